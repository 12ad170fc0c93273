//! Parts of a study that run by themselves, and what puts their tables together.
//!
//! Shard k of n has the designs k − 1, k − 1 + n, k − 1 + 2n, …: neighbours, which cost alike, go to different shards.
//! The tables are put together line by line, with one line of each shard in memory.

use super::StudyError;
use super::journal::is_ours;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, BufWriter, Lines, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// One part of a study, `7/64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 1.
    number: u64,
    /// How many there are.
    of: u64,
}

impl Shard {
    /// The whole of a study.
    pub const WHOLE: Self = Self { number: 1, of: 1 };

    /// How many of so many designs are its own.
    pub fn count(self, designs: u64) -> u64 {
        (designs + self.of - self.number) / self.of
    }

    /// The indices of its designs, of so many.
    pub fn indices(self, count: u64) -> Vec<u64> {
        (self.number - 1..count).step_by(usize::try_from(self.of).unwrap_or(usize::MAX)).collect()
    }

    /// What its table is called, `study-7-of-64.csv`; of the whole, `study.csv`. Numbers are as wide as the last one, so
    /// that a shell lists them in order.
    pub fn file(self, stem: &str) -> String {
        match self {
            Self::WHOLE => format!("{stem}.csv"),
            Self { number, of } => format!("{stem}-{number:0width$}-of-{of}.csv", width = of.to_string().len()),
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(a, b)| Some((a.trim().parse().ok()?, b.trim().parse().ok()?)));
        match numbers {
            Some((number, of)) if (1..=of).contains(&number) => Ok(Self { number, of }),
            _ => Err("a shard is its number, from 1, and how many there are, as in 7/64".into()),
        }
    }
}

/// The table of a shard, line by line.
struct Table {
    path: PathBuf,
    lines: Lines<BufReader<File>>,
    /// Study and number of designs, of every row.
    study: Option<(String, u64)>,
}

/// Puts the tables of all shards of a study together in the order of their designs; returns how many there are.
///
/// # Errors
/// When a table is missing, there twice, of another study or not whole; nothing is written then.
pub fn merge(shards: &[PathBuf], out: &Path) -> Result<u64, StudyError> {
    let help = "give every shard of one study once";
    let mut tables = Vec::new();
    let mut header: Option<String> = None;
    for path in shards {
        if !is_ours(path) {
            let what = format!("{} is no table of a study, or cannot be read", path.display());
            return Err(StudyError::new(what, help));
        }
        let mut lines = BufReader::new(File::open(path).map_err(|error| unreadable(path, &error))?).lines();
        let own = lines.next().transpose().map_err(|error| unreadable(path, &error))?.unwrap_or_default();
        if header.get_or_insert_with(|| own.clone()) != &own {
            let what = format!("{} has other columns than {}", path.display(), shards[0].display());
            return Err(StudyError::new(what, help));
        }
        tables.push(Table { path: path.clone(), lines, study: None });
    }
    let Some(header) = header else { return Err(StudyError::new("there is no shard to merge", help)) };
    if out.exists() && !is_ours(out) {
        let what = format!("{} is there and is no table of a study", out.display());
        return Err(StudyError::new(what, "choose another name with --out"));
    }
    let part = out.with_file_name(format!(".{}.merge", out.file_name().unwrap_or_default().to_string_lossy()));
    let unwritable = |error: io::Error| {
        StudyError::new(format!("cannot write {}: {error}", out.display()), "choose another place with --out")
    };
    let mut writer = BufWriter::new(File::create(&part).map_err(unwritable)?);
    let put = |writer: &mut BufWriter<File>, line: &str| writeln!(writer, "{line}").map_err(unwritable);
    let merged = put(&mut writer, &header).and_then(|()| rows(&mut tables, |line| put(&mut writer, line)));
    let merged = merged.and_then(|count| {
        writer.into_inner().map_err(|error| unwritable(error.into_error()))?.sync_all().map_err(unwritable)?;
        fs::rename(&part, out).map_err(unwritable)?;
        Ok(count)
    });
    // What was begun of a merge that failed is of no use.
    merged.inspect_err(|_| _ = fs::remove_file(&part))
}

/// All rows in order.
fn rows(tables: &mut [Table], mut put: impl FnMut(&str) -> Result<(), StudyError>) -> Result<u64, StudyError> {
    let help = "give every shard of one study once";
    let mut next: Vec<Option<(u64, String)>> = Vec::new();
    for table in tables.iter_mut() {
        next.push(table.next()?);
    }
    let studies: Vec<(&PathBuf, &(String, u64))> =
        tables.iter().filter_map(|table| Some((&table.path, table.study.as_ref()?))).collect();
    let Some((first, (study, count))) = studies.first().map(|(path, study)| ((*path).clone(), (*study).clone())) else {
        return Err(StudyError::new("no shard has a row", help));
    };
    if let Some((path, _)) = studies.iter().find(|(_, other)| *other != &(study.clone(), count)) {
        return Err(StudyError::new(format!("{} is of another study than {}", path.display(), first.display()), help));
    }
    for index in 0..count {
        let owners: Vec<usize> =
            (0..tables.len()).filter(|&k| next[k].as_ref().is_some_and(|(own, _)| *own == index)).collect();
        match owners[..] {
            [k] => {
                if let Some((_, line)) = next[k].take() {
                    put(&line)?;
                }
                next[k] = tables[k].next()?;
                if tables[k].study.as_ref() != Some(&(study.clone(), count)) {
                    let what = format!("{} has rows of another study", tables[k].path.display());
                    return Err(StudyError::new(what, help));
                }
            }
            [] => return Err(StudyError::new(format!("design {index} of {count} is in no shard"), help)),
            [a, b, ..] => {
                let [a, b] = [a, b].map(|k| tables[k].path.display());
                return Err(StudyError::new(format!("design {index} is both in {a} and in {b}"), help));
            }
        }
    }
    match next.iter().position(Option::is_some) {
        Some(k) => {
            let what = format!("{} has rows twice or beyond the study's end", tables[k].path.display());
            Err(StudyError::new(what, help))
        }
        None => Ok(count),
    }
}

impl Table {
    /// The index of the next row, and the row.
    fn next(&mut self) -> Result<Option<(u64, String)>, StudyError> {
        let Some(line) = self.lines.next().transpose().map_err(|error| unreadable(&self.path, &error))? else {
            return Ok(None);
        };
        let mut fields = line.splitn(4, ',');
        let study = fields.next().unwrap_or_default().to_owned();
        let numbers = fields.next().and_then(|n| n.parse().ok()).zip(fields.next().and_then(|n| n.parse().ok()));
        let Some((count, index)) = numbers else {
            let what = format!("{} has a line that is no row of a study", self.path.display());
            return Err(StudyError::new(what, "run that shard again"));
        };
        self.study = Some((study, count));
        Ok(Some((index, line)))
    }
}

fn unreadable(path: &Path, error: &io::Error) -> StudyError {
    StudyError::new(format!("cannot read {}: {error}", path.display()), "give the tables that the shards have written")
}
