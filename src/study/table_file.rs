//! Tables of studies on the disk, whole or as shards. While one is written: `.study.csv.rows`, renamed to `study.csv` when the
//! last row is there.
//!
//! A killed run may leave one incomplete last row, which resuming removes. Shard k of n has the designs k − 1, k − 1 + n,
//! k − 1 + 2n, …: neighbours, which cost alike, go to different shards.

use super::error::ensure;
use super::run_table::{BEGINNING, record};
use super::{EarlierRuns, Run, RunTable, StudyError, fail};
use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A table on the disk.
#[derive(Debug)]
pub struct TableFile {
    path: PathBuf,
    /// Path of the rows while some are missing.
    pub part: PathBuf,
    file: File,
    /// Rows that an earlier run has left.
    pub earlier: EarlierRuns,
}

impl TableFile {
    /// Opens the table file of a study; rows of an earlier run are refused unless they are to `resume` or to `restart`.
    pub fn open(path: &Path, runs: &RunTable, resume: bool, restart: bool) -> Result<Self, StudyError> {
        let (shown, elsewhere) = (path.display(), "choose another place with --out");
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let part = path.with_file_name(format!(".{name}.rows"));
        let unwritable = |error: io::Error| StudyError::new(format!("cannot write {shown}: {error}"), elsewhere);
        fs::create_dir_all(path.parent().unwrap_or(Path::new(""))).map_err(unwritable)?;
        let is_free = !path.exists() || is_table(path);
        ensure(is_free, format!("{shown} is there and is no table of a study"), elsewhere)?;
        let mut file = loop {
            let file = OpenOptions::new().read(true).append(true).create(true).open(&part).map_err(unwritable)?;
            match file.try_lock() {
                // A shard that begins again waits for the end of the process that it takes over from.
                Err(TryLockError::WouldBlock) if resume => file.lock().map_err(unwritable)?,
                Err(TryLockError::WouldBlock) => {
                    return fail(format!("another run writes {shown}"), format!("wait for it, or {elsewhere}"));
                }
                // File systems without locks are accepted.
                Ok(()) | Err(TryLockError::Error(_)) => {}
            }
            // The run that was waited for may have renamed its table.
            if part.exists() {
                break file;
            }
        };
        let mut bytes = Vec::new();
        if !restart {
            file.read_to_end(&mut bytes).map_err(unwritable)?;
        }
        let what = format!("an earlier run has left rows of {shown} and did not end");
        let help = "go on with them by --resume, or begin anew with --restart";
        ensure(bytes.is_empty() || resume, what, help)?;
        // Bytes behind the last whole line are a row that was cut.
        bytes.truncate(bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1));
        let kept = bytes.len() as u64;
        if kept == 0 {
            bytes = if resume && path.exists() { fs::read(path).map_err(unwritable)? } else { record(&runs.header()) };
        }
        let what = format!("{shown} has rows of another study, or of another version");
        let foreign = || StudyError::new(what, format!("begin anew with --restart, or {elsewhere}"));
        let earlier = rows(&bytes, runs).ok_or_else(foreign)?;
        file.set_len(kept).and_then(|()| file.seek(SeekFrom::End(0))).map_err(unwritable)?;
        if kept == 0 {
            file.write_all(&bytes).map_err(unwritable)?;
        }
        Ok(Self { path: path.to_owned(), part, file, earlier })
    }

    /// Appends a row.
    pub fn add(&mut self, runs: &RunTable, run: &Run) -> io::Result<()> {
        self.file.write_all(&record(&runs.line(run)))
    }

    /// Gives the whole table its name.
    pub fn finish(self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.part, &self.path)
    }

    /// Removes the rows once they are in the folder of the results.
    pub fn discard(self) {
        let _ = fs::remove_file(&self.part);
    }
}

fn rows(text: &[u8], runs: &RunTable) -> Option<EarlierRuns> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text);
    let mut records = reader.records();
    let Some(header) = records.next() else { return Some(EarlierRuns::new()) };
    let is_own = header.ok()?.iter().eq(runs.header().iter().map(String::as_str));
    let rows = records.map(|record| runs.read(&record.ok()?).map(|run| (run.index, run)));
    rows.collect::<Option<_>>().filter(|_| is_own)
}

fn is_table(path: &Path) -> bool {
    let mut beginning = Vec::new();
    let read = File::open(path).and_then(|file| file.take(BEGINNING.len() as u64).read_to_end(&mut beginning));
    read.is_ok() && beginning == BEGINNING.as_bytes()
}

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
    let help = "give every shard of one study once";
    let unreadable = |path: &Path, error| StudyError::new(format!("cannot read {}: {error}", path.display()), help);
    let read = |path: &PathBuf| fs::read_to_string(path).map_err(|error| unreadable(path, error));
    let texts = shards.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let (mut header, mut study) = (None, None);
    let mut rows: BTreeMap<u64, (&str, &Path)> = BTreeMap::new();
    for (path, text) in shards.iter().zip(&texts) {
        let (shown, before) = (path.display(), shards[0].display());
        let mut lines = text.split_inclusive('\n');
        let first = lines.next().unwrap_or_default();
        ensure(first.starts_with(BEGINNING), format!("{shown} is no table of a study"), help)?;
        let is_alike = *header.get_or_insert(first) == first;
        ensure(is_alike, format!("{shown} has other columns than {before}"), help)?;
        for line in lines {
            let row = || {
                let mut fields = line.strip_suffix('\n')?.split(',');
                Some(((fields.next()?, fields.next()?.parse().ok()?), fields.next()?.parse().ok()?))
            };
            let what = format!("{shown} has a line that is no row of a study");
            let cut = || StudyError::new(what, "run that shard again with --resume");
            let (own, index): ((&str, u64), u64) = row().ok_or_else(cut)?;
            let is_own = *study.get_or_insert(own) == own;
            ensure(is_own, format!("{shown} is of another study than {before}"), help)?;
            if let Some((_, other)) = rows.insert(index, (line, path)) {
                return fail(format!("design {index} is both in {} and in {shown}", other.display()), help);
            }
        }
    }
    let (header, (_, designs)) = header.zip(study).ok_or_else(|| StudyError::new("no shard has a row", help))?;
    if let Some(missing) = (0..designs).find(|index| !rows.contains_key(index)) {
        return fail(format!("design {missing} of {designs} is in no shard"), help);
    }
    if let Some((index, (_, path))) = rows.range(designs..).next() {
        return fail(format!("{} has design {index} of {designs}", path.display()), help);
    }
    Ok(([header].into_iter().chain(rows.into_values().map(|(line, _)| line)).collect(), designs))
}
