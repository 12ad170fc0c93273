//! Tool sections from a drawing (DXF): lines, arcs, polylines and splines joined into oriented chains, one per tool.
//!
//! ```text
//! text → listing, curve          entities and their shapes, the header's unit
//!    │ blocks, reference          each block as often as it is referred to
//!    │ layers, parts              tool and operation of each layer
//!    │ stroke, spline             entity → Stroke: pieces in mm
//!    │ axis, halves               is the axis at x = 0? a second half is compared and left out
//!    │ chain                      strokes joined end to end: gaps, overlaps, branches are named
//!    └ orient, outline            Section: sheet on the left; of outlines the side towards the sheet
//! ```
//!
//! # Frame
//! In the drawing x is the distance from the axis (or the symmetry plane) and y goes up. In a section r = x, and z goes
//! the way the punch moves: z = −y for a punch that is drawn above the sheet. Tools stay where they are drawn; a case
//! file's reader moves each to where it touches the flat sheet.

mod axis;
mod blocks;
mod chain;
mod curve;
mod error;
mod frame;
mod halves;
mod layers;
mod listing;
mod options;
mod orient;
mod outline;
mod parts;
mod reference;
mod section;
mod spline;
mod stroke;

pub use error::ImportError;
pub use listing::LARGEST;
pub use options::{DrawingUnit, Heading, Options, layer};
pub use section::{Operation, Section, Sections};

use crate::model::Role;
use parts::{Part, Parts};
use std::collections::BTreeSet;

/// Reads the tools' sections from the bytes of a DXF file (text; binary DXF is refused).
///
/// # Errors
/// When the drawing is damaged, its unit or axis unknown, or a tool's lines make no chain; with entities and place.
pub fn read(bytes: &[u8], options: &Options) -> Result<Sections, ImportError> {
    let drawing = listing::drawing(&listing::decode(bytes)?)?;
    let mut notes = Vec::new();
    let frame = frame::Frame::of(&drawing.header, options, &mut notes)?;
    let entities = blocks::exploded(&drawing)?;
    let parts = layers::parts(&entities, options, &mut notes)?;
    let mut strokes = Vec::new();
    for part in in_order(&parts) {
        let drawn = stroke::of_part(&entities, &parts, part, &frame, &mut notes)?;
        if !drawn.is_empty() {
            strokes.push((part, drawn));
        }
    }
    if strokes.is_empty() {
        return Err(layers::nothing_drawn(&parts));
    }
    if options.axis.is_none() {
        axis::ask(&strokes, &entities, &frame)?;
    }
    let mut chains = Vec::new();
    for (part, strokes) in strokes {
        chains.push((part, halves::right(strokes, part, &frame, &mut notes)?));
    }
    let heading = orient::heading(&chains, options.punch_moves, &mut notes)?;
    let mut operations: Vec<Operation> = Vec::new();
    for (part, chain) in chains {
        let section = orient::section(part, chain, heading, &frame, &mut notes)?;
        match operations.last_mut().filter(|operation| operation.number == part.operation) {
            Some(operation) => operation.tools.push(section),
            None => operations.push(Operation { number: part.operation, tools: vec![section] }),
        }
    }
    let idle = operations.iter().find(|operation| operation.tool(Role::Punch).is_none());
    if let Some(operation) = idle.filter(|_| operations.len() > 1) {
        let what = format!("of {} operations, {} has no punch", operations.len(), operation.name());
        let help = "draw one on a layer of that operation, or leave its other layers out with --layer NAME=none";
        return Err(ImportError::new(what, help));
    }
    let later = operations.split_off(1);
    let Operation { number, tools } = operations.remove(0);
    Ok(Sections { number, tools, later, notes })
}

fn in_order(parts: &Parts) -> Vec<Part> {
    let operations: BTreeSet<Option<u32>> = parts.values().map(|part| part.operation).collect();
    let all = operations.into_iter().flat_map(|operation| Role::ALL.map(|role| Part { operation, role }));
    all.filter(|part| parts.values().any(|other| other == part)).collect()
}
