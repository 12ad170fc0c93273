//! `stampflow search`: where a condition ends, or where a number has a wanted value; the best of several keys.

mod best;
mod told;

use super::code::Code;
use super::error_bars::ErrorBars;
use super::many::{Many, asked};
use super::options::{PictureOptions, Told};
use super::place;
use super::progress::Progress;
use super::say::{say, say_json};
use anyhow::Context;
use serde_json::{Value, json};
use stampflow::output::study::search::plot;
use stampflow::output::{Chart, write};
use stampflow::study::search::{Answer, Condition, Draft, Found, Goal, Quest, Side, Target, Template, Wanted};
use stampflow::study::{Span, StudyError, Subject};
use stampflow::units::rounded;
use stampflow::verification::{Verification, Watch};
use std::path::{Path, PathBuf};
use std::time::Instant;

pub const HELP: &str = "\
The span is looked at in 9 places first, for a condition may come and go; then the \
limit is divided until it is known within 0.5 % of the span, or --tolerance. A run \
that failed counts as neither. Conditions, joined by `and`: no red, no red or amber, \
no tear, ROW not red (a row of the verdict), NUMBER < VALUE UNIT (a number of \
study.csv). A number of a sheet that tore keeps none.

--for takes key, span and condition from the case; --vary, --while, --target change \
them:
  limiting-draw-ratio  the largest blank that is drawn without a tear
  greatest-height      the largest travel without a red light
  least-holder-force   the smallest force that keeps the flange flat
  smallest-radius      the smallest die shoulder without a red light
  over-bend            the travel for a wanted angle: with --target \"90 deg\"
  bead-force           the bead for a wanted draw-in: with --target \"8 mm\"

Examples:
  stampflow search cup.toml --for limiting-draw-ratio
  stampflow search cup.toml --vary \"blank.diameter=90..140 mm\" --largest --while \"no red\"
  stampflow search hat.toml --vary \"tools.holder.force=50..2000 N/mm log\" --target \"draw_in=20 mm\"
  stampflow search cup.toml --vary \"tools.die.shoulder=4..10 mm\" \\
    --vary friction=0.04..0.12 --minimise punch_force --while \"thinning < 8 %\"

Exit codes: 0 done, 1 nothing found, 2 bad input, 130 interrupted (runs are kept)";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// A key and its span, KEY=FROM..TO UNIT, with `log` behind it in even ratios; of a key alone from half to twice what the
    /// case has. Keys joined by & move together
    #[arg(long, value_name = "KEY=SPAN")]
    vary: Vec<String>,
    /// What is asked for often, with all that it takes
    #[arg(long = "for", value_name = "SEARCH")]
    template: Option<String>,
    /// Find the largest value at which the condition holds
    #[arg(long, conflicts_with = "smallest")]
    largest: bool,
    /// Find the smallest
    #[arg(long)]
    smallest: bool,
    /// What a run must keep to, such as "no red" or "thinning < 20 % and punch_force <= 60 kN"
    #[arg(long = "while", value_name = "CONDITION", conflicts_with = "target")]
    condition: Option<String>,
    /// A number and the value that it shall have, such as "draw_in=8 mm"
    #[arg(long, value_name = "NUMBER=VALUE")]
    target: Option<String>,
    /// Find the least of a number, over one key or several
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["maximise", "target", "template", "largest", "smallest"])]
    minimise: Option<String>,
    /// Find the most of a number
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["target", "template", "largest", "smallest"])]
    maximise: Option<String>,
    /// How near the limit is to be found, in the unit of the key [default: 0.5 % of the span]
    #[arg(long, value_name = "VALUE")]
    tolerance: Option<String>,
    #[command(flatten)]
    told: Told,
    #[command(flatten)]
    bars: ErrorBars,
    #[command(flatten)]
    pictures: PictureOptions,
    #[command(flatten)]
    many: Many,
}

