//! Blocks: parts of a drawing that are drawn once and placed with a reference (INSERT) as often as needed.
//!
//! ```text
//! x' = p + R(φ) [S (x − b) + (i c, j r)]        b base of the block; p, φ, S the reference's point, rotation and scales;
//!                                               i, j column and row of an array, c, r their distances
//! ```

use super::curve::{Curve, Group, Place, UP};
use super::error::ImportError;
use super::listing::{Drawing, ENTITIES, Entity, Listed, Shape, cut, whole};
use crate::geometry::Point;
use nalgebra::{Matrix2, Rotation2};
use std::collections::BTreeMap;

/// Blocks inside blocks are followed so deep.
const DEEPEST: usize = 50;
/// The layer whose entities take on that of the reference.
const NO_LAYER: &str = "0";

/// A block as the file lists it.
#[derive(Debug, Default)]
pub(super) struct Block {
    name: String,
    /// The point that a reference places, in drawing units.
    base: Point,
    /// Whether it stands for another file.
    is_external: bool,
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

/// INSERT: where and how a block is placed.
#[derive(Clone, Debug)]
pub(super) struct Reference {
    at: Place,
    scale: Place,
    /// \[degrees\]
    rotation: f64,
    /// Columns and rows.
    count: [f64; 2],
    /// Distance of columns and of rows.
    spacing: [f64; 2],
    normal: Place,
}

impl Default for Reference {
    fn default() -> Self {
        Self { at: [0.0; 3], scale: [1.0; 3], rotation: 0.0, count: [1.0; 2], spacing: [0.0; 2], normal: UP }
    }
}

impl Reference {
    /// Where the value of a group goes.
    pub fn group(&mut self, code: i32) -> Group<'_> {
        Group::Number(match code {
            10 | 20 | 30 => &mut self.at[code as usize / 10 - 1],
            41..=43 => &mut self.scale[code as usize - 41],
            44 | 45 => &mut self.spacing[code as usize - 44],
            50 => &mut self.rotation,
            70 | 71 => &mut self.count[code as usize - 70],
            210 | 220 | 230 => &mut self.normal[code as usize / 10 - 21],
            _ => return Group::Other,
        })
    }

    /// Every place of an array; `None` of a block that is turned out of the plane or has no extent.
    fn placements(&self, base: Point) -> Option<impl Iterator<Item = Placement> + use<>> {
        let [x, y, z] = self.normal;
        let [across, up, _] = self.scale;
        if x.abs() > 1e-9 || y.abs() > 1e-9 || z == 0.0 || across == 0.0 || up == 0.0 {
            return None;
        }
        let turned = Rotation2::new(self.rotation.to_radians()).into_inner();
        let scaled = turned * Matrix2::new(across, 0.0, 0.0, up);
        let side = Matrix2::new(z.signum(), 0.0, 0.0, 1.0);
        let [columns, rows] = self.count.map(|count| count.clamp(1.0, ENTITIES as f64) as usize);
        let (at, spacing) = (Point::new(self.at[0], self.at[1]), self.spacing);
        let cells = (0..rows).flat_map(move |row| (0..columns).map(move |column| [column, row]));
        Some(cells.map(move |[column, row]| {
            let cell = turned * Point::new(column as f64 * spacing[0], row as f64 * spacing[1]);
            Placement { matrix: side * scaled, shift: side * (at + cell - scaled * base) }
        }))
    }
}

/// From the coordinates of a block to those of the drawing: x ↦ A x + s, in drawing units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    matrix: Matrix2<f64>,
    shift: Point,
}

/// What a placement does to a circle.
pub(super) struct Similarity {
    pub scale: f64,
    /// \[rad\]
    pub rotation: f64,
    /// −1 where it mirrors, else 1; the mirror image in the x axis is taken before the rotation.
    pub sense: f64,
}

impl Placement {
    fn identity() -> Self {
        Self { matrix: Matrix2::identity(), shift: Point::zeros() }
    }

    fn after(&self, inner: &Self) -> Self {
        Self { matrix: self.matrix * inner.matrix, shift: self.at(inner.shift) }
    }

    /// Where a point of the block is in the drawing.
    pub fn at(&self, p: Point) -> Point {
        self.matrix * p + self.shift
    }

    /// −1 where it mirrors, else 1.
    pub fn sense(&self) -> f64 {
        self.matrix.determinant().signum()
    }

    /// `None` where it makes ellipses of circles.
    pub fn similarity(&self) -> Option<Similarity> {
        let (x, y) = (self.matrix.column(0), self.matrix.column(1));
        let scale = x.norm();
        let round = (y.norm() - scale).abs() <= 1e-9 * scale && x.dot(&y).abs() <= 1e-9 * scale * scale;
        round.then(|| Similarity { scale, rotation: x.y.atan2(x.x), sense: self.sense() })
    }
}

/// An entity where the drawing has it: of the model or a paper sheet, or placed by references.
#[derive(Debug)]
pub(super) struct Placed<'a> {
    pub listed: Listed,
    /// Its shape where it is one that tools are drawn with.
    pub curve: Option<&'a Curve>,
    pub placement: Placement,
}

/// All entities of a drawing, each block as often as it is referred to. A reference to what is not in the file, or that is not
/// in the drawing's plane, stays one.
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
    /// By their names in small letters.
    blocks: BTreeMap<String, &'a Block>,
    /// The blocks that are being placed, the innermost last.
    open: Vec<&'a str>,
    count: usize,
    found: Vec<Placed<'a>>,
}

impl<'a> Explosion<'a> {
    /// Places entities; `by` is the reference that they are placed by.
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
        let placed = block.and_then(|block| Some((block, reference.placements(block.base)?)));
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

    /// An entity as it is placed. Without a layer of its own it has that of the reference, and where that has none, the name of
    /// the block: a part's file that is placed whole is a block of that name.
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
