//! Numbers that a part is known by.

use super::formed;
use super::press::{Load, RESERVE};
use super::tear::{place, thinnest};
use crate::case::Case;
use crate::measure::{OPENING_ANGLE, Shape, changes, part_height};
use crate::model::{Geometry, Model, Motion, Role};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::Unit;
use crate::units::{Amount, Digits, Quantity, joined};

/// Thinnest place, force and press, holder, blank, angle of a sprung bend, height, draw-in, opening of a slit ring.
pub(super) fn numbers(case: &Case, stages: &[StageSolution], is_torn: bool) -> Vec<Quantity> {
    let end = stages.last().and_then(|stage| stage.steps.last());
    let height = stages.last().and_then(|stage| part_height(stage.frames.last()?));
    let all = [
        thinnest_number(stages, is_torn),
        load(case, stages),
        holder(stages),
        Some(blank(case.model())),
        opening_angle(stages),
        height.map(|height| Quantity::new("part_height", "Height", Amount::place(height)).at("over all")),
        end.map(|end| Quantity::new("draw_in", "Draw-in", Amount::place(end.draw_in)).at("of the edge, on each side")),
        ring(case, stages),
    ];
    all.into_iter().flatten().collect()
}

fn thinnest_number(stages: &[StageSolution], is_torn: bool) -> Option<Quantity> {
    let stage = stages.last()?;
    let (thickness, s0) = thinnest(stage)?;
    let about = format!("{} thinner", Amount::share(1.0 - thickness / stage.model.blank.thickness));
    // What comes after it is another sheet.
    let after = if is_torn { "after the tear".into() } else { String::new() };
    let about = joined([about, place(stages, s0), after], ", ");
    Some(Quantity::new("thinnest", "Thinnest", Amount::thickness(thickness)).at(about))
}

/// Step of the largest value, and the number of its stage.
fn largest(stages: &[StageSolution], value: fn(&StepRecord) -> f64) -> Option<(usize, &StepRecord)> {
    let steps = formed(stages).flat_map(|(i, stage)| stage.steps.iter().map(move |step| (i, step)));
    steps.max_by(|a, b| value(a.1).total_cmp(&value(b.1)))
}

/// Step of the largest punch force, and the number of its stage; `None` if no punch presses.
pub fn largest_force(stages: &[StageSolution]) -> Option<(usize, &StepRecord)> {
    largest(stages, |step| step.punch_force).filter(|(_, peak)| peak.punch_force > 0.0)
}

/// Largest force over all stages, or largest gas pressure if no punch moves.
fn load(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    let several = formed(stages).count() > 1;
    let at = |i: usize, at: String| {
        let stage = if several { format!("in stage {}", i + 1) } else { String::new() };
        joined([stage, at], ", ")
    };
    let Some((i, peak)) = largest_force(stages) else {
        let (i, peak) = largest(stages, |step| step.pressure.abs()).filter(|(_, peak)| peak.pressure != 0.0)?;
        let at = at(i, format!("at a height of {}", Amount::place(peak.pole_height.abs())));
        return Some(Quantity::new("pressure", "Pressure", Amount::stress(peak.pressure.abs())).at(at));
    };
    let unit = stages[i].model.extent().force_unit();
    let pressed = Load::largest(stages)?;
    let (press, reserve) = match case.press.force {
        Some(rating) => {
            let share = Amount::share(pressed.force() / rating);
            (format!("{share} of the press's {}", Amount::force(rating, unit)), String::new())
        }
        None => {
            let reserve = format!("({} times the load)", Amount::number(RESERVE));
            (format!("a press of at least {}", pressed.rating()), reserve)
        }
    };
    let with_holder = if pressed.holder() > 0.0 { "with the holder".into() } else { String::new() };
    let at = at(i, format!("at {} of travel", Amount::place(peak.travel)));
    let about = joined([at, joined([press, with_holder, reserve], " ")], "; ");
    Some(Quantity::new("punch_force", "Punch force", Amount::force(peak.punch_force, unit)).at(about))
}

/// Largest holder force, or the gap of a fixed holder.
fn holder(stages: &[StageSolution]) -> Option<Quantity> {
    let stage = stages.first()?;
    let holder = stage.model.tool(Role::Holder)?;
    if let Motion::Gap(gap) = holder.motion {
        let about = format!("to the die, {}", Amount::thicknesses(gap / stage.model.blank.thickness));
        return Some(Quantity::new("holder_gap", "Holder gap", Amount::size(gap)).at(about));
    }
    let force = stage.steps.iter().map(|step| step.holder_force).fold(0.0, f64::max);
    let amount = Amount::force(force, stage.model.extent().force_unit());
    Some(Quantity::new("holder_force", "Holder", amount).at("at its largest"))
}

fn blank(model: &Model) -> Quantity {
    let t = Amount::size(model.blank.thickness);
    let about = match model.geometry {
        Geometry::Axisymmetric => format!("in diameter, {t} thick"),
        Geometry::PlaneStrain => format!("wide, {t} thick"),
    };
    let amount = Amount::new(2.0 * model.blank.length, Unit::Mm, Digits::Given(2));
    Quantity::new("blank", "Blank", amount).at(about)
}

/// Angle between the legs of a bend or the walls of a channel, after release.
fn opening_angle(stages: &[StageSolution]) -> Option<Quantity> {
    let stage = stages.last().filter(|stage| stage.model.geometry == Geometry::PlaneStrain)?;
    let [before, after] = stage.released()?;
    let changes = changes(&Shape::of(before), &Shape::of(after));
    let angle = changes.iter().find(|change| change.quantity.key == OPENING_ANGLE.key)?;
    let before = angle.before.map(|before| format!("{} under load", Amount::angle(before)));
    let about = joined([Some("sprung back".to_owned()), before].into_iter().flatten(), ", ");
    Some(Quantity::new(OPENING_ANGLE.key, OPENING_ANGLE.label, Amount::angle(angle.after?)).at(about))
}

fn ring(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    let ring = case.springback.ring?;
    let [height, from] = [ring.height, ring.from].map(Amount::size);
    let amount = Amount::place(ring.opening(stages)?);
    let about = format!("when slit; a ring {height} high, cut {from} over the bottom");
    Some(Quantity::new("ring_opening", "Ring opening", amount).at(about))
}
