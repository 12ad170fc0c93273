//! Sliders of a case, and the keys that move along: a die's throat goes with the punch, because the clearance stays.

use serde::Serialize;
use toml_edit::{DocumentMut, Item};

/// Numbers with a slider: key, label, the paths where it may stand, and its range over the number of the case \[–\].
const KNOWN: &[(&str, &str, &str, [f64; 2])] = &[
    ("blank", "Blank", "blank.radius blank.half_length blank.diameter blank.length", [0.8, 1.25]),
    ("thickness", "Sheet thickness", "blank.thickness", [0.5, 1.6]),
    (
        "punch_radius",
        "Punch",
        "tools.punch.flat.radius tools.punch.flat.half_width tools.punch.hemispherical.radius tools.punch.flat.diameter tools.punch.hemispherical.diameter",
        [0.8, 1.2],
    ),
    ("nose", "Punch nose radius", "tools.punch.flat.nose", [0.5, 2.0]),
    ("throat", "Die opening", "tools.die.throat tools.die.throat_diameter", [0.95, 1.2]),
    ("shoulder", "Die shoulder radius", "tools.die.shoulder", [0.5, 2.0]),
    ("inner_radius", "Holder opening", "tools.holder.inner_radius tools.holder.inner_half_width", [0.95, 1.2]),
    ("holder_force", "Holder force", "tools.holder.force", [0.0, 4.0]),
    ("holder_pressure", "Holder pressure", "tools.holder.pressure", [0.0, 4.0]),
    ("travel", "Punch travel", "tools.punch.travel", [0.2, 1.2]),
    ("friction", "Friction", "tools.punch.friction tools.die.friction", [0.0, 3.0]),
    ("k", "Hardening k", "material.hardening.swift.k material.hardening.hollomon.k", [0.5, 2.0]),
    ("n", "Hardening n", "material.hardening.swift.n material.hardening.hollomon.n", [0.4, 1.6]),
    ("elements", "Elements", "blank.elements", [0.15, 1.5]),
];
/// Range of the clearance over its value \[–\].
const GAP: [f64; 2] = [0.8, 2.0];
/// Largest clearance of a punch and its die over the punch's radius \[–\].
const WIDEST: f64 = 0.25;
/// Difference below which two lengths are one \[mm\].
const SAME: f64 = 1e-6;

/// A number of the case that moves.
#[derive(Clone, Serialize)]
struct Slider {
    key: &'static str,
    label: &'static str,
    #[serde(skip)]
    path: &'static str,
    value: f64,
    /// Empty for a plain number.
    unit: String,
    low: f64,
    high: f64,
}

/// A path of the case that is set to the sum of some sliders and a constant.
#[derive(Serialize)]
struct Write {
    path: &'static str,
    unit: String,
    terms: Vec<&'static str>,
    plus: f64,
    #[serde(rename = "isWhole")]
    is_whole: bool,
}

/// Sliders and the paths that they write.
#[derive(Default, Serialize)]
pub struct Sliders {
    sliders: Vec<Slider>,
    writes: Vec<Write>,
}

impl Slider {
    fn new([key, label, path]: [&'static str; 3], (value, unit): (f64, String), [low, high]: [f64; 2]) -> Self {
        Self { key, label, path, value, unit, low: low * value, high: high * value }
    }
}

impl Sliders {
    /// Sliders of a case's text.
    pub fn of_case(text: &str) -> Self {
        let Ok(document) = text.parse::<DocumentMut>() else { return Self::default() };
        let find = |&(key, label, paths, range): &(&'static str, &'static str, &'static str, [f64; 2])| {
            paths.split(' ').find_map(|path| {
                let item = path.split('.').try_fold(document.as_item(), |item, key| item.get(key))?;
                let value = number(item).filter(|(value, _)| *value > 0.0)?;
                Some(Slider::new([key, label, path], value, range))
            })
        };
        let mut all = Self { sliders: KNOWN.iter().filter_map(find).collect(), writes: Vec::new() };
        all.couple_blank();
        all.couple_throat();
        for slider in all.sliders.clone() {
            // The key `friction` sets every tool's.
            let path = if slider.key == "friction" { "friction" } else { slider.path };
            if !path.is_empty() && all.writes.iter().all(|write| write.path != path) {
                all.write(&slider, path, &[slider.key], 0.0);
            }
        }
        all
    }

    fn write(&mut self, slider: &Slider, path: &'static str, terms: &[&'static str], plus: f64) {
        let (unit, is_whole) = (slider.unit.clone(), *terms == ["elements"]);
        self.writes.push(Write { path, unit, terms: terms.to_vec(), plus, is_whole });
    }

    /// The sliders of some keys, if all are there in one unit.
    fn all<const N: usize>(&self, keys: [&str; N]) -> Option<[Slider; N]> {
        let found = keys.map(|key| self.sliders.iter().find(|one| one.key == key).cloned());
        let sliders: Vec<Slider> = found.into_iter().collect::<Option<_>>()?;
        sliders.iter().all(|one| one.unit == sliders[0].unit).then(|| sliders.try_into().ok())?
    }

    /// A blank that ends where the die's shoulder does goes with it.
    fn couple_blank(&mut self) {
        let Some([blank, throat, shoulder]) = self.all(["blank", "throat", "shoulder"]) else { return };
        if (blank.value - throat.value - shoulder.value).abs() < SAME {
            self.write(&blank, blank.path, &["throat", "shoulder"], 0.0);
            self.sliders.retain(|one| one.key != "blank");
        }
    }

    /// A throat goes with the punch and has the clearance for its slider; the holder's opening goes with both and the shoulder.
    fn couple_throat(&mut self) {
        let Some([punch, throat]) = self.all(["punch_radius", "throat"]) else { return };
        let gap = throat.value - punch.value;
        let has_diameter = [&punch, &throat].iter().any(|one| one.path.ends_with("diameter"));
        if has_diameter || gap <= 0.0 || gap > WIDEST * punch.value {
            return;
        }
        for edge in self.writes.iter_mut().filter(|write| write.terms[0] == "throat") {
            edge.terms = vec!["punch_radius", "clearance", "shoulder"];
        }
        self.write(&throat, throat.path, &["punch_radius", "clearance"], 0.0);
        if let Some([_, hole, corner]) = self.all(["throat", "inner_radius", "shoulder"]) {
            let plus = hole.value - throat.value - corner.value;
            self.write(&hole, hole.path, &["punch_radius", "clearance", "shoulder"], plus);
            self.sliders.retain(|one| one.key != "inner_radius");
        }
        let clearance = Slider::new(["clearance", "Clearance", ""], (gap, throat.unit.clone()), GAP);
        self.sliders.iter_mut().filter(|one| one.key == "throat").for_each(|one| *one = clearance.clone());
    }
}

/// A number and its unit.
fn number(item: &Item) -> Option<(f64, String)> {
    if let Some(value) = item.as_float().or(item.as_integer().map(|whole| whole as f64)) {
        return Some((value, String::new()));
    }
    let text = item.as_str()?.trim();
    let end = text.find(char::is_whitespace).unwrap_or(text.len());
    Some((text[..end].parse().ok()?, text[end..].trim().to_owned()))
}
