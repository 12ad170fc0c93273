//! A case file around tools that were drawn: their profiles, and declared placeholders for the rest.

mod sizes;

use super::templates::{Inputs, LAW, elastic, mild_steel, rules::Picked};
use crate::assess::size_doubts;
use crate::case::{self, Case, CaseError, library, overrides};
use crate::import::{self, ImportError, Operation, Options, Result, Section, Sections};
use crate::material::Material;
use crate::model::{Extent, Geometry, Role, tool_sizes::extent, tool_sizes::throat};
use crate::units::{joined, trimmed};
use crate::writer::{Values, comment, drawn_profile, exact, forming_limit};
use sizes::{DrawnTools, placeholder};
use std::{fmt, path::Path};

/// Options of an import, and sizes that are known besides the drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Import {
    /// Options of the reader.
    pub options: Options,
    /// Axisymmetric or plane strain; that of the drawing's blank where `None`.
    pub geometry: Option<Geometry>,
    /// Sheet of the library, by its name or a grade; a placeholder where `None`.
    pub material: Option<String>,
    /// Thickness of the sheet \[mm\]; a placeholder where `None`.
    pub thickness: Option<f64>,
    /// Radius or half-length \[mm\]; a placeholder where `None`.
    pub blank: Option<f64>,
    /// Travel of the punch \[mm\]; where `None`, that of tools that are drawn closed, or a placeholder.
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
    /// The case.
    pub case: Case,
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
    /// Makes a case of the bytes of a DXF file. Fails on an unreadable drawing, an unknown sheet, or tools of no case.
    pub fn read(&self, bytes: &[u8], drawing: &Path) -> Result<Imported> {
        let sections = import::read(bytes, &self.options)?;
        let sheet = self.material.as_deref().map(library::material).transpose().map_err(refused)?;
        let metal = sheet.map_or_else(mild_steel, |sheet| sheet.material);
        let mut tools: Vec<DrawnTools> = Vec::new();
        for operation in &sections.operations {
            tools.push(DrawnTools::new(self, &sections, operation, tools.last())?);
        }
        let is_through = tools.last().is_some_and(|last| last.is_through);
        let mut doubts = Vec::from_iter(tools[0].gap_doubt().filter(|_| sections.blank.is_none()));
        let through = is_through.then(|| "stop.drawn_through=true".to_owned());
        let overrides: Vec<String> = through.into_iter().chain(self.overrides.iter().cloned()).collect();
        let text = overrides::apply(&self.text(drawing, &sections, &tools, &metal), &overrides).map_err(refused)?;
        let case = case(&text, &drawing.display().to_string(), &sections.operations[0], &doubts)?;
        // A doubt of the drawing is the cause of those of the case.
        if doubts.is_empty() {
            doubts = size_doubts(&case);
        }
        let DrawnTools { geometry, tube, punch, holder, .. } = &tools[0];
        if *geometry == Geometry::Axisymmetric && tube.is_none() && punch.is_some() && holder.is_none() {
            doubts.push("nothing holds the flange: draw a holder, or name its layer with --layer NAME=holder".into());
        }
        let travels = joined(tools.iter().filter_map(|tools| Some(trimmed(tools.drawn?, 2))), ", ");
        let pushed = if is_through { ", the part is pushed through the die" } else { "" };
        let travels = (!travels.is_empty()).then(|| format!("travel as drawn, {travels} mm{pushed}"));
        // Tools are drawn where they end, and begin elsewhere.
        let derived = case.derived.iter().map(ToString::to_string).filter(|note| !note.contains("is moved by"));
        let notes = doubts.iter().chain(&sections.notes).cloned().chain(travels).chain(derived).collect();
        Ok(Imported { sections, text, case, size: tools[0].size(), doubts, notes, geometry: *geometry })
    }

    fn text(&self, drawing: &Path, sections: &Sections, tools: &[DrawnTools], metal: &Material) -> String {
        let first @ DrawnTools { thickness, blank, .. } = &tools[0];
        let friction =
            Picked::or(self.friction, || placeholder(Inputs::of_sheet().value("friction"), "Coulomb's coefficient"));
        let mut values = tool_values(&sections.operations[0].tools, &friction, first.tube);
        let notes: String = sections.notes.iter().map(|note| comment(&format!("- {note}"))).collect();
        values.set("notes", notes.trim_end(), "");
        let title = format!("Tools of {}", drawing.file_name().unwrap_or_default().display());
        let title: String = title.chars().filter(|c| !c.is_control()).take(150).collect();
        values.set("title", toml_edit::Value::from(title), "");
        values.set("geometry", format!("{:?}", first.geometry.key()), "");
        let key = if first.geometry == Geometry::Axisymmetric { "radius" } else { "half_length" };
        let mut open = Vec::new();
        let mut list = |what: &str, option: &str, keys: &str, is_open: bool| {
            let is_set = |key: &str| self.overrides.iter().any(|set| set.trim_start().starts_with(key));
            if is_open && !keys.split(' ').any(is_set) {
                open.push(format!("{what} ({option})"));
            }
        };
        list("material", "--material", "material", self.material.is_none());
        list("friction", "--set friction", "friction=", !friction.is_given());
        list("thickness", "--set blank.thickness", "blank.thickness", !thickness.is_given());
        list("blank", &format!("--set blank.{key}"), "blank.radius blank.d blank.half", !blank.is_given());
        for (i, (operation, tools)) in sections.operations.iter().zip(tools).enumerate() {
            let stage = |key: &str| format!("stages.{}.{key}", i.saturating_sub(1));
            let (of, [travel, holder]) = match i {
                0 => (String::new(), ["tools.punch.travel", "tools.holder."].map(str::to_owned)),
                _ => (format!(" of {}", operation.name()), ["punch.move", "holder."].map(stage)),
            };
            let is_open = tools.travel.why.starts_with("placeholder");
            list(&format!("travel{of}"), &format!("--set {travel}"), &travel, is_open);
            list("pressure", "--set gas.lower.pressure.1.1", "gas.lower.pressure", tools.punch.is_none());
            let holds = operation.tool(Role::Holder).is_some();
            list(&format!("holder force{of}"), &format!("--set {holder}force"), &holder, holds);
        }
        values.set_text("open", &open.join(", "));
        let name = if tools.len() > 1 || sections.is_released { "\"first\"" } else { "" };
        let number = sections.operations[0].number.map(|number| format!("\"op{number}\""));
        values.set_text("stage", number.as_deref().unwrap_or(name));
        if let Some([low, high]) = first.tube {
            values.set("diameter", exact(2.0 * blank.value), "");
            values.set("length", exact(high - low), "");
            values.set("inner_edge", "\"guided\"", "the end that stays");
            values.set("is_tube", "", "");
        } else {
            values.set(key, exact(blank.value), &blank.why);
        }
        if let Some(oil) = first.oil(metal) {
            values.set("oil", format!("\"{} MPa\"", oil.value), &oil.why);
            (first.tube.is_none() && first.holder.is_none())
                .then(|| values.set("edge", "\"clamped\"", "no holder is drawn"));
        }
        let lengths = [("thickness", thickness), ("travel", &first.travel)];
        lengths.into_iter().for_each(|(key, length)| values.set(key, exact(length.value), &length.why));
        let finished = ["height", "diameter", "flange_diameter"].into_iter().zip(sections.finished);
        let finished = finished.filter_map(|(key, size)| Some(format!("{key} = {}", exact(size?))));
        values.set_text("finished", &joined(finished, "\n"));
        let hole = sections.blank.iter().filter(|[hole, ..]| *hole > 0.0);
        hole.for_each(|[hole, ..]| values.set("hole", exact(*hole), ""));
        match &self.material {
            Some(name) => values.set("name", format!("{name:?}"), "of the library: stampflow materials"),
            None => values.swift(Inputs::of_sheet().values(LAW)),
        }
        sections.is_released.then(|| elastic(&mut values, metal));
        sections.depth.iter().for_each(|depth| values.set("depth", exact(*depth), "length of the part"));
        values.set("forming_limit", forming_limit(metal, thickness.value, false), "");
        let (pressure, rule) = first.pressure(metal);
        let why = format!("placeholder: {rule}, between holder and die; change it, or give a force");
        values.set("pressure", format!("\"{pressure} MPa\""), &why);
        let stages = later_stages(&sections.operations[1..], tools, pressure, &friction);
        values.set_text("stages", stages.join("\n").trim_end());
        values.fill(include_str!("from_drawing/case.toml"))
    }
}

