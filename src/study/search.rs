//! Searches: the last value of a variable at which a condition holds, or the value at which a quantity is as wanted.

use super::bracket::{Search, Trial};
use super::goals::{Goal, holder_setting};
use super::variable::{SearchRange, check_distinct};
use super::{charts::Charts, *};
use crate::assess::estimate;
use crate::plot::{Axis, axis::capitalised};

/// Request of a search, as on the command line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SearchRequest {
    /// `KEY=FROM..TO UNIT`.
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
    plan: Plan,
    /// The first is searched; each goes from its first end to its last.
    variables: Vec<(Variable, SearchRange)>,
    search: Search,
    values: Vec<f64>,
    /// Condition to keep, or target to reach.
    aim: Condition,
    goal: Goal,
}

/// A target that is missed by less is met, over its size \[–\].
const MISSED: f64 = 0.005;

impl LimitSearch {
    /// Plans the search of a request.
    pub fn new(base: BaseCase, request: &SearchRequest) -> Result<Self> {
        let goal = request.goal.as_ref().map(|name| Goal::request(name, &base.case(&[])?)).transpose()?;
        let goal = goal.unwrap_or_default();
        let base = if goal.settings.is_empty() { base } else { base.with_settings(&goal.settings)? };
        let nothing = || StudyError::new("there is nothing to vary", "give --vary \"KEY=FROM..TO UNIT\", or --for");
        let vary = request.vary.as_ref().or(goal.vary.as_ref()).ok_or_else(nothing)?;
        let variable = |text: &str| Variable::read(text).and_then(|v| Ok((v.clone(), v.search_range()?)));
        let mut variables = vary.split('&').map(variable).collect::<Result<Vec<_>>>()?;
        if variables[0].1.ends[0] > variables[0].1.ends[1] {
            variables.iter_mut().for_each(|(_, range)| range.ends.reverse());
        }
        check_distinct(variables.iter().map(|(variable, _)| variable), "is varied twice", "give each key once")?;
        let target = request.target.clone().or(goal.wanted.clone().filter(|_| request.condition.is_none()));
        let request = &SearchRequest { target, ..request.clone() };
        let aim = aim(request, &goal)?;
        let is_limit = request.target.is_none();
        let side = request.side.or(goal.side).or((!is_limit).then_some(Side::Smallest));
        let (what, help) = ("neither the largest nor the smallest is asked for", "give --largest or --smallest");
        let side = side.ok_or_else(|| StudyError::new(what, help))?;
        let tolerance = request.tolerance.as_ref().map(|text| tolerance(&variables[0].0, text)).transpose()?;
        let columns = variables.iter().map(|(variable, _)| variable.header()).collect();
        let plan = Plan::new(base, &format!("{variables:?}{request:?}"), columns, 0);
        let search = Search { range: variables[0].1, tolerance, is_limit, side };
        let goal = Goal { holder: goal.holder.filter(|_| request.vary.is_none()), ..goal };
        let limit = Self { plan, variables, search, values: Vec::new(), aim, goal };
        if request.vary.is_some() {
            limit.plan.base.check_effective(&limit.trial(0, limit.search.at(0.5)).settings)?;
        }
        limit.plan.base.check_any([0.5, 0.0, 1.0].map(|share| limit.trial(0, limit.search.at(share)).settings))?;
        Ok(limit)
    }

