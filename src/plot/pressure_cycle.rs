//! Gas pressure, strain rate and dome height over the time, with a strain rate held by the pressure.

use super::StageView;
use super::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color};
use crate::results::pressure_cycle::{CONTACT_SHARE, HEIGHT, PRESSURE, STRAIN_RATE, held};
use crate::solver::solution::StepRecord;
use crate::table::{Column, Field, Unit};

/// A cycle longer than this is drawn in minutes \[s\].
const LONG: f64 = 600.0;

/// Pressure, strain rate, height and, where the sheet meets a tool, contact below each other over one time axis.
pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let control = held(view)?;
    let (extent, steps) = (view.extent(), &view.stage.steps);
    let end = steps.last()?.time;
    let (unit, factor) = if end > LONG { (Unit::Minute, 1.0 / 60.0) } else { (Unit::Second, 1.0) };
    let time = Column::new("time", "Time", unit, Vec::new()).axis();
    let panel = |field: Field<StepRecord>, i: usize, height: f64, beside: Option<Series>| {
        let points = steps.iter().map(|step| (factor * step.time, (field.value)(step))).collect();
        // One curve a panel: no pattern is needed to tell it from others.
        let curve = Series::new(
            String::from(field.label(extent)),
            points,
            Look::Line { color: color(i), width: 2.4, dash: &[] },
        );
        let least = 0.02 * steps.iter().map(field.value).fold(0.0, f64::max);
        Panel {
            x: time.clone(),
            y: field.axis(extent),
            series: beside.into_iter().chain([curve]).collect(),
            scale: Scale::Fit { height, least },
        }
    };
    let level = |label: &'static str, value: f64, look: Look| {
        value.is_finite().then(|| Series::new(String::from(label), vec![(0.0, value), (factor * end, value)], look))
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
