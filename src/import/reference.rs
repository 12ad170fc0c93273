//! Placement of a block.
//!
//! ```text
//! x' = p + R(φ) [S (x − b) + (i c, j r)]        b base of the block; p, φ, S the reference's point, rotation and scales;
//!                                               i, j column and row of an array, c, r their distances
//! ```

use super::curve::{Group, Place, UP};
use crate::geometry::Point;
use nalgebra::{Matrix2, Rotation2};

/// INSERT: placement of a block.
#[derive(Clone, Debug)]
pub(super) struct Reference {
    at: Place,
    scale: Place,
    /// \[degrees\]
    rotation: f64,
    count: [f64; 2],
    spacing: [f64; 2],
    normal: Place,
}

impl Default for Reference {
    fn default() -> Self {
        Self { at: [0.0; 3], scale: [1.0; 3], rotation: 0.0, count: [1.0; 2], spacing: [0.0; 2], normal: UP }
    }
}

impl Reference {
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

    /// All places of an array, up to `most` in each direction; `None` for a block out of the plane or without extent.
    pub fn placements(&self, base: Point, most: usize) -> Option<impl Iterator<Item = Placement> + use<>> {
        let [x, y, z] = self.normal;
        let [across, up, _] = self.scale;
        if x.abs() > 1e-9 || y.abs() > 1e-9 || z == 0.0 || across == 0.0 || up == 0.0 {
            return None;
        }
        let turned = Rotation2::new(self.rotation.to_radians()).into_inner();
        let scaled = turned * Matrix2::new(across, 0.0, 0.0, up);
        let side = Matrix2::new(z.signum(), 0.0, 0.0, 1.0);
        let [columns, rows] = self.count.map(|count| count.clamp(1.0, most as f64) as usize);
        let (at, spacing) = (Point::new(self.at[0], self.at[1]), self.spacing);
        let cells = (0..rows).flat_map(move |row| (0..columns).map(move |column| [column, row]));
        Some(cells.map(move |[column, row]| {
            let cell = turned * Point::new(column as f64 * spacing[0], row as f64 * spacing[1]);
            Placement { matrix: side * scaled, shift: side * (at + cell - scaled * base) }
        }))
    }
}

/// Map from a block to the drawing, x ↦ A x + s \[drawing units\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    matrix: Matrix2<f64>,
    shift: Point,
}

pub(super) struct Similarity {
    pub scale: f64,
    /// \[rad\]
    pub rotation: f64,
    /// −1 for a mirror image in the x axis, taken before the rotation, else 1.
    pub sense: f64,
}

impl Placement {
    pub fn identity() -> Self {
        Self { matrix: Matrix2::identity(), shift: Point::zeros() }
    }

    pub fn after(&self, inner: &Self) -> Self {
        Self { matrix: self.matrix * inner.matrix, shift: self.at(inner.shift) }
    }

    pub fn at(&self, p: Point) -> Point {
        self.matrix * p + self.shift
    }

    pub fn sense(&self) -> f64 {
        self.matrix.determinant().signum()
    }

    /// `None` for a map that makes ellipses of circles.
    pub fn similarity(&self) -> Option<Similarity> {
        let (x, y) = (self.matrix.column(0), self.matrix.column(1));
        let scale = x.norm();
        let round = (y.norm() - scale).abs() <= 1e-9 * scale && x.dot(&y).abs() <= 1e-9 * scale * scale;
        round.then(|| Similarity { scale, rotation: x.y.atan2(x.x), sense: self.sense() })
    }
}
