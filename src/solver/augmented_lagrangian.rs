//! Augmented Lagrangian: gaps are shifted until nothing penetrates.
//!
//! # References
//! M. R. Hestenes, J. Optim. Theory Appl. 4 (1969) 303; J. C. Simo, T. A. Laursen, Computers & Structures 42 (1992) 97.

use super::{evaluation::mean_gap, *};

const LONGEST_SERIES: f64 = 20.0;

/// One round: λ ← min(0, λ + g) for every element; `false` when none is off by more than [`Settings::PENETRATION`].
///
/// The points of an element share one shift, by their mean gap: with one each, pressure would alternate between points.
/// Where g falls slowly the shift is the sum of the geometric series of its rounds (A. C. Aitken, 1926).
pub(super) fn shift(trial: &mut Trial, evaluation: &Evaluation, round: usize) -> bool {
    let mut worst: f64 = 0.0;
    for (contacts, memories) in evaluation.contacts.rows().zip(trial.contacts.rows()) {
        let elements = contacts.chunks_exact(STATIONS).zip(memories.chunks_exact(STATIONS)).zip(&evaluation.thickness);
        for ((contacts, memories), thickness) in elements {
            let gap = mean_gap(contacts).filter(|gap| *gap < 0.0 || memories[0].shift < 0.0);
            worst = gap.map_or(worst, |gap| worst.max(gap.abs() / thickness));
        }
    }
    if worst <= Settings::PENETRATION {
        return false;
    }
    for (contacts, memories) in evaluation.contacts.rows().zip(trial.contacts.rows_mut()) {
        for (contacts, memories) in contacts.chunks_exact(STATIONS).zip(memories.chunks_exact_mut(STATIONS)) {
            let Some(gap) = mean_gap(contacts) else { continue };
            let ratio = if round > 0 { gap / memories[0].round_gap } else { 0.0 };
            let series = if (0.0..1.0).contains(&ratio) { (1.0 / (1.0 - ratio)).min(LONGEST_SERIES) } else { 1.0 };
            for (contact, memory) in contacts.iter().zip(memories) {
                memory.round_gap = gap;
                memory.shift = (memory.shift + series * gap).min(0.0);
                memory.carried = contact.pressure.value;
            }
        }
    }
    true
}
