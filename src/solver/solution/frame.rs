//! Kept instants of a run.

use crate::solver::*;

/// Element at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementRecord {
    /// Initial distance of the element's middle from the axis \[mm\].
    pub s0: f64,
    /// Distance of the element's middle from the axis \[mm\].
    pub r: f64,
    /// Height of the element's middle, along the punch travel \[mm\].
    pub z: f64,
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Logarithmic mid-surface strain along the section \[–\].
    pub strain_meridional: f64,
    /// Logarithmic mid-surface strain across the section \[–\].
    pub strain_hoop: f64,
    /// ln(t/t₀) \[–\].
    pub strain_thickness: f64,
    /// Equivalent plastic strain, mean over the thickness \[–\].
    pub strain_equivalent: f64,
    /// Largest equivalent plastic strain over the thickness \[–\].
    pub strain_equivalent_max: f64,
    /// Mean Cauchy stress along the section, less p/2 of a tool's pressure p on a face \[MPa\].
    pub stress_meridional: f64,
    /// Mean Cauchy stress across the section, likewise \[MPa\].
    pub stress_hoop: f64,
    /// Tearing index: meridional force over the one at which the place tears \[–\]; 0 where it is not judged.
    pub tearing_index: f64,
    /// Largest tearing index in the stage so far \[–\].
    pub tearing_index_max: f64,
    /// Mean porosity \[–\].
    pub porosity: f64,
    /// Largest damage of ductile fracture over its critical value through the thickness, faces included \[–\].
    pub damage: f64,
    /// Temperature \[K\].
    pub temperature: f64,
}

/// Node at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeRecord {
    /// Distance of the mid-surface from the axis \[mm\].
    pub r: f64,
    /// Height of the mid-surface, along the punch travel \[mm\].
    pub z: f64,
    /// Rotation of the fibre, counter-clockwise in the r-z plane \[rad\].
    pub theta: f64,
    /// Thickness that contact sees \[mm\].
    pub thickness: f64,
}

/// Thickness point at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointRecord {
    /// Cauchy stress along the section, with pressure as in [`ElementRecord`] \[MPa\].
    pub stress_meridional: f64,
    /// Cauchy stress across the section, likewise \[MPa\].
    pub stress_hoop: f64,
    /// Equivalent plastic strain \[–\].
    pub strain_equivalent: f64,
}

/// Thickness points of all elements at one instant; empty in all frames but the last.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThroughThickness {
    /// Points of every element: ξ = ζ/(t/2) from −1 on the die's face to 1 on the punch's.
    pub layers: Vec<ThicknessPoint>,
    /// Elements by `layers`.
    pub points: Vec<PointRecord>,
}

impl ThroughThickness {
    /// Points of each element, from the axis outward.
    pub fn elements(&self) -> std::slice::ChunksExact<'_, PointRecord> {
        self.points.chunks_exact(self.layers.len().max(1))
    }
}

/// Sheet and tools at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Time \[s\].
    pub time: f64,
    /// Punch travel \[mm\].
    pub travel: f64,
    /// Elements, from the axis outward.
    pub elements: Vec<ElementRecord>,
    /// Nodes, from the axis outward.
    pub nodes: Vec<NodeRecord>,
    /// Points through the thickness.
    pub through: ThroughThickness,
    /// Displacement of each of the model's tools (away from the axis, along z) \[mm\].
    pub tool_displacement: Vec<Point>,
}

impl State {
    /// The frame of this instant.
    pub fn frame(&self, model: &Model) -> Frame {
        let layers = model.blank.points();
        let element = |e: usize| {
            let points = self.points.row(e);
            let mean =
                |of: &dyn Fn(&MaterialPoint) -> f64| points.iter().zip(&layers).map(|(p, l)| l.weight * of(p)).sum();
            let ([a, b], [strain_meridional, strain_hoop]) = ([self.nodes[e], self.nodes[e + 1]], self.membrane[e]);
            ElementRecord {
                s0: self.middle(e),
                r: 0.5 * (a[0] + b[0]),
                z: 0.5 * (a[1] + b[1]),
                thickness: self.thickness[e],
                strain_meridional,
                strain_hoop,
                strain_thickness: -strain_meridional - strain_hoop + self.dilation[e],
                strain_equivalent: mean(&|p| p.strain),
                strain_equivalent_max: points.iter().map(|p| p.strain).fold(0.0, f64::max),
                stress_meridional: mean(&|p| model.cauchy(p.stress)[0]),
                stress_hoop: mean(&|p| model.cauchy(p.stress)[1]),
                tearing_index: self.tearing_index[e][0],
                tearing_index_max: self.tearing_index[e][1],
                porosity: mean(&|p| p.porosity),
                damage: self.damage(e, &layers).0,
                temperature: self.temperature[e],
            }
        };
        let node = |i: usize| {
            let [r, z, theta] = self.nodes[i];
            NodeRecord { r, z, theta, thickness: self.thickness_at(i) }
        };
        let points = self.points.iter().map(|p| {
            let [stress_meridional, stress_hoop, _] = model.cauchy(p.stress);
            PointRecord { stress_meridional, stress_hoop, strain_equivalent: p.strain }
        });
        let elements = (0..self.thickness.len()).map(element).collect();
        let nodes = (0..self.nodes.len()).map(node).collect();
        let through = ThroughThickness { points: points.collect(), layers };
        Frame { time: self.time, travel: self.travel, elements, nodes, through, tool_displacement: self.tools.clone() }
    }
}
