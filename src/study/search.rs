//! Searches: the last value of a variable at which a condition holds, or the value at which a quantity is as wanted.

use super::base_case::short_hash;
use super::bracket::{Aim, Bracket, Search, Side, Trial};
use super::charts;
use super::condition::{Comparison, Condition};
use super::goals::{Goal, GoalAim};
use super::report::StudyReport;
use super::variable::{SearchRange, Value, Variable};
use super::{BaseCase, Design, Run, RunTable, Study, StudyError};
use crate::table::Spacing;
use crate::units::{parse, significant};

/// Places of the first scan.
const PLACES: usize = 9;
/// Default tolerance over the range \[–\].
const TOLERANCE: f64 = 0.005;
/// A target that is missed by less is met, over its size \[–\].
pub(super) const MISSED: f64 = 0.005;

/// Request of a search, as on the command line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SearchRequest {
    /// `KEY=FROM..TO UNIT`; a key alone is searched from half to twice its value.
    pub vary: Option<String>,
    /// Name of a [`Goal`].
    pub goal: Option<String>,
    /// Wanted end of the range.
    pub side: Option<Side>,
    /// Condition that must hold.
    pub condition: Option<String>,
    /// `QUANTITY=VALUE` to reach.
    pub target: Option<String>,
    /// Wanted accuracy, in the unit of the key.
    pub tolerance: Option<String>,
}

/// A search over one variable, with others that move along.
#[derive(Clone, Debug)]
pub struct LimitSearch {
    base: BaseCase,
    /// The first is searched; each goes from its first end to its last.
    pub(super) variables: Vec<Variable>,
    pub(super) ranges: Vec<SearchRange>,
    tolerance: Option<f64>,
    is_whole: bool,
    pub(super) aim: SearchAim,
    pub(super) side: Side,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum SearchAim {
    Keep(Condition),
    Reach(Comparison, Option<(usize, f64)>),
}

impl LimitSearch {
    /// Plans the search of a request.
    ///
    /// # Errors
    /// When something is missing or makes no sense, or the case lacks it.
    pub fn new(base: BaseCase, request: &SearchRequest) -> Result<Self, StudyError> {
        let goal = match &request.goal {
            Some(name) => Some(Goal::request(name, &base.case(&[])?)?),
            None => None,
        };
        let base = match &goal {
            Some(goal) if !goal.settings.is_empty() => base.with_settings(&goal.settings)?,
            _ => base,
        };
        let vary = request.vary.as_ref().or(goal.as_ref().map(|goal| &goal.vary)).ok_or_else(|| {
            StudyError::new("there is nothing to vary", "give --vary \"KEY=FROM..TO UNIT\", or --for")
        })?;
        let texts =
            vary.split('&').map(|text| if text.contains('=') { Ok(text.to_owned()) } else { around(text, &base) });
        let variables = texts.map(|text| Variable::read(&text?)).collect::<Result<Vec<_>, _>>()?;
        let mut ranges = variables.iter().map(Variable::search_range).collect::<Result<Vec<_>, _>>()?;
        if ranges[0].ends[0] > ranges[0].ends[1] {
            ranges.iter_mut().for_each(|range| range.ends.reverse());
        }
        let aim = aim(request, goal.as_ref().map(|goal| goal.aim))?;
        let side = match (request.side, &goal, &aim) {
            (Some(side), ..) => side,
            (_, Some(goal), _) => goal.side,
            (.., SearchAim::Reach(..)) => Side::Smallest,
            _ => {
                let what = "neither the largest nor the smallest is asked for";
                return Err(StudyError::new(what, "give --largest or --smallest"));
            }
        };
        let tolerance = request.tolerance.as_ref().map(|text| tolerance(&variables[0], text)).transpose()?;
        let mut search = Self { base, variables, ranges, tolerance, is_whole: false, aim, side };
        search.is_whole = search.has_whole_numbers();
        let tried = [0.5, 0.0, 1.0].map(|share| search.base.case(&search.settings(search.at(share))).map(drop));
        match tried {
            [Err(error), Err(_), Err(_)] => Err(error.into()),
            _ => Ok(search),
        }
    }

    /// The variable.
    pub fn variable(&self) -> &Variable {
        &self.variables[0]
    }

