//! Inputs made wrong: by what they are made of (keys, group codes, cells) and by their bytes.

use super::excess::excess;
use fastrand::Rng;
use toml::{Table, Value};

/// What a text is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    Toml,
    Dxf,
    Csv,
}

const NUMBERS: [&str; 24] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e308",
    "-1e308",
    "1.7976931348623157e308",
    "1e-308",
    "5e-324",
    "nan",
    "inf",
    "-inf",
    "",
    "9223372036854775807",
    "-9223372036854775808",
    "1e400",
    "2147483648",
    "1e5",
    "1e-9",
    "1e12",
    "90",
    "1000",
];

const UNITS: [&str; 17] =
    ["mm", "m", "um", "km", "in", "N", "kN", "MN", "MPa", "GPa", "N/mm", "s", "mm/s", "%", "°C", "deg", ""];

/// A number from a number: another one, or its like.
fn number(old: f64, rng: &mut Rng) -> String {
    match rng.usize(..10) {
        0..=3 => NUMBERS[rng.usize(..NUMBERS.len())].to_owned(),
        4 => (-old).to_string(),
        5 => (old * 10f64.powi(rng.i32(-9..=9))).to_string(),
        6 => (old + f64::EPSILON * old).to_string(),
        _ => (old * (0.3 + 2.0 * rng.f64())).to_string(),
    }
}

/// Words that nobody writes.
fn words(old: &str, rng: &mut Rng) -> String {
    let odd = [
        "",
        " ",
        "\u{0}",
        "\u{1b}[2J\u{1b}]0;title\u{7}",
        "\u{9b}31m",
        "\u{202e}rtl",
        "Ä\u{301}𝔘",
        "../../etc/passwd",
        "/dev/zero",
        "a,b;c\t\"d\"",
        "line\nline\r\n",
        "<b>&amp;",
        "%s{}",
        "NUL",
        "-",
        "=",
        "punch",
        "die",
        "holder",
    ];
    match rng.usize(..8) {
        0 => "W".repeat([41, 300, 70_000][rng.usize(..3)]),
        1 => format!("{old}{old}"),
        2 => old.chars().rev().collect(),
        3 => old.chars().take(rng.usize(..=old.chars().count())).collect(),
        _ => odd[rng.usize(..odd.len())].to_owned(),
    }
}

/// Another quantity, number and unit, or other words.
fn text(old: &str, rng: &mut Rng) -> String {
    let end = old.find(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c))).unwrap_or(old.len());
    let Ok(value) = old[..end].parse::<f64>() else { return words(old, rng) };
    match rng.usize(..6) {
        0 => words(old, rng),
        1 => format!("{} {}", &old[..end], UNITS[rng.usize(..UNITS.len())]),
        2 => number(value, rng),
        _ => format!("{}{}", number(value, rng), &old[end..]),
    }
}

/// So many times a text of that length, or as often as makes 10 MB: what is larger is not read anyway.
fn repeats(length: usize, times: usize) -> usize {
    times.min(10_000_000 / length.max(1))
}

/// One of a list, where there is one.
fn any<T>(list: &[T], rng: &mut Rng) -> Option<usize> {
    (!list.is_empty()).then(|| rng.usize(..list.len()))
}

/// The bytes with one to three things done to them.
pub fn mutated(bytes: &[u8], form: Form, rng: &mut Rng) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..rng.usize(1..=3) {
        bytes = match (form, std::str::from_utf8(&bytes)) {
            (Form::Toml, Ok(text)) if rng.u8(..30) == 0 => format!("{text}\n{}", excess(rng)).into_bytes(),
            (Form::Toml, Ok(text)) if rng.u8(..10) < 8 => toml(text, rng).unwrap_or(bytes),
            (Form::Dxf, Ok(text)) if rng.u8(..10) < 8 => dxf(text, rng).into_bytes(),
            (Form::Csv, Ok(text)) if rng.u8(..10) < 8 => csv(text, rng).into_bytes(),
            _ => by_bytes(bytes, rng),
        };
    }
    bytes
}

