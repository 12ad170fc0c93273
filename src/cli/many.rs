//! What verbs have in common that run a case many times.

use super::code::BadRequest;
use super::options::{Json, Overrides, PictureOptions, Threads};
use super::progress::{Count, Progress};
use stampflow::results::{WriteError, write};
use stampflow::study::StudyError;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;

/// The options of every verb that runs a case many times.
#[derive(Debug, clap::Args)]
pub struct Many {
    #[command(flatten)]
    pub overrides: Overrides,
    /// Folder for the results [default: out/<file>-<verb>]
    #[arg(long, alias = "output", value_name = "DIR")]
    out: Option<PathBuf>,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    pub pictures: PictureOptions,
    #[command(flatten)]
    pub json: Json,
}

impl Many {
    /// Where the results of a verb on a file go.
    pub fn folder(&self, file: &Path, verb: &str) -> PathBuf {
        self.out.clone().unwrap_or_else(|| Path::new("out").join(format!("{}-{verb}", stem(file))))
    }

    /// Counts the runs of a file, which are called `what`.
    pub fn count(&self, file: &Path, what: &str) -> Count {
        Progress::new(self.quiet || self.json.json).count(format!("{}, {what}", stem(file)))
    }

    /// Threads for runs side by side: one a core where nothing else is asked for.
    pub fn threads(&self) -> usize {
        self.threads.count().or_else(|| available_parallelism().ok().map(usize::from)).unwrap_or(1)
    }
}

/// Writes the results of a study, each named in its folder; returns where they are.
///
/// # Errors
/// At the first that cannot be written.
pub fn write_all(dir: &Path, files: impl IntoIterator<Item = (String, Vec<u8>)>) -> Result<Vec<PathBuf>, WriteError> {
    let written = files.into_iter().map(|(name, bytes)| {
        let path = dir.join(name);
        write(&path, &bytes).map(|()| path)
    });
    written.collect()
}

/// A study that is wrong, as bad input.
pub fn asked(error: StudyError) -> anyhow::Error {
    match error {
        StudyError::Case(error) => error.into(),
        asked @ StudyError::Asked { .. } => BadRequest(asked.to_string()).into(),
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "study".into(), |stem| stem.to_string_lossy().into_owned())
}
