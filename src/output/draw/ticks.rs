//! Ticks: how many, where, and their labels.

pub(super) fn tick_count(height: f64) -> usize {
    ((height / 45.0) as usize).clamp(4, 8)
}

/// The multiples of 1, 2 or 5 times a power of ten within the range, as close together as `most` of them allow.
pub(super) fn ticks(range: (f64, f64), most: usize) -> Vec<f64> {
    let span = range.1 - range.0;
    if !(span > 0.0 && span.is_finite()) {
        return vec![range.0];
    }
    // Steps of a digit, and of how many powers of ten: numbers like 0.3 come out as they are written.
    let within = |digit: f64, power: i32| {
        let scale = 10_f64.powi(power.abs());
        let value = move |i: f64| if power < 0 { i * digit / scale } else { i * digit * scale };
        let step = value(1.0);
        let (first, last) = ((range.0 / step - 1e-9).ceil(), (range.1 / step + 1e-9).floor());
        (first, last, value)
    };
    let coarsest = span.log10().floor() as i32 + 1;
    let steps = (0..).flat_map(|k| [5.0, 2.0, 1.0].map(|digit| (digit, coarsest - k)));
    let fits = |&(digit, power): &(f64, i32)| {
        let (first, last, _) = within(digit, power);
        last - first + 1.0 <= most as f64
    };
    let (digit, power) = steps.take_while(fits).last().unwrap_or((1.0, coarsest + 1));
    let (first, last, value) = within(digit, power);
    (0..).map(|i| first + f64::from(i)).take_while(|i| *i <= last).map(value).collect()
}

/// A tick's label: as many decimals as the ticks beside it need, digits in groups of three from 10 000 on.
pub(super) fn tick(value: f64, all: &[f64]) -> String {
    let decimals = |v: &f64| {
        let text = format!("{v:.6}");
        let tail = text.rsplit_once('.').map_or("", |(_, tail)| tail.trim_end_matches('0'));
        tail.len()
    };
    let text = format!("{:.*}", all.iter().map(decimals).max().unwrap_or(0), value + 0.0);
    let text = if text.trim_start_matches(['-', '0', '.']).is_empty() { text.replace('-', "") } else { text };
    let (whole, tail) = text.split_once('.').map_or((text.as_str(), ""), |(whole, tail)| (whole, tail));
    let digits = whole.trim_start_matches('-');
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && digits.len() > 4 && (digits.len() - i) % 3 == 0 {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    let minus = if whole.starts_with('-') { "−" } else { "" };
    let point = if tail.is_empty() { "" } else { "." };
    format!("{minus}{grouped}{point}{tail}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_numbers_as_many_as_allowed() {
        assert_eq!(ticks((0.0, 1.0), 8), [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        assert_eq!(ticks((0.0, 0.3), 8), [0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3]);
        assert_eq!(ticks((-0.52, 0.46), 6), [-0.4, -0.2, 0.0, 0.2, 0.4]);
        assert_eq!(ticks((0.0, 46_900.0), 7), [0.0, 10_000.0, 20_000.0, 30_000.0, 40_000.0]);
        assert_eq!(ticks((99.5, 100.5), 4), [99.5, 100.0, 100.5]);
        assert_eq!(ticks((3.0, 3.0), 8), [3.0]);
    }

    #[test]
    fn ticks_share_their_decimals_and_group_thousands() {
        let all = [0.0, 0.05, 0.1];
        assert_eq!(all.map(|v| tick(v, &all)), ["0.00", "0.05", "0.10"]);
        assert_eq!(tick(-20_000.0, &[0.0, 10_000.0]), "−20\u{2009}000");
        assert_eq!(tick(5000.0, &[5000.0]), "5000");
        assert_eq!(tick(0.1 + 0.2, &[0.1 + 0.2]), "0.3");
        assert_eq!(tick(-0.0, &[0.0]), "0");
    }
}
