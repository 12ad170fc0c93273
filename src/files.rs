//! Files that a case or a drawing needs: on the disk, or in memory.
//!
//! Larger files than [`CASE`] and [`CSV`] are refused before they are read, and so are pipes and devices.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::{Component, Path, PathBuf};
use std::{borrow::Cow, collections::BTreeMap};

/// The largest case file \[bytes\]; a thousand times the size of a long one.
pub const CASE: usize = 2_000_000;
/// The largest CSV file \[bytes\].
pub const CSV: usize = 10_000_000;

/// SHA-256 of some bytes, one part after the other, in hex digits.
#[cfg(feature = "app")]
pub fn sha256(parts: impl IntoIterator<Item = impl AsRef<[u8]>>) -> String {
    use sha2::{Digest, Sha256};
    let hash = parts.into_iter().fold(Sha256::new(), |hash, bytes| hash.chain_update(bytes));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Files by their paths.
pub trait Files {
    /// Bytes of a file, of `limit` at most. Fails when there is no such file, it is a folder, pipe or device, or larger.
    fn read(&self, path: &Path, limit: usize) -> io::Result<Vec<u8>>;

    /// Text of a file. Fails as [`Files::read`], and when it is not UTF-8.
    fn text(&self, path: &Path, limit: usize) -> io::Result<String> {
        let no_text = |_| io::Error::new(ErrorKind::InvalidData, "it is not UTF-8 text");
        String::from_utf8(self.read(path, limit)?).map_err(no_text)
    }
}

/// Remedy for a file that cannot be read; `otherwise` if the error has none.
pub fn remedy(error: &io::Error, otherwise: &str) -> String {
    let utf8 = "save it as UTF-8: in Excel as \"CSV UTF-8\", in Notepad by its choice of encoding";
    if error.kind() == ErrorKind::InvalidData { utf8 } else { otherwise }.to_owned()
}

pub(crate) fn too_large(limit: usize) -> io::Error {
    io::Error::new(ErrorKind::FileTooLarge, format!("it is larger than {} MB", limit / 1_000_000))
}

fn missing() -> io::Error {
    io::Error::new(ErrorKind::NotFound, "there is no such file")
}

/// The files of the disk.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path, limit: usize) -> io::Result<Vec<u8>> {
        // Opening a pipe waits for someone to write into it.
        let about = fs::metadata(path).map_err(|e| if e.kind() == ErrorKind::NotFound { missing() } else { e })?;
        if about.is_dir() {
            return Err(io::Error::new(ErrorKind::IsADirectory, "it is a folder"));
        } else if !about.is_file() {
            return Err(io::Error::other("it is a pipe or a device, not a file"));
        }
        // Some files are longer than their length.
        let mut bytes = Vec::new();
        if about.len() <= limit as u64 {
            File::open(path)?.take(limit as u64 + 1).read_to_end(&mut bytes)?;
        }
        if about.len().max(bytes.len() as u64) > limit as u64 { Err(too_large(limit)) } else { Ok(bytes) }
    }
}

/// Files in memory. `cases/../a.csv` is `a.csv`.
#[derive(Clone, Debug, Default)]
pub struct Memory(BTreeMap<PathBuf, Vec<u8>>);

impl Memory {
    /// Adds a file, or replaces the one of that path.
    pub fn insert(&mut self, path: impl AsRef<Path>, bytes: impl Into<Vec<u8>>) {
        self.0.insert(plain(path.as_ref()), bytes.into());
    }
}

impl Files for Memory {
    fn read(&self, path: &Path, limit: usize) -> io::Result<Vec<u8>> {
        let bytes = self.0.get(&plain(path)).ok_or_else(missing)?;
        if bytes.len() > limit { Err(too_large(limit)) } else { Ok(bytes.clone()) }
    }
}

/// A path without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut plain, component| {
        match component {
            Component::CurDir => {}
            Component::ParentDir if plain.file_name().is_some() => drop(plain.pop()),
            other => plain.push(other),
        }
        plain
    })
}

#[derive(Clone, Copy)]
pub(crate) struct Folder<'a> {
    pub files: &'a dyn Files,
    pub path: &'a Path,
}

/// Text with control characters as their code: a title that holds an escape shows `\u001b`, as JSON and TOML write it.
///
/// Ends of lines and tabs are left alone.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(is_control) {
        return Cow::Borrowed(text);
    }
    let shown = |(at, c): (usize, char)| match c {
        '\r' if text[at..].starts_with("\r\n") => "\r".to_owned(),
        c if is_control(c) => format!("\\u{:04x}", u32::from(c)),
        c => c.to_string(),
    };
    Cow::Owned(text.char_indices().map(shown).collect())
}

/// Control characters, and those that turn the direction of writing or end a line.
fn is_control(c: char) -> bool {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || c.is_control() && c != '\n' && c != '\t'
}
