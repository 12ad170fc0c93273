//! Mid-surface strains over the blank at the last frame, the earlier frames thin behind them.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::{Subject, profile, shown, travel};
use crate::table::Axis;

const STRAINS: [&str; 3] = ["strain_meridional", "strain_hoop", "strain_thickness"];

pub(super) fn plot(subject: &Subject) -> Chart {
    let frames: Vec<_> = shown(&subject.run.frames).map(|f| profile::table(std::slice::from_ref(f))).collect();
    let last = profile::last(&subject.run.frames);
    let curves = STRAINS.iter().enumerate();
    let earlier = frames.iter().rev().skip(1).flat_map(|frame| {
        curves.clone().map(|(i, key)| Series::silent(frame.pairs("s0", key), Look::curve(i).faint()))
    });
    let at_last = curves.clone().map(|(i, key)| {
        let column = last.column(key);
        Series::new(column.label, last.pairs("s0", key), Look::curve(i))
    });
    let at = subject.run.frames.last().map_or(String::new(), |frame| format!(" at {} of travel", travel(frame)));
    Chart {
        title: format!("{}: strains{at}", subject.model.title),
        legend: "",
        panels: vec![Panel {
            x: last.column("s0").axis(),
            y: Axis::shared(&STRAINS.map(|key| last.column(key))),
            series: earlier.chain(at_last).collect(),
            scale: Scale::Fit { height: 350.0 },
        }],
        notes: std::iter::once("Thin: the earlier frames. Logarithmic strains of the mid-surface.".to_owned())
            .chain(subject.notes_of_frames())
            .collect(),
    }
}
