//! What a case file says, key by key; nothing here has a meaning yet beyond its own units and ranges.
//!
//! The documentation of the fields is what an editor shows through the JSON schema, the examples are what error
//! messages propose.

mod anisotropy;
mod compare;
mod forming_limit;
mod friction;
mod gas;
mod heat;
mod history;
mod material;
mod output;
mod press;
mod report;
mod section;
mod springback;
mod stages;
mod tools;
mod yield_condition;

pub use anisotropy::{Anisotropy, Directions};
pub use compare::{Compare, ComparedQuantity};
pub use forming_limit::FormingLimit;
pub use friction::{Friction, Sides};
pub use gas::{Gas, GasFace};
pub use heat::{Heat, InitialTemperature, ToolHeat, Zones};
pub use history::Given;
pub use material::Material;
pub use output::Output;
pub use press::Press;
pub use report::TitleBlock;
pub use section::{ProfileStep, Section, SectionTable, Turn};
pub use springback::Springback;
pub use stages::{FirstStage, Release, Stage, StageDie, StageHolder, StagePunch};
pub use tools::{Bead, Crowned, Die, Flat, Hemispherical, Holder, HolderForce, Punch, Spring, Stiffness, Tools};
pub use yield_condition::{Crystal, YieldCondition};

use crate::model::{Edge, Geometry, Grading, Settings, StopRules, Theory};
use crate::units::{Length, Positive};
use serde::Deserialize;

/// A forming case: blank, material, tools.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct CaseFile {
    /// Shown above plots and reports.
    #[schemars(example = "Steel cup, 60 mm punch")]
    pub title: String,
    /// Axisymmetric or plane strain.
    #[schemars(example = &"axisymmetric")]
    pub geometry: Geometry,
    /// Shown wherever results are shown; an assumption begins with "declared: ".
    #[serde(default)]
    pub notes: Vec<String>,
    /// The flat sheet.
    pub blank: Blank,
    /// What the sheet is made of.
    pub material: Material,
    /// The rigid tools.
    #[serde(default)]
    pub tools: Tools,
    /// Friction by the face of the sheet, for tools that do not name their own, and where all of it comes from.
    #[serde(default)]
    pub friction: Sides,
    /// Gas or oil that presses on the sheet.
    pub gas: Option<Gas>,
    /// Temperature of the sheet; 20 °C throughout when not given.
    pub heat: Option<Heat>,
    /// The forming limit that the strains are held against; none when not given.
    pub forming_limit: Option<FormingLimit>,
    /// What the press can give, for the verdict; the run does not depend on it.
    #[serde(default)]
    pub press: Press,
    /// The title block of reports.
    #[serde(default)]
    pub report: TitleBlock,
    /// The part's tolerances on spring-back, for the verdict; not judged when not given.
    pub springback: Option<Springback>,
    /// How the problem is solved.
    #[serde(default)]
    pub solver: Settings,
    /// What ends the run before its full travel.
    #[serde(default)]
    pub stop: StopRules,
    /// What is kept of the run.
    #[serde(default)]
    pub output: Output,
    /// The first stage, where there are several.
    #[serde(default)]
    pub stage: FirstStage,
    /// Operations after the first one, on the same sheet.
    #[serde(default)]
    pub stages: Vec<Stage>,
    /// Published curves and values to hold the result against.
    #[serde(default)]
    pub compare: Vec<Compare>,
}

/// The flat sheet before forming.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Blank {
    /// Radius of the blank (axisymmetric).
    #[schemars(example = "55 mm")]
    pub radius: Option<Positive<Length>>,
    /// Length from the symmetry plane to the edge (plane strain).
    #[schemars(example = "420 mm")]
    pub half_length: Option<Positive<Length>>,
    /// Length of the part across the section (plane strain): forces and works are then of the whole part, in N and J. When
    /// not given they are of the whole section per mm of depth.
    #[schemars(example = "800 mm")]
    pub depth: Option<Positive<Length>>,
    /// Initial thickness, 0.001 to 50 mm.
    #[schemars(example = "0.9 mm")]
    pub thickness: Positive<Length>,
    /// Number of elements from the axis or symmetry plane to the edge, 2 to 2000.
    #[serde(default = "default::elements")]
    #[schemars(range(min = 2, max = 2000), example = 100)]
    pub elements: i64,
    /// How element sizes are spread.
    #[serde(default)]
    #[schemars(extend("default" = "radii"))]
    pub grading: Grading,
    /// Shell theory of the sheet.
    #[serde(default)]
    #[schemars(extend("default" = "bending"))]
    pub theory: Theory,
    /// Integration points through the thickness of elements that bend, 3 to 101. When not given: 5 by the flow law, 9 in
    /// plane strain, where bending is most of the load; 15 for an elasto-viscoplastic sheet (with fewer the moment grows in
    /// jumps), 25 where a stage releases the sheet.
    #[schemars(range(min = 3, max = 101), example = 5)]
    pub layers: Option<i64>,
    /// How the outer edge is held.
    #[serde(default)]
    #[schemars(extend("default" = "free"))]
    pub edge: Edge,
}

mod default {
    pub fn elements() -> i64 {
        100
    }
}
