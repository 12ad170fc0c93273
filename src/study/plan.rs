//! What a study runs: the case, what is varied in it, and the designs by their index.

use super::bars::Bars;
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
    how: How,
    key: String,
}

/// Which designs are made of what is varied.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum How {
    /// Every combination.
    #[default]
    Combined,
    /// The case as it stands, and each axis at each of its values with all else as it stands.
    OneAtATime,
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
        let how = How::default();
        let plan = Self { key: key(&subject, &axes, how), subject, axes, how };
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

    /// The same keys and values, put together otherwise.
    #[must_use]
    pub fn made(self, how: How) -> Self {
        Self { key: key(&self.subject, &self.axes, how), how, ..self }
    }

    /// Which designs are made of what is varied.
    pub fn how(&self) -> How {
        self.how
    }

    /// Error bars, as they are asked for or not; where nothing is said those over one key alone.
    pub fn bars(&self, asked: Option<bool>) -> Bars {
        let are_usual = self.axes.len() == 1 && self.how == How::Combined;
        if asked.unwrap_or(are_usual) { Bars::Quick } else { Bars::Without }
    }

    /// Of every axis the place of a design's value among its values; `None` where the case is as it stands.
    pub fn place(&self, index: u64) -> Vec<Option<usize>> {
        let counts = self.axes.iter().map(|axis| axis[0].values.len() as u64);
        let mut rest = index;
        match self.how {
            How::Combined => {
                let places = counts.rev().map(|count| {
                    let place = rest % count;
                    rest /= count;
                    Some(place as usize)
                });
                let mut places: Vec<_> = places.collect();
                places.reverse();
                places
            }
            How::OneAtATime => {
                // The first is the case as it stands.
                let mut before = 1;
                let places = counts.map(|count| {
                    let own = index.checked_sub(before).filter(|place| *place < count);
                    before += count;
                    own.map(|place| place as usize)
                });
                places.collect()
            }
        }
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
        let counts = self.axes.iter().map(|axis| axis[0].values.len() as u64);
        match self.how {
            How::Combined => counts.product(),
            How::OneAtATime => 1 + counts.sum::<u64>(),
        }
    }

    fn design(&self, index: u64) -> Design {
        let places = self.place(index);
        let pairs = || {
            self.axes
                .iter()
                .zip(&places)
                .flat_map(|(axis, place)| axis.iter().map(move |vary| (vary, place.map(|i| &vary.values[i]))))
        };
        Design {
            index,
            values: pairs().map(|(_, value)| value.cloned().unwrap_or_else(Value::as_it_stands)).collect(),
            settings: pairs().filter_map(|(vary, value)| Some(vary.setting(value?))).collect(),
        }
    }
}

fn key(subject: &Subject, axes: &[Vec<Vary>], how: How) -> String {
    let kind = match how {
        How::Combined => "",
        How::OneAtATime => "one at a time",
    };
    short_hash([subject.key(), &format!("{axes:?}"), kind])
}
