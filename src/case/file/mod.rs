//! Keys of a case file, in their own units and ranges, and the models that they mean.
//!
//! The documentation of the fields is shown by editors through the JSON schema, the examples are proposed by error messages.

mod blank;
mod contact;
mod counter;
mod drive;
mod fit;
mod forming_limit;
mod further;
mod judged;
mod material;
mod opening;
mod points;
mod preform;
mod section;
mod stages;
mod surroundings;
mod tools;
mod values;
mod zones;

pub(super) use forming_limit::FormingLimit;
pub use judged::{Finished, Press, Springback, TitleBlock};
pub(super) use material::{Anisotropy, Material};
pub use material::{Crystal, YieldCondition};
pub(super) use points::Named;

use super::{CaseError, Result, comparison::Compare, source::Source};
use crate::geometry::{Piece, Point, Profile};
use crate::model::tool_sizes::shoulder_end;
use crate::model::{
    self, Edge, Extent, Friction, Geometry, Mode, Model, Motion, Role, Settings, StopRules, Theory, Tool,
};
use crate::numerics::PiecewiseLinear;
use crate::units::{
    Amount, Angle, Dimensioned, Fraction, Length, NonNegative, Number, Positive, Stress, Time, rounded,
};
use blank::Blank;
use contact::{Frictions, Sides};
use drive::Output;
use judged::WrittenPress;
use material::checked_mode;
use schemars::JsonSchema;
use serde::{Deserialize, de::IntoDeserializer};
use stages::{FirstStage, Stage};
use std::ops::RangeInclusive;
use surroundings::{Gas, Heat};
use tools::{ToolContext, Tools};
use values::{History, HolderForce, count, place_of, radius_of, untagged};

/// Forming case: blank, material, tools.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CaseFile {
    /// Shown above plots and reports.
    title: String,
    /// Axisymmetric or plane strain.
    geometry: Geometry,
    /// Shown wherever results are shown; an assumption begins with "declared: ".
    #[serde(default)]
    notes: Vec<String>,
    /// Flat sheet.
    blank: Blank,
    /// Material of the sheet.
    pub material: Material,
    /// Rigid tools.
    #[serde(default)]
    tools: Tools,
    /// Friction by the face of the sheet, for tools without their own, and its source.
    #[serde(default)]
    pub friction: Sides,
    /// Gas or oil that presses on the sheet.
    gas: Option<Gas>,
    /// Temperature of the sheet; 20 °C throughout when not given.
    heat: Option<Heat>,
    /// Forming limit to check the strains against; without it one is computed where that makes sense.
    pub forming_limit: Option<FormingLimit>,
    /// Rating of the press, for the verdict; the run does not depend on it.
    #[serde(default)]
    press: WrittenPress,
    /// Title block of reports.
    #[serde(default)]
    pub report: TitleBlock,
    /// Sizes of the trimmed part, for the verdict.
    #[serde(default)]
    pub finished: Finished,
    /// Tolerances of the part on spring-back, for the verdict.
    springback: Option<Springback>,
    /// Numerical parameters.
    #[serde(default)]
    solver: Settings,
    /// Conditions that end the run before its full travel.
    #[serde(default)]
    stop: StopRules,
    /// Kept instants of the run.
    #[serde(default)]
    output: Output,
    /// Name of the first of several stages.
    #[serde(default)]
    stage: FirstStage,
    /// Operations after the first one, on the same sheet.
    #[serde(default)]
    stages: Vec<Stage>,
    /// Published curves and values to hold the result against.
    #[serde(default)]
    pub compare: Vec<Compare>,
}

impl CaseFile {
    /// Models of all stages; notes on what was assumed go to the source.
    pub fn stages(&self, source: &Source) -> Result<Vec<model::Stage>> {
        let stages = stages::stages(self, self.first(source)?, source)?;
        drive::of_stages(&stages, source)?;
        for (i, stage) in stages.iter().enumerate() {
            // Values of the case have been checked above: these are the limits of the solver.
            stage.check(i.checked_sub(1).map(|before| &stages[before].model)).map_err(|error| {
                let path = if i == 0 { error.what.clone() } else { format!("stages.{}", i - 1) };
                source.error(&path, error.to_string(), "the solver cannot take this: change the key that is named")
            })?;
        }
        Ok(stages)
    }

    fn first(&self, source: &Source) -> Result<Model> {
        let extent = self.extent(source)?;
        let mut blank = self.blank(source)?;
        let material = self.material.model(source)?;
        blank.zones = zones::Zone::all(&self.blank.zones, &blank, &material, source)?;
        let mode = checked_mode(self.material.mode.unwrap_or_default(), &material, "material.mode", source)?;
        let drive = self.drive(blank.length, source)?;
        let (written, travel) = (&self.tools, drive.travel);
        let further: Vec<String> = written.further.iter().map(|tool| tool.name.clone()).collect();
        let context = ToolContext { written, standing: &[], further: &further, blank: &blank, extent, travel, source };
        let tools = context.tools(&Frictions::new(self))?;
        // A sheet that is not flat is sealed at its ends, however far it bulges.
        let sealed = if blank.meridian.is_some() { blank.reach() + blank.length } else { blank.length };
        let gas = self.gas.as_ref().map(|gas| gas.model(&tools, sealed, source)).transpose()?;
        let heat = self.heat.as_ref().map(|heat| heat.model(&tools, source)).transpose()?;
        if heat.is_none() && (material.thermal.is_some() || material.hardening.temperatures().is_some()) {
            source.note("without [heat] the sheet is at 20 °C throughout");
        }
        let forming_limit = match &self.forming_limit {
            Some(limit) => limit.curve(&material, blank.thickness, heat.as_ref(), source)?,
            None => FormingLimit::usual(&material, blank.thickness, heat.as_ref(), source),
        };
        let by_rate = tools.iter().any(|tool| matches!(tool.friction, Friction::Stribeck(_)));
        let heat_flows = heat.as_ref().is_some_and(|heat| heat.flow.is_some());
        let timed = drive.timed || material.rate.is_some() || heat_flows || by_rate || self.gas.is_some();
        drive::check_settings(&self.solver, source)?;
        drive::check_stop(&self.stop, &tools, source)?;
        let mut model = Model {
            title: self.title.clone(),
            notes: self.notes.clone(),
            geometry: self.geometry,
            depth: self.blank.depth.map(Dimensioned::value),
            frames: self.output.frames(&drive, source)?,
            blank,
            material,
            tools,
            further,
            beads: Vec::new(),
            gas: gas.unwrap_or_default(),
            heat,
            travel: drive.travel,
            schedule: drive.schedule,
            speed: drive.speed,
            duration: drive.duration,
            timed,
            stop: self.stop,
            settings: self.solver.clone(),
            mode,
            release: None,
            forming_limit,
        };
        model.beads = contact::beads(&written.beads, &model, source)?;
        fit::check(&model, source)?;
        drive::of_model(&model, &drive::frames_key(0, source), source)?;
        fit::collisions(&model, source)?;
        Ok(model)
    }
}
