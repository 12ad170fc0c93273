//! A sample that was run, read back from its table: what is said of it is said of what stands there, whoever has run it and
//! in how many parts.

use super::StudyError;
use crate::assess::Light;
use crate::solver::solution::LOST;
use crate::study::Columns;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Rows of a sample, column by column.
#[derive(Clone, Debug, Default)]
pub struct Sample {
    /// Values of what scatters, by columns.
    pub factors: Vec<Vec<f64>>,
    /// Numbers, by columns; not finite where a run has none.
    pub numbers: Vec<Vec<f64>>,
    /// Verdicts; `None` of runs that say nothing of the part.
    pub verdict: Vec<Option<Light>>,
    /// Rows of the verdict that are red in some run, or amber.
    pub keys: Vec<String>,
    /// Of each run, for each of those keys whether it is red.
    red: Vec<u64>,
    amber: Vec<u64>,
    /// Why runs say nothing, and how many; of reasons that differ by their numbers alone, the first.
    pub failures: BTreeMap<String, usize>,
    /// Load curves, as far as they come, and thicknesses.
    pub curves: [Vec<Box<[f32]>>; 2],
}

/// Keys of the verdict's rows that fit into a run's word.
const KEYS: usize = u64::BITS as usize;

/// Whether two reasons are one but for the numbers in them.
fn are_alike(a: &str, b: &str) -> bool {
    let is_of_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+');
    let words = |text| str::split(text, is_of_number).filter(|part| !matches!(*part, "" | "e"));
    words(a).eq(words(b))
}

impl Sample {
    /// From a table that has these columns, and behind them one for each curve.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn read(path: &Path, columns: &Columns) -> Result<Self, StudyError> {
        let shown = path.display().to_string();
        let file = File::open(path)
            .map_err(|error| StudyError::new(format!("cannot read {shown}: {error}"), "begin anew with --restart"))?;
        Self::of(file, &shown, columns)
    }

    /// The same of what is called so.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn of(table: impl Read, shown: &str, columns: &Columns) -> Result<Self, StudyError> {
        let unreadable =
            |error: csv::Error| StudyError::new(format!("cannot read {shown}: {error}"), "begin anew with --restart");
        let mut reader = csv::Reader::from_reader(table);
        let header = reader.headers().map_err(unreadable)?.clone();
        let place = |name: &str| header.iter().position(|column| column == name);
        let [varied, numbers] = [&columns.varied, &columns.numbers]
            .map(|names| names.iter().map(|name| place(name)).collect::<Option<Vec<usize>>>());
        let own = ["verdict", "red", "amber", "end", "reason"].map(place);
        let (Some(varied), Some(numbers), [Some(verdict), Some(red), Some(amber), Some(end), Some(reason)]) =
            (varied, numbers, own)
        else {
            let what = format!("{shown} has other columns than this study");
            return Err(StudyError::new(what, "begin anew with --restart"));
        };
        let mut sample = Self {
            factors: vec![Vec::new(); varied.len()],
            numbers: vec![Vec::new(); numbers.len()],
            ..Self::default()
        };
        let curves = columns.header().len();
        for record in reader.into_records() {
            let record = record.map_err(unreadable)?;
            let field = |i: usize| record.get(i).unwrap_or_default();
            let number = |i: usize| field(i).parse().unwrap_or(f64::NAN);
            let light = [Light::Grey, Light::Green, Light::Amber, Light::Red]
                .into_iter()
                .find(|light| light.name() == field(verdict) && !LOST.contains(&field(end)));
            varied.iter().zip(&mut sample.factors).for_each(|(i, column)| column.push(number(*i)));
            let is_kept = light.is_some();
            let kept = |i: usize| if is_kept { number(i) } else { f64::NAN };
            numbers.iter().zip(&mut sample.numbers).for_each(|(i, column)| column.push(kept(*i)));
            if !is_kept {
                let why = if field(verdict).is_empty() { field(reason) } else { field(end) };
                let known = sample.failures.keys().find(|known| are_alike(known, why));
                let why = known.map_or_else(|| why.to_owned(), String::clone);
                *sample.failures.entry(why).or_default() += 1;
            }
            let [red, amber] = [red, amber].map(|i| if is_kept { sample.word(field(i)) } else { 0 });
            sample.red.push(red);
            sample.amber.push(amber);
            sample.verdict.push(light);
            for (k, curve) in sample.curves.iter_mut().enumerate() {
                let values = field(curves + k).split(' ').filter_map(|value| value.parse().ok());
                curve.push(if is_kept { values.collect() } else { Box::default() });
            }
        }
        Ok(sample)
    }

    /// Keys as bits.
    fn word(&mut self, keys: &str) -> u64 {
        let mut word = 0;
        for key in keys.split_whitespace() {
            let place = self.keys.iter().position(|known| known == key).unwrap_or_else(|| {
                self.keys.push(key.to_owned());
                self.keys.len() - 1
            });
            if place < KEYS {
                word |= 1 << place;
            }
        }
        word
    }

    /// Rows.
    pub fn rows(&self) -> usize {
        self.verdict.len()
    }

    /// For each run whether one of these rows of the verdict has a light, red or amber; `None` where it says nothing.
    pub fn has(&self, light: Light, keys: &[&str]) -> Vec<Option<bool>> {
        let known = self.keys.iter().take(KEYS).enumerate().filter(|(_, key)| keys.contains(&key.as_str()));
        let mask = known.fold(0, |mask, (i, _)| mask | 1 << i);
        let words = if light == Light::Red { &self.red } else { &self.amber };
        words.iter().zip(&self.verdict).map(|(word, verdict)| verdict.map(|_| word & mask != 0)).collect()
    }
}
