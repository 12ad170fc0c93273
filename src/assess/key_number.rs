//! Numbers that a part is known by.

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
    let all = [
        thinnest_number(stages, is_torn),
        load(case, stages),
        holder(stages),
        Some(blank(case.model())),
        opening_angle(stages),
        height(stages),
        draw_in(stages),
        ring(case, stages),
    ];
    all.into_iter().flatten().collect()
}

fn thinnest_number(stages: &[StageSolution], is_torn: bool) -> Option<Quantity> {
    let stage = stages.last()?;
    let (thickness, s0) = thinnest(stage)?;
    let thinning = 1.0 - thickness / stage.model.blank.thickness;
    let about = format!("{thinning} thinner", thinning = Amount::share(thinning));
    // What comes after it is another sheet.
    let after = if is_torn { "after the tear".into() } else { String::new() };
    let about = joined([about, place(stages, s0), after], ", ");
    Some(Quantity::new("thinnest", "Thinnest", Amount::thickness(thickness)).at(about))
}

/// The stages that form the sheet, with their numbers.
fn formed(stages: &[StageSolution]) -> impl Iterator<Item = (usize, &StageSolution)> {
    stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none())
}

/// The step where something is largest, and the number of its stage.
fn largest(stages: &[StageSolution], value: fn(&StepRecord) -> f64) -> Option<(usize, &StepRecord)> {
    let steps = formed(stages).flat_map(|(i, stage)| stage.steps.iter().map(move |step| (i, step)));
    steps.max_by(|a, b| value(a.1).total_cmp(&value(b.1)))
}

/// The step with the largest punch force, and the number of its stage; `None` where no punch presses.
pub fn largest_force(stages: &[StageSolution]) -> Option<(usize, &StepRecord)> {
    largest(stages, |step| step.punch_force).filter(|(_, peak)| peak.punch_force > 0.0)
}

/// The largest force over all stages, or the largest gas pressure where no punch moves.
fn load(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    let several = formed(stages).count() > 1;
    let stage = |i: usize| if several { format!("in stage {n}", n = i + 1) } else { String::new() };
    let Some((i, peak)) = largest_force(stages) else {
        let (i, peak) = largest(stages, |step| step.pressure.abs()).filter(|(_, peak)| peak.pressure != 0.0)?;
        let at = format!("at a height of {height}", height = Amount::place(peak.pole_height.abs()));
        let about = joined([stage(i), at], ", ");
        return Some(Quantity::new("pressure", "Pressure", Amount::stress(peak.pressure.abs())).at(about));
    };
    let unit = stages[i].model.extent().force_unit();
    let at = format!("at {travel} of travel", travel = Amount::place(peak.travel));
    let at = joined([stage(i), at], ", ");
    let pressed = Load::largest(stages)?;
    let (press, reserve) = match case.press.force {
        Some(rating) => {
            let (share, rating) = (Amount::share(pressed.force() / rating), Amount::force(rating, unit));
            (format!("{share} of the press's {rating}"), String::new())
        }
        None => {
            let reserve = format!("({times} times the load)", times = Amount::number(RESERVE));
            (format!("a press of at least {rating}", rating = pressed.rating()), reserve)
        }
    };
    let with_holder = if pressed.holder() > 0.0 { "with the holder".into() } else { String::new() };
    let press = joined([press, with_holder, reserve], " ");
    let about = joined([at, press], "; ");
    Some(Quantity::new("punch_force", "Punch force", Amount::force(peak.punch_force, unit)).at(about))
}

/// The largest holder force, or the gap of a holder that stands.
fn holder(stages: &[StageSolution]) -> Option<Quantity> {
    let stage = stages.first()?;
    let holder = stage.model.tool(Role::Holder)?;
    if let Motion::Gap(gap) = holder.motion {
        let about = format!("to the die, {ratio}", ratio = Amount::thicknesses(gap / stage.model.blank.thickness));
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

/// Between the legs of a bend, or the walls of a channel, once its tools are taken away.
fn opening_angle(stages: &[StageSolution]) -> Option<Quantity> {
    let stage = stages.last().filter(|stage| stage.model.geometry == Geometry::PlaneStrain)?;
    let [before, after] = stage.released()?;
    let changes = changes(&Shape::of(before), &Shape::of(after));
    let angle = changes.iter().find(|change| change.quantity.key == OPENING_ANGLE.key)?;
    let about = match angle.before {
        Some(before) => format!("sprung back, {angle} under load", angle = Amount::angle(before)),
        None => "sprung back".into(),
    };
    Some(Quantity::new(OPENING_ANGLE.key, OPENING_ANGLE.label, Amount::angle(angle.after?)).at(about))
}

fn height(stages: &[StageSolution]) -> Option<Quantity> {
    let height = part_height(stages.last()?.frames.last()?)?;
    Some(Quantity::new("part_height", "Height", Amount::place(height)).at("over all"))
}

fn draw_in(stages: &[StageSolution]) -> Option<Quantity> {
    let drawn = stages.last()?.steps.last()?.draw_in;
    Some(Quantity::new("draw_in", "Draw-in", Amount::place(drawn)).at("of the edge, on each side"))
}

fn ring(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    let ring = case.springback.ring?;
    let about = format!(
        "when slit; a ring {height} high, cut {from} over the bottom",
        height = Amount::size(ring.height),
        from = Amount::size(ring.from)
    );
    let amount = Amount::place(ring.opening(stages)?);
    Some(Quantity::new("ring_opening", "Ring opening", amount).at(about))
}
