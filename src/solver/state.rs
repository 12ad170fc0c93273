//! State of the sheet and its tools at one instant.

pub mod nonlocal_average;

use super::*;
use crate::forming_limit::{Instant, Paths};
use std::sync::Arc;

/// Thickness point of an element.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MaterialPoint {
    /// Equivalent plastic strain ε̄ \[–\].
    pub strain: f64,
    /// Stress at the end of the last step, per initial volume in a sheet that is elastic \[MPa\].
    pub stress: Triple,
    /// Carried stress w of the primal-dual matrix \[MPa\].
    pub carried: Triple,
    /// Back-stresses \[MPa\].
    pub back: [Triple; 2],
    /// Porosity f \[–\]; 0 in a sheet without voids.
    pub porosity: f64,
    /// Rate of the porosity in the last step \[1/s\].
    pub porosity_rate: f64,
    /// Strain rate in the last step \[1/s\]; of the flow law only.
    pub strain_rate: Triple,
    /// Rate of ε̄ in the last step, in process time \[1/s\].
    pub equivalent_rate: f64,
    /// Damage D of ductile fracture over its critical value \[–\].
    pub damage: f64,
}

/// The sheet and its tools at one instant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Time \[s\].
    pub time: f64,
    /// Punch travel \[mm\].
    pub travel: f64,
    /// Nodes from the axis outward \[mm, rad\].
    pub nodes: Vec<Node>,
    /// Mean velocities of the nodes in the last step \[mm/s, rad/s\].
    pub velocity: Vec<Node>,
    /// Velocities extrapolated to the end of the last step \[mm/s, rad/s\]: predictor of the next.
    pub end_velocity: Vec<Node>,
    /// Thickness of each element \[mm\].
    pub thickness: Vec<f64>,
    /// Initial volume of each element \[mm³, or mm² in plane strain\].
    pub volume: Vec<f64>,
    /// Volume strain of each element \[–\], of voids or elastic: t = t₀ exp(−ε_s − ε_θ) times its exponential.
    pub dilation: Vec<f64>,
    /// Rate of the volume strain of voids in the last step \[1/s\].
    pub dilation_rate: Vec<f64>,
    /// Temperature of each element \[K\].
    pub temperature: Vec<f64>,
    /// Temperature rates in the last step and in the one before \[K/s\].
    pub temperature_rates: Vec<[f64; 2]>,
    /// Logarithmic mid-surface strains of each element: meridional, hoop \[–\].
    pub membrane: Vec<[f64; 2]>,
    /// Logarithmic strain by which each element has thinned between two tools, in the stage and in all \[–\]: ironing.
    pub ironed: Vec<[f64; 2]>,
    /// Largest curvature of each element's mid-surface on the punch so far \[1/mm\].
    pub nose_curvature: Vec<f64>,
    /// Tearing index of each element: after the last step, and its largest in the stage \[–\].
    pub tearing_index: Vec<[f64; 2]>,
    /// Duration of the last step \[s\].
    pub last_step: f64,
    /// Flags of the elements that strained in the last step about as in the one before.
    pub steady: Vec<bool>,
    /// Elements by thickness points.
    pub points: Grid<MaterialPoint>,
    /// Damage, as that of the points, on the faces of each element: the die's and the punch's \[–\].
    pub face_damage: Vec<[f64; 2]>,
    /// Displacement of each tool (away from the axis, along z) from where it is drawn \[mm\].
    pub tools: Vec<Point>,
    /// Velocity of each tool along z \[mm/s\].
    pub tool_velocity: Vec<f64>,
    /// Contact pressure of tools by contact points \[MPa\].
    pub pressure: Grid<f64>,
    /// The augmented Lagrangian's shift λ ≤ 0 of the same pairs \[mm\]; zero with a penalty.
    pub shift: Grid<f64>,
    /// Pressure of each gas \[MPa\].
    pub gas: Vec<f64>,
    /// Initial distances of the nodes from the axis, or along a sheet that is not flat from its first end \[mm\].
    pub s0: Vec<f64>,
    /// Nodal forces before tools were taken away from an elastic sheet, which fade \[N, N mm\]; empty without any.
    pub unloading: Arc<[Vector3<f64>]>,
}

