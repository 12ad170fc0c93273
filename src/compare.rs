//! Computed tables against reference curves.

mod reference;
mod source;

pub use source::Source;

use crate::quantity::rounded;
use crate::table::{Axis, Column, Table, Unit, UnitError};
use std::path::PathBuf;

/// What is compared.
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
}

/// A comparison that a case asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// CSV file of the reference curve, units at the end of its headers.
    pub reference: PathBuf,
    /// Header of the column to compare at.
    pub x: String,
    /// Header of the column to compare with.
    pub y: String,
    pub quantity: Quantity,
    /// Part of the curve to use, in the unit of the x column.
    pub range: Option<(f64, f64)>,
    /// Largest difference over the reference value \[–\].
    pub tolerance: f64,
    /// Why the tolerance is what it is.
    pub reason: String,
    /// Whether the reference file may be missing.
    pub optional: bool,
}

/// What a run offers for comparison.
#[derive(Clone, Copy, Debug)]
pub struct Computed<'a> {
    /// One row per step: `travel`, `punch_force`.
    pub history: &'a Table,
    /// The last frame from the axis outward: `s0`, `r`, `thickness`.
    pub profile: &'a Table,
    /// Whether the run reached its full travel.
    pub complete: bool,
}

/// One reference value and its computed counterpart, in solver units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    pub x: f64,
    pub reference: f64,
    /// `None` where the run did not get.
    pub computed: Option<f64>,
    /// Whether the point lies in the range that is judged; the others are shown only.
    pub judged: bool,
}

/// Whether a run agrees with a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every point lies within the tolerance.
    In,
    /// A point lies outside the tolerance.
    Out,
    /// The run ended before the last point; the points it reached lie within the tolerance.
    NotReached,
    /// The reference file is optional and not there.
    NoData,
}

/// The outcome of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    pub spec: Spec,
    /// Where the reference comes from, if its folder says so.
    pub source: Option<Source>,
    pub points: Vec<Point>,
    /// The computed curve that the points were interpolated on.
    pub curve: Vec<(f64, f64)>,
    pub verdict: Verdict,
    x: Column,
    y: Column,
}

/// Why a comparison cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    #[error("cannot read {}", path.display())]
    Read { path: PathBuf, source: std::io::Error },
    #[error("cannot read {} as CSV", path.display())]
    Csv { path: PathBuf, source: csv::Error },
    #[error("cannot read {}: one table per reference file with citation, kind, grade and, if known, scatter", path.display())]
    Sources { path: PathBuf, source: toml::de::Error },
    #[error("{} has no column `{column}`; it has {found}", path.display())]
    Column { path: PathBuf, column: String, found: String },
    #[error("{} separates its columns by {found:?}: write commas between columns, and points in numbers", path.display())]
    Separator { path: PathBuf, found: char },
    #[error("{}: {error}", path.display())]
    Unit { path: PathBuf, error: UnitError },
    #[error("{}: column `{column}` cannot be compared with the computed {with}", path.display())]
    Dimension { path: PathBuf, column: String, with: String },
    #[error("{}, data row {row}: `{text}` in column `{column}` is not a number", path.display())]
    Number { path: PathBuf, row: usize, column: String, text: String },
    #[error("{} has no rows in columns `{x}` and `{y}` within the range asked for", path.display())]
    Empty { path: PathBuf, x: String, y: String },
    #[error("{}: the reference value is 0 at {x}, which no relative difference can be taken from; narrow `range`", path.display())]
    Zero { path: PathBuf, x: f64 },
}

impl Quantity {
    /// Every quantity.
    pub const ALL: [Self; 4] = [Self::PunchForce, Self::Travel, Self::ThicknessAtS0, Self::ThicknessAtRadius];

    /// The word used in case files, tables and file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::PunchForce => "punch_force",
            Self::Travel => "travel",
            Self::ThicknessAtS0 => "thickness_at_s0",
            Self::ThicknessAtRadius => "thickness_at_radius",
        }
    }

    /// The computed columns that are compared: abscissa and ordinate.
    fn columns<'a>(self, computed: &Computed<'a>) -> (&'a Column, &'a Column) {
        let Computed { history, profile, .. } = computed;
        match self {
            Self::PunchForce => (history.column("travel"), history.column("punch_force")),
            Self::Travel => (history.column("punch_force"), history.column("travel")),
            Self::ThicknessAtS0 => (profile.column("s0"), profile.column("thickness")),
            Self::ThicknessAtRadius => (profile.column("r"), profile.column("thickness")),
        }
    }

    fn is_of_last_frame(self) -> bool {
        matches!(self, Self::ThicknessAtS0 | Self::ThicknessAtRadius)
    }
}

