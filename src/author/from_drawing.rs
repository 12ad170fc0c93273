//! A case file around tools that were drawn: their profiles, and declared placeholders for the rest.

mod sizes;

use super::templates::rules::{Picked, siebel, strip_pressure, tensile_strength};
use super::templates::{FRICTION, typical};
use super::writer::{Values, comment, drawn_profile, exact, forming_limit};
use crate::assess::size_doubts;
use crate::case::{self, Case, CaseError, library};
use crate::import::{self, ImportError, Options, Section, Sections};
use crate::material::hardening::Swift;
use crate::material::{Hardening, Material};
use crate::model::tool_sizes::{extent, mouth, throat};
use crate::model::{Extent, Geometry, Role};
use crate::units::rounded;
use sizes::DrawnTools;
use std::path::Path;

/// How a drawing is read, and what is known besides it.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// Options of the reader.
    pub options: Options,
    /// Axisymmetric or plane strain.
    pub geometry: Geometry,
    /// Sheet of the library, by its name or a grade; a placeholder where `None`.
    pub material: Option<String>,
    /// Thickness of the sheet \[mm\]; a placeholder where `None`.
    pub thickness: Option<f64>,
    /// Radius or half-length \[mm\]; a placeholder where `None`.
    pub blank: Option<f64>,
    /// Travel of the punch \[mm\]; a placeholder where `None`.
    pub travel: Option<f64>,
}

/// A case made from a drawing.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The tools as they are drawn.
    pub sections: Sections,
    /// Text of the case file.
    pub text: String,
    /// The case; `None` where no punch is drawn, so that the user has to give one.
    pub case: Option<Case>,
    /// Sizes of the tools, in words.
    pub size: String,
    /// How the drawing was understood, what the case derives from it, and doubts.
    pub notes: Vec<String>,
}

/// Reason why no case is made from a drawing.
#[derive(Debug, thiserror::Error)]
pub enum ImportFailure {
    /// The drawing cannot be read.
    #[error(transparent)]
    Drawing(#[from] ImportError),
    /// The library has no such sheet.
    #[error(transparent)]
    Sheet(CaseError),
    /// The tools make no case.
    #[error(transparent)]
    Case(CaseError),
}

impl Import {
    /// Makes a case of the bytes of a DXF file.
    ///
    /// # Errors
    /// When the drawing cannot be read, the sheet is unknown, or the tools make no case.
    pub fn read(&self, bytes: &[u8], drawing: &Path) -> Result<Imported, ImportFailure> {
        let sections = import::read(bytes, &self.options)?;
        let metal = match self.material.as_deref().map(library::material).transpose().map_err(ImportFailure::Sheet)? {
            Some(entry) => entry.material,
            None => {
                let [k, n, offset] = typical();
                Material::plain(Hardening::Swift(Swift::new(k, n, offset).expect("the law is one")))
            }
        };
        let tools = DrawnTools::new(self, sections.first.tools.iter().collect());
        let (size, doubts) = (tools.size(), tools.doubts());
        let text = self.text(drawing, &sections, &tools, &metal);
        let case = self.case(&text, &drawing.display().to_string(), &tools).map_err(ImportFailure::Case)?;
        let mut notes = sections.notes.clone();
        if let Some(case) = &case {
            // A doubt of the drawing is the cause of those of the case.
            if doubts.is_empty() {
                notes.extend(size_doubts(case));
            }
            notes.extend(case.derived.iter().map(ToString::to_string));
        }
        notes.extend(doubts);
        Ok(Imported { sections, text, case, size, notes })
    }

