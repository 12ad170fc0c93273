//! The table of a study on its way: rows in the order of their indices, so that what is missing is known after any end.
//!
//! Rows are appended to `.study.csv.part` beside `study.csv`, which takes its name when the last one is there: whoever
//! reads `study.csv` reads all of it. A run that was killed leaves whole rows and at most a half one, which is cut off.

use super::StudyError;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// What the header of a study's table begins with.
const OURS: &str = "study,designs,index,";

/// A table that is being written.
#[derive(Debug)]
pub struct Journal {
    /// Its name when it is complete.
    path: PathBuf,
    part: PathBuf,
    file: File,
    /// Rows that are there.
    done: usize,
}

/// What to do with rows that an earlier run has left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Earlier {
    /// They stay, and only what is missing is run, once no other run is at it.
    Resume,
    /// They go.
    Restart,
    /// They are not touched: to begin is a mistake then.
    Refuse,
}

/// What can be done about a table.
#[derive(Debug)]
pub enum Begun {
    /// Rows are missing, from [`Journal::done`] on.
    Open(Journal),
    /// All of it is there.
    Complete,
}

impl Journal {
    /// Takes a table for the rows of some indices of a study, which its key tells from others.
    ///
    /// # Errors
    /// When it cannot be written to, another process writes there, a file that is no table of a study stands in its
    /// place, or what an earlier run has left is to be neither kept nor removed, or is of another study.
    pub fn open(
        path: &Path,
        study: &str,
        header: &[String],
        indices: &[u64],
        earlier: Earlier,
    ) -> Result<Begun, StudyError> {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let part = path.with_file_name(format!(".{name}.part"));
        let unwritable = |error: io::Error| {
            StudyError::new(format!("cannot write {}: {error}", path.display()), "choose another place with --out")
        };
        let own = Own { study, header: record(header), indices };
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(unwritable)?;
        }
        let (mut file, is_begun) = loop {
            if path.exists() && !is_ours(path) {
                let what = format!("{} is there and is no table of a study", path.display());
                return Err(StudyError::new(what, "choose another place with --out"));
            }
            if path.exists() && earlier == Earlier::Resume && rows_of(path, &own)?.count == indices.len() {
                return Ok(Begun::Complete);
            }
            let is_begun = part.exists();
            let file = OpenOptions::new().read(true).append(true).create(true).open(&part).map_err(unwritable)?;
            lock(&file, path, earlier)?;
            // Another run may have ended meanwhile and given its rows, which are this file, their name.
            if is_same(&file, &part) {
                break (file, is_begun);
            }
        };
        let kept = match earlier {
            Earlier::Refuse if is_begun && file.metadata().is_ok_and(|data| data.len() > 0) => {
                let what = format!("an earlier run has left rows of {} and did not end", path.display());
                return Err(StudyError::new(what, "go on with them by --resume, or begin anew with --restart"));
            }
            Earlier::Resume if is_begun => rows_of(&part, &own)?,
            _ => Rows::default(),
        };
        file.set_len(kept.bytes).and_then(|()| file.seek(SeekFrom::End(0))).map_err(unwritable)?;
        let mut journal = Self { path: path.to_owned(), part, file, done: kept.count };
        if kept.bytes == 0 {
            journal.write(header).map_err(unwritable)?;
        }
        Ok(Begun::Open(journal))
    }

    /// Rows that are there.
    pub fn done(&self) -> usize {
        self.done
    }

    /// Adds the next row.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, line: &[String]) -> io::Result<()> {
        self.write(line)?;
        self.done += 1;
        Ok(())
    }

    fn write(&mut self, line: &[String]) -> io::Result<()> {
        self.file.write_all(&record(line))
    }

    /// Gives the table its name: all rows are there.
    ///
    /// # Errors
    /// When that cannot be done; the rows stay where they are.
    pub fn finish(self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.part, &self.path)
    }

    /// Where the rows are as long as some are missing.
    pub fn part(&self) -> &Path {
        &self.part
    }
}

/// Keeps other runs from writing the same rows. A run that goes on waits for one that is not over: a scheduler may begin a
/// shard again while what it has lost is still at it.
fn lock(file: &File, path: &Path, earlier: Earlier) -> Result<(), StudyError> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) if earlier == Earlier::Resume => file.lock().map_err(|error| {
            StudyError::new(format!("cannot wait for the other run of {}: {error}", path.display()), "try it again")
        }),
        Err(TryLockError::WouldBlock) => {
            let what = format!("another run writes {}", path.display());
            Err(StudyError::new(what, "wait for it, or choose another place with --out"))
        }
        // Some disks of clusters know no locks: rows that are there twice are still found when shards are merged.
        Ok(()) | Err(TryLockError::Error(_)) => Ok(()),
    }
}

/// Whether an open file is still the one of that name.
fn is_same(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let [open, named] = [file.metadata(), fs::metadata(path)].map(|data| data.ok().map(|d| (d.dev(), d.ino())));
        open.is_some() && open == named
    }
    #[cfg(not(unix))]
    {
        // A file that is open cannot be renamed there.
        let _ = file;
        path.exists()
    }
}

/// Whole rows at the beginning of a file.
#[derive(Clone, Copy, Debug, Default)]
struct Rows {
    count: usize,
    /// With the header; 0 where there is none.
    bytes: u64,
}

/// What rows of a study begin with.
struct Own<'a> {
    /// Its [key](super::Designs::key).
    study: &'a str,
    /// The first line.
    header: Vec<u8>,
    /// Of its rows, in order.
    indices: &'a [u64],
}

/// Counts the whole rows of a table, which must be of the study that it is of.
fn rows_of(path: &Path, own: &Own) -> Result<Rows, StudyError> {
    let unreadable = |error: io::Error| {
        StudyError::new(format!("cannot read {}: {error}", path.display()), "begin anew with --restart")
    };
    let other = || {
        let what = format!("{} has rows of another study, or of another version", path.display());
        StudyError::new(what, "begin anew with --restart, or choose another place with --out")
    };
    let mut lines = BufReader::new(File::open(path).map_err(unreadable)?);
    let (mut rows, mut line) = (Rows::default(), String::new());
    loop {
        line.clear();
        let read = lines.read_line(&mut line).map_err(unreadable)?;
        if read == 0 || !line.ends_with('\n') {
            return Ok(rows);
        }
        if rows.bytes == 0 {
            if line.as_bytes() != own.header {
                return Err(other());
            }
        } else {
            let mut fields = line.split(',');
            let is_own = fields.next() == Some(own.study);
            let index = fields.nth(1).and_then(|index| index.parse::<u64>().ok());
            if !is_own || index.is_none() || index != own.indices.get(rows.count).copied() {
                return Err(other());
            }
            rows.count += 1;
        }
        rows.bytes += read as u64;
    }
}

/// Whether a file begins as tables of studies do.
pub(super) fn is_ours(path: &Path) -> bool {
    let mut line = String::new();
    File::open(path).and_then(|file| BufReader::new(file).read_line(&mut line)).is_ok() && line.starts_with(OURS)
}

/// A whole table as CSV.
pub fn csv(header: &[String], lines: &[Vec<String>]) -> Vec<u8> {
    std::iter::once(header).chain(lines.iter().map(Vec::as_slice)).flat_map(record).collect()
}

/// A line of CSV: one line of text whatever its fields hold, so that whole rows can be told from half ones.
fn record(fields: &[String]) -> Vec<u8> {
    let never = "memory does not refuse a row";
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(fields.iter().map(|field| field.replace(['\n', '\r'], " "))).expect(never);
    writer.into_inner().expect(never)
}
