//! Tables of studies on the disk, whole or as shards. While one is made, `.study.csv.rows` has its rows and `.study.csv.curves`
//! their curves; `.study.csv.lock` is held by the process that writes them.
//!
//! A killed run may leave half a last row, which resuming removes. Shard k of n has the designs k − 1, k − 1 + n, …

use super::{run_table::BEGINNING, run_table::record, *};
use crate::results::file::{Lock, NewFolders, WriteError, folder_of, hidden, write};
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::time::Duration;
use std::{str::FromStr, thread};

/// Largest table \[bytes\]: a million rows of 2 kB.
const LARGEST: usize = 2_000_000_000;
const AGAIN: Duration = Duration::from_millis(100);
const ELSEWHERE: &str = "choose another place with --out";

/// A table on the disk, locked by this process.
#[derive(Debug)]
pub struct TableFile {
    path: PathBuf,
    /// Path of the rows while some are missing.
    pub part: PathBuf,
    /// Folder of the curves while some are missing.
    curves: PathBuf,
    /// Whether its rows are those of a complete table.
    is_complete: bool,
    is_resumed: bool,
    _lock: Lock,
    _folders: NewFolders,
}

impl TableFile {
    /// Locks a study's table; an earlier one only to `resume`, after the end of the process before, or to `restart`.
    pub fn open(path: &Path, resume: bool, restart: bool, watch: &dyn Watch) -> Result<Self> {
        let shown = path.display();
        let unwritable = |error: io::Error| StudyError::new(format!("cannot write {shown}: {error}"), ELSEWHERE);
        let hidden = |ending: &str| hidden(path, ending).map_err(unwritable);
        let [part, curves, lock] = [hidden("rows")?, hidden("curves")?, hidden("lock")?];
        let folders = NewFolders::make(folder_of(path)).map_err(unwritable)?;
        let lock = loop {
            match Lock::take(&lock) {
                Err(error) if resume && error.kind() == ErrorKind::ResourceBusy && !watch.wants_to_stop() => {
                    thread::sleep(AGAIN);
                }
                lock => break lock.map_err(unwritable)?,
            }
        };
        let is_complete = path.exists();
        ensure(!is_complete || is_table(path), format!("{shown} is there and is no table of a study"), ELSEWHERE)?;
        let is_free = |is_there: bool| resume || restart || !is_there;
        let what = format!("an earlier run has left rows of {shown} and did not end");
        let help = "go on with them by --resume, or begin anew with --restart";
        ensure(is_free(part.metadata().is_ok_and(|part| part.len() > 0)), what, help)?;
        let help = format!("replace it with --restart, or {ELSEWHERE}");
        ensure(is_free(is_complete), format!("{shown} is there, of a complete study"), help)?;
        let path = path.to_owned();
        Ok(Self { path, part, curves, is_complete, is_resumed: resume, _lock: lock, _folders: folders })
    }

    /// Begins the rows of a study, or goes on with those of an earlier run, which are returned.
    pub fn begin(&mut self, runs: &RunTable) -> Result<EarlierRuns> {
        let Self { path, part, curves, is_complete, .. } = self;
        let shown = path.display();
        let unwritable = |error: io::Error| StudyError::new(format!("cannot write {shown}: {error}"), ELSEWHERE);
        let read = |path: &Path| if path.exists() { Disk.read(path, LARGEST) } else { Ok(Vec::new()) };
        let mut bytes = if self.is_resumed { read(part).map_err(unwritable)? } else { Vec::new() };
        // Bytes behind the last whole line are a row that was cut.
        bytes.truncate(bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1));
        let kept = bytes.len() as u64;
        *is_complete &= self.is_resumed && kept == 0;
        if *is_complete {
            bytes = read(path).map_err(unwritable)?;
        } else if kept == 0 {
            bytes = record(&runs.header());
        }
        let what = format!("{shown} has rows of another study, or of another version");
        let foreign = || StudyError::new(what, format!("begin anew with --restart, or {ELSEWHERE}"));
        let earlier = rows(&bytes, runs).ok_or_else(foreign)?;
        if kept == 0 && curves.exists() {
            fs::remove_dir_all(curves).map_err(unwritable)?;
        }
        let begin = || {
            let mut file = File::options().write(true).create(true).truncate(false).open(part)?;
            file.set_len(kept)?;
            file.seek(SeekFrom::End(0))?;
            file.write_all(&bytes[kept as usize..])
        };
        begin().map(|()| earlier).map_err(unwritable)
    }

    /// Appends a row, with load and thickness of the design if they are to be kept.
    pub fn add(&mut self, runs: &RunTable, evaluated: &Evaluated, with_curves: bool) -> Result<(), WriteError> {
        let Evaluated { run, outcome } = evaluated;
        let curves = outcome.iter().filter(|_| with_curves).flat_map(|outcome| {
            let load = ("load", "travel_mm,punch_force_N", &outcome.load);
            [load, ("thickness", "s0_mm,thickness_mm", &outcome.thickness)]
        });
        for (name, header, points) in curves {
            let lines: String = points.iter().map(|(x, y)| format!("{x},{y}\n")).collect();
            write(&self.curves.join(format!("{name}-{}.csv", run.index)), format!("{header}\n{lines}").as_bytes())?;
        }
        let line = record(&runs.line(run));
        // Open for one row only: Windows keeps the name of a file that is open.
        let written = File::options().append(true).open(&self.part).and_then(|mut rows| rows.write_all(&line));
        written.map_err(|source| WriteError { path: self.part.clone(), source })
    }

    /// Files of all curves that were kept.
    pub fn curve_files(&self) -> Vec<PathBuf> {
        let earlier = self.is_complete.then(|| self.path.with_file_name("curves"));
        let folders = earlier.as_ref().into_iter().chain([&self.curves]);
        let files = folders.flat_map(|folder| fs::read_dir(folder).into_iter().flatten().flatten());
        files.map(|file| file.path()).collect()
    }

    /// Writes the table of a shard, and its curves beside it; removes the rows.
    pub fn finish(self, runs: &RunTable) -> Result<(), WriteError> {
        let curves = self.path.with_file_name("curves");
        let keep = |path: PathBuf| {
            fs::create_dir_all(&curves)?;
            fs::rename(&path, curves.join(path.file_name().unwrap_or_default()))
        };
        let kept = self.curve_files().into_iter().try_for_each(keep);
        kept.map_err(|source| WriteError { path: curves.clone(), source })?;
        write(&self.path, &runs.csv())?;
        let _ = fs::remove_dir(&self.curves);
        let _ = fs::remove_file(&self.part);
        Ok(())
    }
}

