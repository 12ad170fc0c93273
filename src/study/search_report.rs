//! Results of a search in words and as a table.

use super::bracket::stretches;
use super::condition::Comparison;
use super::search::Aim;
use super::{Bracket, Cell, Condition, LimitSearch, ReportTable, Run, RunTable, Side};
use crate::assess::estimate;
use crate::results::error_bars::Origin;
use crate::units::significant;

/// A target that is missed by less is met, over its size \[–\].
const MISSED: f64 = 0.005;

impl LimitSearch {
    pub(super) fn headline(&self, runs: &RunTable) -> String {
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
                let display = |value: f64| runs.display(place, value);
                let Some(run) = best.map(|best| &runs.runs[best]) else {
                    return format!("{key}: {name} is {} nowhere from {low} to {high}.", display(wanted));
                };
                let (x, value) = (at(run.value(0)), display(run.numbers[place]));
                format!("{key} = {x}: {name} is {value}, wanted {}.", display(wanted))
            }
        }
    }

    pub(super) fn notes(&self, runs: &RunTable) -> Vec<String> {
        let at = |x: f64| self.variable().display(x);
        let trials = self.trials(runs);
        let (found, best, other) = self.result(runs);
        let mut notes = Vec::new();
        match (found, &self.aim) {
            (Bracket::Between([a, b]), Aim::Keep(_)) => {
                notes.push(format!("Known within {}.", at(significant((b - a).abs(), 2))));
            }
            (Bracket::Between(_), Aim::Reach(Comparison { resolved: Some((place, wanted)), .. })) => {
                let [from, to] = [best, other].map(|run| run.map_or(f64::NAN, |run| runs.runs[run].numbers[*place]));
                if (from - wanted).abs().min((to - wanted).abs()) > MISSED * wanted.abs() {
                    let [from, to] = [from, to].map(|value| runs.display(*place, value));
                    notes.push(format!("It jumps from {from} to {to} there."));
                }
            }
            _ => {}
        }
        let draw_ratio = |run: usize| {
            let case = self.plan.base.case(&self.design(0, runs.runs[run].value(0)).settings).ok()?;
            estimate::draw_ratio(case.model())
        };
        let ratios = best.zip(other).and_then(|(best, other)| draw_ratio(best).zip(draw_ratio(other)));
        if let Some((best, other)) = ratios.filter(|(best, other)| best != other) {
            notes.push(format!("Draw ratio {best:.3}, beyond it {other:.3}."));
        }
        if let Aim::Keep(_) = self.aim {
            let all: Vec<String> =
                stretches(&trials).iter().map(|[from, to]| format!("{} to {}", at(*from), at(*to))).collect();
            if all.len() > 1 {
                notes.push(format!("It comes and goes over the range, and holds at {}.", all.join(", ")));
            }
            if let Some(run) = best.map(|best| &runs.runs[best]).filter(|run| !run.red.is_empty()) {
                notes.push(format!("Careful: red there is {}.", runs.worst_rows(run)));
            }
        }
        let failed = trials.iter().filter(|trial| trial.1.is_none()).count();
        if failed > 0 {
            notes.push(format!("{failed} of {} runs came to no result.", trials.len()));
        }
        notes
    }

    pub(super) fn table(&self, runs: &RunTable) -> ReportTable {
        let (_, best, other) = self.result(runs);
        let sides: Vec<&Run> = best.into_iter().chain(other).map(|run| &runs.runs[run]).collect();
        let values = sides.iter().map(|run| self.variable().display(run.value(0)));
        let columns = [self.variable().label().to_owned()].into_iter().chain(values).collect();
        let mut table = ReportTable { name: "search_result", columns, rows: Vec::new() };
        if sides.is_empty() {
            return table;
        }
        let mut add = |label: &str, cell: &dyn Fn(&Run) -> Cell| {
            table.rows.push([label.into()].into_iter().chain(sides.iter().map(|run| cell(run))).collect());
        };
        add("Verdict", &|run| run.light.map_or("–".into(), |light| Cell::Light(light, runs.worst_rows(run))));
        add("End", &|run| run.end.clone().into());
        let limits = self.limits();
        for (place, response) in runs.responses.iter().enumerate() {
            if response.origin == Origin::Answer || limits.iter().any(|(limited, _)| *limited == place) {
                let amount = |value| response.quantity.amount.of(value).into();
                let value = |run: &Run| Some(run.numbers[place]).filter(|value| value.is_finite());
                add(response.quantity.label, &|run| value(run).map_or("–".into(), amount));
            }
        }
        table
    }
}
