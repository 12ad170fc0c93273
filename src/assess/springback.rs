//! Spring-back against tolerances, and its compensation.

use super::{Finding, Light, run::Run};
use crate::case::Springback;
use crate::geometry::{Piece, Profile};
use crate::measure::{Change, EDGE, FLANGE_ANGLE, OPENING_ANGLE, Shape, ShapeMeasure, WALL_ANGLE, changes};
use crate::model::{Geometry, Mode, Model, Role};
use crate::solver::solution::Frame;
use crate::units::{Amount, Digits, Unit, joined};

/// Share of a tolerance above which the scatter of sheet and process may use the rest: from coil to coil spring-back varies by
/// a fifth and more \[–\].
const NEAR: f64 = 0.8;
/// A wall that leans by less from the punch's straight wall was drawn against it \[°\]; a strip that is bent in air leans by
/// tens of degrees.
const BESIDE: f64 = 8.0;

/// Measure of the released part against its tolerance.
struct Judged {
    change: Change,
    wanted: f64,
    /// Whether the wanted angle is that of the punch's wall.
    of_punch: bool,
    /// After less wanted, in the unit of the quantity.
    missed: f64,
    tolerance: f64,
}

/// Part after its tools are taken away, against its tolerances. The flow law has no elasticity, so plane sections are
/// not judged.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let limits = &run.case.springback;
    let Some([before, after]) = last.released() else {
        let flows = last.model.geometry == Geometry::PlaneStrain && last.model.mode == Mode::Flow;
        let why = match flows {
            true => "not computed: the flow law has no elasticity",
            false if limits.is_given() => "not computed: no stage takes the tools away",
            false => return None,
        };
        let advice =
            "[material] mode = \"elasto_viscoplastic\" with young and poisson, and a stage with release = true";
        return Some(grey(why, advice));
    };
    let shape = Shape::of(before);
    let changes = changes(&shape, &Shape::of(after));
    let punch = punch_wall(&last.model, &changes);
    let judged: Vec<Judged> = limits.of(&changes, punch).collect();
    if judged.is_empty() {
        return unjudged(limits, &changes, punch);
    }
    let worst = judged.iter().max_by(|a, b| a.used().total_cmp(&b.used()))?;
    let over = judged.iter().filter_map(|judged| overbend(&judged.change, judged.wanted));
    let less = match run.case.model().tool(Role::Holder) {
        Some(_) => wall_advice(&last.model, before, &shape),
        None => "a smaller radius springs back less".into(),
    };
    Some(
        Finding::judged(
            "springback",
            "Spring-back",
            Light::of(worst.used(), [NEAR, 1.0]),
            joined(judged.iter().map(Judged::text), "; "),
        )
        .number(Amount::new(worst.missed.abs(), worst.change.quantity.unit, Digits::Significant(3)))
        .limit(joined(judged.iter().map(Judged::limit), "; "))
        .at_most(NEAR * worst.tolerance, worst.tolerance)
        .source("the part's tolerance, [springback]; near it from 80 % on, a declared rule of thumb")
        .advice(joined([less, compensated(over)], "; ")),
    )
}

/// Spring-back without a tolerance, or without an angle that can be measured.
fn unjudged(limits: &Springback, changes: &[Change], punch: Option<f64>) -> Option<Finding> {
    if limits.is_given() {
        let advice = "a bend by ten degrees or more, and a straight leg behind it that can be measured";
        return Some(grey("no angle was found to measure", advice));
    }
    let angles = changes.iter().filter(|change| change.quantity.unit == Unit::Degree);
    let changes_text = joined(angles.map(|change| format!("{} {change}", change.quantity.label)), ", ");
    let over = changes.iter().filter_map(|change| {
        // The wall's is half of the opening angle's.
        let is_told = change.quantity.key != WALL_ANGLE.key;
        overbend(change, of_punch(change.quantity, punch).or(change.before)?).filter(|_| is_told)
    });
    let advice = joined(["[springback] with the part's tolerance".into(), compensated(over)], "; ");
    (!changes_text.is_empty()).then(|| grey(changes_text, advice))
}

fn grey(found: impl Into<String>, advice: impl Into<String>) -> Finding {
    Finding::judged("springback", "Spring-back", Light::Grey, found)
        .limit("the part's tolerance, not in the case")
        .advice(advice)
}

/// Angle of the punch's wall to its direction \[°\], where the sheet's wall lies against it.
fn punch_wall(model: &Model, changes: &[Change]) -> Option<f64> {
    let sheet = changes.iter().find(|change| change.quantity.key == WALL_ANGLE.key)?.before?;
    steepest(&model.tool(Role::Punch)?.profile).filter(|angle| (angle - sheet).abs() < BESIDE)
}

/// Angle of a profile's steepest straight piece to the punch's direction \[°\]: 0 upright, positive opened.
fn steepest(profile: &Profile) -> Option<f64> {
    let angles = profile.pieces().iter().filter_map(|piece| match piece {
        Piece::Segment(line) => {
            let (from, to) = (line.from, line.to);
            Some((to.x - from.x).atan2((to.y - from.y).abs()) * (from.y - to.y).signum())
        }
        Piece::Arc(_) => None,
    });
    angles.map(f64::to_degrees).min_by(|a, b| a.abs().total_cmp(&b.abs()))
}

/// Target from the punch's wall: its own angle, or that between it and its mirror image.
fn of_punch(quantity: &ShapeMeasure, wall: Option<f64>) -> Option<f64> {
    match quantity.key {
        key if key == WALL_ANGLE.key => wall,
        key if key == OPENING_ANGLE.key => wall.map(|angle| 2.0 * angle),
        _ => None,
    }
}

