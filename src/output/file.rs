//! Files that appear complete or not at all.

use super::{disk, lock};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// A file that could not be written; what stood there before is untouched.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}", path.display())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// What the system says.
    pub source: io::Error,
}

/// Writes `bytes` to `path` by way of a temporary neighbour that is renamed; missing folders are created. What a killed
/// process left of such a neighbour is used up.
///
/// # Errors
/// When a folder or the file cannot be written. A file that was there before then keeps its content.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    replace(path, bytes).map_err(|source| WriteError { path: path.to_owned(), source })
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let part = neighbour(path)?;
    disk::create_dir_all(folder_of(path))?;
    let file = lock::when_free(&part)?;
    let written = disk::fill(&file, bytes).and_then(|()| file.sync_all()).and_then(|()| disk::rename(&part, path));
    written.inspect_err(|_| _ = disk::remove_file(&part))
}

/// Whether a file could be written to `path`: found out by what [`write()`] does, without leaving anything behind.
///
/// # Errors
/// When a folder stands there, a part of the way to it is no folder, nothing may be made there, or a name is too long.
pub fn can_write(path: &Path) -> Result<(), WriteError> {
    probe(path).map_err(|source| WriteError { path: path.to_owned(), source })
}

fn probe(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    let part = neighbour(path)?;
    let _way = Way::to(folder_of(path))?;
    let _file = lock::when_free(&part)?;
    disk::remove_file(&part)
}

/// Removes from `dir` the files that are `ours` by their names, but those just written.
///
/// # Errors
/// When a file cannot be removed.
pub fn remove_others(dir: &Path, written: &[PathBuf], ours: impl Fn(&str) -> bool) -> Result<(), WriteError> {
    let Ok(entries) = fs::read_dir(dir) else { return Ok(()) };
    for path in entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file() && !written.contains(path)) {
        if path.file_name().and_then(|name| name.to_str()).is_some_and(&ours) {
            disk::remove_file(&path).map_err(|source| WriteError { path, source })?;
        }
    }
    Ok(())
}

/// Folders that were made on the way to one; those that are empty when this is dropped go again.
#[derive(Debug)]
pub(super) struct Way(Vec<PathBuf>);

impl Way {
    /// Makes a folder, and what is missing on the way to it.
    pub fn to(folder: &Path) -> io::Result<Self> {
        let mut way = Self(Vec::new());
        let missing: Vec<&Path> =
            folder.ancestors().take_while(|dir| !dir.as_os_str().is_empty() && !dir.exists()).collect();
        for dir in missing.into_iter().rev() {
            match disk::create_dir(dir) {
                Ok(()) => way.0.push(dir.to_owned()),
                // Another process goes the same way.
                Err(_) if dir.is_dir() => {}
                Err(error) => return Err(error),
            }
        }
        Ok(way)
    }
}

impl Drop for Way {
    fn drop(&mut self) {
        for dir in self.0.iter().rev() {
            let _ = disk::remove_dir(dir);
        }
    }
}

/// Where a file stands until it is complete.
pub(super) fn neighbour(path: &Path) -> io::Result<PathBuf> {
    let name = path.file_name().ok_or_else(|| io::Error::new(ErrorKind::InvalidInput, "not a file name"))?;
    let mut part = std::ffi::OsString::from(".");
    part.push(name);
    part.push(".part");
    Ok(folder_of(path).join(part))
}

/// The folder that a path stands in; of a bare name it is the present one.
pub(super) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|dir| !dir.as_os_str().is_empty()).unwrap_or(Path::new("."))
}
