//! Symbols of the equations of `docs/theory.md`, for `.ci/equations.py` to compare.

use nalgebra::DMatrix;
use serde_json::{Value, json};
use std::{cell::RefCell, collections::BTreeMap};

pub type Matrix = DMatrix<f64>;

/// Random number between two.
pub type Random<'a> = &'a dyn Fn(f64, f64) -> f64;

/// Numbers of equations, what goes into functions and comes out of them, and the relative error of the functions.
pub type Check = (&'static [usize], fn(Random) -> Symbols, f64);

/// Ten samples of every check as JSON.
pub fn samples(checks: &[Check]) -> Value {
    let values = |check: fn(Random) -> Symbols, seed| {
        let random = RefCell::new(fastrand::Rng::with_seed(seed));
        check(&|low, high| low + (high - low) * random.borrow_mut().f64()).0
    };
    let all = checks.iter().map(|(numbers, check, error)| {
        json!({"equations": numbers, "error": error, "samples": (0..10).map(|seed| values(*check, seed)).collect::<Vec<_>>()})
    });
    all.collect()
}

/// Values of symbols as rows of numbers, several where a sum runs over them.
#[derive(Default)]
pub struct Symbols(BTreeMap<String, Vec<Vec<Vec<f64>>>>);

impl Symbols {
    pub fn set(&mut self, name: &str, values: impl IntoIterator<Item = Matrix>) {
        let rows = |value: Matrix| value.row_iter().map(|row| row.iter().copied().collect()).collect();
        self.0.insert(name.to_owned(), values.into_iter().map(rows).collect());
    }

    /// Numbers of names that commas part.
    pub fn numbers<const N: usize>(&mut self, names: &str, values: [f64; N]) {
        let names: Vec<&str> = names.split(", ").collect();
        assert_eq!(names.len(), N, "{names:?}");
        names.iter().zip(values).for_each(|(name, value)| self.list(name, [value]));
    }

    pub fn column(&mut self, name: &str, values: &[f64]) {
        self.set(name, [column(values)]);
    }

    pub fn list(&mut self, name: &str, values: impl IntoIterator<Item = f64>) {
        self.set(name, values.into_iter().map(|value| Matrix::from_element(1, 1, value)));
    }
}

pub fn column(values: &[f64]) -> Matrix {
    Matrix::from_column_slice(values.len(), 1, values)
}
