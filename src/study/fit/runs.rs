//! Whether residuals lie on either side as chance would have it.

/// How far the number of runs of one sign lies below what chance would give, in its standard deviations; negative where there
/// are fewer runs.
///
/// # References
/// A. Wald, J. Wolfowitz, Ann. Math. Statist. 11 (1940) 147–162 (not read; the formula is in common use).
pub(super) fn runs(residuals: &[f64]) -> f64 {
    let signs: Vec<bool> = residuals.iter().filter(|r| **r != 0.0).map(|r| *r > 0.0).collect();
    let n = signs.len() as f64;
    let above = signs.iter().filter(|sign| **sign).count() as f64;
    let below = n - above;
    if above == 0.0 || below == 0.0 || n < 8.0 {
        return 0.0;
    }
    let found = 1.0 + signs.windows(2).filter(|pair| pair[0] != pair[1]).count() as f64;
    let expected = 1.0 + 2.0 * above * below / n;
    let variance = (expected - 1.0) * (expected - 2.0) / (n - 1.0);
    (found - expected) / variance.sqrt()
}

/// Beyond chance.
pub(super) const PATTERN: f64 = -2.5;

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by hand, of ten in two runs (6 expected, √(20/9) wide) and of ten that alternate.
    #[test]
    fn a_bow_has_few_runs_and_a_zigzag_many() {
        let bow: Vec<f64> = (0..10).map(|i| if i < 5 { 1.0 } else { -1.0 }).collect();
        assert!((runs(&bow) + 4.0 / (20.0f64 / 9.0).sqrt()).abs() < 1e-12);
        let zigzag: Vec<f64> = (0..10).map(|i| if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert!((runs(&zigzag) - 4.0 / (20.0f64 / 9.0).sqrt()).abs() < 1e-12);
    }
}
