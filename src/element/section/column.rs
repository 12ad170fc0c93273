//! The thickness points of an element, which answer one after the other.

use crate::material::PointLaw;
use crate::material::flow::{Across, StressUpdate, Triple};

/// The thickness points of an element, or of several side by side: each is asked once.
pub trait Column<T> {
    /// What the `i`-th point answers to a strain increment and to its spread over the point's part of the thickness, where it
    /// stands for a part.
    fn respond(&mut self, i: usize, strain: Triple<T>, spread: Option<[T; 2]>) -> Answer<T>;
}

/// What a thickness point answers.
pub enum Answer<T> {
    /// By itself.
    Point(StressUpdate<T>),
    /// For the part of the thickness that it stands for.
    Part(Across<T>),
}

/// Points of one element.
pub struct Alone<'a, L: PointLaw> {
    /// Their law.
    pub law: &'a L,
    /// The points as the step finds them.
    pub before: &'a [L::PointState],
    /// What they remember, which moves on.
    pub iterates: &'a mut [L::Iterate],
    /// Their results.
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
