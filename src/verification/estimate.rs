//! Error of a number from its values on finer and finer levels.

/// Factors of safety on an extrapolated error, and on the spread of values that follow no order \[–\].
const EXTRAPOLATED: f64 = 1.25;
const SPREAD: f64 = 3.0;

/// Accepted factor between observed and formal order \[–\].
const BELIEVED: f64 = 2.0;

/// Error of a number by one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Estimated upper bound of the discretisation error, in the number's unit.
    pub error: f64,
    /// Observed order of convergence, if the differences keep their sign \[–\].
    pub order: Option<f64>,
    /// True if it was extrapolated with that order, false if it is from the spread.
    pub extrapolated: bool,
}

/// Error of the first level, each twice as fine as the one before: by Richardson's extrapolation if three levels show an order
/// near the `formal` one, else by their spread.
pub fn estimate(levels: &[f64], formal: Option<f64>) -> Estimate {
    let order = match levels {
        [coarse, fine, finest, ..] => observed(coarse - fine, fine - finest),
        _ => None,
    };
    let near = |p: &f64| formal.is_some_and(|formal| (formal / BELIEVED..=formal * BELIEVED).contains(p));
    if let Some(p) = order.filter(near) {
        let error = EXTRAPOLATED * (levels[0] - levels[1]).abs() / (1.0 - 0.5_f64.powf(p));
        return Estimate { error, order, extrapolated: true };
    }
    let (low, high) =
        levels.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)));
    Estimate { error: if low < high { SPREAD * (high - low) } else { 0.0 }, order, extrapolated: false }
}

/// log₂ of the quotient of two differences of one sign.
fn observed(coarse: f64, fine: f64) -> Option<f64> {
    Some(coarse / fine).filter(|quotient| quotient.is_finite() && *quotient > 0.0).map(f64::log2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: f = 7 + c hᵖ with h = 1, 1/2, 1/4 has the error c on its first level.
    #[test]
    fn a_power_law_is_extrapolated_to_its_limit() {
        for (formal, p) in [(1.0, 0.6), (1.0, 1.0), (1.0, 1.9), (2.0, 1.1), (2.0, 2.0), (2.0, 3.9)] {
            for c in [0.3, -2.0] {
                let levels = [1.0_f64, 0.5, 0.25].map(|h| 7.0 + c * h.powf(p));
                let found = estimate(&levels, Some(formal));
                assert!(found.extrapolated);
                assert_relative_eq!(found.order.expect("one sign"), p, max_relative = 1e-9);
                assert_relative_eq!(found.error, 1.25 * f64::abs(c), max_relative = 1e-9);
            }
        }
    }

    /// Trust: by hand; the differences are 3 and −1, 1 and 3, 1 and 0, and none.
    #[test]
    fn what_follows_no_power_has_three_times_its_spread() {
        for (levels, formal, error, order) in [
            ([10.0, 7.0, 8.0], Some(1.0), 9.0, None),
            ([10.0, 9.0, 6.0], Some(1.0), 12.0, Some((1.0_f64 / 3.0).log2())),
            ([10.0, 9.0, 9.0], Some(2.0), 3.0, None),
            ([10.0, 9.0, 8.5], None, 4.5, Some(1.0)),
            ([10.0, 10.0, 10.0], Some(1.0), 0.0, None),
        ] {
            assert_eq!(estimate(&levels, formal), Estimate { error, order, extrapolated: false }, "{levels:?}");
        }
        assert_eq!(estimate(&[5.0, 4.0], Some(1.0)), Estimate { error: 3.0, order: None, extrapolated: false });
        assert_eq!(estimate(&[5.0], Some(1.0)), Estimate { error: 0.0, order: None, extrapolated: false });
    }
}
