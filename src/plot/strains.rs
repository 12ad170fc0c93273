//! Mid-surface strains over the blank at the last frame, the earlier frames thin behind them.

use super::StageView;
use super::chart::{Chart, Look, Panel, Scale, Series};
use crate::solver::solution::{ElementRecord, Frame};
use crate::table::Field;
use crate::table::fields::element::{S0, STRAIN_HOOP, STRAIN_MERIDIONAL, STRAIN_THICKNESS};

const STRAINS: [Field<ElementRecord>; 3] = [STRAIN_MERIDIONAL, STRAIN_HOOP, STRAIN_THICKNESS];

/// Least height of the axis: smaller strains are noise or nothing to look at [–].
const LEAST: f64 = 0.02;

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (extent, last) = (view.extent(), view.stage.frames.last()?);
    let values = STRAINS.iter().flat_map(|field| last.elements.iter().map(field.value));
    if view.is_level(0.0, values, LEAST) {
        return None;
    }
    let curves = |frame: &Frame| STRAINS.map(|field| S0.against(&field, &frame.elements)).into_iter().enumerate();
    let earlier = view.shown().rev().skip(1).flat_map(|frame| {
        curves(frame).map(|(i, points)| Series::silent(points, Look::curve(i).faint())).collect::<Vec<_>>()
    });
    let at_last =
        curves(last).map(|(i, points)| Series::new(String::from(STRAINS[i].label(extent)), points, Look::curve(i)));
    Some(Chart {
        title: view.titled(format!("strains, {progress} {at}", progress = view.progress(), at = view.reached(last))),
        legend: String::new(),
        panels: vec![Panel {
            x: S0.axis(extent),
            y: Field::shared_axis(&STRAINS, extent),
            series: earlier.chain(at_last).collect(),
            scale: Scale::Fit { height: 350.0, least: LEAST },
        }],
        notes: std::iter::once(String::from("Thin: the earlier frames. Logarithmic strains of the mid-surface."))
            .chain(view.notes_of_frames())
            .collect(),
    })
}