impl Verdict {
    /// The word used in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::In => "in",
            Self::Out => "OUT",
            Self::NotReached => "not reached",
            Self::NoData => "no data",
        }
    }

    /// Whether a validation must fail.
    pub fn is_failure(self) -> bool {
        matches!(self, Self::Out | Self::NotReached)
    }
}

impl Point {
    /// Computed minus reference, over the reference \[–\].
    pub fn difference(&self) -> Option<f64> {
        self.computed.map(|computed| (computed - self.reference) / self.reference.abs())
    }
}

impl Comparison {
    /// The judged point with the largest relative difference.
    pub fn worst(&self) -> Option<&Point> {
        let size = |p: &Point| p.difference().map_or(-1.0, f64::abs);
        self.judged().max_by(|a, b| size(a).total_cmp(&size(b))).filter(|p| p.computed.is_some())
    }

    /// The points inside the range that is judged.
    pub fn judged(&self) -> impl Iterator<Item = &Point> {
        self.points.iter().filter(|p| p.judged)
    }

    /// Where a point is, in words: `punch travel = 12.5 mm`.
    pub fn place(&self, point: &Point) -> String {
        let x = (1e3 * point.x).round() / 1e3;
        format!("{} = {x} {}", self.x.label.to_lowercase(), self.x.unit.symbol())
    }

    /// The outcome in a sentence: `punch_force against osu.csv: in, worst +2.1 % at punch travel = 20 mm`.
    pub fn sentence(&self) -> String {
        let Self { spec, verdict, .. } = self;
        let file = spec.reference.file_name().unwrap_or_default().to_string_lossy();
        let worst = self.worst().and_then(|p| Some((p, p.difference()?))).map_or(String::new(), |(point, d)| {
            format!(
                ", worst {:+.1} % at {} (tolerance {} %)",
                100.0 * d,
                self.place(point),
                rounded(100.0 * spec.tolerance)
            )
        });
        format!("{} against {file}: {}{worst}", spec.quantity.name(), verdict.name())
    }

    /// Axes of the compared quantities.
    pub fn axes(&self) -> (Axis, Axis) {
        (self.x.axis(), self.y.axis())
    }

    /// One row per reference value; NaN where the run did not get.
    pub fn table(&self) -> Table {
        let of = |value: fn(&Point) -> f64| self.points.iter().map(value).collect();
        Table::new(vec![
            Column::new(self.x.key, self.x.label, self.x.unit, of(|p| p.x)),
            Column::new("reference", "Reference", self.y.unit, of(|p| p.reference)),
            Column::new("computed", "Computed", self.y.unit, of(|p| p.computed.unwrap_or(f64::NAN))),
            Column::new("difference", "Difference", Unit::Percent, of(|p| 100.0 * p.difference().unwrap_or(f64::NAN))),
        ])
    }
}

/// Compares a run with a reference curve.
///
/// The computed curve is interpolated linearly at the reference's abscissae. Where it turns back (force after its
/// peak, radius along a bulging wall), each abscissa counts where it is reached first; so travel at equal force is
/// taken on the rise to the peak. Either end is held for one interval.
///
/// # Errors
/// When the reference cannot be read or does not fit the quantity; a missing file that is optional is no error.
pub fn compare(spec: &Spec, computed: &Computed) -> Result<Comparison, CompareError> {
    let (x, y) = spec.quantity.columns(computed);
    let mut comparison = Comparison {
        spec: spec.clone(),
        source: None,
        points: Vec::new(),
        curve: x.values.iter().copied().zip(y.values.iter().copied()).collect(),
        verdict: Verdict::NoData,
        x: Column { values: Vec::new(), ..x.clone() },
        y: Column { values: Vec::new(), ..y.clone() },
    };
    if spec.optional && !spec.reference.exists() {
        return Ok(comparison);
    }
    comparison.source = source::of(&spec.reference)?;
    let rising = rising(&comparison.curve);
    for reference::Row { x, y, judged } in reference::read(spec, x, y)? {
        if y == 0.0 && judged {
            return Err(CompareError::Zero { path: spec.reference.clone(), x });
        }
        comparison.points.push(Point { x, reference: y, computed: interpolated(&rising, x), judged });
    }
    let out = |p: &Point| p.difference().is_some_and(|d| d.abs() > spec.tolerance || d.is_nan());
    comparison.verdict = if !computed.complete && spec.quantity.is_of_last_frame() {
        Verdict::NotReached
    } else if comparison.judged().any(out) {
        Verdict::Out
    } else if comparison.judged().any(|p| p.computed.is_none()) {
        Verdict::NotReached
    } else {
        Verdict::In
    };
    Ok(comparison)
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

#[cfg(test)]
mod tests;
