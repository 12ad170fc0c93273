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

/// Largest file \[bytes\].
pub const LARGEST: usize = 50_000_000;
/// Most lines and arcs of a tool; a section may have 2000.
pub(super) const MOST: usize = 5000;

/// Most entities of a drawing, and points and knots of its curves.
pub(super) const ENTITIES: usize = 200_000;
const POINTS: usize = 1_000_000;

const AGAIN: &str = "open the drawing in a CAD program and save it as DXF again";

/// Code page 1252 from 0x80 to 0x9F; other characters are those of Unicode.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

#[derive(Debug, Default)]
pub(super) struct Drawing {
    pub header: Header,
    pub entities: Vec<Entity>,
    pub blocks: Vec<Block>,
    /// Line type of each layer.
    pub line_types: BTreeMap<String, String>,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Header {
    /// $INSUNITS, or 0.
    pub unit: usize,
    pub is_metric: bool,
}

#[derive(Debug)]
pub(super) struct Entity {
    pub listed: Listed,
    pub shape: Shape,
}

#[derive(Debug)]
pub(super) enum Shape {
    Curve(Curve),
    Reference(Reference),
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

/// Properties of an entity.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Listed {
    pub kind: String,
    pub layer: String,
    /// Hexadecimal, as CAD programs show it; empty in old files.
    pub handle: String,
    /// Line of the file, from 1.
    pub line: usize,
    pub on_paper: bool,
    /// First point \[drawing units\].
    pub at: [f64; 2],
    /// Empty for that of the layer.
    pub line_type: String,
    /// Block that it is in or refers to; empty for others.
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

#[derive(Debug, Default)]
pub(super) struct Block {
    pub name: String,
    /// Point that a reference places \[drawing units\].
    pub base: Point,
    pub is_external: bool,
    pub entities: Vec<Entity>,
}

impl Block {
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

/// Text of the file: UTF-8, or the Windows code page of older files.
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

/// Owner of the next groups.
enum Part {
    Block,
    Entity,
    Vertex,
    /// Attributes and ends of lists.
    Other,
}

/// Reads a drawing's text.
///
/// # Errors
/// When it is no DXF, is cut short, is too large, or has no number where one has to be.
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

/// Whole number, which some programs write with decimals; 0 for anything else.
pub(super) fn whole(value: &str) -> usize {
    value.parse::<f64>().map_or(0, |value| value as usize)
}

pub(super) fn cut(text: &str) -> &str {
    text.char_indices().nth(40).map_or(text, |(end, _)| &text[..end])
}
