//! Text of a case file: tables, keys, and the reason beside each picked number.

use crate::forming_limit::{Hill, Kind, Sheet};
use crate::geometry::{Piece, Point, Profile};
use crate::material::Material;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::units::trimmed;
use std::fmt::{Display, Write};

/// Longest line \[characters\]; a comment that does not fit stands above its line.
const WIDTH: usize = 100;

/// Keys of a round part that shops measure as diameters.
pub(super) const RADII: [&str; 3] = ["radius", "throat", "inner_radius"];

/// End of a step of a profile, and of an arc its centre and whether it turns left.
pub(super) type Step = (Point, Option<(Point, bool)>);

const LIMIT: &str = "Necking computed from the hardening law (Hill, Swift). Replace it by measured points of your coil: points = \
                     [[-0.2, 0.5], ...] and strain = \"logarithmic\".";

/// A case file being written.
#[derive(Default)]
pub(super) struct CaseWriter(String);

impl CaseWriter {
    /// A comment, wrapped; control characters are left out.
    pub fn comment(&mut self, text: &str) {
        let mut line = String::from("#");
        for word in text.split_whitespace() {
            if line.chars().count() + 1 + word.chars().count() > WIDTH {
                let _ = writeln!(self.0, "{line}");
                line = String::from("#");
            }
            line.push(' ');
            line.extend(word.chars().filter(|c| !c.is_control()));
        }
        let _ = writeln!(self.0, "{line}");
    }

    /// Writes a line and its reason.
    pub fn line(&mut self, line: &str, why: &str) {
        let last = line.lines().last().unwrap_or_default();
        let is_short = last.chars().count() + 3 + why.chars().count() <= WIDTH;
        if !why.is_empty() && !is_short {
            self.comment(why);
        }
        let beside = if why.is_empty() || !is_short { String::new() } else { format!("   # {why}") };
        let _ = writeln!(self.0, "{line}{beside}");
    }

    /// Begins a table such as `tools.punch` or `[stages]`.
    pub fn table(&mut self, name: &str, why: &str) {
        self.0.push('\n');
        if !why.is_empty() {
            self.comment(why);
        }
        let _ = writeln!(self.0, "[{name}]");
    }

    /// Writes a key, its value as TOML and the reason.
    pub fn set(&mut self, key: &str, value: impl Display, why: &str) {
        self.line(&format!("{key} = {value}"), why);
    }

    /// Writes Swift's law: k \[MPa\], n and offset strain \[–\].
    pub fn swift(&mut self, [k, n, offset]: [f64; 3], why: &str) {
        self.table("material.hardening.swift", why);
        self.set("k", format!("\"{k} MPa\""), "");
        self.set("n", n, "");
        self.set("offset", offset, "");
    }

    /// Writes the forming limit: measured points of the library, or Hill's where the law has a load maximum.
    pub fn forming_limit(&mut self, material: &Material, thickness: f64, is_measured: bool) {
        let sheet = Sheet { material, thickness, temperature: ROOM_TEMPERATURE };
        if is_measured {
            self.table("forming_limit", "Measured on the library's sheet; replace them by points of your coil.");
            self.set("measured", true, "");
        } else if Kind::Hill(Hill { n: None }).curve(&sheet).is_ok() {
            self.table("forming_limit", LIMIT);
            self.set("hill", true, "");
        } else {
            self.comment(
                "No [forming_limit]: the hardening law has no load maximum. Give measured points of your coil.",
            );
        }
    }

    /// Writes a profile as it was drawn.
    pub fn profile(&mut self, profile: &Profile) {
        let step = |piece: &Piece| {
            let arc = if let Piece::Arc(arc) = piece { Some((arc.center, arc.sweep > 0.0)) } else { None };
            (piece.last(), arc)
        };
        let steps: Vec<Step> = profile.pieces().iter().map(step).collect();
        self.set("profile", profile_text(profile.first(), &steps, exact), "");
    }

    /// The text of the case file.
    pub fn text(self) -> String {
        self.0.trim().to_owned() + "\n"
    }
}

/// Steps of a profile as TOML, lengths written by `length`.
pub(super) fn profile_text(start: Point, steps: &[Step], length: fn(f64) -> String) -> String {
    let point = |p: &Point| format!("[{}, {}]", length(p.x), length(p.y));
    let mut text = format!("[\n    {{ from = {} }},\n", point(&start));
    for (end, arc) in steps {
        let end = point(end);
        let _ = match arc {
            None => writeln!(text, "    {{ to = {end} }},"),
            Some((center, left)) => {
                let (center, turn) = (point(center), if *left { "left" } else { "right" });
                writeln!(text, "    {{ arc_to = {end}, center = {center}, turn = \"{turn}\" }},")
            }
        };
    }
    text + "]"
}

/// Joins those reasons that are not empty.
pub(super) fn joined(reasons: &[&str]) -> String {
    reasons.iter().filter(|reason| !reason.is_empty()).copied().collect::<Vec<_>>().join(", ")
}

/// Length for a sentence.
pub(super) fn plain(length: f64) -> String {
    format!("{} mm", trimmed(length, 3))
}

/// Length as TOML, to a micrometre.
pub(super) fn mm(length: f64) -> String {
    format!("\"{}\"", plain(length))
}

/// Length as TOML, to a picometre: `"30.5 mm"`.
pub(super) fn exact(length: f64) -> String {
    format!("\"{} mm\"", trimmed(length, 9))
}