    fn variable(&self) -> &Variable {
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
                let is_swapped = !self.search.is_limit && size(outer) < size(inner);
                let [best, other] = if is_swapped { [outer, inner] } else { [inner, outer] };
                (found, place(best), place(other))
            }
            Bracket::Everywhere(x) | Bracket::Open(x) => (found, place(x), None),
            Bracket::Nowhere | Bracket::Failed => {
                let nearest = self.nearest(runs).filter(|(_, missed)| missed.abs() <= self.goal.tolerance);
                (found, nearest.map(|(place, _)| place), None)
            }
        }
    }

    fn nearest(&self, runs: &RunTable) -> Option<(usize, f64)> {
        self.target()?;
        let missed = self.trials(runs).into_iter().enumerate().filter_map(|(i, trial)| Some((i, trial.1?)));
        missed.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
    }

    fn failure(&self, runs: &RunTable, run: &Run) -> Option<String> {
        let at = self.variable().display(run.value(0));
        let pulled = runs.response("tearing").ok().filter(|place| run.numbers[*place] >= 100.0);
        let pulled = pulled.map_or_else(String::new, |place| format!(" ({})", runs.display(place, run.numbers[place])));
        match run.failures.first()? {
            FailureMode::Tears => Some(format!("at {at} it tears{pulled}")),
            FailureMode::NoResult => Some(format!("at {at} it comes to no result")),
            _ => Some(format!("at {at} red is {}", runs.labels(&run.red))),
        }
    }

    fn unreached(&self, runs: &RunTable, place: usize, wanted: &str) -> Option<String> {
        let (best, missed) = self.nearest(runs).map(|(best, missed)| (&runs.runs[best], missed))?;
        let (x, value) = (best.value(0), best.numbers[place]);
        let failed = runs.runs.iter().filter(|run| run.tears() || !run.is_known());
        let beside = failed.min_by(|a, b| (a.value(0) - x).abs().total_cmp(&(b.value(0) - x).abs()));
        let beside = beside.and_then(|run| self.failure(runs, run)).unwrap_or_default();
        let at = self.variable().display(x);
        let remedy = self.goal.remedy.filter(|_| missed > 0.0).map_or_else(String::new, |(remedy, to)| {
            format!(" Take it to {at} and {remedy} {}.", runs.display(place, to.map_or(missed, |to| value - to)))
        });
        let (key, lights) = (self.variable().label(), runs.lights_there(best));
        let nearest = joined([format!("{} at {at}{lights}", runs.display(place, value)), beside], ", ");
        Some(format!("{key}: {} of {wanted} is not reached: {nearest}.{remedy}", self.aim.text))
    }

    fn trials(&self, runs: &RunTable) -> Vec<Trial> {
        let value = |run: &Run| match self.target() {
            None => self.aim.holds(run).map(|holds| if holds { 1.0 } else { -1.0 }),
            Some((place, wanted)) => run.response(place).filter(|_| !run.tears()).map(|value| value - wanted),
        };
        runs.runs.iter().map(|run| (run.value(0), value(run))).collect()
    }

    fn target(&self) -> Option<(usize, f64)> {
        self.aim.limits().first().copied().filter(|_| !self.search.is_limit)
    }

    fn trial(&self, index: u64, x: f64) -> Design {
        let share = self.search.share(x);
        let others = self.variables[1..].iter().map(|(_, range)| range.spacing.between(range.ends, share));
        let values: Vec<String> = [x].into_iter().chain(others).map(written).collect();
        let settings = self.variables.iter().zip(&values).map(|((variable, _), value)| variable.setting(value));
        let settings = settings.chain(self.goal.holder.map(|rule| holder_setting(rule, x)));
        Design { index, settings: settings.collect(), values }
    }

    fn headline(&self, runs: &RunTable) -> String {
        let (key, name, at) = (self.variable().label(), &self.aim.text, |x: f64| self.variable().display(x));
        let [low, high] = self.search.range.ends.map(at);
        let (found, best, _) = self.result(runs);
        let holds = match (found, self.target().map(|(place, wanted)| (place, runs.display(place, wanted))), best) {
            (Bracket::Failed, ..) => return format!("{key}: every run from {low} to {high} tears or has no result."),
            (_, Some((place, wanted)), Some(best)) => {
                let best = &runs.runs[best];
                let [x, value] = [at(best.value(0)), runs.display(place, best.numbers[place])];
                return format!("{key} = {x}: {name} is {value}, wanted {wanted}{}.", runs.lights_there(best));
            }
            (_, Some((place, wanted)), None) => return self.unreached(runs, place, &wanted).unwrap_or_default(),
            (Bracket::Between([inner, outer]), ..) => {
                let side = if self.search.side == Side::Largest { "up to" } else { "from" };
                format!("{side} {}, not at {}", at(inner), at(outer))
            }
            (Bracket::Everywhere(x), ..) => format!("to the end of the range, {}", at(x)),
            (Bracket::Open(x), ..) => format!("at {}; beyond it no run came to a result", at(x)),
            (Bracket::Nowhere, ..) => format!("nowhere from {low} to {high}"),
        };
        format!("{key}: “{name}” holds {holds}.")
    }

    fn notes(&self, runs: &RunTable) -> Vec<String> {
        let (found, best, other) = self.result(runs);
        let [best, other] = [best, other].map(|place| place.map(|place| &runs.runs[place]));
        let mut notes = Vec::new();
        if let (None, Bracket::Between([a, b])) = (self.target(), found) {
            notes.push(format!("Known within {}.", self.variable().display(significant((b - a).abs(), 2))));
        }
        if let (Some((place, wanted)), Some(best), Some(other)) = (self.target(), best, other) {
            let [from, to] = [best, other].map(|run| run.numbers[place]);
            if (from - wanted).abs().min((to - wanted).abs()) > MISSED * wanted.abs() {
                let [from, to] = [from, to].map(|value| runs.display(place, value));
                notes.push(format!("It jumps from {from} to {to} there."));
            }
        }
        notes.extend(other.and_then(|other| self.failure(runs, other)).map(|text| capitalised(&text) + "."));
        notes.extend(self.goal.note.clone());
        let case = |run: &Run| self.plan.base.case(&self.trial(0, run.value(0)).settings).ok();
        let draw_ratio = |run: &Run| estimate::draw_ratio(case(run)?.model());
        let ratios = best.zip(other).and_then(|(best, other)| draw_ratio(best).zip(draw_ratio(other)));
        let ratios = ratios.filter(|(best, other)| best != other);
        notes.extend(ratios.map(|(best, other)| format!("Draw ratio {best:.3}, beyond it {other:.3}.")));
        notes.extend(self.goal.holder.zip(best).map(|(rule, best)| {
            let force = Amount::force(rule.force(best.value(0)), Unit::N);
            format!("The holder's force follows Siebel's rule as the blank grows: {force} there.")
        }));
        let red = best.filter(|run| self.search.is_limit && !run.red.is_empty());
        notes.extend(red.map(|run| format!("Careful: red there is {}.", runs.labels(&run.red))));
        let failed = runs.runs.iter().filter(|run| !run.is_known()).count();
        let some = format!("{failed} of {} runs came to no result.", runs.runs.len());
        notes.extend(runs.no_result().or((failed > 0).then_some(some)));
        notes
    }

    fn charts(&self, runs: &RunTable, best: Option<usize>) -> Charts {
        let (label, (unit, factor)) = (self.variable().label(), self.variable().axis_unit());
        let positions: Vec<(f64, &Run)> = runs.runs.iter().map(|run| (factor * run.value(0), run)).collect();
        let result = best.map(|best| positions[best]);
        let limits = self.aim.limits().into_iter().map(|(place, limit)| (place, Some(limit)));
        let others = charts::decisive(runs, 1).into_iter().map(|place| (place, None));
        let numbers = if limits.len() > 0 { limits.collect() } else { others.collect() };
        let x = Axis::named(label, unit).spaced(self.search.range.spacing);
        let panels = charts::trends(runs, &x, positions, numbers, result, Some("Result"));
        charts::chart("search", &format!("Search: {label}"), panels)
    }
}

