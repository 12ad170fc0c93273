//! Forces over the punch travel.

use super::StageView;
use super::chart::{BLACK, Chart, Look, Panel, Scale, Series, color};
use crate::measure;
use crate::solver::solution::StepRecord;
use crate::table::Field;
use crate::table::fields::step::{EDGE_FORCE, HOLDER_FORCE, POLE_HEIGHT, PRESSURE, PUNCH_FORCE, TRAVEL};
use crate::units::Amount;

/// A press's rating is drawn where it is no larger than so many times the largest force: else the curve would be flat.
const NEAR: f64 = 2.0;

/// The curves, the peak, what happens on the way, and what the press can give.
pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let mut panel = panel(view, 350.0)?;
    if let Some(band) = view.load_band {
        panel = panel.with_band(String::from("Error band"), &band.x, [&band.low, &band.high], color(0));
    }
    let forces = view.model().travel > 0.0;
    let mut notes = Vec::new();
    if forces {
        let unit = view.extent().force_unit();
        for event in measure::events(view.stage) {
            let label = format!("{event}, {travel}", event = event.kind.label(), travel = Amount::place(event.travel));
            panel.series.push(Series::new(String::from(label), vec![(event.travel, event.force)], Look::Flag));
        }
        let peak = view.stage.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force));
        if let Some(peak) = peak.filter(|peak| peak.punch_force > 0.0) {
            let (force, travel) = (Amount::force(peak.punch_force, unit), Amount::place(peak.travel));
            let label = format!("peak {force} at {travel}");
            panel.series.push(Series::new(label, vec![(peak.travel, peak.punch_force)], Look::Flag));
            if let Some(rating) = view.press.force {
                let label = format!("Press rating, {force}", force = Amount::force(rating, unit));
                match rating <= NEAR * peak.punch_force {
                    true => {
                        let ends = [view.stage.steps.first(), view.stage.steps.last()].into_iter().flatten();
                        let line = ends.map(|step| (step.travel, rating)).collect();
                        panel.series.push(Series::new(
                            String::from(label),
                            line,
                            Look::Line { color: BLACK, width: 1.4, dash: &[7.0, 3.0, 1.5, 3.0] },
                        ));
                    }
                    false => notes.push(format!("{label}: above the picture.")),
                }
            }
        }
    }
    let what = if forces { "forces" } else { "pressure" };
    notes.extend(view.notes());
    Some(Chart { title: view.titled(what), legend: String::new(), panels: vec![panel], notes })
}

/// Punch and holder force over the travel, and the held edge's force where there is one; under gas alone, its pressure
/// over the height of the dome; nothing while the tools are taken away. One point per step in every series.
pub(crate) fn panel(view: &StageView, height: f64) -> Option<Panel> {
    let (extent, steps) = (view.extent(), &view.stage.steps);
    steps.first().filter(|_| view.model().release.is_none())?;
    let pressure = view.model().travel == 0.0;
    let (over, fields) = match pressure {
        true => (POLE_HEIGHT, vec![PRESSURE]),
        false => {
            let acts = |field: &Field<StepRecord>| steps.iter().any(|step| (field.value)(step) != 0.0);
            let others = [HOLDER_FORCE, EDGE_FORCE].into_iter().filter(acts);
            (TRAVEL, std::iter::once(PUNCH_FORCE).chain(others).collect())
        }
    };
    let curve = |(i, field): (usize, &Field<StepRecord>)| {
        Series::new(String::from(field.label(extent)), over.against(field, steps), Look::curve(i))
    };
    Some(Panel {
        x: over.axis(extent),
        y: Field::shared_axis(&fields, extent),
        series: fields.iter().enumerate().map(curve).collect(),
        scale: Scale::Fit { height, least: 0.0 },
    })
}
