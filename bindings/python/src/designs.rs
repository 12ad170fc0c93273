//! The designs of a study: run in memory, or into a table on the disk as the command line has it.

use super::attend::Line;
use super::rows::Rows;
use pyo3::prelude::*;
use stampflow::study::{self, Bars, Begun, Columns, Designs, Earlier, Journal, Row, Shard, StudyError, Times};
use std::convert::Infallible;
use std::fmt::Display;
use std::fs;
use std::path::PathBuf;

/// So many designs at most: their rows are kept in memory.
const MOST: u64 = 10_000_000;

/// Which rows of a study are run, and where they are kept.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Part {
    /// Number of the shard, from 1, and how many there are.
    shard: Option<(u64, u64)>,
    /// The folder of the table; in memory alone where there is none.
    out: Option<PathBuf>,
    /// Whether rows of an earlier run stay.
    resume: bool,
    /// Whether they go.
    restart: bool,
}

/// What came of the designs of a part.
pub struct Ran {
    /// In their order, as far as they came.
    pub rows: Rows,
    /// The table of the whole study where all of it is there, and what it is called.
    pub whole: Option<(Vec<u8>, String)>,
}

/// How a study is written.
pub struct Written<'a> {
    /// The name of its table, without its ending.
    pub stem: &'a str,
    /// Its columns that say what came of a design.
    pub columns: &'a Columns,
    /// The first line.
    pub header: Vec<String>,
    /// The line of a row.
    pub line: &'a dyn Fn(&Row) -> Vec<String>,
    /// Whether the table is wanted of a study that is kept in memory.
    pub is_told: bool,
    /// Whether a table of how long each design took stands beside.
    pub has_times: bool,
}

impl Part {
    /// The indices of its designs.
    pub fn indices(&self, designs: &dyn Designs) -> Result<Vec<u64>, StudyError> {
        let shard = self.shard()?;
        match shard.count(designs.count()) {
            0..=MOST => Ok(shard.indices(designs.count())),
            count => Err(StudyError::Asked {
                what: format!("{count} designs are asked for, more than {MOST}"),
                help: "fewer values, or --shard for a part of them".to_owned(),
            }),
        }
    }

    fn shard(&self) -> Result<Shard, StudyError> {
        let Some((number, of)) = self.shard else { return Ok(Shard::WHOLE) };
        let wrong = |help| StudyError::Asked { what: format!("({number}, {of}) is no shard"), help };
        format!("{number}/{of}").parse().map_err(wrong)
    }

    fn earlier(&self) -> Earlier {
        match (self.resume, self.restart) {
            (true, _) => Earlier::Resume,
            (_, true) => Earlier::Restart,
            _ => Earlier::Refuse,
        }
    }

    /// Runs its designs; of what an earlier run has left on the disk only what is missing.
    pub fn run(
        &self,
        designs: &dyn Designs,
        written: Written<'_>,
        threads: usize,
        bars: Bars,
        line: &Line<'_>,
    ) -> Result<Ran, StudyError> {
        let indices = self.indices(designs)?;
        if self.out.is_some() {
            return self.kept(designs, &indices, &written, threads, bars, line);
        }
        let (mut rows, mut lines) = (Rows::of(designs.headers()), Vec::new());
        let Ok(()) = study::run(designs, &indices, threads, bars, line, |row| {
            lines.extend(written.is_told.then(|| (written.line)(&row)));
            rows.push(row);
            Ok::<(), Infallible>(())
        });
        let is_whole = self.shard()? == Shard::WHOLE && lines.len() == indices.len();
        // What is said is said of the table, as on the command line: of its digits.
        let whole = is_whole.then(|| (study::csv(&written.header, &lines), "the study".to_owned()));
        Ok(Ran { rows, whole })
    }

    fn kept(
        &self,
        designs: &dyn Designs,
        indices: &[u64],
        written: &Written<'_>,
        threads: usize,
        bars: Bars,
        line: &Line<'_>,
    ) -> Result<Ran, StudyError> {
        let (shard, folder) = (self.shard()?, self.out.clone().unwrap_or_default());
        let path = folder.join(shard.file(written.stem));
        let wrong = |verb: &str, error: &dyn Display| StudyError::Asked {
            what: format!("cannot {verb} {}: {error}", path.display()),
            help: "choose another place with --out".to_owned(),
        };
        let mut table = path.clone();
        let mut is_whole = true;
        if let Begun::Open(mut journal) = Journal::open(&path, designs.key(), &written.header, indices, self.earlier())?
        {
            let kept = journal.done();
            let beside = folder.join(shard.file(&format!("{}_times", written.stem)));
            let mut times = written.has_times.then(|| Times::open(&beside, kept > 0)).transpose()?;
            let ended = study::run(designs, &indices[kept..], threads, bars, line, |row| {
                if let Some(times) = &mut times {
                    times.add(row.design.index, row.seconds)?;
                }
                journal.add(&(written.line)(&row))
            });
            ended.map_err(|error| wrong("write", &error))?;
            is_whole = journal.done() == indices.len();
            match is_whole {
                true => journal.finish().map_err(|error| wrong("write", &error))?,
                false => journal.part().clone_into(&mut table),
            }
        }
        let table = fs::read(&table).map_err(|error| wrong("read", &error))?;
        let rows = Rows::read(designs.headers(), written.columns, &table);
        let whole = (is_whole && shard == Shard::WHOLE).then(|| (table, path.display().to_string()));
        Ok(Ran { rows, whole })
    }
}

/// Puts the tables of all shards of a study together; how many designs there are.
#[pyfunction]
pub fn merge(py: Python<'_>, shards: Vec<PathBuf>, out: PathBuf) -> PyResult<u64> {
    py.detach(|| study::merge(&shards, &out)).map_err(|error| super::error::of_study(py, &error))
}
