//! Tool sections from a drawing (DXF): lines, arcs, polylines and splines joined into oriented chains, one per tool.
//!
//! ```text
//! text → listing               what the file holds, line by line: the header's unit, entities and where they stand
//!    │ curve                      the shape of those that tools are drawn with
//!    │ layers                     which layer is which tool
//!    │ stroke, spline             entity → Stroke: pieces in mm, and where they were drawn
//!    │ halves                     cut at the axis; a second half is compared and left out
//!    │ chain                      strokes joined end to end: gaps, overlaps, branches are named
//!    │ orient                     which way the punch moves; the sheet on the left
//!    └ Sections                   a Profile for each tool, as drawn
//! ```
//!
//! # Frame
//! In the drawing x is the distance from the axis (or the symmetry plane) and y goes up. In a section r = x, and z goes
//! the way the punch moves: z = −y for a punch that is drawn above the sheet. Tools stay where they are drawn; a case
//! file's reader moves each to where it touches the flat sheet.

mod chain;
mod curve;
mod error;
mod frame;
mod halves;
mod layers;
mod listing;
mod options;
mod orient;
mod section;
mod spline;
mod stroke;

pub use error::ImportError;
pub use listing::LARGEST;
pub use options::{DrawingUnit, Heading, Options};
pub use section::{Section, Sections};

use crate::model::Role;

/// Reads the tools' sections from the bytes of a DXF file (text; binary DXF is refused).
///
/// # Errors
/// When the bytes are no DXF, the unit is not known, no layer is a tool, or a tool's lines do not make one open chain;
/// the message names the entities and the place in the drawing's own unit.
pub fn read(bytes: &[u8], options: &Options) -> Result<Sections, ImportError> {
    let drawing = listing::drawing(&listing::decode(bytes)?)?;
    let mut notes = Vec::new();
    let frame = frame::Frame::of(&drawing.header, options, &mut notes)?;
    let roles = layers::roles(&drawing.entities, options, &mut notes)?;
    let mut chains = Vec::new();
    for role in Role::ALL {
        let strokes = stroke::of_role(&drawing.entities, &roles, role, &frame, &mut notes)?;
        if !strokes.is_empty() {
            chains.push((role, halves::right(strokes, role, &frame, &mut notes)?));
        }
    }
    if chains.is_empty() {
        return Err(layers::nothing_drawn(&roles));
    }
    let heading = orient::heading(&chains, options.punch_moves, &mut notes)?;
    let oriented = chains.into_iter().map(|(role, chain)| orient::section(role, chain, heading, &frame));
    Ok(Sections { tools: oriented.collect::<Result<_, _>>()?, notes })
}
