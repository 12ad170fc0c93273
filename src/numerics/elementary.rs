//! Logarithm, exponential and power, of one number or of several side by side: without branches, and the same to the last bit
//! on every processor.
//!
//! ```text
//! ln x = e ln 2 + 2 artanh z, z = (m − 1)/(m + 1)        x = m 2^e, √½ ≤ m < √2, z² < 0.0295
//! eʸ = 2^k e^f,  f = y − k ln 2                           |f| ≤ ½ ln 2
//! x^n = e^(n ln x)
//! ```
//!
//! The sums are added up in pairs and pairs of pairs (Estrin), whose parts the processor works out at once; one term after the
//! other (Horner) it would wait for each.

use super::Real;

/// ln 2 in two parts, the first short enough for its products to be exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
/// 1.5 · 2^52: what is added to it is rounded to a whole number, in its last bits.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// The bits of √½.
const LEAST_MANTISSA: u64 = std::f64::consts::FRAC_1_SQRT_2.to_bits();
/// 2^52: a whole number below it stands in its last bits.
const WHOLE: f64 = 4_503_599_627_370_496.0;
/// What the exponents of numbers are shifted by.
const BIAS: u64 = 1_023;
/// Largest |y| of the exponential's own formula.
const FAR: f64 = 700.0;

/// ln x for x > 0.
#[inline(always)]
pub fn ln<T: Real>(x: T) -> T {
    let [m, e] = T::each([x], |[x]| {
        // Shifted to be positive, the exponent goes through the last bits of 2^52: four of them take as long as one.
        let biased = x.to_bits().wrapping_sub(LEAST_MANTISSA).wrapping_add(BIAS << 52) >> 52;
        let exponent = f64::from_bits(biased | WHOLE.to_bits()) - (WHOLE + BIAS as f64);
        [f64::from_bits(x.to_bits().wrapping_sub(biased.wrapping_sub(BIAS) << 52)), exponent]
    });
    let z = (m - 1.0) / (m + 1.0);
    let y = z * z;
    let square = y * y;
    let fourth = square * square;
    // What is left out, y¹¹/23, is below 1e-18.
    let head = y * (1.0 / 5.0) + 1.0 / 3.0 + square * (y * (1.0 / 9.0) + 1.0 / 7.0);
    let middle = y * (1.0 / 13.0) + 1.0 / 11.0 + square * (y * (1.0 / 17.0) + 1.0 / 15.0);
    let tail = y * (1.0 / 21.0) + 1.0 / 19.0;
    let sum = y * (head + fourth * (middle + fourth * tail));
    e * LN_2[0] + (z * 2.0 + (z * sum * 2.0 + e * LN_2[1]))
}

/// eˣ.
#[inline(always)]
pub fn exp<T: Real>(x: T) -> T {
    let rounded = x * std::f64::consts::LOG2_E + ROUND;
    let k = rounded - ROUND;
    let f = x - k * LN_2[0] - k * LN_2[1];
    let square = f * f;
    let fourth = square * square;
    // What is left out, f¹⁴/14!, is below 5e-18.
    let head = f * (1.0 / 6.0) + 0.5 + square * (f * (1.0 / 120.0) + 1.0 / 24.0);
    let middle = f * (1.0 / 5_040.0) + 1.0 / 720.0 + square * (f * (1.0 / 362_880.0) + 1.0 / 40_320.0);
    let tail =
        f * (1.0 / 39_916_800.0) + 1.0 / 3_628_800.0 + square * (f * (1.0 / 6_227_020_800.0) + 1.0 / 479_001_600.0);
    let rest = square * (head + fourth * (middle + fourth * tail));
    let [power] = T::each([rounded], |[k]| [f64::from_bits((k.to_bits() << 52).wrapping_add(1f64.to_bits()))]);
    let near = power + power * (f + rest);
    let far = (x * x).exceeds(x.constant(FAR * FAR));
    if !x.anywhere(far) {
        return near;
    }
    let [by_library] = T::each([x], |[x]| [x.exp()]);
    by_library.where_or(far, near)
}

/// x^n for x > 0.
#[inline(always)]
pub fn power<T: Real>(x: T, n: T) -> T {
    exp(n * ln(x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::number::{Instructions, LANES, Lanes, Work, dispatch};
    use approx::assert_relative_eq;

    /// Trust: the library's functions, right to a unit in the last digit; a power multiplies the error of its logarithm.
    #[test]
    fn they_are_the_functions() {
        let mut x = 1e-9;
        while x < 1e3 {
            assert_relative_eq!(ln(x), x.ln(), epsilon = 3e-16, max_relative = 4e-16);
            for n in [0.0, 0.01, 0.22, 0.504, 1.0] {
                assert_relative_eq!(power(x, n), x.powf(n), epsilon = 0.0, max_relative = 4e-15);
            }
            x *= 1.003;
        }
        for i in -8000..=8000 {
            let y = f64::from(i) / 10.0;
            assert_relative_eq!(exp(y), y.exp(), epsilon = 0.0, max_relative = 4e-16);
        }
        assert_eq!((ln(1.0), exp(0.0), exp(-1e5)), (0.0, 1.0, 0.0));
    }

    /// What four numbers are side by side.
    struct Beside([f64; LANES]);

    impl Work for Beside {
        type Output = [[f64; LANES]; 2];

        #[inline(always)]
        fn run<S: Instructions>(self, simd: S) -> [[f64; LANES]; 2] {
            let x = Lanes::new(simd, self.0);
            [power(x, x.constant(0.3)).values(), exp(-x).values()]
        }
    }

    /// Trust: to the bit.
    #[test]
    fn side_by_side_they_are_what_they_are_alone() {
        let x = [1e-5, 0.037, 0.8, 800.0];
        let [powers, exponentials] = dispatch(Beside(x));
        assert_eq!(powers, x.map(|x| power(x, 0.3)));
        assert_eq!(exponentials, x.map(|x| exp(-x)));
    }
}
