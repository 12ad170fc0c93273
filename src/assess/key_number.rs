//! Numbers that a part is known by.

use super::formed;
use super::press::{Load, RESERVE};
use super::tear::place;
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
        end.and_then(|end| thinnest(stages, end, is_torn)),
        load(case, stages),
        stages.first().and_then(holder),
        Some(blank(case.model())),
        stages.last().and_then(opening_angle),
        height.map(|height| Quantity::new("part_height", "Height", Amount::place(height)).at("over all")),
        end.map(|end| Quantity::new("draw_in", "Draw-in", Amount::place(end.draw_in)).at("of the edge, on each side")),
        ring(case, stages),
    ];
    all.into_iter().flatten().collect()
}

fn thinnest(stages: &[StageSolution], end: &StepRecord, is_torn: bool) -> Option<Quantity> {
    let thinning = 1.0 - end.thinnest / stages.last()?.model.blank.thickness;
    // What comes after it is another sheet.
    let after = if is_torn { "after the tear" } else { "" };
    let about = [format!("{} thinner", Amount::share(thinning)), place(stages, end.thinnest_s0), after.into()];
    Some(Quantity::new("thinnest", "Thinnest", Amount::thickness(end.thinnest)).at(joined(about, ", ")))
}

/// Step of the largest value, and the number of its stage.
fn largest(stages: &[StageSolution], value: fn(&StepRecord) -> f64) -> Option<(usize, &StepRecord)> {
    let steps = formed(stages).flat_map(|(i, stage)| stage.steps.iter().map(move |step| (i, step)));
    steps.max_by(|a, b| value(a.1).total_cmp(&value(b.1))).filter(|(_, step)| value(step) > 0.0)
}

/// Step of the largest punch force, and the number of its stage; `None` if no punch presses.
pub fn largest_force(stages: &[StageSolution]) -> Option<(usize, &StepRecord)> {
    largest(stages, |step| step.punch_force)
}

/// Largest force over all stages, or largest gas pressure if no punch moves.
fn load(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    let stage = |i: usize| if formed(stages).count() > 1 { format!("in stage {}", i + 1) } else { String::new() };
    let Some((i, peak)) = largest_force(stages) else {
        let (i, peak) = largest(stages, |step| step.pressure.abs())?;
        let at = format!("at a height of {}", Amount::place(peak.pole_height.abs()));
        let pressure = Quantity::new("pressure", "Pressure", Amount::stress(peak.pressure.abs()));
        return Some(pressure.at(joined([stage(i), at], ", ")));
    };
    let amount = |force: f64| Amount::force(force, stages[i].model.extent().force_unit());
    let pressed = Load::largest(stages)?;
    let (press, reserve) = match case.press.force {
        Some(rating) => {
            let share = Amount::share(pressed.force() / rating);
            (format!("{share} of the press's {}", amount(rating)), String::new())
        }
        None => (format!("a press of at least {}", pressed.rating()), format!("({RESERVE} times the load)")),
    };
    let with_holder = if pressed.holder() > 0.0 { "with the holder" } else { "" };
    let at = joined([stage(i), format!("at {} of travel", Amount::place(peak.travel))], ", ");
    let about = joined([at, joined([press, with_holder.into(), reserve], " ")], "; ");
    Some(Quantity::new("punch_force", "Punch force", amount(peak.punch_force)).at(about))
}

/// Largest holder force, or the gap of a fixed holder.
fn holder(stage: &StageSolution) -> Option<Quantity> {
    let model = &stage.model;
    if let Motion::Gap(gap) = model.tool(Role::Holder)?.motion {
        let about = format!("to the die, {}", Amount::thicknesses(gap / model.blank.thickness));
        return Some(Quantity::new("holder_gap", "Holder gap", Amount::size(gap)).at(about));
    }
    let force = Amount::force(super::largest(stage, |step| step.holder_force), model.extent().force_unit());
    Some(Quantity::new("holder_force", "Holder", force).at("at its largest"))
}

fn blank(model: &Model) -> Quantity {
    let across = match model.geometry {
        Geometry::Axisymmetric => "in diameter",
        Geometry::PlaneStrain => "wide",
    };
    let amount = Amount::new(2.0 * model.blank.length, Unit::Mm, Digits::Given(2));
    let about = format!("{across}, {} thick", Amount::size(model.blank.thickness));
    Quantity::new("blank", "Blank", amount).at(about)
}

/// Angle between the legs of a bend or the walls of a channel, after release.
fn opening_angle(stage: &StageSolution) -> Option<Quantity> {
    let [before, after] = stage.released().filter(|_| stage.model.geometry == Geometry::PlaneStrain)?;
    let changes = changes(&Shape::of(before), &Shape::of(after));
    let angle = changes.iter().find(|change| change.quantity.key == OPENING_ANGLE.key)?;
    let before = angle.before.map_or_else(String::new, |before| format!(", {} under load", Amount::angle(before)));
    let opening = Quantity::new(OPENING_ANGLE.key, OPENING_ANGLE.label, Amount::angle(angle.after?));
    Some(opening.at(format!("sprung back{before}")))
}

fn ring(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    let ring = case.springback.ring?;
    let [height, from] = [ring.height, ring.from].map(Amount::size);
    let about = format!("when slit; a ring {height} high, cut {from} over the bottom");
    Some(Quantity::new("ring_opening", "Ring opening", Amount::place(ring.opening(stages)?)).at(about))
}
