//! Case files: TOML → [`CaseFile`] (what was written) → [`Case`] (what it means: a [`Model`] for every stage).
//!
//! This is the only place that knows TOML. Twelve lines are enough for a cup that runs:
//!
//! ```
//! let case = stampflow::case::parse(
//!     r#"title = "Cup"
//!        geometry = "axisymmetric"
//!        [blank]
//!        radius = "55 mm"
//!        thickness = "1 mm"
//!        [material.hardening]
//!        swift = { k = "520 MPa", n = 0.22, offset = 0.005 }
//!        [tools]
//!        punch = { flat = { radius = "30 mm", nose = "6 mm" }, friction = 0.08, travel = "25 mm" }
//!        die = { throat = "31.25 mm", shoulder = "6 mm", friction = 0.08 }
//!        holder = { inner_radius = "32 mm", force = "10 kN" }
//!     "#,
//!     "cup.toml",
//!     &[],
//! )?;
//! assert_eq!(case.model().blank.thickness, 1.0);
//! # Ok::<(), stampflow::case::CaseError>(())
//! ```

mod build;
mod error;
mod explain;
pub mod file;
pub mod files;
#[cfg(feature = "schema")]
mod laws;
pub mod library;
mod overrides;
#[cfg(feature = "schema")]
mod schema;
mod solution;
mod source;
mod sources;

pub use error::CaseError;
pub use file::CaseFile;
#[cfg(feature = "schema")]
pub use laws::{Law, law_list, laws};
#[cfg(feature = "schema")]
pub use schema::schema;
pub use solution::Solution;
pub use sources::Sources;

use crate::compare::Spec;
use crate::model::{Model, Stage};
use files::{Disk, FileError, Files, Folder};
use source::Source;
use std::path::{Path, PathBuf};

/// A case: the problem to solve, what to compare it with, and the text it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Stem of the file's name.
    pub name: String,
    pub path: PathBuf,
    /// The text that was read, overrides applied: enough to repeat the run.
    pub text: String,
    /// `key=value` settings that replaced what the file says.
    pub overrides: Vec<String>,
    /// What is solved, one operation after another on the same sheet; never empty.
    pub stages: Vec<Stage>,
    pub compare: Vec<Spec>,
    pub press: Press,
    pub sources: Sources,
    /// What was assumed or changed while reading: defaults that matter, profiles that were shifted.
    pub derived: Vec<String>,
}

/// What the press can give; `None` where the case does not say.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Press {
    /// Largest force \[N\], in plane strain \[N/mm\] of depth of the modelled half.
    pub force: Option<f64>,
    /// Work of one stroke \[mJ\].
    pub energy: Option<f64>,
}

impl Case {
    /// The stage that begins with the flat blank.
    pub fn first(&self) -> &Stage {
        &self.stages[0]
    }

    /// The stages after it.
    pub fn later(&self) -> &[Stage] {
        &self.stages[1..]
    }

    /// The model of the first stage.
    pub fn model(&self) -> &Model {
        &self.first().model
    }

    /// The names of all stages.
    pub fn stage_names(&self) -> impl Iterator<Item = &str> {
        self.stages.iter().map(|stage| stage.name.as_str())
    }
}

/// Reads a case file from the disk and applies overrides such as `tools.punch.friction=0.1` or `blank.thickness=0.9 mm`.
///
/// # Errors
/// When the file cannot be read, or as [`parse`].
pub fn load(path: impl AsRef<Path>, overrides: &[String]) -> Result<Case, CaseError> {
    let path = path.as_ref();
    let files: &dyn Files = &Disk;
    let text = files.text(path, files::CASE).map_err(|error| CaseError::unreadable(path, &error))?;
    parse(&text, &path.to_string_lossy(), overrides)
}

/// Reads a case from text; `name` is the path that messages show and that reference curves, profiles and temperatures are
/// looked up from, on the disk.
///
/// An override is `KEY=VALUE`: a dotted path of keys (array entries by index, from 0) and a TOML value; what is not a
/// TOML value is taken as text. Optional tables such as `solver`, `output`, `press` and `forming_limit` are made when they are missing.
///
/// # Errors
/// When the text is not TOML, a key is unknown or missing, or a value makes no sense; the error points to its line.
pub fn parse(text: &str, name: &str, overrides: &[String]) -> Result<Case, CaseError> {
    parse_with(text, name, overrides, &Disk)
}

/// Reads a case from text as [`parse`], the files beside it from elsewhere. All that a case needs is read here.
///
/// ```
/// # use stampflow::case::{self, files::Memory};
/// let mut files = Memory::default();
/// files.insert("cases/field.csv", "s0_mm,temperature_C\n20,25\n40,150\n");
/// let text = format!("{}[heat]\ninitial = \"field.csv\"\n", case::template::find("cup").unwrap().fill(&[])?);
/// let case = case::parse_with(&text, "cases/cup.toml", &[], &files)?;
/// assert_eq!(case.model().heat.as_ref().unwrap().initial.at(40.0), 423.15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`parse`].
pub fn parse_with(text: &str, name: &str, overrides: &[String], files: &dyn Files) -> Result<Case, CaseError> {
    let path = PathBuf::from(name);
    if text.len() > files::CASE {
        return Err(CaseError::unreadable(&path, &FileError::TooLarge { limit: files::CASE }));
    }
    let text = overrides::apply(text, overrides)?;
    let shown = if overrides.is_empty() { name.to_owned() } else { format!("{name} (with overrides)") };
    let source = Source::parse(&shown, &text)?;
    let mut file = source.read()?;
    sources::forget_replaced(&mut file, overrides);
    let origin = library::complete(&mut file, &source)?;
    let folder = Folder { files, path: path.parent().unwrap_or(Path::new("")) };
    let (stages, mut derived) = build::stages(&file, &source, folder)?;
    derived.splice(0..0, origin);
    let compare = build::compare(&file, &source, folder)?;
    let press = build::press(&file, &source)?;
    let sources = sources::of(&file, &source)?;
    let name = path.file_stem().map_or_else(|| "case".into(), |stem| stem.to_string_lossy().into_owned());
    let overrides = overrides.to_vec();
    Ok(Case { name, text: text.clone(), overrides, stages, compare, press, sources, derived, path })
}
