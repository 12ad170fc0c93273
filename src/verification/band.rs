//! The error band of a curve.

use super::bar::combined;
use super::direction::Direction;
use super::estimate::Estimate;
use crate::numerics::interpolated;

/// What lies around a curve of the run as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Where, rising: travel or initial distance from the axis \[mm\].
    pub x: Vec<f64>,
    /// The lower side, in the curve's unit.
    pub low: Vec<f64>,
    /// The upper side.
    pub high: Vec<f64>,
}

/// A curve of the run as it is, and of the runs of one direction.
pub(super) struct Curves<'a> {
    pub direction: Direction,
    pub finer: Vec<&'a [(f64, f64)]>,
}

impl Band {
    /// Around a curve, from what the finer runs of every direction have at the same places, as far as they come.
    pub(super) fn around(
        curve: &[(f64, f64)],
        directions: &[Curves],
        estimate: impl Fn(Direction, &[f64]) -> Estimate,
    ) -> Option<Self> {
        let mut band = Self { x: Vec::new(), low: Vec::new(), high: Vec::new() };
        for &(x, value) in curve {
            let errors = directions.iter().map(|Curves { direction, finer }| {
                let levels: Vec<f64> =
                    [value].into_iter().chain(finer.iter().filter_map(|curve| at(curve, x))).collect();
                estimate(*direction, &levels).error
            });
            let half = combined(errors);
            band.x.push(x);
            band.low.push(value - half);
            band.high.push(value + half);
        }
        (!band.x.is_empty() && !directions.is_empty()).then_some(band)
    }
}

/// A curve between its points; of what lies outside, up to an element or a step from its ends, the end's.
fn at(curve: &[(f64, f64)], x: f64) -> Option<f64> {
    let [.., before, last] = curve else { return None };
    (x <= last.0 + (last.0 - before.0)).then(|| interpolated(curve, x))
}

#[cfg(test)]
mod tests {
    use super::super::estimate::estimate;
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: curves 2x, 2x + 1 and 2x + 1.5, which converge to 2x + 2 with the order 1.
    #[test]
    fn a_band_is_the_error_at_each_place() {
        let curve = |raised: f64, n: usize| -> Vec<(f64, f64)> {
            (0..=n).map(|i| 4.0 * i as f64 / n as f64).map(|x| (x, 2.0 * x + raised)).collect()
        };
        let (own, finer) = (curve(0.0, 4), [curve(1.0, 8), curve(1.5, 16)]);
        let directions = [Curves { direction: Direction::Steps, finer: finer.iter().map(Vec::as_slice).collect() }];
        let band = Band::around(&own, &directions, |direction, levels| estimate(levels, direction.order()));
        let band = band.expect("a curve");
        for (i, (x, value)) in own.iter().enumerate() {
            assert_eq!(band.x[i], *x);
            assert_relative_eq!(band.high[i], value + 2.5, max_relative = 1e-12);
            assert_relative_eq!(band.low[i], value - 2.5, max_relative = 1e-12);
        }
        assert_eq!(at(&own, 9.0), None);
    }
}
