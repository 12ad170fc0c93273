//! A case file written around tools that were drawn: their profiles, and declared placeholders for the rest.

mod refused;
mod sizes;

use super::templates::rules::strip_pressure;
use super::templates::{FRICTION, K, N, OFFSET};
use crate::geometry::{Piece, Point, Profile};
use crate::material::Hardening;
use crate::material::hardening::Swift;
use crate::model::{Geometry, Role};
use crate::rules::estimate::{siebel, tensile_strength};
use crate::rules::tool_sizes::mouth;
use crate::units::{parse, rounded};
use sizes::Sizes;
use std::fmt::Write;

/// What a case file is written from.
#[derive(Clone, Debug, PartialEq)]
pub struct Draft<'a> {
    pub title: &'a str,
    pub geometry: Geometry,
    /// Sections in the order punch, die, holder, each with a line that says where it comes from.
    pub tools: Vec<(Role, &'a Profile, &'a str)>,
    /// Placeholders where `None` \[mm\].
    pub thickness: Option<f64>,
    /// Radius or half-length.
    pub blank: Option<f64>,
    pub travel: Option<f64>,
    /// How the drawing was understood, for comments at the top.
    pub notes: &'a [String],
}

impl Draft<'_> {
    /// The case file's text: TOML with comments, every placeholder marked and declared in `notes`.
    pub fn toml(&self) -> String {
        let sizes = self.sizes();
        let mut text = String::new();
        self.head(&sizes, &mut text);
        self.sheet(&sizes, &mut text);
        for (role, profile, made_of) in &self.tools {
            let _ = writeln!(text, "\n# {}\n[tools.{}]", comment(made_of), role.name());
            write_profile(profile, &mut text);
            let _ = writeln!(text, "friction = {FRICTION}   # placeholder: Coulomb's coefficient; change it");
            match (role, &sizes.travel) {
                (Role::Punch, Some(travel)) => {
                    let _ = writeln!(text, "travel = {}{}", quoted(travel.mm), travel.comment());
                }
                (Role::Holder, _) => {
                    let (pressure, rule) = self.pressure(&sizes);
                    let _ = writeln!(
                        text,
                        "# placeholder: {rule}, on the area between holder and die; change it, or give a force\npressure = \"{pressure} MPa\""
                    );
                }
                _ => {}
            }
        }
        if !self.has(Role::Punch) {
            let _ = writeln!(
                text,
                "\n# No punch is drawn. Add one, for example:\n# [tools.punch]\n\
                 # flat = {{ radius = \"30 mm\", nose = \"6 mm\" }}\n# friction = {FRICTION}\n# travel = \"10 mm\""
            );
        }
        text
    }

    fn head(&self, sizes: &Sizes, text: &mut String) {
        *text += "# Written by `stampflow import`: the tools are as drawn, what is marked as placeholder is not in the drawing.\n";
        for note in self.notes {
            let _ = writeln!(text, "# - {}", comment(note));
        }
        let title: String = self.title.chars().filter(|c| !c.is_control()).take(150).collect();
        let geometry = match self.geometry {
            Geometry::Axisymmetric => "axisymmetric",
            Geometry::PlaneStrain => "plane_strain",
        };
        let _ = writeln!(text, "\ntitle = {}\ngeometry = \"{geometry}\"", toml_edit::Value::from(title));
        let mut open = vec!["material", "friction"];
        open.extend(sizes.thickness.placeholder.map(|_| "thickness"));
        open.extend(sizes.blank.placeholder.map(|_| "blank"));
        open.extend(sizes.travel.as_ref().and_then(|travel| travel.placeholder).map(|_| "travel"));
        open.extend(self.has(Role::Holder).then_some("holder pressure"));
        *text += "notes = [\n    \"declared: the tools' sections are those of the drawing\",\n";
        let _ = writeln!(text, "    \"declared: placeholders, not in the drawing: {}\",\n]", open.join(", "));
    }

    fn sheet(&self, sizes: &Sizes, text: &mut String) {
        let length = match self.geometry {
            Geometry::Axisymmetric => "radius",
            Geometry::PlaneStrain => "half_length",
        };
        let Sizes { thickness, blank, .. } = sizes;
        let _ = writeln!(text, "\n[blank]\n{length} = {}{}", quoted(blank.mm), blank.comment());
        let _ = writeln!(text, "thickness = {}{}", quoted(thickness.mm), thickness.comment());
        if !self.has(Role::Die) {
            *text += "edge = \"clamped\"   # placeholder: no die is drawn that the blank could rest on\n";
        }
        let _ = writeln!(
            text,
            "\n# placeholder: typical of mild deep-drawing steel; change it, or name one of `stampflow materials`.\n\
             # σ = k (offset + ε)^n\n[material.hardening.swift]\nk = \"{K}\"\nn = {N}\noffset = {OFFSET}"
        );
    }

    /// The holder's pressure \[MPa\], rounded up, and its rule: Siebel's for a blank that is drawn in round an axis.
    fn pressure(&self, sizes: &Sizes) -> (f64, &'static str) {
        let strength = tensile_strength(&hardening());
        let travel = sizes.travel.as_ref().map_or(0.0, |travel| travel.mm);
        let punch = self.tool(Role::Punch).map(|punch| mouth(&punch, travel));
        let drawn = punch.filter(|punch| self.geometry == Geometry::Axisymmetric && sizes.blank.mm > *punch);
        let (pressure, rule) = match drawn {
            Some(punch) => {
                (siebel(sizes.blank.mm / punch, 2.0 * punch, sizes.thickness.mm, strength), "Siebel's pressure")
            }
            None => (strip_pressure(strength).value, "1 % of the tensile strength"),
        };
        (rounded(0.01 * (100.0 * pressure).ceil()), rule)
    }

    fn has(&self, role: Role) -> bool {
        self.tools.iter().any(|(tool, ..)| *tool == role)
    }
}

/// The law that is written.
fn hardening() -> Hardening {
    let number = |text: &str| parse(text).expect("the law is well written").value;
    Hardening::Swift(Swift::new(number(K), number(N), number(OFFSET)).expect("the law is one"))
}

/// A profile as steps.
fn write_profile(profile: &Profile, text: &mut String) {
    *text += "profile = [\n";
    let _ = writeln!(text, "    {{ from = {} }},", point(profile.first()));
    for piece in profile.pieces() {
        let end = point(piece.last());
        let _ = match piece {
            Piece::Segment(_) => writeln!(text, "    {{ to = {end} }},"),
            Piece::Arc(arc) => {
                let turn = if arc.sweep > 0.0 { "left" } else { "right" };
                writeln!(text, "    {{ arc_to = {end}, center = {}, turn = \"{turn}\" }},", point(arc.center))
            }
        };
    }
    *text += "]\n";
}

fn point(p: Point) -> String {
    format!("[{}, {}]", quoted(p.x), quoted(p.y))
}

/// A length to a millionth of a micrometre: `"30.5 mm"`.
fn quoted(mm: f64) -> String {
    let text = format!("{:.9}", (mm * 1e9).round() / 1e9 + 0.0);
    format!("\"{} mm\"", text.trim_end_matches('0').trim_end_matches('.'))
}

/// A text that may stand in a comment.
fn comment(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).collect()
}
