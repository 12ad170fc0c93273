//! The dxf crate's reading of the entities that tools are drawn with.

use super::ImportError;
use super::listing::Listed;
use dxf::entities::{Entity, EntityType};
use dxf::{Drawing, Header};

/// Kinds that become pieces of a section.
const CURVES: [&str; 5] = ["LINE", "ARC", "LWPOLYLINE", "POLYLINE", "SPLINE"];

/// What was read of a drawing.
pub(super) struct Reading {
    pub header: Header,
    /// As many as the listing has of these kinds, in the same order.
    entities: Vec<Entity>,
}

impl Reading {
    /// The curves with what the file says of them, those on paper sheets left out.
    pub fn curves<'a>(&'a self, listed: &'a [Listed]) -> impl Iterator<Item = (&'a Entity, &'a Listed)> {
        let curves = listed.iter().filter(|entry| is_curve(entry));
        self.entities.iter().zip(curves).filter(|(_, entry)| !entry.on_paper)
    }
}

/// Whether it is of a kind that becomes pieces of a section.
pub(super) fn is_curve(entry: &Listed) -> bool {
    CURVES.contains(&entry.kind.as_str())
}

/// Reads a text whose entities were listed.
///
/// # Errors
/// When the crate cannot read it, or reads fewer curves than there are.
pub(super) fn drawing(text: &str, listed: &[Listed]) -> Result<Reading, ImportError> {
    let again = "open the drawing in a CAD program and save it as DXF again";
    let drawing = Drawing::load_with_encoding(&mut text.as_bytes(), encoding_rs::UTF_8)
        .map_err(|error| ImportError::new(format!("the drawing cannot be read: {error}"), again))?;
    let is_read = |entity: &&Entity| {
        matches!(
            entity.specific,
            EntityType::Line(_)
                | EntityType::Arc(_)
                | EntityType::LwPolyline(_)
                | EntityType::Polyline(_)
                | EntityType::Spline(_)
        )
    };
    let entities: Vec<Entity> = drawing.entities().filter(is_read).cloned().collect();
    let mut curves = listed.iter().filter(|entry| is_curve(entry));
    if let Some(lost) = curves.nth(entities.len()) {
        return Err(ImportError::new(format!("the drawing cannot be read from {lost} on"), again).at(lost.line));
    }
    Ok(Reading { header: drawing.header.clone(), entities })
}
