//! Residual stress through the thickness.

use super::StageView;
use super::chart::{Chart, Look, Panel, Scale, Series};
use crate::measure::Place;
use crate::results::residual_stress::{across, released, shown};
use crate::solver::solution::{ElementRecord, PointRecord};
use crate::table::Field;
use crate::table::fields::element::{STRESS_HOOP, STRESS_MERIDIONAL};
use crate::units::Amount;

/// Least height of a stress axis \[MPa\]: smaller stresses are noise or nothing to look at.
const LEAST: f64 = 1.0;

/// Both stresses over the place through the thickness, at the places of [`places`]; `None` without layers.
pub fn plot(view: &StageView) -> Option<Chart> {
    let (frame, elements) = released(view)?;
    let (extent, layers) = (view.extent(), &frame.through.layers);
    let shown = shown(frame, elements);
    shown.first()?;
    let at = |place: &Place| Amount::place(elements[place.element].s0);
    let panel = |field: Field<ElementRecord>, stress: fn(&PointRecord) -> f64, labelled: bool| {
        let series = shown.iter().enumerate().map(|(i, place)| {
            let points = frame.through.elements().nth(place.element).unwrap_or_default();
            Series {
                label: labelled.then(|| format!("{place}, s0 = {s0}", place = place.name, s0 = at(place))),
                points: layers.iter().zip(points).map(|(layer, point)| (0.5 * layer.xi, stress(point))).collect(),
                look: Look::curve(i),
            }
        });
        Panel {
            x: across(Vec::new()).axis(),
            y: field.axis(extent),
            series: series.collect(),
            scale: Scale::Fit { height: 300.0, least: LEAST },
        }
    };
    let is_held = shown.iter().any(|place| place.name == Place::FLANGE);
    let held = is_held.then(|| String::from("In the flange the punch's face is the holder's."));
    Some(Chart {
        title: view.titled("stress through the thickness"),
        legend: String::new(),
        panels: vec![
            panel(STRESS_MERIDIONAL, |point| point.stress_meridional, true),
            panel(STRESS_HOOP, |point| point.stress_hoop, false),
        ],
        notes: std::iter::once(format!("{n} thickness points.", n = layers.len()))
            .chain(held)
            .chain(view.assumptions())
            .collect(),
    })
}
