//! The neighbourhood of an element along the meridian: the length over which a sheet has one section.
//!
//! A sheet bent under tension thins, and the moment that it bears falls with the square of its thickness: where hardening does
//! not make up for it, H < 4τσ/(1 + τ²)² with the tension τ over the yield force, bending goes on where it began. A shell has no
//! length that would keep that from happening in one element, and neighbours thin in turn. In a sheet a section can not be
//! weaker than what stands within about a thickness of it, for the stress would have to spread and gather again over less
//! than it takes to cross the sheet: an element's section has the mean thickness of its neighbourhood. Elements longer than
//! that are by themselves.

use super::State;
use crate::geometry::Point;
use crate::model::Model;

/// Length of a neighbourhood along the meridian over the initial thickness \[–\]: declared. From 1 to 2 the thinnest place
/// of deep cups is the same within 0.1 %; below 1 neighbours of half a thickness still thin in turn.
pub const NEIGHBOURHOOD: f64 = 1.5;

/// The neighbourhood of every element of a sheet at one instant.
#[derive(Clone, Debug)]
pub struct Neighbourhood {
    /// Where each element begins and the last one ends along the meridian, from the axis \[mm\].
    ends: Vec<f64>,
    /// How far it reaches from the middle of an element \[mm\].
    reach: f64,
    /// From where to where it reaches; empty for an element that is by itself.
    spans: Vec<[Place; 2]>,
}

/// A place on the sheet, or on its mirror image beyond the axis.
#[derive(Clone, Copy, Debug, Default)]
struct Place {
    /// The element that it lies on, and how far from where that begins \[mm\].
    element: usize,
    beyond: f64,
    /// Distance from the axis along the meridian \[mm\], below 0 on the mirror image.
    at: f64,
}

impl Neighbourhood {
    /// Of the elements of `state`.
    pub fn new(model: &Model, state: &State) -> Self {
        let lengths = state.nodes.windows(2).map(|w| Point::new(w[1][0] - w[0][0], w[1][1] - w[0][1]).norm());
        Self::of(lengths, 0.5 * NEIGHBOURHOOD * model.blank.thickness)
    }

    fn of(lengths: impl Iterator<Item = f64>, reach: f64) -> Self {
        let ends = summed(lengths);
        let last = ends.len() - 2;
        let whole = ends[last + 1];
        // From one element to the next a place moves by no more than a few of them.
        let find = |at: f64, element: &mut usize| {
            let distance = at.abs();
            while *element < last && ends[*element + 1] <= distance {
                *element += 1;
            }
            while ends[*element] > distance {
                *element -= 1;
            }
            Place { element: *element, beyond: distance - ends[*element], at }
        };
        let (mut low, mut high) = (0, 0);
        let span = |pair: &[f64]| {
            let middle = 0.5 * (pair[0] + pair[1]);
            if pair[1] - middle >= reach {
                return [Place::default(); 2];
            }
            let from = (middle - reach).max(-whole);
            [find(from, &mut low), find(whole.min(middle + reach), &mut high)]
        };
        Self { spans: ends.windows(2).map(span).collect(), ends, reach }
    }

    /// Share of its neighbourhood that element `e` takes itself \[–\].
    pub fn own_share(&self, e: usize) -> f64 {
        (0.5 * (self.ends[e + 1] - self.ends[e]) / self.reach).min(1.0)
    }

    /// Mean over the neighbourhood of each element of what the elements have. Beyond the axis the sheet goes on as its mirror
    /// image; beyond the edge there is none.
    ///
    /// Of sums from the axis on, so that it costs the same however many elements a neighbourhood has.
    pub fn means(&self, of: impl Fn(usize) -> f64) -> Vec<f64> {
        let sums = summed(self.ends.windows(2).enumerate().map(|(e, pair)| (pair[1] - pair[0]) * of(e)));
        // From the axis on; to the mirror image it is the other way.
        let up_to = |place: &Place| {
            let sum = sums[place.element] + place.beyond * of(place.element);
            if place.at < 0.0 { -sum } else { sum }
        };
        let mean = |(e, [from, to]): (usize, &[Place; 2])| {
            let length = to.at - from.at;
            if length > 0.0 { (up_to(to) - up_to(from)) / length } else { of(e) }
        };
        self.spans.iter().enumerate().map(mean).collect()
    }

    /// Thickness of the section at every element: the mean over its neighbourhood \[mm\].
    pub fn section_thickness(&self, thickness: &[f64]) -> Vec<f64> {
        self.means(|e| thickness[e])
    }
}

/// Sums of the values up to each of them, the first of none.
fn summed(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sum = 0.0;
    let sums = values.map(|value| {
        sum += value;
        sum
    });
    std::iter::once(0.0).chain(sums).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Of elements of these lengths.
    fn of(lengths: &[f64], reach: f64) -> Neighbourhood {
        Neighbourhood::of(lengths.iter().copied(), reach)
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
        assert_relative_eq!(near.means(|k| values[k])[1], (4.0 + 1.0 + 7.0) / 3.0, max_relative = 1e-14);
        assert_relative_eq!(near.means(|k| values[k])[0], (4.0 + 4.0 + 1.0) / 3.0, max_relative = 1e-14);
        assert_relative_eq!(near.means(|k| values[k])[3], (2.0 + 7.0) / 2.0, max_relative = 1e-14);
        let unequal = of(&[2.0, 1.0, 2.0, 1.0], 1.0);
        assert_relative_eq!(unequal.means(|k| values[k])[1], 0.25 * 4.0 + 0.5 + 0.25 * 7.0, max_relative = 1e-14);
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
