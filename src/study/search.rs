//! Searches: the last value of a variable at which a condition holds, or the value at which a quantity is as wanted.

use super::bracket::{Search, Trial};
use super::charts;
use super::condition::Comparison;
use super::goals::{Goal, GoalAim};
use super::variable::{SearchRange, split_number, written};
use super::{
    BaseCase, Bracket, Condition, Design, Plan, Run, RunTable, Side, Study, StudyError, StudyReport, Variable, fail,
};
use crate::units::{parse, significant};

/// Request of a search, as on the command line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SearchRequest {
    /// `KEY=FROM..TO UNIT`; a key alone is searched from half to twice its value.
    pub vary: Option<String>,
    /// Name of a goal.
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
    pub(super) plan: Plan,
    /// The first is searched; each goes from its first end to its last.
    variables: Vec<(Variable, SearchRange)>,
    pub(super) search: Search,
    pub(super) aim: Aim,
}

#[derive(Clone, Debug)]
pub(super) enum Aim {
    Keep(Condition),
    Reach(Comparison),
}

impl LimitSearch {
    /// Plans the search of a request.
    pub fn new(base: BaseCase, request: &SearchRequest) -> Result<Self, StudyError> {
        let goal = match &request.goal {
            Some(name) => Some(Goal::request(name, &base.case(&[])?)?),
            None => None,
        };
        let base = match &goal {
            Some(goal) if !goal.settings.is_empty() => base.with_settings(&goal.settings)?,
            _ => base,
        };
        let Some(vary) = request.vary.as_ref().or(goal.as_ref().map(|goal| &goal.vary)) else {
            return fail("there is nothing to vary", "give --vary \"KEY=FROM..TO UNIT\", or --for");
        };
        let variable = |text: &str| {
            let text = if text.contains('=') { text.to_owned() } else { around(text, &base)? };
            let variable = Variable::read(&text)?;
            let range = variable.search_range()?;
            Ok((variable, range))
        };
        let mut variables = vary.split('&').map(variable).collect::<Result<Vec<_>, StudyError>>()?;
        if variables[0].1.ends[0] > variables[0].1.ends[1] {
            variables.iter_mut().for_each(|(_, range)| range.ends.reverse());
        }
        let aim = Aim::new(request, goal.as_ref().map(|goal| goal.aim))?;
        let side = match (request.side.or(goal.map(|goal| goal.side)), &aim) {
            (Some(side), _) => side,
            (None, Aim::Reach(_)) => Side::Smallest,
            (None, Aim::Keep(_)) => {
                return fail("neither the largest nor the smallest is asked for", "give --largest or --smallest");
            }
        };
        let tolerance = request.tolerance.as_ref().map(|text| tolerance(&variables[0].0, text)).transpose()?;
        let text = match &aim {
            Aim::Keep(condition) => condition.text.clone(),
            Aim::Reach(target) => format!("{target:?}"),
        };
        let columns = variables.iter().map(|(variable, _)| variable.header()).collect();
        let plan = Plan::new(base, &format!("{variables:?}{tolerance:?}{text}{side:?}"), columns, 0);
        let (range, is_limit) = (variables[0].1, matches!(aim, Aim::Keep(_)));
        let search = Search { range, tolerance, is_whole: false, is_limit, side };
        let mut limit = Self { plan, variables, search, aim };
        limit.search.is_whole = limit.has_whole_numbers();
        limit.plan.base.check_any([0.5, 0.0, 1.0].map(|share| limit.design(0, limit.search.at(share)).settings))?;
        Ok(limit)
    }

    pub(super) fn variable(&self) -> &Variable {
        &self.variables[0].0
    }

    /// Result, with the run at the answer and the one on its other side.
    pub fn result(&self, runs: &RunTable) -> (Bracket, Option<usize>, Option<usize>) {
        let trials = self.trials(runs);
        let found = self.search.result(&trials);
        let place = |x: f64| runs.runs.iter().position(|run| run.value(0) == x);
        match found {
            Bracket::Between([inner, outer]) => {
                let trial = |x: f64| trials.iter().find(|trial| trial.0 == x).and_then(|trial| trial.1);
                let size = |x: f64| trial(x).map_or(f64::MAX, f64::abs);
                let is_swapped = matches!(self.aim, Aim::Reach(_)) && size(outer) < size(inner);
                let [best, other] = if is_swapped { [outer, inner] } else { [inner, outer] };
                (found, place(best), place(other))
            }
            Bracket::Everywhere(x) | Bracket::Open(x) => (found, place(x), None),
            _ => (found, None, None),
        }
    }

