//! A DXF file, read once from its first line to its last: pairs of a group code and a value, each on a line of its own.
//!
//! # References
//! Autodesk, DXF Reference (group codes of the HEADER and ENTITIES sections; not read: codes as commonly used).

use super::curve::{Curve, Group, Vertex};
use super::error::ImportError;
use super::reference::Reference;
use crate::geometry::Point;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

/// More of a file is no drawing of a few tools \[bytes\].
pub const LARGEST: usize = 50_000_000;
/// Lines and arcs that a tool may be drawn in, repeats and both halves counted: a case's section may have 2000.
pub(super) const MOST: usize = 5000;

/// Entities of a drawing, and points and knots of its lines and curves: an assembly with all its parts has fewer.
pub(super) const ENTITIES: usize = 200_000;
const POINTS: usize = 1_000_000;

const AGAIN: &str = "open the drawing in a CAD program and save it as DXF again";

/// Characters of the Windows code page 1252 from 0x80 to 0x9F; all others are those of Unicode.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// What is read of a drawing.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    pub header: Header,
    /// The entities of the model and of paper sheets, references to blocks among them.
    pub entities: Vec<Entity>,
    pub blocks: Vec<Block>,
    /// The line type of each layer, by the layer's name.
    pub line_types: BTreeMap<String, String>,
}

/// What a drawing says about its unit.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Header {
    /// Number of $INSUNITS; 0 where there is none.
    pub unit: usize,
    /// Whether $MEASUREMENT is metric.
    pub is_metric: bool,
}

/// An entity and its shape.
#[derive(Debug)]
pub(super) struct Entity {
    pub listed: Listed,
    pub shape: Shape,
}

/// What an entity draws.
#[derive(Debug)]
pub(super) enum Shape {
    /// What tools are drawn with.
    Curve(Curve),
    /// INSERT.
    Reference(Reference),
    /// Nothing that a tool is drawn with.
    Other,
}

impl Shape {
    fn new(kind: &str) -> Self {
        match Curve::new(kind) {
            Some(curve) => Self::Curve(curve),
            None if kind == "INSERT" => Self::Reference(Reference::default()),
            None => Self::Other,
        }
    }

    fn group(&mut self, code: i32) -> Group<'_> {
        match self {
            Self::Curve(curve) => curve.group(code),
            Self::Reference(reference) => reference.group(code),
            Self::Other => Group::Other,
        }
    }
}

/// An entity as the file names it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Listed {
    /// LINE, ARC, ...
    pub kind: String,
    pub layer: String,
    /// Hexadecimal, as CAD programs show it; empty in old files.
    pub handle: String,
    /// Line of the file, from 1.
    pub line: usize,
    /// Drawn on a sheet of paper, not in the model.
    pub on_paper: bool,
    /// Its point, in drawing units: where a circle's centre or a text is.
    pub at: [f64; 2],
    /// Its line type; empty where it is that of the layer.
    pub line_type: String,
    /// The block that it is in, or that it refers to; empty for others.
    pub block: String,
}

impl fmt::Display for Listed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, layer, handle, line, .. } = self;
        let handle = if handle.is_empty() { String::new() } else { format!(" #{}", cut(handle)) };
        let block = if self.block.is_empty() { String::new() } else { format!(", block \"{}\"", cut(&self.block)) };
        write!(f, "{}{handle} of layer \"{}\"{block} (line {line} of the file)", cut(kind), cut(layer))
    }
}

/// A block as the file lists it.
#[derive(Debug, Default)]
pub(super) struct Block {
    pub name: String,
    /// The point that a reference places, in drawing units.
    pub base: Point,
    /// Whether it stands for another file.
    pub is_external: bool,
    pub entities: Vec<Entity>,
}

