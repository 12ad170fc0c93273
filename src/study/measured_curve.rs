//! Measured curves: a file whose columns say what it is a curve of.

use super::{MeasuredData, StudyError};
use crate::case::Case;
use crate::case::comparison::{Against, ComparedQuantity, CurveSpec, Spec};
use crate::model::Model;
use crate::results::comparison::{CompareError, Computed, Point};
use crate::table::{Axis, Csv, Record};
use std::path::PathBuf;

/// A measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    /// Its file or name.
    pub path: PathBuf,
    /// Its quantity and columns.
    pub spec: CurveSpec,
    csv: Csv,
    scatter: Option<usize>,
}

/// A quantity, words of its abscissa and of its ordinate.
type Rule = (ComparedQuantity, &'static [&'static str], &'static [&'static str]);
const TRAVEL: &[&str] = &["travel", "stroke"];
const RULES: [Rule; 4] = [
    (ComparedQuantity::PunchForce, TRAVEL, &["force", "load"]),
    (ComparedQuantity::DrawInAtTravel, TRAVEL, &["draw"]),
    (ComparedQuantity::ThicknessAtS0, &["s0"], &["thickness"]),
    (ComparedQuantity::ThicknessAtRadius, &["r", "radius"], &["thickness"]),
];
/// Words of other forces and of scatter.
const NOT: [&str; 9] = ["holder", "edge", "binder", "deviation", "stdev", "std", "scatter", "sd", "error"];
const SCATTER: [&str; 5] = ["deviation", "stdev", "std", "scatter", "sd"];
const EXAMPLE: &str = "a curve has columns such as travel_mm,punch_force_kN or s0_mm,thickness_mm or travel_mm,draw_in_mm, and \
                       maybe one such as standard_deviation_kN";

impl MeasuredCurve {
    /// Reads a curve; its columns say what it is of.
    ///
    /// # Errors
    /// When it cannot be read, or no curve that is compared has such columns.
    pub fn load(data: &MeasuredData) -> Result<Self, StudyError> {
        let csv = data.table(EXAMPLE)?;
        let words: Vec<Vec<String>> = csv.header.fields.iter().map(words).collect();
        let find = |any: &[&str]| {
            let is = |of: &[String]| {
                of.iter().any(|w| any.contains(&w.as_str())) && !of.iter().any(|w| NOT.contains(&w.as_str()))
            };
            words.iter().position(|of| is(of))
        };
        let found = RULES.iter().find_map(|(quantity, x, y)| Some((*quantity, find(x)?, find(y)?)));
        let (quantity, x, y) = found
            .ok_or_else(|| StudyError::new(format!("{data} is no curve of a run; it has {}", csv.names()), EXAMPLE))?;
        let header = |i: usize| csv.header.fields.get(i).unwrap_or_default().to_owned();
        let spec = CurveSpec { quantity, x: header(x), y: header(y), range: None, tolerance: f64::INFINITY };
        Ok(Self::new(data.path().to_owned(), spec, last_frame(csv)))
    }

    /// Curves that a case is compared with.
    pub fn of_case(case: &Case) -> Vec<Self> {
        let curve = |spec: &Spec| match (&spec.against, &spec.data) {
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

    /// Its points with the computed values.
    ///
    /// # Errors
    /// When a column is missing, has no unit or another one.
    pub fn points(&self, computed: &Computed) -> Result<Vec<Point>, CompareError> {
        computed.points(&self.spec, &self.path, &self.csv)
    }

    /// Standard deviation of each point; `None` if one has none.
    pub fn deviations(&self, points: &[Point]) -> Option<Vec<f64>> {
        let column = self.scatter?;
        let (_, factor) = self.csv.unit(column).ok()?;
        let [x, y] = [&self.spec.x, &self.spec.y].map(|name| self.csv.column(name));
        let (x, y) = (x?, y?);
        let (_, of_x) = self.csv.unit(x).ok()?;
        let has = |row: &&Record| matches!((row.number(x), row.number(y)), (Ok(Some(_)), Ok(Some(_))));
        let (low, high) = self.spec.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let inside = |row: &&Record| {
            row.number(x).ok().flatten().is_some_and(|x| (low * of_x..=high * of_x).contains(&(x * of_x)))
        };
        let rows = self.csv.rows.iter().filter(has).filter(inside);
        let scatter: Option<Vec<f64>> =
            rows.map(|row| row.number(column).ok().flatten().map(|s| s * factor).filter(|s| *s > 0.0)).collect();
        scatter.filter(|scatter| scatter.len() == points.len())
    }

    /// Axes of abscissa and ordinate, in solver units.
    pub fn axes(&self, model: &Model) -> [Axis; 2] {
        let (x, y) = Computed::nothing(model).columns(self.spec.quantity);
        [x.axis(), y.axis()]
    }

    /// Name of its file.
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}

fn words(header: &str) -> Vec<String> {
    header.to_lowercase().split(|c: char| !c.is_alphanumeric()).map(str::to_owned).collect()
}

/// Rows of the last frame, of a table of thickness with one frame after another.
fn last_frame(mut csv: Csv) -> Csv {
    if let (Some(travel), Some(_)) = (csv.column("travel_mm"), csv.column("s0_mm")) {
        let frame = |row: &Record| row.fields.get(travel).unwrap_or("").to_owned();
        let last = csv.rows.last().map(frame);
        csv.rows.retain(|row| Some(frame(row)) == last);
    }
    csv
}
