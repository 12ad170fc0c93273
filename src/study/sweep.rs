//! Sweeps: every combination of the variables' values, or each key by itself.

use super::{variable::SearchRange, variable::check_distinct, variable::written, *};
use crate::plot;

/// A full factorial design, or one key at a time.
#[derive(Clone, Debug)]
pub struct Sweep {
    plan: Plan,
    /// The last axis varies fastest.
    pub(super) axes: Vec<Axis>,
    one_at_a_time: bool,
}

#[derive(Clone, Debug)]
pub(super) struct Axis {
    variable: Variable,
    values: Vec<String>,
    /// Axis of a picture; it has names if the values are words.
    pub drawn: plot::Axis,
    /// In the solver's unit; the index for words.
    pub positions: Vec<f64>,
    pub labels: Vec<String>,
    pub own: Option<f64>,
}

const DRAWN: usize = 10_000;

impl Axis {
    fn read(text: &str, base: &BaseCase) -> Result<Self> {
        let variable = Variable::read(text)?;
        if let Ok(SearchRange { ends: [low, high], .. }) = variable.search_range() {
            base.check_any([low, 0.5 * (low + high), high].map(|value| vec![variable.setting(&written(value))]))?;
        }
        let (values, (unit, factor)) = (variable.values()?, variable.axis_unit());
        let last = values.len() - 1;
        base.check_any([0, last / 2, last].map(|i| vec![variable.setting(&values[i])]))?;
        let mut drawn = plot::Axis::named(variable.label(), unit);
        let numbers: Option<Vec<f64>> = values.iter().map(|value| Some(factor * number(value)?)).collect();
        let own = base.value(&variable.key).and_then(|own| match &numbers {
            Some(_) => Some(factor * in_unit(&own, &variable.unit)?),
            None => values.iter().position(|name| *name == own).map(|i| i as f64),
        });
        let positions = numbers.unwrap_or_else(|| {
            drawn.names = values.clone();
            (0..values.len()).map(|i| i as f64).collect()
        });
        let label = |value: &String| number(value).map_or_else(|| value.clone(), |number| variable.display(number));
        Ok(Self { labels: values.iter().map(label).collect(), variable, values, drawn, positions, own })
    }
}

impl Sweep {
    /// Reads a case or study file; `vary` replaces the study's own variables.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String], one_at_a_time: bool) -> Result<Self> {
        let file = StudyFile::load(path, set, vary)?;
        Self::new(BaseCase::load(file.case, file.set)?, &file.variables, one_at_a_time || file.one_at_a_time)
    }

    /// Varies a case by `KEY=VALUES` texts.
    pub fn new(base: BaseCase, vary: &[String], one_at_a_time: bool) -> Result<Self> {
        let axes = vary.iter().map(|text| Axis::read(text, &base)).collect::<Result<Vec<_>, _>>()?;
        ensure(!axes.is_empty(), "nothing of the case is varied", "give --vary KEY=VALUES, as often as needed")?;
        let variables = || axes.iter().map(|axis| &axis.variable);
        check_distinct(variables(), "is varied twice", "give all its values at once")?;
        let mut counts = axes.iter().map(|axis| axis.positions.len() as u64);
        let (what, help) = ("more designs than can be counted", "fewer values, or `scatter` for a sample");
        let designs = match one_at_a_time {
            true => 1 + counts.sum::<u64>(),
            false => counts.try_fold(1, u64::checked_mul).ok_or_else(|| StudyError::new(what, help))?,
        };
        if !one_at_a_time {
            let setting = |axis: &Axis| axis.variable.setting(&axis.values[0]);
            base.check_effective(&axes.iter().map(setting).collect::<Vec<_>>())?;
        }
        let columns = variables().map(Variable::header).collect();
        Ok(Self { plan: Plan::new(base, &format!("{vary:?}{one_at_a_time}"), columns, designs), axes, one_at_a_time })
    }

    /// Place of a design on every axis; `None` where the case keeps its own value.
    pub(super) fn positions(&self, index: u64) -> Vec<Option<usize>> {
        let (index, mut places) = (index as usize, vec![None; self.axes.len()]);
        let mut stride = if self.one_at_a_time { self.plan.designs as usize } else { 1 };
        for (place, axis) in places.iter_mut().zip(&self.axes).rev() {
            if self.one_at_a_time {
                // The first design is the case as it stands.
                stride -= axis.positions.len();
                *place = index.checked_sub(stride).filter(|i| *i < axis.positions.len());
            } else {
                *place = Some(index / stride % axis.positions.len());
                stride *= axis.positions.len();
            }
        }
        places
    }

    fn notes(&self, runs: &RunTable) -> Vec<String> {
        let modes = joined(runs.base.failures.iter().map(|mode| mode.label().to_owned()), ", ");
        let base = match (modes.as_str(), runs.base.light) {
            ("", Some(Light::Amber)) => "The case as it stands is sound, with amber rows.".into(),
            ("", _) => "The case as it stands is sound.".into(),
            _ => format!("The case as it stands fails: {modes}."),
        };
        let describe = |place: usize, run: &Run| {
            let values = self.axes.iter().zip(self.positions(run.index));
            let values = values.filter_map(|(axis, i)| Some(format!("{} {}", axis.drawn.label, axis.labels[i?])));
            format!("{} ({})", runs.display(place, run.numbers[place]), joined(values, ", "))
        };
        let span = charts::decisive(runs, 1).first().and_then(|&place| {
            let sound = || runs.runs.iter().filter(|run| run.is_sound() && run.numbers[place].is_finite());
            let by = |a: &&Run, b: &&Run| a.numbers[place].total_cmp(&b.numbers[place]);
            let (least, most) = sound().min_by(by).zip(sound().max_by(by)).filter(|(a, b)| a.index != b.index)?;
            let [least, most] = [least, most].map(|run| describe(place, run));
            Some(format!("{} of sound designs: {least} to {most}.", runs.responses[place].quantity.label))
        });
        span.into_iter().chain([base]).collect()
    }

    /// Effects of the variables on a number, the largest first.
    pub fn sensitivities(&self, runs: &RunTable, response: usize) -> Vec<Sensitivity> {
        let own = runs.runs.first().map_or(f64::NAN, |run| run.numbers[response]);
        let one = |axis: usize| {
            let end = |run: &Run| {
                let (place, number) = (self.positions(run.index)[axis]?, run.response(response)?);
                Some(End { number, place, is_sound: run.is_sound() })
            };
            let mut ends: Vec<End> = runs.runs.iter().skip(1).filter_map(end).collect();
            ends.sort_by(|a, b| a.number.total_cmp(&b.number));
            Some(Sensitivity { axis, own, extremes: [*ends.first()?, *ends.last()?] })
        };
        let mut all: Vec<Sensitivity> = (0..self.axes.len()).filter_map(one).filter(|s| s.width() > 0.0).collect();
        all.sort_by(|a, b| b.width().total_cmp(&a.width()));
        all
    }

    fn sensitivity_table(&self, runs: &RunTable) -> ReportTable {
        let columns = ["Number", "Key", "As it stands", "Least", "at", "Largest", "at value"];
        let mut rows = Vec::new();
        for response in charts::decisive(runs, 4) {
            let number = &runs.responses[response].quantity;
            for s in self.sensitivities(runs, response) {
                let (axis, amount) = (&self.axes[s.axis], |value| Cell::from(number.amount.with_value(value)));
                let mut row = vec![number.label.into(), axis.drawn.label.clone().into(), amount(s.own)];
                row.extend(s.extremes.iter().flat_map(|e| [amount(e.number), axis.labels[e.place].clone().into()]));
                rows.push(row);
            }
        }
        ReportTable::new("sensitivities", &columns, rows)
    }
}

