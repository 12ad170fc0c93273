//! The neighbourhood of an element along the meridian: the length over which a sheet has one section.
//!
//! A sheet bent under tension thins, and the moment that it bears falls with the square of its thickness: where hardening does
//! not make up for it, H < 4τσ/(1 + τ²)² with the tension τ over the yield force, bending goes on where it began. A shell has no
//! length that would keep that from happening in one element, and neighbours thin in turn. In a sheet a section can not be
//! weaker than what stands within about a thickness of it, for the stress would have to spread and gather again over less
//! than it takes to cross the sheet: an element's section has the mean thickness of its neighbourhood. Elements longer than
//! that are by themselves.

use super::State;
use crate::model::Model;

/// Length of a neighbourhood along the meridian over the initial thickness \[–\]: declared. From 1 to 2 the thinnest place
/// of deep cups is the same within 0.1 %; below 1 neighbours of half a thickness still thin in turn.
pub const NEIGHBOURHOOD: f64 = 1.5;

/// The neighbourhood of every element of a sheet at one instant.
#[derive(Clone, Debug)]
pub struct Neighbourhood {
    /// Of the elements along the meridian \[mm\].
    lengths: Vec<f64>,
    /// How far it reaches from the middle of an element \[mm\].
    reach: f64,
}

impl Neighbourhood {
    /// Of the elements of `state`.
    pub fn new(model: &Model, state: &State) -> Self {
        let length = |w: &[crate::element::Node]| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]);
        let reach = 0.5 * NEIGHBOURHOOD * model.blank.thickness;
        Self { lengths: state.nodes.windows(2).map(length).collect(), reach }
    }

    /// Share of its neighbourhood that element `e` takes itself \[–\].
    pub fn own_share(&self, e: usize) -> f64 {
        (0.5 * self.lengths[e] / self.reach).min(1.0)
    }

    /// Mean over the neighbourhood of element `e` of what each element has.
    pub fn mean(&self, e: usize, of: impl Fn(usize) -> f64) -> f64 {
        if self.own_share(e) >= 1.0 {
            return of(e);
        }
        let mut sum = 0.0;
        let length = self.each(e, |k, part| sum += part * of(k));
        sum / length
    }

    /// Visits the elements in the neighbourhood of element `e` with the length of each that lies in it, which sum to the
    /// length that is returned \[mm\]. Beyond the axis the sheet goes on as its mirror image; beyond the edge there is none.
    pub fn each(&self, e: usize, mut visit: impl FnMut(usize, f64)) -> f64 {
        let n = self.lengths.len();
        let mut length = self.lengths[e];
        visit(e, length);
        let mut beside = |elements: &mut dyn Iterator<Item = usize>| {
            let mut left = self.reach - 0.5 * self.lengths[e];
            while left > 0.0
                && let Some(k) = elements.next()
            {
                let part = self.lengths[k].min(left);
                visit(k, part);
                length += part;
                left -= part;
            }
        };
        beside(&mut (0..e).rev().chain(0..n));
        beside(&mut (e + 1..n));
        length
    }

    /// Thickness of the section at every element: the mean over its neighbourhood \[mm\].
    pub fn section_thickness(&self, thickness: &[f64]) -> Vec<f64> {
        (0..thickness.len()).map(|e| self.mean(e, |k| thickness[k])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Of elements of these lengths.
    fn of(lengths: &[f64], reach: f64) -> Neighbourhood {
        Neighbourhood { lengths: lengths.to_vec(), reach }
    }

    #[test]
    fn an_element_as_long_as_its_neighbourhood_is_by_itself() {
        let thickness = [1.0, 0.7, 1.2];
        assert_eq!(of(&[2.0; 3], 1.0).section_thickness(&thickness), thickness);
        assert_eq!(of(&[2.0; 3], 1.0).own_share(1), 1.0);
    }

    /// Trust: 1.5 mm on either side of the middle of an element of 1 mm are itself and its two neighbours; half of the
    /// second one's neighbour on the axis is its own mirror image.
    #[test]
    fn the_mean_is_that_of_the_length_within_reach() {
        let values = [4.0, 1.0, 7.0, 2.0];
        let near = of(&[1.0; 4], 1.5);
        assert_relative_eq!(near.mean(1, |k| values[k]), (4.0 + 1.0 + 7.0) / 3.0, max_relative = 1e-15);
        assert_relative_eq!(near.mean(0, |k| values[k]), (4.0 + 4.0 + 1.0) / 3.0, max_relative = 1e-15);
        assert_relative_eq!(near.mean(3, |k| values[k]), (2.0 + 7.0) / 2.0, max_relative = 1e-15);
        let unequal = of(&[2.0, 1.0, 2.0, 1.0], 1.0);
        assert_relative_eq!(unequal.mean(1, |k| values[k]), 0.25 * 4.0 + 0.5 + 0.25 * 7.0, max_relative = 1e-15);
        assert_relative_eq!(unequal.own_share(1), 0.5);
    }

    /// Trust: neighbours by turns 1 % thicker and thinner than 1 mm; over three and a half of them 1/3.5 of it is left.
    #[test]
    fn what_alternates_from_element_to_element_is_averaged_out() {
        let thickness: Vec<f64> = (0..40).map(|e| if e % 2 == 0 { 1.01 } else { 0.99 }).collect();
        let section = of(&[0.4; 40], 0.7).section_thickness(&thickness);
        for t in &section[5..35] {
            assert!((t - 1.0).abs() < 0.01 / 3.4, "{t}");
        }
    }
}
