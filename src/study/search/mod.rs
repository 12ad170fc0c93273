//! Searches: the last value of a key up to which a condition holds, or the one at which a number has a wanted value.
//!
//! ```text
//! Span       what is looked through                  blank.diameter=90..140 mm
//! Condition  what a run must keep to                 no red and thinning < 20 %
//! Target     the value that a number shall have      opening_angle=90 deg
//! bracket    the mathematics, of any function
//! Trials     the runs, side by side
//! Template   what shops ask for, with key, span and condition from the case
//! optimise   the least or the most of a number over several keys
//! Asked      a search in texts as a user writes them; Wish: a best likewise
//! telling    what was found, in sentences
//! ```

mod asked;
mod bracket;
mod condition;
mod number;
mod optimise;
mod telling;
mod template;
mod trials;
mod wish;

pub use asked::Asked;
pub use bracket::{Aim, Bracket, Found, Line, Side, Trial, bracket};
pub use condition::{Condition, Said};
pub use number::Named;
pub use optimise::{Best, Sense, optimise};
pub use template::{Draft, TEMPLATES, Template, Wanted};
pub use trials::{Keep, Trials, reasons};
pub use wish::Wish;

use crate::assess::estimate::draw_ratio;
use crate::case::Solution;
use crate::study::verify::Watch;
use crate::study::{Bars, Columns, Row, Solved, Span, StudyError, Subject, base};
use crate::units::Parsed;
use condition::{quantity, usable};

/// Places that a span is looked at first, where nothing else is given.
const PLACES: usize = 9;

/// Runs nearer to each other, over the span, tell no slope \[–\].
const FAR: f64 = 0.02;

/// A target that is missed by less, over its size, is met for a shop \[–\].
const MISSED: f64 = 0.005;

/// What is searched for.
#[derive(Clone, Debug)]
pub struct Quest {
    /// The case.
    pub subject: Subject,
    /// What is varied.
    pub span: Span,
    /// What it is varied for.
    pub goal: Goal,
    /// Which end of the span is wanted, or which of several crossings.
    pub side: Side,
}

/// What a key is varied for.
#[derive(Clone, Debug, PartialEq)]
pub enum Goal {
    /// That this holds.
    Keep(Condition),
    /// That a number has a value.
    Reach(Target),
}

/// The value that a number shall have.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Which number.
    pub name: Named,
    value: Parsed,
}

impl Target {
    /// Reads `draw_in=8 mm`.
    ///
    /// # Errors
    /// When there is no name, or no value with a unit.
    pub fn read(text: &str) -> Result<Self, StudyError> {
        let usage = "write NUMBER=VALUE UNIT, such as \"draw_in=8 mm\"";
        let (name, value) =
            text.split_once('=').ok_or_else(|| StudyError::new(format!("`{text}` is no target"), usage))?;
        let name = Named::read(name).ok_or_else(|| StudyError::new(format!("`{text}` names no number"), usage))?;
        Ok(Self { name, value: quantity(value)? })
    }

    /// The wanted value, in the unit of the number of a run.
    ///
    /// # Errors
    /// Where a run has no such number, or it is in another unit.
    pub fn value(&self, solved: &Solved) -> Result<f64, StudyError> {
        self.name.limit(self.name.find(solved)?, &self.value)
    }

    /// How far a run is beyond it, in the unit of the number, or why the run does not say.
    fn beyond(&self, row: &Row) -> Result<f64, String> {
        let solved = usable(row)?;
        if solved.tears {
            return Err("it tears".into());
        }
        let number =
            self.name.find(solved).map_err(|_| format!("the run has no number {name}", name = self.name.text))?;
        Ok(number.amount.value - self.value(solved).unwrap_or(f64::NAN))
    }
}

/// What a search has come to.
#[derive(Debug)]
pub struct Answer {
    /// What was found, of the first key.
    pub bracket: Bracket,
    /// All runs, in the order in which they were made.
    pub rows: Vec<Row>,
    /// The answer's run: the last that keeps the condition, or the one nearest to the target.
    pub best: Option<usize>,
    /// The run next to it on the other side.
    pub other: Option<usize>,
    /// The draw ratios of both, where a blank is drawn in over a punch.
    pub draw_ratios: Option<[f64; 2]>,
    /// Why runs came to nothing, each reason with how often.
    pub failed: Vec<(String, usize)>,
    /// The wanted value in the unit of the number, of a target.
    pub wanted: Option<f64>,
    /// What the case as it stands came to.
    pub base: Solved,
    table: (Vec<String>, Vec<Vec<String>>),
}

