//! Sliders of a case, and the keys that move along: a die's throat goes with the punch, for the clearance stays.

use serde_json::{Value, json};
use toml_edit::{DocumentMut, Item};

/// A number that a designer turns: its name, where it may stand, and its range over the number that stands there \[–\].
struct Known {
    key: &'static str,
    paths: &'static [&'static str],
    range: [f64; 2],
}

const PUNCH: &str = "punch_radius";
const THROAT: &str = "throat";
const SHOULDER: &str = "shoulder";
const CLEARANCE: &str = "clearance";
const INNER: &str = "inner_radius";
const FRICTION: &str = "friction";
const ELEMENTS: &str = "elements";

const KNOWN: &[Known] = &[
    known("blank", &["blank.radius", "blank.half_length", "blank.diameter", "blank.length"], [0.8, 1.25]),
    known("thickness", &["blank.thickness"], [0.5, 1.6]),
    known(
        PUNCH,
        &[
            "tools.punch.flat.radius",
            "tools.punch.flat.half_width",
            "tools.punch.hemispherical.radius",
            "tools.punch.flat.diameter",
            "tools.punch.hemispherical.diameter",
        ],
        [0.8, 1.2],
    ),
    known("nose", &["tools.punch.flat.nose"], [0.5, 2.0]),
    known(THROAT, &["tools.die.throat", "tools.die.throat_diameter"], [0.95, 1.2]),
    known(SHOULDER, &["tools.die.shoulder"], [0.5, 2.0]),
    known(INNER, &["tools.holder.inner_radius", "tools.holder.inner_half_width"], [0.95, 1.2]),
    known("holder_force", &["tools.holder.force"], [0.0, 4.0]),
    known("holder_pressure", &["tools.holder.pressure"], [0.0, 4.0]),
    known("travel", &["tools.punch.travel"], [0.2, 1.2]),
    known(FRICTION, &["tools.punch.friction", "tools.die.friction"], [0.0, 3.0]),
    known("k", &["material.hardening.swift.k", "material.hardening.hollomon.k"], [0.5, 2.0]),
    known("n", &["material.hardening.swift.n", "material.hardening.hollomon.n"], [0.4, 1.6]),
    known(ELEMENTS, &["blank.elements"], [0.15, 1.5]),
];

/// Range of the clearance over what it is \[–\].
const GAP: [f64; 2] = [0.8, 2.0];

const fn known(key: &'static str, paths: &'static [&'static str], range: [f64; 2]) -> Known {
    Known { key, paths, range }
}

/// A number of the case that moves.
struct Slider {
    key: &'static str,
    path: &'static str,
    value: f64,
    /// As it is written; empty of a plain number.
    unit: String,
    range: [f64; 2],
}

/// The sliders of a case's text, and what they write: each path is set to the sum of some sliders and a constant.
pub fn sliders(text: &str) -> Value {
    let Ok(document) = text.parse::<DocumentMut>() else { return listed(&[], &[]) };
    let mut sliders: Vec<Slider> = KNOWN.iter().filter_map(|known| known.find(document.as_item())).collect();
    let mut writes = Vec::new();
    couple(&mut sliders, &mut writes);
    for one in &sliders {
        // `friction` is that of every tool.
        let path = if one.key == FRICTION { FRICTION } else { one.path };
        if one.key != CLEARANCE && !writes.iter().any(|write: &Write| write.path == path) {
            writes.push(write(path, &one.unit, &[one.key], 0.0));
        }
    }
    listed(&sliders, &writes)
}

fn listed(sliders: &[Slider], writes: &[Write]) -> Value {
    let slider = |one: &Slider| {
        let [low, high] = one.range.map(|times| times * one.value);
        json!({ "key": one.key, "value": one.value, "unit": one.unit, "low": low, "high": high })
    };
    let write = |Write { path, unit, terms, plus }: &Write| json!({ "path": path, "unit": unit, "terms": terms, "plus": plus, "isWhole": *terms == [ELEMENTS] });
    json!({
        "sliders": sliders.iter().map(slider).collect::<Vec<_>>(),
        "writes": writes.iter().map(write).collect::<Vec<_>>(),
    })
}

/// A path of the case, which is set to the sum of some sliders and a constant.
struct Write {
    path: &'static str,
    unit: String,
    terms: Vec<&'static str>,
    plus: f64,
}

fn write(path: &'static str, unit: &str, terms: &[&'static str], plus: f64) -> Write {
    Write { path, unit: unit.to_owned(), terms: terms.to_vec(), plus }
}

