//! Searches with a name: variable, range and condition follow from the case.

use super::StudyError;
use super::bracket::Side;
use crate::assess::design::tensile_strength;
use crate::case::Case;
use crate::model::tool_sizes::{extent, mouth, shoulder_end, throat};
use crate::model::{Edge, Geometry, Model, Motion, Role, Tool};
use crate::units::significant;

/// A search with a name.
#[derive(Clone, Copy)]
pub struct Goal {
    /// Name on the command line.
    pub name: &'static str,
    /// Result in one line.
    pub about: &'static str,
    request: fn(&Case) -> Result<GoalRequest, StudyError>,
}

/// Request of a goal, each part as on the command line.
#[derive(Clone, Debug, PartialEq)]
pub struct GoalRequest {
    /// Overrides of all runs.
    pub settings: Vec<String>,
    /// The variable with its range.
    pub vary: String,
    /// The condition; or the quantity whose value the user gives.
    pub aim: GoalAim,
    /// Wanted end of the range.
    pub side: Side,
}

/// Condition or quantity of a goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GoalAim {
    /// A condition that must hold.
    Condition(&'static str),
    /// A quantity; the user gives its value.
    Quantity(&'static str),
}

/// All goals.
pub const GOALS: &[Goal] = &[
    Goal { name: "limiting-draw-ratio", about: "the largest blank that is drawn without a tear", request: draw_ratio },
    Goal { name: "greatest-height", about: "the largest travel without a red light", request: height },
    Goal { name: "least-holder-force", about: "the smallest force that keeps the flange flat", request: holder_force },
    Goal { name: "smallest-radius", about: "the smallest die shoulder without a red light", request: radius },
    Goal { name: "over-bend", about: "the travel for a wanted angle: with --target \"90 deg\"", request: over_bend },
    Goal { name: "bead-force", about: "the bead for a wanted draw-in: with --target \"8 mm\"", request: bead_force },
];

/// Smallest and largest draw ratio \[–\].
const RATIOS: [f64; 2] = [1.2, 3.0];
/// Travel beyond the height of the largest blank's cup, over the punch diameter \[–\].
const BEYOND: f64 = 0.3;
/// Least blank radius over the outer end of the die shoulder \[–\].
const FLANGE: f64 = 1.02;
/// Largest bead force over the sheet's strength \[–\].
const RESTRAINT: f64 = 0.5;

impl Goal {
    /// The request of a named goal for a case.
    ///
    /// # Errors
    /// When there is no such goal, or the case lacks what it needs.
    pub fn request(name: &str, case: &Case) -> Result<GoalRequest, StudyError> {
        let goal = GOALS.iter().find(|goal| goal.name == name).ok_or_else(|| {
            let names: Vec<&str> = GOALS.iter().map(|goal| goal.name).collect();
            StudyError::new(format!("there is no search `{name}`"), format!("choose one of {}", names.join(", ")))
        })?;
        (goal.request)(case).map_err(|error| match error {
            StudyError::Request { what, help } => StudyError::new(format!("{name} needs {what}"), help),
            of_case @ StudyError::Case(_) => of_case,
        })
    }
}

/// A blank gets the travel that draws the largest one through: h = d/4 (β² − 1) keeps its area.
fn draw_ratio(case: &Case) -> Result<GoalRequest, StudyError> {
    let model = one_stage(case)?;
    let (punch, die) = punch_and_die(model)?;
    if model.geometry != Geometry::Axisymmetric || model.blank.edge != Edge::Free {
        return Err(missing("an axisymmetric blank with a free edge"));
    }
    if throat(die).is_none() {
        return Err(missing("a die that is open below: its `throat`"));
    }
    let radius = mouth(punch, model.travel);
    let held = model.tool(Role::Holder).map_or(0.0, |holder| extent(holder).0);
    let low = (RATIOS[0] * radius).max(FLANGE * shoulder_end(die).max(held));
    let high = RATIOS[1] * radius;
    // The chord of a parabola lies above it: blanks between the ends have travel enough.
    let [short, long] = [low, high].map(|blank| 2.0 * radius * (0.25 * ((blank / radius).powi(2) - 1.0) + BEYOND));
    let (blank, travel) = (range("blank.radius", [low, high], "mm"), range("tools.punch.travel", [short, long], "mm"));
    Ok(GoalRequest {
        settings: vec!["stop.drawn_through=true".into(), "output.count=2".into()],
        vary: format!("{blank} & {travel}"),
        aim: GoalAim::Condition("no tear"),
        side: Side::Largest,
    })
}

fn height(case: &Case) -> Result<GoalRequest, StudyError> {
    let vary = travels(one_stage(case)?, [0.2, 3.0])?;
    let aim = GoalAim::Condition("no red and stop not amber");
    Ok(GoalRequest { settings: Vec::new(), vary, aim, side: Side::Largest })
}

fn holder_force(case: &Case) -> Result<GoalRequest, StudyError> {
    let model = case.model();
    let Some(Motion::Pressed(press)) = model.tool(Role::Holder).map(|holder| &holder.motion) else {
        return Err(missing("a holder with a force: [tools.holder] force"));
    };
    if model.geometry != Geometry::Axisymmetric {
        return Err(missing("an axisymmetric flange, for it goes by the wrinkle index"));
    }
    let vary = range("tools.holder.force", [0.1, 10.0].map(|share| share * press.force.largest()), "N") + " log";
    let aim = GoalAim::Condition("no red and wrinkling not red or amber");
    Ok(GoalRequest { settings: Vec::new(), vary, aim, side: Side::Smallest })
}

fn radius(case: &Case) -> Result<GoalRequest, StudyError> {
    let (_, die) = punch_and_die(case.model())?;
    let shoulder = throat(die).map(|throat| shoulder_end(die) - throat).filter(|shoulder| *shoulder > 0.0);
    let Some(shoulder) = shoulder else { return Err(missing("a die with a `shoulder`")) };
    let vary = range("tools.die.shoulder", [0.15, 2.0].map(|share| share * shoulder), "mm");
    Ok(GoalRequest { settings: Vec::new(), vary, aim: GoalAim::Condition("no red"), side: Side::Smallest })
}

fn over_bend(case: &Case) -> Result<GoalRequest, StudyError> {
    if case.stages.last().is_none_or(|stage| stage.model.release.is_none()) {
        return Err(missing("a stage that takes the tools away: [[stages]] with release = true"));
    }
    let vary = travels(case.model(), [0.6, 1.3])?;
    Ok(GoalRequest { settings: Vec::new(), vary, aim: GoalAim::Quantity("opening_angle"), side: Side::Smallest })
}

fn bead_force(case: &Case) -> Result<GoalRequest, StudyError> {
    let model = case.model();
    if model.beads.is_empty() {
        return Err(missing("a bead: [[tools.beads]] with at and restraining"));
    }
    let largest = RESTRAINT * tensile_strength(&model.material) * model.blank.thickness;
    let vary = range("tools.beads.0.restraining", [0.0, largest], "N/mm");
    Ok(GoalRequest { settings: Vec::new(), vary, aim: GoalAim::Quantity("draw_in"), side: Side::Smallest })
}

fn one_stage(case: &Case) -> Result<&Model, StudyError> {
    if case.later().is_empty() { Ok(case.model()) } else { Err(missing("a case of one stage")) }
}

fn punch_and_die(model: &Model) -> Result<(&Tool, &Tool), StudyError> {
    model.tool(Role::Punch).zip(model.tool(Role::Die)).ok_or_else(|| missing("a punch and a die"))
}

/// Travels over the case's own.
fn travels(model: &Model, shares: [f64; 2]) -> Result<String, StudyError> {
    if model.tool(Role::Punch).is_none() || model.travel <= 0.0 {
        return Err(missing("a punch with a travel"));
    }
    Ok(range("tools.punch.travel", shares.map(|share| share * model.travel), "mm"))
}

fn missing(what: &str) -> StudyError {
    StudyError::new(what, "give --vary and --while, or --target, for what this case has")
}

fn range(key: &str, ends: [f64; 2], unit: &str) -> String {
    let [low, high] = ends.map(|end| significant(end, 4));
    format!("{key}={low}..{high} {unit}")
}
