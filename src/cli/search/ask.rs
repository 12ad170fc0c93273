//! What is asked of a search, from the command line.

use super::super::error_bars::ErrorBars;
use super::super::many::{Many, write_all};
use super::super::place;
use stampflow::output::{Chart, write};
use stampflow::study::search::{Condition, Draft, Goal, Quest, Side, Target, Template, Wanted};
use stampflow::study::{self, Span, StudyError, Subject};
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
        let overrides = self.many.overrides.all();
        let mut subject = Subject::new(&self.case, overrides.clone())?;
        let draft = match &self.template {
            Some(name) => Some(Template::named(name)?.draft(&subject.case(&[])?)?),
            None => None,
        };
        if let Some(Draft { settings, .. }) = draft.as_ref().filter(|draft| !draft.settings.is_empty()) {
            subject = Subject::new(&self.case, settings.iter().cloned().chain(overrides).collect())?;
        }
        let vary = match (&self.vary[..], &draft) {
            ([vary], _) => vary,
            ([], Some(draft)) => &draft.vary,
            ([], None) => {
                return Err(wanting("there is nothing to vary", "give --vary \"KEY=FROM..TO UNIT\", or --for"));
            }
            _ => {
                let help = "join keys that move together by &, or give --minimise or --maximise for their best";
                return Err(wanting("several keys are varied", help));
            }
        };
        let mut span = Span::read(vary, &subject)?;
        if let Some(tolerance) = &self.tolerance {
            span = span.within(tolerance)?;
        }
        let goal = self.goal(draft.as_ref().map(|draft| draft.goal))?;
        let side = match (self.largest, self.smallest, &draft) {
            (true, ..) => Side::Largest,
            (_, true, _) => Side::Smallest,
            (_, _, Some(draft)) => {
                if draft.is_smallest {
                    Side::Smallest
                } else {
                    Side::Largest
                }
            }
            (_, _, None) if matches!(goal, Goal::Reach(_)) => Side::Smallest,
            _ => {
                return Err(wanting(
                    "neither the largest nor the smallest is asked for",
                    "give --largest or --smallest",
                ));
            }
        };
        Ok(Quest { subject, span, goal, side })
    }

    fn goal(&self, wanted: Option<Wanted>) -> Result<Goal, StudyError> {
        match (&self.condition, &self.target, wanted) {
            (Some(condition), ..) => Condition::read(condition).map(Goal::Keep),
            // A template knows the number.
            (_, Some(target), Some(Wanted::Number(number))) if !target.contains('=') => {
                Target::read(&format!("{number}={target}")).map(Goal::Reach)
            }
            (_, Some(target), _) => Target::read(target).map(Goal::Reach),
            (_, _, Some(Wanted::Condition(condition))) => Condition::read(condition).map(Goal::Keep),
            (_, _, Some(Wanted::Number(number))) => {
                let help = format!("give it with --target, such as \"{number}=90 deg\" or \"{number}=8 mm\"");
                Err(wanting(&format!("the wanted value of {number} is missing"), &help))
            }
            (None, None, None) => Err(wanting(
                "it is not said what a run must keep to",
                "give --while \"no red\", or --target \"NUMBER=VALUE\"",
            )),
        }
    }

    /// Where the results go, found usable before anything is run.
    pub fn places(&self) -> anyhow::Result<Places> {
        let dir = self.many.folder(&self.case, "search");
        let table = dir.join("search.csv");
        place::file(&table, std::slice::from_ref(&self.case), "--out")?;
        place::replaced(&table, b"study,designs,index,", "--out")?;
        Ok(Places { dir, table })
    }
}

fn wanting(what: &str, help: &str) -> StudyError {
    StudyError::Asked { what: what.into(), help: help.into() }
}

/// Where the results of a search go.
pub struct Places {
    pub dir: PathBuf,
    pub table: PathBuf,
}

impl Places {
    pub fn table(&self, header: &[String], lines: &[Vec<String>]) -> anyhow::Result<()> {
        let bytes = study::csv(header, lines);
        Ok(write(&self.table, &bytes)?)
    }

    /// The table of the runs so far; where that cannot be, the end says it.
    pub fn keep(&self, header: &[String], lines: &[Vec<String>]) {
        let _ = self.table(header, lines);
    }

    pub fn picture(&self, args: &Args, chart: Option<Chart>) -> anyhow::Result<()> {
        let made = args.many.pictures.pictures();
        write_all(&self.dir, chart.iter().flat_map(|chart| made.files("search", chart)))?;
        Ok(())
    }
}