impl Imported {
    /// Picture of the tools as they are drawn.
    #[cfg(feature = "app")]
    pub fn picture(&self, drawing: &Path) -> crate::plot::Chart {
        use crate::plot::{SketchedTool, axis::capitalised, sketch};
        let tool = |tool: &Section| SketchedTool {
            label: format!("{}: {}", capitalised(tool.role.name()), tool.made_of),
            role: tool.role,
            profile: tool.profile.clone(),
            ends: tool.ends.clone(),
        };
        let tools = |operation: &Operation| operation.tools.iter().map(tool).collect();
        let Sections { operations, notes, .. } = &self.sections;
        let operations: Vec<Vec<SketchedTool>> = operations.iter().map(tools).collect();
        let caption = "Circles: where drawn lines, arcs and splines begin and end. The tools are where they are drawn; the \
                       case moves each along z to where it touches the sheet.";
        let notes = notes.iter().map(|note| format!("{}.", capitalised(note)));
        let title = format!("{}: the tools that were read", drawing.file_name().unwrap_or_default().display());
        sketch(title, self.geometry, &operations, std::iter::once(caption.to_owned()).chain(notes).collect())
    }
}

impl fmt::Display for Imported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let operations = &self.sections.operations;
        operations.iter().try_for_each(|operation| write!(f, "{operation}"))?;
        writeln!(f, "size    {}", self.size)?;
        self.notes.iter().skip(self.doubts.len()).try_for_each(|note| writeln!(f, "  - {note}"))?;
        let model = self.case.model();
        model.placeholders().iter().try_for_each(|open| writeln!(f, "\nplaceholders: {open}"))?;
        let is_known = model.stop.drawn_through || operations.iter().any(|operation| operation.sheet_end.is_some());
        let is_cup = model.tool(Role::Holder).is_some() && !is_known;
        f.write_str(if is_cup { "if the part is pushed through the die: import it with --drawn-through\n" } else { "" })
    }
}

