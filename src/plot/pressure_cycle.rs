//! Superplastic forming: gas pressure, strain rate, dome height and contact share over the time.

use super::*;

/// Least length of a cycle that is drawn in minutes \[s\].
const LONG: f64 = 600.0;
const LEAST: f64 = 0.02;
pub(crate) const PRESSURE: Field<StepRecord> = Field::new("pressure", "Pressure", Unit::MPa, |s| s.pressure.abs());
pub(crate) const STRAIN_RATE: Field<StepRecord> =
    Field::new("strain_rate", "Strain rate", Unit::PerSecond, |s| s.held_rate);
pub(crate) const HEIGHT: Field<StepRecord> = Field::new("height", "Dome height", Unit::Mm, |s| s.pole_height.abs());
pub(crate) const CONTACT_SHARE: Field<StepRecord> =
    Field::new("contact_share", "Contact share", Unit::None, |s| s.contact_share);
const TARGET: Style = Style::Line { color: BLACK, width: 1.2, dash: &[6.0, 4.0] };
const CAP: Style = Style::Line { color: GREY, width: 1.6, dash: &[2.0, 3.0] };

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let control = view.model().rate_control()?;
    let (extent, steps) = (view.extent(), &view.stage.steps);
    let end = steps.last()?.time;
    let (unit, factor) = if end > LONG { (Unit::Minute, 1.0 / 60.0) } else { (Unit::Second, 1.0) };
    let panel = |(i, field, height): (usize, Field<StepRecord>, f64)| {
        let points = steps.iter().map(|step| (factor * step.time, (field.value)(step))).collect();
        let least = LEAST * steps.iter().map(field.value).fold(0.0, f64::max);
        let curve = Series::new(field.label(extent), points, Style::solid(color(i), 2.4));
        Panel::fit(Axis::named("Time", unit), field.axis(extent), height, least).with([curve])
    };
    let mut fields = vec![(0, PRESSURE, 250.0), (1, STRAIN_RATE, 150.0), (2, HEIGHT, 150.0)];
    if steps.iter().any(|step| step.contact_share > 0.0) {
        fields.push((3, CONTACT_SHARE, 150.0));
    }
    let mut panels: Vec<Panel> = fields.into_iter().map(panel).collect();
    let levels = [
        ("Largest pressure of the press", control.max_pressure, CAP),
        ("Strain rate to be held", control.target, TARGET),
    ];
    for (panel, (label, value, style)) in panels.iter_mut().zip(levels).filter(|(_, level)| level.1.is_finite()) {
        panel.series.insert(0, Series::new(label, vec![(0.0, value), (factor * end, value)], style));
    }
    Some(view.chart("pressure cycle", panels, None::<String>))
}
