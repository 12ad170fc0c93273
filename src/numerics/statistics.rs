//! Statistics of a sample: quantiles, probabilities with intervals, rank correlations.

use statrs::distribution::{ContinuousCDF, Normal};
use statrs::statistics::{Data, OrderStatistics, RankTieBreaker, Statistics};

const CONFIDENCE: f64 = 0.95;

/// Share of hits with the ends of Wilson's interval of 95 %; `None` without a try.
///
/// Source: E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209–212 (not read; the formula is in common use).
pub fn wilson(hits: usize, tries: usize) -> Option<[f64; 3]> {
    let n = Some(tries as f64).filter(|n| *n > 0.0)?;
    let value = hits as f64 / n;
    let square = Normal::standard().inverse_cdf(0.5 * (1.0 + CONFIDENCE)).powi(2) / n;
    let middle = (value + 0.5 * square) / (1.0 + square);
    let half = (square * (value * (1.0 - value) + 0.25 * square)).sqrt() / (1.0 + square);
    Some([value, if hits == 0 { 0.0 } else { middle - half }, if hits == tries { 1.0 } else { middle + half }])
}

/// Means of at most `most` blocks of successive rows, as many rows in each but the first.
pub fn block_means<const N: usize>(rows: &[[f64; N]], most: usize) -> Vec<[f64; N]> {
    let blocks = rows.rchunks(rows.len().div_ceil(most).max(1)).rev();
    blocks.map(|block| std::array::from_fn(|i| block.iter().map(|row| row[i]).mean())).collect()
}

/// Quantile of sorted values, interpolated by Hazen's rule.
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = (share * sorted.len() as f64 - 0.5).clamp(0.0, sorted.len() as f64 - 1.0);
    let (below, part) = (place.floor() as usize, place.fract());
    sorted[below] + part * (sorted[(below + 1).min(sorted.len() - 1)] - sorted[below])
}

/// Spearman's rank correlation of pairs that are both finite; `None` if one does not vary.
pub fn rank_correlation(x: &[f64], y: &[f64]) -> Option<f64> {
    let pairs = x.iter().copied().zip(y.iter().copied()).filter(|(x, y)| x.is_finite() && y.is_finite());
    let (x, y): (Vec<f64>, Vec<f64>) = pairs.unzip();
    let [x, y] = [x, y].map(|values| Data::new(values).ranks(RankTieBreaker::Average));
    let deviations = (&x).population_std_dev() * (&y).population_std_dev();
    (deviations > 0.0).then(|| x.population_covariance(y) / deviations)
}
