//! Sweeps: every combination of the variables' values, or each key by itself.

use super::base_case::short_hash;
use super::charts;
use super::report::{Cell, ReportTable, StudyReport};
use super::variable::{Value, Variable};
use super::{BaseCase, Design, FailureMode, Run, RunTable, Study, StudyError, StudyFile};
use crate::assess::Light;
use crate::units::Unit;
use std::path::Path;

/// A full factorial design, or one key at a time.
#[derive(Clone, Debug)]
pub struct Sweep {
    base: BaseCase,
    /// Variables of one axis move together; the last axis varies fastest.
    axes: Vec<Axis>,
    one_at_a_time: bool,
}

/// Variables that move together.
#[derive(Clone, Debug)]
pub struct Axis {
    /// At least one; the first names the axis.
    pub variables: Vec<Variable>,
    values: Vec<Vec<Value>>,
    /// Position of the base case along the axis; `None` if it is unknown.
    pub own: Option<f64>,
}

/// Largest number of axes and of points that are drawn.
const DRAWN: usize = 10_000;

impl Axis {
    /// Reads `KEY=VALUES & KEY=VALUES`.
    ///
    /// # Errors
    /// When one has no values, or they have not as many.
    pub fn read(text: &str, base: &BaseCase) -> Result<Self, StudyError> {
        let variables = Variable::read_together(text)?;
        let values = variables.iter().map(Variable::values).collect::<Result<Vec<_>, _>>()?;
        if let Some(i) = (1..values.len()).find(|&i| values[i].len() != values[0].len()) {
            let counted = |i: usize| format!("{} has {} values", variables[i].key, values[i].len());
            let what = format!("{} but {}", counted(0), counted(i));
            return Err(StudyError::new(what, "keys that move together have as many values"));
        }
        let mut axis = Self { variables, values, own: None };
        let own = base.value(&axis.variables[0].key);
        axis.own = own.and_then(|own| match axis.names()[..] {
            [] => Some(axis.variables[0].axis_unit().1 * axis.variables[0].in_unit(&own)?),
            ref names => names.iter().position(|name| *name == own).map(|place| place as f64),
        });
        Ok(axis)
    }

    /// Number of values.
    pub fn count(&self) -> usize {
        self.values[0].len()
    }

    /// Values as words; empty for numbers.
    pub fn names(&self) -> Vec<&str> {
        let is_numeric = self.values[0].iter().all(|value| value.number.is_some());
        self.values[0].iter().filter(|_| !is_numeric).map(|value| value.text.as_str()).collect()
    }

    /// Positions along the axis, in its solver unit; the index for words.
    pub fn positions(&self) -> Vec<f64> {
        let (_, factor) = self.variables[0].axis_unit();
        let position = |(i, value): (usize, &Value)| value.number.map_or(i as f64, |number| factor * number);
        self.values[0].iter().enumerate().map(position).collect()
    }

    /// Solver unit of the positions.
    pub fn unit(&self) -> Unit {
        self.variables[0].axis_unit().0
    }

    /// A value with its unit.
    pub fn display(&self, i: usize) -> String {
        format!("{} {}", self.values[0][i].text, self.variables[0].unit).trim_end().to_owned()
    }

    fn settings(&self, i: usize) -> impl Iterator<Item = String> {
        self.variables.iter().zip(&self.values).map(move |(variable, values)| variable.setting(&values[i]))
    }
}

