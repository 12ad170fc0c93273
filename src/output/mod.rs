//! What a run leaves on disk: one file of this folder per table or plot, and one list, [`OUTPUTS`].
//!
//! What is made of single frames is written by functions of its own: [`springback::write`] compares the sheet before and
//! after the tools are taken away, [`residual_stress::write`] looks through its thickness.

pub mod chart;
mod csv;
mod dimensions;
mod draw;
mod file;
pub mod film;
pub mod flow_curve;
mod font;
pub mod forming_limit;
mod gif;
pub mod load_travel;
mod outline;
mod over_blank;
mod overlay;
mod png;
pub mod pressure_cycle;
pub mod profile;
pub mod residual_stress;
mod shapes;
mod sketch;
pub mod springback;
mod stages;
mod strains;
mod summary;
pub mod trace;
pub mod vtk;

pub use chart::Chart;
pub use csv::csv;
pub use dimensions::{Dimension, Mark, dimensioned};
pub use draw::svg;
pub use file::{WriteError, can_write, remove_others, write};
pub use overlay::write_comparison;
pub use png::png;
pub use sketch::sketch;
pub use stages::{Line as StageLine, STAGES, stage_folder, stages_report, stages_table, write_stages};
pub use summary::{Figure, Summary};

pub use crate::table::{JOULES, energy_unit, force_unit};

use crate::assess::{Finding, Kind, sentences};
use crate::forming_limit::{Assessment, assess};
use crate::model::{Geometry, Model};
use crate::solution::{Frame, StageSolution, Stop};
use crate::table::{Table, Unit};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A run with all that its files say about it.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// Short name of the case, as in its file name.
    pub name: &'a str,
    /// The case file's text: its SHA-256 ties results to their input.
    pub case_text: &'a str,
    /// `key=value` settings that replaced what the case file says.
    pub overrides: &'a [String],
    pub model: &'a Model,
    pub run: &'a StageSolution,
    /// What is told with the results: what was assumed while the case was read, and warnings.
    pub findings: &'a [Finding],
    /// Time that the solution took.
    pub wall: Duration,
}

/// How a file is made.
#[derive(Clone, Copy, Debug)]
pub enum Make {
    /// Nothing where a run has no such thing.
    Table(fn(&Subject) -> Option<Table>),
    Text(fn(&Subject) -> String),
    /// Nothing where there is nothing to draw.
    Plot(fn(&Subject) -> Option<Chart>),
}

/// A file that a run writes, where it has what the file holds.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    pub file: &'static str,
    /// What it holds, for help texts.
    pub about: &'static str,
    pub make: Make,
}

/// Every file that a run may write.
pub const OUTPUTS: &[Output] = &[
    Output {
        file: "summary.json",
        about: "the printed summary, versions and checksums",
        make: Make::Text(summary::json),
    },
    Output {
        file: "load_travel.csv",
        about: "forces, draw-in, energy and iterations of every step",
        make: Make::Table(load_travel::of),
    },
    Output {
        file: "profile.csv",
        about: "shape, thickness, strains and stresses of every kept frame",
        make: Make::Table(profile::of),
    },
    Output { file: "load_travel.png", about: "forces over the punch travel", make: Make::Plot(load_travel::plot) },
    Output {
        file: "pressure_cycle.csv",
        about: "pressure and strain rate over time, where a gas pressure holds a rate",
        make: Make::Table(pressure_cycle::of),
    },
    Output {
        file: "pressure_cycle.png",
        about: "the same, and the height of the dome",
        make: Make::Plot(pressure_cycle::plot),
    },
    Output {
        file: "thickness.png",
        about: "thickness over the blank at every kept frame",
        make: Make::Plot(over_blank::thickness),
    },
    Output {
        file: "porosity.png",
        about: "porosity over the blank, of a sheet with voids",
        make: Make::Plot(over_blank::porosity),
    },
    Output {
        file: "temperature.png",
        about: "temperature over the blank, where it is given",
        make: Make::Plot(over_blank::temperature),
    },
    Output { file: "strains.png", about: "strains over the blank at the last frame", make: Make::Plot(strains::plot) },
    Output {
        file: "forming_limit.csv",
        about: "the forming limit curve, where one is given",
        make: Make::Table(forming_limit::curve_of),
    },
    Output {
        file: "strain_paths.csv",
        about: "strain path and margin of every element, where a forming limit is given",
        make: Make::Table(forming_limit::paths_of),
    },
    Output {
        file: "forming_limit.png",
        about: "the curve with every element's strain path",
        make: Make::Plot(forming_limit::plot),
    },
    Output {
        file: "shapes.png",
        about: "the sheet's section at every kept frame, and the tools",
        make: Make::Plot(shapes::plot),
    },
];

impl Output {
    /// The file's content; none for a plot or a table of nothing.
    pub fn bytes(&self, subject: &Subject) -> Option<Vec<u8>> {
        match self.make {
            Make::Table(make) => make(subject).map(|table| csv(&table)),
            Make::Text(make) => Some(make(subject).into_bytes()),
            Make::Plot(make) => make(subject).map(|chart| png(&chart)),
        }
    }
}

/// Writes every file of [`OUTPUTS`] into `dir`, which is created where it is missing.
///
/// Each file appears complete or not at all. Returns what was written.
///
/// # Errors
/// When the directory or a file cannot be written.
pub fn write_all(subject: &Subject, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let mut written = Vec::new();
    for output in OUTPUTS {
        if let Some(bytes) = output.bytes(subject) {
            let path = dir.join(output.file);
            write(&path, &bytes)?;
            written.push(path);
        }
    }
    Ok(written)
}