    /// Result, with the run at the answer and the one on its other side.
    pub fn result(&self, runs: &RunTable) -> (Bracket, Option<usize>, Option<usize>) {
        let trials = self.trials(runs);
        let found = self.search(|search| search.result(&trials));
        let place = |x: f64| runs.runs.iter().position(|run| run.value(0) == x);
        match (found, &self.aim) {
            (Bracket::Between([inner, outer]), SearchAim::Keep(_)) => (found, place(inner), place(outer)),
            (Bracket::Between([inner, outer]), SearchAim::Reach(..)) => {
                let size =
                    |x: f64| trials.iter().find(|trial| trial.0 == x).and_then(|t| t.1).map_or(f64::MAX, f64::abs);
                let nearest = if size(inner) <= size(outer) { [inner, outer] } else { [outer, inner] };
                (found, place(nearest[0]), place(nearest[1]))
            }
            (Bracket::Everywhere(x) | Bracket::Open(x), _) => (found, place(x), None),
            _ => (found, None, None),
        }
    }

    /// The overrides of a run.
    pub fn settings_of(&self, run: &Run) -> Vec<String> {
        self.settings(run.value(0))
    }

    /// The case of a run's study.
    pub fn base_case(&self) -> &BaseCase {
        &self.base
    }

    fn search<T>(&self, then: impl FnOnce(&Search) -> T) -> T {
        let range = self.ranges[0];
        then(&Search {
            at: &|share| self.at(share),
            share: &|x| range.spacing.share(range.ends, x),
            tolerance: &|x| self.tolerance(x),
            places: range.count.unwrap_or(PLACES).max(3),
            aim: match self.aim {
                SearchAim::Keep(_) => Aim::Limit(self.side),
                SearchAim::Reach(..) => Aim::Crossing(self.side),
            },
        })
    }

    pub(super) fn trials(&self, runs: &RunTable) -> Vec<Trial> {
        let value = |run: &Run| match &self.aim {
            SearchAim::Keep(condition) => condition.holds(run).map(|holds| if holds { 1.0 } else { -1.0 }),
            SearchAim::Reach(_, target) => {
                let (place, wanted) = (*target)?;
                let usable = run.is_known() && !run.tears() && run.numbers[place].is_finite();
                usable.then(|| run.numbers[place] - wanted)
            }
        };
        runs.runs.iter().map(|run| (run.value(0), value(run))).collect()
    }

    fn tolerance(&self, x: f64) -> f64 {
        let SearchRange { ends: [low, high], spacing, .. } = self.ranges[0];
        let tolerance = self.tolerance.unwrap_or_else(|| match spacing {
            Spacing::Logarithmic => x * ((high / low).ln() * TOLERANCE).exp_m1(),
            Spacing::Even => TOLERANCE * (high - low),
        });
        if self.is_whole { tolerance.max(1.0) } else { tolerance }
    }

    /// Value at a share of the range, rounded to the decimal below half the tolerance.
    fn at(&self, share: f64) -> f64 {
        let SearchRange { ends: [low, high], spacing, .. } = self.ranges[0];
        if share <= 0.0 || share >= 1.0 {
            return if share <= 0.0 { low } else { high };
        }
        let x = spacing.between([low, high], share);
        let step = if self.is_whole { 1.0 } else { 10f64.powf((0.5 * self.tolerance(x)).log10().floor()) };
        significant((x / step).round() * step, 12).clamp(low, high)
    }

    /// Values of all variables where the first has this one.
    fn values(&self, x: f64) -> Vec<Value> {
        let share = self.ranges[0].spacing.share(self.ranges[0].ends, x);
        let others = self.ranges[1..].iter().map(|range| Value::number(range.spacing.between(range.ends, share)));
        std::iter::once(Value::number(x)).chain(others).collect()
    }

    fn settings(&self, x: f64) -> Vec<String> {
        self.variables.iter().zip(self.values(x)).map(|(variable, value)| variable.setting(&value)).collect()
    }

    fn has_whole_numbers(&self) -> bool {
        let [low, high] = self.ranges[0].ends;
        let is_case = |x: f64| self.base.case(&[self.variables[0].setting(&Value::number(x))]).is_ok();
        let is_plain = self.variables[0].unit.is_empty() && low.fract() == 0.0 && high.fract() == 0.0;
        is_plain && is_case(low) && !is_case(low + 0.5) && is_case(low + 1.0)
    }
}

impl Study for LimitSearch {
    fn base(&self) -> &BaseCase {
        &self.base
    }