impl Springback {
    /// Judged measures; `punch` is the angle of its wall \[°\].
    fn of<'a>(&'a self, changes: &'a [Change], punch: Option<f64>) -> impl Iterator<Item = Judged> + 'a {
        let limits: [(ShapeMeasure, Option<f64>, Option<f64>); 4] = [
            (OPENING_ANGLE, self.angle, self.tolerance),
            (WALL_ANGLE, self.angle.map(|angle| 0.5 * angle), self.wall_tolerance),
            (FLANGE_ANGLE, None, self.flange_tolerance),
            (EDGE, None, self.edge_tolerance),
        ];
        limits.into_iter().filter_map(move |(quantity, given, tolerance)| {
            let change = *changes.iter().find(|change| change.quantity.key == quantity.key)?;
            let after = change.after?;
            let punch = of_punch(&quantity, punch).filter(|_| given.is_none());
            let wanted = given.or(punch).or(change.before)?;
            let of_punch = punch.is_some();
            Some(Judged { change, wanted, of_punch, missed: after - wanted, tolerance: tolerance? })
        })
    }
}

impl Judged {
    /// Share of the tolerance \[–\].
    fn used(&self) -> f64 {
        self.missed.abs() / self.tolerance
    }

    /// `Opening angle 90.0° → 94.9°, off by +4.9°, each wall opens by 2.5°`.
    fn text(&self) -> String {
        let quantity = self.change.quantity;
        let by = quantity.signed_text(self.missed);
        let missed = format!("{} {}, off by {by}", quantity.label, self.change);
        joined([missed, self.each_wall()], ", ")
    }

    /// Change of one wall; empty for measures that are no angle of a wall.
    fn each_wall(&self) -> String {
        let share = match self.change.quantity.key {
            key if key == OPENING_ANGLE.key => 0.5,
            key if key == WALL_ANGLE.key => 1.0,
            _ => return String::new(),
        };
        let Some(change) = self.change.change() else { return String::new() };
        let by = self.change.quantity.text(share * change.abs());
        match change < 0.0 {
            true => format!("each wall closes by {by}"),
            false => format!("each wall opens by {by}"),
        }
    }

    /// `0.0° ± 1.0° of the punch's wall`.
    fn limit(&self) -> String {
        let quantity = self.change.quantity;
        let (wanted, tolerance) = (quantity.text(self.wanted), quantity.text(self.tolerance));
        let limit = format!("{wanted} ± {tolerance}");
        if self.of_punch { format!("{limit} of the punch's wall") } else { limit }
    }
}

/// Compensation in the tools.
enum Overbend {
    /// Angle under the tools that leaves the wanted one.
    By(String),
    /// The wall would have to lie under the punch.
    Undercut,
}

/// Angle under the tools that leaves the wanted one, to first order: over-bent by the present spring-back. `None` for
/// measures that are no angle of a tool.
fn overbend(change: &Change, wanted: f64) -> Option<Overbend> {
    let quantity = change.quantity;
    let of_wall = [OPENING_ANGLE.key, WALL_ANGLE.key].contains(&quantity.key);
    let back = change.change().filter(|_| of_wall || quantity.key == FLANGE_ANGLE.key)?;
    let angle = wanted - back;
    // To the displayed digit: 0.0° is upright.
    if of_wall && back > 0.0 && quantity.text(angle) != quantity.text(angle.max(0.0)) {
        return Some(Overbend::Undercut);
    }
    let (angle, by) = (quantity.text(angle), quantity.text(back.abs()));
    Some(Overbend::By(format!("{} {angle}, over-bent by {by}", quantity.label)))
}

/// Advice on compensation; empty without an angle.
fn compensated(over: impl Iterator<Item = Overbend>) -> String {
    let mut angles = Vec::new();
    let mut undercut = String::new();
    for over in over {
        match over {
            Overbend::By(angle) => angles.push(angle),
            Overbend::Undercut => {
                undercut = "a straight punch cannot bend past upright: restrike, a cam or more tension".into();
            }
        }
    }
    let over = joined(angles, "; ");
    if over.is_empty() {
        return undercut;
    }
    let advice = format!("or over-bend: {over}; a first estimate, so run again and go on by what is left");
    joined([undercut, advice], "; ")
}

/// Effect of tension on a wall's spring-back, with the wall's tension under the tools.
fn wall_advice(model: &Model, frame: &Frame, shape: &Shape) -> String {
    let carried = wall_tension(model, frame, shape).map_or_else(String::new, |share| {
        format!("Wall tension is {} of what would straighten it", Amount::share(share))
    });
    joined(["smaller radii spring back less; more wall tension (holder force, beads) helps as the whole wall nears yield".into(), carried], ". ")
}

/// Largest mean tension along the wall over the one at which its whole thickness yields \[–\].
fn wall_tension(model: &Model, frame: &Frame, shape: &Shape) -> Option<f64> {
    let nodes = shape.wall.as_ref()?.nodes.clone();
    let weights: Vec<f64> = frame.through.layers.iter().map(|layer| layer.weight).collect();
    let total: f64 = weights.iter().sum();
    // A wall does not strain across its section: the stress along it is then larger than the yield stress.
    let material = &model.material;
    let across = material.yield_criterion.equivalent_stress([1.0, material.yield_criterion.plane_strain_ratio(), 0.0]);
    let of = |e: usize| {
        let (element, points) = (frame.elements.get(e)?, frame.through.elements().nth(e)?);
        let yields = |strain: f64| material.yield_stress(strain, element.temperature);
        let limit: f64 =
            points.iter().zip(&weights).map(|(point, weight)| weight * yields(point.strain_equivalent)).sum();
        Some(element.stress_meridional * across * total / limit)
    };
    (nodes.start..nodes.end.saturating_sub(1)).filter_map(of).reduce(f64::max).filter(|share| *share > 0.0)
}