/// Gap at which a tool waits before the first step: a few smoothing lengths \[mm\].
pub fn waiting(model: &Model) -> f64 {
    Penalty::WAITING * model.settings.contact_smoothing * model.blank.thickness
}

/// Axial displacement at which a tool waits just off the flat sheet \[mm\].
pub fn waiting_displacement(model: &Model, tool: &Tool) -> f64 {
    match (tool.role, &tool.motion) {
        // Exactly this far from the die.
        (_, Motion::Gap(gap)) => model.blank.thickness - gap + waiting(model),
        (role, _) => role.side() * waiting(model),
    }
}

impl State {
    /// Blank before forming with waiting tools.
    pub fn initial(model: &Model, s0: Vec<f64>) -> Self {
        let nodes: Vec<Node> = s0.iter().map(|&s| model.blank.node(s)).collect();
        let elements = nodes.len() - 1;
        let middles: Vec<f64> = s0.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
        let thickness: Vec<f64> = middles.iter().map(|s| model.blank.thickness_at(*s)).collect();
        let area = |w: &[Node]| Reference::new(model.geometry, model.blank.theory, w[0], w[1]).area();
        let volume = nodes.windows(2).zip(&thickness).map(|(w, t)| t * area(w)).collect();
        let strains = |s: &f64| model.blank.strains_at(*s);
        let porosity = model.material.gtn.map_or(0.0, |voids| voids.initial);
        let point = |strain: f64| MaterialPoint { strain, porosity, ..MaterialPoint::default() };
        let points = middles.iter().flat_map(|s| std::iter::repeat_n(point(strains(s)[2]), model.blank.layers));
        let temperature = |r: f64| model.heat.as_ref().map_or(ROOM_TEMPERATURE, |heat| heat.initial.at(r));
        let speed = |tool: &Tool| if tool.motion == Motion::Travel { model.speed } else { 0.0 };
        let pairs = Grid::new(model.tools.len(), STATIONS * elements, 0.0);
        Self {
            velocity: vec![[0.0; 3]; nodes.len()],
            end_velocity: vec![[0.0; 3]; nodes.len()],
            thickness,
            volume,
            membrane: middles.iter().map(|s| [strains(s)[0], strains(s)[1]]).collect(),
            ironed: vec![[0.0; 2]; elements],
            nose_curvature: vec![0.0; elements],
            tearing_index: vec![[0.0; 2]; elements],
            steady: vec![false; elements],
            points: Grid::from_values(model.blank.layers, points),
            face_damage: vec![[0.0; 2]; elements],
            dilation: vec![0.0; elements],
            dilation_rate: vec![0.0; elements],
            temperature: middles.iter().map(|s| temperature(*s)).collect(),
            temperature_rates: vec![[0.0; 2]; elements],
            tools: model.tools.iter().map(|tool| Point::new(0.0, waiting_displacement(model, tool))).collect(),
            tool_velocity: model.tools.iter().map(speed).collect(),
            pressure: pairs.clone(),
            shift: pairs,
            gas: vec![0.0; model.gas.len()],
            nodes,
            s0,
            ..Self::default()
        }
    }

    /// Position of node `i` in the frame in which tool `j` is drawn \[mm\].
    #[inline]
    pub fn in_frame_of(&self, j: usize, i: usize) -> Point {
        Point::new(self.nodes[i][0] - self.tools[j].x, self.nodes[i][1] - self.tools[j].y)
    }

    /// Gap between node `i` and tool `j` \[mm\].
    pub fn gap(&self, model: &Model, j: usize, i: usize) -> f64 {
        model.tools[j].profile.closest(self.in_frame_of(j, i)).distance - 0.5 * self.thickness_at(i)
    }

    /// Element `e` from its first node to its second \[mm\].
    pub fn along(&self, e: usize) -> Point {
        let [a, b] = [self.nodes[e], self.nodes[e + 1]];
        Point::new(b[0] - a[0], b[1] - a[1])
    }

