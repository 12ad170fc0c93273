//! [`CaseFile`] → [`Stage`]s: what the keys mean together, checked against each other.

mod blank;
mod collide;
mod compare;
mod context;
mod counter;
mod drawn;
mod fit;
mod forming_limit;
mod friction;
mod heat;
mod laws;
mod limits;
mod lines;
mod loads;
mod material;
mod memory;
mod motion;
mod patch;
mod place;
mod points;
mod press;
mod profile;
mod section;
mod settings;
mod springback;
mod stages;
mod tools;
mod values;

pub(super) use compare::compare;
pub(super) use forming_limit::measured;
pub(super) use material::{convert as material, mean_of};
pub(super) use press::press;
pub(super) use springback::springback;

use context::{Sheet, ToolContext};
use friction::Frictions;

use super::file::CaseFile;
use super::{CaseError, source::Source};
use crate::case::files::Folder;
use crate::material::Material;
use crate::model::{Blank, Extent, Friction, Heat, Mode, Model, Stage, Theory, Tool};

/// What a case whose files are looked up from a folder means: its stages, and what was assumed.
pub(super) fn stages(file: &CaseFile, source: &Source, folder: Folder) -> Result<(Vec<Stage>, Vec<String>), CaseError> {
    limits::of_file(file, source)?;
    let mut derived = Vec::new();
    let first = first(file, source, folder, &mut derived)?;
    let stages = stages::convert(file, first, source, folder, &mut derived)?;
    limits::of_stages(&stages, source)?;
    for (i, stage) in stages.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| &stages[before].model);
        // What is said of a value of the case has been said above: this is the border of the solver.
        stage.check(before).map_err(|error| {
            let path = if i == 0 { String::new() } else { format!("stages.{}", i - 1) };
            source.error(&path, error.to_string(), "the solver cannot take this: change what makes it so")
        })?;
    }
    Ok((stages, derived))
}

/// The model of the first stage.
fn first(file: &CaseFile, source: &Source, folder: Folder, derived: &mut Vec<String>) -> Result<Model, CaseError> {
    let geometry = file.geometry;
    let blank = blank::convert(file, geometry, source, derived)?;
    let depth = blank::depth(file, source)?;
    let material = material::convert(&file.material, source)?;
    let mode = mode(file, &material, &blank, source)?;
    let drive = motion::drive(file, blank.length, source)?;
    let (sheet, travel) = (Sheet::of(&blank, Extent::of(geometry, depth)), drive.travel);
    let context =
        ToolContext { written: &file.tools, standing: &[], sheet, travel, source, folder, profile: tools::profile };
    let tools = tools::convert(&context, &Frictions::of(file), derived)?;
    let sheet = context.sheet;
    let gas = file.gas.as_ref().map(|gas| loads::gas(gas, &tools, &sheet, source, derived)).transpose()?;
    let heat = file.heat.as_ref().map(|heat| heat::convert(heat, &tools, source, folder)).transpose()?;
    if heat.is_none() && (material.thermal.is_some() || material.hardening.temperatures().is_some()) {
        derived.push("without [heat] the sheet is at 20 °C throughout".into());
    }
    let limit = file.forming_limit.as_ref();
    let limit = limit
        .map(|limit| forming_limit::convert(limit, &material, blank.thickness, heat.as_ref(), source, derived))
        .transpose()?;
    let feels_rate = feels_rate(&material, heat.as_ref(), &tools) || file.gas.is_some();
    let beads = loads::beads(&file.tools.beads, &tools, &sheet, source)?;
    settings::stop(&file.stop, &tools, source)?;
    let frames = settings::frames(&file.output, &drive, source)?;
    settings::check(&file.solver, source)?;
    let model = Model {
        title: file.title.clone(),
        notes: file.notes.clone(),
        geometry,
        depth,
        blank,
        material,
        tools,
        beads,
        gas: gas.unwrap_or_default(),
        heat,
        travel,
        schedule: drive.schedule,
        speed: drive.speed,
        duration: drive.duration,
        timed: drive.timed || feels_rate,
        frames,
        stop: file.stop,
        settings: file.solver.clone(),
        mode,
        release: None,
        forming_limit: limit,
    };
    fit::check(&model, source)?;
    limits::of_model(&model, &limits::frames_key(0, source), source)?;
    collide::check(&model, source)?;
    Ok(model)
}

/// Whether the result depends on how fast the tools go.
fn feels_rate(material: &Material, heat: Option<&Heat>, tools: &[Tool]) -> bool {
    let flows = heat.is_some_and(|heat| heat.flow.is_some());
    let by_speed = |tool: &Tool| matches!(tool.friction, Friction::Stribeck(_));
    material.rate.is_some() || flows || tools.iter().any(by_speed)
}

fn mode(file: &CaseFile, material: &Material, blank: &Blank, source: &Source) -> Result<Mode, CaseError> {
    let mode = file.material.mode.map(|mode| material::mode(mode, material, "material.mode", source)).transpose()?;
    let mode = mode.unwrap_or_default();
    if mode != Mode::Flow && blank.theory == Theory::Selective {
        let help = "write blank.theory = \"bending\", or mode = \"flow\"";
        return Err(source.error("blank.theory", "an elastic sheet cannot change between bending and membrane", help));
    }
    Ok(mode)
}
