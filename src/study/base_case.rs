//! The case that a study varies, read once; each design is the case with further overrides.

use super::StudyError;
use crate::case::files::{self, CSV, Disk, Files, sha256};
use crate::case::{self, Case, CaseError, Solution};
use crate::verification::Watch;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use toml_edit::DocumentMut;

/// Hex digits of a hash that identify inputs.
const DIGITS: usize = 16;

/// The case that a study varies.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseCase {
    text: String,
    path: PathBuf,
    overrides: Vec<String>,
    key: String,
}

impl BaseCase {
    /// Reads a case file with overrides for all designs.
    ///
    /// # Errors
    /// When it is no case.
    pub fn load(path: impl Into<PathBuf>, overrides: Vec<String>) -> Result<Self, StudyError> {
        let path = path.into();
        let disk: &dyn Files = &Disk;
        let text = disk.text(&path, files::CASE).map_err(|error| {
            let help = error.remedy("give the path of a case file");
            StudyError::new(format!("cannot read {}: {error}", path.display()), help)
        })?;
        Self::from_text(text, path, overrides)
    }

    /// Takes the text of a case file; files beside `path` are looked up from there.
    ///
    /// # Errors
    /// When it is no case.
    pub fn from_text(text: String, path: impl Into<PathBuf>, overrides: Vec<String>) -> Result<Self, StudyError> {
        let base = Self { text, path: path.into(), overrides, key: String::new() };
        let inputs = Self::input_hash(&base.case(&[])?);
        let key = short_hash([&base.text, &format!("{:?}", base.overrides), &inputs]);
        Ok(Self { key, ..base })
    }

    /// Puts settings before its own overrides.
    ///
    /// # Errors
    /// When that makes no case.
    pub fn with_settings(&self, settings: &[String]) -> Result<Self, StudyError> {
        Self::from_text(self.text.clone(), self.path.clone(), [settings, &self.overrides].concat())
    }

    /// Text of the case file and its path.
    pub fn written(&self) -> (&str, &Path) {
        (&self.text, &self.path)
    }

    /// Hash of the case file, the files beside it and the overrides.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// Builds the case with further overrides.
    ///
    /// # Errors
    /// When that makes no case.
    pub fn case(&self, settings: &[String]) -> Result<Case, CaseError> {
        let all: Vec<String> = self.overrides.iter().chain(settings).cloned().collect();
        case::parse(&self.text, &self.path.to_string_lossy(), &all)
    }

    /// Value of a key as the case writes it; `None` if it has none, or several tools have different ones.
    pub fn value(&self, key: &str) -> Option<String> {
        let document: DocumentMut = self.case(&[]).ok()?.text.parse().ok()?;
        let at = |path: &str| {
            let item = path.split('.').try_fold(document.as_item(), |item, key| match key.parse::<usize>() {
                Ok(index) => item.get(index),
                Err(_) => item.get(key),
            })?;
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

    /// Solves a case until `watch` asks to stop.
    ///
    /// # Errors
    /// The message of a panic, which is a mistake of this program.
    pub fn solve(case: Case, watch: &dyn Watch) -> Result<Solution, String> {
        catch_unwind(AssertUnwindSafe(|| case.solve(&mut &*watch))).map_err(|panic| message(panic.as_ref()))
    }

    /// Hash of a case's text with its overrides and of the files that it reads.
    pub fn input_hash(case: &Case) -> String {
        let others = case.inputs.iter().filter(|path| **path != case.path);
        let others = others.map(|path| Disk.read(path, CSV).unwrap_or_default());
        short_hash([case.text.clone().into_bytes()].into_iter().chain(others))
    }
}

/// First digits of the SHA-256 of some bytes.
pub(super) fn short_hash(all: impl IntoIterator<Item = impl AsRef<[u8]>>) -> String {
    sha256(all)[..DIGITS].to_owned()
}

fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    format!("a mistake of this program: {}", text.unwrap_or("no message"))
}
