//! What is run: the designs of a sample, each by its index.

use super::StudyError;
use super::copula::{Copula, Correlation, groups};
use super::declared::Declared;
use super::factor::Factor;
use super::sampling::{COORDINATES, MOST, REPLICATES, Sampling};
use crate::study::hash::short_hash;
use crate::study::{Design, Designs, Subject, Value};

/// Points where nothing else is asked for: 64 of each scrambling, for a sequence is the more even at a power of two.
pub const POINTS: u64 = 64 * REPLICATES as u64;

/// The seed where none is given.
pub const SEED: u32 = 1;

/// Coordinates at which each key is tried before a study begins: its middle, and one in a thousand to either side.
const TRIED: [f64; 3] = [0.5, 0.001, 0.999];

/// What is asked of a scatter.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// Keys and how they scatter; what is declared where there is none.
    pub vary: Vec<(String, String)>,
    /// Which of them go together.
    pub correlations: Vec<Correlation>,
    /// Points of the sample.
    pub points: u64,
    /// Of the scramblings.
    pub seed: u32,
    /// Whether Sobol indices are wanted.
    pub indices: bool,
}

impl Default for Asked {
    fn default() -> Self {
        Self { vary: Vec::new(), correlations: Vec::new(), points: POINTS, seed: SEED, indices: false }
    }
}

/// A sample of what a case may meet.
#[derive(Clone, Debug)]
pub struct Scatter {
    subject: Subject,
    factors: Vec<Factor>,
    copula: Copula,
    sampling: Sampling,
    /// What was declared, for want of what scatters.
    pub told: Vec<String>,
    key: String,
}

impl Scatter {
    /// Of a case, and what is asked.
    ///
    /// # Errors
    /// When a distribution or a correlation makes no sense, two set the same, a key makes no case, or there are too many
    /// points or too few.
    pub fn new(subject: Subject, asked: Asked) -> Result<Self, StudyError> {
        let case = subject.case(&[])?;
        let Declared { vary, told } = match asked.vary.is_empty() {
            true => Declared::of(&case),
            false => Declared { vary: asked.vary.clone(), told: Vec::new() },
        };
        let factors =
            vary.iter().map(|(key, scatter)| Factor::new(&case, key, scatter)).collect::<Result<Vec<_>, _>>()?;
        sound(&factors, &asked)?;
        let keys: Vec<&str> = factors.iter().map(|factor| factor.key.as_str()).collect();
        let copula = Copula::new(&keys, &asked.correlations)?;
        let sampling = Sampling::new(asked.seed, asked.points, groups(&keys, &asked.correlations)?, asked.indices);
        let key = short_hash([subject.key(), &format!("{factors:?}{copula:?}{sampling:?}")]);
        let scatter = Self { subject, factors, copula, sampling, told, key };
        scatter.each_key_can_be_set()?;
        Ok(scatter)
    }

    /// A key none of whose values makes a case is a mistake of the study, not of a design.
    fn each_key_can_be_set(&self) -> Result<(), StudyError> {
        for factor in &self.factors {
            let tried = TRIED.map(|u| self.subject.case(&factor.settings(&factor.value(u))).map(drop));
            if let [Err(error), Err(_), Err(_)] = tried {
                return Err(error.into());
            }
        }
        Ok(())
    }

    /// What scatters, in the order of the columns.
    pub fn factors(&self) -> &[Factor] {
        &self.factors
    }

    /// Where the sample is taken.
    pub fn sampling(&self) -> &Sampling {
        &self.sampling
    }

    /// The names of what scatters by groups: keys that are correlated are one.
    pub fn groups(&self) -> Vec<String> {
        let mut names = vec![Vec::new(); self.sampling.groups()];
        for (factor, group) in self.factors.iter().zip(self.sampling.group_of()) {
            names[*group].push(factor.key.as_str());
        }
        names.iter().map(|keys| keys.join(" & ")).collect()
    }
}

/// What is wrong before anything is tried.
fn sound(factors: &[Factor], asked: &Asked) -> Result<(), StudyError> {
    let fail = |what: String, help: &str| Err(StudyError::new(what, help));
    if factors.is_empty() {
        return fail("nothing scatters: the case gives no friction".into(), "give --vary \"KEY=DISTRIBUTION\"");
    }
    if factors.len() > COORDINATES {
        return fail(format!("{} keys scatter", factors.len()), "128 at most");
    }
    for (i, factor) in factors.iter().enumerate() {
        if let Some(other) =
            factors[..i].iter().find(|other| factor.is_at_odds_with(other) || other.is_at_odds_with(factor))
        {
            return fail(format!("{} and {} set the same", other.key, factor.key), "vary one of them");
        }
    }
    // Each scrambling says how far it is from the others only with points of its own.
    let least = 2 * REPLICATES as u64;
    match asked.points {
        points if points < least => {
            fail(format!("{points} runs say nothing of a scatter"), &format!("{least} or more"))
        }
        points if points > MOST => {
            fail(format!("{points} runs are more than the sequence has"), &format!("{MOST} at most"))
        }
        _ => Ok(()),
    }
}

impl Designs for Scatter {
    fn subject(&self) -> &Subject {
        &self.subject
    }

    fn key(&self) -> &str {
        &self.key
    }

    fn headers(&self) -> Vec<String> {
        self.factors.iter().map(Factor::header).collect()
    }

    fn count(&self) -> u64 {
        self.sampling.rows()
    }

    fn design(&self, index: u64) -> Design {
        let unit = self.copula.correlated(&self.sampling.unit(index));
        let values: Vec<Value> = self.factors.iter().zip(&unit).map(|(factor, u)| factor.value(*u)).collect();
        let settings = self.factors.iter().zip(&values).flat_map(|(factor, value)| factor.settings(value)).collect();
        Design { index, values, settings }
    }
}
