//! A case file written around tools that were drawn: their profiles, and declared placeholders for the rest.

use super::check::estimate::{siebel, tensile_strength};
use super::check::mm;
use super::measure::{extent, gap, shoulder_end, throat};
use super::template::rules::strip_pressure;
use super::template::{FRICTION, K, N, OFFSET};
use crate::geometry::{Piece, Point, Profile};
use crate::material::Hardening;
use crate::material::hardening::Swift;
use crate::model::{Geometry, Motion, Role, Tool};
use crate::quantity::{parse, rounded};
use std::fmt::Write;

/// Thickness where nothing else is said \[mm\].
const THICKNESS: f64 = 1.0;
/// Clearance over thickness that a placeholder thickness leaves [–].
const CLEARANCE: f64 = 1.25;
/// Clearance over thickness above which the thickness, or the drawing's unit, is doubted [–].
const WIDE: f64 = 3.0;
/// Largest draw ratio of a placeholder blank [–].
const RATIO: f64 = 1.8;
/// Travel over the punch's size [–], of a sheet that is drawn in and of one that is clamped and only stretched.
const TRAVEL: [f64; 2] = [0.5, 0.25];

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

/// A number of the case, and whether someone gave it.
struct Chosen {
    mm: f64,
    /// Where a placeholder comes from; `None` for what was asked for.
    placeholder: Option<&'static str>,
}

/// The placeholders' sizes, once the tools are known.
struct Sizes {
    thickness: Chosen,
    blank: Chosen,
    travel: Option<Chosen>,
}

impl Chosen {
    fn or(given: Option<f64>, placeholder: impl FnOnce() -> (f64, &'static str)) -> Self {
        match given {
            Some(mm) => Self { mm, placeholder: None },
            None => {
                let (mm, from) = placeholder();
                Self { mm, placeholder: Some(from) }
            }
        }
    }

    /// What stands behind the value.
    fn comment(&self) -> String {
        self.placeholder.map_or(String::new(), |from| format!("   # placeholder: {from}; change it"))
    }
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
        let punch = self.tool(Role::Punch).map(|punch| extent(&punch).1);
        let drawn = punch.filter(|punch| self.geometry == Geometry::Axisymmetric && sizes.blank.mm > *punch);
        let (pressure, rule) = match drawn {
            Some(punch) => {
                (siebel(sizes.blank.mm / punch, 2.0 * punch, sizes.thickness.mm, strength), "Siebel's pressure")
            }
            None => (strip_pressure(strength).value, "1 % of the tensile strength"),
        };
        (rounded(0.01 * (100.0 * pressure).ceil()), rule)
    }

    /// Throat less punch \[mm\].
    fn clearance(&self) -> Option<f64> {
        let (punch, die) = (self.tool(Role::Punch)?, self.tool(Role::Die)?);
        Some(throat(&die)? - extent(&punch).1)
    }

    /// How large the tools are, which shows a wrong unit at once: `punch radius 30 mm, die throat 31.25 mm, 180 mm wide in all`.
    pub fn size(&self) -> String {
        let half = match self.geometry {
            Geometry::Axisymmetric => "radius",
            Geometry::PlaneStrain => "half-width",
        };
        let tools: Vec<Tool> = Role::ALL.iter().filter_map(|role| self.tool(*role)).collect();
        let mut said: Vec<String> = tools
            .iter()
            .filter_map(|tool| match tool.role {
                Role::Punch => Some(format!("punch {half} {} mm", mm(extent(tool).1))),
                Role::Die => throat(tool).map(|throat| format!("die throat {half} {} mm", mm(throat))),
                Role::Holder => None,
            })
            .collect();
        let reach = tools.iter().map(|tool| extent(tool).1).fold(0.0, f64::max);
        said.push(format!("{} mm wide in all", mm(2.0 * reach)));
        said.join(", ")
    }

