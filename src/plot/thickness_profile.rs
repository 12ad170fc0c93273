//! Thickness over the blank at the kept frames, and over the part that came out; in the first way porosity and temperature
//! too.

use super::chart::{Chart, Look, Panel, Scale, Series, color};
use super::{StageView, part_bands};
use crate::solver::solution::ElementRecord;
use crate::table::fields::element::{POROSITY, S0, TEMPERATURE, THICKNESS};
use crate::table::{Field, capitalised};

/// Least height of the thickness axis over the initial thickness: smaller differences are noise or nothing to look at [–].
const LEAST: f64 = 0.02;
/// Least height of the porosity axis [–] and of the temperature axis [K].
const LEAST_POROSITY: f64 = 1e-4;
const LEAST_TEMPERATURE: f64 = 1.0;

pub(crate) fn thickness(view: &StageView) -> Option<Chart> {
    let initial = view.model().blank.thickness;
    let values = view.stage.frames.iter().flat_map(|frame| &frame.elements).map(|element| element.thickness);
    let is_level = view.is_level(initial, values, LEAST * initial);
    if is_level {
        return None;
    }
    let mut chart = plot(view, "thickness", &THICKNESS, LEAST * initial)?;
    if let Some(band) = view.thickness_band {
        // Around the last curve.
        let around = |panel: Panel| {
            let of = color(panel.series.len().saturating_sub(1));
            panel.with_band(String::from("Error band"), &band.x, [&band.low, &band.high], of)
        };
        chart.panels = chart.panels.into_iter().map(around).collect();
    }
    chart.panels.extend(part_bands::panel(view, Scale::Fit { height: 270.0, least: LEAST * initial }));
    Some(chart)
}

pub(crate) fn porosity(view: &StageView) -> Option<Chart> {
    view.model().material.gtn.and_then(|_| plot(view, "porosity", &POROSITY, LEAST_POROSITY))
}

pub(crate) fn temperature(view: &StageView) -> Option<Chart> {
    view.model().heat.as_ref().and_then(|_| plot(view, "temperature", &TEMPERATURE, LEAST_TEMPERATURE))
}

fn plot(view: &StageView, what: &'static str, field: &Field<ElementRecord>, least: f64) -> Option<Chart> {
    view.stage.frames.last()?;
    let extent = view.extent();
    let curves = view.shown().enumerate().map(|(i, frame)| {
        Series::new(String::from(view.reached(frame)), S0.against(field, &frame.elements), Look::curve(i))
    });
    Some(Chart {
        title: view.titled(what),
        legend: capitalised(&String::from(view.progress())),
        panels: vec![Panel {
            x: S0.axis(extent),
            y: field.axis(extent),
            series: curves.collect(),
            scale: Scale::Fit { height: 350.0, least },
        }],
        notes: view.notes_of_frames(),
    })
}
