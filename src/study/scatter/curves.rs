//! Curves of many runs, each at the same places, so that quantiles can be taken across them.

use crate::assess::largest_force;
use crate::case::Solution;
use crate::model::mesh;
use crate::numerics::interpolated;
use crate::study::Row;
use crate::table::Unit;
use crate::units::significant;

/// Places along a curve: enough for the radii of a part, and a line that a spreadsheet still opens.
const PLACES: usize = 61;

/// Digits of what is kept of a curve: more than a picture shows.
const DIGITS: usize = 5;

/// Where curves are kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Grids {
    /// Travels of the load curve \[mm\]; empty where no punch moves.
    pub load: Vec<f64>,
    /// Initial distances from the axis of the thickness \[mm\].
    pub thickness: Vec<f64>,
    /// Of the load.
    pub force: Unit,
}

impl Grids {
    /// For runs of a case that was solved as it stands: over its whole travel, and over its whole blank.
    pub fn of(solution: &Solution) -> Self {
        let travel = largest_force(&solution.stages).map_or(0.0, |(i, _)| solution.stages[i].model.travel);
        let model = solution.case.model();
        let even = |end: f64| (0..PLACES).map(|i| significant(end * i as f64 / (PLACES - 1) as f64, DIGITS)).collect();
        Self {
            load: if travel > 0.0 { even(travel) } else { Vec::new() },
            thickness: mesh::nodes(model).last().map_or_else(Vec::new, |edge| even(*edge)),
            force: model.extent().force_unit(),
        }
    }

    /// Headers of the columns that keep them: places from the first to the last, evenly.
    pub fn headers(&self) -> [String; 2] {
        let header = |unit: Unit, key: &str, grid: &[f64]| {
            let (first, last) = grid.first().zip(grid.last()).unwrap_or((&0.0, &0.0));
            format!("{}_at_{}_places_{first}_to_{last}_mm", unit.keyed(key), grid.len())
        };
        [header(self.force, "punch_force", &self.load), header(Unit::Mm, "thickness", &self.thickness)]
    }

    /// The cells of a row: values with spaces between them, as far as its run comes.
    pub fn cells(&self, row: &Row) -> [String; 2] {
        let Ok(solved) = &row.result else { return Default::default() };
        // Before the first step nothing presses.
        let load: Vec<(f64, f64)> = [(0.0, 0.0)].into_iter().chain(solved.outcome.load.iter().copied()).collect();
        let thickness = &solved.outcome.thickness;
        // Elements have their thickness at their middles: it reaches half of one further.
        let beyond = match thickness.as_slice() {
            [.., a, b] => b.0 - a.0,
            _ => 0.0,
        };
        let cell = |grid: &[f64], curve: &[(f64, f64)], beyond: f64| {
            let values = grid.iter().map_while(|x| at(curve, *x, beyond)).map(|y| significant(y, DIGITS).to_string());
            values.collect::<Vec<_>>().join(" ")
        };
        let end = 1e-9 * self.load.last().copied().unwrap_or_default();
        [cell(&self.load, &load, end), cell(&self.thickness, thickness, beyond)]
    }
}

/// A curve between its points, and its ends' values as far `beyond` its last one and before its first.
fn at(curve: &[(f64, f64)], x: f64, beyond: f64) -> Option<f64> {
    let last = curve.last()?;
    (x <= last.0 + beyond).then(|| interpolated(curve, x))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by hand.
    #[test]
    fn a_curve_is_kept_as_far_as_it_comes() {
        let curve = [(1.0, 10.0), (2.0, 20.0), (4.0, 0.0)];
        let kept = |beyond: f64| [0.0, 1.5, 3.0, 4.0, 4.5].map(|x| at(&curve, x, beyond));
        assert_eq!(kept(0.0), [Some(10.0), Some(15.0), Some(10.0), Some(0.0), None]);
        assert_eq!(kept(1.0)[4], Some(0.0));
        assert_eq!(at(&[], 1.0, 1.0), None);
    }
}
