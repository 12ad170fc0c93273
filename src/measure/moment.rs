//! Resolution of the section's moment by the thickness points.

use crate::numerics::lobatto::ThicknessPoint;
use crate::solver::solution::{Frame, PointRecord};

/// Estimated quadrature error of a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MomentError {
    /// Error over the largest moment of the sheet \[–\].
    pub share: f64,
    /// Initial distance of the place from the axis \[mm\].
    pub s0: f64,
}

/// Estimates the largest quadrature error of the meridional moment through the thickness.
///
/// The rule Σ w ζ σ is compared with the exact integral of a stress that is linear between the points: with kinks of the stress
/// both miss the moment by as much; with a smooth stress the estimate is too large. `None` without a moment.
pub fn moment_error(frame: &Frame) -> Option<MomentError> {
    let layers = &frame.through.layers;
    let sections = || frame.elements.iter().zip(frame.through.elements());
    // M over t²/2, which is the same in both integrals.
    let squares = |thickness: f64| 0.5 * thickness * thickness;
    let moments = sections().map(|(e, points)| squares(e.thickness) * summed(layers, points).abs());
    let largest = moments.fold(0.0, f64::max);
    let errors = sections().map(|(e, points)| MomentError {
        share: squares(e.thickness) * (summed(layers, points) - linear(layers, points)).abs() / largest,
        s0: e.s0,
    });
    errors.filter(|error| error.share.is_finite()).max_by(|a, b| a.share.total_cmp(&b.share))
}

/// ½ ∫ ξ σ dξ by the rule \[MPa\].
fn summed(layers: &[ThicknessPoint], points: &[PointRecord]) -> f64 {
    layers.iter().zip(points).map(|(layer, point)| layer.weight * layer.xi * point.stress_meridional).sum()
}

/// ½ ∫ ξ σ dξ of a stress that is linear between the points \[MPa\].
fn linear(layers: &[ThicknessPoint], points: &[PointRecord]) -> f64 {
    let intervals = layers.windows(2).zip(points.windows(2));
    let parts = intervals.map(|(l, p)| {
        let ((a, b), (at_a, at_b)) = ((l[0].xi, l[1].xi), (p[0].stress_meridional, p[1].stress_meridional));
        (b - a) / 12.0 * (at_a * (2.0 * a + b) + at_b * (a + 2.0 * b))
    });
    parts.sum()
}
