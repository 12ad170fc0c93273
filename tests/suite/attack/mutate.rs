//! Inputs made wrong, whatever their format: numbers, words, lines and bytes.

use super::excess::excess;
use crate::common::prelude::*;

const NUMBERS: &str =
    "0 -0.0 1 -1 0.5 1e308 -1e308 1e-308 5e-324 nan inf -inf 9223372036854775807 1e400 2147483648 1e5 1e-9 90";
/// Words, separated by bars.
const WORDS: &str = "| |\u{0}|\u{1b}[2J\u{1b}]0;title\u{7}|\u{9b}31m|\u{202e}rtl|Ä\u{301}𝔘|../../etc/passwd|/dev/zero|a,b;c\t\"d\"|\
    line\nline\r\n|%s{}|=|punch|die|holder|mm|kN|MPa|%|LINE|SPLINE";

fn one_of(list: &str, separator: char, rng: &mut Rng) -> String {
    let all: Vec<&str> = list.split(separator).collect();
    all[rng.usize(..all.len())].to_owned()
}

/// Number or word of a text, at random: its start and end.
fn token(text: &str, rng: &mut Rng) -> Option<(usize, usize)> {
    let is_part = |c: char| c.is_alphanumeric() || "+-._".contains(c);
    let from = text.char_indices().map(|(i, _)| i).nth(rng.usize(..text.chars().count().max(1)))?;
    let start = from + text[from..].find(is_part)?;
    Some((start, text[start..].find(|c| !is_part(c)).map_or(text.len(), |length| start + length)))
}

fn replacement(old: &str, rng: &mut Rng) -> String {
    match (old.parse::<f64>(), rng.usize(..10)) {
        (Ok(_), 0..=2) => one_of(NUMBERS, ' ', rng),
        (Ok(value), 3) => (-value).to_string(),
        (Ok(value), 4) => (value * 10f64.powi(rng.i32(-9..=9))).to_string(),
        (Ok(value), _) => (value * (0.3 + 2.0 * rng.f64())).to_string(),
        (Err(_), 0) => "W".repeat([41, 300, 70_000][rng.usize(..3)]),
        (Err(_), 1) => format!("{old}{old}"),
        (Err(_), _) => one_of(WORDS, '|', rng),
    }
}

fn by_text(text: &str, rng: &mut Rng) -> String {
    if rng.u8(..10) < 7
        && let Some((start, end)) = token(text, rng)
    {
        return format!("{}{}{}", &text[..start], replacement(&text[start..end], rng), &text[end..]);
    }
    let mut lines: Vec<&str> = text.lines().collect();
    let (one, other) = (rng.usize(..lines.len().max(1)), rng.usize(..lines.len().max(1)));
    match rng.usize(..4) {
        _ if lines.is_empty() => {}
        0 => drop(lines.remove(one)),
        1 => lines.swap(one, other),
        2 => lines.insert(other, lines[one]),
        _ => {
            // What is larger than 10 MB is not read anyway.
            let times = [2, 2_500, 110_000][rng.usize(..3)].min(10_000_000 / lines[one].len().max(1));
            drop(lines.splice(one..one, vec![lines[one]; times]));
        }
    }
    lines.join("\n")
}

fn by_bytes(mut bytes: Vec<u8>, rng: &mut Rng) -> Vec<u8> {
    if bytes.is_empty() {
        return vec![rng.u8(..)];
    }
    let at = rng.usize(..bytes.len());
    let end = (at + rng.usize(1..40)).min(bytes.len());
    match rng.usize(..5) {
        0 => bytes[at] ^= 1 << rng.u8(..8),
        1 => drop(bytes.drain(at..end)),
        2 => bytes.truncate(at),
        3 => drop(bytes.splice(at..at, std::iter::repeat_n(rng.u8(..), rng.usize(1..500)))),
        _ => {
            drop(bytes.splice(at..at, bytes[at..end].repeat(rng.usize(1..200))));
        }
    }
    bytes
}

/// The bytes with one to three changes; a case may also grow too large.
pub fn mutated(bytes: &[u8], is_case: bool, rng: &mut Rng) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..rng.usize(1..=3) {
        bytes = match std::str::from_utf8(&bytes) {
            Ok(text) if is_case && rng.u8(..30) == 0 => format!("{text}\n{}", excess(rng)).into_bytes(),
            Ok(text) if rng.u8(..10) < 9 => by_text(text, rng).into_bytes(),
            _ => by_bytes(bytes, rng),
        };
    }
    bytes
}
