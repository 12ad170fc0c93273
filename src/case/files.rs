//! Files that a case needs: on the disk, or in memory.
//!
//! | what is read | at most |
//! |---|---|
//! | case file | [`CASE`] = 2 MB |
//! | CSV of a profile, a temperature or a reference, `sources.toml` | [`CSV`] = 10 MB, 100 000 rows of 10 kB, 2000 points of a profile |
//! | drawing | `import::LARGEST` = 50 MB, 200 000 entities, a million points, 5000 lines and arcs of a tool |
//!
//! Larger files are refused before they are read, and so are pipes and devices, which may never end.

use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

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
    /// The whole of a file, of `limit` bytes at most.
    ///
    /// # Errors
    /// When there is no such file, it is not a file, or it is larger.
    fn read(&self, path: &Path, limit: usize) -> Result<Vec<u8>, FileError>;
}

/// Reason why a file is not read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FileError {
    /// No file of this name.
    #[error("there is no such file")]
    Missing,
    /// A folder has this name.
    #[error("it is a folder")]
    Folder,
    /// Pipe or device.
    #[error("it is a pipe or a device, not a file")]
    Special,
    /// It is larger than may be read.
    #[error("it is larger than {} MB", limit / 1_000_000)]
    TooLarge {
        /// Largest size that is read \[bytes\].
        limit: usize,
    },
    /// Its bytes are no UTF-8.
    #[error("it is not UTF-8 text")]
    NotText,
    /// In the words of the system.
    #[error("{0}")]
    Other(String),
}

impl FileError {
    /// Remedy; `otherwise` if the error has none.
    pub fn remedy(&self, otherwise: &str) -> String {
        match self {
            Self::NotText => "save it as UTF-8: in Excel as \"CSV UTF-8\", in Notepad by its choice of encoding".into(),
            _ => otherwise.to_owned(),
        }
    }
}

impl From<io::Error> for FileError {
    fn from(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::NotFound { Self::Missing } else { Self::Other(error.to_string()) }
    }
}

impl dyn Files + '_ {
    /// The whole of a text file.
    ///
    /// # Errors
    /// Those of [`Files::read`], and when it is not UTF-8.
    pub fn text(&self, path: &Path, limit: usize) -> Result<String, FileError> {
        String::from_utf8(self.read(path, limit)?).map_err(|_| FileError::NotText)
    }
}

/// The files of the disk.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path, limit: usize) -> Result<Vec<u8>, FileError> {
        // Opening a pipe waits for someone to write into it.
        let about = fs::metadata(path)?;
        match about.is_dir() {
            true => return Err(FileError::Folder),
            false if !about.is_file() => return Err(FileError::Special),
            false => {}
        }
        // Some files are longer than they say.
        let (mut bytes, too_large) = (Vec::new(), FileError::TooLarge { limit });
        if about.len() <= limit as u64 {
            File::open(path)?.take(limit as u64 + 1).read_to_end(&mut bytes)?;
        }
        if about.len().max(bytes.len() as u64) > limit as u64 { Err(too_large) } else { Ok(bytes) }
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
    fn read(&self, path: &Path, limit: usize) -> Result<Vec<u8>, FileError> {
        let bytes = self.0.get(&plain(path)).ok_or(FileError::Missing)?;
        if bytes.len() > limit { Err(FileError::TooLarge { limit }) } else { Ok(bytes.clone()) }
    }
}

/// Files that note the paths of those that are read, in order.
pub(super) struct Noted<'a> {
    pub files: &'a dyn Files,
    pub paths: RefCell<Vec<PathBuf>>,
}

impl Files for Noted<'_> {
    fn read(&self, path: &Path, limit: usize) -> Result<Vec<u8>, FileError> {
        self.files.read(path, limit).inspect(|_| self.paths.borrow_mut().push(path.to_owned()))
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

/// Files, and the folder that those of a case are looked up from.
#[derive(Clone, Copy)]
pub(crate) struct Folder<'a> {
    pub files: &'a dyn Files,
    pub path: &'a Path,
}

/// The text with what a terminal would obey written as its code: a title that holds an escape shows `\u001b`.
///
/// Codes are those of JSON and TOML, so that a JSON text stays one. Ends of lines and tabs are left alone.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(is_obeyed) {
        return Cow::Borrowed(text);
    }
    let shown = |(at, c): (usize, char)| match c {
        '\r' if text[at..].starts_with("\r\n") => "\r".to_owned(),
        c if is_obeyed(c) => format!("\\u{:04x}", u32::from(c)),
        c => c.to_string(),
    };
    Cow::Owned(text.char_indices().map(shown).collect())
}

/// Control characters, and those that turn the direction of writing or end a line where none is seen to end.
fn is_obeyed(c: char) -> bool {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || c.is_control() && c != '\n' && c != '\t'
}