/// Flips, deletions, truncations, insertions, repeats.
fn by_bytes(mut bytes: Vec<u8>, rng: &mut Rng) -> Vec<u8> {
    let Some(at) = any(&bytes, rng) else { return vec![rng.u8(..)] };
    let end = (at + rng.usize(1..40)).min(bytes.len());
    match rng.usize(..6) {
        0 => bytes[at] ^= 1 << rng.u8(..8),
        1 => drop(bytes.drain(at..end)),
        2 => bytes.truncate(at),
        3 => bytes.insert(at, rng.u8(..)),
        4 => drop(bytes.splice(at..at, std::iter::repeat_n(rng.u8(..), rng.usize(1..500)))),
        _ => {
            let again = bytes[at..end].repeat(rng.usize(1..200));
            drop(bytes.splice(at..at, again));
        }
    }
    bytes
}

/// The keys of all entries of a tree, each the way to it.
fn ways(value: &Value, here: &[Step], found: &mut Vec<Vec<Step>>) {
    let mut enter = |step: Step, value: &Value| {
        let way = [here, &[step]].concat();
        ways(value, &way, found);
        found.push(way);
    };
    match value {
        Value::Table(table) => table.iter().for_each(|(key, value)| enter(Step::Key(key.clone()), value)),
        Value::Array(array) => array.iter().enumerate().for_each(|(i, value)| enter(Step::At(i), value)),
        _ => {}
    }
}

#[derive(Clone, Debug)]
enum Step {
    Key(String),
    At(usize),
}

fn at<'v>(tree: &'v mut Value, way: &[Step]) -> Option<&'v mut Value> {
    way.iter().try_fold(tree, |value, step| match step {
        Step::Key(key) => value.get_mut(key),
        Step::At(i) => value.get_mut(*i),
    })
}

/// Keys and tables removed, copied, swapped, renamed; values replaced. `None` of a text that is no TOML.
fn toml(text_now: &str, rng: &mut Rng) -> Option<Vec<u8>> {
    let mut tree = Value::Table(text_now.parse::<Table>().ok()?);
    let mut all = Vec::new();
    ways(&tree, &[], &mut all);
    let one = all[any(&all, rng)?].clone();
    let other = all[any(&all, rng)?].clone();
    let (last, parent) = one.split_last()?;
    match rng.usize(..14) {
        0 => match (at(&mut tree, parent)?, last) {
            (Value::Table(table), Step::Key(key)) => drop(table.remove(key)),
            (Value::Array(array), Step::At(i)) => drop(array.remove(*i)),
            _ => {}
        },
        1 => {
            let value = at(&mut tree, &other)?.clone();
            *at(&mut tree, &one)? = value;
        }
        2 => {
            let (a, b) = (at(&mut tree, &one)?.clone(), at(&mut tree, &other)?.clone());
            *at(&mut tree, &one)? = b;
            if let Some(place) = at(&mut tree, &other) {
                *place = a;
            }
        }
        3 => match (at(&mut tree, parent)?, last) {
            (Value::Table(table), Step::Key(key)) => {
                let value = table.remove(key)?;
                let name = match other.last() {
                    Some(Step::Key(name)) if rng.bool() => name.clone(),
                    _ => words(key, rng),
                };
                table.insert(name, value);
            }
            (Value::Array(array), Step::At(i)) => {
                let value = array[*i].clone();
                let times = repeats(text_now.len(), [1, 2, 3000][rng.usize(..3)]);
                array.splice(*i..*i, std::iter::repeat_n(value, times));
            }
            _ => {}
        },
        4 => {
            let value = at(&mut tree, &other)?.clone();
            if let (Value::Table(table), Step::Key(key)) = (at(&mut tree, parent)?, last) {
                table.insert(format!("{key}_{}", rng.u8(..3)), value);
            }
        }
        _ => {
            let place = at(&mut tree, &one)?;
            *place = match &*place {
                Value::String(old) => Value::String(text(old, rng)),
                Value::Integer(old) => numeric(*old as f64, rng),
                Value::Float(old) => numeric(*old, rng),
                Value::Boolean(old) => Value::Boolean(!old),
                Value::Array(_) if rng.bool() => Value::Array(Vec::new()),
                Value::Table(_) if rng.bool() => Value::Table(Table::new()),
                _ => numeric(1.0, rng),
            };
        }
    }
    toml::to_string(&tree).ok().map(String::into_bytes)
}

fn numeric(old: f64, rng: &mut Rng) -> Value {
    let text = number(old, rng);
    let whole = text.parse().map(Value::Integer);
    whole.or_else(|_| text.parse().map(Value::Float)).unwrap_or(Value::String(text))
}