impl Answer {
    /// The table of all runs: its header and its lines.
    pub fn table(&self) -> (&[String], &[Vec<String>]) {
        (&self.table.0, &self.table.1)
    }

    /// How a number changes with the first key at the answer, in its unit over the key's: between the runs that are nearest
    /// to it on either side and far enough for their difference to be no noise.
    pub fn slope(&self, quest: &Quest, name: &Named) -> Option<f64> {
        let at = self.value(self.best?);
        let [low, high] = quest.span.ends();
        let far = FAR * (high - low);
        let of = |run: usize| {
            let solved = self.rows[run].result.as_ref().ok().filter(|solved| !solved.tears)?;
            Some((self.value(run), name.find(solved).ok()?.amount.value))
        };
        let runs = || (0..self.rows.len()).filter_map(of);
        let below = runs().filter(|(x, _)| *x <= at - far).max_by(|a, b| a.0.total_cmp(&b.0));
        let above = runs().filter(|(x, _)| *x >= at + far).min_by(|a, b| a.0.total_cmp(&b.0));
        let own = runs().find(|(x, _)| *x == at);
        let (from, to) = (below.or(own)?, above.or(own)?);
        Some((to.1 - from.1) / (to.0 - from.0)).filter(|slope| slope.is_finite() && *slope != 0.0)
    }

    /// The numbers on either side of a step that goes past the wanted value, in the unit of the number; `None` where it is met.
    pub fn jump(&self) -> Option<[f64; 2]> {
        let wanted = self.wanted.filter(|_| matches!(self.bracket.found, Found::Between(_)))?;
        let off = self.bracket.jump(self.value(self.best?))?;
        off.iter().all(|off| off.abs() > MISSED * wanted.abs()).then(|| off.map(|off| wanted + off))
    }

    /// The value of the first key in a run.
    pub fn value(&self, run: usize) -> f64 {
        self.rows[run].design.values[0].number.unwrap_or(f64::NAN)
    }
}

impl Quest {
    /// Searches, runs side by side on so many threads.
    ///
    /// # Errors
    /// When the case cannot be run, the span makes no case, or a number is asked for that it does not have.
    pub fn search(&self, threads: usize, watch: &dyn Watch) -> Result<Answer, StudyError> {
        self.search_keeping(threads, watch, &mut |_, _| {})
    }

    /// The same with someone who keeps the runs as they come.
    ///
    /// # Errors
    /// As [`search`](Self::search).
    pub fn search_keeping(&self, threads: usize, watch: &dyn Watch, keep: Keep) -> Result<Answer, StudyError> {
        self.can_be_set()?;
        let base = base(&self.subject, Bars::Without, watch)?;
        let wanted = match &self.goal {
            Goal::Keep(condition) => condition.check(&base).map(|()| None)?,
            Goal::Reach(target) => Some(target.value(&base)?),
        };
        let places = self.span.places().unwrap_or(PLACES);
        let spans = std::slice::from_ref(&self.span);
        let mut trials =
            Trials::new(&self.subject, spans, threads, watch, self.expected(places, threads)).keeping(&base, keep);
        let line = Line {
            at: &|share| self.span.at(share),
            share: &|x| self.span.share(x),
            tolerance: &|x| self.span.tolerance(x),
            places,
            at_once: threads,
        };
        let aim = match self.goal {
            Goal::Keep(_) => Aim::Edge(self.side),
            Goal::Reach(_) => Aim::Crossing(self.side),
        };
        let mut failed = Vec::new();
        let mut bracket = bracket(&line, aim, &mut |values| {
            let points: Vec<Vec<f64>> = values.iter().map(|x| vec![*x]).collect();
            let runs = trials.run(&points)?;
            Some(
                runs.into_iter().map(|run| self.said(&trials.rows[run]).map_err(|why| failed.push(why)).ok()).collect(),
            )
        });
        let (best, other) = self.runs(&mut bracket, &mut trials);
        let table = trials.table(&Columns::of(&trials, &base));
        let ratio = |run: usize| draw_ratio(self.subject.case(&trials.rows[run].design.settings).ok()?.model());
        let draw_ratios = best.zip(other).and_then(|(best, other)| Some([ratio(best)?, ratio(other)?]));
        Ok(Answer {
            best,
            other,
            draw_ratios: draw_ratios.filter(|[a, b]| a != b),
            failed: reasons(failed.into_iter()),
            wanted,
            table,
            rows: trials.rows,
            bracket,
            base,
        })
    }

