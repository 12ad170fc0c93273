//! Blocks: parts of a drawing that are drawn once and placed with a reference (INSERT) as often as needed.

use super::curve::Curve;
use super::error::ImportError;
use super::listing::{Block, Drawing, ENTITIES, Entity, Listed, Shape, cut};
use super::reference::{Placement, Reference};
use std::collections::BTreeMap;

const DEEPEST: usize = 50;
/// Layer whose entities take that of the reference.
const NO_LAYER: &str = "0";

/// Entity as it is placed in the drawing.
#[derive(Debug)]
pub(super) struct Placed<'a> {
    pub listed: Listed,
    pub curve: Option<&'a Curve>,
    pub placement: Placement,
}

/// Entities of a drawing with all blocks placed; a reference to a missing block or out of the plane stays.
///
/// # Errors
/// When a block holds itself, or there are too many entities.
pub(super) fn exploded(drawing: &Drawing) -> Result<Vec<Placed<'_>>, ImportError> {
    let blocks = drawing.blocks.iter().filter(|block| !block.is_external);
    let blocks = blocks.map(|block| (block.name.to_lowercase(), block)).collect();
    let mut explosion = Explosion { drawing, blocks, open: Vec::new(), count: 0, found: Vec::new() };
    explosion.entities(&drawing.entities, Placement::identity(), None)?;
    Ok(explosion.found)
}

struct Explosion<'a> {
    drawing: &'a Drawing,
    /// Blocks by their names in small letters.
    blocks: BTreeMap<String, &'a Block>,
    /// Blocks that are being placed, the innermost last.
    open: Vec<&'a str>,
    count: usize,
    found: Vec<Placed<'a>>,
}

impl<'a> Explosion<'a> {
    /// Places entities; `by` is their reference.
    fn entities(
        &mut self,
        entities: &'a [Entity],
        placement: Placement,
        by: Option<&Listed>,
    ) -> Result<(), ImportError> {
        for entity in entities {
            self.count(&entity.listed)?;
            let listed = self.listed(&entity.listed, &placement, by);
            match &entity.shape {
                Shape::Curve(curve) => self.found.push(Placed { listed, curve: Some(curve), placement }),
                Shape::Other => self.found.push(Placed { listed, curve: None, placement }),
                Shape::Reference(reference) => self.reference(reference, &placement, listed)?,
            }
        }
        Ok(())
    }

    fn reference(&mut self, reference: &Reference, outer: &Placement, listed: Listed) -> Result<(), ImportError> {
        let block = self.blocks.get(&listed.block.to_lowercase()).copied();
        let placed = block.and_then(|block| Some((block, reference.placements(block.base, ENTITIES)?)));
        let Some((block, placements)) = placed else {
            self.found.push(Placed { listed, curve: None, placement: *outer });
            return Ok(());
        };
        if self.open.contains(&block.name.as_str()) || self.open.len() == DEEPEST {
            let what = match self.open.len() {
                DEEPEST => format!("blocks are placed in each other more than {DEEPEST} deep: {listed}"),
                _ => format!("the block \"{}\" is placed in itself: {listed}", cut(&block.name)),
            };
            return Err(
                ImportError::new(what, "explode the tools' blocks to lines, arcs and polylines").at(listed.line)
            );
        }
        self.open.push(&block.name);
        for inner in placements {
            self.count(&listed)?;
            self.entities(&block.entities, outer.after(&inner), Some(&listed))?;
        }
        self.open.pop();
        Ok(())
    }

    fn count(&mut self, listed: &Listed) -> Result<(), ImportError> {
        self.count += 1;
        if self.count <= ENTITIES {
            return Ok(());
        }
        let what = format!("with its blocks the drawing has more than {ENTITIES} entities: {listed} is one more");
        Err(ImportError::new(what, "save the tools' layers only").at(listed.line))
    }

    /// Entity as it is placed, with the layer of its reference if it has none, or else the block's name as its layer.
    fn listed(&self, entity: &Listed, placement: &Placement, by: Option<&Listed>) -> Listed {
        let mut listed = entity.clone();
        let at = placement.at(entity.at.into());
        listed.at = [at.x, at.y];
        if let Some(by) = by {
            listed.on_paper |= by.on_paper;
            if listed.layer == NO_LAYER {
                listed.layer.clone_from(if by.layer == NO_LAYER { &by.block } else { &by.layer });
            }
            if listed.kind != "INSERT" {
                listed.block.clone_from(&by.block);
            }
        }
        if matches!(listed.line_type.to_uppercase().as_str(), "" | "BYLAYER") {
            listed.line_type = self.drawing.line_types.get(&listed.layer).cloned().unwrap_or_default();
        }
        listed
    }
}