    /// The case of a text, `None` without a punch; errors name the drawing and the option.
    fn case(&self, text: &str, drawing: &str, tools: &DrawnTools) -> Result<Option<Case>, CaseError> {
        if tools.tool(Role::Die).is_none() {
            let what = format!("no die in {drawing}: nothing would draw the sheet over the punch");
            return Err(CaseError::bare(what, "name its layer with --layer NAME=die".to_owned()));
        }
        if tools.tool(Role::Punch).is_none() {
            return Ok(None);
        }
        case::parse(text, drawing, &[]).map(Some).map_err(|error| {
            let place = match error.key() {
                "tools.punch.travel" => Some("set it with --travel".to_owned()),
                "blank.thickness" => Some("set it with --thickness".to_owned()),
                "blank.radius" | "blank.half_length" => Some("set it with --blank-radius".to_owned()),
                key => tools.sections.iter().find_map(|section| {
                    let is_here = key.split('.').take(2).eq(["tools", section.role.name()]);
                    is_here.then(|| format!("it is drawn in {}, r is x from the axis", section.made_of))
                }),
            };
            let help: Vec<String> =
                error.remedy().map(str::to_owned).into_iter().chain(place).chain(tools.doubts()).collect();
            let what = format!("the case made from {drawing} is refused, and no file is written: {error}");
            CaseError::bare(what, help.join("; "))
        })
    }

    fn text(&self, drawing: &Path, sections: &Sections, first: &DrawnTools, metal: &Material) -> String {
        let sizes = first.sizes();
        let mut values = tool_values(&sections.first.tools);
        let notes: String = sections.notes.iter().map(|note| comment(&format!("- {note}"))).collect();
        values.set("notes", notes.trim_end(), "");
        let name = drawing.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let title: String = format!("Tools of {name}").chars().filter(|c| !c.is_control()).take(150).collect();
        values.set("title", toml_edit::Value::from(title), "");
        values.set("geometry", format!("{:?}", self.geometry.key()), "");
        let is_open = |size: &Picked| !size.is_given();
        let open = [
            ("material", self.material.is_none()),
            ("friction", true),
            ("thickness", is_open(&sizes.thickness)),
            ("blank", is_open(&sizes.blank)),
            ("travel", sizes.travel.as_ref().is_some_and(is_open)),
            ("holder pressure", first.tool(Role::Holder).is_some()),
            ("ways and holder forces of the later stages", !sections.later.is_empty()),
        ];
        let open: Vec<&str> = open.into_iter().filter_map(|(name, is_open)| is_open.then_some(name)).collect();
        values.set("open", open.join(", "), "");
        if let Some(name) =
            sections.first.number.map(stage).or((!sections.later.is_empty()).then(|| "first".to_owned()))
        {
            values.set("stage", format!("{name:?}"), "");
        }
        let key = if self.geometry == Geometry::Axisymmetric { "radius" } else { "half_length" };
        let lengths =
            [(key, Some(&sizes.blank)), ("thickness", Some(&sizes.thickness)), ("travel", sizes.travel.as_ref())];
        for (key, length) in lengths.iter().filter_map(|(key, length)| Some((key, (*length)?))) {
            values.set(key, exact(length.value), &reason(length));
        }
        match &self.material {
            Some(name) => values.set("name", format!("{name:?}"), "of the library: stampflow materials"),
            None => values.swift(typical()),
        }
        values.set("forming_limit", forming_limit(metal, sizes.thickness.value, false), "");
        let (pressure, rule) = self.pressure(first, metal);
        let why = format!("placeholder: {rule}, between holder and die; change it, or give a force");
        values.set("pressure", format!("\"{pressure} MPa\""), &why);
        if first.tool(Role::Punch).is_none() {
            values.set("no_punch", FRICTION, "");
        }
        let stages = self.later_stages(sections, first, pressure);
        if !stages.is_empty() {
            values.set("stages", stages.join("\n").trim_end(), "");
        }
        values.fill(include_str!("from_drawing/case.toml"))
    }

