//! What a study runs: the case, what is varied in it, and the designs by their index.

use super::hash::short_hash;
use super::vary::{Value, Vary};
use super::{StudyError, Subject};
use std::path::PathBuf;

/// A study of a case: every combination of what is varied.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    subject: Subject,
    /// What is varied: the keys of one axis go together, axes are combined with each other. The last one varies fastest.
    axes: Vec<Vec<Vary>>,
    key: String,
}

/// Cases that a study runs, each known by its index: any of them can be run anywhere, and again.
pub trait Designs: Sync {
    /// The case that is varied.
    fn subject(&self) -> &Subject;

    /// What tells this study from others: of the case, its overrides and all that is varied.
    fn key(&self) -> &str;

    /// What is varied, as headers of columns with their units.
    fn headers(&self) -> Vec<String>;

    /// How many designs there are.
    fn count(&self) -> u64;

    /// The design of an index below [`count`](Self::count).
    fn design(&self, index: u64) -> Design;
}

/// One design of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Its place in the study, from 0.
    pub index: u64,
    /// Its values, in the order of [`Designs::headers`].
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
        Self::of(Subject::new(path, base)?, axes)
    }

    /// Of a case that was read.
    ///
    /// # Errors
    /// When a key is varied twice, or the designs cannot be counted.
    pub fn of(subject: Subject, axes: Vec<Vec<Vary>>) -> Result<Self, StudyError> {
        let key = short_hash([subject.key(), &format!("{axes:?}")]);
        let plan = Self { subject, axes, key };
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
            let is_sound = [0, last / 2, last].into_iter().any(|i| match self.subject.case(&settings(i)) {
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

    /// What is varied, in the order of the columns.
    fn varied(&self) -> impl Iterator<Item = &Vary> {
        self.axes.iter().flatten()
    }

    /// What is varied: the keys of one axis go together.
    pub fn axes(&self) -> &[Vec<Vary>] {
        &self.axes
    }
}

impl Designs for Plan {
    fn subject(&self) -> &Subject {
        &self.subject
    }

    fn headers(&self) -> Vec<String> {
        self.varied().map(Vary::header).collect()
    }

    fn key(&self) -> &str {
        &self.key
    }

    fn count(&self) -> u64 {
        self.axes.iter().map(|axis| axis[0].values.len() as u64).product()
    }

    fn design(&self, index: u64) -> Design {
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