fn rows(text: &[u8], runs: &RunTable) -> Option<EarlierRuns> {
    let own = text.strip_prefix(&record(&runs.header())[..])?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(own);
    reader.records().map(|record| runs.read(&record.ok()?).map(|run| (run.index, run))).collect()
}

fn is_table(path: &Path) -> bool {
    let mut beginning = Vec::new();
    let read = File::open(path).and_then(|file| file.take(BEGINNING.len() as u64).read_to_end(&mut beginning));
    path.is_file() && read.is_ok() && beginning == BEGINNING.as_bytes()
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

    /// Position of one of its designs in the study.
    pub fn index(self, own: usize) -> u64 {
        self.number - 1 + own as u64 * self.count
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
        match text.split_once('/').and_then(|(a, b)| Some((a.trim().parse().ok()?, b.trim().parse().ok()?))) {
            Some((number, count)) if (1..=count).contains(&number) => Ok(Self { number, count }),
            _ => Err("a shard is its number, from 1, and how many there are, as in 7/64".into()),
        }
    }
}

/// Merges the tables of all shards of a study, in the order of the designs; returns the text and the number of rows.
pub fn merge(shards: &[PathBuf]) -> Result<(String, u64)> {
    let help = "give every shard of one study once";
    let read = |path: &PathBuf| Disk.text(path, LARGEST).map_err(|error| StudyError::unreadable(path, &error, help));
    let texts = shards.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let (mut header, mut study) = (None, None);
    let mut all: BTreeMap<u64, (&str, &Path)> = BTreeMap::new();
    for (path, text) in shards.iter().zip(&texts) {
        let (shown, before) = (path.display(), shards[0].display());
        let mut lines = text.split_inclusive('\n');
        let first = lines.next().unwrap_or_default();
        ensure(first.starts_with(BEGINNING), format!("{shown} is no table of a study"), help)?;
        ensure(*header.get_or_insert(first) == first, format!("{shown} has other columns than {before}"), help)?;
        let columns = fields(first).map_or(0, |fields| fields.len());
        for (i, line) in lines.enumerate() {
            let shown = format!("{shown}, line {}", i + 2);
            let row = || {
                let fields = fields(line).filter(|fields| fields.len() == columns && line.ends_with('\n'))?;
                let [key, designs, index, .., version] = &fields[..] else { return None };
                Some(((key.clone(), designs.parse().ok()?, version.clone()), index.parse().ok()?))
            };
            let (what, again) = (format!("{shown}, is no row of a study"), "run that shard again with --resume");
            let (own, index): ((String, u64, String), u64) = row().ok_or_else(|| StudyError::new(what, again))?;
            let is_own = *study.get_or_insert_with(|| own.clone()) == own;
            ensure(is_own, format!("{shown}, is of another study than {before}, or of another version"), help)?;
            if let Some((_, other)) = all.insert(index, (line, path)) {
                return fail(format!("design {index} is both in {} and in {shown}", other.display()), help);
            }
        }
    }
    let (header, (_, designs, _)) = header.zip(study).ok_or_else(|| StudyError::new("no shard has a row", help))?;
    if let Some(missing) = (0..designs).find(|index| !all.contains_key(index)) {
        return fail(format!("design {missing} of {designs} is in no shard"), help);
    }
    if let Some((index, (_, path))) = all.range(designs..).next() {
        return fail(format!("{} has design {index} of {designs}", path.display()), help);
    }
    Ok(([header].into_iter().chain(all.into_values().map(|(line, _)| line)).collect(), designs))
}

fn fields(line: &str) -> Option<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(line.as_bytes());
    Some(reader.records().next()?.ok()?.iter().map(str::to_owned).collect())
}
