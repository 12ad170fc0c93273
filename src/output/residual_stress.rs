//! Stress through the thickness of one frame: at every layer in numbers, at a few places as curves.

use super::StageView;
use super::chart::{Chart, Look, Panel, Scale, Series};
use crate::measure::{Place, places};
use crate::message::{Amount, message};
use crate::solver::solution::{ElementRecord, Frame, PointRecord};
use crate::table::fields::element::{R, S0, STRAIN_EQUIVALENT, STRESS_HOOP, STRESS_MERIDIONAL, Z};
use crate::table::{Column, Field, Table, Unit};

/// Least height of a stress axis \[MPa\]: smaller stresses are noise or nothing to look at.
const LEAST: f64 = 1.0;

/// The frame after release, of a stage that takes its tools away, with its elements that have thickness points.
fn released<'a>(view: &StageView<'a>) -> Option<(&'a Frame, &'a [ElementRecord])> {
    let [_, frame] = view.stage.released()?;
    Some((frame, &frame.elements[..frame.through.elements().len().min(frame.elements.len())]))
}

/// The places that are shown: those of [`places`] that have thickness points.
fn shown(frame: &Frame, elements: &[ElementRecord]) -> Vec<Place> {
    let has_layers = |place: &Place| !frame.through.layers.is_empty() && place.element < elements.len();
    places(frame).into_iter().filter(has_layers).collect()
}

/// One row per element and layer, from the axis outward and from the die's face to the punch's; nothing where no place
/// has thickness points.
pub(super) fn of(view: &StageView) -> Option<Table> {
    let (frame, elements) = released(view)?;
    shown(frame, elements).first()?;
    let (extent, layers) = (view.extent(), &frame.through.layers);
    let points = &frame.through.points[..elements.len() * layers.len()];
    let of_elements = |field: Field<ElementRecord>| {
        let each = elements.iter().flat_map(|e| std::iter::repeat_n((field.value)(e), layers.len()));
        field.filled(extent, each.collect())
    };
    let of_points = |field: Field<ElementRecord>, value: fn(&PointRecord) -> f64| {
        field.filled(extent, points.iter().map(value).collect())
    };
    let place = elements.iter().flat_map(|_| layers.iter().map(|layer| 0.5 * layer.xi));
    let zeta = elements.iter().flat_map(|e| layers.iter().map(|layer| 0.5 * layer.xi * e.thickness));
    Some(Table::new(vec![
        of_elements(S0),
        of_elements(R),
        of_elements(Z),
        across(place.collect()),
        Column::new("zeta", "ζ, from the mid-surface towards the punch", Unit::Mm, zeta.collect()),
        of_points(STRESS_MERIDIONAL, |p| p.stress_meridional),
        of_points(STRESS_HOOP, |p| p.stress_hoop),
        of_points(STRAIN_EQUIVALENT, |p| p.strain_equivalent),
    ]))
}

/// Where points lie in the thickness.
fn across(places: Vec<f64>) -> Column {
    Column::new("place", "ζ/t, from the die's face (−0.5) to the punch's (0.5)", Unit::None, places)
}

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
                label: labelled.then(|| view.tell(message!("{place}, s0 = {s0}", place = place.name, s0 = at(place)))),
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
    let held = is_held.then(|| view.tell("In the flange the punch's face is the holder's."));
    Some(Chart {
        title: view.titled("stress through the thickness"),
        legend: String::new(),
        panels: vec![
            panel(STRESS_MERIDIONAL, |point| point.stress_meridional, true),
            panel(STRESS_HOOP, |point| point.stress_hoop, false),
        ],
        notes: std::iter::once(view.tell(message!("{n} thickness points.", n = layers.len())))
            .chain(held)
            .chain(view.assumptions())
            .collect(),
    })
}
