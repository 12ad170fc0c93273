//! Residual stress through the thickness at a few places.

use super::StageView;
use super::chart::{Chart, Panel, Series, Style};
use crate::measure::{FLANGE, Place, part_places};
use crate::plot::Axis;
use crate::plot::fields::element::{STRESS_HOOP, STRESS_MERIDIONAL};
use crate::solver::solution::{ElementRecord, Frame, PointRecord};
use crate::table::Unit;
use crate::units::Amount;

/// Least span of a stress axis \[MPa\].
const LEAST: f64 = 1.0;
const HEIGHT: f64 = 300.0;
pub(crate) const PLACE: &str = "ζ/t, from the die's face (−0.5) to the punch's (0.5)";

/// Frame after release and its elements with thickness points; `None` without a release.
pub(crate) fn released<'a>(view: &StageView<'a>) -> Option<(&'a Frame, &'a [ElementRecord])> {
    let [_, frame] = view.stage.released()?;
    Some((frame, &frame.elements[..frame.through.elements().len().min(frame.elements.len())]))
}

pub(crate) fn places_with_layers(frame: &Frame, elements: &[ElementRecord]) -> Vec<Place> {
    let has_layers = |place: &Place| !frame.through.layers.is_empty() && place.element < elements.len();
    part_places(frame).into_iter().filter(has_layers).collect()
}

type StressOf = fn(&PointRecord) -> f64;

/// Meridional and hoop stress over the place through the thickness; `None` without layers.
pub fn plot(view: &StageView) -> Option<Chart> {
    let (frame, elements) = released(view)?;
    let (extent, layers) = (view.extent(), &frame.through.layers);
    let places = places_with_layers(frame, elements);
    places.first()?;
    let stresses: [(_, StressOf); 2] =
        [(STRESS_MERIDIONAL, |point| point.stress_meridional), (STRESS_HOOP, |point| point.stress_hoop)];
    let panels = stresses.into_iter().enumerate().map(|(n, (field, stress))| {
        let curves = places.iter().enumerate().map(|(i, place)| {
            let points = frame.through.elements().nth(place.element).unwrap_or_default();
            let label = format!("{}, s0 = {}", place.name, Amount::place(elements[place.element].s0));
            Series {
                label: Some(label).filter(|_| n == 0),
                points: layers.iter().zip(points).map(|(layer, point)| (0.5 * layer.xi, stress(point))).collect(),
                style: Style::curve(i),
            }
        });
        Panel::fit(Axis::named(PLACE, Unit::None), field.axis(extent), HEIGHT, LEAST).with(curves)
    });
    let points = format!("{} thickness points.", layers.len());
    let flange = places.iter().any(|place| place.name == FLANGE);
    let face = flange.then(|| "In the flange the punch's face is the holder's.".to_owned());
    Some(view.chart("stress through the thickness", panels.collect(), [Some(points), face].into_iter().flatten()))
}
