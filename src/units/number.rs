//! Numbers as text.

/// Nine significant digits: more than anyone measures, and no binary noise at the end (31.4 mm, not
/// 31.400000000000002 mm).
pub fn rounded(value: f64) -> f64 {
    format!("{value:.8e}").parse::<f64>().map_or(value, |v| v + 0.0) // −0 becomes 0
}
