//! Lengths in sentences.

/// A length \[mm\] without digits that mean nothing.
pub(crate) fn mm(length: f64) -> String {
    // Adding 0 takes the sign from a rounded −0.
    let text = format!("{:.3}", (length * 1e3).round() / 1e3 + 0.0);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