impl Sweep {
    /// Reads a case or study file; `vary` replaces the study's own variables.
    ///
    /// # Errors
    /// When there is nothing to vary, a key is varied twice, or none of its values makes a case.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String], one_at_a_time: bool) -> Result<Self, StudyError> {
        let (file, vary) = StudyFile::load(path, set, vary)?;
        Self::new(BaseCase::load(file.case, file.set)?, &vary, one_at_a_time || file.one_at_a_time)
    }

    /// Varies a case by `KEY=VALUES` texts.
    ///
    /// # Errors
    /// Those of [`load`](Self::load).
    pub fn new(base: BaseCase, vary: &[String], one_at_a_time: bool) -> Result<Self, StudyError> {
        let axes = vary.iter().map(|text| Axis::read(text, &base)).collect::<Result<Vec<_>, _>>()?;
        if axes.is_empty() {
            return Err(StudyError::new("nothing of the case is varied", "give --vary KEY=VALUES, as often as needed"));
        }
        let keys: Vec<&str> = axes.iter().flat_map(|axis| &axis.variables).map(|v| v.key.as_str()).collect();
        if let Some(i) = (1..keys.len()).find(|&i| keys[..i].contains(&keys[i])) {
            return Err(StudyError::new(format!("{} is varied twice", keys[i]), "give all its values at once"));
        }
        let count = axes.iter().try_fold(1u64, |count, axis| count.checked_mul(axis.count() as u64));
        if count.is_none() {
            return Err(StudyError::new("more designs than can be counted", "fewer values, or `scatter` for a sample"));
        }
        for axis in &axes {
            let last = axis.count() - 1;
            let tried = [0, last / 2, last].map(|i| base.case(&axis.settings(i).collect::<Vec<_>>()).map(drop));
            if let [Err(error), Err(_), Err(_)] = tried {
                return Err(error.into());
            }
        }
        Ok(Self { base, axes, one_at_a_time })
    }

    /// Whether error bars are usual: over one key.
    pub fn has_error_bars(&self) -> bool {
        self.axes.len() == 1 && !self.one_at_a_time
    }

    /// Place of a design on every axis; `None` where the case keeps its own value.
    pub fn places(&self, index: u64) -> Vec<Option<usize>> {
        let mut rest = index;
        if !self.one_at_a_time {
            let mut places: Vec<_> = self
                .axes
                .iter()
                .rev()
                .map(|axis| {
                    let count = axis.count() as u64;
                    let place = rest % count;
                    rest /= count;
                    Some(place as usize)
                })
                .collect();
            places.reverse();
            return places;
        }
        // Design 0 is the base case.
        let mut before = 1;
        self.axes
            .iter()
            .map(|axis| {
                let own = index.checked_sub(before).filter(|place| *place < axis.count() as u64);
                before += axis.count() as u64;
                own.map(|place| place as usize)
            })
            .collect()
    }

    fn design(&self, index: u64) -> Design {
        let places = self.places(index);
        let pairs = || self.axes.iter().zip(&places);
        let values = pairs().flat_map(|(axis, place)| {
            axis.values.iter().map(move |values| place.map_or_else(String::new, |i| values[i].text.clone()))
        });
        let settings = pairs().flat_map(|(axis, place)| place.iter().flat_map(|i| axis.settings(*i)));
        Design { index, values: values.collect(), settings: settings.collect() }
    }

    /// The values of a run: `Friction 0.1, Holder force 5 kN`.
    fn describe(&self, run: &Run) -> String {
        let places = self.places(run.index);
        let pairs = self.axes.iter().zip(places).filter_map(|(axis, place)| Some((axis, place?)));
        let values = pairs.map(|(axis, i)| format!("{} {}", axis.variables[0].label(), axis.display(i)));
        values.collect::<Vec<_>>().join(", ")
    }

    fn notes(&self, runs: &RunTable) -> Vec<String> {
        let mut notes = Vec::new();
        if let Some(response) = charts::deciding(runs, 1).first().copied() {
            let sound = || runs.runs.iter().filter(|run| run.is_sound() && run.numbers[response].is_finite());
            let by = |a: &&Run, b: &&Run| a.numbers[response].total_cmp(&b.numbers[response]);
            if let Some((least, most)) = sound().min_by(by).zip(sound().max_by(by)).filter(|(a, b)| a.index != b.index)
            {
                let told = |run: &Run| {
                    format!("{} ({})", runs.responses[response].display(run.numbers[response]), self.describe(run))
                };
                let label = runs.responses[response].number.quantity.label;
                notes.push(format!("{label} of sound designs: {} to {}.", told(least), told(most)));
            }
        }
        let base = &runs.base;
        let modes = base.failures.iter().map(|mode| mode.label()).collect::<Vec<_>>().join(", ");
        notes.push(match (base.is_sound(), base.light) {
            (true, Some(Light::Amber)) => "The case as it stands is sound, with amber rows.".into(),
            (true, _) => "The case as it stands is sound.".into(),
            (false, _) => format!("The case as it stands fails: {modes}."),
        });
        notes
    }

    /// Least and largest value of each deciding number over each variable by itself, the largest effect first.
    pub fn sensitivities(&self, runs: &RunTable, response: usize) -> Vec<Sensitivity> {
        let Some(own) = runs.runs.first().map(|run| run.numbers[response]).filter(|own| own.is_finite()) else {
            return Vec::new();
        };
        let of = |axis: usize| {
            let known = runs.runs.iter().skip(1).filter(|run| run.is_known() && run.numbers[response].is_finite());
            let runs = known.filter_map(|run| Some((self.places(run.index)[axis]?, run)));
            let ends = runs.map(|(place, run)| End { number: run.numbers[response], place, is_sound: run.is_sound() });
            Sensitivity { axis, own, ends: ends.collect() }
        };
        let mut all: Vec<Sensitivity> = (0..self.axes.len()).map(of).filter(|s| s.width() > 0.0).collect();
        all.sort_by(|a, b| b.width().total_cmp(&a.width()));
        all
    }

    /// The axes.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }
}

