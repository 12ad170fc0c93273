//! The flow law of several thickness points side by side: the same place in the thickness of neighbouring elements.

use super::{Across, FlowLaw, Iterate, Past, PointLaw, PointState, StressUpdate, Surroundings, Triple};
use crate::material::Hill48;
use crate::material::yield_condition::Kept;
use crate::numerics::Real;
use crate::numerics::number::{Instructions, LANES, Lanes, beside, values};

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

/// Points of one element after those of the other: of so many lie side by side.
pub struct Rows<'a, S> {
    /// What calls the instructions.
    pub simd: S,
    /// Thickness points of an element.
    pub columns: usize,
    /// The points as the step finds them, what they remember, and their results.
    pub before: &'a [PointState],
    /// What they remember.
    pub iterates: &'a mut [Iterate],
    /// Their results.
    pub updates: &'a mut [StressUpdate],
}

impl<S: Instructions> Rows<'_, S> {
    /// The `i`-th point of each element.
    #[inline(always)]
    pub fn point(&self, i: usize) -> PointState<Lanes<S>> {
        let (n, s) = (self.columns, self.simd);
        let of = [&self.before[i], &self.before[n + i], &self.before[2 * n + i], &self.before[3 * n + i]];
        PointState {
            strain: beside!(s, of, strain),
            porosity: beside!(s, of, porosity),
            temperature: beside!(s, of, temperature),
            past: Past {
                weight: beside!(s, of, past.weight),
                strain: [
                    beside!(s, of, past.strain[0]),
                    beside!(s, of, past.strain[1]),
                    beside!(s, of, past.strain[2]),
                ],
                spread: [beside!(s, of, past.spread[0]), beside!(s, of, past.spread[1])],
                equivalent: beside!(s, of, past.equivalent),
            },
            surroundings: Surroundings {
                exponent: beside!(s, of, surroundings.exponent),
                increment: beside!(s, of, surroundings.increment),
                floor: beside!(s, of, surroundings.floor),
            },
        }
    }

    /// What the `i`-th point of each element remembers.
    #[inline(always)]
    pub fn iterate(&self, i: usize) -> Iterate<Lanes<S>> {
        let (n, s) = (self.columns, self.simd);
        let of = [&self.iterates[i], &self.iterates[n + i], &self.iterates[2 * n + i], &self.iterates[3 * n + i]];
        Iterate {
            carried: [beside!(s, of, carried[0]), beside!(s, of, carried[1]), beside!(s, of, carried[2])],
            carried_moment: [beside!(s, of, carried_moment[0]), beside!(s, of, carried_moment[1])],
            strain: [beside!(s, of, strain[0]), beside!(s, of, strain[1]), beside!(s, of, strain[2])],
            flow: [beside!(s, of, flow[0]), beside!(s, of, flow[1]), beside!(s, of, flow[2])],
            spread: [beside!(s, of, spread[0]), beside!(s, of, spread[1])],
            fluidity: beside!(s, of, fluidity),
            hardening: beside!(s, of, hardening),
            inverse_square: beside!(s, of, inverse_square),
            kept: Kept::default(),
        }
    }

    /// Takes what the `i`-th point of each element remembers, and its result without the matrix.
    #[inline(always)]
    pub fn take(&mut self, i: usize, iterate: &Iterate<Lanes<S>>, update: &StressUpdate<Lanes<S>>) {
        let (carried, moment) = (values(iterate.carried), values(iterate.carried_moment));
        let (strain, flow, spread) = (values(iterate.strain), values(iterate.flow), values(iterate.spread));
        let [fluidity, hardening, inverse_square] =
            values([iterate.fluidity, iterate.hardening, iterate.inverse_square]);
        let stress = values(update.stress);
        let [increment, yield_stress, work_across] =
            values([update.increment, update.yield_stress, update.work_across]);
        for k in 0..LANES {
            let at = k * self.columns + i;
            let own = &mut self.iterates[at];
            own.carried = [carried[0][k], carried[1][k], carried[2][k]];
            own.carried_moment = [moment[0][k], moment[1][k]];
            own.strain = [strain[0][k], strain[1][k], strain[2][k]];
            own.flow = [flow[0][k], flow[1][k], flow[2][k]];
            own.spread = [spread[0][k], spread[1][k]];
            (own.fluidity, own.hardening, own.inverse_square) = (fluidity[k], hardening[k], inverse_square[k]);
            let update = &mut self.updates[at];
            update.stress = [stress[0][k], stress[1][k], stress[2][k]];
            (update.increment, update.yield_stress) = (increment[k], yield_stress[k]);
            update.work_across = work_across[k];
        }
    }
}
