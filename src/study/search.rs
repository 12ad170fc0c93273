//! Searches: the last value of a variable at which a condition holds, or the value at which a quantity is as wanted.

use super::bracket::{Search, Trial, stretches};
use super::charts;
use super::condition::Comparison;
use super::goals::Goal;
use super::variable::{SearchRange, split_number, written};
use super::{
    BaseCase, Bracket, Cell, Condition, Design, Plan, ReportTable, Run, RunTable, Side, Study, StudyError, StudyReport,
    Variable, fail,
};
use crate::assess::estimate;
use crate::results::error_bars::Origin;
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
    plan: Plan,
    /// The first is searched; each goes from its first end to its last.
    variables: Vec<(Variable, SearchRange)>,
    search: Search,
    aim: Aim,
}

/// A target that is missed by less is met, over its size \[–\].
const MISSED: f64 = 0.005;

#[derive(Clone, Debug)]
enum Aim {
    Keep(Condition),
    Reach(Comparison),
}

impl LimitSearch {
    /// Plans the search of a request.
    pub fn new(base: BaseCase, request: &SearchRequest) -> Result<Self, StudyError> {
        let goal = request.goal.as_ref().map(|name| Goal::request(name, &base.case(&[])?)).transpose()?;
        let base = match &goal {
            Some(goal) if !goal.settings.is_empty() => base.with_settings(&goal.settings)?,
            _ => base,
        };
        let vary = request.vary.as_ref().or(goal.as_ref().map(|goal| &goal.vary));
        let nothing = || StudyError::new("there is nothing to vary", "give --vary \"KEY=FROM..TO UNIT\", or --for");
        let variable = |text: &str| {
            let text = if text.contains('=') { text.to_owned() } else { around(text.trim(), &base)? };
            let variable = Variable::read(&text)?;
            let range = variable.search_range()?;
            Ok((variable, range))
        };
        let mut variables =
            vary.ok_or_else(nothing)?.split('&').map(variable).collect::<Result<Vec<_>, StudyError>>()?;
        if variables[0].1.ends[0] > variables[0].1.ends[1] {
            variables.iter_mut().for_each(|(_, range)| range.ends.reverse());
        }
        let aim = Aim::new(request, goal.as_ref())?;
        let is_limit = matches!(aim, Aim::Keep(_));
        let side = request.side.or(goal.map(|goal| goal.side)).or((!is_limit).then_some(Side::Smallest));
        let (what, help) = ("neither the largest nor the smallest is asked for", "give --largest or --smallest");
        let side = side.ok_or_else(|| StudyError::new(what, help))?;
        let tolerance = request.tolerance.as_ref().map(|text| tolerance(&variables[0].0, text)).transpose()?;
        let columns = variables.iter().map(|(variable, _)| variable.header()).collect();
        let plan = Plan::new(base, &format!("{variables:?}{tolerance:?}{aim:?}{side:?}"), columns, 0);
        let search = Search { range: variables[0].1, tolerance, is_whole: false, is_limit, side };
        let mut limit = Self { plan, variables, search, aim };
        limit.search.is_whole = limit.has_whole_numbers();
        limit.plan.base.check_any([0.5, 0.0, 1.0].map(|share| limit.design(0, limit.search.at(share)).settings))?;
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
            _ => (found, None, None),
        }
    }

    fn trials(&self, runs: &RunTable) -> Vec<Trial> {
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
    fn design(&self, index: u64, x: f64) -> Design {
        let share = self.search.share(x);
        let others = self.variables[1..].iter().map(|(_, range)| range.spacing.between(range.ends, share));
        let values: Vec<String> = [x].into_iter().chain(others).map(written).collect();
        let settings = self.variables.iter().zip(&values).map(|((variable, _), value)| variable.setting(value));
        Design { index, settings: settings.collect(), values }
    }

    fn has_whole_numbers(&self) -> bool {
        let [low, high] = self.search.range.ends;
        let is_case = |x: f64| self.plan.base.case(&[self.variable().setting(&written(x))]).is_ok();
        let is_plain = self.variable().unit.is_empty() && low.fract() == 0.0 && high.fract() == 0.0;
        is_plain && is_case(low) && !is_case(low + 0.5) && is_case(low + 1.0)
    }

    fn limits(&self) -> Vec<(usize, f64)> {
        match &self.aim {
            Aim::Keep(condition) => condition.limits(),
            Aim::Reach(target) => target.resolved.into_iter().collect(),
        }
    }

    fn headline(&self, runs: &RunTable) -> String {
        let (key, at) = (self.variable().label(), |x: f64| self.variable().display(x));
        let [low, high] = self.search.range.ends.map(at);
        let (found, best, _) = self.result(runs);
        match (&self.aim, found) {
            (_, Bracket::Failed) => format!("{key}: no run came to a result from {low} to {high}."),
            (Aim::Keep(Condition { text, .. }), found) => {
                let holds = match found {
                    Bracket::Between([inner, outer]) => {
                        let side = if self.search.side == Side::Largest { "up to" } else { "from" };
                        format!("{side} {}, not at {}", at(inner), at(outer))
                    }
                    Bracket::Everywhere(x) => format!("to the end of the range, {}", at(x)),
                    Bracket::Open(x) => format!("at {}; beyond it no run came to a result", at(x)),
                    _ => format!("nowhere from {low} to {high}"),
                };
                format!("{key}: “{text}” holds {holds}.")
            }
            (Aim::Reach(target), _) => {
                let (name, Some((place, wanted))) = (&target.quantity, target.resolved) else { return String::new() };
                let wanted = runs.display(place, wanted);
                match best.map(|best| &runs.runs[best]) {
                    None => format!("{key}: {name} is {wanted} nowhere from {low} to {high}."),
                    Some(run) => {
                        let (x, value) = (at(run.value(0)), runs.display(place, run.numbers[place]));
                        format!("{key} = {x}: {name} is {value}, wanted {wanted}.")
                    }
                }
            }
        }
    }

    fn notes(&self, runs: &RunTable) -> Vec<String> {
        let at = |x: f64| self.variable().display(x);
        let trials = self.trials(runs);
        let (found, best, other) = self.result(runs);
        let best = best.map(|best| &runs.runs[best]);
        let other = other.map(|other| &runs.runs[other]);
        let mut notes = Vec::new();
        if let (Aim::Keep(_), Bracket::Between([a, b])) = (&self.aim, found) {
            notes.push(format!("Known within {}.", at(significant((b - a).abs(), 2))));
        }
        if let (Aim::Reach(Comparison { resolved: Some((place, wanted)), .. }), Some((best, other))) =
            (&self.aim, best.zip(other))
        {
            let [from, to] = [best, other].map(|run| run.numbers[*place]);
            if (from - wanted).abs().min((to - wanted).abs()) > MISSED * wanted.abs() {
                let [from, to] = [from, to].map(|value| runs.display(*place, value));
                notes.push(format!("It jumps from {from} to {to} there."));
            }
        }
        let draw_ratio = |run: &Run| {
            let case = self.plan.base.case(&self.design(0, run.value(0)).settings).ok()?;
            estimate::draw_ratio(case.model())
        };
        let ratios = best.zip(other).and_then(|(best, other)| draw_ratio(best).zip(draw_ratio(other)));
        if let Some((best, other)) = ratios.filter(|(best, other)| best != other) {
            notes.push(format!("Draw ratio {best:.3}, beyond it {other:.3}."));
        }
        if let Aim::Keep(_) = self.aim {
            let all = stretches(&trials).into_iter().map(|[from, to]| format!("{} to {}", at(from), at(to)));
            let all: Vec<String> = all.collect();
            if all.len() > 1 {
                notes.push(format!("It comes and goes over the range, and holds at {}.", all.join(", ")));
            }
            let red = best.filter(|run| !run.red.is_empty());
            notes.extend(red.map(|run| format!("Careful: red there is {}.", runs.worst_rows(run))));
        }
        let failed = trials.iter().filter(|trial| trial.1.is_none()).count();
        if failed > 0 {
            notes.push(format!("{failed} of {} runs came to no result.", trials.len()));
        }
        notes
    }

    fn table(&self, runs: &RunTable) -> ReportTable {
        let (_, best, other) = self.result(runs);
        let sides: Vec<&Run> = best.into_iter().chain(other).map(|run| &runs.runs[run]).collect();
        let values = sides.iter().map(|run| self.variable().display(run.value(0)));
        let columns = [self.variable().label().to_owned()].into_iter().chain(values).collect();
        let row = |label: &str, cell: &dyn Fn(&Run) -> Cell| -> Vec<Cell> {
            [label.into()].into_iter().chain(sides.iter().map(|run| cell(run))).collect()
        };
        let verdict = |run: &Run| run.light.map_or("–".into(), |light| Cell::Light(light, runs.worst_rows(run)));
        let mut rows = vec![row("Verdict", &verdict), row("End", &|run| run.end.clone().into())];
        let limits = self.limits();
        for (place, response) in runs.responses.iter().enumerate() {
            if response.origin == Origin::Answer || limits.iter().any(|(limited, _)| *limited == place) {
                let value = |run: &Run| Some(run.numbers[place]).filter(|value| value.is_finite());
                let amount = |value| response.quantity.amount.with_value(value).into();
                rows.push(row(response.quantity.label, &|run| value(run).map_or("–".into(), amount)));
            }
        }
        rows.retain(|_| !sides.is_empty());
        ReportTable { name: "search_result", columns, rows }
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
        let values = self.search.next(&self.trials(runs));
        (runs.runs.len() as u64..).zip(values).map(|(index, x)| self.design(index, x)).collect()
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
    fn new(request: &SearchRequest, goal: Option<&Goal>) -> Result<Self, StudyError> {
        let (condition, quantity) = goal.map_or((None, None), |goal| (goal.condition, goal.quantity));
        match (&request.condition, &request.target) {
            (Some(_), Some(_)) => fail("both a condition and a target are given", "give --while or --target"),
            (Some(condition), None) => Condition::read(condition).map(Self::Keep),
            (None, Some(target)) => {
                let named = quantity.filter(|_| !target.contains('=')).map(|quantity| format!("{quantity}={target}"));
                Comparison::target(named.as_ref().unwrap_or(target)).map(Self::Reach)
            }
            (None, None) => {
                let help = "give --while \"no red\", or --target \"QUANTITY=VALUE\"";
                let what = quantity
                    .map_or("no condition is given".to_owned(), |q| format!("the wanted value of {q} is missing"));
                condition.map_or_else(|| fail(what, help), Condition::read).map(Self::Keep)
            }
        }
    }
}

/// A range from half to twice the case's own value.
fn around(key: &str, base: &BaseCase) -> Result<String, StudyError> {
    let own = base.value(key);
    let number = own.as_ref().and_then(|own| split_number(own.trim())).filter(|own| own.0 > 0.0);
    let what = format!("the case has no number at `{key}` to search about");
    let missing = || StudyError::new(what, format!("give the range: \"{key}=FROM..TO UNIT\""));
    let (value, unit) = number.ok_or_else(missing)?;
    let [low, high] = [0.5, 2.0].map(|share| significant(share * value, 4));
    Ok(format!("{key}={low}..{high} {unit}"))
}

fn tolerance(variable: &Variable, text: &str) -> Result<f64, StudyError> {
    let unit = &variable.unit;
    let has_unit = parse(text).is_ok_and(|given| given.has_unit) != unit.is_empty();
    let size = variable.in_unit(text).filter(|size| *size > 0.0 && size.is_finite() && has_unit);
    let help = format!("write a number above 0 in the unit of the key, such as \"0.1 {unit}\"");
    size.ok_or_else(|| StudyError::new(format!("`{text}` is no tolerance of {}", variable.key), help))
}
