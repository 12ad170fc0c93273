//! Intervals of fitted parameters by the profile of the least sum of squares: where, all others fitted anew, it has risen as far
//! as the confidence asks for.
//!
//! ```text
//! τ(θ) = ±√[(min S | θ) − S₀]/s,  and the ends of the interval are where |τ| = t
//! ```
//!
//! τ is straight where residuals are linear in the parameters; its bend is what standard errors leave out.
//!
//! # References
//! D. M. Bates, D. G. Watts, Nonlinear Regression Analysis and Its Applications (1988), chapter 6 (not read; in common use).

use super::least_squares::{Limits, Minimum, Parameter, Residuals, minimise};
use nalgebra::DMatrix;

/// An end of an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// Here.
    At(f64),
    /// At the parameter's bound, or beyond it.
    Open,
    /// It was not found.
    Unknown,
}

/// Trial values of an end.
const TRIALS: usize = 5;
/// How near to t is near enough \[–\].
const NEAR: f64 = 0.02;

/// Both ends of the interval of parameter `j` for residuals of that variance, |τ| ≤ `t`; of one that is pushed against its bound
/// the end within.
pub fn interval(
    parameters: &[Parameter],
    residuals: &dyn Residuals,
    limits: Limits,
    (minimum, covariance): (&Minimum, &DMatrix<f64>),
    (variance, t): (f64, f64),
    j: usize,
) -> [End; 2] {
    let best = minimum.values[j];
    let is_free = covariance[(j, j)] > 0.0;
    let error = match is_free {
        true => covariance[(j, j)].sqrt(),
        false => (variance / minimum.jacobian.column(j).norm_squared()).sqrt(),
    };
    let of_side = |side: f64| {
        let bound = if side < 0.0 { parameters[j].low } else { parameters[j].high };
        if best == bound || !error.is_finite() {
            return End::Open;
        }
        let (mut near, mut tau_near) = (best, 0.0);
        let mut value = best + side * t * error;
        for _ in 0..TRIALS {
            value = if side < 0.0 { value.max(bound) } else { value.min(bound) };
            let fixed: Vec<Parameter> = parameters
                .iter()
                .enumerate()
                .map(|(i, p)| {
                    let along = if is_free { covariance[(i, j)] / covariance[(j, j)] * (value - best) } else { 0.0 };
                    match i == j {
                        true => Parameter { start: value, low: value, high: value, ..*p },
                        false => Parameter { start: (minimum.values[i] + along).clamp(p.low, p.high), ..*p },
                    }
                })
                .collect();
            let Some(found) = minimise(&fixed, residuals, limits) else { return End::Unknown };
            let tau = ((found.sum() - minimum.sum()).max(0.0) / variance).sqrt();
            if (tau - t).abs() <= NEAR * t {
                return End::At(value);
            }
            if value == bound && tau < t {
                return End::Open;
            }
            let slope = (tau - tau_near) / (value - near);
            // Where the sum does not rise yet, farther out.
            let next = if side * slope > 0.0 { value + (t - tau) / slope } else { value + 0.5 * (value - best) };
            if tau < t {
                (near, tau_near) = (value, tau);
            }
            // Never back across the best value, nor farther than three times as far.
            value = best + ((next - best) / (value - best)).clamp(0.2, 3.0) * (value - best);
        }
        // As near as the trials came.
        End::At(value)
    };
    [of_side(-1.0), of_side(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: of a line the interval is that of its standard errors; of y = a² seen with an error of 1 about 9 it is √(9 ± 2).
    #[test]
    fn intervals_of_what_is_bent_are_bent() {
        let limits = Limits { steps: 100, change: 1e-12 };
        let parameter = Parameter { start: 2.0, low: 0.0, high: 9.0, step: 1e-6 };
        let square = |x: &[f64]| Some(vec![x[0] * x[0] - 9.0]);
        let minimum = minimise(&[parameter], &square, limits).expect("residuals");
        let covariance = minimum.covariance(1.0).expect("told apart");
        let ends = interval(&[parameter], &square, limits, (&minimum, &covariance), (1.0, 2.0), 0);
        for (end, expected) in ends.into_iter().zip([7f64.sqrt(), 11f64.sqrt()]) {
            // Trust: τ is met within 2 % of 2, which is 0.04/(2 a) of a.
            assert!(matches!(end, End::At(x) if (x - expected).abs() < 0.04 / 5.0), "{ends:?}");
        }
        let wide = interval(&[parameter], &square, limits, (&minimum, &covariance), (1e4, 2.0), 0);
        assert_eq!(wide[0], End::Open);
    }
}
