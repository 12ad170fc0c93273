//! Text of a case file: a template with placeholders, filled with values and the reason beside each.

pub mod redraw;

use crate::forming_limit::{Kind, Sheet};
use crate::geometry::{Piece, Point, Profile};
use crate::material::{Material, flow::ROOM_TEMPERATURE};
use crate::rules::Picked;
use crate::units::{joined, trimmed};
use std::{collections::BTreeMap, fmt::Display};

/// Longest line \[characters\]; a comment that does not fit stands above its line.
const WIDTH: usize = 100;
const RADII: [&str; 3] = ["radius", "throat", "inner_radius"];

/// End of a step of a profile, and of an arc its centre and whether it turns left.
pub type Step = (Point, Option<(Point, bool)>);

/// Value as TOML and reason of each placeholder of a template.
#[derive(Clone, Default)]
pub struct Values(BTreeMap<String, (String, String)>);

impl Values {
    pub fn set(&mut self, name: &str, value: impl Display, why: &str) {
        self.0.insert(name.to_owned(), (value.to_string(), why.to_owned()));
    }

    pub fn set_text(&mut self, name: &str, text: &str) {
        (!text.is_empty()).then(|| self.set(name, text, ""));
    }

    pub fn lengths<const N: usize>(&mut self, lengths: [(&str, &Picked); N]) {
        lengths.into_iter().for_each(|(name, picked)| self.set(name, mm(picked.value), &picked.why));
    }

    pub fn drop(&mut self, names: &[&str]) {
        self.0.retain(|name, _| !names.contains(&name.as_str()));
    }

    /// Sets Swift's law: k \[MPa\], n and offset strain \[–\].
    pub fn swift(&mut self, [k, n, offset]: [f64; 3]) {
        self.set("k", format!("\"{k} MPa\""), "");
        self.set("n", n, "");
        self.set("offset", offset, "");
    }

    /// Text of the case: lines with a missing value and paragraphs `<if NAME>` without one are left out.
    pub fn fill(&self, template: &str) -> String {
        let (mut text, is_round) = (String::new(), template.contains("\ngeometry = \"axisymmetric\""));
        for paragraph in template.split("\n\n") {
            let condition = paragraph.strip_prefix("<if ").and_then(|rest| rest.split_once(">\n"));
            let (name, paragraph) = condition.unwrap_or(("", paragraph));
            if condition.is_some() && !self.0.contains_key(name) {
                continue;
            }
            for line in paragraph.lines() {
                let Some((filled, why)) = self.line(line, is_round) else { continue };
                let last = filled.lines().last().unwrap_or_default();
                text += &match filled.strip_prefix("# ").filter(|_| line.starts_with("# ")) {
                    Some(remark) => comment(remark),
                    None if why.is_empty() => filled + "\n",
                    None if last.chars().count() + 3 + why.chars().count() <= WIDTH => format!("{filled}   # {why}\n"),
                    None => comment(&why) + &filled + "\n",
                };
            }
            text.push('\n');
        }
        text.trim().to_owned() + "\n"
    }

    fn line(&self, line: &str, is_round: bool) -> Option<(String, String)> {
        let (mut filled, mut reasons, mut parts) = (String::new(), Vec::new(), line.split('<'));
        filled += parts.next()?;
        for part in parts {
            let (name, rest) = part.split_once('>')?;
            let (value, why) = self.0.get(name)?;
            filled.extend([value, rest]);
            reasons.push(why.as_str());
        }
        let is_radius = line.split_once(" = <").is_some_and(|(key, _)| is_round && RADII.contains(&key));
        let radius = filled.split('"').nth(1).and_then(|text| text.strip_suffix(" mm")?.parse::<f64>().ok());
        let diameter = radius.filter(|_| is_radius).map(|radius| format!("Ø {}", plain(2.0 * radius)));
        reasons.insert(0, diameter.as_deref().unwrap_or(""));
        Some((filled, joined(reasons, ", ")))
    }
}

/// A comment, wrapped; control characters are left out.
pub fn comment(text: &str) -> String {
    let (mut lines, mut length) = (String::from("#"), 1);
    for word in text.split_whitespace() {
        let letters = word.chars().count();
        let begin = if length + 1 + letters > WIDTH { "\n# " } else { " " };
        length = if begin == " " { length + 1 + letters } else { 2 + letters };
        lines += begin;
        lines.extend(word.chars().filter(|c| !c.is_control()));
    }
    lines + "\n"
}

/// Remark on the forming limit: the library's measured points, a computed curve, or none.
pub fn forming_limit(material: &Material, thickness: f64, is_measured: bool) -> String {
    let sheet = Sheet { material, thickness, temperature: ROOM_TEMPERATURE };
    let limit = match Kind::usual(&sheet) {
        _ if is_measured => "measured on the library's sheet".to_owned(),
        Ok(curve) => format!("{}, computed, not measured", curve.name),
        Err(error) => format!("none, for {}", error.message),
    };
    let coil = "Points of your coil: [forming_limit] points = [[-0.2, 0.5], ...] and strain = \"logarithmic\".";
    comment(&format!("Forming limit: {limit}. {coil}")).trim().to_owned()
}

pub fn drawn_profile(profile: &Profile) -> String {
    let arc = |piece: &Piece| if let Piece::Arc(arc) = piece { Some((arc.center, arc.sweep > 0.0)) } else { None };
    let steps: Vec<Step> = profile.pieces().iter().map(|piece| (piece.last(), arc(piece))).collect();
    profile_text(profile.first(), &steps, exact)
}

/// Steps of a profile as TOML, lengths written by `length`.
pub fn profile_text(start: Point, steps: &[Step], length: fn(f64) -> String) -> String {
    let point = |p: &Point| format!("[{}, {}]", length(p.x), length(p.y));
    let step = |(end, arc): &Step| match (point(end), arc) {
        (end, None) => format!("    {{ to = {end} }},\n"),
        (end, Some((center, left))) => {
            let (center, turn) = (point(center), if *left { "left" } else { "right" });
            format!("    {{ arc_to = {end}, center = {center}, turn = \"{turn}\" }},\n")
        }
    };
    format!("[\n    {{ from = {} }},\n{}]", point(&start), steps.iter().map(step).collect::<String>())
}

/// Punch as TOML by wall, corner and depth, hollow (radius at half depth, depth) and slope (radius, width), all \[mm\].
pub fn recessed_punch([wall, nose, end]: [f64; 3], [at, depth]: [f64; 2], [bend, width]: [f64; 2]) -> String {
    let [from, to, flat] = [at - 0.5 * width, at + 0.5 * width, wall - nose];
    let arc = |x: f64, y: f64, center: [f64; 2], left: bool| (Point::new(x, y), Some((Point::from(center), left)));
    let steps = [
        (Point::new(from, -depth), None),
        arc(at, -0.5 * depth, [from, bend - depth], true),
        arc(to, 0.0, [to, -bend], false),
        (Point::new(flat, 0.0), None),
        arc(wall, -nose, [flat, -nose], false),
        (Point::new(wall, -end), None),
    ];
    format!("profile = {}", profile_text(Point::new(0.0, -depth), &steps, mm))
}

pub fn plain(length: f64) -> String {
    format!("{} mm", trimmed(length, 3))
}

/// Length as TOML, to a micrometre.
pub fn mm(length: f64) -> String {
    format!("\"{}\"", plain(length))
}

/// Length as TOML, to a picometre: `"30.5 mm"`.
pub fn exact(length: f64) -> String {
    format!("\"{} mm\"", trimmed(length, 9))
}