    /// What does not fit: a gap between punch and die that is wide for the sheet.
    pub fn doubt(&self) -> Option<String> {
        let (clearance, thickness) = (self.clearance()?, self.sizes().thickness);
        let placeholder = if thickness.placeholder.is_some() { ", a placeholder" } else { "" };
        (clearance > WIDE * thickness.mm).then(|| {
            format!(
                "the drawing leaves {} mm between punch and die, {:.1} times the sheet's thickness of {} mm{placeholder}: check \
                 --units and --thickness",
                mm(clearance),
                clearance / thickness.mm,
                mm(thickness.mm)
            )
        })
    }

    fn has(&self, role: Role) -> bool {
        self.tools.iter().any(|(tool, ..)| *tool == role)
    }

    fn tool(&self, role: Role) -> Option<Tool> {
        let (_, profile, _) = self.tools.iter().find(|(tool, ..)| *tool == role)?;
        Some(Tool { role, profile: (*profile).clone(), friction: 0.0.into(), motion: Motion::Fixed })
    }

    fn sizes(&self) -> Sizes {
        let (punch, die) = (self.tool(Role::Punch), self.tool(Role::Die));
        let thickness = Chosen::or(self.thickness, || {
            match self.clearance().map(|clearance| rounded((clearance / CLEARANCE * 100.0).floor() / 100.0)) {
                Some(fits) if fits > 0.0 && fits < THICKNESS => {
                    (fits, "what the gap between punch and die has room for")
                }
                _ => (THICKNESS, "the drawing has no sheet"),
            }
        });
        let blank = Chosen::or(self.blank, || self.blank_for(punch.as_ref(), die.as_ref()));
        let travel = punch
            .as_ref()
            .map(|punch| Chosen::or(self.travel, || travel_for(punch, die.as_ref(), thickness.mm, blank.mm)));
        Sizes { thickness, blank, travel }
    }

    /// As far as all of die and holder reach, but no more than is drawn in one draw.
    fn blank_for(&self, punch: Option<&Tool>, die: Option<&Tool>) -> (f64, &'static str) {
        let size = punch.map(|punch| extent(punch).1);
        let Some(die) = die else {
            return (rounded(1.2 * size.unwrap_or(50.0)), "a little more than the punch");
        };
        let holder = self.tool(Role::Holder);
        let reach = holder.map_or(f64::INFINITY, |holder| extent(&holder).1).min(extent(die).1);
        let down = |mm: f64| rounded((mm * 10.0).floor() / 10.0);
        match size.map(|size| down(RATIO * size)) {
            Some(drawn) if drawn < reach && drawn > shoulder_end(die) => (drawn, "1.8 times the punch"),
            _ => (down(reach), "as far as die and holder are drawn"),
        }
    }
}

/// The law that is written.
fn hardening() -> Hardening {
    let number = |text: &str| parse(text).expect("the law is well written").value;
    Hardening::Swift(Swift::new(number(K), number(N), number(OFFSET)).expect("the law is one"))
}

/// A share of the punch's size, or what its drawn height and the die's bottom leave room for.
fn travel_for(punch: &Tool, die: Option<&Tool>, thickness: f64, blank: f64) -> (f64, &'static str) {
    let height = (punch.profile.last().y - punch.profile.first().y).abs();
    let size = TRAVEL[usize::from(die.is_none())] * extent(punch).1;
    let most = if height > thickness { size.min(height) } else { size };
    // Both where they touch the flat sheet.
    let placed = |tool: &Tool, highest: bool, z: f64| {
        let touching = tool.profile.extreme(highest, blank).map_or(0.0, |p| p.y);
        Tool { profile: tool.profile.shifted(z - touching), ..tool.clone() }
    };
    let punch = placed(punch, true, -0.5 * thickness);
    let free = |travel: &f64| {
        die.is_none_or(|die| gap(&punch, &placed(die, false, 0.5 * thickness), *travel).distance >= thickness)
    };
    let digits = |mm: f64| rounded((mm * 10.0).floor() / 10.0).max(rounded(mm.min(0.1)));
    let share = (1..=20).rev().map(|i| digits(most * f64::from(i) / 20.0)).find(free);
    (share.unwrap_or_else(|| digits(most)), "a moderate one that the tools have room for")
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