    /// Clear diameter at the first end, between its inner faces \[mm\].
    pub fn hole(&self) -> f64 {
        let (along, r) = (self.along(0), self.nodes[0][0]);
        2.0 * r - self.thickness[0] * along.y.abs() / along.norm()
    }

    /// Initial distance of the middle of element `e` from the axis \[mm\].
    pub fn middle(&self, e: usize) -> f64 {
        0.5 * (self.s0[e] + self.s0[e + 1])
    }

    /// Number of points at which the sheet may touch a tool.
    pub fn contact_points(&self) -> usize {
        STATIONS * self.thickness.len()
    }

    /// Mean thickness of the elements at node `i` \[mm\].
    pub fn thickness_at(&self, i: usize) -> f64 {
        0.5 * (self.thickness[i.max(1) - 1] + self.thickness[i.min(self.thickness.len() - 1)])
    }

    /// Removes the pressure of a tool that lets go.
    pub fn release(&mut self, tool: usize) {
        self.pressure.row_mut(tool).fill(0.0);
        self.shift.row_mut(tool).fill(0.0);
    }

    /// Largest porosity, mean over the thickness \[–\], and its initial distance from the axis \[mm\].
    pub fn largest_porosity(&self, rule: &[ThicknessPoint]) -> (f64, f64) {
        let means = self.points.rows().enumerate().map(|(e, points)| {
            let mean: f64 = points.iter().zip(rule).map(|(p, at)| at.weight * p.porosity).sum();
            (mean, self.middle(e))
        });
        means.fold((0.0, 0.0), |largest, now| if now.0 > largest.0 { now } else { largest })
    }

    /// Largest damage through the thickness of element `e` and its ξ \[–\].
    pub fn damage(&self, e: usize, rule: &[ThicknessPoint]) -> (f64, f64) {
        let inside = self.points.row(e).iter().zip(rule).map(|(point, at)| (point.damage, at.xi));
        let [die, punch] = self.face_damage[e];
        let all = inside.chain([(die, -1.0), (punch, 1.0)]);
        all.fold((0.0, 0.0), |largest, now| if now.0 > largest.0 { now } else { largest })
    }

    /// Largest damage of the sheet \[–\], and its initial distance from the axis \[mm\].
    pub fn largest_damage(&self, rule: &[ThicknessPoint]) -> (f64, f64) {
        let all = (0..self.thickness.len()).map(|e| (self.damage(e, rule).0, self.middle(e)));
        all.fold((0.0, 0.0), |largest, now| if now.0 > largest.0 { now } else { largest })
    }

    /// Extrapolated temperature of element `e` at `dt` \[s\] from now \[K\].
    pub fn foreseen_temperature(&self, e: usize, dt: f64) -> f64 {
        let [last, before] = self.temperature_rates[e];
        let rate = if last * before > 0.0 { last.abs().min(before.abs()).copysign(last) } else { 0.0 };
        self.temperature[e] + rate * dt
    }

    /// Lowest and highest temperature of an element \[K\].
    pub fn temperatures(&self) -> (f64, f64) {
        let t = &self.temperature;
        t.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &t| (low.min(t), high.max(t)))
    }

    /// Strain paths that begin with this instant; empty when the model has no forming limit.
    pub fn paths(&self, model: &Model) -> Paths {
        if model.forming_limit.is_none() {
            return Paths::default();
        }
        let mut paths = Paths::starting((0..self.thickness.len()).map(|e| self.middle(e)).collect());
        let blank = &model.blank;
        paths.edge = (if blank.hole > 0.0 { blank.hole + blank.thickness } else { 0.0 }, blank.edge_limit.is_some());
        paths.record(self.instant());
        paths
    }

    /// Mid-surface strains of this instant, less ironing: a wall that two tools press thin does not neck by it.
    pub fn instant(&self) -> Instant {
        let stretched = |([along, hoop], [_, ironed]): (&[f64; 2], &[f64; 2])| [along - ironed.max(0.0), *hoop];
        let strains = self.membrane.iter().zip(&self.ironed).map(stretched).collect();
        Instant { time: self.time, travel: self.travel, strains }
    }
}