    /// Solves the case of a run again, all of it.
    ///
    /// # Errors
    /// A mistake of this program.
    pub fn solution(&self, row: &Row, watch: &dyn Watch) -> Result<Solution, StudyError> {
        let case = self.subject.case(&row.design.settings)?;
        Subject::solution(case, watch).map_err(|why| StudyError::new(why, "try `stampflow run`"))
    }

    /// How a run stands to what is searched for: above 0 on the inner side, or why it does not say.
    fn said(&self, row: &Row) -> Result<f64, String> {
        match &self.goal {
            Goal::Keep(condition) => match condition.judge(row) {
                Said::Holds => Ok(1.0),
                Said::Fails => Ok(-1.0),
                Said::Neither(why) => Err(why),
            },
            Goal::Reach(target) => target.beyond(row),
        }
    }

    /// The answer's run and the one beside it. Of a target one more run is made where its number would be reached were it
    /// straight in the bracket.
    fn runs(&self, bracket: &mut Bracket, trials: &mut Trials) -> (Option<usize>, Option<usize>) {
        let run_at =
            |trials: &Trials, x: f64| trials.rows.iter().position(|row| row.design.values[0].number == Some(x));
        match (&bracket.found, &self.goal) {
            (Found::Between([inner, outer]), Goal::Keep(_)) => (run_at(trials, *inner), run_at(trials, *outer)),
            (Found::Everywhere(x) | Found::Open(x), _) => (run_at(trials, *x), None),
            (Found::Between([inner, outer]), Goal::Reach(_)) => {
                let value = |x: f64| bracket.trials.iter().find(|trial| trial.0 == x).and_then(|trial| trial.1);
                let (Some(a), Some(b)) = (value(*inner), value(*outer)) else { return (None, None) };
                let [from, to] = [*inner, *outer].map(|x| self.span.share(x));
                let x = self.span.at(from + (to - from) * a / (a - b));
                if run_at(trials, x).is_none() {
                    let said = trials.run(&[vec![x]]).and_then(|runs| self.said(&trials.rows[runs[0]]).ok());
                    bracket.trials.push((x, said));
                    bracket.trials.sort_by(|a, b| a.0.total_cmp(&b.0));
                }
                let near = |x: &f64| bracket.trials.iter().find(|trial| trial.0 == *x).and_then(|t| t.1).map(f64::abs);
                let mut nearest = [x, *inner, *outer].into_iter().filter(|x| near(x).is_some()).collect::<Vec<_>>();
                nearest.sort_by(|a, b| near(a).unwrap_or(f64::INFINITY).total_cmp(&near(b).unwrap_or(f64::INFINITY)));
                nearest.dedup();
                let run = |i: usize| nearest.get(i).and_then(|x| run_at(trials, *x));
                (run(0), run(1))
            }
            _ => (None, None),
        }
    }

    /// A span none of whose ends and middle makes a case is a mistake of the search, not of a run.
    fn can_be_set(&self) -> Result<(), StudyError> {
        let mut wrong = None;
        let is_sound = [0.5, 0.0, 1.0].into_iter().any(|share| {
            let settings = self.span.settings(&self.span.values(self.span.at(share)));
            self.subject.case(&settings).map_err(|error| wrong.get_or_insert(error).to_string()).is_ok()
        });
        wrong.filter(|_| !is_sound).map_or(Ok(()), |error| Err(error.into()))
    }

    /// Runs that a search takes where nothing comes between.
    fn expected(&self, places: usize, threads: usize) -> usize {
        let [low, high] = self.span.ends();
        let widths = (high - low) / (places - 1) as f64 / self.span.tolerance(low);
        let rounds = (widths.max(1.0).ln() / (threads as f64 + 1.0).ln()).ceil() as usize;
        places + rounds * threads + 4
    }
}
