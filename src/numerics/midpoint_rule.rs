//! The thickness in equal parts: each point stands in the middle of one, for laws that integrate over it.

use super::lobatto::ThicknessPoint;

/// The middles of `n` equal parts.
pub fn rule(n: usize) -> Vec<ThicknessPoint> {
    let weight = 1.0 / n as f64;
    (0..n).map(|i| ThicknessPoint { xi: (2 * i + 1) as f64 * weight - 1.0, weight, half: weight }).collect()
}
