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
mod laws;
pub mod library;
mod overrides;
mod schema;
mod source;

pub use error::CaseError;
pub use file::CaseFile;
pub use laws::{Law, law_list, laws};
pub use schema::schema;

use crate::compare::Spec;
use crate::model::{Model, Stage};
use crate::solution::StageSolution;
use source::Source;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The largest case file \[bytes\]; a thousand times the size of a long one.
const LARGEST: usize = 2_000_000;

/// A case: the problem to solve, what to compare it with, and the text it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Stem of the file's name.
    pub name: String,
    pub path: PathBuf,
    /// The text that was read, overrides applied: enough to repeat the run.
    pub text: String,
    /// What is solved, one operation after another on the same sheet; never empty.
    pub stages: Vec<Stage>,
    pub compare: Vec<Spec>,
    pub press: Press,
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

    /// Whether every stage was run and came to its end.
    pub fn is_completed_by(&self, passes: &[StageSolution]) -> bool {
        passes.len() == self.stages.len() && passes.iter().all(|pass| pass.stop.is_complete())
    }
}

/// Reads a case file and applies overrides such as `tools.punch.friction=0.1` or `blank.thickness=0.9 mm`.
///
/// # Errors
/// When the file cannot be read, or as [`parse`].
pub fn load(path: impl AsRef<Path>, overrides: &[String]) -> Result<Case, CaseError> {
    let path = path.as_ref();
    let unreadable = |error| CaseError::unreadable(path, &error);
    let mut text = String::new();
    // No more than is needed to see that it is too much: a path may lead to a device that never ends.
    File::open(path).map_err(unreadable)?.take(LARGEST as u64 + 1).read_to_string(&mut text).map_err(unreadable)?;
    parse(&text, &path.to_string_lossy(), overrides)
}

/// Reads a case from text; `name` is the path that messages show and that reference curves and profiles are
/// looked up from.
///
/// An override is `KEY=VALUE`: a dotted path of keys (array entries by index, from 0) and a TOML value; what is not a
/// TOML value is taken as text. Optional tables such as `solver`, `output`, `press` and `forming_limit` are made when they are missing.
///
/// # Errors
/// When the text is not TOML, a key is unknown or missing, or a value makes no sense; the error points to its line.
pub fn parse(text: &str, name: &str, overrides: &[String]) -> Result<Case, CaseError> {
    if text.len() > LARGEST {
        let what = format!("{name} is no case file: it is larger than {} MB", LARGEST / 1_000_000);
        return Err(CaseError::bare(what, "give the path of a case file, such as cases/quickstart.toml".into()));
    }
    let text = overrides::apply(text, overrides)?;
    let shown = if overrides.is_empty() { name.to_owned() } else { format!("{name} (with overrides)") };
    let source = Source::parse(&shown, &text)?;
    let mut file = source.read()?;
    let origin = library::complete(&mut file, &source)?;
    let path = PathBuf::from(name);
    let (stages, mut derived) = build::stages(&file, &source, &path)?;
    derived.splice(0..0, origin);
    let compare = build::compare(&file, &source, &path)?;
    let press = build::press(&file, &source)?;
    let name = path.file_stem().map_or_else(|| "case".into(), |stem| stem.to_string_lossy().into_owned());
    Ok(Case { name, path, text: text.clone(), stages, compare, press, derived })
}