fn case(text: &str, drawing: &str, first: &Operation, doubts: &[String]) -> Result<Case> {
    case::parse(text, drawing, &[]).map_err(|error| {
        let place = match error.key() {
            "tools.punch.travel" => Some("set it with --travel".to_owned()),
            "blank.thickness" => Some("set it with --thickness".to_owned()),
            "blank.radius" | "blank.half_length" => Some("set it with --blank-radius".to_owned()),
            "tools.holder.force" => Some("in plane strain give the part's length with --length".to_owned()),
            key => first.tools.iter().find_map(|section| {
                let is_here = key.split('.').take(2).eq(["tools", section.role.name()]);
                is_here.then(|| format!("it is drawn in {}, r is x from the axis", section.made_of))
            }),
        };
        let help = error.remedy().map(str::to_owned).into_iter().chain(place).chain(doubts.iter().cloned());
        let what = format!("the case made from it is refused, and no file is written: {error}");
        ImportError { what, help: joined(help, "; "), line: None }
    })
}

fn refused(error: CaseError) -> ImportError {
    ImportError { what: error.to_string(), help: error.remedy().unwrap_or_default().to_owned(), line: None }
}

fn later_stages(later: &[Operation], tools: &[DrawnTools], pressure: f64, friction: &Picked) -> Vec<String> {
    let stage = |(later, (before, now)): (&Operation, (&DrawnTools, &DrawnTools))| {
        let mut values = tool_values(&later.tools, friction, now.tube);
        values.set("label", later.number.map_or_else(String::new, |number| format!("op{number}")), "");
        let is_left_out = before.holder.is_some() && now.holder.is_none();
        is_left_out.then(|| values.set("remove", "[\"holder\"]", "no holder is drawn for the new die"));
        let why = "the die stands inside the part before: a reverse redraw";
        now.is_reverse(before).then(|| values.set("turn_over", true, why));
        values.set("move", exact(now.travel.value), &now.travel.why);
        let (force, why) = force(before, now, pressure);
        values.set("force", force, &why);
        values.fill(include_str!("from_drawing/stage.toml"))
    };
    later.iter().zip(tools.iter().zip(&tools[1..])).map(stage).collect()
}

fn force(before: &DrawnTools, now: &DrawnTools, pressure: f64) -> (String, String) {
    let holder = now.holder.as_ref().map_or((0.0, 0.0), extent);
    let inner = now.die.as_ref().and_then(throat).unwrap_or(0.0).max(holder.0);
    let outer = holder.1.min(before.mouth()).max(inner);
    let whole = Extent::of(now.geometry, None);
    let (area, unit) = match now.geometry {
        Geometry::Axisymmetric => (whole.area(outer) - whole.area(inner), "N"),
        Geometry::PlaneStrain => (outer - inner, "N/mm"),
    };
    let why = format!("placeholder: the first pressure between {inner:.1} and {outer:.1} mm from the axis; change it");
    (format!("\"{:.0} {unit}\"", (pressure * area).ceil().max(1.0)), why)
}

fn tool_values(tools: &[Section], friction: &Picked, tube: Option<[f64; 2]>) -> Values {
    let (mut values, shift) = (Values::default(), tube.map_or(0.0, |[_, high]| -high));
    values.set("friction", friction.value, &friction.why);
    for Section { role, profile, made_of, .. } in tools {
        values.set(role.name(), made_of, "");
        values.set(&format!("{}_profile", role.name()), drawn_profile(&profile.shifted(shift)), "");
    }
    values
}
