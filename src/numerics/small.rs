//! Functions of small arguments, which the strains of a step are: the heads of their series take a quarter of what the
//! library's functions do.
//!
//! ```text
//! ln(1 + x) = 2 artanh z, z = x/(2 + x)      artanh z = z S(z²)      atan z = z S(−z²)
//! S(y) = 1 + y/3 + y²/5 + y³/7 + y⁴/9 + …
//! sin x = x (1 − y/6 + y²/120 − …), cos x = 1 − y/2 + y²/24 − …      y = x²
//! ```

use super::Real;

/// Largest |y| of the head: what is left out, y⁵/11, is then below 3e-20.
const SMALL: f64 = 2e-4;

#[inline(always)]
fn head<T: Real>(y: T) -> T {
    y * (y * (y * (y * (1.0 / 9.0) + 1.0 / 7.0) + 1.0 / 5.0) + 1.0 / 3.0) + 1.0
}

/// Where a square is so small.
#[inline(always)]
fn is_small<T: Real>(square: T) -> T::Mask {
    square.constant(SMALL).exceeds(square)
}

/// ln(1 + x).
#[inline(always)]
pub fn ln_1p<T: Real>(x: T) -> T {
    let z = x / (x + 2.0);
    let square = z * z;
    let (small, near) = (is_small(square), z * 2.0 * head(square));
    if x.everywhere(small) {
        return near;
    }
    let [far] = T::each([x], |[x]| [x.ln_1p()]);
    near.where_or(small, far)
}

/// Angle of the direction `(x, y)` from the x axis \[rad\], within ±π.
#[inline(always)]
pub fn angle<T: Real>(y: T, x: T) -> T {
    let slope = y / x;
    let square = slope * slope;
    let ahead = square.where_or(x.exceeds(x.constant(0.0)), x.constant(1.0));
    let (small, near) = (is_small(ahead), slope * head(-square));
    if x.everywhere(small) {
        return near;
    }
    let [far] = T::each([y, x], |[y, x]| [y.atan2(x)]);
    near.where_or(small, far)
}

/// Sine and cosine of an angle \[rad\].
#[inline(always)]
pub fn sin_cos<T: Real>(x: T) -> [T; 2] {
    let y = x * x;
    let sine = y * (y * (y * (-1.0 / 5040.0) + 1.0 / 120.0) - 1.0 / 6.0) + 1.0;
    let cosine = y * (y * (y * (-1.0 / 720.0) + 1.0 / 24.0) - 0.5) + 1.0;
    let (small, near) = (is_small(y), [x * sine, cosine]);
    if x.everywhere(small) {
        return near;
    }
    let far = T::each([x], |[x]| x.sin_cos().into());
    [near[0].where_or(small, far[0]), near[1].where_or(small, far[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::number::{Instructions, LANES, Lanes, Work, dispatch};
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
                let ([sine, cosine], exact) = (sin_cos(x), x.sin_cos());
                assert_relative_eq!(sine, exact.0, epsilon = 0.0, max_relative = 1e-15);
                assert_relative_eq!(cosine, exact.1, epsilon = 0.0, max_relative = 1e-15);
            }
        }
        assert_eq!(ln_1p(-0.5), (-0.5_f64).ln_1p());
        assert_eq!(angle(1.0, 0.0), std::f64::consts::FRAC_PI_2);
    }
    /// What they are of four numbers side by side.
    struct Beside([f64; LANES]);

    impl Work for Beside {
        type Output = [[f64; LANES]; 4];

        #[inline(always)]
        fn run<S: Instructions>(self, simd: S) -> [[f64; LANES]; 4] {
            let x = Lanes::new(simd, self.0);
            let [sine, cosine] = sin_cos(x);
            [ln_1p(x).values(), angle(x, x + 1.0).values(), sine.values(), cosine.values()]
        }
    }

    /// Trust: to the bit, with all of them small, some, and none.
    #[test]
    fn side_by_side_they_are_what_they_are_alone() {
        for x in [[1e-9, -2e-3, 0.0, 1e-4], [1e-9, 0.7, -3e-3, -0.4], [0.2, -0.7, 3.0, 1.5]] {
            let alone = [ln_1p, |x| angle(x, x + 1.0), |x| sin_cos(x)[0], |x| sin_cos(x)[1]];
            assert_eq!(dispatch(Beside(x)), alone.map(|function: fn(f64) -> f64| x.map(function)));
        }
    }
}
