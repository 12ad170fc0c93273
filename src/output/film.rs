//! The draw as a moving picture: the section, true to thickness, with its tools, and how far the load has come.

use super::chart::{Chart, Look, Panel, Scale, Series, color};
use super::draw::Drawing;
use super::file::{WriteError, write as write_file};
use super::gif::gif;
use super::{Subject, load_travel, profile, progress, reaches, shapes};
use crate::solution::Frame;
use std::path::{Path, PathBuf};

/// The file that [`write()`] makes.
pub const FILE: &str = "shapes.gif";

/// How many pictures are wanted of a run: every second of its steps, which are at most a hundredth of it by default.
pub const PICTURES: usize = 50;

/// How long the whole run is shown, and its last picture after it \[hundredths of a second\].
const LENGTH: f64 = 400.0;
const LAST: u16 = 150;
/// What viewers show at all; several take less for a tenth of a second \[hundredths of a second\].
const SHORTEST: f64 = 2.0;

/// Height of the load's panel \[px of a picture 800 wide\].
const LOAD_HEIGHT: f64 = 130.0;

/// Writes `shapes.gif` of these frames, rising in time, into `dir`; nothing of a run that never started.
///
/// Each picture is shown for as long as its frame lasts, so that the tools move evenly.
///
/// # Errors
/// When the file cannot be written.
pub fn write(subject: &Subject, frames: &[Frame], dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
    if frames.len() < 2 {
        return Ok(Vec::new());
    }
    let drawings = (0..frames.len()).map(|i| Drawing::of(&picture(subject, frames, i)));
    let path = dir.join(FILE);
    write_file(&path, &gif(drawings, &delays(subject, frames)))?;
    Ok(vec![path])
}

/// How long each picture is shown \[hundredths of a second\].
fn delays(subject: &Subject, frames: &[Frame]) -> Vec<u16> {
    let done = |frame: &Frame| subject.model.progress(frame.time);
    let whole = done(&frames[frames.len() - 1]) - done(&frames[0]);
    let until_next = frames.windows(2).map(|pair| LENGTH * (done(&pair[1]) - done(&pair[0])) / whole);
    until_next.map(|hundredths| hundredths.max(SHORTEST).round() as u16).chain([LAST]).collect()
}

/// The `i`-th frame; the window and the axes are those of the whole film.
pub fn picture(subject: &Subject, frames: &[Frame], i: usize) -> Chart {
    let (model, frame) = (subject.model, &frames[i]);
    let table = profile::last(model, &frames[..=i]);
    let (x, y) = shapes::window(frames.iter().flat_map(|f| &f.nodes), model.blank.length);
    let (value, unit) = reaches(model, frame);
    let decimals = decimals(frames.iter().map(|frame| reaches(model, frame).0).fold(0.0, f64::max));
    let sheet = Series::new(
        format!("{value:.decimals$} {}", unit.symbol()),
        shapes::sheet(frame, 0..frame.elements.len()),
        Look::Area { fill: color(0), edge: None },
    );
    let section = Panel {
        x: table.column("r").axis(),
        y: table.column("z").axis(),
        series: shapes::tools(model, Some(frame), x.1).chain([sheet]).collect(),
        scale: Scale::Section { x, y },
    };
    Chart {
        title: model.title.clone(),
        legend: progress(model),
        panels: std::iter::once(section).chain(load(subject, frame.time)).collect(),
        notes: subject.notes(),
    }
}

/// The load up to a time, on what it comes to; nothing where nothing loads the sheet.
fn load(subject: &Subject, time: f64) -> Option<Panel> {
    let mut panel = load_travel::panel(subject, LOAD_HEIGHT)?;
    let acts = panel.series.iter().flat_map(|series| &series.points).any(|point| point.1 != 0.0);
    let steps = subject.run.steps.iter().take_while(|step| step.time <= time).count();
    let whole: Vec<Series> =
        panel.series.iter().map(|series| Series::silent(series.points.clone(), series.look.faint())).collect();
    for series in &mut panel.series {
        series.points.truncate(steps);
    }
    panel.series.splice(..0, whole);
    acts.then_some(panel)
}

/// As many decimals as show three digits of `largest`, at most 6.
fn decimals(largest: f64) -> usize {
    if largest > 0.0 { (2.0 - largest.log10().floor()).clamp(0.0, 6.0) as usize } else { 0 }
}
