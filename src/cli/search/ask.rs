//! What is asked of a search, from the command line.

use super::super::error_bars::ErrorBars;
use super::super::many::{Many, write_all};
use super::super::place;
use serde_json::Value;
use stampflow::results::{Chart, write};
use stampflow::study::search::{Asked, Quest, Sense, Side, Wish};
use stampflow::study::{self, Begun, Earlier, Journal, StudyError, Subject};
use stampflow::units::rounded;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// A key and its span, KEY=FROM..TO UNIT, with `log` behind it in even ratios; of a key alone from half to twice what the
    /// case has. Keys joined by & move together
    #[arg(long, value_name = "KEY=SPAN")]
    pub vary: Vec<String>,
    /// What is asked for often, with all that it takes
    #[arg(long = "for", value_name = "SEARCH")]
    pub template: Option<String>,
    /// Find the largest value at which the condition holds
    #[arg(long, conflicts_with = "smallest")]
    pub largest: bool,
    /// Find the smallest
    #[arg(long)]
    pub smallest: bool,
    /// What a run must keep to, such as "no red" or "thinning < 20 % and punch_force <= 60 kN"
    #[arg(long = "while", value_name = "CONDITION", conflicts_with = "target")]
    pub condition: Option<String>,
    /// A number and the value that it shall have, such as "draw_in=8 mm"
    #[arg(long, value_name = "NUMBER=VALUE")]
    pub target: Option<String>,
    /// Find the least of a number, over one key or several
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["maximise", "target", "template", "largest", "smallest"])]
    pub minimise: Option<String>,
    /// Find the most of a number
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["target", "template", "largest", "smallest"])]
    pub maximise: Option<String>,
    /// How near the limit is to be found, in the unit of the key [default: 0.5 % of the span]
    #[arg(long, value_name = "VALUE")]
    pub tolerance: Option<String>,
    #[command(flatten)]
    pub bars: ErrorBars,
    #[command(flatten)]
    pub many: Many,
}

impl Args {
    /// What is searched for, from a template and what the command line says besides.
    pub fn quest(&self) -> Result<Quest, StudyError> {
        let side = match (self.largest, self.smallest) {
            (true, _) => Some(Side::Largest),
            (_, true) => Some(Side::Smallest),
            _ => None,
        };
        let asked = Asked {
            vary: self.vary.clone(),
            template: self.template.clone(),
            side,
            condition: self.condition.clone(),
            target: self.target.clone(),
            tolerance: self.tolerance.clone(),
        };
        asked.quest(self.subject()?)
    }

    /// The best that is looked for; `None` where none is.
    pub fn wish(&self) -> Result<Option<Wish>, StudyError> {
        let wanted = match (&self.minimise, &self.maximise) {
            (Some(number), _) => (number.as_str(), Sense::Least),
            (None, Some(number)) => (number.as_str(), Sense::Most),
            (None, None) => return Ok(None),
        };
        Wish::read(self.subject()?, &self.vary, wanted, self.condition.as_deref()).map(Some)
    }

    fn subject(&self) -> Result<Subject, StudyError> {
        Subject::new(&self.case, self.many.overrides.all())
    }

    /// Where the results go, found usable before anything is run.
    pub fn places(&self) -> anyhow::Result<Places> {
        let dir = self.many.folder(&self.case, "search");
        let table = dir.join("search.csv");
        place::file(&table, std::slice::from_ref(&self.case), "--out")?;
        place::replaced(&table, b"study,designs,index,", "--out")?;
        Ok(Places { dir, table, journal: None })
    }
}

/// Where the results of a search go.
pub struct Places {
    pub dir: PathBuf,
    pub table: PathBuf,
    /// The runs so far, once there is one; nothing where they cannot be kept.
    journal: Option<Option<Journal>>,
}

impl Places {
    /// The table of all runs, in place of what is kept of them.
    pub fn table(&mut self, header: &[String], lines: &[Vec<String>]) -> anyhow::Result<()> {
        // Given back first: what is written takes its place, and its lock.
        self.journal = None;
        Ok(write(&self.table, &study::csv(header, lines))?)
    }

    /// Keeps the next run; where that cannot be, the end says it.
    pub fn keep(&mut self, header: &[String], line: &[String]) {
        let journal =
            self.journal.get_or_insert_with(|| match Journal::open(&self.table, "", header, &[], Earlier::Restart) {
                Ok(Begun::Open(journal)) => Some(journal),
                _ => None,
            });
        if journal.as_mut().is_some_and(|journal| journal.add(line).is_err()) {
            *journal = None;
        }
    }

    /// What was found, with the time that it took and where its table is.
    pub fn located(&self, mut found: Value, seconds: f64) -> Value {
        found["seconds"] = rounded(seconds).into();
        found["file"] = self.table.display().to_string().into();
        found
    }

    pub fn picture(&self, args: &Args, chart: Option<Chart>) -> anyhow::Result<()> {
        let made = args.many.pictures.pictures();
        write_all(&self.dir, chart.iter().flat_map(|chart| made.files("search", chart)))?;
        Ok(())
    }
}
