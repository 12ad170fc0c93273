//! Every output of a solution, written to its folder.

use super::{FrameRecorder, Make, OUTPUTS, Results, StageView, WriteError, can_write, overlay, remove_others, write};
use crate::case::Solution;
use crate::compare::CompareError;
use std::path::{Path, PathBuf};

/// Why results could not be written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// A file or folder cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// A reference that the case is compared with cannot be used.
    #[error(transparent)]
    Compare(#[from] CompareError),
}

impl Solution {
    /// Writes every table and plot of [`OUTPUTS`] into `dir`, those of several stages into a folder each, and removes what
    /// an earlier run left there; returns what was written.
    ///
    /// # Errors
    /// When a folder or file cannot be written, or a reference of the case cannot be read.
    pub fn write(&self, dir: impl AsRef<Path>) -> Result<Vec<PathBuf>, OutputError> {
        Ok(Results::of(self)?.write(&FrameRecorder::default(), dir.as_ref())?)
    }
}

impl Results<'_> {
    /// Writes as [`Solution::write`], with what a recorder was asked for.
    ///
    /// # Errors
    /// When a folder or file cannot be written: each file appears complete or not at all.
    pub fn write(&self, recorder: &FrameRecorder, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
        let mut written = Vec::new();
        let mut here = Vec::new();
        for output in OUTPUTS {
            if let Make::OfCase(make) = output.make {
                here.extend(write_files(make(self), dir)?);
            }
        }
        let case = &self.solution.case;
        for (i, _) in case.stage_names().enumerate() {
            let label = case.stage_label(i);
            let folder = label.as_ref().map_or_else(|| dir.to_owned(), |label| dir.join(label));
            let files = self.views.get(i).map_or(Ok(Vec::new()), |view| write_stage(view, i, recorder, &folder))?;
            if label.is_none() {
                here.extend(files);
            } else {
                remove_stale(&folder, &files)?;
                written.extend(files);
            }
        }
        remove_stale(dir, &here)?;
        written.extend(here);
        Ok(written)
    }

    /// Writes comparisons only.
    ///
    /// # Errors
    /// When a folder or file cannot be written.
    pub fn write_comparisons(&self, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_files(overlay::files(self), dir)
    }
}

impl StageView<'_> {
    /// Writes every table and plot of this stage into `dir`; returns what was written.
    ///
    /// # Errors
    /// When a folder or file cannot be written: each file appears complete or not at all.
    pub fn write(&self, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_stage(self, 0, &FrameRecorder::default(), dir)
    }
}

/// Writes what a stage has.
fn write_stage(view: &StageView, i: usize, recorder: &FrameRecorder, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let frames = recorder.of_stage(i, view.stage);
    let mut written = Vec::new();
    for output in OUTPUTS {
        if let Make::Moving(extra, make) = output.make {
            if recorder.extras.contains(&extra) && frames.len() > 1 {
                written.extend(write_files(make(view, &frames), dir)?);
            }
        } else if let Some(bytes) = output.bytes(view) {
            written.extend(write_files(std::iter::once((output.file.to_owned(), bytes)), dir)?);
        }
    }
    Ok(written)
}

fn write_files(files: impl Iterator<Item = (String, Vec<u8>)>, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
    files.map(|(name, bytes)| write(&dir.join(&name), &bytes).map(|()| dir.join(name))).collect()
}

/// Whether every output could be written into `dir`; nothing is left behind.
///
/// # Errors
/// As [`can_write`].
pub fn can_write_all(dir: &Path) -> Result<(), WriteError> {
    OUTPUTS.iter().try_for_each(|output| can_write(&dir.join(output.file)))
}

/// Removes what an earlier run wrote into `dir` and this one did not, so that no plot of another run stands beside
/// `written`; files of names that this program does not give are left alone.
///
/// # Errors
/// When a file cannot be removed.
pub fn remove_stale(dir: &Path, written: &[PathBuf]) -> Result<(), WriteError> {
    remove_others(dir, written, |name| OUTPUTS.iter().any(|output| output.is_named(name)))
}
