//! A folder of results that goes over from those of one run to those of the next in one step.
//!
//! A run writes beside its folder `cup`, and what it has written takes the folder's place when it is complete:
//!
//! | name | what | left by a killed run, the next one |
//! |---|---|---|
//! | `.cup.lock` | the process that writes | takes it over |
//! | `.cup.part` | results that are being written | removes it |
//! | `.cup.swap` | exchanged with `cup`: new results before, old ones after | removes the results in it |
//! | `.cup.ready` | complete results that go into `cup` file by file | puts them there |
//!
//! Files of a user's own in the folder are linked into the new one before the exchange, so that they are there at
//! every instant; no step removes a file that a run has not written. The results go in file by file, and an interruption of
//! that is visible until the next run, where folders cannot be exchanged: the file system does not know how, a disk is
//! mounted there, a program stands in the folder (the shell that calls, `--out .`), or it has folders of a user's own, which
//! cannot be linked. Where nothing may be made beside the folder the names stand inside it, as `.stampflow.part`.

mod site;
#[cfg(test)]
mod tests;

use crate::output::file::{Way, folder_of};
use crate::output::lock::Lock;
use crate::output::{WriteError, can_write, disk};
use site::{Site, with, with_ending};
use std::ffi::OsString;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// So many files at a time are waited for until the disk has them: one after the other takes several times as long.
const AT_A_TIME: usize = 16;

/// A folder of results, held by this process until it is published or dropped.
#[derive(Debug)]
pub struct ResultFolder {
    /// As it was named.
    named: PathBuf,
    site: Site,
    lock: Lock,
    /// What was written, by its path from the folder.
    written: Vec<PathBuf>,
    /// The first thing that could not be written.
    failure: Option<WriteError>,
    /// Whether what was written stays, though it is not published.
    is_kept: bool,
    /// Dropped last, when nothing of ours stands on it.
    _way: Way,
}

impl ResultFolder {
    /// Takes a folder, which need not exist, for results whose files are `is_ours` by their paths; ends what a killed run
    /// left half done.
    ///
    /// # Errors
    /// When it is no folder, cannot be written to, or another process writes there.
    pub fn open(named: &Path, is_ours: fn(&Path) -> bool) -> Result<Self, WriteError> {
        Self::take(named, is_ours).map_err(|source| WriteError { path: named.to_owned(), source })
    }

    fn take(named: &Path, is_ours: fn(&Path) -> bool) -> io::Result<Self> {
        let (path, way) = located(named)?;
        let (stem, lock) = claimed(&path)?;
        let site = Site { path, stem, is_ours };
        site.recover()?;
        if site.path.exists() {
            can_write(&site.path.join("probe")).map_err(|error| error.source)?;
        }
        disk::create_dir(&site.part())?;
        let named = named.to_owned();
        Ok(Self { named, site, lock, written: Vec::new(), failure: None, is_kept: false, _way: way })
    }

    /// Writes a file of the results to come, by its path from the folder. When that fails, publishing will say so: what
    /// else there is can still be written.
    pub fn write(&mut self, name: impl AsRef<Path>, bytes: &[u8]) {
        let name = name.as_ref();
        match self.put(&self.site.part().join(name), bytes) {
            Ok(()) => self.written.push(name.to_owned()),
            Err(source) => {
                self.failure.get_or_insert(WriteError { path: self.named.join(name), source });
            }
        }
    }

    fn put(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        if !self.lock.stands() {
            // Someone has removed all of it.
            disk::create_dir_all(folder_of(&self.site.stem))?;
            self.lock = Lock::wait(&self.site.named("lock"))?;
            self.site.recover()?;
        }
        disk::create_dir_all(folder_of(path))?;
        disk::fill(&disk::open(path)?, bytes).inspect_err(|_| _ = disk::remove_file(path))
    }

    /// Puts what was written in the place of the results that were there; returns its files.
    ///
    /// # Errors
    /// When something could not be written, or not be put there: the message says where the new results are, and the
    /// folder is as it was.
    pub fn publish(mut self) -> Result<Vec<PathBuf>, WriteError> {
        let part = self.site.part();
        if let Some(WriteError { path, source }) = self.failure.take() {
            self.is_kept = !self.written.is_empty();
            let what = "; what could be written is until the next run in";
            return Err(WriteError { path, source: if self.is_kept { with(&source, what, &part) } else { source } });
        }
        let published = match self.written.iter().find(|name| !part.join(name).exists()) {
            Some(gone) => Err(io::Error::other(format!("{} was taken away", part.join(gone).display()))),
            None => self.sync().and_then(|()| self.site.publish(self.written.is_empty())),
        };
        self.is_kept = published.is_err();
        published.map_err(|source| WriteError { path: self.named.clone(), source })?;
        Ok(self.written.iter().map(|name| self.named.join(name)).collect())
    }

    /// Returns when all that was written would outlast a loss of power.
    fn sync(&self) -> io::Result<()> {
        let part = self.site.part();
        for names in self.written.chunks(AT_A_TIME) {
            std::thread::scope(|scope| {
                let paths = names.iter().map(|name| part.join(name));
                let syncs: Vec<_> = paths.map(|path| scope.spawn(move || disk::sync(&path))).collect();
                syncs.into_iter().try_for_each(|sync| sync.join().expect("no panic in a call of the system"))
            })?;
        }
        disk::sync_names(&part);
        Ok(())
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        if !self.is_kept && self.lock.stands() {
            let _ = disk::remove_dir_all(&self.site.part());
        }
    }
}

/// Where a folder is, behind links, and the way that was made to it.
fn located(named: &Path) -> io::Result<(PathBuf, Way)> {
    let named = if named.as_os_str().is_empty() { Path::new(".") } else { named };
    let folder = folder_of(named);
    let way = Way::to(folder)?;
    if named.symlink_metadata().is_err() {
        let name = named.file_name().ok_or(ErrorKind::InvalidInput)?;
        return Ok((fs::canonicalize(folder)?.join(name), way));
    }
    let path = fs::canonicalize(named)?;
    if path.is_dir() { Ok((path, way)) } else { Err(ErrorKind::NotADirectory.into()) }
}

/// Takes the lock beside a folder, or inside it where nothing can be made beside it.
fn claimed(path: &Path) -> io::Result<(PathBuf, Lock)> {
    let beside = path.file_name().map(|name| {
        let mut stem = OsString::from(".");
        stem.push(name);
        path.with_file_name(stem)
    });
    let inside = path.is_dir().then(|| path.join(concat!(".", env!("CARGO_PKG_NAME"))));
    let mut failure = io::Error::from(ErrorKind::InvalidInput);
    for (i, stem) in [beside, inside].into_iter().flatten().enumerate() {
        match Lock::take(&with_ending(&stem, "lock")) {
            Ok(lock) => return Ok((stem, lock)),
            Err(error) if error.kind() == ErrorKind::ResourceBusy => return Err(error),
            Err(error) if i == 0 => failure = error,
            Err(_) => {}
        }
    }
    Err(failure)
}
