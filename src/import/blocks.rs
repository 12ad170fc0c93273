//! Blocks: parts of a drawing that are drawn once and placed with a reference (INSERT) as often as needed.
//!
//! ```text
//! x' = p + R(φ) [S (x − b) + (i c, j r)]        b base of the block; p, φ, S the reference's point, rotation and scales;
//!                                               i, j column and row of an array, c, r their distances
//! ```

use super::dxf::{Block, Drawing, ENTITIES, Entity, Source, cut};
use super::{Result, ensure};
use crate::geometry::Point;
use nalgebra::{Matrix2, Rotation2};
use std::collections::BTreeMap;

const DEEPEST: usize = 50;
const NO_LAYER: &str = "0";

#[derive(Debug)]
pub(super) struct Placed<'a> {
    pub source: Source,
    pub entity: &'a Entity,
    pub placement: Placement,
}

/// Map from a block to the drawing, x ↦ A x + s \[drawing units\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    matrix: Matrix2<f64>,
    shift: Point,
}

impl Placement {
    fn after(&self, inner: &Self) -> Self {
        Self { matrix: self.matrix * inner.matrix, shift: self.at(inner.shift) }
    }

    pub fn at(&self, p: Point) -> Point {
        self.matrix * p + self.shift
    }

    /// −1 for a mirror image in the x axis, taken before the rotation, else 1.
    pub fn sense(&self) -> f64 {
        self.matrix.determinant().signum()
    }

    /// Scale and rotation \[rad\]; `None` for a map that makes ellipses of circles.
    pub fn similarity(&self) -> Option<(f64, f64)> {
        let (x, y) = (self.matrix.column(0), self.matrix.column(1));
        let scale = x.norm();
        let round = (y.norm() - scale).abs() <= 1e-9 * scale && x.dot(&y).abs() <= 1e-9 * scale * scale;
        round.then(|| (scale, x.y.atan2(x.x)))
    }
}

fn placements(reference: &Entity, base: Point) -> Option<impl Iterator<Item = Placement> + use<>> {
    let [x, y, z] = reference.normal();
    let [across, up] = [41, 42].map(|code| reference.number(code, 1.0));
    if x.abs() > 1e-9 || y.abs() > 1e-9 || z == 0.0 || across == 0.0 || up == 0.0 {
        return None;
    }
    let turned = Rotation2::new(reference.number(50, 0.0).to_radians()).into_inner();
    let scaled = turned * Matrix2::new(across, 0.0, 0.0, up);
    let side = Matrix2::new(z.signum(), 0.0, 0.0, 1.0);
    let [columns, rows] = [70, 71].map(|code| reference.number(code, 1.0).clamp(1.0, ENTITIES as f64) as usize);
    let [x, y, _] = reference.point(10);
    let spacing = [44, 45].map(|code| reference.number(code, 0.0));
    let cells = (0..rows).flat_map(move |row| (0..columns).map(move |column| [column, row]));
    Some(cells.map(move |[column, row]| {
        let cell = turned * Point::new(column as f64 * spacing[0], row as f64 * spacing[1]);
        Placement { matrix: side * scaled, shift: side * (Point::new(x, y) + cell - scaled * base) }
    }))
}

pub(super) fn exploded(drawing: &Drawing) -> Result<Vec<Placed<'_>>> {
    let blocks = drawing.blocks.iter().filter(|block| !block.is_external);
    let blocks = blocks.map(|block| (block.name.to_lowercase(), block)).collect();
    let mut explosion = Explosion { blocks, ..Explosion::default() };
    explosion.entities(&drawing.entities, Placement { matrix: Matrix2::identity(), shift: Point::zeros() }, None)?;
    Ok(explosion.placed)
}

#[derive(Default)]
struct Explosion<'a> {
    /// Blocks by their names in small letters.
    blocks: BTreeMap<String, &'a Block>,
    /// Blocks that are being placed, the innermost last.
    open: Vec<&'a str>,
    count: usize,
    placed: Vec<Placed<'a>>,
}

impl<'a> Explosion<'a> {
    fn entities(&mut self, entities: &'a [Entity], outer: Placement, by: Option<&Source>) -> Result {
        for entity in entities {
            self.count(&entity.source)?;
            let source = placed_source(&entity.source, &outer, by);
            let name = Some(&source).filter(|source| source.kind == "INSERT").map(|source| source.block.to_lowercase());
            let block = name.and_then(|name| self.blocks.get(&name).copied());
            let Some((block, inner)) = block.and_then(|block| Some((block, placements(entity, block.base)?))) else {
                self.placed.push(Placed { source, entity, placement: outer });
                continue;
            };
            if self.open.contains(&block.name.as_str()) || self.open.len() == DEEPEST {
                let what = match self.open.len() {
                    DEEPEST => format!("blocks are placed in each other more than {DEEPEST} deep: {source}"),
                    _ => format!("the block \"{}\" is placed in itself: {source}", cut(&block.name)),
                };
                return Err(source.error(what, "explode the tools' blocks to lines, arcs and polylines"));
            }
            self.open.push(&block.name);
            for inner in inner {
                self.count(&source)?;
                self.entities(&block.entities, outer.after(&inner), Some(&source))?;
            }
            self.open.pop();
        }
        Ok(())
    }

    fn count(&mut self, source: &Source) -> Result {
        self.count += 1;
        let what = || format!("with its blocks the drawing has more than {ENTITIES} entities: {source} is one more");
        ensure(self.count <= ENTITIES, || source.error(what(), "save the tools' layers only"))
    }
}

fn placed_source(entity: &Source, placement: &Placement, by: Option<&Source>) -> Source {
    let mut source = Source { at: placement.at(entity.at), ..entity.clone() };
    let Some(by) = by else { return source };
    source.on_paper |= by.on_paper;
    if source.layer == NO_LAYER {
        source.layer.clone_from(if by.layer == NO_LAYER { &by.block } else { &by.layer });
    }
    if source.kind != "INSERT" {
        source.block.clone_from(&by.block);
    }
    source
}
