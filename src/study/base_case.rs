//! The case that a study varies, read once; each design is the case with further overrides.

use super::*;
use crate::case::{self, CaseError, files, files::CSV, files::sha256};
use std::panic::{AssertUnwindSafe, catch_unwind};

const DIGITS: usize = 16;

/// The case that a study varies.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseCase {
    text: String,
    path: PathBuf,
    overrides: Vec<String>,
    pub(super) key: String,
}

impl BaseCase {
    /// Reads a case file with overrides for all designs.
    pub fn load(path: impl Into<PathBuf>, overrides: Vec<String>) -> Result<Self> {
        let path = path.into();
        Self::from_text(read_text(&path, "give the path of a case file")?, path, overrides)
    }

    /// Takes the text of a case file; files beside `path` are looked up from there.
    pub fn from_text(text: String, path: impl Into<PathBuf>, overrides: Vec<String>) -> Result<Self> {
        let base = Self { text, path: path.into(), overrides, key: String::new() };
        let inputs = Self::input_hash(&base.case(&[])?);
        Ok(Self { key: short_hash([&base.text, &format!("{:?}", base.overrides), &inputs]), ..base })
    }

    /// Puts settings before its own overrides.
    pub fn with_settings(&self, settings: &[String]) -> Result<Self> {
        Self::from_text(self.text.clone(), self.path.clone(), [settings, &self.overrides].concat())
    }

    /// Builds the case with further overrides.
    pub fn case(&self, settings: &[String]) -> Result<Case, CaseError> {
        case::parse(&self.text, &self.path.to_string_lossy(), &[&self.overrides, settings].concat())
    }

    pub(super) fn check_any(&self, designs: [Vec<String>; 3]) -> Result<()> {
        match designs.map(|settings| self.case(&settings).map(drop)) {
            [Err(error), Err(_), Err(_)] => Err(error.into()),
            _ => Ok(()),
        }
    }

    /// Refuses overrides and settings of all designs that later ones replace: one changes the case, but not with them.
    pub(super) fn check_effective(&self, settings: &[String]) -> Result<()> {
        let (given, all) = (self.overrides.len(), [&self.overrides, settings].concat());
        let bare = Self { overrides: Vec::new(), ..self.clone() };
        for (i, one) in all.iter().enumerate() {
            let changes = |end: usize| {
                let cases = [&all[..=i], &all[..i]].map(|before| bare.case(&[before, &all[i + 1..end]].concat()).ok());
                let [with, without] = cases.map(|case| case.map(|case| case.text));
                with != without || with.is_none()
            };
            let what = format!("`{one}` has no effect: the study gives all its runs other values of this key");
            ensure(!changes(given.max(i + 1)) || changes(all.len()), what, "leave it out, or do not vary the key")?;
        }
        Ok(())
    }

    /// Value of a key as the case writes it; `None` if it has none, or several tools have different ones.
    pub fn value(&self, key: &str) -> Option<String> {
        let case = self.case(&[]).ok()?;
        let values = [key.to_owned(), format!("{key}.name")].into_iter().flat_map(|key| case.written(&key));
        let mut values = values.map(|(_, value)| value);
        let first = values.next()?;
        values.all(|other| other == first).then_some(first)
    }

    /// Solves a case until `watch` asks to stop; the error is the message of a panic.
    pub fn solve(case: Case, watch: &dyn Watch) -> Result<Solution, String> {
        catch_unwind(AssertUnwindSafe(|| case.solve(&mut &*watch))).map_err(|panic| {
            let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
            format!("a mistake of this program: {}", text.unwrap_or("no message"))
        })
    }

    /// Hash of a case's text with its overrides and of the files that it reads.
    pub fn input_hash(case: &Case) -> String {
        let others = case.inputs.iter().filter(|path| **path != case.path);
        let others = others.map(|path| Disk.read(path, CSV).unwrap_or_default());
        short_hash([case.text.clone().into_bytes()].into_iter().chain(others))
    }
}

pub(super) fn read_text(path: &Path, help: &str) -> Result<String> {
    Disk.text(path, files::CASE).map_err(|error| StudyError::unreadable(path, &error, help))
}

pub(super) fn short_hash(all: impl IntoIterator<Item = impl AsRef<[u8]>>) -> String {
    sha256(all)[..DIGITS].to_owned()
}
