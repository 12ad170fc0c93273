//! A measured curve that runs are held against.

use crate::case::Case;
use crate::compare::{Against, CompareError, Computed, CurveSpec, Point, Quantity};
use crate::study::{Readings, StudyError};
use crate::table::Csv;
use std::path::PathBuf;

/// A measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Its file, or what it is called.
    pub path: PathBuf,
    /// What it is of, and its columns.
    pub spec: CurveSpec,
    csv: Csv,
    /// Column of each point's standard deviation, if any.
    scatter: Option<usize>,
}

/// What a file's columns are taken for: words of the abscissa, of the ordinate, and words that the latter has not.
type Rule = (Quantity, &'static [&'static str], &'static [&'static str]);
const TRAVEL: &[&str] = &["travel", "stroke"];
const RULES: [Rule; 4] = [
    (Quantity::PunchForce, TRAVEL, &["force", "load"]),
    (Quantity::DrawInAtTravel, TRAVEL, &["draw"]),
    (Quantity::ThicknessAtS0, &["s0"], &["thickness"]),
    (Quantity::ThicknessAtRadius, &["r", "radius"], &["thickness"]),
];
/// Other forces, and what is said of a value beside it.
const NOT: [&str; 9] = ["holder", "edge", "binder", "deviation", "stdev", "std", "scatter", "sd", "error"];
const SCATTER: [&str; 5] = ["deviation", "stdev", "std", "scatter", "sd"];
const EXAMPLE: &str = "a curve has columns such as travel_mm,punch_force_kN or s0_mm,thickness_mm or travel_mm,draw_in_mm, and \
                       maybe one such as standard_deviation_kN";

impl Target {
    /// Reads a curve; its columns say what it is of.
    ///
    /// # Errors
    /// When it cannot be read, or no curve that is compared has such columns.
    pub fn load(readings: &Readings) -> Result<Self, StudyError> {
        let csv = readings.table("give a CSV file of a measured curve with --to", EXAMPLE)?;
        let words: Vec<Vec<String>> = csv.header.fields.iter().map(words).collect();
        let find = |any: &[&str]| {
            let is = |of: &[String]| {
                of.iter().any(|w| any.contains(&w.as_str())) && !of.iter().any(|w| NOT.contains(&w.as_str()))
            };
            words.iter().position(|of| is(of))
        };
        let found = RULES.iter().find_map(|(quantity, x, y)| Some((*quantity, find(x)?, find(y)?)));
        let (quantity, x, y) = found.ok_or_else(|| {
            StudyError::new(
                format!("{readings} is no curve that a run can be held against; it has {}", csv.found()),
                EXAMPLE,
            )
        })?;
        let header = |i: usize| csv.header.fields.get(i).unwrap_or_default().to_owned();
        let spec = CurveSpec { quantity, x: header(x), y: header(y), range: None, tolerance: f64::INFINITY };
        Ok(Self::new(readings.path().to_owned(), spec, csv))
    }

    /// The curves that a case is compared with.
    pub fn of(case: &Case) -> Vec<Self> {
        let curve = |spec: &crate::compare::Spec| match (&spec.against, &spec.data) {
            (Against::Curve(curve), Some(data)) => {
                Some(Self::new(spec.reference.clone(), curve.clone(), data.csv.clone()))
            }
            _ => None,
        };
        case.compare.iter().filter_map(curve).collect()
    }

    fn new(path: PathBuf, spec: CurveSpec, csv: Csv) -> Self {
        let is_scatter = |header: &str| words(header).iter().any(|word| SCATTER.contains(&word.as_str()));
        let unit = |i: usize| csv.unit(i).ok().map(|(unit, _)| unit);
        let y = csv.column(&spec.y).and_then(unit);
        let scatter = (0..csv.header.fields.len())
            .find(|&i| csv.header.fields.get(i).is_some_and(is_scatter) && unit(i).is_some() && unit(i) == y);
        Self { path, spec, csv, scatter }
    }

    /// Its points with what a stage computed there.
    ///
    /// # Errors
    /// When a column is missing, has no unit or another one.
    pub fn points(&self, computed: &Computed) -> Result<Vec<Point>, CompareError> {
        self.spec.points(&self.path, &self.csv, computed)
    }

    /// The standard deviation of each of its points; `None` where not all have one.
    pub(super) fn scatter(&self, points: &[Point]) -> Option<Vec<f64>> {
        let column = self.scatter?;
        let (_, factor) = self.csv.unit(column).ok()?;
        let [x, y] = [&self.spec.x, &self.spec.y].map(|name| self.csv.column(name));
        let (x, y) = (x?, y?);
        let (_, of_x) = self.csv.unit(x).ok()?;
        let has = |row: &&crate::table::Record| matches!((row.number(x), row.number(y)), (Ok(Some(_)), Ok(Some(_))));
        let (low, high) = self.spec.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let inside = |row: &&crate::table::Record| {
            row.number(x).ok().flatten().is_some_and(|x| (low * of_x..=high * of_x).contains(&(x * of_x)))
        };
        let rows = self.csv.rows.iter().filter(has).filter(inside);
        let scatter: Option<Vec<f64>> =
            rows.map(|row| row.number(column).ok().flatten().map(|s| s * factor).filter(|s| *s > 0.0)).collect();
        scatter.filter(|scatter| scatter.len() == points.len())
    }

    /// Name of its file.
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}

fn words(header: &str) -> Vec<String> {
    header.to_lowercase().split(|c: char| !c.is_alphanumeric()).map(str::to_owned).collect()
}
