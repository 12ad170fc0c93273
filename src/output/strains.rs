//! Mid-surface strains over the blank at the last frame, the earlier frames thin behind them.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::{Subject, is_level, profile, progress, reached, shown};
use crate::table::Axis;

const STRAINS: [&str; 3] = ["strain_meridional", "strain_hoop", "strain_thickness"];

/// Least height of the axis: smaller strains are noise or nothing to look at [–].
const LEAST: f64 = 0.02;

pub(super) fn plot(subject: &Subject) -> Option<Chart> {
    let Subject { model, run, .. } = subject;
    let at = format!(", {} {}", progress(model).to_lowercase(), reached(model, run.frames.last()?));
    let table = |frame| profile::table(model, std::slice::from_ref(frame));
    let frames: Vec<_> = shown(&run.frames).map(table).collect();
    let last = profile::last(model, &run.frames);
    let values = STRAINS.iter().flat_map(|key| last.column(key).values.iter().copied());
    if is_level(model, 0.0, values, LEAST) {
        return None;
    }
    let curves = STRAINS.iter().enumerate();
    let earlier = frames.iter().rev().skip(1).flat_map(|frame| {
        curves.clone().map(|(i, key)| Series::silent(frame.pairs("s0", key), Look::curve(i).faint()))
    });
    let at_last = curves.clone().map(|(i, key)| {
        let column = last.column(key);
        Series::new(column.label, last.pairs("s0", key), Look::curve(i))
    });
    Some(Chart {
        title: format!("{}: strains{at}", model.title),
        legend: "",
        panels: vec![Panel {
            x: last.column("s0").axis(),
            y: Axis::shared(&STRAINS.map(|key| last.column(key))),
            series: earlier.chain(at_last).collect(),
            scale: Scale::Fit { height: 350.0, least: LEAST },
        }],
        notes: std::iter::once("Thin: the earlier frames. Logarithmic strains of the mid-surface.".to_owned())
            .chain(subject.notes_of_frames())
            .collect(),
    })
}
