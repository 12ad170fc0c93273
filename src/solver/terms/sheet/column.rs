//! The thickness points of an element, or of several side by side, by the law of their metal.

use crate::element::section::{Answer, Column};
use crate::material::PointLaw;
use crate::material::flow::{Quadratic, Rows, StressUpdate, Triple};
use crate::numerics::number::{Instructions, Lanes};

/// Points of one element: as the step finds them, what they remember, and their results.
pub struct Alone<'a, L: PointLaw> {
    pub law: &'a L,
    pub before: &'a [L::PointState],
    pub iterates: &'a mut [L::Iterate],
    pub updates: &'a mut [StressUpdate],
}

impl<L: PointLaw> Column<f64> for Alone<'_, L> {
    #[inline(always)]
    fn respond(&mut self, i: usize, strain: Triple, spread: Option<[f64; 2]>) -> Answer<f64> {
        let (before, iterate) = (&self.before[i], &mut self.iterates[i]);
        // No closure: it would be compiled by itself.
        let across = match spread {
            Some(spread) => self.law.respond_across(before, iterate, strain, spread),
            None => None,
        };
        if let Some(across) = across {
            self.updates[i] = across.update;
            return Answer::Part(across);
        }
        self.updates[i] = self.law.respond(before, iterate, strain);
        Answer::Point(self.updates[i])
    }
}

/// Points of several elements.
pub struct Together<'a, S> {
    pub law: &'a Quadratic<'a>,
    pub rows: Rows<'a, S>,
}

impl<S: Instructions> Column<Lanes<S>> for Together<'_, S> {
    #[inline(always)]
    fn respond(&mut self, i: usize, strain: Triple<Lanes<S>>, spread: Option<[Lanes<S>; 2]>) -> Answer<Lanes<S>> {
        let (point, mut iterate) = (self.rows.point(i), self.rows.iterate(i));
        let Some(spread) = spread else {
            let update = self.law.respond(&point, &mut iterate, strain);
            self.rows.take(i, &iterate, &update);
            return Answer::Point(update);
        };
        let across = self.law.across(&point, &mut iterate, strain, spread);
        self.rows.take(i, &iterate, &across.update);
        Answer::Part(across)
    }
}
