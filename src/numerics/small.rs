//! Functions of small arguments, which the strains of a step are: the heads of their series take a quarter of what the
//! library's functions do.
//!
//! ```text
//! ln(1 + x) = 2 artanh z, z = x/(2 + x)      artanh z = z S(z²)      atan z = z S(−z²)
//! S(y) = 1 + y/3 + y²/5 + y³/7 + y⁴/9 + …
//! sin x = x (1 − y/6 + y²/120 − …), cos x = 1 − y/2 + y²/24 − …      y = x²
//! ```

/// Largest |y| of the head: what is left out, y⁵/11, is then below 3e-20.
const SMALL: f64 = 2e-4;

#[inline]
fn head(y: f64) -> f64 {
    1.0 + y * (1.0 / 3.0 + y * (1.0 / 5.0 + y * (1.0 / 7.0 + y * (1.0 / 9.0))))
}

/// ln(1 + x).
#[inline]
pub fn ln_1p(x: f64) -> f64 {
    let z = x / (2.0 + x);
    let square = z * z;
    if square < SMALL { 2.0 * z * head(square) } else { x.ln_1p() }
}

/// Angle of the direction `(x, y)` from the x axis \[rad\], within ±π.
#[inline]
pub fn angle(y: f64, x: f64) -> f64 {
    let slope = y / x;
    let square = slope * slope;
    if x > 0.0 && square < SMALL { slope * head(-square) } else { y.atan2(x) }
}

/// Sine and cosine of an angle \[rad\].
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    let y = x * x;
    if y < SMALL {
        let sine = 1.0 - y * (1.0 / 6.0 - y * (1.0 / 120.0 - y * (1.0 / 5040.0)));
        (x * sine, 1.0 - y * (0.5 - y * (1.0 / 24.0 - y * (1.0 / 720.0))))
    } else {
        x.sin_cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: the library's functions, right to a unit in the last digit or two; both sides of where the head ends.
    #[test]
    fn heads_are_the_functions() {
        for i in -1000..=1000 {
            for size in [1e-12, 1e-6, 1e-3, 0.03] {
                let x = size * f64::from(i) / 1000.0;
                assert_relative_eq!(ln_1p(x), x.ln_1p(), epsilon = 0.0, max_relative = 1e-15);
                assert_relative_eq!(angle(2.0 * x, 2.0), (2.0 * x).atan2(2.0), epsilon = 0.0, max_relative = 1e-15);
                assert_eq!(angle(x, -1.0), x.atan2(-1.0));
                let ((sine, cosine), exact) = (sin_cos(x), x.sin_cos());
                assert_relative_eq!(sine, exact.0, epsilon = 0.0, max_relative = 1e-15);
                assert_relative_eq!(cosine, exact.1, epsilon = 0.0, max_relative = 1e-15);
            }
        }
        assert_eq!(ln_1p(-0.5), (-0.5_f64).ln_1p());
        assert_eq!(angle(1.0, 0.0), std::f64::consts::FRAC_PI_2);
    }
}
