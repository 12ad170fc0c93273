//! Folder of results that goes from one complete set of files to the next in one rename.
//!
//! Beside `cup`, `.cup.lock` holds the number of the process that writes and `.cup.part` the new set, then the earlier one.
//!
//! Files of other origin are hard-linked into the new set before the exchange. The set goes in file by file if folders cannot be
//! exchanged: no support by the system, a program standing in the folder (`--out .`), more than [`MOST_CARRIED`] other files.
//! Nothing goes in while another program holds one of the files that would change.
//! If nothing can be made beside the folder (a protected parent), the names stand inside it.

use super::file::{Lock, NewFolders, WriteError, can_replace, can_write, fill, folder_of, hidden};
use rayon::prelude::*;
use std::{fs, fs::File, io, io::ErrorKind, path::Path, path::PathBuf};

/// More files of other origin than this are not linked at every run.
const MOST_CARRIED: usize = 2000;
/// Whether the system exchanges two folders in one step. Elsewhere a link to a file that is held keeps the new set's folder.
const EXCHANGES: bool = cfg!(any(target_os = "linux", target_os = "macos"));

/// Decides by the folder and the path from it whether a file belongs to the set that is replaced.
pub type IsOurs = fn(&Path, &Path) -> bool;

/// Folder of results, locked by this process until it is committed or dropped.
#[derive(Debug)]
pub struct ResultFolder {
    /// Path given by the caller.
    named: PathBuf,
    /// Without links.
    path: PathBuf,
    part: PathBuf,
    is_ours: IsOurs,
    written: Vec<PathBuf>,
    _lock: Lock,
    _parents: NewFolders,
}

impl ResultFolder {
    /// Locks a folder, which need not exist, and removes what a killed run left; fails if another process writes there.
    pub fn open(named: &Path, is_ours: IsOurs) -> Result<Self, WriteError> {
        let open = || {
            let named = if named.as_os_str().is_empty() { Path::new(".") } else { named };
            let parents = NewFolders::make(folder_of(named))?;
            let path = match named.symlink_metadata() {
                Ok(_) => fs::canonicalize(named)?,
                Err(_) => fs::canonicalize(folder_of(named))?.join(named.file_name().ok_or(ErrorKind::InvalidInput)?),
            };
            if path.exists() {
                fs::read_dir(&path)?;
                can_write(&path.join("probe")).map_err(|error| error.source)?;
            }
            let (part, lock) = match part_and_lock(&path) {
                Err(error) if path.is_dir() && error.kind() != ErrorKind::ResourceBusy => {
                    part_and_lock(&path.join(env!("CARGO_PKG_NAME")))?
                }
                names => names?,
            };
            if part.exists() {
                fs::remove_dir_all(&part)?;
            }
            Ok(Self { named: named.to_owned(), path, part, is_ours, written: vec![], _lock: lock, _parents: parents })
        };
        open().map_err(|source| WriteError::new(named, source))
    }

    /// Writes a file of the new set by its path from the folder; after a failure drop the folder, and the earlier results stay.
    pub fn write(&mut self, name: impl AsRef<Path>, bytes: &[u8]) -> Result<(), WriteError> {
        let (name, path) = (name.as_ref(), self.part.join(name.as_ref()));
        let written = fs::create_dir_all(folder_of(&path)).and_then(|()| fill(&File::create(&path)?, bytes));
        written.map_err(|source| WriteError::new(self.named.join(name), unchanged(&source)))?;
        self.written.push(name.to_owned());
        Ok(())
    }

    /// Replaces the earlier set by the new one and returns the paths of its files.
    pub fn commit(self) -> Result<Vec<PathBuf>, WriteError> {
        self.replace().map_err(|source| WriteError::new(&self.named, source))?;
        Ok(self.written.iter().map(|name| self.named.join(name)).collect())
    }