/// Difference below which two lengths are one [mm].
const SAME: f64 = 1e-6;

fn at(sliders: &[Slider], key: &str) -> Option<usize> {
    sliders.iter().position(|one| one.key == key)
}

/// A throat goes with the punch and has the clearance for its slider; a holder's opening, and a blank that is clamped there, go
/// with the throat and its shoulder.
fn couple(sliders: &mut Vec<Slider>, writes: &mut Vec<Write>) {
    clamp(sliders, writes);
    let (Some(punch), Some(throat)) = (at(sliders, PUNCH), at(sliders, THROAT)) else { return };
    let (radius, opening) = (&sliders[punch], &sliders[throat]);
    let gap = opening.value - radius.value;
    let both_are_halves = !radius.path.ends_with("diameter") && !opening.path.ends_with("diameter");
    // A throat far wider than its punch is a tool of another kind.
    if !both_are_halves || radius.unit != opening.unit || gap <= 0.0 || gap > 0.25 * radius.value {
        return;
    }
    writes.push(write(opening.path, &opening.unit, &[PUNCH, CLEARANCE], 0.0));
    for edge in writes.iter_mut().filter(|write| write.terms[0] == THROAT) {
        edge.terms = vec![PUNCH, CLEARANCE, SHOULDER];
    }
    sliders[throat] = Slider { key: CLEARANCE, path: "", value: gap, unit: sliders[throat].unit.clone(), range: GAP };
    let (Some(inner), Some(shoulder)) = (at(sliders, INNER), at(sliders, SHOULDER)) else { return };
    let (hole, corner) = (&sliders[inner], &sliders[shoulder]);
    if hole.unit == sliders[throat].unit && corner.unit == hole.unit {
        let plus = hole.value - sliders[punch].value - gap - corner.value;
        writes.push(write(hole.path, &hole.unit, &[PUNCH, CLEARANCE, SHOULDER], plus));
        sliders.remove(inner);
    }
}

/// A blank that ends where the die's shoulder does goes with it.
fn clamp(sliders: &mut Vec<Slider>, writes: &mut Vec<Write>) {
    let (Some(blank), Some(throat), Some(shoulder)) =
        (at(sliders, "blank"), at(sliders, THROAT), at(sliders, SHOULDER))
    else {
        return;
    };
    let (edge, opening, corner) = (&sliders[blank], &sliders[throat], &sliders[shoulder]);
    let is_there = (edge.value - opening.value - corner.value).abs() < SAME;
    if is_there && edge.unit == opening.unit && corner.unit == edge.unit {
        writes.push(write(edge.path, &edge.unit, &[THROAT, SHOULDER], 0.0));
        sliders.remove(blank);
    }
}

impl Known {
    fn find(&self, case: &Item) -> Option<Slider> {
        self.paths.iter().find_map(|path| {
            let item = path.split('.').try_fold(case, |item, key| item.get(key))?;
            let (value, unit) = number(item)?;
            (value > 0.0).then_some(Slider { key: self.key, path, value, unit, range: self.range })
        })
    }
}

/// A number and its unit, as they are written.
fn number(item: &Item) -> Option<(f64, String)> {
    if let Some(value) = item.as_float().or(item.as_integer().map(|whole| whole as f64)) {
        return Some((value, String::new()));
    }
    let text = item.as_str()?.trim();
    let end = text.find(|c: char| c.is_whitespace()).unwrap_or(text.len());
    let unit = text[end..].trim();
    Some((text[..end].parse().ok()?, unit.to_owned()))
}
