//! Keys of a case file, in their own units and ranges.
//!
//! The documentation of the fields is shown by editors through the JSON schema, the examples are proposed by error messages.

mod judged;
mod loads;
mod material;
mod section;
mod stages;
mod tools;
mod untagged;

pub use judged::{Compare, Press, Springback, TitleBlock};
pub use loads::{Extensive, Gas, GasFace, Given, Heat, HolderForce, InitialTemperature, Stiffness, ToolHeat, Zones};
pub use material::{Anisotropy, Crystal, FormingLimit, Material, YieldCondition};
pub use section::{ProfileStep, Section, SectionTable, Turn};
pub use stages::{FirstStage, Release, Stage};
pub use tools::{Bead, Crowned, Die, Flat, Friction, Hemispherical, Holder, Punch, Sides, Spring, ToolKeys, Tools};

use crate::model::{Edge, Geometry, Grading, Settings, StopRules, Theory};
use crate::units::{Length, Positive};
use schemars::JsonSchema;
use serde::Deserialize;

/// Forming case: blank, material, tools.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
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
    /// Flat sheet.
    pub blank: Blank,
    /// Material of the sheet.
    pub material: Material,
    /// Rigid tools.
    #[serde(default)]
    pub tools: Tools,
    /// Friction by the face of the sheet, for tools without their own, and its source.
    #[serde(default)]
    pub friction: Sides,
    /// Gas or oil that presses on the sheet.
    pub gas: Option<Gas>,
    /// Temperature of the sheet; 20 °C throughout when not given.
    pub heat: Option<Heat>,
    /// Forming limit to check the strains against; default none.
    pub forming_limit: Option<FormingLimit>,
    /// Rating of the press, for the verdict; the run does not depend on it.
    #[serde(default)]
    pub press: Press,
    /// Title block of reports.
    #[serde(default)]
    pub report: TitleBlock,
    /// Tolerances of the part on spring-back, for the verdict.
    pub springback: Option<Springback>,
    /// Numerical parameters.
    #[serde(default)]
    pub solver: Settings,
    /// Conditions that end the run before its full travel.
    #[serde(default)]
    pub stop: StopRules,
    /// Kept instants of the run.
    #[serde(default)]
    pub output: Output,
    /// Name of the first of several stages.
    #[serde(default)]
    pub stage: FirstStage,
    /// Operations after the first one, on the same sheet.
    #[serde(default)]
    pub stages: Vec<Stage>,
    /// Published curves and values to hold the result against.
    #[serde(default)]
    pub compare: Vec<Compare>,
}

/// Flat sheet before forming.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Blank {
    /// Radius of the blank (axisymmetric).
    #[schemars(example = "55 mm")]
    pub radius: Option<Positive<Length>>,
    /// Diameter of the blank, instead of `radius`.
    #[schemars(example = "110 mm")]
    pub diameter: Option<Positive<Length>>,
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
    #[serde(default = "default_elements")]
    #[schemars(range(min = 2, max = 2000), example = 100)]
    pub elements: i64,
    /// Distribution of element sizes.
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
    /// Support of the outer edge.
    #[serde(default)]
    #[schemars(extend("default" = "free"))]
    pub edge: Edge,
}

fn default_elements() -> i64 {
    100
}

/// Kept instants: `frames` or `count`; the end of the travel always is.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Punch travels at which the state is kept.
    pub frames: Option<Vec<Positive<Length>>>,
    /// Number of equally spaced instants, 1 to 1000; default 4.
    #[schemars(range(min = 1, max = 1000), example = 4)]
    pub count: Option<i64>,
}
