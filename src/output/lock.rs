//! Files that one process at a time has. The system lets go of them when that process ends, however it ends, so that a
//! killed one never keeps another waiting.

use super::disk;
use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind, Read, Seek};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How often, and how long after each other, a lock is asked whose it is: half a second in all.
const TRIES: usize = 100;
const PAUSE: Duration = Duration::from_millis(5);

/// A file that says which process writes beside it; it goes when this is dropped.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Takes it.
    ///
    /// # Errors
    /// [`ErrorKind::ResourceBusy`] where another process has it, with that process's id.
    pub fn take(path: &Path) -> io::Result<Self> {
        Self::with(path, locked(path, File::try_lock)?)
    }

    /// Takes it when no other process has it.
    pub fn wait(path: &Path) -> io::Result<Self> {
        Self::with(path, when_free(path)?)
    }

    fn with(path: &Path, file: File) -> io::Result<Self> {
        let lock = Self { path: path.to_owned(), file };
        disk::fill(&lock.file, format!("{}\n", std::process::id()).as_bytes())?;
        Ok(lock)
    }

    /// Whether it still stands where it was taken, and not another that came after someone removed it.
    pub fn stands(&self) -> bool {
        is_at(&self.file, &self.path)
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        if self.stands() {
            let _ = disk::remove_file(&self.path);
        }
    }
}

/// A file, made if need be, that no other process has.
pub fn when_free(path: &Path) -> io::Result<File> {
    locked(path, |file| file.lock().map_err(TryLockError::Error))
}

fn locked(path: &Path, lock: impl Fn(&File) -> Result<(), TryLockError>) -> io::Result<File> {
    loop {
        let file = disk::open(path)?;
        match lock(&file) {
            Err(TryLockError::WouldBlock) => return Err(busy(file)),
            // Some file systems of networks have no locks: runs into one folder are not kept apart there.
            Err(TryLockError::Error(error)) if error.kind() != ErrorKind::Unsupported => return Err(error),
            _ => {}
        }
        // Whoever had it may have removed it meanwhile.
        if is_at(&file, path) {
            return Ok(file);
        }
    }
}

/// What to say of a file that another process has.
fn busy(mut file: File) -> io::Error {
    let mut line = String::new();
    // Whoever has just taken it has not yet said who it is, or is about to: its line has no end.
    for _ in 0..TRIES {
        line.clear();
        let read = file.rewind().and_then(|()| file.read_to_string(&mut line));
        if read.is_err() || line.ends_with('\n') {
            break;
        }
        std::thread::sleep(PAUSE);
    }
    let who = match line.strip_suffix('\n') {
        Some(process) => format!("another run, process {process},"),
        None => "another run".to_owned(),
    };
    io::Error::new(ErrorKind::ResourceBusy, format!("{who} is writing there"))
}

/// Whether an open file is the one of that path.
fn is_at(file: &File, path: &Path) -> bool {
    file.metadata().and_then(|ours| Ok(is_same(&ours, &fs::metadata(path)?))).unwrap_or(false)
}

/// Whether two names are those of one file.
#[cfg(unix)]
pub fn is_same(a: &fs::Metadata, b: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

/// Elsewhere an open file cannot be removed under its name.
#[cfg(not(unix))]
pub fn is_same(_: &fs::Metadata, _: &fs::Metadata) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::{Lock, PAUSE};
    use std::fs::{self, File};
    use std::io::Write;

    /// Whoever reads while the first half of the number stands there waits for the other.
    #[test]
    fn who_has_it_is_said_by_the_whole_number() {
        let dir = temp_dir::TempDir::new().unwrap();
        let path = dir.path().join("lock");
        let mut first = File::create(&path).unwrap();
        first.lock().unwrap();
        first.write_all(b"123").unwrap();
        std::thread::scope(|scope| {
            let second = scope.spawn(|| Lock::take(&path).unwrap_err());
            std::thread::sleep(4 * PAUSE);
            first.write_all(b"45\n").unwrap();
            assert_eq!(second.join().unwrap().to_string(), "another run, process 12345, is writing there");
        });
        drop(first);
        let taken = Lock::take(&path).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), format!("{}\n", std::process::id()));
        drop(taken);
        assert!(!path.exists());
    }
}
