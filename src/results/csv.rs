//! Tables as comma-separated text.

use crate::measure::Change;
use crate::table::{Table, Unit};
use crate::units::rounded;
use std::fmt::Write;

/// One header row (`punch_force_N`), then one row per value, nine significant digits; a cell without a finite number is empty.
pub fn csv(table: &Table) -> Vec<u8> {
    with_texts(&[], table)
}

/// The same with columns of text, a header and one entry per row each, behind the first column of numbers.
pub(super) fn with_texts(texts: &[(&str, Vec<String>)], table: &Table) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let never = "memory does not refuse a row";
    let first = usize::from(!texts.is_empty());
    let mut record = |numbers: Vec<String>, words: Vec<&str>| {
        let (before, after) = numbers.split_at(first);
        writer.write_record(before.iter().map(String::as_str).chain(words).chain(after.iter().map(String::as_str)))
    };
    let headers = table.columns.iter().map(|c| c.header()).collect();
    record(headers, texts.iter().map(|(header, _)| *header).collect()).expect(never);
    for row in 0..table.rows() {
        let numbers = table.columns.iter().map(|c| number(c.values[row])).collect();
        record(numbers, texts.iter().map(|(_, entries)| entries[row].as_str()).collect()).expect(never);
    }
    writer.into_inner().expect(never)
}

/// One row per quantity that was measured on two sheets; what one of them has not is left empty. The opening of a ring that is
/// slit \[mm\] is after the release.
pub(super) fn springback(changes: &[Change], ring: Option<f64>) -> String {
    let mut text = "quantity,unit,before,after,change\n".to_owned();
    for change in changes {
        let [before, after, by] =
            [change.before, change.after, change.change()].map(|v| v.map_or(String::new(), number));
        let _ = writeln!(text, "{},{},{before},{after},{by}", change.quantity.key, change.quantity.unit.spelled());
    }
    if let Some(opening) = ring {
        let _ = writeln!(text, "ring_opening,{},,{},", Unit::Mm.spelled(), number(opening));
    }
    text
}

/// Nothing for what is no number: an empty cell.
pub(crate) fn number(value: f64) -> String {
    if !value.is_finite() {
        return String::new();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    plain(value).unwrap_or_else(|| {
        let value = rounded(value);
        if (1e-4..1e9).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
    })
}

/// Powers of ten that are exact, and enough to bring the least number of [`plain`] to nine digits.
const TENS: [f64; 13] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12];

/// The same by whole numbers, which is many times as fast, for nearly all that a table holds. Multiplied by a power of
/// ten that is exact, a value is off by 1e-7 at most: whatever is further from half way is rounded rightly.
fn plain(value: f64) -> Option<String> {
    let size = value.abs();
    let mut decimals = TENS.iter().position(|ten| size * ten >= 1e8)?;
    let scaled = size * TENS[decimals];
    let mut digits = (scaled + 0.5) as u32;
    if !(1e-4..999_999_999.0).contains(&size) || (scaled - f64::from(digits)).abs() > 0.5 - 1e-6 {
        return None;
    }
    while decimals > 0 && digits.is_multiple_of(10) {
        (digits, decimals) = (digits / 10, decimals - 1);
    }
    // From the last digit to the sign.
    let (mut text, mut written) = ([0; 16], 0);
    let mut put = |letter: u8| {
        written += 1;
        text[16 - written] = letter;
    };
    for place in 0.. {
        if place > decimals && digits == 0 {
            break;
        }
        if place == decimals && place > 0 {
            put(b'.');
        }
        put(b'0' + (digits % 10) as u8);
        digits /= 10;
    }
    if value < 0.0 {
        put(b'-');
    }
    Some(String::from_utf8_lossy(&text[16 - written..]).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Column;

    #[test]
    fn numbers_are_short_and_read_back_to_nine_digits() {
        for (value, text) in [
            (0.1 + 0.2, "0.3"),
            (-0.0, "0"),
            (1.0, "1"),
            (44_444.444_444_44, "44444.4444"),
            (1.234_567_891_23e-7, "1.23456789e-7"),
            (f64::NAN, ""),
            (f64::INFINITY, ""),
        ] {
            assert_eq!(number(value), text);
        }
    }

    /// Trust: the standard library's own rounding and shortest text, over all sizes and where digits turn over.
    #[test]
    fn whole_numbers_write_what_rounding_writes() {
        let mut random = fastrand::Rng::with_seed(3);
        let edges =
            [0.5, 9.999_999_995, 99_999_999.95, 999_999_999.4, 999_999_999.6, 1e-4, 0.000_1 - 1e-15, 123_456.789_5];
        let values = (0..20_000).map(|_| random.f64() * 10_f64.powi(random.i32(-5..10))).chain(edges);
        for value in values.flat_map(|value| [value, -value, (value * 1e4).round() / 1e4]) {
            if let Some(text) = plain(value) {
                assert_eq!(text, format!("{}", rounded(value)), "{value:e}");
            }
        }
    }

    #[test]
    fn a_table_becomes_a_header_and_rows() {
        let table = Table::new(vec![
            Column::new("travel", "Punch travel", Unit::Mm, vec![0.5, 1.0]),
            Column::new("punch_force", "Punch force", Unit::NPerMm, vec![10.0, 20.25]),
        ]);
        assert_eq!(String::from_utf8(csv(&table)).unwrap(), "travel_mm,punch_force_N_per_mm\n0.5,10\n1,20.25\n");
    }
}
