//! What a run leaves on disk: one file of this folder per table or plot, and one list, [`OUTPUTS`].

mod csv;
mod file;
pub mod load_travel;
pub mod profile;
mod summary;
pub mod trace;

pub use csv::csv;
pub use file::{WriteError, write};
pub use summary::Summary;

use crate::model::{Geometry, Model};
use crate::record::Run;
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
    pub run: &'a Run,
    /// Time that the solution took.
    pub wall: Duration,
}

/// How a file is made.
#[derive(Clone, Copy, Debug)]
pub enum Make {
    Table(fn(&Subject) -> Table),
    Text(fn(&Subject) -> String),
}

/// A file that every run writes.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    pub file: &'static str,
    /// What it holds, for help texts.
    pub about: &'static str,
    pub make: Make,
}

/// Every file that a run writes.
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
];

impl Output {
    /// The file's content.
    pub fn bytes(&self, subject: &Subject) -> Vec<u8> {
        match self.make {
            Make::Table(make) => csv(&make(subject)),
            Make::Text(make) => make(subject).into_bytes(),
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
    OUTPUTS
        .iter()
        .map(|output| {
            let path = dir.join(output.file);
            write(&path, &output.bytes(subject))?;
            Ok(path)
        })
        .collect()
}

/// Unit of forces: of the whole ring, or per mm of depth.
fn force(geometry: Geometry) -> Unit {
    match geometry {
        Geometry::Axisymmetric => Unit::N,
        Geometry::PlaneStrain => Unit::NPerMm,
    }
}

/// Unit of work: of the whole ring, or per mm of depth.
fn work(geometry: Geometry) -> Unit {
    match geometry {
        Geometry::Axisymmetric => Unit::Millijoule,
        Geometry::PlaneStrain => Unit::MillijoulePerMm,
    }
}
