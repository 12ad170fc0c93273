//! How far a run is from a measured curve.

use super::{Curve, Member, Of, Versus};
use crate::units::Amount;

/// How far the runs are from a measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Misfit {
    /// The curve's number, from 1.
    pub number: usize,
    /// The curve's name.
    pub curve: String,
    /// What it is of.
    pub of: Of,
    /// Of every run: the root of the mean square of computed less measured, in the curve's unit, at the measured places that
    /// the run has, and how many of them that are; `None` where there are none.
    pub of_members: Vec<Option<(Amount, usize)>>,
    /// Points of the curve.
    pub points: usize,
}

impl Versus {
    /// Every measured curve, counted from 0.
    pub fn curves(&self) -> impl Iterator<Item = (usize, &Curve)> {
        self.measured.iter().flat_map(|measured| &measured.curves).enumerate()
    }

    /// Of every measured curve.
    pub fn misfits(&self) -> Vec<Misfit> {
        let misfit = |(i, curve): (usize, &Curve)| Misfit {
            number: i + 1,
            curve: curve.name.clone(),
            of: curve.of,
            of_members: self.members.iter().map(|member| distance(curve, member)).collect(),
            points: curve.points.len(),
        };
        self.curves().map(misfit).collect()
    }
}

fn distance(curve: &Curve, member: &Member) -> Option<(Amount, usize)> {
    let outcome = member.outcome();
    let (computed, amount): (_, fn(f64, &Curve) -> Amount) = match curve.of {
        Of::Load => (&outcome.load, |value, curve| Amount::force(value, curve.unit)),
        Of::Thickness => (&outcome.thickness, |value, _| Amount::thickness(value)),
    };
    let squares: Vec<f64> = curve.points.iter().filter_map(|(x, y)| Some((at(computed, *x)? - y).powi(2))).collect();
    let mean = squares.iter().sum::<f64>() / squares.len() as f64;
    (!squares.is_empty()).then(|| (amount(mean.sqrt(), curve), squares.len()))
}

/// A curve of rising places at one of them, between the points beside it; `None` beyond its ends.
fn at(points: &[(f64, f64)], x: f64) -> Option<f64> {
    let after = points.partition_point(|point| point.0 < x);
    let end = points.get(after)?;
    if end.0 == x {
        return Some(end.1);
    }
    let start = points.get(after.checked_sub(1)?)?;
    Some(start.1 + (end.1 - start.1) * (x - start.0) / (end.0 - start.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by hand.
    #[test]
    fn between_points_a_curve_is_straight_and_beyond_them_it_is_not_known() {
        let curve = [(1.0, 10.0), (2.0, 20.0), (4.0, 0.0)];
        let values = [0.5, 1.0, 1.5, 3.0, 4.0, 4.5].map(|x| at(&curve, x));
        assert_eq!(values, [None, Some(10.0), Some(15.0), Some(10.0), Some(0.0), None]);
    }
}
