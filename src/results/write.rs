//! Writing of all outputs of a solution, and protection of files of other origin.

use super::comparison::Comparison;
use super::{FrameRecorder, Make, OUTPUTS, Output, Pictures, ResultFolder, StageView, WriteError, comparison, stages};
use crate::assess::{Answer, Finding, error_bars::ErrorBars, error_bars::answered, judgements};
use crate::case::{Case, Solution, files::Disk, files::Files};
use serde_json::{Value, json};
use std::{fs, io, io::ErrorKind, path::Path, path::PathBuf};

/// Failure to write results.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// A file or folder cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// A reference that the case is compared with cannot be used.
    #[error(transparent)]
    Compare(#[from] comparison::CompareError),
}

/// Tells whether a file of this name is written by a run.
pub fn is_result(name: &str) -> bool {
    OUTPUTS.iter().any(|output| output.is_named(name))
}

/// Mark of a report.
pub const REPORT_MARKER: &str = concat!(env!("CARGO_PKG_NAME"), " report, version");
/// Largest file that is searched for the mark \[bytes\].
const LARGEST_REPORT: usize = 100_000_000;

/// Tells whether a file is a report, whatever its name.
pub fn is_report(path: &Path) -> bool {
    let marked = |bytes: Vec<u8>| bytes.windows(REPORT_MARKER.len()).any(|part| part == REPORT_MARKER.as_bytes());
    Disk.read(path, LARGEST_REPORT).is_ok_and(marked)
}

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

/// Opens the folder for the results of a run; fails if it holds a file with the name of a result that no run has written.
pub fn result_folder(case: &Case, dir: &Path) -> Result<ResultFolder, WriteError> {
    let folder = ResultFolder::open(dir, belongs_to_run)?;
    let stages = (0..).map_while(|i| case.stage_label(i)).map(|label| dir.join(label));
    std::iter::once(dir.to_owned()).chain(stages).try_for_each(|dir| refuse_others(&dir))?;
    Ok(folder)
}

/// Opens a folder for comparisons only, which may hold the results of a run.
pub fn comparison_folder(dir: &Path) -> Result<ResultFolder, WriteError> {
    ResultFolder::open(dir, |_, path| path.to_str().is_some_and(comparison::is_comparison))
}

fn refuse_others(dir: &Path) -> Result<(), WriteError> {
    let holds = |file: &str, what: &str| fs::read_to_string(dir.join(file)).is_ok_and(|text| text.contains(what));
    let is_of_a_run = holds("summary.json", concat!("\"program\": \"", env!("CARGO_PKG_NAME")))
        || holds(stages::FILE, stages::HEADERS);
    let entries = match fs::read_dir(dir) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
        entries => entries.map_err(|source| WriteError { path: dir.to_owned(), source })?,
    };
    let has_its_name = |path: &PathBuf| path.file_name().and_then(|name| name.to_str()).is_some_and(is_result);
    let is_other = |path: &PathBuf| !is_of_a_run || path.is_symlink() || path.is_dir();
    let what = "it is there, and nothing says that a run has written it";
    let refused = |path| Err(WriteError::new(path, io::Error::new(ErrorKind::AlreadyExists, what)));
    entries.flatten().map(|entry| entry.path()).filter(has_its_name).find(is_other).map_or(Ok(()), refused)
}

/// Solution with its views, comparisons and error bars.
#[derive(Clone, Debug)]
pub struct Results<'a> {
    /// The solved case.
    pub solution: &'a Solution,
    /// Views of the stages that were run.
    pub views: Vec<StageView<'a>>,
    /// References of the case beside the computed curves.
    pub comparisons: Vec<Comparison>,
    /// Error bars of a verified case.
    pub bars: Option<&'a ErrorBars>,
}

impl<'a> Results<'a> {
    /// Prepares the outputs of a solution; fails if a reference of the case cannot be read or does not fit.
    pub fn of(solution: &'a Solution) -> Result<Self, comparison::CompareError> {
        Ok(Self { solution, views: solution.views(), comparisons: solution.comparisons()?, bars: None })
    }

    /// Adds error bars.
    pub fn verified(mut self, bars: Option<&'a ErrorBars>) -> Self {
        self.views.iter_mut().for_each(|view| view.bars = bars.map_or_else(Vec::new, ErrorBars::amounts));
        Self { bars, ..self }
    }

    /// Adds the verdict on the whole case to the summary of every stage.
    pub fn answered(mut self, answer: &Answer, findings: &[Finding]) -> Self {
        let verdict = verdict(answer, findings, self.bars);
        self.views.iter_mut().for_each(|view| view.verdict = Some(verdict.clone()));
        self
    }

    /// Sets the formats and captions of pictures.
    pub fn with_pictures(mut self, pictures: &Pictures) -> Self {
        self.views.iter_mut().for_each(|view| view.pictures = pictures.clone());
        self
    }

    /// Writes every output, with those of the recorder and a report by its name, and commits the folder.
    pub fn write(
        &self, recorder: &FrameRecorder, report: Option<(&str, String)>, mut folder: ResultFolder,
    ) -> Result<Vec<PathBuf>, WriteError> {
        let of_case = |output: &Output| if let Make::OfCase(make) = output.make { make(self) } else { Vec::new() };
        OUTPUTS.iter().flat_map(of_case).try_for_each(|(name, bytes)| folder.write(name, &bytes))?;
        for (i, view) in self.views.iter().enumerate() {
            let inside = PathBuf::from(self.solution.case.stage_label(i).unwrap_or_default());
            let frames = recorder.of_stage(i, view.stage);
            let has_moved = frames.len() > 1;
            for output in OUTPUTS {
                let files = match output.make {
                    Make::Moving(extra, make) if recorder.extras.contains(&extra) && has_moved => make(view, &frames),
                    _ => output.files(view),
                };
                files.iter().try_for_each(|(name, bytes)| folder.write(inside.join(name), bytes))?;
            }
        }
        report.into_iter().try_for_each(|(name, page)| folder.write(name, page.as_bytes()))?;
        folder.commit()
    }

    /// Writes comparisons only and commits the folder.
    pub fn write_comparisons(&self, mut folder: ResultFolder) -> Result<Vec<PathBuf>, WriteError> {
        comparison::files(self).iter().try_for_each(|(name, bytes)| folder.write(name, bytes))?;
        folder.commit()
    }
}

/// Verdict as JSON: light, sentence, key numbers, findings, and the error bars' origin.
pub fn verdict(answer: &Answer, findings: &[Finding], bars: Option<&ErrorBars>) -> Value {
    let mut value = json!(answer);
    value["findings"] = judgements(findings).map(|finding| json!(finding)).collect();
    if let Some(bars) = bars {
        value["error_bars"] = json!(bars);
    }
    value
}

impl Solution {
    /// Writes all of [`OUTPUTS`] into `dir`, a folder a stage; returns the paths. A failure keeps earlier results.
    pub fn write(&self, dir: impl AsRef<Path>) -> Result<Vec<PathBuf>, OutputError> {
        let (answer, findings) = answered(self, None);
        let folder = result_folder(&self.case, dir.as_ref())?;
        Ok(Results::of(self)?.answered(&answer, &findings).write(&FrameRecorder::default(), None, folder)?)
    }
}
