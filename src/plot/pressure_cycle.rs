//! Pressure over the time, with the strain rate that it holds, dome height, contact share, or the feed of a tube.

use super::*;
use crate::model::Edge;

/// Least length of a cycle that is drawn in minutes \[s\].
const LONG: f64 = 600.0;
const LEAST: f64 = 0.02;
pub(crate) const PRESSURE: Field<StepRecord> = Field::new("pressure", "Pressure", Unit::MPa, |s| s.pressure.abs());
pub(crate) const STRAIN_RATE: Field<StepRecord> =
    Field::new("strain_rate", "Strain rate", Unit::PerSecond, |s| s.held_rate);
pub(crate) const HEIGHT: Field<StepRecord> = Field::new("height", "Dome height", Unit::Mm, |s| s.pole_height.abs());
pub(crate) const CONTACT_SHARE: Field<StepRecord> =
    Field::new("contact_share", "Contact share", Unit::None, |s| s.contact_share);
const FEED: Field<StepRecord> = Field::new("feed", "Feed", Unit::Mm, |s| s.travel);
const TARGET: Style = Style::Line { color: BLACK, width: 1.2, dash: &[6.0, 4.0] };
const CAP: Style = Style::Line { color: GREY, width: 1.6, dash: &[2.0, 3.0] };

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (model, extent, steps) = (view.model(), view.extent(), &view.stage.steps);
    let control = model.rate_control();
    let is_by_gas = !model.gas.is_empty() && model.tool(Role::Punch).is_none();
    let end = steps.last().filter(|_| control.is_some() || is_by_gas && model.release.is_none())?.time;
    let (unit, factor) = if end > LONG { (Unit::Minute, 1.0 / 60.0) } else { (Unit::Second, 1.0) };
    let panel = |(i, field, height): (usize, Field<StepRecord>, f64)| {
        let points = steps.iter().map(|step| (factor * step.time, (field.value)(step))).collect();
        let least = LEAST * steps.iter().map(field.value).fold(0.0, f64::max);
        let curve = Series::new(field.label(extent), points, Style::solid(color(i), 2.4));
        Panel::fit(Axis::named("Time", unit), field.axis(extent), height, least).with([curve])
    };
    let second = if model.blank.edge == Edge::Fed { FEED } else { HEIGHT };
    let fields = [Some((0, PRESSURE, 250.0)), control.map(|_| (1, STRAIN_RATE, 150.0)), Some((2, second, 150.0))];
    let touches = control.is_some() && steps.iter().any(|step| step.contact_share > 0.0);
    let fields = fields.into_iter().flatten().chain(touches.then_some((3, CONTACT_SHARE, 150.0)));
    let mut panels: Vec<Panel> = fields.map(panel).collect();
    let levels = control.map(|control| {
        let cap = ("Largest pressure of the press", control.max_pressure, CAP);
        [cap, ("Strain rate to be held", control.target, TARGET)]
    });
    let levels = panels.iter_mut().zip(levels.into_iter().flatten());
    for (panel, (label, value, style)) in levels.filter(|(_, level)| level.1.is_finite()) {
        panel.series.insert(0, Series::new(label, vec![(0.0, value), (factor * end, value)], style));
    }
    Some(view.chart("pressure cycle", panels, None::<String>))
}
