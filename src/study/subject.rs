//! The case that a study is of, read once; every design is made of it by overrides, as on the command line.

use super::StudyError;
use super::hash::short_hash;
use crate::case::files::{self, CSV, Disk, Files};
use crate::case::{self, Case, CaseError, Solution};
use crate::study::verify::{Watch, Watched};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use toml_edit::DocumentMut;

/// The case that a study is of.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// Text of the case file, as it was read once.
    text: String,
    /// The case file, from which those beside it are looked up.
    path: PathBuf,
    /// Overrides of all designs alike.
    base: Vec<String>,
    key: String,
}

impl Subject {
    /// Of a case file on the disk with overrides of all designs.
    ///
    /// # Errors
    /// When the case cannot be read as it stands.
    pub fn new(path: impl Into<PathBuf>, base: Vec<String>) -> Result<Self, StudyError> {
        let path = path.into();
        let disk: &dyn Files = &Disk;
        let text = disk.text(&path, files::CASE).map_err(|error| {
            let help = error.remedy("give the path of a case file");
            StudyError::new(format!("cannot read {}: {error}", path.display()), help)
        })?;
        Self::of_text(text, path, base)
    }

    /// Of the text of a case file, which stands or would stand at a path: from there the files beside it are looked up.
    ///
    /// # Errors
    /// When that is no case.
    pub fn of_text(text: String, path: impl Into<PathBuf>, base: Vec<String>) -> Result<Self, StudyError> {
        let subject = Self { text, path: path.into(), base, key: String::new() };
        // What a case reads from beside it is of the study too.
        let own = Self::hash(&subject.case(&[])?);
        let key = short_hash([&subject.text, &format!("{:?}", subject.base), &own]);
        Ok(Self { key, ..subject })
    }

    /// The same with overrides of all designs before its own, which go on to count.
    ///
    /// # Errors
    /// When that is no case.
    pub fn after(&self, settings: &[String]) -> Result<Self, StudyError> {
        Self::of_text(self.text.clone(), self.path.clone(), [settings, &self.base].concat())
    }

    /// Text of the case file, and where that stands or would stand.
    pub fn written(&self) -> (&str, &Path) {
        (&self.text, &self.path)
    }

    /// What tells it from others: of the case file, the files beside it and the overrides of all designs.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The case with some overrides besides those of all designs.
    ///
    /// # Errors
    /// When that makes no case.
    pub fn case(&self, settings: &[String]) -> Result<Case, CaseError> {
        let all: Vec<String> = self.base.iter().chain(settings).cloned().collect();
        case::parse(&self.text, &self.path.to_string_lossy(), &all)
    }

    /// What the case as it stands has for a key, as it is written there; `None` where it says nothing, or where a key of
    /// several tools has several values.
    pub fn own(&self, key: &str) -> Option<String> {
        let text = self.case(&[]).ok()?.text;
        let document: DocumentMut = text.parse().ok()?;
        let at = |path: &str| -> Option<String> {
            let item = path.split('.').try_fold(document.as_item(), |item, key| item.get(key))?;
            let value = item.as_value().or_else(|| item.get("name")?.as_value())?;
            Some(value.as_str().map_or_else(|| value.clone().decorated("", "").to_string(), str::to_owned))
        };
        let key = if key == "friction" { "tools.*.friction" } else { key };
        let Some((above, below)) = key.split_once(".*.") else { return at(key) };
        let tools = above.split('.').try_fold(document.as_item(), |item, key| item.get(key))?.as_table_like()?;
        let mut values = tools.iter().filter_map(|(tool, _)| at(&format!("{above}.{tool}.{below}")));
        let first = values.next()?;
        values.all(|other| other == first).then_some(first)
    }

    /// Solves a case until `watch` wants to stop.
    ///
    /// # Errors
    /// A mistake of this program, which ends no study: in the words of its panic.
    pub fn solution(case: Case, watch: &dyn Watch) -> Result<Solution, String> {
        catch_unwind(AssertUnwindSafe(|| case.solve(&mut Watched(watch)))).map_err(|panic| words(panic.as_ref()))
    }

    /// Of all that a case was read from: SHA-256 of its text with its settings and of the files beside it, the first 16 digits.
    pub fn hash(case: &Case) -> String {
        let beside = case.inputs.iter().filter(|path| **path != case.path);
        let beside = beside.map(|path| Disk.read(path, CSV).unwrap_or_default());
        short_hash([case.text.clone().into_bytes()].into_iter().chain(beside))
    }
}

fn words(panic: &(dyn Any + Send)) -> String {
    let said = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    format!("a mistake of this program: {}", said.unwrap_or("no words"))
}
