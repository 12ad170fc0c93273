//! Sweeps: every combination of the variables' values, or each key by itself.

use super::charts;
use super::variable::{number, repeated};
use super::{
    BaseCase, Cell, Design, FailureMode, Plan, ReportTable, Run, RunTable, Study, StudyError, StudyFile, StudyReport,
    Variable, fail,
};
use crate::assess::Light;
use crate::plot;
use crate::units::joined;
use std::path::Path;

/// A full factorial design, or one key at a time.
#[derive(Clone, Debug)]
pub struct Sweep {
    plan: Plan,
    /// The last axis varies fastest.
    pub(super) axes: Vec<Axis>,
    one_at_a_time: bool,
}

/// Variables that move together; the first names the axis.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub variables: Vec<Variable>,
    values: Vec<Vec<String>>,
    pub(super) own: Option<f64>,
}

const DRAWN: usize = 10_000;

impl Axis {
    fn read(text: &str, base: &BaseCase) -> Result<Self, StudyError> {
        let variables = text.split('&').map(Variable::read).collect::<Result<Vec<_>, _>>()?;
        let values = variables.iter().map(Variable::values).collect::<Result<Vec<_>, _>>()?;
        if let Some(i) = (1..values.len()).find(|&i| values[i].len() != values[0].len()) {
            let counted = |i: usize| format!("{} has {} values", variables[i].key, values[i].len());
            return fail(format!("{} but {}", counted(0), counted(i)), "keys that move together have as many values");
        }
        let mut axis = Self { variables, values, own: None };
        let variable = &axis.variables[0];
        axis.own = base.value(&variable.key).and_then(|own| match axis.names() {
            [] => Some(variable.axis_unit().1 * variable.in_unit(&own)?),
            names => names.iter().position(|name| *name == own).map(|place| place as f64),
        });
        Ok(axis)
    }

    pub fn count(&self) -> usize {
        self.values[0].len()
    }

    /// Values as words; empty for numbers.
    pub fn names(&self) -> &[String] {
        let is_numeric = self.values[0].iter().all(|value| number(value).is_some());
        if is_numeric { &[] } else { &self.values[0] }
    }

    /// Positions along the axis, in its solver unit; the index for words.
    pub fn positions(&self) -> Vec<f64> {
        let (_, factor) = self.variables[0].axis_unit();
        let position = |(i, value): (usize, &String)| number(value).map_or(i as f64, |number| factor * number);
        self.values[0].iter().enumerate().map(position).collect()
    }

    /// Axis of a picture.
    pub fn drawn(&self) -> plot::Axis {
        let label = self.variables[0].label();
        match self.names() {
            [] => plot::Axis::named(label, self.variables[0].axis_unit().0),
            names => plot::Axis::of_names(label, names.to_vec()),
        }
    }

    /// A value with its unit.
    pub fn display(&self, i: usize) -> String {
        format!("{} {}", self.values[0][i], self.variables[0].unit).trim_end().to_owned()
    }

    /// `Holder force 5 kN`.
    pub fn describe(&self, i: usize) -> String {
        format!("{} {}", self.variables[0].label(), self.display(i))
    }

    fn settings(&self, i: usize) -> impl Iterator<Item = String> {
        self.variables.iter().zip(&self.values).map(move |(variable, values)| variable.setting(&values[i]))
    }
}

