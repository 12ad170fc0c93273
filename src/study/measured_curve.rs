//! Measured curves: a CSV file whose columns name their quantities and end with their units.

use super::{StudyError, fail};
use crate::case::Case;
use crate::case::comparison::{ComparedQuantity, Spec};
use crate::case::files::{self, Disk, Files};
use crate::results::comparison::Computed;
use crate::table::{Csv, CsvError, Record};
use std::path::Path;

/// A measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    /// Its file, quantity and columns.
    pub spec: Spec,
    /// Header of the points' standard deviations.
    scatter: Option<String>,
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
/// Words of a standard deviation.
pub(super) const SCATTER: [&str; 6] = ["deviation", "stdev", "std", "scatter", "sd", "sigma"];
const OTHER: [&str; 4] = ["holder", "edge", "binder", "error"];
const EXAMPLE: &str = "a curve has columns such as travel_mm,punch_force_kN or s0_mm,thickness_mm or travel_mm,draw_in_mm, and \
                       maybe one such as standard_deviation_kN";

impl MeasuredCurve {
    /// Reads a curve, whose columns name its quantity.
    pub fn load(path: &Path) -> Result<Self, StudyError> {
        let csv = read_csv(path, EXAMPLE)?;
        let is = |name: &str, any: &[&str]| has_word(name, any) && !has_word(name, &OTHER) && !has_word(name, &SCATTER);
        let find = |any: &[&str]| csv.header.fields.iter().position(|name| is(name, any));
        let Some((quantity, x, y)) = RULES.iter().find_map(|(quantity, x, y)| Some((*quantity, find(x)?, find(y)?)))
        else {
            return fail(format!("{} is no curve of a run; it has {}", path.display(), csv.names()), EXAMPLE);
        };
        let [x, y] = [x, y].map(|i| csv.header.fields.get(i).unwrap_or_default().to_owned());
        let (reference, data, columns) = (path.to_owned(), Some(last_frame(csv)), vec![x, y]);
        let spec = Spec { reference, data, quantity, columns, tolerance: f64::INFINITY, ..Spec::default() };
        Ok(Self::new(spec))
    }

    /// Curves that a case is compared with.
    pub fn of_case(case: &Case) -> Vec<Self> {
        let curves = case.compare.iter().filter(|spec| spec.quantity.is_curve() && spec.data.is_some());
        curves.cloned().map(Self::new).collect()
    }

    fn new(spec: Spec) -> Self {
        let scatter = spec.data.as_ref().and_then(|csv| {
            let unit = |i: usize| csv.unit(i).ok().map(|(unit, _)| unit);
            let y = csv.column(&spec.columns[1]).and_then(unit);
            let is_scatter =
                |(i, name): &(usize, &str)| has_word(name, &SCATTER) && unit(*i).is_some() && unit(*i) == y;
            csv.header.fields.iter().enumerate().find(is_scatter).map(|(_, name)| name.to_owned())
        });
        Self { spec, scatter }
    }

    /// Standard deviation of each point; `None` if one has none.
    pub fn deviations(&self, computed: &Computed) -> Option<Vec<f64>> {
        let columns = vec![self.spec.columns[0].clone(), self.scatter.clone()?];
        let sizes = computed.points(&Spec { columns, ..self.spec.clone() }).ok()?.into_iter().map(|p| p.reference);
        let sizes: Vec<f64> = sizes.filter(|size| *size > 0.0).collect();
        (sizes.len() == computed.points(&self.spec).ok()?.len()).then_some(sizes)
    }

    /// Name of its file.
    pub fn name(&self) -> String {
        self.spec.reference.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}

pub(super) fn read_csv(path: &Path, example: &str) -> Result<Csv, StudyError> {
    let shown = path.display();
    let text = Disk.text(path, files::CSV).map_err(|error| {
        let help = files::remedy(&error, "give the path of a CSV file");
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
