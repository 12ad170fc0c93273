//! The text of a case file as it grows: tables, keys, and a comment for every number that was picked.

use crate::assess::design::Picked;
use crate::forming_limit::{Hill, Kind, Sheet};
use crate::geometry::{Piece, Point, Profile};
use crate::material::Material;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::model::Geometry;
use crate::units::trimmed;
use std::fmt::{Display, Write};

/// A comment that would make its line longer than this stands above it \[characters\].
const WIDE: usize = 100;

/// A case file being written.
pub(super) struct Page {
    text: String,
    /// Whether the part is round: sizes are then also said as diameters.
    is_round: bool,
}

/// What is said of the forming limit.
const LIMIT: &str = "Where the sheet necks, computed from the hardening law: Hill's localised necking on the left, Swift's \
                     diffuse necking on the right. Measured points of the coil should replace it: points = [[-0.2, 0.5], ...] and \
                     strain = \"logarithmic\".";

/// Keys of a round part that are half of what shops measure.
const HALVES: [&str; 3] = ["radius", "throat", "inner_radius"];

impl Page {
    /// Begins with comments on the case as a whole, its title, its geometry and what is declared.
    pub fn new<T: AsRef<str>>(
        about: impl IntoIterator<Item = T>,
        title: &str,
        geometry: Geometry,
        notes: &[String],
    ) -> Self {
        let is_round = geometry == Geometry::Axisymmetric;
        let geometry = geometry.key();
        let mut page = Self { text: String::new(), is_round };
        about.into_iter().for_each(|text| page.comment(text.as_ref()));
        let _ = writeln!(page.text, "\ntitle = {}\ngeometry = {geometry:?}\nnotes = [", toml_edit::Value::from(title));
        for note in notes {
            let _ = writeln!(page.text, "    {},", toml_edit::Value::from(note));
        }
        page.text.push_str("]\n");
        page
    }

    /// A comment, wrapped into lines; characters that may not stand in one are left out.
    pub fn comment(&mut self, text: &str) {
        let mut line = String::from("#");
        for word in text.split_whitespace() {
            if line.chars().count() + 1 + word.chars().count() > WIDE {
                let _ = writeln!(self.text, "{line}");
                line = String::from("#");
            }
            line.push(' ');
            line.extend(word.chars().filter(|c| !c.is_control()));
        }
        let _ = writeln!(self.text, "{line}");
    }

    /// Lines for someone to uncomment.
    pub fn proposal(&mut self, lines: &[&str]) {
        self.text.push('\n');
        lines.iter().for_each(|line| self.comment(line));
    }

    /// Begins a table, `tools.punch` or `[stages]`, with a comment above it where there is one.
    pub fn table(&mut self, name: &str, why: &str) {
        self.text.push('\n');
        if !why.is_empty() {
            self.comment(why);
        }
        let _ = writeln!(self.text, "[{name}]");
    }

    /// A key and its value as TOML, with why it is so.
    pub fn set(&mut self, key: &str, value: impl Display, why: &str) {
        let line = format!("{key} = {value}");
        if why.is_empty() {
            let _ = writeln!(self.text, "{line}");
        } else if line.chars().count() + 3 + why.chars().count() <= WIDE {
            let _ = writeln!(self.text, "{line}   # {why}");
        } else {
            self.comment(why);
            let _ = writeln!(self.text, "{line}");
        }
    }

    /// A picked length.
    pub fn length(&mut self, key: &str, picked: &Picked) {
        let diameter = across(picked.value, if self.is_round { key } else { "" });
        let parts = [diameter.as_str(), &picked.why].into_iter().filter(|part| !part.is_empty());
        self.set(key, mm(picked.value), &parts.collect::<Vec<_>>().join(", "));
    }

    /// `[material.hardening.swift]`: k \[MPa\], n and offset strain \[–\].
    pub fn swift(&mut self, law: [f64; 3], why: &str) {
        let [k, n, offset] = law;
        self.table("material.hardening.swift", why);
        self.set("k", format!("\"{k} MPa\""), "");
        self.set("n", n, "");
        self.set("offset", offset, "");
    }

    /// `[forming_limit]` of a sheet \[mm\] that is drawn or stretched, where its hardening law gives one, or as it was
    /// `measured` on the sheet of the library that the case names.
    pub fn forming_limit(&mut self, material: &Material, thickness: f64, measured: bool) {
        if measured {
            self.table("forming_limit", "Points measured on the library's sheet, to be replaced by those of the coil.");
            self.set("measured", true, "");
            return;
        }
        let sheet = Sheet { material, thickness, temperature: ROOM_TEMPERATURE };
        if Kind::Hill(Hill { n: None }).curve(&sheet).is_err() {
            self.comment(
                "No [forming_limit]: this hardening law has no load maximum; give measured points of the coil.",
            );
            return;
        }
        self.table("forming_limit", LIMIT);
        self.set("hill", true, "");
    }

    /// A profile as steps.
    pub fn profile(&mut self, profile: &Profile) {
        let mut steps = format!("[\n    {{ from = {} }},\n", point(profile.first()));
        for piece in profile.pieces() {
            let end = point(piece.last());
            let _ = match piece {
                Piece::Segment(_) => writeln!(steps, "    {{ to = {end} }},"),
                Piece::Arc(arc) => {
                    let turn = if arc.sweep > 0.0 { "left" } else { "right" };
                    writeln!(steps, "    {{ arc_to = {end}, center = {}, turn = \"{turn}\" }},", point(arc.center))
                }
            };
        }
        self.set("profile", steps + "]", "");
    }

    pub fn text(self) -> String {
        self.text
    }
}

/// The diameter that belongs to a key of a round part, as a comment has it; nothing for other keys.
pub(super) fn across(half: f64, key: &str) -> String {
    if HALVES.contains(&key) { format!("Ø {}", plain(2.0 * half)) } else { String::new() }
}

/// The key of a blank's size.
pub(super) fn size_key(geometry: Geometry) -> &'static str {
    match geometry {
        Geometry::Axisymmetric => "radius",
        Geometry::PlaneStrain => "half_length",
    }
}

/// A length as a sentence has it.
pub(super) fn plain(length: f64) -> String {
    format!("{} mm", trimmed(length, 3))
}

/// A length as a case file has it.
pub(super) fn mm(length: f64) -> String {
    format!("\"{}\"", plain(length))
}

/// A length as it was drawn, to a millionth of a micrometre: `"30.5 mm"`.
pub(super) fn exact(length: f64) -> String {
    format!("\"{} mm\"", trimmed(length, 9))
}

fn point(p: Point) -> String {
    format!("[{}, {}]", exact(p.x), exact(p.y))
}
