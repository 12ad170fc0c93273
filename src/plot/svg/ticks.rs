//! Ticks: their number, their values and their labels.

use super::*;
use plotters::coord::ranged1d::{BoldPoints, DefaultFormatting, KeyPointHint, Ranged};
use plotters::coord::types::RangedCoordf64;

pub(super) fn tick_count(height: f64) -> usize {
    ((height / 45.0) as usize).clamp(4, 8)
}

fn ticks(range: (f64, f64), most: usize) -> Vec<f64> {
    RangedCoordf64::from(range.0..range.1).key_points(BoldPoints(most))
}

fn decades((low, high): (f64, f64), most: usize) -> Vec<f64> {
    let powers = low.floor() as i32..=high.ceil() as i32;
    let fine = powers.flat_map(|power| [1.0_f64, 2.0, 5.0].map(|digit| digit.log10() + f64::from(power)));
    let fine: Vec<f64> = fine.filter(|place| (low..=high).contains(place)).collect();
    match fine.len() {
        0 | 1 => ticks((10_f64.powf(low), 10_f64.powf(high)), most).into_iter().map(f64::log10).collect(),
        n if n > most => {
            let tens: Vec<f64> = fine.into_iter().filter(|place| place.fract() == 0.0).collect();
            tens.iter().step_by(tens.len().div_ceil(most).max(1)).copied().collect()
        }
        _ => fine,
    }
}

pub(super) struct Ticked(pub (f64, f64), pub Vec<f64>);

impl Ranged for Ticked {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        RangedCoordf64::from(self.range()).map(value, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.1.clone()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.0.0..self.0.1
    }
}

fn tick(value: f64, all: &[f64]) -> String {
    let decimals = |v: &f64| format!("{v:.6}").trim_end_matches('0').rsplit_once('.').map_or(0, |(_, tail)| tail.len());
    let text = format!("{:.*}", all.iter().map(decimals).max().unwrap_or(0), value.abs());
    let (digits, tail) = text.split_at(text.find('.').unwrap_or(text.len()));
    let is_negative = value < 0.0 && text.contains(|c: char| c.is_ascii_digit() && c != '0');
    let mut label = String::from(if is_negative { "−" } else { "" });
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && digits.len() > 4 && (digits.len() - i) % 3 == 0 {
            label.push('\u{2009}');
        }
        label.push(digit);
    }
    label + tail
}

pub(super) fn values(axis: &Axis, range: (f64, f64), most: usize) -> Vec<f64> {
    match axis.names.as_slice() {
        [] if axis.spacing.is_logarithmic() => decades(range, most),
        [] => ticks(range, most),
        names => (0..names.len()).map(|i| i as f64).collect(),
    }
}

pub(super) fn label(axis: &Axis, value: f64, all: &[f64]) -> String {
    match axis.names.as_slice() {
        [] if axis.spacing.is_logarithmic() => {
            let value = axis.spacing.value(value);
            tick(value, &[value])
        }
        [] => tick(value, all),
        names => names.get(value.round() as usize).cloned().unwrap_or_default(),
    }
}

#[cfg(test)]
#[test]
fn ticks_are_round_numbers_as_many_as_allowed() {
    let labels = |values: Vec<f64>| values.iter().map(|value| tick(*value, &values)).collect::<Vec<_>>().join(" ");
    let log = |low: f64, high: f64, most| {
        labels(decades((low.log10(), high.log10()), most).iter().map(|place| 10_f64.powf(*place)).collect())
    };
    assert_eq!(labels(ticks((-0.52, 0.46), 6)), "−0.4 −0.2 0.0 0.2 0.4");
    assert_eq!(labels(ticks((0.0, 46_900.0), 7)), "0 10\u{2009}000 20\u{2009}000 30\u{2009}000 40\u{2009}000");
    assert_eq!(log(0.02, 0.3, 8), "0.02 0.05 0.10 0.20");
    assert_eq!(log(1.0, 1e3, 4), "1 10 100 1000");
    assert_eq!(log(6.0, 9.0, 4), "6 7 8 9");
}
