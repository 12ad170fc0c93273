//! Searches with a name: variable, range and condition follow from the case.

use super::*;
use crate::assess::estimate::{flange_strength, held_from};
use crate::model::tool_sizes::{extent, mouth, shoulder_end, throat};
use crate::model::{Edge, Geometry, Model, Motion, Role, Tool};
use crate::rules::{HolderRule, THIN};

#[derive(Clone, Debug, Default)]
pub(super) struct Goal {
    pub settings: Vec<String>,
    pub vary: Option<String>,
    pub condition: Option<&'static str>,
    /// Quantity whose value the user gives.
    pub quantity: Option<&'static str>,
    /// Target by the case itself.
    pub wanted: Option<String>,
    /// Distance from the wanted value that the part's tolerance allows, in the unit of the quantity.
    pub tolerance: f64,
    /// Remark on what the runs add to the case.
    pub note: Option<String>,
    /// Change that makes up for what is missing, and the value that it goes to, if not to the target.
    pub remedy: Option<(&'static str, Option<f64>)>,
    pub side: Option<Side>,
    pub holder: Option<HolderRule>,
}

fn holder_rule(case: &Case, punch: f64) -> Option<HolderRule> {
    let model = case.model();
    let is_given = case.overrides.iter().any(|key| key.starts_with("tools.holder.") && !key.contains("friction"));
    let holder = model.tool(Role::Holder).filter(|holder| matches!(holder.motion, Motion::Pressed(_)))?;
    let end = held_from(model)?.max(extent(holder).0);
    let (thickness, strength) = (model.blank.thickness, flange_strength(model));
    let by_pressure = !case.written("tools.holder.pressure").is_empty();
    (!is_given).then_some(HolderRule { punch, end, thickness, strength, by_pressure })
}

/// Override of the case for a blank of this radius \[mm\].
pub(super) fn holder_setting(rule: HolderRule, blank: f64) -> String {
    match rule.by_pressure {
        true => format!("tools.holder.pressure={:.5} MPa", rule.pressure(blank)),
        false => format!("tools.holder.force={:.0} N", rule.force(blank).ceil()),
    }
}

const BEAD_FORCE: &str = "tools.beads.0.restraining";
const NAMES: &str = "limiting-draw-ratio, greatest-height, least-holder-force, smallest-radius, over-bend, bead-force";
/// Smallest and largest draw ratio \[–\].
const RATIOS: [f64; 2] = [1.2, 3.0];
/// Travel beyond the height of the largest blank's cup, over the punch diameter \[–\].
const BEYOND: f64 = 0.3;
/// Least blank radius over the outer end of the die shoulder \[–\].
const FLANGE: f64 = 1.02;
/// Largest bead force over the sheet's strength \[–\]: a wall yields under it.
const RESTRAINT: f64 = 1.0;
/// Distance of a new bead from the die's shoulder over the thickness \[–\]: declared.
const BEAD: f64 = 5.0;
/// Shares of the travel at which a new bead begins to hold, and holds: declared. So late it takes the wall's curl.
const LATE: [f64; 2] = [0.9, 0.925];

impl Goal {
    pub fn request(name: &str, case: &Case) -> Result<Self> {
        let goal = match name {
            "limiting-draw-ratio" => draw_ratio(case),
            "greatest-height" => height(case),
            "least-holder-force" => holder_force(case.model()),
            "smallest-radius" => radius(case.model()),
            "over-bend" => over_bend(case),
            "bead-force" => bead_force(case.model()),
            _ => return fail(format!("there is no search `{name}`"), format!("choose one of {NAMES}")),
        };
        goal.map_err(|error| error.within(format!("{name} needs ")))
    }

    fn keep(vary: String, condition: &'static str, side: Side) -> Self {
        Self { vary: Some(vary), condition: Some(condition), side: Some(side), ..Self::default() }
    }

