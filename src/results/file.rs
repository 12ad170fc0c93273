//! Single files that are replaced whole or not at all, and the lock of a folder.

use std::{fs, fs::File, fs::TryLockError, io, io::ErrorKind, io::Write, path::Path, path::PathBuf};

/// Failure to write a file or folder; what stood there before is untouched.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}", path.display())]
pub struct WriteError {
    /// The file or folder.
    pub path: PathBuf,
    /// The system's error.
    pub source: io::Error,
}

impl WriteError {
    pub(super) fn new(path: impl Into<PathBuf>, source: io::Error) -> Self {
        Self { path: path.into(), source }
    }
}

/// Writes a file by renaming a complete neighbour `.name.part`; makes missing folders. A failure keeps an earlier file.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    let replace = || {
        let part = hidden(path, "part")?;
        let lock = Lock::wait(&part)?;
        fill(&lock.file, bytes)?;
        lock.file.sync_all()?;
        fs::rename(&part, path)
    };
    replace().map_err(|source| WriteError::new(path, source))
}

/// Checks that [`write()`] could write a file; leaves nothing behind.
pub fn can_write(path: &Path) -> Result<(), WriteError> {
    let probe = || {
        if path.is_dir() {
            return Err(ErrorKind::IsADirectory.into());
        }
        let part = hidden(path, "part")?;
        let _folders = NewFolders::make(folder_of(path))?;
        can_replace(path)?;
        Lock::wait(&part).map(drop)
    };
    probe().map_err(|source| WriteError::new(path, source))
}

/// Refuses a file that is write-protected or, on Windows, held by another program; opening it for writing changes nothing.
pub(super) fn can_replace(path: &Path) -> io::Result<()> {
    let opened = if path.is_file() { File::options().append(true).open(path).map(drop) } else { Ok(()) };
    let remedy = "it is write-protected or open in another program: close it and run again; nothing was changed";
    opened.map_err(|error| io::Error::new(error.kind(), format!("{}: {error}; {remedy}", path.display())))
}

pub(super) fn fill(mut file: &File, bytes: &[u8]) -> io::Result<()> {
    let written = file.set_len(0).and_then(|()| file.write_all(bytes));
    written.map_err(|error| io::Error::new(error.kind(), format!("{error} ({} kB to write)", bytes.len() / 1000 + 1)))
}

/// `out/.cup.part` of `out/cup`.
pub(crate) fn hidden(path: &Path, ending: &str) -> io::Result<PathBuf> {
    let name = path.file_name().ok_or_else(|| io::Error::new(ErrorKind::InvalidInput, "not a file name"))?;
    Ok(folder_of(path).join(format!(".{}.{ending}", name.to_str().ok_or(ErrorKind::InvalidFilename)?)))
}

pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// File that one process holds at a time; removed when dropped, freed by the system when the process is killed.
#[derive(Debug)]
pub(crate) struct Lock {
    path: PathBuf,
    pub(super) file: File,
}

impl Lock {
    /// Takes the lock, or fails with [`ErrorKind::ResourceBusy`] if another process has it.
    pub fn take(path: &Path) -> io::Result<Self> {
        let lock = Self::with(path, File::try_lock)?;
        fill(&lock.file, std::process::id().to_string().as_bytes())?;
        Ok(lock)
    }

    /// Takes the lock as soon as it is free; makes missing folders.
    pub fn wait(path: &Path) -> io::Result<Self> {
        Self::with(path, |file| file.lock().map_err(TryLockError::Error))
    }

    fn with(path: &Path, lock: impl Fn(&File) -> Result<(), TryLockError>) -> io::Result<Self> {
        let open = || File::options().read(true).write(true).create(true).truncate(false).open(path);
        loop {
            // Another process may have removed the empty folder that it made.
            let file = open().or_else(|_| fs::create_dir_all(folder_of(path)).and_then(|()| open()))?;
            match lock(&file) {
                Err(TryLockError::WouldBlock) => {
                    let process = fs::read_to_string(path).ok().filter(|process| !process.is_empty());
                    let process = process.map_or_else(String::new, |process| format!(" (process {process})"));
                    let message = format!("another run{process} is writing there");
                    return Err(io::Error::new(ErrorKind::ResourceBusy, message));
                }
                // Some network file systems have no locks.
                Err(TryLockError::Error(error)) if error.kind() != ErrorKind::Unsupported => return Err(error),
                _ => {}
            }
            // The process that had it may have removed the file meanwhile.
            if is_at(&file, path) {
                return Ok(Self { path: path.to_owned(), file });
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        if is_at(&self.file, &self.path) {
            let _ = fs::remove_file(&self.path);
        }
    }
}

#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |a: fs::Metadata, b: fs::Metadata| (a.dev(), a.ino()) == (b.dev(), b.ino());
    file.metadata().and_then(|ours| Ok(same(ours, fs::metadata(path)?))).unwrap_or(false)
}

#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}

/// Folders made for a path; those still empty are removed when this is dropped.
#[derive(Debug)]
pub(crate) struct NewFolders(Vec<PathBuf>);

impl NewFolders {
    pub fn make(folder: &Path) -> io::Result<Self> {
        let missing = folder.ancestors().take_while(|dir| !dir.as_os_str().is_empty() && !dir.exists());
        let made = Self(missing.map(Path::to_owned).collect());
        fs::create_dir_all(folder)?;
        Ok(made)
    }
}

impl Drop for NewFolders {
    fn drop(&mut self) {
        self.0.iter().for_each(|dir| _ = fs::remove_dir(dir));
    }
}
