//! The thickness points of an element, which answer one after the other.

use crate::material::PointLaw;
use crate::material::flow::{Across, Iterate, Iterates, StressUpdate, Triple};
use crate::numerics::Grid;

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

/// What thickness points remember from one iteration to the next.
pub trait Memory<I> {
    /// What the `i`-th point of an element remembers.
    fn recall(&self, element: usize, i: usize) -> I;

    /// What it is to remember.
    fn keep(&mut self, element: usize, i: usize, iterate: I);
}

impl<I: Copy> Memory<I> for Grid<I> {
    #[inline(always)]
    fn recall(&self, element: usize, i: usize) -> I {
        self[(element, i)]
    }

    #[inline(always)]
    fn keep(&mut self, element: usize, i: usize, iterate: I) {
        self[(element, i)] = iterate;
    }
}

impl Memory<Iterate> for Iterates {
    #[inline(always)]
    fn recall(&self, element: usize, i: usize) -> Iterate {
        self.get(element, i)
    }

    #[inline(always)]
    fn keep(&mut self, element: usize, i: usize, iterate: Iterate) {
        self.put(element, i, &iterate);
    }
}

/// Points of one element.
pub struct Alone<'a, L: PointLaw, M> {
    /// Their law.
    pub law: &'a L,
    /// The points as the step finds them.
    pub before: &'a [L::PointState],
    /// What the points of all elements remember, which moves on, and which of them it is.
    pub memory: &'a mut M,
    /// Its number.
    pub element: usize,
    /// Their results.
    pub updates: &'a mut [StressUpdate],
}

impl<L: PointLaw, M: Memory<L::Iterate>> Column<f64> for Alone<'_, L, M> {
    #[inline(always)]
    fn respond(&mut self, i: usize, strain: Triple, spread: Option<[f64; 2]>) -> Answer<f64> {
        let (before, mut iterate) = (&self.before[i], self.memory.recall(self.element, i));
        // No closure: it would be compiled by itself.
        let across = match spread {
            Some(spread) => self.law.respond_across(before, &mut iterate, strain, spread),
            None => None,
        };
        let answer = match across {
            Some(across) => {
                self.updates[i] = across.update;
                Answer::Part(across)
            }
            None => {
                self.updates[i] = self.law.respond(before, &mut iterate, strain);
                Answer::Point(self.updates[i])
            }
        };
        self.memory.keep(self.element, i, iterate);
        answer
    }
}
