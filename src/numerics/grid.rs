//! Values in rows of equal length: tools by nodes, elements by thickness points.

use std::ops::{Deref, DerefMut, Index, IndexMut};

/// Values by row and column over one vector, row after row; as a slice, all of them in that order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grid<T> {
    columns: usize,
    values: Vec<T>,
}

impl<T: Clone> Grid<T> {
    /// `rows` by `columns` times the same value.
    pub fn new(rows: usize, columns: usize, value: T) -> Self {
        Self { columns, values: vec![value; rows * columns] }
    }

    /// Keeps the first `columns` of every row.
    pub fn truncate_columns(&mut self, columns: usize) {
        let columns = columns.min(self.columns);
        *self = Self { columns, values: self.rows().flat_map(|row| &row[..columns]).cloned().collect() };
    }
}

impl<T> Grid<T> {
    /// From values row after row, whose number is a multiple of `columns`.
    pub fn from_values(columns: usize, values: impl IntoIterator<Item = T>) -> Self {
        Self { columns, values: values.into_iter().collect() }
    }

    /// Keeps the first `rows`.
    pub fn truncate_rows(&mut self, rows: usize) {
        self.values.truncate(rows * self.columns);
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// One row.
    pub fn row(&self, row: usize) -> &[T] {
        &self.values[row * self.columns..(row + 1) * self.columns]
    }

    /// One row, to be changed.
    pub fn row_mut(&mut self, row: usize) -> &mut [T] {
        &mut self.values[row * self.columns..(row + 1) * self.columns]
    }

    /// Every row.
    pub fn rows(&self) -> std::slice::ChunksExact<'_, T> {
        self.values.chunks_exact(self.columns.max(1))
    }

    /// Every row, to be changed.
    pub fn rows_mut(&mut self) -> std::slice::ChunksExactMut<'_, T> {
        self.values.chunks_exact_mut(self.columns.max(1))
    }
}

impl<T> Deref for Grid<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.values
    }
}

impl<T> DerefMut for Grid<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.values
    }
}

impl<T> Index<(usize, usize)> for Grid<T> {
    type Output = T;

    fn index(&self, (row, column): (usize, usize)) -> &T {
        &self.row(row)[column]
    }
}

impl<T> IndexMut<(usize, usize)> for Grid<T> {
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut T {
        &mut self.row_mut(row)[column]
    }
}
