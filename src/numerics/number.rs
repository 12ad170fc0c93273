//! Numbers that a formula is worked out with: one, or four side by side by the vector instructions that the processor has.
//!
//! Each lane is worked out as one number by itself is, so that a result does not depend on the processor, nor on what stands
//! beside it.

mod instructions;

pub use instructions::{Instructions, dispatch};

use std::ops::{Add, Div, Mul, Neg, Sub};

/// How many numbers stand side by side.
pub const LANES: usize = 4;

/// One number, or several side by side.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// The answer to a comparison.
    type Mask: Copy;

    /// The same number everywhere.
    #[must_use]
    fn constant(self, value: f64) -> Self;

    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Whether it is the larger one.
    fn exceeds(self, other: Self) -> Self::Mask;

    /// This where the answer is yes, the other one elsewhere.
    #[must_use]
    fn where_or(self, mask: Self::Mask, otherwise: Self) -> Self;

    /// Whether the answer is yes anywhere.
    fn anywhere(self, mask: Self::Mask) -> bool;

    /// Whether the answer is yes everywhere.
    fn everywhere(self, mask: Self::Mask) -> bool;

    /// Functions of some numbers, one lane after the other.
    #[must_use]
    fn each<const M: usize, const N: usize>(of: [Self; M], functions: impl Fn([f64; M]) -> [f64; N]) -> [Self; N];
}

impl Real for f64 {
    type Mask = bool;

    #[inline(always)]
    fn constant(self, value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn exceeds(self, other: f64) -> bool {
        self > other
    }

    #[inline(always)]
    fn where_or(self, mask: bool, otherwise: f64) -> f64 {
        if mask { self } else { otherwise }
    }

    #[inline(always)]
    fn anywhere(self, mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn everywhere(self, mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn each<const M: usize, const N: usize>(of: [f64; M], functions: impl Fn([f64; M]) -> [f64; N]) -> [f64; N] {
        functions(of)
    }
}

/// Four numbers side by side.
#[derive(Clone, Copy)]
pub struct Lanes<S: Instructions> {
    simd: S,
    values: S::Four,
}

impl<S: Instructions> Lanes<S> {
    /// Of four numbers.
    #[inline(always)]
    pub fn new(simd: S, values: [f64; LANES]) -> Self {
        Self { simd, values: simd.four(values) }
    }

    /// The four numbers.
    #[inline(always)]
    pub fn values(self) -> [f64; LANES] {
        self.simd.numbers(self.values)
    }

    #[inline(always)]
    fn of(self, values: S::Four) -> Self {
        Self { values, ..self }
    }
}

/// Operators of two lanes, and of lanes and one number.
macro_rules! operators {
    ($($operator:ident $function:ident),*) => {$(
        impl<S: Instructions> $operator for Lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                self.of(self.simd.$function(self.values, other.values))
            }
        }

        impl<S: Instructions> $operator<f64> for Lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: f64) -> Self {
                $operator::$function(self, self.constant(other))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<S: Instructions> Neg for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.of(self.simd.neg(self.values))
    }
}

impl<S: Instructions> Real for Lanes<S> {
    type Mask = S::Mask;

    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        self.of(self.simd.four([value; LANES]))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.of(self.simd.sqrt(self.values))
    }

    #[inline(always)]
    fn exceeds(self, other: Self) -> S::Mask {
        self.simd.exceeds(self.values, other.values)
    }

    #[inline(always)]
    fn where_or(self, mask: S::Mask, otherwise: Self) -> Self {
        self.of(self.simd.where_or(mask, self.values, otherwise.values))
    }

    #[inline(always)]
    fn anywhere(self, mask: S::Mask) -> bool {
        self.simd.anywhere(mask)
    }

    #[inline(always)]
    fn everywhere(self, mask: S::Mask) -> bool {
        self.simd.everywhere(mask)
    }

    #[inline(always)]
    fn each<const M: usize, const N: usize>(of: [Self; M], functions: impl Fn([f64; M]) -> [f64; N]) -> [Self; N] {
        let (simd, lanes) = (of[0].simd, values(of));
        let mut results = [[0.0; LANES]; N];
        for k in 0..LANES {
            let mut at = [0.0; M];
            for i in 0..M {
                at[i] = lanes[i][k];
            }
            let at = functions(at);
            for i in 0..N {
                results[i][k] = at[i];
            }
        }
        let mut all = [of[0]; N];
        for i in 0..N {
            all[i] = Self::new(simd, results[i]);
        }
        all
    }
}

/// Multiplied by the same number. (What `map` is given is compiled by itself, without vector instructions.)
#[inline(always)]
pub fn scaled<T: Real, const N: usize>(by: T, mut values: [T; N]) -> [T; N] {
    for value in &mut values {
        *value = by * *value;
    }
    values
}

/// Adds to each.
#[inline(always)]
pub fn add<T: Real, const N: usize>(to: &mut [T; N], what: [T; N]) {
    for i in 0..N {
        to[i] = to[i] + what[i];
    }
}

/// The numbers of every entry.
#[inline(always)]
pub fn values<S: Instructions, const N: usize>(of: [Lanes<S>; N]) -> [[f64; LANES]; N] {
    let mut values = [[0.0; LANES]; N];
    for i in 0..N {
        values[i] = of[i].values();
    }
    values
}

/// One entry of four values, side by side.
macro_rules! beside {
    ($simd:expr, $of:expr, [$i:literal]) => {
        $crate::numerics::number::Lanes::new($simd, [$of[0][$i], $of[1][$i], $of[2][$i], $of[3][$i]])
    };
    ($simd:expr, $of:expr, $($entry:tt)+) => {
        $crate::numerics::number::Lanes::new(
            $simd,
            [$of[0].$($entry)+, $of[1].$($entry)+, $of[2].$($entry)+, $of[3].$($entry)+],
        )
    };
}
pub(crate) use beside;

/// Work for vector instructions, whichever the processor has.
pub trait Work {
    /// What comes of it.
    type Output;

    /// Does it; to be inlined always.
    fn run<S: Instructions>(self, simd: S) -> Self::Output;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A formula with all that a number can do.
    fn formula<T: Real>(x: T, y: T) -> T {
        let larger = x.where_or(x.exceeds(y), y);
        let [joined, apart] = T::each([x, y], |[x, y]| [x.hypot(y), x - y]);
        let [scaled] = scaled(larger, [(x * y + joined / larger).sqrt() - apart * 0.3]);
        let mut sum = [scaled];
        add(&mut sum, [-x]);
        if x.anywhere(x.exceeds(x.constant(2.0))) { sum[0] + 1.0 } else { sum[0] + 1.0 - y.constant(0.0) }
    }

    struct Beside([f64; LANES], [f64; LANES]);

    impl Work for Beside {
        type Output = [f64; LANES];

        #[inline(always)]
        fn run<S: Instructions>(self, simd: S) -> [f64; LANES] {
            formula(Lanes::new(simd, self.0), Lanes::new(simd, self.1)).values()
        }
    }

    /// Trust: to the bit.
    #[test]
    fn a_result_depends_on_neither_the_processor_nor_what_stands_beside_it() {
        let (x, y) = ([0.1, 1.7, 3.3, 1e-9], [0.7, 0.2, 1e5, 0.3]);
        let alone = [0, 1, 2, 3].map(|k| formula(x[k], y[k]));
        assert_eq!(dispatch(Beside(x, y)), alone);
        assert_eq!(Beside(x, y).run(pulp::Scalar256b), alone);
    }
}
