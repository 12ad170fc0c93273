//! Thickness, porosity and temperature over the blank at the kept frames, and thickness along the part.

use super::chart::{Chart, Panel, Series, Style};
use super::palette::color;
use super::{StageView, bands};
use crate::solver::solution::ElementRecord;
use crate::table::fields::element::{POROSITY, S0, TEMPERATURE, THICKNESS};
use crate::table::{Field, capitalised};

/// Least span of the thickness axis over the initial thickness, of the porosity axis \[–\] and of the temperature axis \[K\].
const LEAST: f64 = 0.02;
const LEAST_POROSITY: f64 = 1e-4;
const LEAST_TEMPERATURE: f64 = 1.0;
const HEIGHT: f64 = 350.0;

pub(crate) fn thickness(view: &StageView) -> Option<Chart> {
    let initial = view.model().blank.thickness;
    let values = view.stage.frames.iter().flat_map(|frame| &frame.elements).map(|element| element.thickness);
    if view.is_level(initial, values, LEAST * initial) {
        return None;
    }
    let mut chart = plot(view, "thickness", &THICKNESS, LEAST * initial)?;
    if let Some(band) = view.thickness_band {
        let around = |panel: Panel| {
            let last = color(panel.series.len().saturating_sub(1));
            panel.with_band("Error band", &band.x, [&band.low, &band.high], last)
        };
        chart.panels = chart.panels.into_iter().map(around).collect();
    }
    chart.panels.extend(bands::panel(view, LEAST * initial));
    Some(chart)
}

pub(crate) fn porosity(view: &StageView) -> Option<Chart> {
    view.model().material.gtn.and_then(|_| plot(view, "porosity", &POROSITY, LEAST_POROSITY))
}

pub(crate) fn temperature(view: &StageView) -> Option<Chart> {
    view.model().heat.as_ref().and_then(|_| plot(view, "temperature", &TEMPERATURE, LEAST_TEMPERATURE))
}

fn plot(view: &StageView, what: &str, field: &Field<ElementRecord>, least: f64) -> Option<Chart> {
    view.stage.frames.last()?;
    let extent = view.extent();
    let curves = view.shown_frames().enumerate().map(|(i, frame)| {
        Series::new(view.progress_at(frame).to_string(), S0.against(field, &frame.elements), Style::curve(i))
    });
    let panel = Panel::fit(S0.axis(extent), field.axis(extent), HEIGHT, least).with(curves);
    let legend = capitalised(view.progress());
    Some(Chart { legend, ..Chart::new(view.titled(what), vec![panel], view.notes_on_frames()) })
}
