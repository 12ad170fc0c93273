//! How far a difference must reach so that it measures a run's answer and not its noise.
//!
//! A run's curve has steps in it that no parameter makes: increments that end elsewhere, contacts that close one step later. Their
//! size follows from runs whose keys differ by next to nothing: a smooth curve has no second difference there, so that what is
//! left of it is noise, √6 times that of one run. A difference then reaches so far that the curve moves by a hundred times the
//! noise, between a hundredth and a twentieth of the range: nearer, single increments that end elsewhere make a slope of their
//! own; farther, the curve's bend does.
//!
//! # References
//! J. J. Moré, S. M. Wild, Estimating computational noise, SIAM J. Sci. Comput. 33 (2011) 1292–1314 (not read: the differences of
//! neighbours).

use crate::numerics::least_squares::{Parameter, Residuals};

/// Distance of the runs that noise is measured by, over the range \[–\].
const TINY: f64 = 1e-4;
/// Runs that it is measured by.
const RUNS: usize = 5;
/// A difference moves the curve by so many times the noise \[–\].
const TIMES: f64 = 100.0;
/// How far the first differences reach, over the range \[–\].
const FIRST: f64 = 0.01;
/// Least and largest reach over that \[–\].
const REACH: [f64; 2] = [1.0, 5.0];

/// Gives every parameter the half width of its differences; the root of the mean square of a run's noise, and for each
/// parameter that of the residuals' change over its whole range. `None` where runs fail or no more are wanted.
pub(super) fn measured(parameters: &mut [Parameter], residuals: &dyn Residuals) -> Option<(f64, Vec<f64>)> {
    let range = |p: &Parameter| p.high - p.low;
    let inward = |p: &Parameter| if p.start > 0.5 * (p.low + p.high) { -1.0 } else { 1.0 };
    let along =
        |i: usize| parameters.iter().map(|p| p.start + inward(p) * TINY * i as f64 * range(p)).collect::<Vec<_>>();
    let mut points: Vec<Vec<f64>> = (0..RUNS).map(along).collect();
    for j in 0..parameters.len() {
        let mut point = points[0].clone();
        point[j] += inward(&parameters[j]) * FIRST * range(&parameters[j]);
        points.push(point);
    }
    let found: Vec<Option<Vec<f64>>> = residuals.at(&points);
    let base = found.first()?.as_ref()?;
    let rms = |values: &mut dyn Iterator<Item = f64>| {
        let (sum, count) = values.fold((0.0, 0.0), |(sum, count), v| (sum + v * v, count + 1.0));
        if count > 0.0 { f64::sqrt(sum / count) } else { 0.0 }
    };
    let near: Vec<&Vec<f64>> = found.get(..RUNS)?.iter().flatten().collect();
    let seconds = near.windows(3).flat_map(|w| (0..base.len()).map(move |i| w[0][i] - 2.0 * w[1][i] + w[2][i]));
    let noise = rms(&mut seconds.into_iter()) / 6f64.sqrt();
    let mut felt = Vec::new();
    for (parameter, moved) in parameters.iter_mut().zip(found.get(RUNS..)?) {
        let change = moved.as_ref().map(|moved| rms(&mut moved.iter().zip(base).map(|(a, b)| a - b)));
        let reach =
            change.map_or(1.0, |change| (TIMES * noise / change.max(f64::MIN_POSITIVE)).clamp(REACH[0], REACH[1]));
        parameter.step = reach * FIRST * (parameter.high - parameter.low);
        felt.push(change.unwrap_or(f64::NAN) / FIRST);
    }
    Some((noise, felt))
}