/// Effect of one variable on a number, all else as the case has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Index of the axis.
    pub axis: usize,
    /// Number of the base case.
    pub own: f64,
    /// Number at every value of the axis.
    pub ends: Vec<End>,
}

/// A number at a value of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// In the response's unit.
    pub number: f64,
    /// Index of the axis value.
    pub place: usize,
    /// Whether the design is sound.
    pub is_sound: bool,
}

impl Sensitivity {
    /// Runs with the least and the largest number.
    pub fn extremes(&self) -> Option<[End; 2]> {
        let by = |a: &&End, b: &&End| a.number.total_cmp(&b.number);
        Some([*self.ends.iter().min_by(by)?, *self.ends.iter().max_by(by)?])
    }

    /// Difference between the least and the largest number, the base case among them.
    pub fn width(&self) -> f64 {
        self.extremes().map_or(0.0, |[low, high]| high.number.max(self.own) - low.number.min(self.own))
    }
}

impl Study for Sweep {
    fn base(&self) -> &BaseCase {
        &self.base
    }

    fn key(&self) -> String {
        let variables: Vec<_> = self.axes.iter().map(|axis| (&axis.variables, &axis.values)).collect();
        short_hash([self.base.key(), &format!("{variables:?}{}", self.one_at_a_time)])
    }

    fn columns(&self) -> Vec<String> {
        self.axes.iter().flat_map(|axis| &axis.variables).map(Variable::header).collect()
    }

    fn designs(&self) -> u64 {
        let counts = self.axes.iter().map(|axis| axis.count() as u64);
        if self.one_at_a_time { 1 + counts.sum::<u64>() } else { counts.product() }
    }

    fn next(&mut self, _: &RunTable) -> Vec<Design> {
        (0..self.designs()).map(|index| self.design(index)).collect()
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let skipped = usize::from(self.one_at_a_time);
        let designs = &runs.runs[skipped.min(runs.runs.len())..];
        let sound = designs.iter().filter(|run| run.is_sound()).count();
        let amber = designs.iter().filter(|run| run.is_sound() && run.light == Some(Light::Amber)).count();
        let doubt = if amber > 0 { format!(" ({amber} amber)") } else { String::new() };
        let count = |mode: FailureMode| designs.iter().filter(|run| run.failures.first() == Some(&mode)).count();
        let modes = FailureMode::ALL.map(|mode| (count(mode), mode.label()));
        let failed = modes.iter().filter(|(n, _)| *n > 0).map(|(n, label)| format!(", {n} {label}"));
        let headline = format!("{} designs: {sound} sound{doubt}{}.", designs.len(), failed.collect::<String>());
        let mut tables = Vec::new();
        if self.one_at_a_time {
            let columns = ["Number", "Key", "As it stands", "Least", "at", "Largest", "at value"];
            let mut table = ReportTable::new("sensitivities", &columns);
            for response in charts::deciding(runs, 4) {
                let number = &runs.responses[response].number;
                for s in self.sensitivities(runs, response) {
                    let Some([low, high]) = s.extremes() else { continue };
                    let (axis, amount) = (&self.axes[s.axis], |value| Cell::from(number.quantity.amount.of(value)));
                    table.rows.push(vec![
                        number.quantity.label.into(),
                        axis.variables[0].label().into(),
                        amount(s.own),
                        amount(low.number),
                        axis.display(low.place).into(),
                        amount(high.number),
                        axis.display(high.place).into(),
                    ]);
                }
            }
            tables.push(table);
        }
        let charts = match (self.one_at_a_time, runs.runs.len() <= DRAWN) {
            (_, false) => None,
            (true, _) => charts::tornado(self, runs),
            (false, _) => charts::sweep(self, runs),
        };
        let charts = charts.map(|chart| ("sweep".to_owned(), chart)).into_iter().collect();
        StudyReport { headline, notes: self.notes(runs), tables, found: true, charts }
    }
}
