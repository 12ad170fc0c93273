//! Measured curves: a CSV file whose columns name their quantities and end with their units.

use super::{StudyError, fail};
use crate::case::Case;
use crate::case::comparison::{Against, ComparedQuantity, CurveSpec, Spec};
use crate::case::files::{self, Disk, Files};
use crate::model::Model;
use crate::plot::Axis;
use crate::results::comparison::{CompareError, Computed, Point};
use crate::table::{Csv, CsvError, Record};
use std::path::{Path, PathBuf};

/// A measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    /// Its file.
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
const NOT: [&str; 9] = ["holder", "edge", "binder", "deviation", "stdev", "std", "scatter", "sd", "error"];
const SCATTER: [&str; 5] = ["deviation", "stdev", "std", "scatter", "sd"];
const EXAMPLE: &str = "a curve has columns such as travel_mm,punch_force_kN or s0_mm,thickness_mm or travel_mm,draw_in_mm, and \
                       maybe one such as standard_deviation_kN";

impl MeasuredCurve {
    /// Reads a curve, whose columns name its quantity.
    pub fn load(path: &Path) -> Result<Self, StudyError> {
        let csv = read_csv(path, EXAMPLE)?;
        let find =
            |any: &[&str]| csv.header.fields.iter().position(|name| has_word(name, any) && !has_word(name, &NOT));
        let Some((quantity, x, y)) = RULES.iter().find_map(|(quantity, x, y)| Some((*quantity, find(x)?, find(y)?)))
        else {
            return fail(format!("{} is no curve of a run; it has {}", path.display(), csv.names()), EXAMPLE);
        };
        let [x, y] = [x, y].map(|i| csv.header.fields.get(i).unwrap_or_default().to_owned());
        let spec = CurveSpec { quantity, x, y, range: None, tolerance: f64::INFINITY };
        Ok(Self::new(path.to_owned(), spec, last_frame(csv)))
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
        let unit = |i: usize| csv.unit(i).ok().map(|(unit, _)| unit);
        let y = csv.column(&spec.y).and_then(unit);
        let is_scatter = |(i, name): (usize, &str)| has_word(name, &SCATTER) && unit(i).is_some() && unit(i) == y;
        let scatter = csv.header.fields.iter().enumerate().position(is_scatter);
        Self { path, spec, csv, scatter }
    }

    /// Its points with the computed values.
    pub fn points(&self, computed: &Computed) -> Result<Vec<Point>, CompareError> {
        computed.points(&self.spec, &self.path, &self.csv)
    }

    /// Standard deviation of each point; `None` if one has none.
    pub fn deviations(&self, points: &[Point]) -> Option<Vec<f64>> {
        let column = self.scatter?;
        let (_, factor) = self.csv.unit(column).ok()?;
        let (x, y) = (self.csv.column(&self.spec.x)?, self.csv.column(&self.spec.y)?);
        let (low, high) = self.spec.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let number = |row: &Record, column: usize| row.number(column).ok().flatten();
        let is_point =
            |row: &&Record| number(row, x).is_some_and(|x| (low..=high).contains(&x)) && number(row, y).is_some();
        let rows = self.csv.rows.iter().filter(is_point);
        let scatter = rows.map(|row| number(row, column).map(|size| size * factor).filter(|size| *size > 0.0));
        scatter.collect::<Option<Vec<f64>>>().filter(|scatter| scatter.len() == points.len())
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

pub(super) fn read_csv(path: &Path, example: &str) -> Result<Csv, StudyError> {
    let disk: &dyn Files = &Disk;
    let shown = path.display();
    let text = disk.text(path, files::CSV).map_err(|error| {
        let help = error.remedy("give the path of a CSV file");
        StudyError::new(format!("cannot read {shown}: {error}"), help)
    })?;
    Csv::read(&text, "the file", example).map_err(|error| csv_error(&shown.to_string(), &error))
}

pub(super) fn csv_error(name: &str, error: &CsvError) -> StudyError {
    let line = error.line.map_or_else(String::new, |line| format!(", line {line}"));
    StudyError::new(format!("{name}{line}: {}", error.what), error.help.clone())
}

pub(super) fn has_word(header: &str, any: &[&str]) -> bool {
    header.to_lowercase().split(|c: char| !c.is_alphanumeric()).any(|word| any.contains(&word))
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