pub fn search(args: &Args) -> anyhow::Result<Code> {
    let places = args.places()?;
    if args.minimise.is_some() || args.maximise.is_some() {
        return best::optimise(args, &places);
    }
    let quest = args.quest().map_err(asked)?;
    let count = args.many.count(&args.case, "runs");
    let start = Instant::now();
    let answer = quest.search(args.many.threads(), &count).map_err(asked)?;
    let seconds = start.elapsed().as_secs_f64();
    let (header, lines) = answer.table();
    places.table(header, lines)?;
    let form = args.told.form();
    places.picture(args, plot(&quest, &answer, form))?;
    let bars = match answer.best.filter(|_| !count.wants_to_stop()) {
        Some(best) => {
            let solution = quest.solution(&answer.rows[best], &count).map_err(asked)?;
            args.bars.of(&solution, &Progress::new(true), true)
        }
        None => None,
    };
    let code = match answer.bracket.found {
        Found::Between(_) | Found::Everywhere(_) => Code::Done,
        Found::Interrupted => Code::Interrupted,
        Found::Nowhere | Found::Open(_) | Found::Failed => Code::Failed,
    };
    if args.many.json.json {
        say_json(&json(&quest, &answer, bars.as_ref(), seconds, &places))?;
        return Ok(code);
    }
    say(told::screen(&quest, &answer, bars.as_ref(), form))?;
    say(told::done(answer.rows.len(), seconds, &places.dir, form))?;
    Ok(code)
}

impl Args {
    /// What is searched for, from a template and what the command line says besides.
    fn quest(&self) -> Result<Quest, StudyError> {
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
    fn places(&self) -> anyhow::Result<Places> {
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
struct Places {
    dir: PathBuf,
    table: PathBuf,
}

impl Places {
    fn table(&self, header: &[String], lines: &[Vec<String>]) -> anyhow::Result<()> {
        let bytes = stampflow::study::csv(header, lines);
        write(&self.table, &bytes).with_context(|| format!("cannot write {}", self.table.display()))
    }

    fn picture(&self, args: &Args, chart: Option<Chart>) -> anyhow::Result<()> {
        for (name, bytes) in chart.iter().flat_map(|chart| args.pictures.pictures().files("search", chart)) {
            let path = self.dir.join(name);
            write(&path, &bytes).with_context(|| format!("cannot write {}", path.display()))?;
        }
        Ok(())
    }
}

/// What was found, for programs; values in the unit of the key, numbers in those of their columns.
fn json(quest: &Quest, answer: &Answer, bars: Option<&Verification>, seconds: f64, places: &Places) -> Value {
    let bracket = &answer.bracket;
    let range = |range: &std::ops::RangeInclusive<f64>| json!([range.start(), range.end()]);
    let found = match bracket.found {
        Found::Between(_) => "between",
        Found::Everywhere(_) => "everywhere",
        Found::Nowhere => "nowhere",
        Found::Open(_) => "open",
        Found::Failed => "failed",
        Found::Interrupted => "interrupted",
    };
    let tolerance = match bracket.found {
        Found::Between([inner, outer]) => Some(rounded((outer - inner).abs())),
        _ => None,
    };
    let run = |run: usize| run_json(answer.value(run), &answer.rows[run], bars.filter(|_| Some(run) == answer.best));
    json!({
        "key": quest.span.key(),
        "unit": quest.span.unit(),
        "found": found,
        "value": answer.best.map(|run| answer.value(run)),
        "tolerance": tolerance,
        "wanted": answer.wanted.map(rounded),
        "best": answer.best.map(run),
        "other": answer.other.map(run),
        "draw_ratios": answer.draw_ratios.map(|ratios| ratios.map(rounded)),
        "stretches": bracket.stretches.iter().map(range).collect::<Vec<_>>(),
        "mixed": bracket.mixed.as_ref().map(range),
        "runs": answer.rows.len(),
        "failed": answer.failed.iter().map(|(why, count)| json!({ "why": why, "runs": count })).collect::<Vec<_>>(),
        "seconds": rounded(seconds),
        "file": shown(&places.table),
    })
}

/// A run with its lights and numbers.
fn run_json(value: f64, row: &stampflow::study::Row, bars: Option<&Verification>) -> Value {
    let solved = row.result.as_ref().ok();
    let numbers = solved.into_iter().flat_map(|solved| &solved.outcome.numbers).map(|number| {
        let bar = bars.and_then(|bars| bars.bar(number.of, number.key)).and_then(|bar| bar.half).map(rounded);
        json!({
            "told_by": number.of.key(),
            "key": number.key,
            "value": rounded(number.amount.value),
            "unit": number.amount.unit.spelled(),
            "error_bar": bar,
        })
    });
    json!({
        "value": value,
        "light": solved.map(|solved| solved.light.name()),
        "red": solved.map(|solved| &solved.red),
        "amber": solved.map(|solved| &solved.amber),
        "end": solved.map(|solved| solved.outcome.end.kind),
        "numbers": numbers.collect::<Vec<_>>(),
    })
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