    fn reach(vary: String, quantity: &'static str) -> Self {
        Self { vary: Some(vary), quantity: Some(quantity), ..Self::default() }
    }
}

/// A blank gets the travel that draws the largest one through, h = d/4 (β² − 1) keeps its area, and the holder force of its rule.
fn draw_ratio(case: &Case) -> Result<Goal> {
    let model = one_stage(case)?;
    let (punch, die) = punch_and_die(model)?;
    let is_cup = model.geometry == Geometry::Axisymmetric && model.blank.edge == Edge::Free;
    need(is_cup, "an axisymmetric blank with a free edge")?;
    need(throat(die).is_some(), "a die that is open below: its `throat`")?;
    let radius = mouth(punch, model.travel);
    let held = model.tool(Role::Holder).map_or(0.0, |holder| extent(holder).0);
    let ends = [(RATIOS[0] * radius).max(FLANGE * shoulder_end(die).max(held)), RATIOS[1] * radius];
    // The chord of a parabola lies above it: blanks between the ends have travel enough.
    let travels = ends.map(|blank| 2.0 * radius * (0.25 * ((blank / radius).powi(2) - 1.0) + BEYOND));
    let (blank, travel) = (range("blank.radius", ends, "mm"), range("tools.punch.travel", travels, "mm"));
    // No finished part, which the case may have, decides on a draw ratio.
    let settings = ["stop.drawn_through=true", "output.count=2", "finished={}"].map(str::to_owned).to_vec();
    let holder = holder_rule(case, radius);
    Ok(Goal { settings, holder, ..Goal::keep(format!("{blank} & {travel}"), "no tear and no wrinkles", Side::Largest) })
}

fn height(case: &Case) -> Result<Goal> {
    Ok(Goal::keep(travels(one_stage(case)?, [0.2, 3.0])?, "no red and stop not amber", Side::Largest))
}

fn holder_force(model: &Model) -> Result<Goal> {
    let Some(Motion::Pressed(press)) = model.tool(Role::Holder).map(|holder| &holder.motion) else {
        return missing("a holder with a force: [tools.holder] force");
    };
    need(model.geometry == Geometry::Axisymmetric, "an axisymmetric flange, for it goes by the wrinkle index")?;
    let vary = range("tools.holder.force", [0.1, 10.0].map(|share| share * press.force.largest()), "N") + " log";
    Ok(Goal::keep(vary, "no red and wrinkling not red or amber", Side::Smallest))
}

fn radius(model: &Model) -> Result<Goal> {
    let (_, die) = punch_and_die(model)?;
    let shoulder = throat(die).map_or(0.0, |throat| shoulder_end(die) - throat);
    need(shoulder > 0.0, "a die with a `shoulder`")?;
    // A shell says nothing of a bend sharper than its thickness.
    let ends = [model.blank.thickness.min(0.5 * shoulder), 2.0 * shoulder];
    let note = Some(format!("Below {THIN} thicknesses a shell's forces are rough."));
    Ok(Goal { note, ..Goal::keep(range("tools.die.shoulder", ends, "mm"), "no red", Side::Smallest) })
}

/// Travel that bends legs in air to the wanted angle of the case; of a wall drawn under a holder the bead that stretches it into
/// 80 % of its tolerance: where the case has none, one in the flange that closes late.
fn over_bend(case: &Case) -> Result<Goal> {
    let is_released = case.stages.last().is_some_and(|stage| stage.model.release.is_some());
    need(is_released, "a stage that takes the tools away: [[stages]] with release = true")?;
    let (model, limits) = (case.model(), &case.springback);
    let Some(held) = held_from(model) else {
        let wanted = limits.angle.map(|angle| format!("opening_angle={angle} deg"));
        return Ok(Goal { wanted, ..Goal::reach(travels(model, [0.6, 1.3])?, "opening_angle") });
    };
    let tolerance = limits.wall_tolerance.or(limits.tolerance.map(|both| 0.5 * both)).unwrap_or_default();
    let wall = limits.angle.map(|angle| 0.5 * angle);
    let wanted = wall.map(|wall| format!("wall_angle={} deg", wall + 0.8 * tolerance));
    let at = significant(held + BEAD * model.blank.thickness, 4);
    let [from, full] = LATE.map(|share| significant(share * model.travel, 4));
    let bead = |force: &str| {
        format!("at = \"{at} mm\", restraining = [[\"{from} mm\", \"0 N/mm\"], [\"{full} mm\", {force}]]")
    };
    let setting = format!("tools.beads=[{{{}}}]", bead("\"0 N/mm\""));
    let lines = bead("the force");
    let note = format!("A bead that closes late stretches the wall. In the case: [[tools.beads]] with {lines}.");
    let is_new = model.beads.is_empty();
    let (settings, note) = if is_new { (vec![setting], Some(note)) } else { Default::default() };
    let vary = restraints(model, if is_new { "tools.beads.0.restraining.1.1" } else { BEAD_FORCE });
    let (tolerance, remedy) = (0.2 * tolerance, Some(("lean the walls of punch and die back by", wall)));
    Ok(Goal { settings, wanted, tolerance, note, remedy, ..Goal::reach(vary, "wall_angle") })
}

fn bead_force(model: &Model) -> Result<Goal> {
    need(!model.beads.is_empty(), "a bead: [[tools.beads]] with at and restraining")?;
    Ok(Goal::reach(restraints(model, BEAD_FORCE), "draw_in"))
}

fn restraints(model: &Model, key: &str) -> String {
    range(key, [0.0, RESTRAINT * flange_strength(model) * model.blank.thickness], "N/mm")
}

fn one_stage(case: &Case) -> Result<&Model> {
    need(case.later().is_empty(), "a case of one stage").map(|()| case.model())
}

fn punch_and_die(model: &Model) -> Result<(&Tool, &Tool)> {
    model.tool(Role::Punch).zip(model.tool(Role::Die)).map_or_else(|| missing("a punch and a die"), Ok)
}

fn travels(model: &Model, shares: [f64; 2]) -> Result<String> {
    need(model.tool(Role::Punch).is_some() && model.travel > 0.0, "a punch with a travel")?;
    Ok(range("tools.punch.travel", shares.map(|share| share * model.travel), "mm"))
}

fn need(is_there: bool, what: &str) -> Result<()> {
    if is_there { Ok(()) } else { missing(what) }
}

fn missing<T>(what: &str) -> Result<T> {
    fail(what, "give --vary and --while, or --target, for what this case has")
}

fn range(key: &str, ends: [f64; 2], unit: &str) -> String {
    let [low, high] = ends.map(|end| significant(end, 4));
    format!("{key}={low}..{high} {unit}")
}
