//! [`CaseFile`] → [`Stage`]s: meaning of the keys together, checked against each other.

mod blank;
mod compare;
mod counter;
mod drawn;
mod fit;
mod forming_limit;
mod friction;
mod gas;
mod heat;
mod holder;
mod judged;
mod limits;
mod lines;
mod material;
mod motion;
mod points;
mod section;
mod settings;
mod stages;
mod tools;
mod values;

pub(super) use compare::compare;
pub(super) use forming_limit::measured;
pub(super) use judged::{press, springback};
pub(super) use material::{convert as material, mean_of};

use super::file::CaseFile;
use super::{CaseError, source::Source};
use crate::model::{Extent, Friction, Mode, Model, Stage, Theory, Tool};
use friction::Frictions;
use tools::{Sheet, ToolContext};

/// Builds the stages of a case; notes on what was assumed go to the source.
pub(super) fn stages(file: &CaseFile, source: &Source) -> Result<Vec<Stage>, CaseError> {
    let stages = stages::convert(file, first(file, source)?, source)?;
    limits::of_stages(&stages, source)?;
    for (i, stage) in stages.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| &stages[before].model);
        // Values of the case have been checked above: these are the limits of the solver.
        stage.check(before).map_err(|error| {
            let path = if i == 0 { String::new() } else { format!("stages.{}", i - 1) };
            source.error(&path, error.to_string(), "the solver cannot take this: change the key that is named")
        })?;
    }
    Ok(stages)
}

/// Builds the model of the first stage.
fn first(file: &CaseFile, source: &Source) -> Result<Model, CaseError> {
    let geometry = file.geometry;
    let blank = blank::convert(file, source)?;
    let depth = blank::depth(file, source)?;
    let material = material::convert(&file.material, source)?;
    let mode = material::mode(file.material.mode.unwrap_or_default(), &material, "material.mode", source)?;
    let changes = mode != Mode::Flow && blank.theory == Theory::Selective;
    let what = "an elastic sheet cannot change between bending and membrane";
    source.require(!changes, "blank.theory", what, "write blank.theory = \"bending\", or mode = \"flow\"")?;
    let drive = motion::drive(file, blank.length, source)?;
    let (length, thickness) = (blank.length, blank.thickness);
    let sheet = Sheet { extent: Extent::of(geometry, depth), length, thickness };
    let context = ToolContext { written: &file.tools, standing: &[], sheet, travel: drive.travel, source };
    let tools = tools::convert(&context, &Frictions::new(file))?;
    let sheet = &context.sheet;
    let gas = file.gas.as_ref().map(|gas| gas::convert(gas, &tools, sheet, source)).transpose()?;
    let heat = file.heat.as_ref().map(|heat| heat::convert(heat, &tools, source)).transpose()?;
    if heat.is_none() && (material.thermal.is_some() || material.hardening.temperatures().is_some()) {
        source.note("without [heat] the sheet is at 20 °C throughout");
    }
    let limit = |limit| forming_limit::convert(limit, &material, blank.thickness, heat.as_ref(), source);
    let forming_limit = file.forming_limit.as_ref().map(limit).transpose()?;
    let by_rate = |tool: &Tool| matches!(tool.friction, Friction::Stribeck(_));
    let heat_flows = heat.as_ref().is_some_and(|heat| heat.flow.is_some());
    let timed = drive.timed || material.rate.is_some() || heat_flows || tools.iter().any(by_rate) || file.gas.is_some();
    let beads = holder::beads(&file.tools.beads, &tools, sheet, source)?;
    settings::check(&file.solver, source)?;
    settings::stop(&file.stop, &tools, source)?;
    let model = Model {
        title: file.title.clone(),
        notes: file.notes.clone(),
        geometry,
        depth,
        frames: settings::frames(&file.output, &drive, source)?,
        blank,
        material,
        tools,
        beads,
        gas: gas.unwrap_or_default(),
        heat,
        travel: drive.travel,
        schedule: drive.schedule,
        speed: drive.speed,
        duration: drive.duration,
        timed,
        stop: file.stop,
        settings: file.solver.clone(),
        mode,
        release: None,
        forming_limit,
    };
    fit::check(&model, source)?;
    limits::of_model(&model, &limits::frames_key(0, source), source)?;
    fit::collisions(&model, source)?;
    Ok(model)
}
