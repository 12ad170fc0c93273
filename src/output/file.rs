//! Files that appear complete or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
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

/// Writes `bytes` to `path` by way of a temporary neighbour that is renamed; missing folders are created.
///
/// # Errors
/// When a folder or the file cannot be written. A file that was there before then keeps its content.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    replace(path, bytes).map_err(|source| WriteError { path: path.to_owned(), source })
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let name = name(path)?;
    let dir = or_here(path.parent().unwrap_or(Path::new("")));
    fs::create_dir_all(dir)?;
    let temporary = temporary(dir, &name);
    let mut file = File::create(&temporary)?;
    file.write_all(bytes).and_then(|()| fs::rename(&temporary, path)).inspect_err(|_| {
        let _ = fs::remove_file(&temporary);
    })
}

/// Whether a file could be written to `path`: found out without leaving anything behind.
///
/// # Errors
/// When a folder stands there, a part of the way to it is no folder, or nothing may be made there.
pub fn can_write(path: &Path) -> Result<(), WriteError> {
    probe(path).map_err(|source| WriteError { path: path.to_owned(), source })
}

/// Removes from `dir` the files that are `ours` by their names, but those just written.
///
/// # Errors
/// When a file cannot be removed.
pub fn remove_others(dir: &Path, written: &[PathBuf], ours: impl Fn(&str) -> bool) -> Result<(), WriteError> {
    let Ok(entries) = fs::read_dir(dir) else { return Ok(()) };
    for path in entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file() && !written.contains(path)) {
        if path.file_name().and_then(|name| name.to_str()).is_some_and(&ours) {
            fs::remove_file(&path).map_err(|source| WriteError { path, source })?;
        }
    }
    Ok(())
}

fn probe(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory));
    }
    name(path)?;
    // What is missing of the way can be made where the nearest folder that is there may be written to.
    let there = path.ancestors().skip(1).map(or_here).find(|dir| dir.symlink_metadata().is_ok());
    let probe = temporary(there.unwrap_or(Path::new(".")), "probe");
    File::create_new(&probe)?;
    fs::remove_file(&probe)
}

/// A neighbour's name that no one else uses.
fn temporary(dir: &Path, name: &str) -> PathBuf {
    dir.join(format!(".{name}.{}.part", std::process::id()))
}

fn name(path: &Path) -> io::Result<String> {
    let name = path.file_name().ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "not a file name"))?;
    Ok(name.to_string_lossy().into_owned())
}

/// The folder of a bare file name is the present one.
fn or_here(dir: &Path) -> &Path {
    if dir.as_os_str().is_empty() { Path::new(".") } else { dir }
}
