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
pub mod comparison;
mod complaint;
mod error;
pub mod file;
pub mod files;
pub mod library;
mod overrides;
mod read;
mod schema;
mod solution;
mod source;
mod sources;
pub mod thickness_tolerance;
mod written;

pub use error::CaseError;
pub use file::{CaseFile, Springback, TitleBlock};
pub use read::{load, parse, parse_with};
pub(crate) use schema::{definition, whole};
pub use schema::{keys, schema};
pub use solution::Solution;
pub use sources::{Sheets, Sources, Thickness};

use crate::material::RValues;
use crate::model::{Model, Stage};
use std::path::PathBuf;

/// A case: the problem to solve, what to compare it with, and the text it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Stem of the file's name.
    pub name: String,
    /// The file as it was named.
    pub path: PathBuf,
    /// Paths of that file and of those that it names: nothing may be written over them.
    pub inputs: Vec<PathBuf>,
    /// The text that was read, overrides applied: enough to repeat the run.
    pub text: String,
    /// `key=value` settings that replaced what the file says.
    pub overrides: Vec<String>,
    /// Operations on the same sheet, one after another; never empty.
    pub stages: Vec<Stage>,
    /// References of the first stage.
    pub compare: Vec<comparison::Spec>,
    /// The rating of the press.
    pub press: Press,
    /// Title block of its reports.
    pub title_block: TitleBlock,
    /// The part's tolerances.
    pub springback: Springback,
    /// Sources of its numbers.
    pub sources: Sources,
    /// The sheet's r-values by direction; `None` where the case has their mean alone, or nothing.
    pub r_values: Option<RValues>,
    /// Notes on assumptions and changes while reading: defaults that matter, profiles that were shifted.
    pub derived: Vec<String>,
}

/// Rating of the press; `None` if the case has none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Press {
    /// Largest force, of the whole section as [`Extent`](crate::model::Extent) has it \[N, or N/mm of depth\].
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