    pub(super) fn trials(&self, runs: &RunTable) -> Vec<Trial> {
        let value = |run: &Run| match &self.aim {
            Aim::Keep(condition) => condition.holds(run).map(|holds| if holds { 1.0 } else { -1.0 }),
            Aim::Reach(target) => {
                let (place, wanted) = target.resolved?;
                run.response(place).filter(|_| !run.tears()).map(|value| value - wanted)
            }
        };
        runs.runs.iter().map(|run| (run.value(0), value(run))).collect()
    }

    /// The first variable has this value, the others move along.
    pub(super) fn design(&self, index: u64, x: f64) -> Design {
        let share = self.search.share(x);
        let others = self.variables[1..].iter().map(|(_, range)| range.spacing.between(range.ends, share));
        let values: Vec<String> = [x].into_iter().chain(others).map(written).collect();
        let settings =
            self.variables.iter().zip(&values).map(|((variable, _), value)| variable.setting(value)).collect();
        Design { index, values, settings }
    }

    fn has_whole_numbers(&self) -> bool {
        let [low, high] = self.search.range.ends;
        let is_case = |x: f64| self.plan.base.case(&[self.variable().setting(&written(x))]).is_ok();
        let is_plain = self.variable().unit.is_empty() && low.fract() == 0.0 && high.fract() == 0.0;
        is_plain && is_case(low) && !is_case(low + 0.5) && is_case(low + 1.0)
    }

    pub(super) fn limits(&self) -> Vec<(usize, f64)> {
        match &self.aim {
            Aim::Keep(condition) => condition.limits(),
            Aim::Reach(target) => target.resolved.into_iter().collect(),
        }
    }
}

impl Study for LimitSearch {
    fn plan(&self) -> &Plan {
        &self.plan
    }

    fn check(&mut self, runs: &RunTable) -> Result<(), StudyError> {
        match &mut self.aim {
            Aim::Keep(condition) => condition.resolve(runs),
            Aim::Reach(target) => target.resolve(runs),
        }
    }

    fn next(&mut self, runs: &RunTable) -> Vec<Design> {
        let trials = self.trials(runs);
        (runs.runs.len() as u64..).zip(self.search.next(&trials)).map(|(index, x)| self.design(index, x)).collect()
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let (found, best, _) = self.result(runs);
        StudyReport {
            headline: self.headline(runs),
            notes: self.notes(runs),
            tables: vec![self.table(runs)],
            found: matches!(found, Bracket::Between(_) | Bracket::Everywhere(_)),
            charts: charts::search(self.variable(), self.search.range.spacing, runs, &self.limits(), best),
        }
    }
}

impl Aim {
    fn new(request: &SearchRequest, goal: Option<GoalAim>) -> Result<Self, StudyError> {
        let keep = |text: &str| Condition::read(text).map(Self::Keep);
        let reach = |text: &str| Comparison::target(text).map(Self::Reach);
        match (&request.condition, &request.target, goal) {
            (Some(_), Some(_), _) => fail("both a condition and a target are given", "give --while or --target"),
            (Some(condition), ..) => keep(condition),
            (_, Some(target), Some(GoalAim::Quantity(quantity))) if !target.contains('=') => {
                reach(&format!("{quantity}={target}"))
            }
            (_, Some(target), _) => reach(target),
            (_, _, Some(GoalAim::Condition(condition))) => keep(condition),
            (_, _, Some(GoalAim::Quantity(quantity))) => {
                let help = format!("give it with --target, such as \"{quantity}=90 deg\" or \"{quantity}=8 mm\"");
                fail(format!("the wanted value of {quantity} is missing"), help)
            }
            (None, None, None) => {
                fail("no condition is given", "give --while \"no red\", or --target \"QUANTITY=VALUE\"")
            }
        }
    }
}

/// A range from half to twice the case's own value.
fn around(key: &str, base: &BaseCase) -> Result<String, StudyError> {
    let key = key.trim();
    let own = base.value(key);
    let Some((value, unit)) = own.as_ref().and_then(|own| split_number(own.trim())).filter(|own| own.0 > 0.0) else {
        let what = format!("the case has no number at `{key}` to search about");
        return fail(what, format!("give the range: \"{key}=FROM..TO UNIT\""));
    };
    let [low, high] = [0.5, 2.0].map(|share| significant(share * value, 4));
    Ok(format!("{key}={low}..{high} {unit}"))
}

fn tolerance(variable: &Variable, text: &str) -> Result<f64, StudyError> {
    let unit = &variable.unit;
    let has_unit = parse(text).is_ok_and(|given| given.has_unit) != unit.is_empty();
    let size = variable.in_unit(text).filter(|size| *size > 0.0 && size.is_finite() && has_unit);
    size.map_or_else(
        || {
            let example = format!("write a number above 0 in the unit of the key, such as \"0.1 {unit}\"");
            fail(format!("`{text}` is no tolerance of {}", variable.key), example)
        },
        Ok,
    )
}
