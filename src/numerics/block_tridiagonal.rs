//! The linear system of an iteration: block-tridiagonal, bordered by the shared unknowns, solved exactly in O(n).

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Most shared unknowns (holder positions, pressures) a model can have.
pub const MAX_SHARED: usize = 3;

type Corner = SMatrix<f64, MAX_SHARED, MAX_SHARED>;
type Shared = SVector<f64, MAX_SHARED>;

/// ```text
/// [ H  C ] [ x ]   [ f ]      H: one 3×3 block a node on three diagonals, not symmetric
/// [ R  D ] [ y ] = [ g ]      C, R, D: columns, rows and corner of the shared unknowns y
/// ```
#[derive(Clone, Debug, Default)]
pub struct System {
    /// Blocks of H left of the diagonal, of node i with node i − 1; the first is not used.
    pub lower: Vec<Matrix3<f64>>,
    /// Blocks of H on the diagonal.
    pub diagonal: Vec<Matrix3<f64>>,
    /// Blocks of H right of the diagonal, of node i with node i + 1; the last is not used.
    pub upper: Vec<Matrix3<f64>>,
    /// f, by nodes; after the solution x.
    pub rhs: Vec<Vector3<f64>>,
    /// C, by nodes and shared unknowns.
    pub columns: Vec<[Vector3<f64>; MAX_SHARED]>,
    /// R, by nodes and shared unknowns.
    pub rows: Vec<[Vector3<f64>; MAX_SHARED]>,
    /// D.
    pub corner: Corner,
    /// g; after the solution y.
    pub corner_rhs: Shared,
    shared: usize,
}

impl System {
    /// A system of `nodes` blocks and `shared` ≤ [`MAX_SHARED`] shared unknowns.
    pub fn new(nodes: usize, shared: usize) -> Self {
        assert!(shared <= MAX_SHARED, "at most {MAX_SHARED} shared unknowns");
        let [lower, diagonal, upper] = [(); 3].map(|()| vec![Matrix3::zeros(); nodes]);
        let [columns, rows] = [(); 2].map(|()| vec![[Vector3::zeros(); MAX_SHARED]; nodes]);
        let (rhs, corner) = (vec![Vector3::zeros(); nodes], Corner::identity());
        Self { lower, diagonal, upper, rhs, columns, rows, corner, shared, ..Self::default() }
    }

    /// Takes the three diagonals of another system of the same size.
    pub fn take_matrix(&mut self, other: &Self) {
        self.lower.copy_from_slice(&other.lower);
        self.diagonal.copy_from_slice(&other.diagonal);
        self.upper.copy_from_slice(&other.upper);
    }

    /// Zeroes everything; unused shared unknowns keep a one on their diagonal.
    pub fn clear(&mut self) {
        for blocks in [&mut self.lower, &mut self.diagonal, &mut self.upper] {
            blocks.fill(Matrix3::zeros());
        }
        self.rhs.fill(Vector3::zeros());
        let borders = self.columns.iter_mut().chain(&mut self.rows);
        borders.for_each(|node| node[..self.shared].fill(Vector3::zeros()));
        self.corner = Corner::from_diagonal(&Shared::from_fn(|k, _| if k < self.shared { 0.0 } else { 1.0 }));
        self.corner_rhs = Shared::zeros();
    }

    /// Adds forces on the nodes `e` and `e + 1`.
    pub fn add_forces(&mut self, e: usize, forces: &SVector<f64, 6>) {
        self.rhs[e] += forces.fixed_rows::<3>(0);
        self.rhs[e + 1] += forces.fixed_rows::<3>(3);
    }

    /// Adds the matrix of an element between the nodes `e` and `e + 1`.
    pub fn add_element(&mut self, e: usize, matrix: &SMatrix<f64, 6, 6>) {
        self.diagonal[e] += matrix.fixed_view::<3, 3>(0, 0);
        self.diagonal[e + 1] += matrix.fixed_view::<3, 3>(3, 3);
        self.upper[e] += matrix.fixed_view::<3, 3>(0, 3);
        self.lower[e + 1] += matrix.fixed_view::<3, 3>(3, 0);
    }

    /// Fixes one freedom of a node: its equation becomes x = 0.
    pub fn fix(&mut self, node: usize, freedom: usize) {
        for block in [&mut self.lower[node], &mut self.diagonal[node], &mut self.upper[node]] {
            block.row_mut(freedom).fill(0.0);
        }
        self.diagonal[node][(freedom, freedom)] = 1.0;
        self.rhs[node][freedom] = 0.0;
        self.columns[node].iter_mut().for_each(|column| column[freedom] = 0.0);
    }

    /// Solves in place by block elimination and a Schur complement: x in `rhs`, y in `corner_rhs`. The matrix is lost.
    ///
    /// Returns `false` when a pivot block is singular or a number is not finite.
    #[must_use]
    pub fn solve(&mut self) -> bool {
        let n = self.rhs.len();
        for i in 0..n {
            if i > 0 {
                let l = self.lower[i];
                self.diagonal[i] -= l * self.upper[i - 1];
                let above = self.rhs[i - 1];
                self.rhs[i] -= l * above;
                for k in 0..self.shared {
                    let above = self.columns[i - 1][k];
                    self.columns[i][k] -= l * above;
                }
            }
            let Some(inverse) = self.diagonal[i].try_inverse() else { return false };
            self.upper[i] = inverse * self.upper[i];
            self.rhs[i] = inverse * self.rhs[i];
            self.columns[i][..self.shared].iter_mut().for_each(|column| *column = inverse * *column);
        }
        for i in (0..n - 1).rev() {
            let u = self.upper[i];
            let below = self.rhs[i + 1];
            self.rhs[i] -= u * below;
            for k in 0..self.shared {
                let below = self.columns[i + 1][k];
                self.columns[i][k] -= u * below;
            }
        }
        if self.shared > 0 {
            for i in 0..n {
                for k in 0..self.shared {
                    let row = self.rows[i][k];
                    self.corner_rhs[k] -= row.dot(&self.rhs[i]);
                    for j in 0..self.shared {
                        self.corner[(k, j)] -= row.dot(&self.columns[i][j]);
                    }
                }
            }
            let Some(inverse) = self.corner.try_inverse() else { return false };
            self.corner_rhs = inverse * self.corner_rhs;
            for i in 0..n {
                for k in 0..self.shared {
                    self.rhs[i] -= self.columns[i][k] * self.corner_rhs[k];
                }
            }
        }
        self.rhs.iter().all(|x| x.iter().all(|v| v.is_finite())) && self.corner_rhs.iter().all(|v| v.is_finite())
    }
}
