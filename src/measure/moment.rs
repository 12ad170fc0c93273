//! Resolution of the section's moment by the thickness points.

use crate::numerics::quadrature::ThicknessPoint;
use crate::solver::solution::{Frame, PointRecord};

/// Estimates the largest quadrature error of the meridional moment through the thickness, over its largest value \[–\].
///
/// The rule Σ w ζ σ is compared with the exact integral of a stress that is linear between the points: with kinks of the stress
/// both miss the moment by as much; with a smooth stress the estimate is too large. `None` without a moment.
pub fn moment_error(frame: &Frame) -> Option<f64> {
    let layers = &frame.through.layers;
    let sections = || frame.elements.iter().zip(frame.through.elements());
    let by_rule = |thickness: f64, points| moment(thickness, layers, points, |point| point.stress_meridional);
    let largest = sections().map(|(e, points)| by_rule(e.thickness, points).abs()).fold(0.0, f64::max);
    let difference = |thickness: f64, points| by_rule(thickness, points) - linear(thickness, layers, points);
    let errors = sections().map(|(e, points)| difference(e.thickness, points).abs() / largest);
    errors.filter(|error| error.is_finite()).max_by(f64::total_cmp)
}

/// ∫ σ ζ dζ by the rule, ζ from the mid-surface towards the punch's face \[N\].
pub(super) fn moment(t: f64, layers: &[ThicknessPoint], points: &[PointRecord], sigma: fn(&PointRecord) -> f64) -> f64 {
    0.5 * t * t * layers.iter().zip(points).map(|(layer, point)| layer.weight * layer.xi * sigma(point)).sum::<f64>()
}

/// ∫ σ ζ dζ of a meridional stress that is linear between the points \[N\].
fn linear(t: f64, layers: &[ThicknessPoint], points: &[PointRecord]) -> f64 {
    let parts = layers.windows(2).zip(points.windows(2)).map(|(l, p)| {
        let ((a, b), (at_a, at_b)) = ((l[0].xi, l[1].xi), (p[0].stress_meridional, p[1].stress_meridional));
        (b - a) / 12.0 * (at_a * (2.0 * a + b) + at_b * (a + 2.0 * b))
    });
    0.5 * t * t * parts.sum::<f64>()
}
