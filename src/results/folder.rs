//! Folder of results that goes from one complete set of files to the next in one rename.
//!
//! | name beside `cup` | holds | left by a killed run |
//! |---|---|---|
//! | `.cup.lock` | number of the process that writes | taken over |
//! | `.cup.part` | results being written; after the exchange the earlier ones | removed |
//! | `.cup.ready`, `.cup.move` | complete results on their way into `cup` file by file | moved in |
//!
//! Files of other origin are hard-linked into the new set before the exchange. The set goes in file by file if folders cannot be
//! exchanged: no support by the system, a program standing in the folder (`--out .`), more than [`MOST_CARRIED`] other files.
//! If nothing can be made beside the folder (a mounted disk, a protected parent), the names stand inside it.

use super::file::{Lock, NewFolders, WriteError, can_write, fill, folder_of, hidden};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// More files of other origin than this are not linked at every run.
const MOST_CARRIED: usize = 2000;

/// Levels of folders that results may have: `1-draw/profile.csv`.
const RESULT_DEPTH: usize = 2;

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
    ready: PathBuf,
    moving: PathBuf,
    is_ours: IsOurs,
    written: Vec<PathBuf>,
    _lock: Lock,
    _parents: NewFolders,
}

impl ResultFolder {
    /// Locks a folder, which need not exist, and heals what a killed run left; fails if another process writes there.
    pub fn open(named: &Path, is_ours: IsOurs) -> Result<Self, WriteError> {
        let open = || {
            let named = if named.as_os_str().is_empty() { Path::new(".") } else { named };
            let parents = NewFolders::make(folder_of(named))?;
            let path = match named.symlink_metadata() {
                Ok(_) => fs::canonicalize(named)?,
                Err(_) => fs::canonicalize(folder_of(named))?.join(named.file_name().ok_or(ErrorKind::InvalidInput)?),
            };
            if path.exists() && !path.is_dir() {
                return Err(ErrorKind::NotADirectory.into());
            }
            let (names, lock) = locked(&path)?;
            let [part, ready, moving] = ["part", "ready", "move"].map(|ending| hidden(&names, ending));
            let (part, ready, moving) = (part?, ready?, moving?);
            let (named, written) = (named.to_owned(), Vec::new());
            let folder = Self { named, path, part, ready, moving, is_ours, written, _lock: lock, _parents: parents };
            folder.heal()?;
            if folder.path.exists() {
                can_write(&folder.path.join("probe")).map_err(|error| error.source)?;
            }
            Ok(folder)
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

    /// Replaces the earlier set by the new one and returns the paths of its files; after a failure the folder is as it was, or
    /// the next [`open`](Self::open) completes it.
    pub fn commit(self) -> Result<Vec<PathBuf>, WriteError> {
        self.replace().map_err(|source| WriteError::new(&self.named, source))?;
        Ok(self.written.iter().map(|name| self.named.join(name)).collect())
    }

    fn replace(&self) -> io::Result<()> {
        if self.written.is_empty() && !self.path.exists() {
            return Ok(());
        }
        fs::create_dir_all(&self.part)?;
        let synced = self.written.par_iter().try_for_each(|name| File::open(self.part.join(name))?.sync_all());
        synced.map_err(|error| unchanged(&error))?;
        sync(&self.part);
        if !self.path.exists() {
            fs::rename(&self.part, &self.path)?;
            sync(folder_of(&self.path));
            return Ok(());
        }
        fs::set_permissions(&self.part, fs::metadata(&self.path)?.permissions())?;
        if self.can_be_exchanged() {
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
        fs::rename(&self.part, &self.ready)?;
        self.heal()
    }

    /// Completes or removes what a killed run left.
    fn heal(&self) -> io::Result<()> {
        if self.ready.exists() {
            fs::create_dir_all(&self.path)?;
            let mut stale = entries(&self.path, RESULT_DEPTH)?;
            stale.retain(|name| (self.is_ours)(&self.path, name) && self.ready.join(name).symlink_metadata().is_err());
            // The list of stages in the folder itself decides whose the files below are: it goes last.
            stale.sort_by_key(|name| Reverse(name.components().count()));
            for path in stale.iter().map(|name| self.path.join(name)) {
                fs::remove_file(&path)?;
                let _ = fs::remove_dir(folder_of(&path));
            }
            fs::rename(&self.ready, &self.moving)?;
        }
        if self.moving.exists() {
            fs::create_dir_all(&self.path)?;
            for name in entries(&self.moving, usize::MAX)? {
                let to = self.path.join(&name);
                fs::create_dir_all(folder_of(&to))?;
                fs::rename(self.moving.join(&name), to)?;
            }
            sync(&self.path);
            fs::remove_dir_all(&self.moving)?;
        }
        if self.part.exists() { fs::remove_dir_all(&self.part) } else { Ok(()) }
    }

    fn can_be_exchanged(&self) -> bool {
        let stands_in = std::env::current_dir().is_ok_and(|here| here.starts_with(&self.path));
        !stands_in && !self.part.starts_with(&self.path)
    }

    /// Links files of other origin that the target has not; false if they are too many.
    fn carry(&self, from: &Path, to: &Path) -> io::Result<bool> {
        let names = entries(from, usize::MAX)?;
        for name in names.iter().filter(|name| !(self.is_ours)(from, name)).take(MOST_CARRIED) {
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

/// Takes the lock beside a folder, or inside it if nothing can be made beside it; also the path whose hidden names are used.
fn locked(path: &Path) -> io::Result<(PathBuf, Lock)> {
    let inside = path.join(env!("CARGO_PKG_NAME"));
    let beside = match path.file_name() {
        Some(_) if !path.exists() || device(path)? == device(folder_of(path))? => Lock::take(&hidden(path, "lock")?),
        _ => Err(ErrorKind::InvalidInput.into()),
    };
    match beside {
        Err(error) if path.is_dir() && error.kind() != ErrorKind::ResourceBusy => {
            Ok((inside.clone(), Lock::take(&hidden(&inside, "lock")?)?))
        }
        lock => Ok((path.to_owned(), lock?)),
    }
}

/// Paths of files, links and empty folders below a folder, down to a number of levels.
fn entries(folder: &Path, depth: usize) -> io::Result<Vec<PathBuf>> {
    let (mut found, mut folders) = (Vec::new(), vec![PathBuf::new()]);
    while let Some(inside) = folders.pop() {
        let mut is_empty = inside != Path::new("");
        for entry in fs::read_dir(folder.join(&inside))? {
            let entry = entry?;
            let name = inside.join(entry.file_name());
            is_empty = false;
            if !entry.file_type()?.is_dir() {
                found.push(name);
            } else if name.components().count() < depth && found.len() <= MOST_CARRIED {
                folders.push(name);
            }
        }
        if is_empty {
            found.push(inside);
        }
    }
    Ok(found)
}

#[cfg(unix)]
fn device(path: &Path) -> io::Result<u64> {
    Ok(std::os::unix::fs::MetadataExt::dev(&fs::metadata(path)?))
}

#[cfg(not(unix))]
fn device(_: &Path) -> io::Result<u64> {
    Ok(0)
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

/// Flushes a folder's names to the disk, if the system can.
fn sync(folder: &Path) {
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

fn unchanged(error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{error}; the earlier results are as they were"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: each state is what a killed run leaves at one step of `replace`; `2` are complete new results.
    #[test]
    fn what_a_killed_run_left_is_healed_and_other_files_stay() {
        let old = [("cup/r-a", "1"), ("cup/s/r-b", "1"), ("cup/note", "mine"), ("cup/s/photo", "mine")];
        let (kept, new) = (["r-a=1", "s/r-b=1"].as_slice(), ["r-a=2"].as_slice());
        for (left, results) in [
            (&[][..], kept),
            (&[(".cup.part/r-a", "half"), (".cup.part/note", "mine")], kept),
            (&[(".cup.ready/r-a", "2")], new),
            (&[(".cup.ready/r-a", "2"), (".cup.ready/note", "mine"), (".cup.lock", "1")], new),
            (&[(".cup.move/r-a", "2")], &["r-a=2", "s/r-b=1"]),
        ] {
            let root = temp_dir::TempDir::new().unwrap();
            for (name, text) in old.iter().chain(left) {
                fs::create_dir_all(folder_of(&root.path().join(name))).unwrap();
                fs::write(root.path().join(name), text).unwrap();
            }
            let (cup, is_ours) =
                (root.path().join("cup"), |_: &Path, path: &Path| !path.ends_with("note") && !path.ends_with("photo"));
            drop(ResultFolder::open(&cup, is_ours).unwrap());
            let mut expected = [results, &["note=mine", "s/photo=mine"]].concat();
            expected.sort_unstable();
            let text = |name: &PathBuf| fs::read_to_string(cup.join(name)).unwrap();
            let found = entries(&cup, 9).unwrap();
            let mut found: Vec<_> = found.iter().map(|name| format!("{}={}", name.display(), text(name))).collect();
            found.sort();
            assert_eq!(found, expected, "{left:?}");
            assert_eq!(fs::read_dir(root.path()).unwrap().count(), 1, "{left:?} leaves litter");
        }
    }
}
