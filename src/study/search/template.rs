//! What shops ask for: the key, its span and the condition taken from the case itself.

use crate::assess::design::tensile_strength;
use crate::case::Case;
use crate::model::tool_sizes::{mouth, shoulder_end, throat};
use crate::model::{Edge, Geometry, Model, Motion, Role};
use crate::study::StudyError;
use crate::units::significant;

/// A search that has a name.
#[derive(Clone, Copy)]
pub struct Template {
    /// As it is asked for.
    pub name: &'static str,
    /// What it finds, in one line.
    pub about: &'static str,
    /// What it varies and for what, of a case.
    draft: fn(&Case) -> Result<Draft, StudyError>,
}

/// What a template makes of a case, each as it would be written on the command line.
#[derive(Clone, Debug, PartialEq)]
pub struct Draft {
    /// Overrides of all runs.
    pub settings: Vec<String>,
    /// What is varied.
    pub vary: String,
    /// What it is varied for.
    pub goal: Wanted,
    /// Whether the smallest value is wanted, or the largest.
    pub is_smallest: bool,
}

/// What a template varies a key for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wanted {
    /// That this holds.
    Condition(&'static str),
    /// That a number has a value, which the user gives.
    Number(&'static str),
}

/// All of them.
pub const TEMPLATES: &[Template] = &[
    Template {
        name: "limiting-draw-ratio",
        about: "the largest blank that is drawn through the die without a tear",
        draft: limiting_draw_ratio,
    },
    Template {
        name: "greatest-height",
        about: "the largest travel that ends without a red light",
        draft: greatest_height,
    },
    Template {
        name: "least-holder-force",
        about: "the smallest holder force that keeps the flange flat",
        draft: least_holder_force,
    },
    Template {
        name: "smallest-radius",
        about: "the smallest die shoulder without a red light",
        draft: smallest_radius,
    },
    Template { name: "over-bend", about: "the travel that leaves a wanted angle after springback", draft: over_bend },
    Template { name: "bead-force", about: "the force of the first bead for a wanted draw-in", draft: bead_force },
];

impl Template {
    /// The template of a name.
    ///
    /// # Errors
    /// When there is none, with those that there are.
    pub fn named(name: &str) -> Result<&'static Self, StudyError> {
        TEMPLATES.iter().find(|template| template.name == name).ok_or_else(|| {
            let known: Vec<&str> = TEMPLATES.iter().map(|template| template.name).collect();
            StudyError::new(format!("there is no search `{name}`"), format!("choose one of {}", known.join(", ")))
        })
    }

    /// What it varies and for what.
    ///
    /// # Errors
    /// When the case does not have what it needs.
    pub fn draft(&self, case: &Case) -> Result<Draft, StudyError> {
        (self.draft)(case)
    }
}

/// Blank diameters over that of the punch that are looked at \[–\].
const RATIOS: [f64; 2] = [1.2, 3.0];
/// Travel beyond that at which a blank of the largest ratio is through the die, over the punch's diameter \[–\].
const BEYOND: f64 = 0.3;
/// What a flange is at least, over the radius at which the die's flat begins \[–\].
const FLANGE: f64 = 1.02;
/// Travels over the case's own that are looked at \[–\].
const TRAVELS: [f64; 2] = [0.2, 3.0];
/// Holder forces, likewise.
const FORCES: [f64; 2] = [0.1, 10.0];
/// Radii, likewise.
const RADII: [f64; 2] = [0.15, 2.0];
/// Travels of a bend, likewise.
const BENDS: [f64; 2] = [0.6, 1.3];
/// Largest restraint of a bead, over what the sheet carries \[–\].
const RESTRAINT: f64 = 0.5;

/// A blank is given a travel that draws the largest through: h = d/4 (β² − 1) keeps its area.
fn limiting_draw_ratio(case: &Case) -> Result<Draft, StudyError> {
    let model = one_draw(case, "limiting-draw-ratio")?;
    let (punch, die) = tools(model, "limiting-draw-ratio")?;
    if model.geometry != Geometry::Axisymmetric || model.blank.edge != Edge::Free {
        return Err(missing("limiting-draw-ratio", "an axisymmetric blank with a free edge"));
    }
    let diameter = 2.0 * mouth(punch, model.travel);
    if throat(die).is_none() {
        return Err(missing("limiting-draw-ratio", "a die that is open below: its `throat`"));
    }
    let held = model.tool(Role::Holder).map_or(0.0, |holder| crate::model::tool_sizes::extent(holder).0);
    let low = (RATIOS[0] * diameter).max(FLANGE * 2.0 * shoulder_end(die).max(held));
    let high = RATIOS[1] * diameter;
    // The chord of a parabola lies above it: what is between the ends has travel enough.
    let [short, long] = [low, high].map(|blank| diameter * (0.25 * ((blank / diameter).powi(2) - 1.0) + BEYOND));
    let (blank, travel) = (span("blank.diameter", low, high, "mm"), span("tools.punch.travel", short, long, "mm"));
    Ok(Draft {
        settings: vec!["stop.drawn_through=true".into(), "output.count=2".into()],
        vary: format!("{blank} & {travel}"),
        goal: Wanted::Condition("no tear"),
        is_smallest: false,
    })
}