impl Block {
    /// Takes a group of the block itself.
    pub fn take(&mut self, code: i32, value: &str) {
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

/// The file's text: UTF-8, or the Windows code page of older files.
pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, ImportError> {
    let text_help = "save the drawing as DXF in text form (ASCII), version R12 or later";
    if bytes.len() > LARGEST {
        let what = format!("the file is larger than {} MB", LARGEST / 1_000_000);
        return Err(ImportError::new(what, "save the tools' layers only"));
    }
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Err(ImportError::new("the file is a binary DXF", text_help));
    }
    if bytes.starts_with(b"AC10") {
        return Err(ImportError::new("the file is a DWG, not a DXF", text_help));
    }
    let windows = |byte: &u8| match byte {
        0x80..=0x9f => WINDOWS[usize::from(byte - 0x80)],
        _ => char::from(*byte),
    };
    Ok(match std::str::from_utf8(bytes) {
        Ok(text) => text.trim_start_matches('\u{feff}').into(),
        Err(_) => bytes.iter().map(windows).collect::<String>().into(),
    })
}

/// What the pairs that follow belong to, inside the BLOCKS and ENTITIES sections.
enum Part {
    /// The last block itself.
    Block,
    Entity,
    /// The last vertex of the last entity, a POLYLINE.
    Vertex,
    /// An attribute of a block, the end of a list of vertices: no part of any shape.
    Other,
}

/// Reads a drawing's text.
///
/// # Errors
/// When it is no DXF, ends inside a section, holds more than any drawing of tools, or has something else where a group code
/// or a curve's number has to be.
pub(super) fn drawing(text: &str) -> Result<Drawing, ImportError> {
    let Drawing { mut header, mut entities, mut blocks, mut line_types } = Drawing::default();
    let (mut section, mut opens, mut is_dxf) = ("", false, false);
    let (mut variable, mut part, mut last_line, mut count, mut points) = ("", Part::Other, 0, 0, 0);
    // The table entry that is being read, where it is a layer.
    let mut layer = None;
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
        match (code, value) {
            (0, "EOF") => break,
            (0, "SECTION") => (opens, is_dxf) = (true, true),
            (2, name) if opens => (section, opens) = (name, false),
            (0, "ENDSEC") => section = "",
            (9, name) if section == "HEADER" => variable = name,
            (70, value) if section == "HEADER" => match variable {
                "$INSUNITS" => header.unit = whole(value),
                "$MEASUREMENT" => header.is_metric = whole(value) == 1,
                _ => {}
            },
            (0, kind) if section == "TABLES" => layer = (kind == "LAYER").then_some(""),
            (2, name) if section == "TABLES" && layer == Some("") => layer = Some(name),
            (6, line_type) if section == "TABLES" => {
                line_types.extend(layer.map(|layer| (layer.to_owned(), line_type.to_owned())));
            }
            (0, "BLOCK") if section == "BLOCKS" => {
                blocks.push(Block::default());
                part = Part::Block;
            }
            (0, "ENDBLK") if section == "BLOCKS" => part = Part::Other,
            (code, value) if matches!(section, "BLOCKS" | "ENTITIES") => {
                let in_block = section == "BLOCKS";
                match (blocks.last_mut().filter(|_| in_block), &part, code) {
                    (Some(block), Part::Block, 1..) => block.take(code, value),
                    (None, ..) if in_block => {}
                    (block, ..) => {
                        let found = block.map_or(&mut entities, |block| &mut block.entities);
                        if code == 0 {
                            part = begun(value, last_line, found);
                            points += usize::from(matches!(part, Part::Vertex));
                            count += usize::from(matches!(part, Part::Entity));
                        } else if let Some(entity) = found.last_mut() {
                            points += usize::from(matches!((&part, code), (Part::Entity, 10 | 40 | 41)));
                            entity.take(&part, code, value, last_line)?;
                        }
                    }
                }
            }
            _ => {}
        }
        if count > ENTITIES || points > POINTS {
            let what = format!(
                "the drawing has more than {ENTITIES} entities or {POINTS} points: line {last_line} is one more"
            );
            return Err(ImportError::new(what, "save the tools' layers only").at(last_line));
        }
    }
    if !is_dxf {
        let what = "the file is not a DXF drawing: it has no section";
        return Err(ImportError::new(what, "give a DXF file in text form (ASCII)"));
    }
    if !section.is_empty() {
        let what =
            format!("the drawing is cut short: it ends inside its {} section, at line {last_line}", cut(section));
        return Err(ImportError::new(what, AGAIN).at(last_line));
    }
    Ok(Drawing { header, entities, blocks, line_types })
}

/// Begins an entity, or a part of the last one.
fn begun(kind: &str, line: usize, found: &mut Vec<Entity>) -> Part {
    match (kind, found.last_mut()) {
        ("VERTEX", Some(Entity { shape: Shape::Curve(Curve::Old(polyline)), .. })) => {
            polyline.vertices.push(Vertex::default());
            Part::Vertex
        }
        ("VERTEX" | "SEQEND" | "ATTRIB", _) => Part::Other,
        _ => {
            let listed = Listed { kind: kind.to_owned(), layer: "0".to_owned(), line, ..Listed::default() };
            found.push(Entity { listed, shape: Shape::new(kind) });
            Part::Entity
        }
    }
}

impl Entity {
    fn take(&mut self, part: &Part, code: i32, value: &str, line: usize) -> Result<(), ImportError> {
        let Self { listed, shape } = self;
        let group = match (part, shape) {
            (Part::Other, _) => return Ok(()),
            (Part::Vertex, Shape::Curve(Curve::Old(polyline))) => {
                polyline.vertices.last_mut().map_or(Group::Other, |vertex| vertex.group(code))
            }
            (Part::Entity, shape) => shape.group(code),
            _ => Group::Other,
        };
        match (group, part, code) {
            (Group::Number(number), ..) => match value.parse::<f64>() {
                Ok(value) if value.is_finite() => *number = value,
                _ => {
                    let what =
                        format!("{listed} cannot be read: line {line} has to be a number, and is \"{}\"", cut(value));
                    return Err(ImportError::new(what, AGAIN).at(line));
                }
            },
            (Group::NoPoint, ..) => {
                let what = format!("{listed} cannot be read: line {line} belongs to a point that has no x before it");
                return Err(ImportError::new(what, AGAIN).at(line));
            }
            (Group::Other, Part::Entity, 2) if listed.kind == "INSERT" => listed.block = value.to_owned(),
            (Group::Other, Part::Entity, 6) => listed.line_type = value.to_owned(),
            (Group::Other, Part::Entity, 5) => listed.handle = value.to_owned(),
            (Group::Other, Part::Entity, 8) => listed.layer = value.to_owned(),
            (Group::Other, Part::Entity, 10 | 20) => listed.at[usize::from(code == 20)] = value.parse().unwrap_or(0.0),
            (Group::Other, Part::Entity, 67) => listed.on_paper = value == "1",
            _ => {}
        }
        Ok(())
    }
}

/// A whole number, which some programs write with decimals; 0 for anything else.
pub(super) fn whole(value: &str) -> usize {
    value.parse::<f64>().map_or(0, |value| value as usize)
}

/// A quotation that stays short.
pub(super) fn cut(text: &str) -> &str {
    text.char_indices().nth(40).map_or(text, |(end, _)| &text[..end])
}
