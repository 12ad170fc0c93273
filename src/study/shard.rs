//! Shards: shares of a study that run by themselves, and the merge of their tables.
//!
//! Shard k of n has the designs k − 1, k − 1 + n, k − 1 + 2n, …: neighbours, which cost alike, go to different shards.

use super::run_table::BEGINNING;
use super::{StudyError, fail};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A share of a study, `7/64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 1.
    number: u64,
    count: u64,
}

impl Shard {
    /// The whole study.
    pub const WHOLE: Self = Self { number: 1, count: 1 };

    /// Number of its designs.
    pub fn len(self, designs: u64) -> u64 {
        (designs + self.count - self.number) / self.count
    }

    /// Whether a design is its own.
    pub fn holds(self, index: u64) -> bool {
        index % self.count == self.number - 1
    }

    /// File of its table: `study-07-of-64.csv`, `study.csv` for the whole.
    pub fn file(self, stem: &str) -> String {
        let Self { number, count } = self;
        let width = count.to_string().len();
        if self == Self::WHOLE { format!("{stem}.csv") } else { format!("{stem}-{number:0width$}-of-{count}.csv") }
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(a, b)| Some((a.trim().parse().ok()?, b.trim().parse().ok()?)));
        match numbers {
            Some((number, count)) if (1..=count).contains(&number) => Ok(Self { number, count }),
            _ => Err("a shard is its number, from 1, and how many there are, as in 7/64".into()),
        }
    }
}

/// Merges the tables of all shards of a study, in the order of the designs; returns the text and the number of rows.
pub fn merge(shards: &[PathBuf]) -> Result<(String, u64), StudyError> {
    let wrong = |what: String| StudyError::new(what, "give every shard of one study once");
    let mut header: Option<String> = None;
    let mut study: Option<(String, u64)> = None;
    let mut rows: BTreeMap<u64, (String, &Path)> = BTreeMap::new();
    for path in shards {
        let (shown, before) = (path.display(), shards[0].display());
        let text = fs::read_to_string(path).map_err(|error| wrong(format!("cannot read {shown}: {error}")))?;
        let (first, lines) = text.split_once('\n').unwrap_or((&text, ""));
        if !first.starts_with(BEGINNING) {
            return Err(wrong(format!("{shown} is no table of a study")));
        }
        if header.get_or_insert_with(|| first.to_owned()) != first {
            return Err(wrong(format!("{shown} has other columns than {before}")));
        }
        for line in lines.split_inclusive('\n') {
            let mut fields = line.splitn(4, ',');
            let key = fields.next().unwrap_or_default().to_owned();
            let mut number = || fields.next()?.parse::<u64>().ok();
            let Some((designs, index)) = number().zip(number()).filter(|_| line.ends_with('\n')) else {
                let what = format!("{shown} has a line that is no row of a study");
                return fail(what, "run that shard again with --resume");
            };
            if study.get_or_insert_with(|| (key.clone(), designs)) != &(key, designs) {
                return Err(wrong(format!("{shown} is of another study than {before}")));
            }
            if let Some((_, other)) = rows.insert(index, (line.to_owned(), path)) {
                return Err(wrong(format!("design {index} is both in {} and in {shown}", other.display())));
            }
        }
    }
    let Some((header, (_, designs))) = header.zip(study) else { return Err(wrong("no shard has a row".into())) };
    if let Some(missing) = (0..designs).find(|index| !rows.contains_key(index)) {
        return Err(wrong(format!("design {missing} of {designs} is in no shard")));
    }
    if let Some((index, (_, path))) = rows.range(designs..).next() {
        return Err(wrong(format!("{} has design {index} of {designs}", path.display())));
    }
    let text = rows.into_values().fold(header + "\n", |text, (line, _)| text + &line);
    Ok((text, designs))
}
