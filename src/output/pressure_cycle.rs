//! What the press is set to in superplastic forming: the pressure over time that holds the strain rate.

use super::StageView;
use super::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color};
use crate::model::{PressureCap, RateControl};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::{Column, Field, Table, Unit};

/// A cycle longer than this is drawn in minutes \[s\].
const LONG: f64 = 600.0;

const TIME: Field<StepRecord> = Field::new("time", "Time", Unit::Second, |s| s.time);
const PRESSURE: Field<StepRecord> = Field::new("pressure", "Gas pressure", Unit::MPa, |s| s.pressure.abs());
const STRAIN_RATE: Field<StepRecord> = Field::new("strain_rate", "Strain rate", Unit::PerSecond, |s| s.held_rate);
const HEIGHT: Field<StepRecord> = Field::new("height", "Dome height", Unit::Mm, |s| s.pole_height.abs());
const CONTACT_SHARE: Field<StepRecord> = Field::new("contact_share", "Contact share", Unit::None, |s| s.contact_share);
const FIELDS: [Field<StepRecord>; 7] = [
    TIME,
    PRESSURE,
    STRAIN_RATE,
    HEIGHT,
    crate::table::fields::step::THINNEST,
    CONTACT_SHARE,
    Field::new("cap", "Cap in force: 0 none, 1 largest pressure, 2 its fastest rise", Unit::None, |s| match s.on_cap {
        None => 0.0,
        Some(PressureCap::Largest) => 1.0,
        Some(PressureCap::Rise) => 2.0,
    }),
];

/// Time that the pressure sat on a cap \[s\].
pub(super) fn time_on_a_cap(stage: &StageSolution) -> f64 {
    let before = std::iter::once(0.0).chain(stage.steps.iter().map(|s| s.time));
    stage.steps.iter().zip(before).filter(|(s, _)| s.on_cap.is_some()).map(|(s, before)| s.time - before).sum()
}

fn held<'a>(view: &StageView<'a>) -> Option<&'a RateControl> {
    view.stage.steps.first()?;
    view.model().rate_control()
}

/// One row per accepted step.
pub(super) fn of(view: &StageView) -> Option<Table> {
    held(view)?;
    Some(Table::new(FIELDS.iter().map(|field| field.column(view.extent(), &view.stage.steps)).collect()))
}

/// Pressure, strain rate, height and, where the sheet meets a tool, contact below each other over one time axis.
pub(super) fn plot(view: &StageView) -> Option<Chart> {
    let control = held(view)?;
    let (extent, steps) = (view.extent(), &view.stage.steps);
    let end = steps.last()?.time;
    let (unit, factor) = if end > LONG { (Unit::Minute, 1.0 / 60.0) } else { (Unit::Second, 1.0) };
    let time = Column::new("time", "Time", unit, Vec::new()).axis();
    let panel = |field: Field<StepRecord>, i: usize, height: f64, beside: Option<Series>| {
        let points = steps.iter().map(|step| (factor * step.time, (field.value)(step))).collect();
        // One curve a panel: no pattern is needed to tell it from others.
        let curve =
            Series::new(view.tell(field.label(extent)), points, Look::Line { color: color(i), width: 2.4, dash: &[] });
        let least = 0.02 * steps.iter().map(field.value).fold(0.0, f64::max);
        Panel {
            x: time.clone(),
            y: field.axis(extent),
            series: beside.into_iter().chain([curve]).collect(),
            scale: Scale::Fit { height, least },
        }
    };
    let level = |label: &'static str, value: f64, look: Look| {
        value.is_finite().then(|| Series::new(view.tell(label), vec![(0.0, value), (factor * end, value)], look))
    };
    let target = Look::Line { color: BLACK, width: 1.2, dash: &[6.0, 4.0] };
    let cap = Look::Line { color: GREY, width: 1.6, dash: &[2.0, 3.0] };
    let touches = steps.iter().any(|step| step.contact_share > 0.0);
    Some(Chart {
        title: view.titled("pressure cycle"),
        legend: String::new(),
        panels: [
            panel(PRESSURE, 0, 250.0, level("Largest pressure of the press", control.max_pressure, cap)),
            panel(STRAIN_RATE, 1, 150.0, level("Strain rate to be held", control.target, target)),
            panel(HEIGHT, 2, 150.0, None),
        ]
        .into_iter()
        .chain(touches.then(|| panel(CONTACT_SHARE, 3, 150.0, None)))
        .collect(),
        notes: view.notes(),
    })
}
