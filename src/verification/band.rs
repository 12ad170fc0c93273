//! Error band of a curve.

use super::{Direction, Estimate};
use crate::numerics::interpolated;

/// Reach of an error to either side, over the length of the curve \[–\]: curves that cross agree by chance.
const REACH: f64 = 0.04;

/// A direction of refinement with the curves of its runs, coarse to fine.
pub(super) type Refined<'a> = (Direction, Vec<&'a [(f64, f64)]>);

/// Error band around a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Rising travel or initial distance from the axis \[mm\].
    pub x: Vec<f64>,
    /// Lower side, in the curve's unit.
    pub low: Vec<f64>,
    /// Upper side.
    pub high: Vec<f64>,
}

impl Band {
    /// Band around a curve from the curves of finer runs, as far as they come.
    pub(super) fn around(
        curve: &[(f64, f64)],
        directions: &[Refined<'_>],
        estimate: impl Fn(Direction, &[f64]) -> Estimate,
    ) -> Option<Self> {
        let half = |&(x, value): &(f64, f64)| {
            let errors = directions.iter().map(|(direction, finer)| {
                let finer = finer.iter().filter_map(|curve| at(curve, x));
                estimate(*direction, &[value].into_iter().chain(finer).collect::<Vec<_>>()).error
            });
            errors.sum::<f64>()
        };
        let x: Vec<f64> = curve.iter().map(|point| point.0).collect();
        let half = envelope(&x, &curve.iter().map(half).collect::<Vec<_>>());
        let side = |sign: f64| curve.iter().zip(&half).map(|((_, value), half)| value + sign * half).collect();
        (!x.is_empty() && !directions.is_empty()).then(|| Self { low: side(-1.0), high: side(1.0), x })
    }
}

/// Largest error within reach of each place, smoothed over the same reach: nowhere below the error itself.
fn envelope(x: &[f64], half: &[f64]) -> Vec<f64> {
    let reach = REACH * (x.last().unwrap_or(&0.0) - x.first().unwrap_or(&0.0));
    let near = |values: &[f64], fold: fn(&[f64]) -> f64| -> Vec<f64> {
        let of = |at: &f64| {
            let [from, to] = [at - reach, at + reach];
            fold(&values[x.partition_point(|x| *x < from)..x.partition_point(|x| *x <= to)])
        };
        x.iter().map(of).collect()
    };
    let largest = near(half, |near| near.iter().copied().fold(0.0, f64::max));
    near(&largest, |near| near.iter().sum::<f64>() / near.len() as f64)
}

/// Value of a curve, held for one interval beyond its end.
fn at(curve: &[(f64, f64)], x: f64) -> Option<f64> {
    let [.., before, last] = curve else { return None };
    (x <= last.0 + (last.0 - before.0)).then(|| interpolated(curve, x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verification::estimate;
    use approx::assert_relative_eq;

    /// Trust: curves 2x, 2x + 1 and 2x + 1.5, which converge to 2x + 2 with the order 1.
    #[test]
    fn a_band_is_the_error_at_each_place() {
        let curve = |raised: f64, n: usize| -> Vec<(f64, f64)> {
            (0..=n).map(|i| 4.0 * i as f64 / n as f64).map(|x| (x, 2.0 * x + raised)).collect()
        };
        let (own, finer) = (curve(0.0, 4), [curve(1.0, 8), curve(1.5, 16)]);
        let directions = [(Direction::Steps, finer.iter().map(Vec::as_slice).collect())];
        let band = Band::around(&own, &directions, |direction, levels| estimate(levels, direction.order()));
        let band = band.expect("a curve");
        for (i, (x, value)) in own.iter().enumerate() {
            assert_eq!(band.x[i], *x);
            assert_relative_eq!(band.high[i], value + 2.5, max_relative = 1e-12);
            assert_relative_eq!(band.low[i], value - 2.5, max_relative = 1e-12);
        }
        assert_eq!(at(&own, 9.0), None);
    }

    /// Trust: by construction; the wave of the errors has its knots 10 apart, and the band reaches 4 % of 100 to each side.
    #[test]
    fn a_band_does_not_close_where_curves_cross() {
        let x: Vec<f64> = (0..=100).map(f64::from).collect();
        let half: Vec<f64> = x.iter().map(|x| (std::f64::consts::PI * x / 10.0).sin().abs()).collect();
        let envelope = envelope(&x, &half);
        assert!(envelope.iter().zip(&half).all(|(envelope, half)| envelope >= half));
        assert!(envelope.iter().all(|half| (0.8..=1.0).contains(half)), "{envelope:?}");
    }
}