/// Pairs of group code and value removed, copied, swapped, replaced; whole entities too.
fn dxf(text_now: &str, rng: &mut Rng) -> String {
    let lines: Vec<&str> = text_now.lines().collect();
    let mut pairs: Vec<(String, String)> =
        lines.chunks(2).map(|pair| (pair[0].to_owned(), pair.get(1).unwrap_or(&"").to_string())).collect();
    // Half of the strokes go where the shapes are.
    let shapes = pairs.iter().position(|(_, value)| value == "ENTITIES").unwrap_or(0);
    let from = if rng.bool() { shapes } else { 0 };
    if from >= pairs.len() {
        return text_now.to_owned();
    }
    let (one, other) = (rng.usize(from..pairs.len()), rng.usize(from..pairs.len()));
    let begins = |pair: &(String, String)| pair.0.trim() == "0";
    match rng.usize(..12) {
        0 => drop(pairs.remove(one)),
        1 => pairs.insert(other, pairs[one].clone()),
        2 => pairs.swap(one, other),
        3 => {
            let codes = [
                "0", "5", "8", "10", "20", "30", "11", "21", "40", "41", "42", "50", "51", "67", "70", "71", "210",
                "-1", "999",
            ];
            pairs[one].0 = codes[rng.usize(..codes.len())].to_owned();
        }
        4 | 5 => {
            let start = (0..=one).rev().find(|i| begins(&pairs[*i])).unwrap_or(0);
            let end = (one + 1..pairs.len()).find(|i| begins(&pairs[*i])).unwrap_or(pairs.len());
            let entity = pairs[start..end].to_vec();
            if rng.bool() {
                pairs.drain(start..end);
            } else {
                let times = repeats(100 * entity.len(), [1, 1, 1, 500][rng.usize(..4)]);
                pairs.splice(start..start, std::iter::repeat_n(entity, times).flatten());
            }
        }
        6 => {
            let kinds = [
                "LINE",
                "ARC",
                "CIRCLE",
                "SPLINE",
                "LWPOLYLINE",
                "POLYLINE",
                "VERTEX",
                "SEQEND",
                "ELLIPSE",
                "INSERT",
                "ENDSEC",
                "SECTION",
                "EOF",
                "TEXT",
            ];
            if let Some(i) = (one..pairs.len()).find(|i| begins(&pairs[*i])) {
                pairs[i].1 = kinds[rng.usize(..kinds.len())].to_owned();
            }
        }
        7 => pairs.truncate(one),
        _ => pairs[one].1 = text(pairs[one].1.trim(), rng).replace(['\n', '\r'], " "),
    }
    pairs.iter().map(|(code, value)| format!("{code}\n{value}\n")).collect()
}

/// Cells replaced, rows and columns removed, copied, swapped, separators and units of headers changed.
fn csv(text_now: &str, rng: &mut Rng) -> String {
    let mut rows: Vec<Vec<String>> =
        text_now.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect();
    let (Some(one), Some(other)) = (any(&rows, rng), any(&rows, rng)) else { return ",".to_owned() };
    let cell = rng.usize(..rows[one].len());
    match rng.usize(..12) {
        0 => drop(rows.remove(one)),
        1 => rows.insert(other, rows[one].clone()),
        2 => rows.swap(one, other),
        3 => drop(rows[one].remove(cell)),
        4 => {
            let copy = rows[one][cell].clone();
            rows[one].insert(cell, copy);
        }
        5 => {
            let ends = ["_mm", "_in", "_um", "_m", "_N", "_kN", "_C", "_percent", "", "_N_per_mm"];
            if let Some(header) = rows.iter_mut().find(|row| !row[0].starts_with('#'))
                && let Some(i) = any(header, rng)
            {
                let stem = header[i].split('_').next().unwrap_or("").to_owned();
                header[i] = stem + ends[rng.usize(..ends.len())];
            }
        }
        6 => {
            let by = [";", "\t", " ", "\"", "\n", ",,"][rng.usize(..6)];
            return text_now.replacen(',', by, rng.usize(1..200));
        }
        7 => {
            let row = rows[one].clone();
            let times = repeats(row.iter().map(String::len).sum(), [2, 2500, 110_000][rng.usize(..3)]);
            rows.splice(one..one, std::iter::repeat_n(row, times));
        }
        _ => rows[one][cell] = text(rows[one][cell].trim(), rng),
    }
    rows.iter().map(|row| row.join(",") + "\n").collect()
}
