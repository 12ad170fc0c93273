//! Student's distribution, for the intervals of fitted numbers.

use super::bisect;

/// Terms of the continued fraction, of which a dozen matter.
const TERMS: usize = 400;

/// Degrees of freedom from which on the distribution is the normal one to five digits, and the fraction would need more terms.
const NORMAL: f64 = 1e5;

/// The t beyond which, on either side, lies a share of 1 − `confidence` of Student's distribution.
///
/// # References
/// M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions (1964), 26.7.1 and 26.5.8.
pub fn student(confidence: f64, freedom: f64) -> f64 {
    let freedom = freedom.min(NORMAL);
    let beyond = |t: f64| incomplete_beta(freedom / (freedom + t * t), 0.5 * freedom, 0.5);
    // Over t/(1 + t), so that the longest tail has an end.
    let [x, _] = bisect(0.0, 1.0, 50, |x| beyond(x / (1.0 - x)) > 1.0 - confidence);
    x / (1.0 - x)
}

/// The regularised incomplete beta function I_x(a, b).
fn incomplete_beta(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 || x >= 1.0 {
        return x.clamp(0.0, 1.0);
    }
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - incomplete_beta(1.0 - x, b, a);
    }
    let front = (a * x.ln() + b * (1.0 - x).ln() + ln_gamma(a + b) - ln_gamma(a) - ln_gamma(b)).exp() / a;
    // From the innermost term outward.
    let fraction = (1..=TERMS).rev().fold(1.0, |inner, n| {
        let m = (n / 2) as f64;
        let term = match n % 2 {
            0 => m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m)),
            _ => -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0)),
        };
        1.0 + term / inner
    });
    front / fraction
}

/// ln Γ(x) for x > 0, by Stirling's series from 10 on.
fn ln_gamma(x: f64) -> f64 {
    let (mut x, mut shift) = (x, 0.0);
    while x < 10.0 {
        shift += x.ln();
        x += 1.0;
    }
    let series = 1.0 / (12.0 * x) - 1.0 / (360.0 * x.powi(3)) + 1.0 / (1260.0 * x.powi(5));
    (x - 0.5) * x.ln() - x + 0.5 * (2.0 * std::f64::consts::PI).ln() + series - shift
}

#[cfg(test)]
mod tests {
    use super::student;

    /// Trust: tables of Student's distribution; with two degrees of freedom t² = 2 c²/(1 − c²), and with very many the normal
    /// distribution's 1.959964.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        let closed = |c: f64| (2.0 * c * c / (1.0 - c * c)).sqrt();
        for (confidence, freedom, t) in [
            (0.95, 1.0, 12.706_205),
            (0.95, 2.0, closed(0.95)),
            (0.5, 2.0, closed(0.5)),
            (0.95, 10.0, 2.228_139),
            (0.95, 30.0, 2.042_272),
            (0.99, 10.0, 3.169_273),
            (0.95, 1e3, 1.962_339),
        ] {
            let found = student(confidence, freedom);
            assert!((found - t).abs() < 2e-6 * t, "{confidence} {freedom}: {found}, not {t}");
        }
    }
}
