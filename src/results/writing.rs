//! Every output of a solution, written to its folder.

use super::{FrameRecorder, Make, OUTPUTS, ResultFolder, Results, StageView, WriteError, stages};
use crate::case::files::{Disk, Files};
use crate::case::{Case, Solution};
use crate::compare::CompareError;
use crate::plot::overlay;
use crate::study::verify::answered;
use std::fs;
use std::io::{self, ErrorKind};
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

/// Whether a file of this name in a folder of results is written by a run.
pub fn is_result(name: &str) -> bool {
    OUTPUTS.iter().any(|output| output.is_named(name))
}

/// What a report of ours contains.
pub const REPORT_MARKER: &str = concat!(env!("CARGO_PKG_NAME"), " report, version");
/// A report is a few MB \[bytes\].
const LARGEST_REPORT: usize = 100_000_000;

/// Whether a file is a report of ours, whatever its name.
pub fn is_report(path: &Path) -> bool {
    let marked = |bytes: Vec<u8>| bytes.windows(REPORT_MARKER.len()).any(|part| part == REPORT_MARKER.as_bytes());
    Disk.read(path, LARGEST_REPORT).is_ok_and(marked)
}

/// Results by their names, in the folder and those of its stages, and reports on them.
fn belongs_to_run(folder: &Path, path: &Path) -> bool {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    match path.parent().and_then(Path::to_str) {
        Some("") => is_result(name) || name.starts_with("report.") && is_report(&folder.join(path)),
        Some(stage) if is_result(name) => {
            let list = fs::read_to_string(folder.join(stages::FILE)).unwrap_or_default();
            stages::folders(&list).iter().any(|listed| listed == stage)
        }
        _ => false,
    }
}

/// Opens the folder for the results of a run.
///
/// # Errors
/// As [`ResultFolder::open`]; also if a file there has the name of a result, but no run has written it.
pub fn result_folder(case: &Case, dir: &Path) -> Result<ResultFolder, WriteError> {
    let folder = ResultFolder::open(dir, belongs_to_run)?;
    let stages = (0..).map_while(|i| case.stage_label(i)).map(|label| dir.join(label));
    std::iter::once(dir.to_owned()).chain(stages).try_for_each(|dir| refuse_others(&dir))?;
    Ok(folder)
}

/// Opens a folder for comparisons only, which may hold the results of a run.
///
/// # Errors
/// As [`ResultFolder::open`].
pub fn comparison_folder(dir: &Path) -> Result<ResultFolder, WriteError> {
    ResultFolder::open(dir, |_, path| path.to_str().is_some_and(|name| overlay::is_comparison("", name)))
}

/// A file that has the name of a result is one where a run has left its summary or its list of stages beside it.
fn refuse_others(dir: &Path) -> Result<(), WriteError> {
    let holds = |file: &str, what: &str| fs::read_to_string(dir.join(file)).is_ok_and(|text| text.contains(what));
    let is_of_a_run = holds("summary.json", concat!("\"program\": \"", env!("CARGO_PKG_NAME")))
        || holds(stages::FILE, stages::HEADERS);
    let entries = match fs::read_dir(dir) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
        entries => entries.map_err(|source| WriteError { path: dir.to_owned(), source })?,
    };
    for path in entries.flatten().map(|entry| entry.path()) {
        if !path.file_name().and_then(|name| name.to_str()).is_some_and(is_result) {
            continue;
        }
        if path.is_dir() {
            return Err(WriteError { path, source: ErrorKind::IsADirectory.into() });
        }
        if !is_of_a_run || path.is_symlink() {
            let source =
                io::Error::new(ErrorKind::AlreadyExists, "it is there, and nothing says that a run has written it");
            return Err(WriteError { path, source });
        }
    }
    Ok(())
}

impl Solution {
    /// Writes every table and plot of [`OUTPUTS`] into `dir`, those of several stages into a folder each, in the place of
    /// what an earlier run left there; returns what was written.
    ///
    /// # Errors
    /// When a folder or file cannot be written, or a reference of the case cannot be read.
    pub fn write(&self, dir: impl AsRef<Path>) -> Result<Vec<PathBuf>, OutputError> {
        let (answer, findings) = answered(self, None);
        Ok(Results::of(self)?.answered(&answer, &findings).write(&FrameRecorder::default(), dir.as_ref())?)
    }
}

impl Results<'_> {
    /// Writes as [`Solution::write`], with what a recorder was asked for.
    ///
    /// # Errors
    /// When a folder or file cannot be written: the earlier results are then still there.
    pub fn write(&self, recorder: &FrameRecorder, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
        self.write_into(recorder, None, result_folder(&self.solution.case, dir)?)
    }

    /// The same, and a page about them, by its name, into a folder that was taken before.
    ///
    /// # Errors
    /// As [`ResultFolder::commit`].
    pub fn write_into(
        &self,
        recorder: &FrameRecorder,
        page: Option<(String, Vec<u8>)>,
        mut folder: ResultFolder,
    ) -> Result<Vec<PathBuf>, WriteError> {
        for output in OUTPUTS {
            if let Make::OfCase(make) = output.make {
                make(self).try_for_each(|(name, bytes)| folder.write(name, &bytes))?;
            }
        }
        for (i, view) in self.views.iter().enumerate() {
            let label = self.solution.case.stage_label(i).unwrap_or_default();
            write_stage(view, i, recorder, &mut folder, Path::new(&label))?;
        }
        if let Some((name, bytes)) = page {
            folder.write(name, &bytes)?;
        }
        folder.commit()
    }

    /// Writes comparisons only.
    ///
    /// # Errors
    /// As [`ResultFolder::commit`].
    pub fn write_comparisons(&self, mut folder: ResultFolder) -> Result<Vec<PathBuf>, WriteError> {
        overlay::files(self).try_for_each(|(name, bytes)| folder.write(name, &bytes))?;
        folder.commit()
    }
}

impl StageView<'_> {
    /// Writes every table and plot of this stage into `dir` in the place of earlier results; returns their paths.
    ///
    /// # Errors
    /// If a folder or file cannot be written; the earlier results stay.
    pub fn write(&self, dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
        let mut folder = ResultFolder::open(dir, belongs_to_run)?;
        refuse_others(dir)?;
        write_stage(self, 0, &FrameRecorder::default(), &mut folder, Path::new(""))?;
        folder.commit()
    }
}

fn write_stage(
    view: &StageView,
    i: usize,
    recorder: &FrameRecorder,
    folder: &mut ResultFolder,
    inside: &Path,
) -> Result<(), WriteError> {
    let frames = recorder.of_stage(i, view.stage);
    for output in OUTPUTS {
        if let Make::Moving(extra, make) = output.make {
            if recorder.extras.contains(&extra) && frames.len() > 1 {
                make(view, &frames).try_for_each(|(name, bytes)| folder.write(inside.join(name), &bytes))?;
            }
        } else {
            output.files(view).iter().try_for_each(|(name, bytes)| folder.write(inside.join(name), bytes))?;
        }
    }
    Ok(())
}
