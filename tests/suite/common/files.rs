//! The files of a folder.

use std::path::{Path, PathBuf};

/// Files of that ending in a folder of the project and the folders below it.
pub fn below(folder: &str, ending: &str) -> Vec<PathBuf> {
    let (mut folders, mut found) = (vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)], Vec::new());
    while let Some(folder) = folders.pop() {
        found.extend(files(&folder, ending));
        folders.extend(files(&folder, "").into_iter().filter(|path| path.is_dir()));
    }
    found
}

/// Files of that ending in alphabetical order; without an ending, everything there is.
pub fn files(folder: impl AsRef<Path>, ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder exists");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    files.retain(|path| ending.is_empty() || path.extension().is_some_and(|e| e == ending));
    files.sort();
    files
}
