//! Records of numbers by row and column, those of neighbouring rows side by side.
//!
//! Vector instructions read and write four of them as they lie, entry by entry; one by itself is picked out.

use super::number::{Instructions, LANES, Lanes};

/// Records of `N` numbers by row and column: those of rows 0 to 3 side by side, then those of rows 4 to 7.
#[derive(Clone, Debug)]
pub struct Abreast<const N: usize> {
    columns: usize,
    groups: Vec<[[f64; LANES]; N]>,
}

impl<const N: usize> Abreast<N> {
    /// Of zeros.
    pub fn new(rows: usize, columns: usize) -> Self {
        Self { columns, groups: vec![[[0.0; LANES]; N]; rows.div_ceil(LANES) * columns] }
    }

    /// One record.
    #[inline(always)]
    pub fn get(&self, row: usize, column: usize) -> [f64; N] {
        let (group, k) = (&self.groups[self.place(row, column)], row % LANES);
        let mut record = [0.0; N];
        for i in 0..N {
            record[i] = group[i][k];
        }
        record
    }

    /// Puts one record in its place.
    #[inline(always)]
    pub fn put(&mut self, row: usize, column: usize, record: &[f64; N]) {
        let place = self.place(row, column);
        let (group, k) = (&mut self.groups[place], row % LANES);
        for i in 0..N {
            group[i][k] = record[i];
        }
    }

    /// The records of as many rows as there are lanes, from `row` on, a multiple of their number.
    #[inline(always)]
    pub fn lanes<S: Instructions>(&self, simd: S, row: usize, column: usize) -> [Lanes<S>; N] {
        debug_assert_eq!(row % LANES, 0);
        let group = &self.groups[self.place(row, column)];
        let mut records = [Lanes::new(simd, [0.0; LANES]); N];
        for i in 0..N {
            records[i] = Lanes::new(simd, group[i]);
        }
        records
    }

    /// Puts these records in their place.
    #[inline(always)]
    pub fn put_lanes<S: Instructions>(&mut self, row: usize, column: usize, records: &[Lanes<S>; N]) {
        debug_assert_eq!(row % LANES, 0);
        let place = self.place(row, column);
        let group = &mut self.groups[place];
        for i in 0..N {
            group[i] = records[i].values();
        }
    }

    #[inline(always)]
    fn place(&self, row: usize, column: usize) -> usize {
        debug_assert!(column < self.columns);
        row / LANES * self.columns + column
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: every record is another one, and of seven rows three stand in the last group.
    #[test]
    fn one_by_one_and_side_by_side_they_are_the_same_records() {
        let (rows, columns) = (7, 3);
        let record = |row: usize, column: usize| [(10 * row + column) as f64, -((10 * row + column) as f64)];
        let mut records = Abreast::<2>::new(rows, columns);
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            records.put(row, column, &record(row, column));
        }
        assert_eq!(records.get(6, 2), record(6, 2));
        let four = records.lanes(pulp::Scalar256b, 0, 1);
        assert_eq!(four[1].values(), [0, 1, 2, 3].map(|row| record(row, 1)[1]));
        records.put_lanes(4, 0, &four);
        assert_eq!([4, 5, 6].map(|row| records.get(row, 0)), [0, 1, 2].map(|row| record(row, 1)));
        assert_eq!(records.get(6, 1), record(6, 1));
    }
}
