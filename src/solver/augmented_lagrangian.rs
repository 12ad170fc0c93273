//! The augmented Lagrangian: shifts of the gaps until nothing penetrates any more.
//!
//! # References
//! M. R. Hestenes, Multiplier and gradient methods, J. Optim. Theory Appl. 4 (1969) 303–320; contact: J. C. Simo,
//! T. A. Laursen, Computers & Structures 42 (1992) 97–116.

use super::evaluation::{Contact, Evaluation};
use super::process::Process;
use super::trial::Trial;
use crate::model::Settings;

/// Most rounds that one shift of the augmented Lagrangian stands for.
const LONGEST_SERIES: f64 = 20.0;

/// One round: shifts every gap by what is left of it, λ ← min(0, λ + g). Returns `false` when nothing penetrates, or is
/// pressed from afar, by more than [`Settings::PENETRATION`].
///
/// Where the sheet hardly gives way, as a rigid zone does until it yields, g falls slowly from round to round; then the
/// shift is what the series of its rounds adds up to, by the ratio of the last two (A. C. Aitken, 1926).
///
/// Between two tools that do not give way there is no gap to find; there the penalty stays.
pub(super) fn shift(process: &Process, trial: &mut Trial, evaluation: &Evaluation, round: usize) -> bool {
    let mut worst: f64 = 0.0;
    for (contacts, memories) in evaluation.contacts.rows().zip(trial.contacts.rows()) {
        for (i, (&Contact { gap, .. }, memory)) in contacts.iter().zip(memories).enumerate() {
            if (gap < 0.0 || memory.shift < 0.0) && gap.is_finite() && evaluation.ironing(process, i).is_none() {
                worst = worst.max(gap.abs() / evaluation.thickness_at(i));
            }
        }
    }
    if worst <= Settings::PENETRATION {
        return false;
    }
    for (contacts, memories) in evaluation.contacts.rows().zip(trial.contacts.rows_mut()) {
        for (i, (&Contact { gap, pressure, .. }, memory)) in contacts.iter().zip(memories).enumerate() {
            if gap.is_finite() && evaluation.ironing(process, i).is_none() {
                let ratio = if round > 0 { gap / memory.round_gap } else { 0.0 };
                let series = if (0.0..1.0).contains(&ratio) { (1.0 / (1.0 - ratio)).min(LONGEST_SERIES) } else { 1.0 };
                memory.round_gap = gap;
                memory.shift = (memory.shift + series * gap).min(0.0);
                memory.carried = pressure.value;
            }
        }
    }
    true
}
