//! Residual stress through the thickness at a few places.

use super::*;
use crate::measure::{Band, Stretch, bands};
use crate::plot::fields::element::{STRESS_HOOP, STRESS_MERIDIONAL};
use crate::solver::solution::PointRecord;
use std::ops::Range;

/// Least span of a stress axis \[MPa\].
const LEAST: f64 = 1.0;
const HEIGHT: f64 = 300.0;
pub(crate) const PLACE: &str = "ζ/t, from the die's face (−0.5) to the punch's (0.5)";

pub(crate) fn released<'a>(view: &StageView<'a>) -> Option<(&'a Frame, &'a [ElementRecord])> {
    let [_, frame] = view.stage.released()?;
    Some((frame, &frame.elements[..frame.through.elements().len().min(frame.elements.len())]))
}

type StressOf = fn(&PointRecord) -> f64;

/// Meridional and hoop stress through the thickness in the middle of each band of the part.
pub fn plot(view: &StageView) -> Option<Chart> {
    let (frame, elements) = released(view)?;
    let (extent, layers) = (view.extent(), &frame.through.layers);
    let middle = |elements: &Range<usize>| elements.start + elements.len() / 2;
    let places = bands(view.stage).into_iter().map(|stretch| (middle(&stretch.elements), stretch));
    let places: Vec<(usize, Stretch)> = places.filter(|(element, _)| *element < elements.len()).collect();
    places.first()?;
    let stresses: [(_, StressOf); 2] = [(STRESS_MERIDIONAL, |p| p.stress_meridional), (STRESS_HOOP, |p| p.stress_hoop)];
    let panels = stresses.into_iter().enumerate().map(|(n, (field, stress))| {
        let curves = places.iter().enumerate().map(|(i, (element, stretch))| {
            let points = frame.through.elements().nth(*element).unwrap_or_default();
            let label = format!("{}, s0 = {}", capitalised(&stretch.name), Amount::place(elements[*element].s0));
            let points = layers.iter().zip(points).map(|(layer, point)| (0.5 * layer.xi, stress(point))).collect();
            Series { label: Some(label).filter(|_| n == 0), points, style: Style::curve(i) }
        });
        Panel::fit(Axis::named(PLACE, Unit::None), field.axis(extent), HEIGHT, LEAST).with(curves)
    });
    let points = format!("{} thickness points.", layers.len());
    let flange = places.iter().any(|(_, stretch)| stretch.band == Band::Flange);
    let face = flange.then(|| "In the flange the punch's face is the holder's.".to_owned());
    Some(view.chart("stress through the thickness", panels.collect(), [Some(points), face].into_iter().flatten()))
}