    /// Each later operation with new tools; the die stays where none is drawn, and with it the holder.
    fn later_stages(&self, sections: &Sections, first: &DrawnTools, pressure: f64) -> Vec<String> {
        let sizes = first.sizes();
        let mut before = DrawnTools { travel: sizes.travel.as_ref().map(|travel| travel.value), ..first.clone() };
        let mut stages = Vec::new();
        for later in &sections.later {
            let has = |role: Role| later.tool(role).is_some();
            let stays = |role: Role| match role {
                Role::Punch => false,
                Role::Die => !has(Role::Die),
                Role::Holder => !has(Role::Holder) && !has(Role::Die),
            };
            let staying = before.sections.iter().copied().filter(|section| stays(section.role));
            let now = DrawnTools {
                sections: later.tools.iter().chain(staying).collect(),
                thickness: Some(sizes.thickness.value),
                blank: Some(sizes.blank.value),
                travel: None,
                ..*first
            };
            let mut values = tool_values(&later.tools);
            values.set("label", later.number.map_or_else(String::new, stage), "");
            if before.tool(Role::Holder).is_some() && now.tool(Role::Holder).is_none() {
                values.set("remove", "[\"holder\"]", "no holder is drawn for the new die");
            }
            if let Some(travel) = now.sizes().travel {
                values.set("move", exact(travel.value), &reason(&travel));
            }
            let (force, why) = self.force(&before, &now, pressure);
            values.set("force", force, &why);
            stages.push(values.fill(include_str!("from_drawing/stage.toml")));
            before = now;
        }
        stages
    }

    /// Force of the first holder's pressure on the sheet between the die's throat and the part as it comes, and why.
    fn force(&self, before: &DrawnTools, now: &DrawnTools, pressure: f64) -> (String, String) {
        let travel = before.sizes().travel.map_or(0.0, |travel| travel.value);
        let part = before.tool(Role::Punch).map_or(f64::INFINITY, |punch| mouth(&punch, travel));
        let holder = now.tool(Role::Holder).map_or((0.0, 0.0), |holder| extent(&holder));
        let inner = now.tool(Role::Die).and_then(|die| throat(&die)).unwrap_or(0.0).max(holder.0);
        let outer = holder.1.min(part).max(inner);
        let whole = Extent::of(self.geometry, None);
        let (area, unit) = match self.geometry {
            Geometry::Axisymmetric => (whole.area(outer) - whole.area(inner), "N"),
            Geometry::PlaneStrain => (outer - inner, "N/mm"),
        };
        let why =
            format!("placeholder: the first pressure between {inner:.1} and {outer:.1} mm from the axis; change it");
        (format!("\"{:.0} {unit}\"", (pressure * area).ceil().max(1.0)), why)
    }

    /// The holder's pressure \[MPa\], rounded up, and its rule.
    fn pressure(&self, tools: &DrawnTools, metal: &Material) -> (f64, &'static str) {
        let (strength, sizes) = (tensile_strength(metal), tools.sizes());
        let travel = sizes.travel.as_ref().map_or(0.0, |travel| travel.value);
        let punch = tools.tool(Role::Punch).map(|punch| mouth(&punch, travel));
        let drawn = punch.filter(|punch| self.geometry == Geometry::Axisymmetric && sizes.blank.value > *punch);
        let (pressure, rule) = match drawn {
            Some(punch) => {
                let ratio = sizes.blank.value / punch;
                (siebel(ratio, 2.0 * punch, sizes.thickness.value, strength), "Siebel's pressure")
            }
            None => (strip_pressure(strength).value, "1 % of the tensile strength"),
        };
        (rounded(0.01 * (100.0 * pressure).ceil()), rule)
    }
}

/// Source, profile and friction of each tool.
fn tool_values(tools: &[Section]) -> Values {
    let mut values = Values::default();
    values.set("friction", FRICTION, "placeholder: Coulomb's coefficient; change it");
    for Section { role, profile, made_of, .. } in tools {
        values.set(role.name(), made_of, "");
        values.set(&format!("{}_profile", role.name()), drawn_profile(profile), "");
    }
    values
}

/// Name of an operation's stage.
fn stage(number: u32) -> String {
    format!("op{number}")
}

/// Reason of a placeholder; empty where the size was given.
fn reason(size: &Picked) -> String {
    if size.is_given() { String::new() } else { format!("placeholder: {}; change it", size.why) }
}
