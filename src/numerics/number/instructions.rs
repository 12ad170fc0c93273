//! Vector instructions of processors and of WebAssembly.

use super::{LANES, Work};
use pulp::{NullaryFnOnce, Scalar256b, Simd, cast, f64x4};

/// Vector instructions of four lanes.
pub trait Instructions: Copy {
    /// Four numbers as they hold them.
    type Four: Copy;
    /// The answers to four comparisons.
    type Mask: Copy;

    /// Takes four numbers.
    fn four(self, values: [f64; LANES]) -> Self::Four;

    /// Gives them back.
    fn numbers(self, values: Self::Four) -> [f64; LANES];

    /// Sum.
    fn add(self, a: Self::Four, b: Self::Four) -> Self::Four;

    /// Difference.
    fn sub(self, a: Self::Four, b: Self::Four) -> Self::Four;

    /// Product.
    fn mul(self, a: Self::Four, b: Self::Four) -> Self::Four;

    /// Quotient.
    fn div(self, a: Self::Four, b: Self::Four) -> Self::Four;

    /// The other sign.
    fn neg(self, a: Self::Four) -> Self::Four;

    /// Square root.
    fn sqrt(self, a: Self::Four) -> Self::Four;

    /// Whether the first is the larger one.
    fn exceeds(self, a: Self::Four, b: Self::Four) -> Self::Mask;

    /// The first where the answer is yes, the second elsewhere.
    fn where_or(self, mask: Self::Mask, a: Self::Four, b: Self::Four) -> Self::Four;

    /// Whether the answer is yes anywhere.
    fn anywhere(self, mask: Self::Mask) -> bool;

    /// Whether the answer is yes everywhere.
    fn everywhere(self, mask: Self::Mask) -> bool;
}

impl<S: Simd<f64s = f64x4>> Instructions for S {
    type Four = f64x4;
    type Mask = S::m64s;

    #[inline(always)]
    fn four(self, values: [f64; LANES]) -> f64x4 {
        cast(values)
    }

    #[inline(always)]
    fn numbers(self, values: f64x4) -> [f64; LANES] {
        cast(values)
    }

    #[inline(always)]
    fn add(self, a: f64x4, b: f64x4) -> f64x4 {
        self.add_f64s(a, b)
    }

    #[inline(always)]
    fn sub(self, a: f64x4, b: f64x4) -> f64x4 {
        self.sub_f64s(a, b)
    }

    #[inline(always)]
    fn mul(self, a: f64x4, b: f64x4) -> f64x4 {
        self.mul_f64s(a, b)
    }

    #[inline(always)]
    fn div(self, a: f64x4, b: f64x4) -> f64x4 {
        self.div_f64s(a, b)
    }

    #[inline(always)]
    fn neg(self, a: f64x4) -> f64x4 {
        self.neg_f64s(a)
    }

    #[inline(always)]
    fn sqrt(self, a: f64x4) -> f64x4 {
        self.sqrt_f64s(a)
    }

    #[inline(always)]
    fn exceeds(self, a: f64x4, b: f64x4) -> S::m64s {
        self.greater_than_f64s(a, b)
    }

    #[inline(always)]
    fn where_or(self, mask: S::m64s, a: f64x4, b: f64x4) -> f64x4 {
        self.select_f64s(mask, a, b)
    }

    #[inline(always)]
    fn anywhere(self, mask: S::m64s) -> bool {
        self.first_true_m64s(mask) < LANES
    }

    #[inline(always)]
    fn everywhere(self, mask: S::m64s) -> bool {
        self.first_true_m64s(self.not_m64s(mask)) == LANES
    }
}

/// Work, and the instructions for it.
struct Call<W, S> {
    work: W,
    simd: S,
}

impl<W: Work, S: Instructions> NullaryFnOnce for Call<W, S> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.work.run(self.simd)
    }
}

/// Does work with the vector instructions that there are.
#[inline]
pub fn dispatch<W: Work>(work: W) -> W::Output {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return simd.vectorize(Call { work, simd });
    }
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    return work.run(web_assembly::Pairs);
    #[allow(unreachable_code)]
    Scalar256b.vectorize(Call { work, simd: Scalar256b })
}

/// WebAssembly has vectors of two numbers, and a module says whether it uses them.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod web_assembly {
    use super::{Instructions, LANES};
    use std::arch::wasm32::{
        f64x2, f64x2_add, f64x2_div, f64x2_extract_lane, f64x2_gt, f64x2_mul, f64x2_neg, f64x2_sqrt, f64x2_sub,
        i64x2_all_true, v128, v128_any_true, v128_bitselect, v128_or,
    };

    /// Two vectors of two.
    #[derive(Clone, Copy)]
    pub struct Pairs;

    type Four = [v128; 2];

    /// Each operation for both vectors.
    macro_rules! of_both {
        ($($function:ident $instruction:ident $($operand:ident)+),*) => {$(
            #[inline(always)]
            fn $function(self, $($operand: Four),+) -> Four {
                [$instruction($($operand[0]),+), $instruction($($operand[1]),+)]
            }
        )*};
    }

    impl Instructions for Pairs {
        type Four = Four;
        type Mask = Four;

        #[inline(always)]
        fn four(self, [a, b, c, d]: [f64; LANES]) -> Four {
            [f64x2(a, b), f64x2(c, d)]
        }

        #[inline(always)]
        fn numbers(self, [first, second]: Four) -> [f64; LANES] {
            let [a, b] = [f64x2_extract_lane::<0>(first), f64x2_extract_lane::<1>(first)];
            [a, b, f64x2_extract_lane::<0>(second), f64x2_extract_lane::<1>(second)]
        }

        of_both!(
            add f64x2_add a b,
            sub f64x2_sub a b,
            mul f64x2_mul a b,
            div f64x2_div a b,
            neg f64x2_neg a,
            sqrt f64x2_sqrt a,
            exceeds f64x2_gt a b
        );

        #[inline(always)]
        fn where_or(self, mask: Four, a: Four, b: Four) -> Four {
            [v128_bitselect(a[0], b[0], mask[0]), v128_bitselect(a[1], b[1], mask[1])]
        }

        #[inline(always)]
        fn anywhere(self, [first, second]: Four) -> bool {
            v128_any_true(v128_or(first, second))
        }

        #[inline(always)]
        fn everywhere(self, [first, second]: Four) -> bool {
            i64x2_all_true(first) && i64x2_all_true(second)
        }
    }
}
