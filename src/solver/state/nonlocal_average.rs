//! Averages along the meridian over a length of about a thickness.
//!
//! A sheet bent under tension thins, and its moment falls with the square of the thickness: without a length scale single
//! elements bend on and neighbours thin in turn. So an element's section has the mean thickness of its neighbourhood.

use crate::numerics::running_sums;
use crate::solver::*;

/// Length of a neighbourhood along the meridian over the initial thickness \[–\]. From 1 to 2 the thinnest place of deep cups is
/// the same within 0.1 %; below 1 neighbours of half a thickness still thin in turn.
pub const NEIGHBOURHOOD: f64 = 1.5;

/// Averaging windows of all elements at one instant.
#[derive(Clone, Debug)]
pub struct NonlocalAverage {
    /// Length along the meridian to each node \[mm\].
    ends: Vec<f64>,
    /// Half the window \[mm\].
    reach: f64,
    /// Element at each end of a window, and length from the axis \[mm\], negative on the mirror image.
    spans: Vec<[(usize, f64); 2]>,
}

impl NonlocalAverage {
    /// Windows of the elements of `state`.
    pub fn new(model: &Model, state: &State) -> Self {
        let lengths = (0..state.thickness.len()).map(|e| state.along(e).norm());
        Self::over(lengths, 0.5 * NEIGHBOURHOOD * model.blank.thickness)
    }

    fn over(lengths: impl Iterator<Item = f64>, reach: f64) -> Self {
        let ends = running_sums(lengths);
        let whole = ends[ends.len() - 1];
        let inner = &ends[1..ends.len() - 1];
        let place = |at: f64| (inner.partition_point(|end| *end <= at.abs()), at);
        let span = |pair: &[f64]| {
            let middle = 0.5 * (pair[0] + pair[1]);
            match pair[1] - middle >= reach {
                true => [(0, 0.0); 2],
                false => [place((middle - reach).max(-whole)), place(whole.min(middle + reach))],
            }
        };
        Self { spans: ends.windows(2).map(span).collect(), ends, reach }
    }

    /// Share of its window that element `e` covers itself \[–\].
    pub fn own_share(&self, e: usize) -> f64 {
        (0.5 * (self.ends[e + 1] - self.ends[e]) / self.reach).min(1.0)
    }

    /// Mean of a value per element over each window; the sheet is mirrored at the axis and ends at the edge.
    pub fn means(&self, of: impl Fn(usize) -> f64) -> Vec<f64> {
        let sums = running_sums(self.ends.windows(2).enumerate().map(|(e, pair)| (pair[1] - pair[0]) * of(e)));
        let up_to = |element: usize, at: f64| {
            let sum = sums[element] + (at.abs() - self.ends[element]) * of(element);
            if at < 0.0 { -sum } else { sum }
        };
        let mean = |(e, [from, to]): (usize, &[(usize, f64); 2])| {
            let length = to.1 - from.1;
            if length > 0.0 { (up_to(to.0, to.1) - up_to(from.0, from.1)) / length } else { of(e) }
        };
        self.spans.iter().enumerate().map(mean).collect()
    }
}

/// Trust: 1.5 mm about the middle of an element of 1 mm are itself, both neighbours and half of the next ones.
#[cfg(test)]
#[test]
fn the_mean_is_that_of_the_length_within_reach() {
    let values = [4.0, 1.0, 7.0, 2.0];
    for (lengths, reach, e, mean) in [
        ([2.0; 4], 1.0, 2, 7.0),
        ([1.0; 4], 1.5, 1, (4.0 + 1.0 + 7.0) / 3.0),
        ([1.0; 4], 1.5, 0, (4.0 + 4.0 + 1.0) / 3.0),
        ([1.0; 4], 1.5, 3, (2.0 + 7.0) / 2.0),
        ([2.0, 1.0, 2.0, 1.0], 1.0, 1, 0.25 * 4.0 + 0.5 + 0.25 * 7.0),
    ] {
        let windows = NonlocalAverage::over(lengths.into_iter(), reach);
        approx::assert_relative_eq!(windows.means(|k| values[k])[e], mean, max_relative = 1e-14);
    }
}