impl Study for LimitSearch {
    fn plan(&self) -> &Plan {
        &self.plan
    }

    fn check(&mut self, runs: &RunTable) -> Result<()> {
        self.aim.resolve(runs)
    }

    fn known(&mut self, runs: &RunTable) -> u64 {
        self.values.truncate(runs.runs.len());
        self.values.extend(self.search.next(&self.trials(runs)));
        self.values.len() as u64
    }

    fn design(&self, index: u64) -> Design {
        self.trial(index, self.values[index as usize])
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let (found, best, _) = self.result(runs);
        let found = best.is_some() && !matches!(found, Bracket::Open(_));
        let (headline, notes, charts) = (self.headline(runs), self.notes(runs), self.charts(runs, best));
        StudyReport { headline, notes, tables: Vec::new(), found, charts }
    }
}

fn aim(request: &SearchRequest, goal: &Goal) -> Result<Condition> {
    match (&request.condition, &request.target, goal.quantity) {
        (Some(_), Some(_), _) => fail("both a condition and a target are given", "give --while or --target"),
        (None, Some(value), Some(key)) if !value.contains('=') => Condition::target(&format!("{key}={value}")),
        (None, Some(target), _) => Condition::target(target),
        (condition, None, quantity) => {
            let missing = |quantity| format!("the wanted value of {quantity} is missing");
            let what = quantity.map_or_else(|| "no condition is given".to_owned(), missing);
            let help = "give --while \"no red\", or --target \"QUANTITY=VALUE\"";
            condition.as_deref().or(goal.condition).map_or_else(|| fail(what, help), Condition::read)
        }
    }
}

fn tolerance(variable: &Variable, text: &str) -> Result<f64> {
    let (key, unit) = (&variable.key, &variable.unit);
    let size = in_unit(text, unit).filter(|size| *size > 0.0 && size.is_finite());
    let help = format!("write a number above 0 in the unit of the key, such as \"0.1 {unit}\"");
    size.ok_or_else(|| StudyError::new(format!("`{text}` is no tolerance of {key}"), help))
}
