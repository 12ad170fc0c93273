//! Thickness, porosity, damage, temperature and strains over the blank at the kept frames, and thickness along the part.

use super::*;
use crate::plot::fields::element::*;

/// Least span of the axis of a thickness over the initial one and a damage \[–\], a porosity \[–\], a temperature \[K\] and a strain \[–\].
const LEAST: f64 = 0.02;
const LEAST_POROSITY: f64 = 1e-4;
const LEAST_TEMPERATURE: f64 = 1.0;
const LEAST_STRAIN: f64 = 0.02;
const HEIGHT: f64 = 350.0;
const STRAINS: [Field<ElementRecord>; 3] = [STRAIN_MERIDIONAL, STRAIN_HOOP, STRAIN_THICKNESS];

pub(crate) fn thickness(view: &StageView) -> Option<Chart> {
    let initial = view.model().blank.thickness;
    let values = view.stage.frames.iter().flat_map(|frame| &frame.elements).map(|element| element.thickness);
    if view.is_level(initial, values, LEAST * initial) {
        return None;
    }
    let mut chart = over_blank(view, "thickness", &THICKNESS, LEAST * initial)?;
    chart.panels.extend(bands::panel(view, LEAST * initial));
    Some(chart)
}

pub(crate) fn tearing_index(view: &StageView) -> Option<Chart> {
    let is_judged = view.stage.steps.iter().any(|step| step.tearing_index > 0.0);
    over_blank(view, "tearing index", &TEARING_INDEX_NOW, LEAST).filter(|_| is_judged)
}

pub(crate) fn porosity(view: &StageView) -> Option<Chart> {
    view.model().material.gtn.and_then(|_| over_blank(view, "porosity", &POROSITY, LEAST_POROSITY))
}

pub(crate) fn damage(view: &StageView) -> Option<Chart> {
    view.model().material.fracture.and_then(|_| over_blank(view, "damage of ductile fracture", &DAMAGE, LEAST))
}

pub(crate) fn temperature(view: &StageView) -> Option<Chart> {
    view.model().heat.as_ref().and_then(|_| over_blank(view, "temperature", &TEMPERATURE, LEAST_TEMPERATURE))
}

fn initial_place(view: &StageView) -> Field<ElementRecord> {
    if view.model().blank.meridian.is_some() { S0_ALONG } else { S0 }
}

fn over_blank(view: &StageView, subject: &str, field: &Field<ElementRecord>, least: f64) -> Option<Chart> {
    view.stage.frames.last()?;
    let (extent, s0) = (view.extent(), initial_place(view));
    let curves = view.shown_frames().into_iter().enumerate().map(|(i, frame)| {
        Series::new(view.progress_at(frame).to_string(), s0.against(field, &frame.elements), Style::curve(i))
    });
    let panel = Panel::fit(s0.axis(extent), field.axis(extent), HEIGHT, least).with(curves);
    Some(Chart { legend: capitalised(&view.progress()), ..view.chart(subject, vec![panel], view.frames_note()) })
}

pub(crate) fn strains(view: &StageView) -> Option<Chart> {
    let (extent, s0, last) = (view.extent(), initial_place(view), view.stage.frames.last()?);
    if view.is_level(0.0, STRAINS.iter().flat_map(|field| last.elements.iter().map(field.value)), LEAST_STRAIN) {
        return None;
    }
    let earlier = view.shown_frames().into_iter().rev().skip(1).map(|frame| (frame, true));
    let curves = earlier.chain([(last, false)]).flat_map(|(frame, is_earlier)| {
        STRAINS.iter().enumerate().map(move |(i, field)| {
            let (points, style) = (s0.against(field, &frame.elements), Style::curve(i));
            if is_earlier {
                Series::silent(points, style.faint())
            } else {
                Series::new(field.label(extent), points, style)
            }
        })
    });
    let panel = Panel::fit(s0.axis(extent), Axis::named("Strain", Unit::None), HEIGHT, LEAST_STRAIN).with(curves);
    let subject = format!("strains, {} {}", view.progress(), view.progress_at(last));
    let note = "Thin: the earlier frames. Logarithmic strains of the mid-surface.".to_owned();
    Some(view.chart(&subject, vec![panel], [Some(note), view.frames_note()].into_iter().flatten()))
}