impl Sweep {
    /// Reads a case or study file; `vary` replaces the study's own variables.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String], one_at_a_time: bool) -> Result<Self, StudyError> {
        let file = StudyFile::load(path, set, vary)?;
        Self::new(BaseCase::load(file.case, file.set)?, &file.variables, one_at_a_time || file.one_at_a_time)
    }

    /// Varies a case by `KEY=VALUES` texts.
    pub fn new(base: BaseCase, vary: &[String], one_at_a_time: bool) -> Result<Self, StudyError> {
        let axes = vary.iter().map(|text| Axis::read(text, &base)).collect::<Result<Vec<_>, _>>()?;
        if axes.is_empty() {
            return fail("nothing of the case is varied", "give --vary KEY=VALUES, as often as needed");
        }
        if let Some(key) = repeated(axes.iter().flat_map(|axis| &axis.variables)) {
            return fail(format!("{key} is varied twice"), "give all its values at once");
        }
        let counts = || axes.iter().map(|axis| axis.count() as u64);
        let Some(all) = counts().try_fold(1u64, u64::checked_mul) else {
            return fail("more designs than can be counted", "fewer values, or `scatter` for a sample");
        };
        for axis in &axes {
            let last = axis.count() - 1;
            base.check_any([0, last / 2, last].map(|i| axis.settings(i).collect()))?;
        }
        let designs = if one_at_a_time { 1 + counts().sum::<u64>() } else { all };
        let columns = axes.iter().flat_map(|axis| &axis.variables).map(Variable::header).collect();
        let values: Vec<_> = axes.iter().map(|axis| (&axis.variables, &axis.values)).collect();
        let plan = Plan::new(base, &format!("{values:?}{one_at_a_time}"), columns, designs);
        Ok(Self { plan, axes, one_at_a_time })
    }

    /// Whether error bars are usual: over one key.
    pub fn has_error_bars(&self) -> bool {
        self.axes.len() == 1 && !self.one_at_a_time
    }

    /// Place of a design on every axis; `None` where the case keeps its own value.
    pub(super) fn places(&self, index: u64) -> Vec<Option<usize>> {
        let counts = self.axes.iter().map(|axis| axis.count() as u64);
        if self.one_at_a_time {
            // Design 0 is the base case.
            let mut before = 1;
            let place = |count: u64| {
                let own = index.checked_sub(before).filter(|place| *place < count);
                before += count;
                own.map(|place| place as usize)
            };
            return counts.map(place).collect();
        }
        let mut rest = index;
        let place = |count: u64| {
            let place = rest % count;
            rest /= count;
            Some(place as usize)
        };
        let mut places: Vec<_> = counts.rev().map(place).collect();
        places.reverse();
        places
    }

    fn design(&self, index: u64) -> Design {
        let places = self.places(index);
        let pairs = || self.axes.iter().zip(&places);
        let values = pairs().flat_map(|(axis, place)| {
            axis.values.iter().map(move |values| place.map_or_else(String::new, |i| values[i].clone()))
        });
        let settings = pairs().flat_map(|(axis, place)| place.iter().flat_map(|i| axis.settings(*i)));
        Design { index, values: values.collect(), settings: settings.collect() }
    }

    fn notes(&self, runs: &RunTable) -> Vec<String> {
        let mut notes = Vec::new();
        if let Some(place) = charts::deciding(runs, 1).first().copied() {
            let sound = || runs.runs.iter().filter(|run| run.is_sound() && run.numbers[place].is_finite());
            let by = |a: &&Run, b: &&Run| a.numbers[place].total_cmp(&b.numbers[place]);
            if let Some((least, most)) = sound().min_by(by).zip(sound().max_by(by)).filter(|(a, b)| a.index != b.index)
            {
                let describe = |run: &Run| {
                    let values = self.axes.iter().zip(self.places(run.index));
                    let values = values.filter_map(|(axis, place)| Some(axis.describe(place?)));
                    format!("{} ({})", runs.display(place, run.numbers[place]), joined(values, ", "))
                };
                let (label, least, most) = (runs.responses[place].quantity.label, describe(least), describe(most));
                notes.push(format!("{label} of sound designs: {least} to {most}."));
            }
        }
        let modes = joined(runs.base.failures.iter().map(|mode| mode.label().to_owned()), ", ");
        notes.push(match (modes.as_str(), runs.base.light) {
            ("", Some(Light::Amber)) => "The case as it stands is sound, with amber rows.".into(),
            ("", _) => "The case as it stands is sound.".into(),
            _ => format!("The case as it stands fails: {modes}."),
        });
        notes
    }

    /// Effects of the variables on a number, the largest first.
    pub fn sensitivities(&self, runs: &RunTable, response: usize) -> Vec<Sensitivity> {
        let Some(own) = runs.runs.first().map(|run| run.numbers[response]).filter(|own| own.is_finite()) else {
            return Vec::new();
        };
        let one = |axis: usize| {
            let end = |run: &Run| {
                let (place, number) = (self.places(run.index)[axis]?, run.response(response)?);
                Some(End { number, place, is_sound: run.is_sound() })
            };
            Sensitivity { axis, own, ends: runs.runs.iter().skip(1).filter_map(end).collect() }
        };
        let mut all: Vec<Sensitivity> = (0..self.axes.len()).map(one).filter(|s| s.width() > 0.0).collect();
        all.sort_by(|a, b| b.width().total_cmp(&a.width()));
        all
    }

    fn sensitivity_table(&self, runs: &RunTable) -> ReportTable {
        let columns = ["Number", "Key", "As it stands", "Least", "at", "Largest", "at value"];
        let mut table = ReportTable::new("sensitivities", &columns);
        for response in charts::deciding(runs, 4) {
            let number = &runs.responses[response];
            for s in self.sensitivities(runs, response) {
                let Some(ends) = s.extremes() else { continue };
                let (axis, amount) = (&self.axes[s.axis], |value| Cell::from(number.quantity.amount.of(value)));
                let mut row = vec![number.quantity.label.into(), axis.variables[0].label().into(), amount(s.own)];
                row.extend(ends.iter().flat_map(|end| [amount(end.number), axis.display(end.place).into()]));
                table.rows.push(row);
            }
        }
        table
    }
}