fn greatest_height(case: &Case) -> Result<Draft, StudyError> {
    let model = one_draw(case, "greatest-height")?;
    if model.tool(Role::Punch).is_none() || model.travel <= 0.0 {
        return Err(missing("greatest-height", "a punch with a travel"));
    }
    let [low, high] = TRAVELS.map(|share| share * model.travel);
    let goal = Wanted::Condition("no red and stop not amber");
    Ok(Draft { settings: Vec::new(), vary: span("tools.punch.travel", low, high, "mm"), goal, is_smallest: false })
}

fn least_holder_force(case: &Case) -> Result<Draft, StudyError> {
    let model = case.model();
    let Some(Motion::Pressed(press)) = model.tool(Role::Holder).map(|holder| &holder.motion) else {
        return Err(missing("least-holder-force", "a holder with a force: [tools.holder] force"));
    };
    if model.geometry != Geometry::Axisymmetric {
        let what = "an axisymmetric flange, for it goes by the wrinkle index; of a strip give --vary and --while";
        return Err(missing("least-holder-force", what));
    }
    let [low, high] = FORCES.map(|share| share * press.force.largest());
    Ok(Draft {
        settings: Vec::new(),
        vary: span("tools.holder.force", low, high, "N") + " log",
        goal: Wanted::Condition("no red and wrinkling not red or amber"),
        is_smallest: true,
    })
}

fn smallest_radius(case: &Case) -> Result<Draft, StudyError> {
    let (_, die) = tools(case.model(), "smallest-radius")?;
    let shoulder = throat(die).map(|throat| shoulder_end(die) - throat).filter(|shoulder| *shoulder > 0.0);
    let Some(shoulder) = shoulder else { return Err(missing("smallest-radius", "a die with a `shoulder`")) };
    let [low, high] = RADII.map(|share| share * shoulder);
    let vary = span("tools.die.shoulder", low, high, "mm");
    Ok(Draft { settings: Vec::new(), vary, goal: Wanted::Condition("no red"), is_smallest: true })
}

fn over_bend(case: &Case) -> Result<Draft, StudyError> {
    let model = case.model();
    if case.stages.last().is_none_or(|stage| stage.model.release.is_none()) {
        return Err(missing("over-bend", "a stage that takes the tools away: [[stages]] with release = true"));
    }
    if model.tool(Role::Punch).is_none() || model.travel <= 0.0 {
        return Err(missing("over-bend", "a punch with a travel"));
    }
    let [low, high] = BENDS.map(|share| share * model.travel);
    let vary = span("tools.punch.travel", low, high, "mm");
    Ok(Draft { settings: Vec::new(), vary, goal: Wanted::Number("opening_angle"), is_smallest: true })
}

fn bead_force(case: &Case) -> Result<Draft, StudyError> {
    let model = case.model();
    if model.beads.is_empty() {
        return Err(missing("bead-force", "a bead: [[tools.beads]] with at and restraining"));
    }
    let largest = RESTRAINT * tensile_strength(&model.material) * model.blank.thickness;
    let vary = span("tools.beads.0.restraining", 0.0, largest, "N/mm");
    Ok(Draft { settings: Vec::new(), vary, goal: Wanted::Number("draw_in"), is_smallest: true })
}

/// The model of a case of one stage.
fn one_draw<'a>(case: &'a Case, name: &str) -> Result<&'a Model, StudyError> {
    if case.later().is_empty() { Ok(case.model()) } else { Err(missing(name, "a case of one stage")) }
}

fn tools<'a>(model: &'a Model, name: &str) -> Result<(&'a crate::model::Tool, &'a crate::model::Tool), StudyError> {
    model.tool(Role::Punch).zip(model.tool(Role::Die)).ok_or_else(|| missing(name, "a punch and a die"))
}

fn missing(name: &str, what: &str) -> StudyError {
    StudyError::new(format!("{name} needs {what}"), "give --vary and --while, or --target, for what this case has")
}

fn span(key: &str, low: f64, high: f64, unit: &str) -> String {
    format!("{key}={}..{} {unit}", significant(low, 4), significant(high, 4))
}
