//! Thickness over the blank, one curve per kept frame.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::{Subject, profile, progress, reached, shown};

/// Least height of the axis over the initial thickness: thinner differences are noise or nothing to look at [–].
const LEAST: f64 = 0.02;

pub(super) fn plot(subject: &Subject) -> Option<Chart> {
    let Subject { model, run, .. } = subject;
    run.frames.last()?;
    let table = profile::last(model.geometry, &run.frames);
    let series = shown(&run.frames)
        .enumerate()
        .map(|(i, frame)| {
            let points = profile::table(model.geometry, std::slice::from_ref(frame)).pairs("s0", "thickness");
            Series::new(reached(model, frame), points, Look::curve(i))
        })
        .collect();
    Some(Chart {
        title: format!("{}: thickness", model.title),
        legend: progress(subject.model),
        panels: vec![Panel {
            x: table.column("s0").axis(),
            y: table.column("thickness").axis(),
            series,
            scale: Scale::Fit { height: 350.0, least: LEAST * model.blank.thickness },
        }],
        notes: subject.notes_of_frames(),
    })
}
