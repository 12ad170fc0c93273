//! What the press is set to in superplastic forming: the pressure over time that holds the strain rate.

use super::Subject;
use super::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color};
use crate::model::{PressureCap, RateControl};
use crate::solution::{StageSolution, StepRecord};
use crate::table::{Column, Table, Unit};

/// A cycle longer than this is drawn in minutes \[s\].
const LONG: f64 = 600.0;

/// One row per accepted step.
pub fn table(run: &StageSolution) -> Table {
    let column = |key, label, unit, value: fn(&StepRecord) -> f64| {
        Column::new(key, label, unit, run.steps.iter().map(value).collect())
    };
    Table::new(vec![
        column("time", "Time", Unit::Second, |s| s.time),
        column("pressure", "Gas pressure", Unit::MPa, |s| s.pressure.abs()),
        column("strain_rate", "Strain rate", Unit::PerSecond, |s| s.held_rate),
        column("height", "Dome height", Unit::Mm, |s| s.pole_height.abs()),
        column("thinnest", "Least thickness", Unit::Mm, |s| s.thinnest),
        column("contact_share", "Contact share", Unit::None, |s| s.contact_share),
        column("cap", "Cap in force: 0 none, 1 largest pressure, 2 its fastest rise", Unit::None, |s| match s.on_cap {
            None => 0.0,
            Some(PressureCap::Largest) => 1.0,
            Some(PressureCap::Rise) => 2.0,
        }),
    ])
}

/// Time that the pressure sat on a cap \[s\].
pub(super) fn time_on_a_cap(run: &StageSolution) -> f64 {
    let before = std::iter::once(0.0).chain(run.steps.iter().map(|s| s.time));
    run.steps.iter().zip(before).filter(|(s, _)| s.on_cap.is_some()).map(|(s, before)| s.time - before).sum()
}

fn held<'a>(subject: &Subject<'a>) -> Option<&'a RateControl> {
    subject.run.steps.first()?;
    subject.model.rate_control()
}

pub(super) fn of(subject: &Subject) -> Option<Table> {
    held(subject).map(|_| table(subject.run))
}

/// Pressure, strain rate, height and, where the sheet meets a tool, contact below each other over one time axis.
pub(super) fn plot(subject: &Subject) -> Option<Chart> {
    let control = held(subject)?;
    let table = table(subject.run);
    let seconds = table.column("time");
    let end = seconds.values.last().copied().unwrap_or(0.0);
    let (unit, factor) = if end > LONG { (Unit::Minute, 1.0 / 60.0) } else { (Unit::Second, 1.0) };
    let time = Column::new("time", "Time", unit, seconds.values.iter().map(|t| factor * t).collect());
    let panel = |key: &str, i: usize, height: f64, beside: Option<Series>| {
        let column = table.column(key);
        let points = time.values.iter().copied().zip(column.values.iter().copied()).collect();
        // One curve a panel: no pattern is needed to tell it from others.
        let curve = Series::new(column.label, points, Look::Line { color: color(i), width: 2.4, dash: &[] });
        let least = 0.02 * column.values.iter().copied().fold(0.0, f64::max);
        Panel {
            x: time.axis(),
            y: column.axis(),
            series: beside.into_iter().chain([curve]).collect(),
            scale: Scale::Fit { height, least },
        }
    };
    let level = |label: &str, value: f64, look: Look| {
        value.is_finite().then(|| Series::new(label, vec![(0.0, value), (factor * end, value)], look))
    };
    let target = Look::Line { color: BLACK, width: 1.2, dash: &[6.0, 4.0] };
    let cap = Look::Line { color: GREY, width: 1.6, dash: &[2.0, 3.0] };
    let touches = table.column("contact_share").values.iter().any(|share| *share > 0.0);
    Some(Chart {
        title: format!("{}: pressure cycle", subject.model.title),
        legend: "",
        panels: [
            panel("pressure", 0, 250.0, level("Largest pressure of the press", control.max_pressure, cap)),
            panel("strain_rate", 1, 150.0, level("Strain rate to be held", control.target, target)),
            panel("height", 2, 150.0, None),
        ]
        .into_iter()
        .chain(touches.then(|| panel("contact_share", 3, 150.0, None)))
        .collect(),
        notes: subject.notes(),
    })
}
