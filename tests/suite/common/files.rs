//! The files of a folder.

use std::path::{Path, PathBuf};

/// Files of that ending in alphabetical order; without an ending, everything there is.
pub fn files(folder: impl AsRef<Path>, ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder exists");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    files.retain(|path| ending.is_empty() || path.extension().is_some_and(|e| e == ending));
    files.sort();
    files
}
