//! Numbers as text.

/// Nine significant digits: more than anyone measures, and no binary noise at the end (31.4 mm, not
/// 31.400000000000002 mm).
pub fn rounded(value: f64) -> f64 {
    significant(value, 9)
}

/// The value to so many significant digits.
pub fn significant(value: f64, digits: usize) -> f64 {
    let decimals = digits.max(1) - 1;
    format!("{value:.decimals$e}").parse::<f64>().map_or(value, |v| v + 0.0) // −0 becomes 0
}

/// At most so many decimals, without zeros at the end and without a minus before 0: `30.5`, `0`.
pub fn trimmed(value: f64, decimals: i32) -> String {
    let scale = 10f64.powi(decimals);
    let text = format!("{:.*}", decimals.max(0) as usize, (value * scale).round() / scale + 0.0);
    without_zeros(&text).to_owned()
}

/// A length \[mm\] to the micrometre: `30.5`.
pub fn mm(length: f64) -> String {
    trimmed(length, 3)
}

/// A decimal number without zeros at the end of its decimals.
pub fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// Joins the parts that are not empty.
pub fn joined(parts: impl IntoIterator<Item = String>, separator: &str) -> String {
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(separator)
}
