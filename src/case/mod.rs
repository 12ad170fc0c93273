//! Case files: TOML → `CaseFile` (what was written) → [`Case`] (what it means: a [`Model`] for every stage).

pub mod comparison;
mod error;
pub(crate) mod file;
pub mod library;
pub(crate) mod overrides;
mod schema;
mod source;
mod sources;

pub use crate::files;
pub use error::CaseError;
pub use file::{Finished, Press, Springback, TitleBlock};
pub use schema::schema;
pub use sources::{Sheets, Sources, Thickness};

use crate::material::RValues;
use crate::model::{Model, Stage};
use crate::solver::{Observer, solution::StageSolution, solve};
use file::CaseFile;
use files::{Disk, Files, Folder, too_large};
use source::Source;
use std::time::Duration;
use std::{collections::BTreeMap, io, path::Path, path::PathBuf};

type Result<T, E = CaseError> = std::result::Result<T, E>;

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
    /// Sizes of the trimmed part.
    pub finished: Finished,
    /// Sources of its numbers.
    pub sources: Sources,
    /// The sheet's r-values by direction; `None` where the case has their mean alone, or nothing.
    pub r_values: Option<RValues>,
    /// Notes on assumptions and changes while reading: defaults that matter, profiles that were shifted.
    pub derived: Vec<String>,
}

/// A solved case.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Solved case.
    pub case: Case,
    /// The stages that were run, in order: up to the first that did not come to its end.
    pub stages: Vec<StageSolution>,
    /// Time that the solution took, by the clock of whoever has one.
    pub wall: Option<Duration>,
}

impl Solution {
    /// True if every stage was run and came to its end.
    pub fn is_complete(&self) -> bool {
        self.stages.len() == self.case.stages.len() && self.stages.iter().all(|stage| stage.stop.is_complete())
    }
}

impl Case {
    /// Reads a case file as it stands. Fails as [`load`].
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        load(path, &[])
    }

    /// Runs the stages after one another, each on the sheet that the one before left.
    pub fn solve(self, observer: &mut dyn Observer) -> Solution {
        Solution { stages: solve(&self.stages, observer), case: self, wall: None }
    }

    /// The stages after it.
    pub fn later(&self) -> &[Stage] {
        &self.stages[1..]
    }

    /// The model of the first stage.
    pub fn model(&self) -> &Model {
        &self.stages[0].model
    }

    /// Label of stage `i`, counted from 0, in folders and headings: `1-draw`; `None` in a case of one stage.
    pub fn stage_label(&self, i: usize) -> Option<String> {
        Some(format!("{}-{}", i + 1, self.stages.get(i).filter(|_| self.stages.len() > 1)?.name))
    }
}

/// Reads a case file with overrides such as `tools.punch.friction=0.1`. Fails when it cannot be read, or as [`parse`].
pub fn load(path: impl AsRef<Path>, overrides: &[String]) -> Result<Case> {
    let path = path.as_ref();
    let text = Disk.text(path, files::CASE).map_err(|error| CaseError::unreadable(path, &error))?;
    parse(&text, &path.to_string_lossy(), overrides)
}

/// Reads a case from text; `name` is the path that messages show and beside which files are looked up on the disk.
///
/// An override is `KEY=VALUE`: a dotted path of keys (array entries by index, from 0) and a TOML value; what is not a
/// TOML value is taken as text. Optional tables such as `solver`, `output`, `press` and `forming_limit` are made when they are missing.
/// Fails when the text is not TOML, a key is unknown or missing, or a value makes no sense; the error points to its line.
pub fn parse(text: &str, name: &str, overrides: &[String]) -> Result<Case> {
    parse_with(text, name, overrides, &Disk)
}

/// Reads all of a case from text as [`parse`], the files beside it from elsewhere. Fails as [`parse`].
pub fn parse_with(text: &str, name: &str, overrides: &[String], files: &dyn Files) -> Result<Case> {
    let path = PathBuf::from(name);
    if text.len() > files::CASE {
        return Err(CaseError::unreadable(&path, &too_large(files::CASE)));
    }
    if !source::is_own(text) {
        let has = "it has fewer than two of title, geometry, blank, material and tools";
        let help = "give the path of a case file; begin with a copy of cases/quickstart.toml".to_owned();
        return Err(CaseError::bare(format!("{name} is no case file: {has}"), help));
    }
    let text = overrides::apply(text, overrides)?;
    let shown = if overrides.is_empty() { name.to_owned() } else { format!("{name} (with overrides)") };
    let source = Source::parse(&shown, &text, Folder { files, path: path.parent().unwrap_or(Path::new("")) })?;
    let mut file = source.case()?;
    sources::forget_replaced(&mut file, overrides);
    sources::limit_of_another_sheet(&file, overrides).into_iter().for_each(|note| source.note(note));
    let taken = library::complete(&mut file, &source)?;
    let stages = file.stages(&source)?;
    let r_values = file.material.r_values(&source);
    let limited = stages[0].model.forming_limit.is_some();
    let spec = |(i, one): (usize, &comparison::Compare)| one.spec(&format!("compare.{i}"), limited, &source);
    Ok(Case {
        name: path.file_stem().map_or_else(|| "case".into(), |stem| stem.to_string_lossy().into_owned()),
        compare: file.compare.iter().enumerate().map(spec).collect::<Result<_>>()?,
        press: file.press_rating(&source)?,
        springback: file.springback_tolerances(&source)?,
        sources: sources::sources(&file, taken, &source)?,
        text: text.clone(),
        overrides: overrides.to_vec(),
        stages,
        title_block: file.report,
        finished: file.finished,
        r_values,
        derived: source.notes.take(),
        inputs: [path.clone()].into_iter().chain(source.read.take()).collect(),
        path,
    })
}
