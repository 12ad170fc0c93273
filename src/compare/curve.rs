//! A reference that is a curve: points, each with the computed value at its place.

use super::computed::Computed;
use super::error::CompareError;
use super::reference::{NOTHING, Reference};
use super::verdict::Verdict;
use crate::table::fields::{element, step};
use crate::table::{Column, Csv, Table, Unit};
use crate::units::four_digits;
use std::path::Path;

/// Quantity that is compared along a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Punch force at equal travel.
    PunchForce,
    /// Punch travel at equal force.
    Travel,
    /// Thickness over the initial distance from the axis, at the last frame.
    ThicknessAtS0,
    /// Thickness over the present radius, at the last frame.
    ThicknessAtRadius,
    /// Minor strain at equal major strain, of the place that is thinnest at the end on its way there.
    StrainPath,
    /// Draw-in of the edge at equal travel.
    DrawInAtTravel,
}

/// A comparison along a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveSpec {
    /// Compared quantity.
    pub quantity: Quantity,
    /// Header of the column to compare at.
    pub x: String,
    /// Header of the column to compare with.
    pub y: String,
    /// Part of the curve to use, in the unit of the x column.
    pub range: Option<(f64, f64)>,
    /// Largest difference over the reference value \[–\].
    pub tolerance: f64,
}

/// One reference value and its computed counterpart, in solver units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Abscissa.
    pub x: f64,
    /// The reference's ordinate.
    pub reference: f64,
    /// The computed ordinate; `None` where the run did not get.
    pub computed: Option<f64>,
    /// Whether the point lies in the range that is judged; the others are shown only.
    pub judged: bool,
}

/// The points of a reference curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Points(pub Vec<Point>);

impl Quantity {
    /// Every quantity that is compared along a curve.
    pub const ALL: [Self; 6] = [
        Self::PunchForce,
        Self::Travel,
        Self::ThicknessAtS0,
        Self::ThicknessAtRadius,
        Self::StrainPath,
        Self::DrawInAtTravel,
    ];

    /// The word used in case files, tables and file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::PunchForce => "punch_force",
            Self::Travel => "travel",
            Self::ThicknessAtS0 => "thickness_at_s0",
            Self::ThicknessAtRadius => "thickness_at_radius",
            Self::StrainPath => "strain_path",
            Self::DrawInAtTravel => "draw_in_at_travel",
        }
    }

    pub(super) fn label(self) -> &'static str {
        match self {
            Self::PunchForce => "force",
            Self::Travel => "travel",
            Self::ThicknessAtS0 | Self::ThicknessAtRadius => "thickness",
            Self::StrainPath => "strain",
            Self::DrawInAtTravel => "draw-in",
        }
    }

    /// The computed columns: along which, and what.
    pub fn columns(self, computed: &Computed) -> (Column, Column) {
        match self {
            Self::PunchForce => (computed.step(step::TRAVEL), computed.step(step::PUNCH_FORCE)),
            Self::Travel => (computed.step(step::PUNCH_FORCE), computed.step(step::TRAVEL)),
            Self::ThicknessAtS0 => (computed.element(element::S0), computed.element(element::THICKNESS)),
            Self::ThicknessAtRadius => (computed.element(element::R), computed.element(element::THICKNESS)),
            Self::StrainPath => computed.path(),
            Self::DrawInAtTravel => (computed.step(step::TRAVEL), computed.step(step::DRAW_IN)),
        }
    }

    fn is_of_last_frame(self) -> bool {
        matches!(self, Self::ThicknessAtS0 | Self::ThicknessAtRadius)
    }
}

impl Point {
    /// Computed minus reference, over the reference \[–\]; `None` where the run did not get, or the reference is
    /// nothing.
    pub fn difference(&self) -> Option<f64> {
        let computed = self.computed.filter(|_| self.reference.abs() >= NOTHING);
        computed.map(|computed| (computed - self.reference) / self.reference.abs())
    }
}

impl Points {
    /// The judged point with the largest relative difference.
    pub fn worst(&self) -> Option<&Point> {
        let size = |p: &Point| p.difference().map_or(-1.0, f64::abs);
        self.judged().max_by(|a, b| size(a).total_cmp(&size(b))).filter(|p| p.computed.is_some())
    }

