//! The table of a study while it is written: `.study.csv.rows`, renamed to `study.csv` when the last row is there.
//!
//! A killed run may leave one incomplete last row, which resuming removes.

use super::run_table::{BEGINNING, record};
use super::{EarlierRuns, Run, RunTable, StudyError, fail};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

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
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(unwritable)?;
        }
        if path.exists() && !is_table(path) {
            return fail(format!("{shown} is there and is no table of a study"), elsewhere);
        }
        let mut file = loop {
            let file = OpenOptions::new().read(true).append(true).create(true).open(&part).map_err(unwritable)?;
            match file.try_lock() {
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
        if !bytes.is_empty() && !resume {
            let what = format!("an earlier run has left rows of {shown} and did not end");
            return fail(what, "go on with them by --resume, or begin anew with --restart");
        }
        // Bytes behind the last whole line are a row that was cut.
        bytes.truncate(bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1));
        let kept = bytes.len() as u64;
        if kept == 0 {
            bytes = if resume && path.exists() { fs::read(path).map_err(unwritable)? } else { record(&runs.header()) };
        }
        let Some(earlier) = rows(&bytes, runs) else {
            let what = format!("{shown} has rows of another study, or of another version");
            return fail(what, format!("begin anew with --restart, or {elsewhere}"));
        };
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
