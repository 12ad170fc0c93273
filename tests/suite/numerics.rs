//! Bracketing, interpolation, grids, quadrature and the linear solve.

use crate::common::prelude::*;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use stampflow::numerics::block_tridiagonal::{MAX_SHARED, System};
use stampflow::numerics::least_squares::{Ended, Minimum, Parameter, minimise};
use stampflow::numerics::statistics::{quantile, rank_correlation, wilson};
use stampflow::numerics::{Grid, Power};

/// Trust: √2 to the last digits, from either side; a bracket is 2^−n of the first.
#[test]
fn a_root_is_bracketed_from_either_side() {
    let [low, high] = bisect(1.0, 2.0, 50, |x| x * x < 2.0);
    assert!(low * low < 2.0 && high * high >= 2.0 && high - low <= 2f64.powi(-50));
    let [above, below] = bisect(2.0, 1.0, 10, |x| x * x >= 2.0);
    assert!((above - below - 2f64.powi(-10)).abs() < 1e-15 && below < 2f64.sqrt() && above >= 2f64.sqrt());
}

#[test]
fn values_are_interpolated_and_held_and_a_rising_one_is_found() {
    let history = PiecewiseLinear::new(vec![(1.0, 10.0), (3.0, 20.0), (4.0, 0.0)]).expect("rising");
    for (x, value) in [(0.0, 10.0), (1.0, 10.0), (2.0, 15.0), (3.0, 20.0), (3.5, 10.0), (9.0, 0.0)] {
        assert_eq!(history.at(x), value);
    }
    assert_eq!((history.smallest(), history.largest()), (0.0, 20.0));
    assert_eq!(PiecewiseLinear::from(5.0).at(-1.0), 5.0);
    for falling in [vec![], vec![(1.0, 0.0), (1.0, 2.0)], vec![(1.0, 0.0), (f64::NAN, 2.0)]] {
        assert_eq!(PiecewiseLinear::new(falling), None);
    }
    let history = PiecewiseLinear::new(vec![(0.0, 0.0), (2.0, 10.0), (3.0, 30.0)]).expect("rising");
    for (x, value) in [(0.0, 0.0), (1.0, 5.0), (2.0, 10.0), (2.5, 20.0), (3.0, 30.0)] {
        assert_eq!((history.at(x), history.reaches(value)), (value, x));
    }
    assert_eq!([0.0, 1.0, 2.0, 2.1, 3.0, 4.0].map(|x| history.slope_before(x)), [0.0, 5.0, 5.0, 20.0, 20.0, 0.0]);
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
        let layers = lobatto(n);
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
            s.diagonal[i] = Matrix3::from_fn(|a, b| random() + if a == b { 8.0 } else { 0.0 });
            dense.view_mut((3 * i, 3 * i), (3, 3)).copy_from(&s.diagonal[i]);
            if i > 0 {
                (s.lower[i], s.upper[i - 1]) = (Matrix3::from_fn(|_, _| random()), Matrix3::from_fn(|_, _| random()));
                dense.view_mut((3 * i, 3 * i - 3), (3, 3)).copy_from(&s.lower[i]);
                dense.view_mut((3 * i - 3, 3 * i), (3, 3)).copy_from(&s.upper[i - 1]);
            }
            s.rhs[i] = Vector3::from_fn(|_, _| random());
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
        let found = s.rhs.iter().flatten().chain(&s.corner_rhs).copied().take(size);
        let found = DVector::from_iterator(size, found);
        assert!((found - dense.lu().solve(&right).expect("regular")).amax() < 1e-12);
    }
}

/// Trust: products and square roots are right to some round-offs, and so is the library's power.
#[test]
fn shortcuts_are_powers() {
    for exponent in [2.0, 3.0, 4.0, 6.0, 6.5, 8.0, 16.0] {
        let power = Power::new(exponent);
        for x in [1e-8, 0.3, 1.0, 1.9_f64] {
            assert_relative_eq!(power.less_two(x), x.powf(exponent - 2.0), max_relative = 1e-14);
            assert_relative_eq!(power.root(x), x.powf(1.0 / exponent), max_relative = 1e-14);
            assert_relative_eq!(power.inverse_square(x), x.powf(-2.0 / exponent), max_relative = 1e-14);
        }
    }
}

/// Trust: Wilson's interval of 3 of 20 in textbooks (0.0524, 0.3604); of none in n tries z²/(n + z²); ranks by hand.
#[test]
fn intervals_and_ranks_are_those_of_textbooks() {
    let square = 1.959_964f64.powi(2);
    for (hits, tries, low, high) in [(3, 20, 0.0524, 0.3604), (0, 100, 0.0, square / (100.0 + square))] {
        let [_, from, to] = wilson(hits, tries).expect("tries");
        assert_relative_eq!(from, low, max_relative = 2e-3);
        assert_relative_eq!(to, high, max_relative = 2e-3);
    }
    let x = [1.0, 2.0, 3.0, f64::NAN];
    for (y, expected) in
        [([1.0, 8.0, 27.0, 0.0], 1.0), ([3.0, 2.0, 1.0, 9.0], -1.0), ([1.0, 1.0, 2.0, 9.0], 0.75f64.sqrt())]
    {
        assert_relative_eq!(rank_correlation(&x, &y).expect("varies"), expected, max_relative = 1e-12);
    }
    assert_eq!(rank_correlation(&x, &[1.0; 4]), None);
    assert_eq!(quantile(&[1.0, 2.0, 3.0, 4.0], 0.5), 2.5);
}

fn minimum(parameters: &[Parameter], residuals: impl Fn(&[f64]) -> Vec<f64>) -> Minimum {
    let mut all = |points: &[Vec<f64>]| points.iter().map(|point| Some(residuals(point))).collect();
    minimise(parameters, &mut all, 200, 1e-12).expect("residuals")
}

fn parameter(start: f64, low: f64, high: f64) -> Parameter {
    Parameter { start, low, high, step: 1e-6 }
}

/// Trust: Rosenbrock's valley has its minimum, 0, at (1, 1); with x ≤ 0.5 it lies at (0.5, 0.25).
#[test]
fn the_end_of_a_bent_valley_is_found_and_a_bound_is_kept() {
    let valley = |x: &[f64]| vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]];
    for (high, expected, free) in [(5.0, [1.0, 1.0], [true, true]), (0.5, [0.5, 0.25], [false, true])] {
        let found = minimum(&[parameter(-1.2, -5.0, high), parameter(1.0, -5.0, 5.0)], valley);
        assert!(found.values.iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-6), "{:?}", found.values);
        assert_eq!((found.free, found.ended), (free.to_vec(), Ended::Found));
    }
}

/// Trust: a straight line has its textbook variances: s²/Σ(x − x̄)² of the slope, and covariance −x̄ of it.
#[test]
fn the_covariance_of_a_line_is_that_of_textbooks() {
    let (x, y) = ([0.0, 1.0, 2.0, 3.0, 4.0], [1.1, 2.9, 5.2, 6.8, 9.1]);
    let line = |p: &[f64]| x.iter().zip(y).map(|(x, y)| p[0] + p[1] * x - y).collect();
    let found = minimum(&[parameter(0.0, -9.0, 9.0), parameter(0.0, -9.0, 9.0)], line);
    let covariance = found.covariance(found.variance()).expect("told apart");
    let expected = found.variance() / 10.0;
    assert!((covariance[(1, 1)] - expected).abs() < 1e-9 && (covariance[(0, 1)] + 2.0 * expected).abs() < 1e-9);
}
