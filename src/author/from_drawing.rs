//! A case file around tools that were drawn: their profiles, and declared placeholders for the rest.

#[cfg(feature = "app")]
mod picture;
mod sizes;

use super::templates::rules::{Metal, Picked, siebel, strip_pressure, tensile_strength};
use super::templates::{Inputs, LAW, mild_steel};
use crate::assess::size_doubts;
use crate::case::{self, Case, CaseError, library, overrides};
use crate::import::{self, ImportError, Options, Section, Sections};
use crate::material::Material;
use crate::model::tool_sizes::{extent, throat};
use crate::model::{Extent, Geometry, Role};
use crate::units::rounded;
use crate::writer::{Values, comment, drawn_profile, exact, forming_limit};
use sizes::{DrawnTools, placeholder};
use std::fmt;
use std::path::Path;

/// Options of an import, and sizes that are known besides the drawing.
#[derive(Clone, Debug, Default, PartialEq)]
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
    /// Coulomb's coefficient of every tool \[–\]; a placeholder where `None`.
    pub friction: Option<f64>,
    /// `KEY=VALUE` settings of the case.
    pub overrides: Vec<String>,
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
    /// Sizes that hardly fit a sheet: mostly a wrong unit.
    pub doubts: Vec<String>,
    /// Doubts, how the drawing was understood, and what the case derives from it.
    pub notes: Vec<String>,
    /// Axisymmetric or plane strain.
    pub geometry: Geometry,
}

impl Import {
    /// Makes a case of the bytes of a DXF file.
    /// Fails when the drawing cannot be read, the sheet is unknown, or the tools make no case.
    pub fn read(&self, bytes: &[u8], drawing: &Path) -> Result<Imported, ImportError> {
        let sections = import::read(bytes, &self.options)?;
        let sheet = self.material.as_deref().map(library::material).transpose().map_err(refused)?;
        let metal = sheet.map_or_else(mild_steel, |sheet| sheet.material);
        let drawn = |i: usize| sections.blank.map(|sizes| sizes[i]);
        let given = [self.thickness.or(drawn(2)), self.blank.or(drawn(1)), self.travel];
        let tools = DrawnTools::new(self.geometry, sections.first.tools.iter().collect(), given);
        let (size, mut doubts) = (tools.size(), tools.doubts(sections.unit, self.thickness.is_none()));
        let is_round = self.geometry == Geometry::Axisymmetric;
        let throat =
            tools.tool(Role::Die).and_then(|die| throat(&die)).filter(|_| is_round && sections.later.is_empty());
        let reach = throat.map_or(0.0, |throat| throat + 0.5 * tools.thickness.value); // contact gives way, declared
        let through = sections.part_edge.filter(|edge| *edge < reach).map(|_| "stop.drawn_through=true".to_owned());
        let overrides: Vec<String> = through.into_iter().chain(self.overrides.iter().cloned()).collect();
        let text = overrides::apply(&self.text(drawing, &sections, &tools, &metal), &overrides).map_err(refused)?;
        let case = case(&text, &drawing.display().to_string(), &tools, &doubts).map_err(refused)?;
        // A doubt of the drawing is the cause of those of the case.
        if let (true, Some(case)) = (doubts.is_empty(), &case) {
            doubts = size_doubts(case);
        }
        if is_round && tools.tool(Role::Holder).is_none() {
            doubts.push("nothing holds the flange: draw a holder, or name its layer with --layer NAME=holder".into());
        }
        let derived = case.iter().flat_map(|case| &case.derived).map(ToString::to_string);
        let notes = doubts.iter().chain(&sections.notes).cloned().chain(derived).collect();
        Ok(Imported { sections, text, case, size, doubts, notes, geometry: self.geometry })
    }

