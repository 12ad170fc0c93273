//! Reference curves: points, each with the computed value at its abscissa.

use super::{CompareError, Computed, NOTHING, difference, read_column};
use crate::case::comparison::{ComparedQuantity, CurveSpec};
use crate::numerics::interpolated;
use crate::table::{Column, Csv, Table};
use crate::units::four_digits;
use std::path::Path;

/// Reference value and its computed counterpart, in solver units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Abscissa.
    pub x: f64,
    /// Ordinate of the reference.
    pub reference: f64,
    /// Computed ordinate; `None` if the run did not reach it.
    pub computed: Option<f64>,
    /// True inside the range that is judged; the others are only drawn.
    pub judged: bool,
}

/// Points of a reference curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Points(pub Vec<Point>);

impl Point {
    /// Computed minus reference, over the reference \[–\]; `None` if not reached or the reference is 0.
    pub fn difference(&self) -> Option<f64> {
        let computed = self.computed.filter(|_| self.reference.abs() >= NOTHING);
        computed.map(|computed| (computed - self.reference) / self.reference.abs())
    }
}

impl Points {
    /// Judged point with the largest relative difference.
    pub fn worst(&self) -> Option<&Point> {
        let size = |p: &Point| p.difference().map_or(-1.0, f64::abs);
        self.judged().max_by(|a, b| size(a).total_cmp(&size(b))).filter(|p| p.computed.is_some())
    }

    /// Points inside the range that is judged.
    pub fn judged(&self) -> impl Iterator<Item = &Point> {
        self.0.iter().filter(|p| p.judged)
    }

    /// Compares a reference with a computed curve.
    pub(super) fn compared(
        spec: &CurveSpec,
        reference: (&Path, &Csv),
        columns: [&Column; 2],
    ) -> Result<Self, CompareError> {
        let points = points(spec, reference, columns)?;
        if let Some((zero, line)) = points.iter().find(|(p, _)| p.reference.abs() < NOTHING && p.judged) {
            return Err(CompareError(format!(
                "{}, line {line}: the reference value is {} at {}, which no relative difference can be taken from; narrow \
                 `range`",
                reference.0.display(),
                four_digits(zero.reference),
                zero.x
            )));
        }
        Ok(Self(points.into_iter().map(|(point, _)| point).collect()))
    }

    /// One row per reference value; NaN where the run did not get.
    pub(super) fn table(&self, x: &Column, y: &Column) -> Table {
        let of = |value: fn(&Point) -> f64| self.0.iter().map(value).collect();
        Table::new(vec![
            Column::new(x.key, x.label, x.unit, of(|p| p.x)),
            Column::new("reference", "Reference", y.unit, of(|p| p.reference)),
            Column::new("computed", "Computed", y.unit, of(|p| p.computed.unwrap_or(f64::NAN))),
            difference(of(|p| 100.0 * p.difference().unwrap_or(f64::NAN))),
        ])
    }

    /// True if all judged points lie within the tolerance; `None` if the run did not reach all of them.
    pub(super) fn is_inside(&self, spec: &CurveSpec, complete: bool) -> Option<bool> {
        use ComparedQuantity::{ThicknessAtRadius, ThicknessAtS0};
        let out = |p: &Point| p.difference().is_some_and(|d| d.abs() > spec.tolerance || d.is_nan());
        if !complete && matches!(spec.quantity, ThicknessAtS0 | ThicknessAtRadius) {
            None
        } else if self.judged().any(out) {
            Some(false)
        } else {
            self.judged().all(|p| p.computed.is_some()).then_some(true)
        }
    }
}

impl Computed<'_> {
    /// Judged points of a reference curve with the computed values; a reference may be 0.
    ///
    /// # Errors
    /// If the reference does not fit the quantity.
    pub fn points(&self, spec: &CurveSpec, path: &Path, csv: &Csv) -> Result<Vec<Point>, CompareError> {
        let (x, y) = self.columns(spec.quantity);
        let points = points(spec, (path, csv), [&x, &y])?;
        Ok(points.into_iter().map(|(point, _)| point).filter(|point| point.judged).collect())
    }
}

/// Points of a reference with their lines.
fn points(
    spec: &CurveSpec,
    (path, csv): (&Path, &Csv),
    [x, y]: [&Column; 2],
) -> Result<Vec<(Point, usize)>, CompareError> {
    let ((xs, of_x), (ys, _)) = (read_column(path, csv, &spec.x, x)?, read_column(path, csv, &spec.y, y)?);
    let (low, high) = spec.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let range = low * of_x..=high * of_x;
    let mut rising: Vec<(f64, f64)> = Vec::with_capacity(x.values.len());
    for point in x.values.iter().copied().zip(y.values.iter().copied()) {
        if rising.last().is_none_or(|last| point.0 > last.0) {
            rising.push(point);
        }
    }
    let pairs = xs.into_iter().zip(ys).zip(&csv.rows);
    let known = pairs.filter_map(|((x, y), row)| Some((x?, y?, row.line)));
    let points: Vec<(Point, usize)> = known
        .map(|(x, reference, line)| {
            (Point { x, reference, computed: held_at_ends(&rising, x), judged: range.contains(&x) }, line)
        })
        .collect();
    if points.iter().any(|(point, _)| point.judged) {
        return Ok(points);
    }
    let columns = format!("columns `{}` and `{}`", spec.x, spec.y);
    Err(CompareError(format!("{} has no rows in {columns} within the range asked for", path.display())))
}

/// Value between points, held for one interval beyond either end; `None` farther out.
fn held_at_ends(rising: &[(f64, f64)], x: f64) -> Option<f64> {
    let ([first, second, ..], [.., before, last]) = (rising, rising) else { return None };
    let is_near = first.0 - x <= second.0 - first.0 && x - last.0 <= last.0 - before.0;
    is_near.then(|| interpolated(rising, x))
}
