//! What a study runs: the case, what is varied in it, and the designs by their index.

use super::StudyError;
use super::hash::short_hash;
use super::vary::{Value, Vary};
use crate::case::{self, Case};
use crate::files::{self, Disk, Files};
use std::path::PathBuf;

/// A study of a case: every combination of what is varied.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Text of the case file, as it was read once.
    text: String,
    /// The case file, from which those beside it are looked up.
    path: PathBuf,
    /// Overrides of all designs alike.
    base: Vec<String>,
    /// What is varied: the keys of one axis go together, axes are combined with each other. The last one varies fastest.
    axes: Vec<Vec<Vary>>,
    key: String,
}

/// One design of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Its place in the study, from 0.
    pub index: u64,
    /// Its values, in the order of [`Plan::varied`].
    pub values: Vec<Value>,
    /// The overrides that make it out of the case.
    pub settings: Vec<String>,
}

impl Plan {
    /// Of a case file on the disk with overrides of all designs.
    ///
    /// # Errors
    /// When the case cannot be read as it stands, a key is varied twice, or the designs cannot be counted.
    pub fn new(path: impl Into<PathBuf>, base: Vec<String>, axes: Vec<Vec<Vary>>) -> Result<Self, StudyError> {
        let path = path.into();
        let disk: &dyn Files = &Disk;
        let text = disk.text(&path, files::CASE).map_err(|error| {
            let help = "give the path of a case file";
            StudyError::new(format!("cannot read {}: {error}", path.display()), help)
        })?;
        let key = short_hash([&text, &format!("{base:?} {axes:?}")]);
        let plan = Self { text, path, base, axes, key };
        plan.case(&[])?;
        let keys: Vec<&str> = plan.varied().map(|vary| vary.key.as_str()).collect();
        if let Some((i, key)) = keys.iter().enumerate().find(|(i, key)| keys[..*i].contains(key)) {
            let help = "give all its values at once";
            return Err(StudyError::new(format!("{key} is varied twice, as number {} and before", i + 1), help));
        }
        plan.axes.iter().try_fold(1u64, |count, axis| count.checked_mul(axis[0].values.len() as u64)).ok_or_else(
            || StudyError::new("more designs than can be counted", "fewer values, or `scatter` for a sample of them"),
        )?;
        plan.each_key_can_be_set()?;
        Ok(plan)
    }

    /// A key none of whose values makes a case is a mistake of the study, not of a design.
    fn each_key_can_be_set(&self) -> Result<(), StudyError> {
        for axis in &self.axes {
            let settings = |i: usize| axis.iter().map(|vary| vary.setting(&vary.values[i])).collect::<Vec<_>>();
            let mut wrong = None;
            // The ends and the middle: a range that is unsound at all three is unsound.
            let last = axis[0].values.len() - 1;
            let is_sound = [0, last / 2, last].into_iter().any(|i| match self.case(&settings(i)) {
                Ok(_) => true,
                Err(error) => {
                    wrong.get_or_insert(error);
                    false
                }
            });
            if let Some(error) = wrong.filter(|_| !is_sound) {
                return Err(error.into());
            }
        }
        Ok(())
    }

    /// The case with some overrides besides those of all designs.
    ///
    /// # Errors
    /// When that makes no case.
    pub fn case(&self, settings: &[String]) -> Result<Case, case::CaseError> {
        let all: Vec<String> = self.base.iter().chain(settings).cloned().collect();
        case::parse(&self.text, &self.path.to_string_lossy(), &all)
    }

    /// What is varied, in the order of the columns.
    pub fn varied(&self) -> impl Iterator<Item = &Vary> {
        self.axes.iter().flatten()
    }

    /// What is varied: the keys of one axis go together.
    pub fn axes(&self) -> &[Vec<Vary>] {
        &self.axes
    }

    /// What tells this study from others: of the case, its overrides and all that is varied.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// How many designs there are.
    pub fn count(&self) -> u64 {
        self.axes.iter().map(|axis| axis[0].values.len() as u64).product()
    }

    /// The design of an index below [`count`](Self::count).
    pub fn design(&self, index: u64) -> Design {
        let mut rest = index;
        let mut chosen = vec![0; self.axes.len()];
        for (axis, chosen) in self.axes.iter().zip(&mut chosen).rev() {
            let count = axis[0].values.len() as u64;
            (*chosen, rest) = ((rest % count) as usize, rest / count);
        }
        let pairs = || {
            self.axes.iter().zip(&chosen).flat_map(|(axis, &i)| axis.iter().map(move |vary| (vary, &vary.values[i])))
        };
        Design {
            index,
            values: pairs().map(|(_, value)| value.clone()).collect(),
            settings: pairs().map(|(vary, value)| vary.setting(value)).collect(),
        }
    }
}