/// Writes files of these names into `dir`; each appears complete or not at all.
fn write_into<const N: usize>(
    dir: &Path,
    names: [impl AsRef<Path>; N],
    contents: [Vec<u8>; N],
) -> Result<Vec<PathBuf>, WriteError> {
    let paths = names.map(|name| dir.join(name));
    for (path, bytes) in paths.iter().zip(&contents) {
        write(path, bytes)?;
    }
    Ok(paths.to_vec())
}

/// Whether the files of a run could be written into `dir`; nothing is left behind.
///
/// # Errors
/// As [`can_write`].
pub fn can_write_all(dir: &Path) -> Result<(), WriteError> {
    let asked_for = vtk::COLLECTIONS.iter().chain([&film::FILE]);
    OUTPUTS.iter().map(|output| &output.file).chain(asked_for).try_for_each(|file| can_write(&dir.join(file)))
}

/// Removes what an earlier run wrote into `dir` and this one did not, so that no plot of another run stands beside
/// `written`; files of names that this program does not give are left alone.
///
/// # Errors
/// When a file cannot be removed.
pub fn remove_stale(dir: &Path, written: &[PathBuf]) -> Result<(), WriteError> {
    let of_frames = [springback::FILES, residual_stress::FILES].concat();
    remove_others(dir, written, |name| {
        OUTPUTS.iter().any(|output| output.file == name)
            || of_frames.contains(&name)
            || name == STAGES
            || name == film::FILE
            || vtk::is_ours(name)
            || overlay::is_comparison(name)
    })
}

impl Subject<'_> {
    /// The run held against its forming limit, where it has one and took a step.
    pub fn forming_limit(&self) -> Option<Assessment> {
        self.run.steps.last()?;
        assess(self.model.forming_limit.as_ref()?, &self.run.paths)
    }

    /// As [`Self::notes`], after a word on frames that a plot leaves out.
    fn notes_of_frames(&self) -> Vec<String> {
        let kept = self.run.frames.len();
        let some = (kept > chart::COLORS)
            .then(|| format!("{} of {kept} kept frames are shown; profile.csv has them all.", chart::COLORS));
        some.into_iter().chain(self.notes()).collect()
    }

    /// Small print of every plot: why an incomplete run ended, what was set and warned of, what was assumed.
    fn notes(&self) -> Vec<String> {
        let ended = (!self.run.stop.is_complete()).then(|| format!("Stopped early: {}.", self.run.stop));
        let set =
            (!self.overrides.is_empty()).then(|| format!("Set on the command line: {}.", self.overrides.join(", ")));
        let warnings = sentences(self.findings, Kind::Warning).into_iter().map(|w| format!("Warning: {w}."));
        ended.into_iter().chain(set).chain(warnings).chain(self.model.notes.iter().cloned()).collect()
    }
}

/// How a run ended, in a few words: one that has no travel to reach ends at its full time.
fn ended(model: &Model, stop: &Stop) -> &'static str {
    match stop {
        Stop::FullTravel if model.travel == 0.0 => "full time",
        stop => stop.kind(),
    }
}

/// The frames that plots show: all of them, or as many as there are colours, spread evenly up to the last.
fn shown(frames: &[Frame]) -> impl Iterator<Item = &Frame> {
    let most = frames.len().min(chart::COLORS);
    (1..=most).map(move |i| &frames[i * frames.len() / most - 1])
}

/// What takes less than this share of an axis of the least height looks level \[–\].
const LEVEL: f64 = 0.1;

/// Whether a plot with an axis of the least height `least` would show the flat blank's value only: while the tools are
/// taken away nothing happens to a sheet that forming has left as it was, and the plots of that have shown it.
fn is_level(model: &Model, flat: f64, values: impl Iterator<Item = f64>, least: f64) -> bool {
    let (low, high) = values.fold((flat, flat), |(low, high), v| (low.min(v), high.max(v)));
    model.release.is_some() && high - low < LEVEL * least
}

/// What frames are named by.
fn progress(model: &Model) -> &'static str {
    match model.rate_control() {
        _ if model.travel > 0.0 => "Punch travel",
        _ if model.release.is_some() => "Tools' forces gone",
        Some(_) => "Time",
        None => "Dome height",
    }
}

/// How plots name a frame.
fn reached(model: &Model, frame: &Frame) -> String {
    let (value, unit) = reaches(model, frame);
    format!("{} {}", shortened(value), unit.symbol())
}

/// What a frame is named by: its travel; while the tools are taken away by the share of their forces that is gone; without
/// a punch the time where a strain rate is held, or else the height of the dome.
fn reaches(model: &Model, frame: &Frame) -> (f64, Unit) {
    match model.rate_control() {
        _ if model.travel > 0.0 => (frame.travel, Unit::Mm),
        _ if model.release.is_some() => (100.0 * frame.time / model.duration, Unit::Percent),
        Some(_) => (frame.time, Unit::Second),
        None => (frame.nodes.first().map_or(0.0, |pole| pole.z.abs()), Unit::Mm),
    }
}

/// A number with as many decimals as it needs, at most two, more below 1.
fn shortened(value: f64) -> String {
    let decimals = (2.0 - value.log10().floor().clamp(-12.0, 0.0)) as usize;
    let text = format!("{value:.decimals$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The word for a geometry: a body of revolution has an axis and hoops, a plane section a symmetry plane and a width.
fn worded(geometry: Geometry, axisymmetric: &'static str, plane_strain: &'static str) -> &'static str {
    match geometry {
        Geometry::Axisymmetric => axisymmetric,
        Geometry::PlaneStrain => plane_strain,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_named_by_as_many_digits_as_tell_them_apart() {
        for (value, text) in
            [(25.0, "25"), (16.75, "16.75"), (6.333_333, "6.33"), (0.000_25, "0.00025"), (600.0, "600")]
        {
            assert_eq!(shortened(value), text);
        }
    }
}
