//! One quantity over the blank, one curve per kept frame: thickness, and porosity and temperature where there are any.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::{Subject, is_level, profile, progress, reached, shown};

/// Least height of the thickness axis over the initial thickness: smaller differences are noise or nothing to look at [–].
const LEAST: f64 = 0.02;
/// Least height of the porosity axis [–] and of the temperature axis [K].
const LEAST_POROSITY: f64 = 1e-4;
const LEAST_TEMPERATURE: f64 = 1.0;

pub(super) fn thickness(subject: &Subject) -> Option<Chart> {
    let Subject { model, run, .. } = subject;
    let (initial, least) = (model.blank.thickness, LEAST * model.blank.thickness);
    let values = run.frames.iter().flat_map(|frame| &frame.elements).map(|element| element.thickness);
    if is_level(model, initial, values, least) { None } else { plot(subject, "thickness", least) }
}

pub(super) fn porosity(subject: &Subject) -> Option<Chart> {
    subject.model.material.voids.and_then(|_| plot(subject, "porosity", LEAST_POROSITY))
}

pub(super) fn temperature(subject: &Subject) -> Option<Chart> {
    subject.model.heat.as_ref().and_then(|_| plot(subject, "temperature", LEAST_TEMPERATURE))
}

fn plot(subject: &Subject, key: &str, least: f64) -> Option<Chart> {
    let Subject { model, run, .. } = subject;
    run.frames.last()?;
    let table = profile::last(model, &run.frames);
    let column = table.column(key);
    let series = shown(&run.frames)
        .enumerate()
        .map(|(i, frame)| {
            let points = profile::table(model, std::slice::from_ref(frame)).pairs("s0", key);
            Series::new(reached(model, frame), points, Look::curve(i))
        })
        .collect();
    Some(Chart {
        title: format!("{}: {}", model.title, column.label.to_lowercase()),
        legend: progress(subject.model),
        panels: vec![Panel {
            x: table.column("s0").axis(),
            y: column.axis(),
            series,
            scale: Scale::Fit { height: 350.0, least },
        }],
        notes: subject.notes_of_frames(),
    })
}
