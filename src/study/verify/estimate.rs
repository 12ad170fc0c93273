//! Discretisation error of a number from its values on other levels of refinement.

use super::{Direction, Outcome};
use crate::assess::error_bars::{Contribution, Number};
use crate::units::ErrorBar;

/// Factor of safety on an extrapolated error \[–\].
const EXTRAPOLATED: f64 = 1.25;
/// Formal order of convergence in the contact smoothing, the one direction with three levels \[–\].
const ORDER: f64 = 1.0;
/// Least error over the number, in tolerances to which every step was solved \[–\].
const SOLVED: f64 = 10.0;
/// A number jumps if the finer pair of levels differs by so many times what the coarser does \[–\], and by more than this share.
const OUT_OF_LINE: f64 = 4.0;
const MUCH: f64 = 0.05;

fn estimate(direction: Direction, levels: &[f64]) -> Contribution {
    let observed = |levels: &[f64; 3]| ((levels[0] - levels[1]) / (levels[1] - levels[2])).log2();
    let order = levels.try_into().ok().map(observed).filter(|p| p.is_finite());
    // Factors on the spread: 19 bars of 20 hold the truth of random dies.
    let safety = if direction == Direction::Elements { 3.0 } else { 2.0 };
    let believed = order.filter(|p| (0.5 * ORDER..=2.0 * ORDER).contains(p));
    let end = |of: fn(f64, f64) -> f64| levels.iter().copied().reduce(of).unwrap_or(0.0);
    let error = match believed {
        Some(p) => EXTRAPOLATED * (levels[0] - levels[1]).abs() / (1.0 - 0.5_f64.powf(p)),
        None => safety * (end(f64::max) - end(f64::min)),
    };
    Contribution { direction: direction.label(), error, order, extrapolated: believed.is_some(), share: 0.0 }
}

pub(super) fn with_bar(number: &Number, directions: &[(Direction, Vec<&Outcome>)], tolerance: f64) -> Number {
    if number.quantity.error != ErrorBar::NotComputed {
        return number.clone();
    }
    let value = number.quantity.amount.value;
    let (mut contributions, mut finer) = (Vec::new(), [f64::INFINITY, f64::NEG_INFINITY]);
    for (direction, runs) in directions {
        let Some(others) = runs.iter().map(|run| run.value(number)).collect::<Option<Vec<f64>>>() else {
            return number.without_bar(&format!("not found in every run ({})", direction.label()));
        };
        finer = others.iter().fold(finer, |[low, high], value| [low.min(*value), high.max(*value)]);
        let levels = [vec![value], others].concat();
        let step = |i: usize| (levels[i] - levels[i - 1]).abs();
        let jumps = |i: &usize| step(*i) > OUT_OF_LINE * step(i - 1) && step(*i) > MUCH * value.abs();
        if let Some(i) = (2..levels.len()).find(jumps) {
            let [from, to] = [levels[i - 1], levels[i]].map(|level| number.quantity.amount.with_value(level));
            let finer = direction.text(runs[i - 1].times);
            return number.without_bar(&format!("jumps from {from} to {to} with {finer}"));
        }
        contributions.push(estimate(*direction, &levels));
    }
    let all: f64 = contributions.iter().map(|part| part.error).sum();
    if all > 0.0 {
        contributions.iter_mut().for_each(|part| part.share = part.error / all);
    }
    contributions.sort_by(|a, b| b.share.total_cmp(&a.share));
    let half = if all > 0.0 { all.max(SOLVED * tolerance * value.abs()) } else { 0.0 };
    let quantity = number.quantity.clone().with_error(ErrorBar::Half(half));
    Number { quantity, contributions, finer: Some(finer), ..number.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: f = 7 + c hᵖ with h = 1, 1/2, 1/4 has the error c on its first level; the others by hand.
    #[test]
    fn a_power_law_is_extrapolated_and_anything_else_has_its_spread() {
        use Direction::{Elements, Points, Smoothing};
        for p in [0.6, 1.0, 1.9] {
            let estimate = estimate(Smoothing, &[1.0_f64, 0.5, 0.25].map(|h| 7.0 - 2.0 * h.powf(p)));
            assert_relative_eq!(estimate.order.expect("one sign"), p, max_relative = 1e-9);
            assert_relative_eq!(estimate.error, 1.25 * 2.0, max_relative = 1e-9);
        }
        for (direction, levels, error, order) in [
            (Smoothing, &[10.0, 7.0, 8.0][..], 6.0, None),
            (Smoothing, &[10.0, 9.0, 6.0], 8.0, Some((1.0_f64 / 3.0).log2())),
            (Smoothing, &[10.0, 9.0, 9.0], 2.0, None),
            (Elements, &[10.0, 9.0], 3.0, None),
            (Points, &[5.0, 4.0], 2.0, None),
        ] {
            let estimate = estimate(direction, levels);
            assert_eq!((estimate.error, estimate.order, estimate.extrapolated), (error, order, false), "{levels:?}");
        }
    }
}
