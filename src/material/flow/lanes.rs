//! The flow law of several thickness points side by side: the same place in the thickness of neighbouring elements.

use super::{Across, FlowLaw, Iterate, Iterates, PointLaw, PointState, PointStates, StressUpdate, Triple};
use crate::material::Hill48;
use crate::numerics::Real;
use crate::numerics::number::{Instructions, LANES, Lanes, values};

/// The flow law of a sheet without voids by Hill's condition.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic<'a> {
    /// The law, but for its yield condition.
    pub law: FlowLaw<'a>,
    /// The yield condition.
    pub hill: Hill48,
}

impl<T: Real> PointLaw<T> for Quadratic<'_> {
    type PointState = PointState<T>;
    type Iterate = Iterate<T>;

    #[inline(always)]
    fn respond(&self, point: &PointState<T>, iterate: &mut Iterate<T>, e: Triple<T>) -> StressUpdate<T> {
        iterate.flow(&self.law, &self.hill, point, e)
    }

    #[inline(always)]
    fn respond_across(
        &self,
        point: &PointState<T>,
        iterate: &mut Iterate<T>,
        e: Triple<T>,
        spread: [T; 2],
    ) -> Option<Across<T>> {
        Some(self.across(point, iterate, e, spread))
    }
}

impl Quadratic<'_> {
    /// As [`PointLaw::respond_across`], which always has an answer here.
    #[inline(always)]
    pub fn across<T: Real>(
        &self,
        point: &PointState<T>,
        iterate: &mut Iterate<T>,
        e: Triple<T>,
        spread: [T; 2],
    ) -> Across<T> {
        iterate.flow_across(&self.law, &self.hill, point, e, spread)
    }
}

/// Points of as many elements as there are lanes.
pub struct Rows<'a, S> {
    /// What calls the instructions.
    pub simd: S,
    /// The first element, by a multiple of the number of lanes.
    pub first: usize,
    /// Thickness points of an element.
    pub columns: usize,
    /// The points as the step finds them.
    pub before: &'a PointStates,
    /// What they remember.
    pub iterates: &'a mut Iterates,
    /// Their results, element after element.
    pub updates: &'a mut [StressUpdate],
}

impl<S: Instructions> Rows<'_, S> {
    /// The `i`-th point of each element.
    #[inline(always)]
    pub fn point(&self, i: usize) -> PointState<Lanes<S>> {
        self.before.lanes(self.simd, self.first, i)
    }

    /// What the `i`-th point of each element remembers.
    #[inline(always)]
    pub fn iterate(&self, i: usize) -> Iterate<Lanes<S>> {
        self.iterates.lanes(self.simd, self.first, i)
    }

    /// Takes what the `i`-th point of each element remembers, and its result without the matrix.
    #[inline(always)]
    pub fn take(&mut self, i: usize, iterate: &Iterate<Lanes<S>>, update: &StressUpdate<Lanes<S>>) {
        self.iterates.put_lanes(self.first, i, iterate);
        let stress = values(update.stress);
        let [increment, yield_stress, work_across] =
            values([update.increment, update.yield_stress, update.work_across]);
        for k in 0..LANES {
            let own = &mut self.updates[k * self.columns + i];
            own.stress = [stress[0][k], stress[1][k], stress[2][k]];
            (own.increment, own.yield_stress) = (increment[k], yield_stress[k]);
            own.work_across = work_across[k];
        }
    }
}