    /// The points inside the range that is judged.
    pub fn judged(&self) -> impl Iterator<Item = &Point> {
        self.0.iter().filter(|p| p.judged)
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

    pub(super) fn verdict(&self, spec: &CurveSpec, complete: bool) -> Verdict {
        let out = |p: &Point| p.difference().is_some_and(|d| d.abs() > spec.tolerance || d.is_nan());
        if !complete && spec.quantity.is_of_last_frame() {
            Verdict::NotReached
        } else if self.judged().any(out) {
            Verdict::Out
        } else if self.judged().any(|p| p.computed.is_none()) {
            Verdict::NotReached
        } else {
            Verdict::In
        }
    }
}

/// Computed minus reference, over the reference \[%\].
pub(super) fn difference(values: Vec<f64>) -> Column {
    Column::new("difference", "Difference", Unit::Percent, values)
}

/// The reference's points with what was computed there; `curve` is the computed one.
pub(super) fn compare(
    spec: &CurveSpec,
    reference: Reference,
    columns: (&Column, &Column),
    curve: &[(f64, f64)],
) -> Result<Points, CompareError> {
    let points = points(spec, reference, columns, curve)?;
    let path = || reference.path.to_owned();
    if let Some((zero, line)) = points.iter().find(|(point, _)| point.reference.abs() < NOTHING && point.judged) {
        return Err(CompareError::Zero { path: path(), line: *line, value: four_digits(zero.reference), x: zero.x });
    }
    Ok(Points(points.into_iter().map(|(point, _)| point).collect()))
}

/// The points of a reference with the lines that they stand in, also where the reference is 0.
fn points(
    spec: &CurveSpec,
    reference: Reference,
    (x, y): (&Column, &Column),
    curve: &[(f64, f64)],
) -> Result<Vec<(Point, usize)>, CompareError> {
    let (xs, ys) = (reference.column(&spec.x, x)?, reference.column(&spec.y, y)?);
    let (low, high) = spec.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let range = low * xs.factor..=high * xs.factor;
    let rising = rising(curve);
    let pairs = xs.values.into_iter().zip(ys.values).zip(&reference.csv.rows);
    let found = pairs.filter_map(|((x, y), row)| Some((x?, y?, row.line)));
    let points: Vec<(Point, usize)> = found
        .map(|(x, reference, line)| {
            (Point { x, reference, computed: interpolated(&rising, x), judged: range.contains(&x) }, line)
        })
        .collect();
    if !points.iter().any(|(point, _)| point.judged) {
        return Err(CompareError::Empty { path: reference.path.to_owned(), x: spec.x.clone(), y: spec.y.clone() });
    }
    Ok(points)
}

impl CurveSpec {
    /// The judged points of a reference with what was computed there; a reference may be 0 here, for no difference is taken
    /// over it.
    ///
    /// # Errors
    /// When the reference does not fit the quantity.
    pub fn points(&self, path: &Path, csv: &Csv, computed: &Computed) -> Result<Vec<Point>, CompareError> {
        let (x, y) = self.quantity.columns(computed);
        let curve: Vec<_> = x.values.iter().copied().zip(y.values.iter().copied()).collect();
        let points = points(self, Reference { path, csv }, (&x, &y), &curve)?;
        Ok(points.into_iter().map(|(point, _)| point).filter(|point| point.judged).collect())
    }
}

/// The points whose abscissa is larger than all before them.
fn rising(curve: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut rising: Vec<(f64, f64)> = Vec::with_capacity(curve.len());
    for &point in curve {
        if rising.last().is_none_or(|last| point.0 > last.0) {
            rising.push(point);
        }
    }
    rising
}

/// Linear between the points, held for one interval beyond the ends, `None` farther out.
fn interpolated(rising: &[(f64, f64)], x: f64) -> Option<f64> {
    let [first, .., last] = rising else { return None };
    let after = rising.partition_point(|p| p.0 < x);
    match after {
        0 => (first.0 - x <= rising[1].0 - first.0).then_some(first.1),
        n if n == rising.len() => (x - last.0 <= last.0 - rising[n - 2].0).then_some(last.1),
        n => {
            let (a, b) = (rising[n - 1], rising[n]);
            Some(a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0))
        }
    }
}
