//! A value that changes along the run.

/// Interpolates linearly between points of rising x, of which there is at least one; constant beyond the ends.
pub fn interpolated(points: &[(f64, f64)], x: f64) -> f64 {
    let after = points.partition_point(|p| p.0 < x);
    if after == 0 {
        return points[0].1;
    }
    let Some(&(x1, v1)) = points.get(after) else { return points[after - 1].1 };
    let (x0, v0) = points[after - 1];
    v0 + (v1 - v0) * (x - x0) / (x1 - x0)
}

/// A value over the punch travel or the time: linear between its points, constant beyond the ends.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewiseLinear {
    points: Vec<(f64, f64)>,
}

impl From<f64> for PiecewiseLinear {
    fn from(value: f64) -> Self {
        Self { points: vec![(0.0, value)] }
    }
}

impl PiecewiseLinear {
    /// Through the points (x, value); `None` when there is none, or x does not rise from each to the next.
    pub fn new(points: Vec<(f64, f64)>) -> Option<Self> {
        (!points.is_empty() && points.windows(2).all(|w| w[0].0 < w[1].0)).then_some(Self { points })
    }

    /// The value at `x`.
    pub fn at(&self, x: f64) -> f64 {
        interpolated(&self.points, x)
    }

    /// Place at which a value that rises from point to point is reached; before the first and after the last point as [`Self::at`].
    pub fn reaches(&self, value: f64) -> f64 {
        interpolated(&self.points.iter().map(|(x, value)| (*value, *x)).collect::<Vec<_>>(), value)
    }

    /// Slope of the line that leads up to `x`; 0 up to the first point and beyond the last.
    pub fn slope_before(&self, x: f64) -> f64 {
        let line = self.points.windows(2).find(|line| line[0].0 < x && x <= line[1].0);
        line.map_or(0.0, |line| (line[1].1 - line[0].1) / (line[1].0 - line[0].0))
    }

    /// Rising from 0 at 0 to its value at `x`, unchanged beyond.
    pub fn rising_to(&self, x: f64) -> Self {
        let beyond = self.points.iter().copied().filter(|p| p.0 > x);
        Self { points: [(0.0, 0.0), (x, self.at(x))].into_iter().chain(beyond).collect() }
    }

    /// Every value more by this much.
    pub fn raised(&self, by: f64) -> Self {
        Self { points: self.points.iter().map(|(x, value)| (*x, value + by)).collect() }
    }

    /// The points (x, value).
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// The largest value.
    pub fn largest(&self) -> f64 {
        self.points.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The smallest value.
    pub fn smallest(&self) -> f64 {
        self.points.iter().map(|p| p.1).fold(f64::INFINITY, f64::min)
    }
}
