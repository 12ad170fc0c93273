//! Thickness points of a sheet and what they remember, those of neighbouring elements side by side.

use super::{Iterate, Past, PointState, Surroundings};
use crate::material::yield_condition::Kept;
use crate::numerics::number::{Instructions, Lanes};
use crate::numerics::{Abreast, Grid, Real};

/// Numbers of a point as a step finds it.
const STATE: usize = 12;
/// Numbers that a point remembers.
const MEMORY: usize = 16;

/// Thickness points as a step finds them: elements by points.
#[derive(Clone, Debug)]
pub struct PointStates(Abreast<STATE>);

impl PointStates {
    /// Of these points.
    pub fn of(points: &Grid<PointState>) -> Self {
        let mut records = Abreast::new(points.rows().len(), points.columns());
        for (e, row) in points.rows().enumerate() {
            for (i, point) in row.iter().enumerate() {
                records.put(e, i, &point.entries());
            }
        }
        Self(records)
    }

    /// The `i`-th points of as many elements as there are lanes, from `element` on, a multiple of their number.
    #[inline(always)]
    pub fn lanes<S: Instructions>(&self, simd: S, element: usize, i: usize) -> PointState<Lanes<S>> {
        PointState::of(self.0.lanes(simd, element, i))
    }
}

impl<T: Copy> PointState<T> {
    /// All that the law of a sheet without voids asks for.
    #[inline(always)]
    fn entries(&self) -> [T; STATE] {
        let Self { strain, temperature, past, surroundings, .. } = *self;
        let Past { weight, strain: [s, t, shear], spread: [by_s, by_t], equivalent } = past;
        let Surroundings { exponent, increment, floor } = surroundings;
        [strain, temperature, weight, s, t, shear, by_s, by_t, equivalent, exponent, increment, floor]
    }
}

impl<S: Instructions> PointState<Lanes<S>> {
    #[inline(always)]
    fn of(entries: [Lanes<S>; STATE]) -> Self {
        let [strain, temperature, weight, s, t, shear, by_s, by_t, equivalent, exponent, increment, floor] = entries;
        let past = Past { weight, strain: [s, t, shear], spread: [by_s, by_t], equivalent };
        let surroundings = Surroundings { exponent, increment, floor };
        Self { strain, porosity: strain.constant(0.0), temperature, past, surroundings }
    }
}

/// What thickness points remember from one iteration to the next: elements by points.
#[derive(Clone, Debug)]
pub struct Iterates {
    numbers: Abreast<MEMORY>,
    kept: Grid<Kept>,
}

impl Iterates {
    /// Of points that remember nothing yet.
    pub fn new(elements: usize, points: usize) -> Self {
        Self { numbers: Abreast::new(elements, points), kept: Grid::new(elements, points, Kept::default()) }
    }

    /// What the `i`-th point of an element remembers.
    #[inline(always)]
    pub fn get(&self, element: usize, i: usize) -> Iterate {
        Iterate::of(self.numbers.get(element, i), self.kept[(element, i)])
    }

    /// What it is to remember.
    #[inline(always)]
    pub fn put(&mut self, element: usize, i: usize, iterate: &Iterate) {
        self.numbers.put(element, i, &iterate.entries());
        self.kept[(element, i)] = iterate.kept;
    }

    /// What the `i`-th points of as many elements as there are lanes remember, from `element` on, a multiple of their number.
    #[inline(always)]
    pub fn lanes<S: Instructions>(&self, simd: S, element: usize, i: usize) -> Iterate<Lanes<S>> {
        Iterate::of(self.numbers.lanes(simd, element, i), Kept::default())
    }

    /// What they are to remember; nothing is kept of matrices, as of the law that is worked out side by side.
    #[inline(always)]
    pub fn put_lanes<S: Instructions>(&mut self, element: usize, i: usize, iterate: &Iterate<Lanes<S>>) {
        self.numbers.put_lanes(element, i, &iterate.entries());
    }
}

impl<T: Copy> Iterate<T> {
    /// All its numbers, but for what it keeps of a matrix.
    #[inline(always)]
    fn entries(&self) -> [T; MEMORY] {
        let Self {
            carried: w, carried_moment: m, strain: e, flow, spread: k, fluidity, hardening, inverse_square, ..
        } = *self;
        [
            w[0],
            w[1],
            w[2],
            m[0],
            m[1],
            e[0],
            e[1],
            e[2],
            flow[0],
            flow[1],
            flow[2],
            k[0],
            k[1],
            fluidity,
            hardening,
            inverse_square,
        ]
    }

    #[inline(always)]
    fn of(entries: [T; MEMORY], kept: Kept) -> Self {
        let [w0, w1, w2, m0, m1, e0, e1, e2, f0, f1, f2, k0, k1, fluidity, hardening, inverse_square] = entries;
        Self {
            carried: [w0, w1, w2],
            carried_moment: [m0, m1],
            strain: [e0, e1, e2],
            flow: [f0, f1, f2],
            spread: [k0, k1],
            fluidity,
            hardening,
            inverse_square,
            kept,
        }
    }
}
