//! What a number hangs on: Sobol indices, and rank correlations where those are too dear.
//!
//! ```text
//!   S  = mean f(B) (f(AB) − f(A)) / V          first order: what of the variance V goes when the group is known
//!   Sₜ = mean (f(A) − f(AB))² / 2V             total: what stays when all others are known
//! ```
//! A is a point, B its partner, AB the point with the group's coordinates from the partner.
//!
//! # References
//! A. Saltelli, P. Annoni, I. Azzini, F. Campolongo, M. Ratto, S. Tarantola, Variance based sensitivity analysis of model
//! output, Comput. Phys. Commun. 181 (2010) 259–270 (not read: the estimator of first order); M. J. W. Jansen, Analysis of
//! variance designs for model output, Comput. Phys. Commun. 117 (1999) 35–43 (not read: the total one).

use super::estimate::{Estimate, jackknife};
use super::sampling::{REPLICATES, Sampling};

/// What of a number's variance a group of what scatters decides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index {
    /// By itself \[–\].
    pub first: Estimate,
    /// With what it does together with others \[–\].
    pub total: Estimate,
}

/// Sums over the points of one scrambling.
#[derive(Clone, Copy, Default)]
struct Sums {
    points: f64,
    value: f64,
    square: f64,
    first: f64,
    total: f64,
}

impl Sums {
    fn minus(self, other: Self) -> Self {
        Self {
            points: self.points - other.points,
            value: self.value - other.value,
            square: self.square - other.square,
            first: self.first - other.first,
            total: self.total - other.total,
        }
    }

    /// Variance of points and partners together.
    fn variance(self) -> f64 {
        let count = 2.0 * self.points;
        self.square / count - (self.value / count).powi(2)
    }
}

/// The indices of each group, from the values of all rows of a sample with partners; a point of which a value is not finite
/// is left out. `None` of a number that does not vary, or where a scrambling has no whole point.
pub fn indices(sampling: &Sampling, values: &[f64]) -> Option<Vec<Index>> {
    let width = sampling.width();
    if !sampling.has_partners() {
        return None;
    }
    let whole =
        || values.chunks_exact(width).enumerate().filter(|(_, rows)| rows.iter().all(|value| value.is_finite()));
    // Less the mean: the estimator of first order is the more exact the nearer that is to 0.
    let mean = whole().map(|(_, rows)| rows[0]).sum::<f64>() / whole().count() as f64;
    let of = |group: usize| {
        let mut sums = [Sums::default(); REPLICATES];
        for (point, rows) in whole() {
            let [a, b, ab] = [rows[0], rows[1], rows[2 + group]].map(|value| value - mean);
            let own = &mut sums[point % REPLICATES];
            own.points += 1.0;
            own.value += a + b;
            own.square += a * a + b * b;
            own.first += b * (ab - a);
            own.total += (a - ab).powi(2);
        }
        let all = sums.iter().fold(Sums::default(), |all, own| all.minus(Sums::default().minus(*own)));
        let without = |one: Option<usize>| one.map_or(all, |one| all.minus(sums[one]));
        // Of numbers that are all the same but for round-off nothing can be said.
        let varies = |sums: Sums| (sums.points > 0.0 && sums.variance() > 1e-20 * mean.powi(2)).then_some(sums);
        let first = jackknife(|one| varies(without(one)).map(|s| s.first / s.points / s.variance()))?;
        let total = jackknife(|one| varies(without(one)).map(|s| 0.5 * s.total / s.points / s.variance()))?;
        Some(Index { first, total })
    };
    (0..sampling.groups()).map(of).collect()
}

/// Spearman's correlation of the ranks of two lists, of pairs that are both finite; `None` where one does not vary.
pub fn rank_correlation(x: &[f64], y: &[f64]) -> Option<f64> {
    let pairs: Vec<(f64, f64)> =
        x.iter().copied().zip(y.iter().copied()).filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
    let x = ranks(&pairs.iter().map(|pair| pair.0).collect::<Vec<_>>());
    let y = ranks(&pairs.iter().map(|pair| pair.1).collect::<Vec<_>>());
    let middle = 0.5 * (pairs.len() as f64 + 1.0);
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - middle) * (b - middle)).sum::<f64>();
    let scale = (product(&x, &x) * product(&y, &y)).sqrt();
    (scale > 0.0).then(|| product(&x, &y) / scale)
}

/// Ranks from 1, equal values with the mean of theirs.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
    let mut ranks = vec![0.0; values.len()];
    let mut first = 0;
    while first < order.len() {
        let ties = order[first..].iter().take_while(|&&i| values[i] == values[order[first]]).count();
        for &i in &order[first..first + ties] {
            ranks[i] = first as f64 + 0.5 * (ties as f64 + 1.0);
        }
        first += ties;
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: by hand, with the two equal values sharing rank 2.5; of a line the correlation is 1.
    #[test]
    fn equal_values_share_their_ranks() {
        assert_eq!(ranks(&[5.0, 1.0, 2.0, 2.0]), [4.0, 1.0, 2.5, 2.5]);
        let x = [1.0, 2.0, 3.0, f64::NAN];
        assert_relative_eq!(rank_correlation(&x, &[1.0, 8.0, 27.0, 0.0]).expect("varies"), 1.0, max_relative = 1e-12);
        assert_relative_eq!(rank_correlation(&x, &[3.0, 2.0, 1.0, 9.0]).expect("varies"), -1.0, max_relative = 1e-12);
        assert_eq!(rank_correlation(&x, &[1.0; 4]), None);
    }
}