    fn text(&self, drawing: &Path, sections: &Sections, first: &DrawnTools, metal: &Material) -> String {
        let DrawnTools { thickness, blank, travel, .. } = first;
        let friction =
            Picked::or(self.friction, || placeholder(Inputs::of_sheet().value("friction"), "Coulomb's coefficient"));
        let mut values = tool_values(&sections.first.tools, &friction);
        let notes: String = sections.notes.iter().map(|note| comment(&format!("- {note}"))).collect();
        values.set("notes", notes.trim_end(), "");
        let title = format!("Tools of {}", file_name(drawing));
        let title: String = title.chars().filter(|c| !c.is_control()).take(150).collect();
        values.set("title", toml_edit::Value::from(title), "");
        values.set("geometry", format!("{:?}", self.geometry.key()), "");
        let key = if self.geometry == Geometry::Axisymmetric { "radius" } else { "half_length" };
        let blank_key = format!("blank (--set blank.{key})");
        let is_set = |key: &str| self.overrides.iter().any(|set| set.trim_start().starts_with(key));
        let has_travel = travel.as_ref().is_some_and(|travel| !travel.is_given());
        let has_holder = first.tool(Role::Holder).is_some();
        let open = [
            ("material (--material)", self.material.is_none() && !is_set("material")),
            ("friction (--set friction)", !friction.is_given() && !is_set("friction=")),
            ("thickness (--set blank.thickness)", !thickness.is_given() && !is_set("blank.thickness")),
            (&blank_key, !blank.is_given() && !is_set("blank.radius") && !is_set("blank.d") && !is_set("blank.half")),
            ("travel (--set tools.punch.travel)", has_travel && !is_set("tools.punch.travel")),
            ("holder pressure (--set tools.holder.pressure)", has_holder && !is_set("tools.holder.")),
            ("travels and holder forces of the later stages (--set stages.0.punch.move)", !sections.later.is_empty()),
        ];
        let open: Vec<&str> = open.into_iter().filter_map(|(name, is_open)| is_open.then_some(name)).collect();
        if !open.is_empty() {
            values.set("open", open.join(", "), "");
        }
        let name = (!sections.later.is_empty()).then(|| "first".to_owned());
        let name = sections.first.number.map(|number| format!("op{number}")).or(name);
        name.into_iter().for_each(|name| values.set("stage", format!("{name:?}"), ""));
        let lengths = [(key, blank), ("thickness", thickness)].into_iter().chain(travel.iter().map(|t| ("travel", t)));
        lengths.for_each(|(key, length)| values.set(key, exact(length.value), &reason(length)));
        let hole = sections.blank.map(|[hole, ..]| hole).filter(|hole| *hole > 0.0);
        hole.into_iter().for_each(|hole| values.set("hole", exact(hole), ""));
        match &self.material {
            Some(name) => values.set("name", format!("{name:?}"), "of the library: stampflow materials"),
            None => values.swift(Inputs::of_sheet().values(LAW)),
        }
        values.set("forming_limit", forming_limit(metal, thickness.value, false), "");
        let (pressure, rule) = pressure(first, metal);
        let why = format!("placeholder: {rule}, between holder and die; change it, or give a force");
        values.set("pressure", format!("\"{pressure} MPa\""), &why);
        if first.tool(Role::Punch).is_none() {
            values.set("no_punch", friction.value, "");
        }
        let stages = later_stages(sections, first, pressure, &friction);
        if !stages.is_empty() {
            values.set("stages", stages.join("\n").trim_end(), "");
        }
        values.fill(include_str!("from_drawing/case.toml"))
    }
}

impl fmt::Display for Imported {
    /// Tools, sizes, how the drawing was understood, and what is left to give.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Sections { first, later, .. } = &self.sections;
        [first].into_iter().chain(later).try_for_each(|operation| write!(f, "{operation}"))?;
        writeln!(f, "size    {}", self.size)?;
        self.notes.iter().skip(self.doubts.len()).try_for_each(|note| writeln!(f, "  - {note}"))?;
        let Some(model) = self.case.as_ref().map(Case::model) else { return Ok(()) };
        model.placeholders().iter().try_for_each(|open| writeln!(f, "\nplaceholders: {open}"))?;
        let is_cup = model.tool(Role::Holder).is_some() && !model.stop.drawn_through;
        f.write_str(if is_cup { "if the part is pushed through the die: import it with --drawn-through\n" } else { "" })
    }
}

fn case(text: &str, drawing: &str, tools: &DrawnTools, doubts: &[String]) -> Result<Option<Case>, CaseError> {
    if tools.tool(Role::Die).is_none() {
        let what = "there is no die: nothing would draw the sheet over the punch";
        return Err(CaseError::bare(what.to_owned(), "name its layer with --layer NAME=die".to_owned()));
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
        let help = error.remedy().map(str::to_owned).into_iter().chain(place).chain(doubts.iter().cloned());
        let what = format!("the case made from it is refused, and no file is written: {error}");
        CaseError::bare(what, help.collect::<Vec<_>>().join("; "))
    })
}

