//! The augmented Lagrangian: shifts of the gaps until nothing penetrates any more.
//!
//! # References
//! M. R. Hestenes, Multiplier and gradient methods, J. Optim. Theory Appl. 4 (1969) 303–320; contact: J. C. Simo,
//! T. A. Laursen, Computers & Structures 42 (1992) 97–116.

use super::evaluation::{Evaluation, mean_gap};
use super::trial::Trial;
use crate::element::surface::STATIONS;
use crate::model::Settings;

/// Most rounds that one shift of the augmented Lagrangian stands for.
const LONGEST_SERIES: f64 = 20.0;

/// One round: shifts the gaps of every element by what is left of them, λ ← min(0, λ + g). Returns `false` when nothing
/// penetrates, or is pressed from afar, by more than [`Settings::PENETRATION`].
///
/// The points of an element share one shift, by their mean gap: one for each would ask more of the sheet than its nodes can
/// give, and pressure would alternate from point to point.
///
/// Where the sheet hardly gives way, as a rigid zone does until it yields, g falls slowly from round to round; then the
/// shift is what the series of its rounds adds up to, by the ratio of the last two (A. C. Aitken, 1926).
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
