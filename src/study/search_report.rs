//! Results of a search in words and as a table.

use super::bracket::{Bracket, Search, Side};
use super::report::{Cell, ReportTable};
use super::search::{LimitSearch, MISSED, SearchAim};
use super::{Run, RunTable};
use crate::units::significant;
use crate::verification::Origin;

impl LimitSearch {
    pub(super) fn headline(&self, runs: &RunTable) -> String {
        let variable = &self.variables[0];
        let (key, at) = (variable.label(), |x: f64| variable.display(x));
        let [low, high] = self.ranges[0].ends.map(at);
        let (found, best, _) = self.result(runs);
        match (&self.aim, found) {
            (_, Bracket::Failed) => format!("{key}: no run came to a result from {low} to {high}."),
            (SearchAim::Keep(condition), found) => {
                let condition = &condition.text;
                match (found, self.side) {
                    (Bracket::Between([inner, outer]), Side::Largest) => {
                        format!("{key}: “{condition}” holds up to {}, not at {}.", at(inner), at(outer))
                    }
                    (Bracket::Between([inner, outer]), Side::Smallest) => {
                        format!("{key}: “{condition}” holds from {}, not at {}.", at(inner), at(outer))
                    }
                    (Bracket::Everywhere(x), _) => {
                        format!("{key}: “{condition}” holds to the end of the range, {}.", at(x))
                    }
                    (Bracket::Open(x), _) => {
                        format!("{key}: “{condition}” holds at {}; beyond it no run came to a result.", at(x))
                    }
                    _ => format!("{key}: “{condition}” holds nowhere from {low} to {high}."),
                }
            }
            (SearchAim::Reach(target, resolved), _) => {
                let (name, Some((place, wanted))) = (&target.quantity, *resolved) else { return String::new() };
                let display = |value: f64| runs.responses[place].display(value);
                let Some(best) = best else {
                    return format!("{key}: {name} is {} nowhere from {low} to {high}.", display(wanted));
                };
                let run = &runs.runs[best];
                let (x, value) = (at(run.value(0)), display(run.numbers[place]));
                format!("{key} = {x}: {name} is {value}, wanted {}.", display(wanted))
            }
        }
    }

    pub(super) fn notes(&self, runs: &RunTable) -> Vec<String> {
        let at = |x: f64| self.variables[0].display(x);
        let trials = self.trials(runs);
        let (found, best, other) = self.result(runs);
        let mut notes = Vec::new();
        match (found, &self.aim) {
            (Bracket::Between([a, b]), SearchAim::Keep(_)) => {
                notes.push(format!("Known within {}.", at(significant((b - a).abs(), 2))));
            }
            (Bracket::Between(_), SearchAim::Reach(_, Some((place, wanted)))) => {
                let number = |run: Option<usize>| run.map_or(f64::NAN, |run| runs.runs[run].numbers[*place]);
                let [from, to] = [number(best), number(other)];
                if (from - wanted).abs().min((to - wanted).abs()) > MISSED * wanted.abs() {
                    let [from, to] = [from, to].map(|value| runs.responses[*place].display(value));
                    notes.push(format!("It jumps from {from} to {to} there."));
                }
            }
            _ => {}
        }
        if let Some([best, other]) = best
            .zip(other)
            .and_then(|(a, b)| Some([self.draw_ratio(runs, a)?, self.draw_ratio(runs, b)?]))
            .filter(|[a, b]| a != b)
        {
            notes.push(format!("Draw ratio {best:.3}, beyond it {other:.3}."));
        }
        if let (SearchAim::Keep(_), [_, _, ..]) = (&self.aim, &Search::stretches(&trials)[..]) {
            let stretches = Search::stretches(&trials);
            let all: Vec<String> = stretches.iter().map(|[from, to]| format!("{} to {}", at(*from), at(*to))).collect();
            notes.push(format!("It comes and goes over the range, and holds at {}.", all.join(", ")));
        }
        let red = best.map_or(&[][..], |best| &runs.runs[best].red);
        if let (SearchAim::Keep(_), false) = (&self.aim, red.is_empty()) {
            let labels: Vec<&str> = red.iter().map(|row| runs.label(row)).collect();
            notes.push(format!("Careful: red there is {}.", labels.join(", ")));
        }
        let failed = trials.iter().filter(|trial| trial.1.is_none()).count();
        if failed > 0 {
            notes.push(format!("{failed} of {} runs came to no result.", trials.len()));
        }
        notes
    }

    fn draw_ratio(&self, runs: &RunTable, run: usize) -> Option<f64> {
        crate::assess::estimate::draw_ratio(self.base_case().case(&self.settings_of(&runs.runs[run])).ok()?.model())
    }

    /// The answer and the run on its other side.
    pub(super) fn table(&self, runs: &RunTable) -> ReportTable {
        let (_, best, other) = self.result(runs);
        let sides: Vec<&Run> = best.into_iter().chain(other).map(|run| &runs.runs[run]).collect();
        let mut columns = vec![self.variables[0].label()];
        columns.extend(sides.iter().map(|run| self.variables[0].display(run.value(0))));
        let mut table = ReportTable { name: "search_result", columns, rows: Vec::new() };
        if sides.is_empty() {
            return table;
        }
        let light = |run: &&Run| {
            let keys = if run.red.is_empty() { &run.amber } else { &run.red };
            let labels: Vec<&str> = keys.iter().map(|key| runs.label(key)).collect();
            run.light.map_or(Cell::from("–"), |light| Cell::Light(light, labels.join(", ")))
        };
        table.rows.push(std::iter::once("Verdict".into()).chain(sides.iter().map(light)).collect());
        table.rows.push(std::iter::once("End".into()).chain(sides.iter().map(|run| run.end.clone().into())).collect());
        let asked: Vec<usize> = match &self.aim {
            SearchAim::Keep(condition) => condition.limits().map(|(place, _)| place).collect(),
            SearchAim::Reach(_, target) => target.iter().map(|(place, _)| *place).collect(),
        };
        for (place, response) in runs.responses.iter().enumerate() {
            if response.number.origin != Origin::Answer && !asked.contains(&place) {
                continue;
            }
            let cell = |run: &&Run| match run.numbers[place] {
                value if value.is_finite() => Cell::from(response.number.quantity.amount.of(value)),
                _ => Cell::from("–"),
            };
            let cells = std::iter::once(response.number.quantity.label.into()).chain(sides.iter().map(cell));
            table.rows.push(cells.collect());
        }
        table
    }
}
