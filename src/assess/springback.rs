//! Spring-back against tolerances, and its compensation.

use super::{Finding, Light, Run};
use crate::case::Springback;
use crate::geometry::Piece;
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

struct Judged<'a> {
    change: &'a Change,
    wanted: f64,
    /// True if the wanted angle is that of the punch's wall.
    of_punch: bool,
    /// After less wanted, in the unit of the quantity.
    missed: f64,
    tolerance: f64,
}

/// Part after its tools are taken away, against its tolerances; plane sections of the flow law, without elasticity, are not
/// judged.
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
    let Some(worst) = judged.iter().max_by(|a, b| a.used().total_cmp(&b.used())) else {
        return unjudged(limits, &changes, punch);
    };
    let less = match run.case.model().tool(Role::Holder) {
        Some(_) => wall_advice(&last.model, before, &shape),
        None => "a smaller radius springs back less".into(),
    };
    let over = compensation(judged.iter().map(|judged| (judged.change, judged.wanted)));
    Finding::judged("springback", "Spring-back", joined(judged.iter().map(Judged::text), "; "))
        .number(Amount::new(worst.missed.abs(), worst.change.quantity.unit, Digits::Significant(3)))
        .at_most(joined(judged.iter().map(Judged::limit), "; "), NEAR * worst.tolerance, worst.tolerance)
        .source("the part's tolerance, [springback]; near it from 80 % on, a declared rule of thumb")
        .advice(joined([less, over], "; "))
        .into()
}

fn unjudged(limits: &Springback, changes: &[Change], punch: Option<f64>) -> Option<Finding> {
    if limits.is_given() {
        let advice = "a bend by ten degrees or more, and a straight leg behind it that can be measured";
        return Some(grey("no angle was found to measure", advice));
    }
    let angles = changes.iter().filter(|change| change.quantity.unit == Unit::Degree);
    let text = joined(angles.map(|change| format!("{} {change}", change.quantity.label)), ", ");
    // The wall's angle is half of the opening angle.
    let others = changes.iter().filter(|change| change.quantity.key != WALL_ANGLE.key);
    let over = others.filter_map(|change| Some((change, of_punch(change.quantity, punch).or(change.before)?)));
    let advice = joined(["[springback] with the part's tolerance".into(), compensation(over)], "; ");
    (!text.is_empty()).then(|| grey(text, advice))
}

fn grey(text: impl Into<String>, advice: impl Into<String>) -> Finding {
    let judged = Finding::judged("springback", "Spring-back", text).light(Light::Grey);
    judged.limit("the part's tolerance, not in the case").advice(advice)
}

/// Angle of the punch's steepest straight wall to its direction \[°\], 0 upright, if the sheet's wall lies against it.
fn punch_wall(model: &Model, changes: &[Change]) -> Option<f64> {
    let sheet = changes.iter().find(|change| change.quantity.key == WALL_ANGLE.key)?.before?;
    let angles = model.tool(Role::Punch)?.profile.pieces().iter().filter_map(|piece| match piece {
        Piece::Segment(line) => {
            let along = line.to - line.from;
            Some((along.x.atan2(along.y.abs()) * -along.y.signum()).to_degrees())
        }
        Piece::Arc(_) => None,
    });
    angles.min_by(|a, b| a.abs().total_cmp(&b.abs())).filter(|angle| (angle - sheet).abs() < BESIDE)
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
    fn of<'a>(&'a self, changes: &'a [Change], punch: Option<f64>) -> impl Iterator<Item = Judged<'a>> + 'a {
        let limits: [(ShapeMeasure, Option<f64>, Option<f64>); 4] = [
            (OPENING_ANGLE, self.angle, self.tolerance),
            (WALL_ANGLE, self.angle.map(|angle| 0.5 * angle), self.wall_tolerance),
            (FLANGE_ANGLE, None, self.flange_tolerance),
            (EDGE, None, self.edge_tolerance),
        ];
        limits.into_iter().filter_map(move |(quantity, given, tolerance)| {
            let change = changes.iter().find(|change| change.quantity.key == quantity.key)?;
            let punch = of_punch(&quantity, punch).filter(|_| given.is_none());
            let wanted = given.or(punch).or(change.before)?;
            let missed = change.after? - wanted;
            Some(Judged { change, wanted, of_punch: punch.is_some(), missed, tolerance: tolerance? })
        })
    }
}

impl Judged<'_> {
    /// Share of the tolerance \[–\].
    fn used(&self) -> f64 {
        self.missed.abs() / self.tolerance
    }

    /// `Opening angle 90.0° → 94.9°, off by +4.9°, each wall opens by 2.5°`.
    fn text(&self) -> String {
        let quantity = self.change.quantity;
        let missed = format!("{} {}, off by {}", quantity.label, self.change, quantity.signed_text(self.missed));
        let share = match quantity.key {
            key if key == OPENING_ANGLE.key => 0.5,
            key if key == WALL_ANGLE.key => 1.0,
            _ => return missed,
        };
        let Some(change) = self.change.change() else { return missed };
        let verb = if change < 0.0 { "closes" } else { "opens" };
        format!("{missed}, each wall {verb} by {}", quantity.text(share * change.abs()))
    }

    /// `0.0° ± 1.0° of the punch's wall`.
    fn limit(&self) -> String {
        let quantity = self.change.quantity;
        let of = if self.of_punch { " of the punch's wall" } else { "" };
        format!("{} ± {}{of}", quantity.text(self.wanted), quantity.text(self.tolerance))
    }
}

/// Angles under the tools that leave the wanted ones, to first order: over-bent by the present spring-back. Empty without an
/// angle of a tool.
fn compensation<'a>(angles: impl Iterator<Item = (&'a Change, f64)>) -> String {
    let (mut undercut, mut over) = ("", Vec::new());
    for (change, wanted) in angles {
        let quantity = change.quantity;
        let of_wall = [OPENING_ANGLE.key, WALL_ANGLE.key].contains(&quantity.key);
        let Some(back) = change.change().filter(|_| of_wall || quantity.key == FLANGE_ANGLE.key) else { continue };
        let [angle, upright, by] = [wanted - back, (wanted - back).max(0.0), back.abs()].map(|a| quantity.text(a));
        // To the displayed digit: 0.0° is upright.
        if of_wall && back > 0.0 && angle != upright {
            undercut = "a straight punch cannot bend past upright: restrike, a cam or more tension";
        } else {
            over.push(format!("{} {angle}, over-bent by {by}", quantity.label));
        }
    }
    let advice = format!("or over-bend: {}; a first estimate, so run again and go on by what is left", over.join("; "));
    joined([undercut.into(), if over.is_empty() { String::new() } else { advice }], "; ")
}

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
