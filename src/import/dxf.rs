//! Reader of DXF text: pairs of a group code and a value, each on a line of its own.
//!
//! Source: Autodesk, DXF Reference (group codes of the HEADER and ENTITIES sections; not read: codes as commonly used).

use super::{ImportError, Result, ensure};
use crate::geometry::Point;
use std::{borrow::Cow, fmt};

/// Largest file \[bytes\].
pub const LARGEST: usize = 50_000_000;
/// Most lines and arcs of a tool; a section may have 2000.
pub(super) const MOST: usize = 5000;

pub(super) const ENTITIES: usize = 200_000;

const AGAIN: &str = "open the drawing in a CAD program and save it as DXF again";
/// Code page 1252 from 0x80 to 0x9F; other characters are those of Unicode.
const WINDOWS: &str = "€\u{81}‚ƒ„…†‡ˆ‰Š‹Œ\u{8d}Ž\u{8f}\u{90}‘’“”•–—˜™š›œ\u{9d}žŸ";

#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// $INSUNITS, or 0.
    pub unit: usize,
    /// $MEASUREMENT.
    pub is_metric: bool,
    pub entities: Vec<Entity>,
    pub blocks: Vec<Block>,
}

#[derive(Debug, Default)]
pub(super) struct Block {
    pub name: String,
    /// Point that a reference places \[drawing units\].
    pub base: Point,
    pub is_external: bool,
    pub entities: Vec<Entity>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Source {
    pub kind: String,
    pub layer: String,
    /// Hexadecimal, as CAD programs show it; empty in old files.
    pub handle: String,
    /// Line of the file, from 1.
    pub line: usize,
    pub on_paper: bool,
    /// Point of an entity that is no curve \[drawing units\].
    pub at: Point,
    /// Block that it is in or refers to; empty for others.
    pub block: String,
}

impl Source {
    pub fn error(&self, what: impl Into<String>, help: impl Into<String>) -> ImportError {
        ImportError::new(what, help).at(self.line)
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, layer, handle, line, block, .. } = self;
        let handle = if handle.is_empty() { String::new() } else { format!(" #{}", cut(handle)) };
        let block = if block.is_empty() { String::new() } else { format!(", block \"{}\"", cut(block)) };
        write!(f, "{}{handle} of layer \"{}\"{block} (line {line} of the file)", cut(kind), cut(layer))
    }
}

/// Point with its height z \[drawing units\].
pub(super) type Place = [f64; 3];

#[derive(Clone, Debug, Default)]
pub(super) struct Vertex {
    pub at: Place,
    /// Tangent of a quarter of the arc's angle to the next vertex, positive to the left; 0 for a line.
    pub bulge: f64,
    pub flags: i64,
}

#[derive(Debug)]
pub(super) struct Entity {
    pub source: Source,
    numbers: Vec<(i32, f64)>,
}

const VERTEX: i32 = 0;

impl Entity {
    pub fn is_curve(&self) -> bool {
        matches!(self.source.kind.as_str(), "LINE" | "ARC" | "LWPOLYLINE" | "POLYLINE" | "SPLINE")
    }

    pub fn number(&self, code: i32, default: f64) -> f64 {
        let own = self.numbers.iter().take_while(|(code, _)| *code != VERTEX);
        own.filter(|(own, _)| *own == code).last().map_or(default, |(_, number)| *number)
    }

    pub fn numbers(&self, code: i32) -> Vec<f64> {
        self.numbers.iter().filter(|(own, _)| *own == code).map(|(_, number)| *number).collect()
    }

    /// Point of the codes 10, 20, 30 or 11, 21, 31.
    pub fn point(&self, x: i32) -> Place {
        [x, x + 10, x + 20].map(|code| self.number(code, 0.0))
    }

    pub fn normal(&self) -> Place {
        [(210, 0.0), (220, 0.0), (230, 1.0)].map(|(code, default)| self.number(code, default))
    }

    pub fn vertices(&self) -> Vec<Vertex> {
        let begin = if self.source.kind == "POLYLINE" { VERTEX } else { 10 };
        let mut vertices: Vec<Vertex> = Vec::new();
        for (code, number) in &self.numbers {
            if *code == begin {
                vertices.push(Vertex::default());
            }
            let Some(vertex) = vertices.last_mut() else { continue };
            match code {
                10 | 20 | 30 => vertex.at[*code as usize / 10 - 1] = *number,
                42 => vertex.bulge = *number,
                70 => vertex.flags = *number as i64,
                _ => {}
            }
        }
        vertices
    }

    fn read(&mut self, part: Part, (code, value): (i32, &str), line: usize) -> Result {
        if matches!(code, 10..=59 | 70 | 71 | 210..=239) && (self.is_curve() || self.source.kind == "INSERT") {
            let source = &self.source;
            let damaged =
                |what: String| ImportError::new(format!("{source} cannot be read: line {line} {what}"), AGAIN).at(line);
            let number = value.parse().ok().filter(|number: &f64| number.is_finite());
            let number = number.ok_or_else(|| damaged(format!("has to be a number, and is \"{}\"", cut(value))))?;
            let needs_x = matches!((source.kind.as_str(), code), ("LWPOLYLINE", 20 | 42) | ("SPLINE", 20 | 30));
            let fits = !needs_x || self.numbers.iter().rev().any(|(code, _)| *code == 10);
            ensure(fits, || damaged("belongs to a point that has no x before it".to_owned()))?;
            self.numbers.push((code, number));
        } else if part == Part::Entity {
            let source = &mut self.source;
            match code {
                2 if source.kind == "INSERT" => source.block = value.to_owned(),
                5 => source.handle = value.to_owned(),
                8 => source.layer = value.to_owned(),
                10 => source.at.x = value.parse().unwrap_or(0.0),
                20 => source.at.y = value.parse().unwrap_or(0.0),
                67 => source.on_paper = value == "1",
                _ => {}
            }
        }
        Ok(())
    }
}

pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>> {
    let what = || format!("the file is larger than {} MB", LARGEST / 1_000_000);
    ensure(bytes.len() <= LARGEST, || ImportError::new(what(), "save the tools' layers only"))?;
    let others = [("AutoCAD Binary DXF", "the file is a binary DXF"), ("AC10", "the file is a DWG, not a DXF")];
    if let Some((_, what)) = others.into_iter().find(|(begin, _)| bytes.starts_with(begin.as_bytes())) {
        return Err(ImportError::new(what, "save the drawing as DXF in text form (ASCII), version R12 or later"));
    }
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Ok(text.trim_start_matches('\u{feff}').into());
    }
    let windows = |byte: &u8| byte.checked_sub(0x80).and_then(|i| WINDOWS.chars().nth(i.into()));
    Ok(bytes.iter().map(|byte| windows(byte).unwrap_or(char::from(*byte))).collect())
}

#[derive(Clone, Copy, PartialEq)]
enum Part {
    Block,
    Entity,
    Vertex,
    /// Attributes and ends of lists.
    Other,
}

pub(super) fn drawing(text: &str) -> Result<Drawing> {
    let mut drawing = Drawing::default();
    let (mut section, mut opens, mut is_dxf, mut last_line) = ("", false, false, 0);
    let (mut variable, mut part, mut count) = ("", Part::Other, 0);
    let mut lines = text.lines().map(str::trim).enumerate();
    while let Some((i, code)) = lines.next() {
        let Some((_, value)) = lines.next() else { break };
        last_line = i + 2;
        let Ok(code) = code.parse::<i32>() else {
            let what = match is_dxf {
                true => format!("the file is damaged: line {} has to be a group code, and is \"{}\"", i + 1, cut(code)),
                false => "the file is not a DXF drawing: it does not begin with a section".to_owned(),
            };
            return Err(ImportError::new(what, "save it as DXF in text form (ASCII) again").at(i + 1));
        };
        match (section, code, value) {
            (_, 0, "EOF") => break,
            (_, 0, "SECTION") => (opens, is_dxf) = (true, true),
            (_, 2, name) if opens => (section, opens) = (name, false),
            (_, 0, "ENDSEC") => section = "",
            ("HEADER", 9, name) => variable = name,
            ("HEADER", 70, unit) if variable == "$INSUNITS" => drawing.unit = whole(unit),
            ("HEADER", 70, system) if variable == "$MEASUREMENT" => drawing.is_metric = whole(system) == 1,
            ("BLOCKS", 0, "BLOCK") => {
                drawing.blocks.push(Block::default());
                part = Part::Block;
            }
            ("BLOCKS", 0, "ENDBLK") => part = Part::Other,
            ("BLOCKS", 1.., value) if part == Part::Block => {
                drawing.blocks.iter_mut().last().into_iter().for_each(|block| block.read(code, value));
            }
            ("BLOCKS" | "ENTITIES", ..) => {
                let block = drawing.blocks.last_mut().map(|block| &mut block.entities);
                let entities = if section == "BLOCKS" { block } else { Some(&mut drawing.entities) };
                let Some(entities) = entities else { continue };
                if code == 0 {
                    part = begun(value, last_line, entities);
                    count += usize::from(part == Part::Entity);
                } else if let Some(entity) = entities.last_mut().filter(|_| part != Part::Other) {
                    entity.read(part, (code, value), last_line)?;
                }
            }
            _ => {}
        }
        let what = || format!("the drawing has more than {ENTITIES} entities: line {last_line} is one more");
        ensure(count <= ENTITIES, || ImportError::new(what(), "save the tools' layers only").at(last_line))?;
    }
    let what = "the file is not a DXF drawing: it has no section";
    ensure(is_dxf, || ImportError::new(what, "give a DXF file in text form (ASCII)"))?;
    let what = |section| format!("the drawing is cut short: it ends inside its {section} section, at line {last_line}");
    ensure(section.is_empty(), || ImportError::new(what(cut(section)), AGAIN).at(last_line))?;
    Ok(drawing)
}

impl Block {
    fn read(&mut self, code: i32, value: &str) {
        let number = || value.parse::<f64>().ok().filter(|number| number.is_finite()).unwrap_or(0.0);
        match code {
            2 => self.name = value.to_owned(),
            10 => self.base.x = number(),
            20 => self.base.y = number(),
            70 => self.is_external = whole(value) & (4 | 8) != 0,
            _ => {}
        }
    }
}

fn begun(kind: &str, line: usize, entities: &mut Vec<Entity>) -> Part {
    match (kind, entities.last_mut()) {
        ("VERTEX", Some(polyline)) if polyline.source.kind == "POLYLINE" => {
            polyline.numbers.push((VERTEX, 0.0));
            Part::Vertex
        }
        ("VERTEX" | "SEQEND" | "ATTRIB", _) => Part::Other,
        _ => {
            let source = Source { kind: kind.to_owned(), layer: "0".to_owned(), line, ..Source::default() };
            entities.push(Entity { source, numbers: Vec::new() });
            Part::Entity
        }
    }
}

fn whole(value: &str) -> usize {
    value.parse::<f64>().map_or(0, |value| value as usize)
}

pub(super) fn cut(text: &str) -> &str {
    text.char_indices().nth(40).map_or(text, |(end, _)| &text[..end])
}