fn refused(error: CaseError) -> ImportError {
    ImportError { what: error.to_string(), help: error.remedy().unwrap_or_default().to_owned(), line: None }
}

/// Each later operation with new tools; the die stays where none is drawn, and with it the holder.
fn later_stages(sections: &Sections, first: &DrawnTools, pressure: f64, friction: &Picked) -> Vec<String> {
    let (mut before, mut stages) = (first.clone(), Vec::new());
    for later in &sections.later {
        let has = |role: Role| later.tool(role).is_some();
        let stays = |role: Role| match role {
            Role::Punch => false,
            Role::Holder => !has(Role::Holder) && !has(Role::Die),
            role => !has(role),
        };
        let staying = before.sections.iter().copied().filter(|section| stays(section.role));
        let given = [Some(first.thickness.value), Some(first.blank.value), None];
        let now = DrawnTools::new(first.geometry, later.tools.iter().chain(staying).collect(), given);
        let mut values = tool_values(&later.tools, friction);
        values.set("label", later.number.map_or_else(String::new, |number| format!("op{number}")), "");
        if before.tool(Role::Holder).is_some() && now.tool(Role::Holder).is_none() {
            values.set("remove", "[\"holder\"]", "no holder is drawn for the new die");
        }
        now.travel.iter().for_each(|travel| values.set("move", exact(travel.value), &reason(travel)));
        let (force, why) = force(&before, &now, pressure);
        values.set("force", force, &why);
        stages.push(values.fill(include_str!("from_drawing/stage.toml")));
        before = now;
    }
    stages
}

/// Force of the first holder's pressure on the sheet between the die's throat and the part as it comes, and why.
fn force(before: &DrawnTools, now: &DrawnTools, pressure: f64) -> (String, String) {
    let holder = now.tool(Role::Holder).map_or((0.0, 0.0), |holder| extent(&holder));
    let inner = now.tool(Role::Die).and_then(|die| throat(&die)).unwrap_or(0.0).max(holder.0);
    let outer = holder.1.min(before.mouth().unwrap_or(f64::INFINITY)).max(inner);
    let whole = Extent::of(now.geometry, None);
    let (area, unit) = match now.geometry {
        Geometry::Axisymmetric => (whole.area(outer) - whole.area(inner), "N"),
        Geometry::PlaneStrain => (outer - inner, "N/mm"),
    };
    let why = format!("placeholder: the first pressure between {inner:.1} and {outer:.1} mm from the axis; change it");
    (format!("\"{:.0} {unit}\"", (pressure * area).ceil().max(1.0)), why)
}

/// The holder's pressure \[MPa\], rounded up, and its rule.
fn pressure(tools: &DrawnTools, metal: &Material) -> (f64, &'static str) {
    let (strength, blank) = (tensile_strength(metal), tools.blank.value);
    let punch = tools.mouth().filter(|punch| tools.geometry == Geometry::Axisymmetric && blank > *punch);
    let (pressure, rule) = match punch {
        Some(punch) => {
            let siebel = siebel(blank / punch, 2.0 * punch, tools.thickness.value, strength);
            (siebel.max(Metal::of(metal).pressure), "usual pressure of the metal, Siebel's if more")
        }
        None => (strip_pressure(strength).value, "1 % of the tensile strength"),
    };
    (rounded(0.01 * (100.0 * pressure).ceil()), rule)
}

/// Source, profile and friction of each tool.
fn tool_values(tools: &[Section], friction: &Picked) -> Values {
    let mut values = Values::default();
    values.set("friction", friction.value, &reason(friction));
    for Section { role, profile, made_of, .. } in tools {
        values.set(role.name(), made_of, "");
        values.set(&format!("{}_profile", role.name()), drawn_profile(profile), "");
    }
    values
}

/// Reason of a placeholder; empty where the size was given.
fn reason(size: &Picked) -> String {
    if size.is_given() { String::new() } else { format!("placeholder: {}; change it", size.why) }
}

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}