/// Effect of one variable on a number, all else as the case has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Index of the axis.
    pub axis: usize,
    /// Number of the base case.
    pub own: f64,
    pub(super) extremes: [End; 2],
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    pub number: f64,
    pub place: usize,
    pub is_sound: bool,
}

impl Sensitivity {
    /// Difference between the least and the largest number, the base case among them.
    pub fn width(&self) -> f64 {
        let [low, high] = self.extremes.map(|end| end.number);
        if self.own.is_finite() { high.max(self.own) - low.min(self.own) } else { 0.0 }
    }
}

impl Study for Sweep {
    fn plan(&self) -> &Plan {
        &self.plan
    }

    fn design(&self, index: u64) -> Design {
        let places = self.positions(index);
        let all = || self.axes.iter().zip(&places).map(|(axis, place)| (axis, place.map(|i| &axis.values[i])));
        let settings = all().filter_map(|(axis, value)| Some(axis.variable.setting(value?))).collect();
        Design { index, values: all().map(|(_, value)| value.cloned().unwrap_or_default()).collect(), settings }
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let designs = runs.runs.get(usize::from(self.one_at_a_time)..).unwrap_or_default();
        let count = |is: &dyn Fn(&Run) -> bool| designs.iter().filter(|run| is(run)).count();
        let sound = count(&Run::is_sound);
        let amber = count(&|run| run.is_sound() && run.light == Some(Light::Amber));
        let doubt = if amber > 0 { format!(" ({amber} amber)") } else { String::new() };
        let modes = FailureMode::ALL.map(|mode| (count(&|run| run.failures.first() == Some(&mode)), mode.label()));
        let failed = modes.iter().filter(|(n, _)| *n > 0).map(|(n, label)| format!(", {n} {label}"));
        let (tables, charts) = match self.one_at_a_time {
            true => (vec![self.sensitivity_table(runs)], charts::tornado(self, runs)),
            false => (Vec::new(), charts::sweep(self, runs)),
        };
        let charts = if runs.runs.len() <= DRAWN { charts } else { Vec::new() };
        let headline = format!("{} designs: {sound} sound{doubt}{}.", designs.len(), failed.collect::<String>());
        let notes = self.notes(runs).into_iter().chain(runs.no_result()).collect();
        StudyReport { headline, notes, tables, found: runs.no_result().is_none(), charts }
    }
}
