//! How long each design took: beside the table, which is the same on any machine.

use super::StudyError;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

const HEADER: &str = "index,wall_s\n";

/// `study_times.csv`, a row as each design is done; of one that was done twice the later row counts.
#[derive(Debug)]
pub struct Times(File);

impl Times {
    /// Goes on with what is there where rows are `kept`, else begins anew.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn open(path: &Path, kept: bool) -> Result<Self, StudyError> {
        let open = || -> io::Result<Self> {
            let mut file = OpenOptions::new().append(true).create(true).open(path)?;
            if !kept {
                file.set_len(0)?;
            }
            if file.metadata()?.len() == 0 {
                file.write_all(HEADER.as_bytes())?;
            }
            Ok(Self(file))
        };
        open().map_err(|error| {
            StudyError::new(format!("cannot write {}: {error}", path.display()), "choose another place with --out")
        })
    }

    /// Adds a design and the time that it took \[s\].
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, index: u64, seconds: f64) -> io::Result<()> {
        self.0.write_all(format!("{index},{seconds:.6}\n").as_bytes())
    }
}