/// Effect of one variable on a number, all else as the case has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Index of the axis.
    pub axis: usize,
    /// Number of the base case.
    pub own: f64,
    pub(super) ends: Vec<End>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    pub number: f64,
    /// Index of the axis value.
    pub place: usize,
    pub is_sound: bool,
}

impl Sensitivity {
    pub(super) fn extremes(&self) -> Option<[End; 2]> {
        let by = |a: &&End, b: &&End| a.number.total_cmp(&b.number);
        Some([*self.ends.iter().min_by(by)?, *self.ends.iter().max_by(by)?])
    }

    /// Difference between the least and the largest number, the base case among them.
    pub fn width(&self) -> f64 {
        self.extremes().map_or(0.0, |[low, high]| high.number.max(self.own) - low.number.min(self.own))
    }
}

impl Study for Sweep {
    fn plan(&self) -> &Plan {
        &self.plan
    }

    fn next(&mut self, _: &RunTable) -> Vec<Design> {
        (0..self.plan.designs).map(|index| self.design(index)).collect()
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let designs = runs.runs.get(usize::from(self.one_at_a_time)..).unwrap_or_default();
        let count = |is: &dyn Fn(&Run) -> bool| designs.iter().filter(|run| is(run)).count();
        let sound = count(&Run::is_sound);
        let amber = count(&|run| run.is_sound() && run.light == Some(Light::Amber));
        let doubt = if amber > 0 { format!(" ({amber} amber)") } else { String::new() };
        let modes = FailureMode::ALL.map(|mode| (count(&|run| run.failures.first() == Some(&mode)), mode.label()));
        let failed = modes.iter().filter(|(n, _)| *n > 0).map(|(n, label)| format!(", {n} {label}"));
        let charts = match (self.one_at_a_time, runs.runs.len() <= DRAWN) {
            (_, false) => Vec::new(),
            (true, _) => charts::tornado(self, runs),
            (false, _) => charts::sweep(self, runs),
        };
        StudyReport {
            headline: format!("{} designs: {sound} sound{doubt}{}.", designs.len(), failed.collect::<String>()),
            notes: self.notes(runs),
            tables: if self.one_at_a_time { vec![self.sensitivity_table(runs)] } else { Vec::new() },
            found: true,
            charts,
        }
    }
}
