//! Bracketing, interpolation, grids, quadrature and the linear solve.

use crate::common::prelude::*;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use stampflow::numerics::Grid;
use stampflow::numerics::block_tridiagonal::{MAX_SHARED, System};
use stampflow::numerics::quadrature::lobatto as rule;

/// Trust: √2 to the last digits, from either side; a bracket is 2^−n of the first.
#[test]
fn a_root_is_bracketed_from_either_side() {
    let [low, high] = bisect(1.0, 2.0, 50, |x| x * x < 2.0);
    assert!(low * low < 2.0 && high * high >= 2.0 && high - low <= 2f64.powi(-50));
    let [above, below] = bisect(2.0, 1.0, 10, |x| x * x >= 2.0);
    assert!((above - below - 2f64.powi(-10)).abs() < 1e-15 && below < 2f64.sqrt() && above >= 2f64.sqrt());
}

#[test]
fn values_are_interpolated_and_held() {
    let history = PiecewiseLinear::new(vec![(1.0, 10.0), (3.0, 20.0), (4.0, 0.0)]).expect("rising");
    for (x, value) in [(0.0, 10.0), (1.0, 10.0), (2.0, 15.0), (3.0, 20.0), (3.5, 10.0), (9.0, 0.0)] {
        assert_eq!(history.at(x), value);
    }
    assert_eq!((history.smallest(), history.largest()), (0.0, 20.0));
    assert_eq!(PiecewiseLinear::from(5.0).at(-1.0), 5.0);
    for falling in [vec![], vec![(1.0, 0.0), (1.0, 2.0)], vec![(1.0, 0.0), (f64::NAN, 2.0)]] {
        assert_eq!(PiecewiseLinear::new(falling), None);
    }
}

#[test]
fn a_rising_value_is_found_cut_and_drawn_out() {
    let history = PiecewiseLinear::new(vec![(0.0, 0.0), (2.0, 10.0), (3.0, 30.0)]).expect("rising");
    for (x, value) in [(0.0, 0.0), (1.0, 5.0), (2.0, 10.0), (2.5, 20.0), (3.0, 30.0)] {
        assert_eq!((history.at(x), history.reaches(value)), (value, x));
    }
    assert_eq!([0.0, 1.0, 2.0, 2.1, 3.0, 4.0].map(|x| history.slope_before(x)), [0.0, 5.0, 5.0, 20.0, 20.0, 0.0]);
    assert_eq!(history.up_to(4.0).points(), [(0.0, 0.0), (0.8, 4.0)]);
    assert_eq!(history.up_to(10.0).points(), [(0.0, 0.0), (2.0, 10.0)]);
    assert_eq!(history.up_to(40.0).points(), [(0.0, 0.0), (2.0, 10.0), (3.5, 40.0)]);
}

/// Trust: by construction.
#[test]
fn rows_and_columns_are_kept_apart() {
    let mut grid = Grid::from_values(3, 0..6);
    assert_eq!((grid.row(1), grid[(1, 0)], grid.columns()), (&[3, 4, 5][..], 3, 3));
    grid[(0, 2)] = 9;
    assert_eq!(grid.iter().sum::<i32>(), 22);
    grid.truncate_columns(2);
    assert_eq!(grid.rows().collect::<Vec<_>>(), [[0, 1], [3, 4]]);
    grid.truncate_rows(1);
    assert_eq!(*grid, [0, 1]);
    assert_eq!(Grid::new(0, 0, 1.0).rows().count(), 0);
}

/// Trust: the rule integrates every monomial it must, to round-off.
#[test]
fn integrates_monomials_up_to_its_degree() {
    for n in 2..=51 {
        let layers = rule(n);
        for degree in 0..=(2 * n - 3).min(40) {
            let sum: f64 = layers.iter().map(|l| l.weight * l.xi.powi(degree as i32)).sum();
            let exact = if degree % 2 == 0 { 1.0 / (degree as f64 + 1.0) } else { 0.0 };
            assert!((sum - exact).abs() < 1e-13, "{n} points, degree {degree}: {sum} for {exact}");
        }
    }
}

/// Trust: nalgebra's dense LU with pivoting on the same numbers, to round-off.
#[test]
fn agrees_with_a_dense_solve() {
    let mut seed = 7u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / 2f64.powi(30) - 1.0
    };
    for shared in 0..=MAX_SHARED {
        let n = 7;
        let mut s = System::new(n, shared);
        s.clear();
        let size = 3 * n + shared;
        let (mut dense, mut right) = (DMatrix::zeros(size, size), DVector::zeros(size));
        for i in 0..n {
            s.lower[i] = if i > 0 { Matrix3::from_fn(|_, _| random()) } else { Matrix3::zeros() };
            s.upper[i] = if i + 1 < n { Matrix3::from_fn(|_, _| random()) } else { Matrix3::zeros() };
            s.diagonal[i] = Matrix3::from_fn(|a, b| random() + if a == b { 8.0 } else { 0.0 });
            s.rhs[i] = Vector3::from_fn(|_, _| random());
            if i > 0 {
                dense.view_mut((3 * i, 3 * i - 3), (3, 3)).copy_from(&s.lower[i]);
            }
            if i + 1 < n {
                dense.view_mut((3 * i, 3 * i + 3), (3, 3)).copy_from(&s.upper[i]);
            }
            dense.view_mut((3 * i, 3 * i), (3, 3)).copy_from(&s.diagonal[i]);
            right.rows_mut(3 * i, 3).copy_from(&s.rhs[i]);
            for k in 0..shared {
                s.columns[i][k] = Vector3::from_fn(|_, _| random());
                s.rows[i][k] = Vector3::from_fn(|_, _| random());
                dense.view_mut((3 * i, 3 * n + k), (3, 1)).copy_from(&s.columns[i][k]);
                dense.view_mut((3 * n + k, 3 * i), (1, 3)).copy_from(&s.rows[i][k].transpose());
            }
        }
        for k in 0..shared {
            for j in 0..shared {
                s.corner[(k, j)] = random() + if k == j { 5.0 } else { 0.0 };
                dense[(3 * n + k, 3 * n + j)] = s.corner[(k, j)];
            }
            s.corner_rhs[k] = random();
            right[3 * n + k] = s.corner_rhs[k];
        }
        assert!(s.solve());
        let exact = dense.lu().solve(&right).expect("regular");
        for i in 0..n {
            for d in 0..3 {
                assert!((s.rhs[i][d] - exact[3 * i + d]).abs() < 1e-12);
            }
        }
        for k in 0..shared {
            assert!((s.corner_rhs[k] - exact[3 * n + k]).abs() < 1e-12);
        }
    }
}