    fn replace(&self) -> io::Result<()> {
        if self.written.is_empty() && !self.path.exists() {
            return Ok(());
        }
        fs::create_dir_all(&self.part)?;
        let flush = |name: &PathBuf| File::options().append(true).open(self.part.join(name))?.sync_all(); // as Windows asks
        self.written.par_iter().try_for_each(flush).map_err(|error| unchanged(&error))?;
        sync(&self.part);
        if !self.path.exists() {
            return fs::rename(&self.part, &self.path).map(|()| sync(folder_of(&self.path)));
        }
        fs::set_permissions(&self.part, fs::metadata(&self.path)?.permissions())?;
        let stands_in = std::env::current_dir().is_ok_and(|here| here.starts_with(&self.path));
        if EXCHANGES && !stands_in && !self.part.starts_with(&self.path) {
            match self.carry(&self.path, &self.part) {
                Err(error) if error.kind() == ErrorKind::StorageFull => return Err(unchanged(&error)),
                Ok(true) if exchange(&self.part, &self.path).is_ok() => {
                    sync(folder_of(&self.path));
                    // Files that someone saved between linking and exchange.
                    self.carry(&self.part, &self.path)?;
                    return fs::remove_dir_all(&self.part);
                }
                _ => {}
            }
        }
        self.replace_each()
    }

    fn replace_each(&self) -> io::Result<()> {
        let is_stale = |name: &PathBuf| (self.is_ours)(&self.path, name) && !self.written.contains(name);
        let stale: Vec<_> = entries(&self.path)?.into_iter().filter(is_stale).collect();
        self.written.iter().chain(&stale).try_for_each(|name| can_replace(&self.path.join(name)))?;
        for name in &self.written {
            let (from, to) = (self.part.join(name), self.path.join(name));
            fs::create_dir_all(folder_of(&to))?;
            // The folder may be a disk of its own.
            fs::rename(&from, &to).or_else(|_| fs::copy(&from, &to).map(drop))?;
        }
        for path in stale.iter().map(|name| self.path.join(name)) {
            fs::remove_file(&path)?;
            let _ = fs::remove_dir(folder_of(&path));
        }
        sync(&self.path);
        fs::remove_dir_all(&self.part)
    }

    fn carry(&self, from: &Path, to: &Path) -> io::Result<bool> {
        let names: Vec<_> = entries(from)?.into_iter().filter(|name| !(self.is_ours)(from, name)).collect();
        for name in names.iter().take(MOST_CARRIED) {
            let (source, target) = (from.join(name), to.join(name));
            if source.is_dir() && !source.is_symlink() {
                fs::create_dir_all(target)?;
            } else if target.symlink_metadata().is_err() {
                fs::create_dir_all(folder_of(&target))?;
                fs::hard_link(source, target)?;
            }
        }
        Ok(names.len() <= MOST_CARRIED)
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.part);
    }
}

fn part_and_lock(folder: &Path) -> io::Result<(PathBuf, Lock)> {
    Ok((hidden(folder, "part")?, Lock::take(&hidden(folder, "lock")?)?))
}

fn entries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    fn add(folder: &Path, inside: &Path, found: &mut Vec<PathBuf>) -> io::Result<()> {
        for entry in fs::read_dir(folder.join(inside))? {
            let entry = entry?;
            let (name, before) = (inside.join(entry.file_name()), found.len());
            if entry.file_type()?.is_dir() && (inside == Path::new("") || before <= MOST_CARRIED) {
                add(folder, &name, found)?;
            }
            if found.len() == before {
                found.push(name);
            }
        }
        Ok(())
    }
    let mut found = Vec::new();
    add(folder, Path::new(""), &mut found)?;
    Ok(found)
}

#[cfg(any(target_os = "linux", target_os = "macos"))]
fn exchange(a: &Path, b: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    Ok(renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE)?)
}

#[cfg(not(any(target_os = "linux", target_os = "macos")))]
fn exchange(_: &Path, _: &Path) -> io::Result<()> {
    Err(ErrorKind::Unsupported.into())
}

fn sync(folder: &Path) {
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

fn unchanged(error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{error}; the earlier results are as they were"))
}
