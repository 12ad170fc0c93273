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

#[cfg(test)]
mod tests {
    use super::*;

    fn names(dir: &Path) -> Vec<String> {
        let mut names: Vec<_> =
            fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_is_replaced_and_its_neighbours_are_left_alone() {
        let dir = temp_dir::TempDir::new().unwrap();
        let path = dir.path().join("deep/er/a.csv");
        write(&path, b"old").unwrap();
        fs::write(path.with_file_name("mine.txt"), "mine").unwrap();
        write(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(names(path.parent().unwrap()), ["a.csv", "mine.txt"]);
    }

    /// Trust: the rename is made to fail (a folder stands where the file should go) after the bytes were written.
    #[test]
    fn a_failure_leaves_neither_half_a_file_nor_a_changed_one() {
        let dir = temp_dir::TempDir::new().unwrap();
        let taken = dir.path().join("a.csv");
        fs::create_dir(&taken).unwrap();
        fs::write(taken.join("inside"), "old").unwrap();
        let error = write(&taken, b"new").unwrap_err();
        assert!(error.to_string().contains("a.csv"), "{error}");
        assert_eq!(fs::read(taken.join("inside")).unwrap(), b"old");
        assert_eq!(names(dir.path()), ["a.csv"]);
    }

    #[test]
    fn what_cannot_be_written_is_known_before() {
        let dir = temp_dir::TempDir::new().unwrap();
        fs::write(dir.path().join("file"), "mine").unwrap();
        for (path, can) in
            [("a.csv", true), ("deep/er/a.csv", true), ("file", true), ("file/a.csv", false), ("", false)]
        {
            assert_eq!(can_write(&dir.path().join(path)).is_ok(), can, "{path}");
            assert_eq!(names(dir.path()), ["file"], "{path} left something behind");
        }
    }

    #[test]
    fn a_temporary_file_that_cannot_be_made_leaves_the_old_file_intact() {
        let dir = temp_dir::TempDir::new().unwrap();
        let path = dir.path().join("a.csv");
        write(&path, b"old").unwrap();
        fs::create_dir(dir.path().join(format!(".a.csv.{}.part", std::process::id()))).unwrap();
        write(&path, b"new").unwrap_err();
        assert_eq!(fs::read(&path).unwrap(), b"old");
    }
}