    fn key(&self) -> String {
        let aim = match &self.aim {
            SearchAim::Keep(condition) => condition.text.clone(),
            SearchAim::Reach(target, _) => format!("{target:?}"),
        };
        let own = format!("{:?}{:?}{:?}{aim}{:?}", self.variables, self.ranges, self.tolerance, self.side);
        short_hash([self.base.key(), &own])
    }

    fn columns(&self) -> Vec<String> {
        self.variables.iter().map(Variable::header).collect()
    }

    fn designs(&self) -> u64 {
        0
    }

    fn check(&mut self, runs: &RunTable) -> Result<(), StudyError> {
        match &mut self.aim {
            SearchAim::Keep(condition) => condition.resolve(runs),
            SearchAim::Reach(target, resolved) => target.resolve(runs).map(|found| *resolved = Some(found)),
        }
    }

    fn next(&mut self, runs: &RunTable) -> Vec<Design> {
        let trials = self.trials(runs);
        let next = self.search(|search| search.next(&trials));
        let first = runs.runs.len() as u64;
        let design = |(index, x): (u64, f64)| Design::new(index, &self.values(x), self.settings(x));
        (first..).zip(next).map(design).collect()
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let (found, best, _) = self.result(runs);
        let limits: Vec<(usize, f64)> = match &self.aim {
            SearchAim::Keep(condition) => condition.limits().collect(),
            SearchAim::Reach(_, target) => target.iter().copied().collect(),
        };
        let chart = charts::search(&self.variables[0], self.ranges[0].spacing, runs, &limits, best);
        StudyReport {
            headline: self.headline(runs),
            notes: self.notes(runs),
            tables: vec![self.table(runs)],
            found: matches!(found, Bracket::Between(_) | Bracket::Everywhere(_)),
            charts: chart.map(|chart| ("search".to_owned(), chart)).into_iter().collect(),
        }
    }
}

fn aim(request: &SearchRequest, goal: Option<GoalAim>) -> Result<SearchAim, StudyError> {
    let keep = |text: &str| Condition::read(text).map(SearchAim::Keep);
    let reach = |text: &str| Comparison::target(text).map(|target| SearchAim::Reach(target, None));
    match (&request.condition, &request.target, goal) {
        (Some(_), Some(_), _) => {
            Err(StudyError::new("both a condition and a target are given", "give --while or --target"))
        }
        (Some(condition), ..) => keep(condition),
        (_, Some(target), Some(GoalAim::Quantity(quantity))) if !target.contains('=') => {
            reach(&format!("{quantity}={target}"))
        }
        (_, Some(target), _) => reach(target),
        (_, _, Some(GoalAim::Condition(condition))) => keep(condition),
        (_, _, Some(GoalAim::Quantity(quantity))) => {
            let help = format!("give it with --target, such as \"{quantity}=90 deg\" or \"{quantity}=8 mm\"");
            Err(StudyError::new(format!("the wanted value of {quantity} is missing"), help))
        }
        (None, None, None) => {
            Err(StudyError::new("no condition is given", "give --while \"no red\", or --target \"QUANTITY=VALUE\""))
        }
    }
}

/// A range from half to twice the case's own value.
fn around(key: &str, base: &BaseCase) -> Result<String, StudyError> {
    let key = key.trim();
    let unknown = || {
        let what = format!("the case has no number at `{key}` to search about");
        StudyError::new(what, format!("give the range: \"{key}=FROM..TO UNIT\""))
    };
    let own = base.value(key).ok_or_else(unknown)?;
    let (value, unit) =
        super::variable::split_number(own.trim()).filter(|(value, _)| *value > 0.0).ok_or_else(unknown)?;
    let [low, high] = [0.5, 2.0].map(|share| significant(share * value, 4));
    Ok(format!("{key}={low}..{high} {unit}"))
}

fn tolerance(variable: &Variable, text: &str) -> Result<f64, StudyError> {
    let unit = &variable.unit;
    let wrong = || {
        let example = format!("write a number above 0 in the unit of the key, such as \"0.1 {unit}\"");
        StudyError::new(format!("`{text}` is no tolerance of {}", variable.key), example)
    };
    let has_unit = parse(text).is_ok_and(|given| given.has_unit) != unit.is_empty();
    variable.in_unit(text).filter(|size| *size > 0.0 && size.is_finite() && has_unit).ok_or_else(wrong)
}
