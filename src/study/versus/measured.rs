//! Measured curves: columns of a CSV file, units at the end of their names.
//!
//! ```text
//! punch force over travel     travel_mm, punch_force_kN; several travels, travel_a_mm, travel_b_mm, are a curve each
//! thickness over the blank    s0_mm, thickness_mm; several thicknesses likewise
//! ```
//! `load_travel.csv` and `profile.csv` of a run are such files too; of the latter the last frame counts.

use super::Candidate;
use crate::study::{Readings, StudyError};
use crate::table::Csv;
use crate::units::{Unit, parse};
use std::path::{Path, PathBuf};

/// What a curve is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// Punch force \[N, or N/mm\] over the travel \[mm\].
    Load,
    /// Thickness \[mm\] over the initial distance from the axis \[mm\].
    Thickness,
}

/// A measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The file's name, and the column's where the file has several.
    pub name: String,
    /// What it is of.
    pub of: Of,
    /// Unit of its values.
    pub unit: Unit,
    /// In the order of the file.
    pub points: Vec<(f64, f64)>,
}

impl Curve {
    /// Number and name of the `i`-th curve from 0: `1: measured.csv`.
    pub fn label(&self, i: usize) -> String {
        format!("{}: {}", i + 1, self.name).into()
    }
}

/// The curves of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Its file, or what it is called.
    pub path: PathBuf,
    /// At least one.
    pub curves: Vec<Curve>,
}

/// What to write.
const EXAMPLE: &str = "a first line such as travel_mm,punch_force_kN or s0_mm,thickness_mm, and numbers below";

/// A column by its name and what its values are multiplied by.
struct Column {
    at: usize,
    name: String,
    unit: Unit,
    factor: f64,
}

impl Measured {
    /// Reads a table.
    ///
    /// # Errors
    /// When it cannot be read, is no table of numbers, or has no curve of the kinds that a run has.
    pub fn read(readings: &Readings) -> Result<Self, StudyError> {
        let csv = readings.table("give the path of a CSV file", EXAMPLE)?;
        let path = readings.path();
        let file = path.file_name().map(|name| name.to_string_lossy().into_owned());
        let mut curves = Vec::new();
        for (of, x, y) in [(Of::Load, "travel", "punch_force"), (Of::Thickness, "s0", "thickness")] {
            let [xs, ys] = [x, y].map(|stem| columns(&csv, stem));
            let (xs, ys) = (xs.map_err(|what| wrong(path, what))?, ys.map_err(|what| wrong(path, what))?);
            for (x, y) in xs.iter().flat_map(|x| ys.iter().map(move |y| (x, y))) {
                let which = [(&xs, x), (&ys, y)].into_iter().filter(|(all, _)| all.len() > 1).map(|(_, one)| &one.name);
                let name = file.iter().chain(which).map(String::as_str).collect::<Vec<_>>().join(", ");
                curves.push(Self::curve(path, &csv, of, [x, y], name)?);
            }
        }
        if curves.is_empty() {
            let what = format!("no curve of a run among the columns {}", csv.found());
            return Err(wrong(path, what));
        }
        Ok(Self { path: path.to_owned(), curves })
    }

    fn curve(path: &Path, csv: &Csv, of: Of, [x, y]: [&Column; 2], name: String) -> Result<Curve, StudyError> {
        let is_right = x.unit == Unit::Mm
            && match of {
                Of::Load => matches!(y.unit, Unit::N | Unit::NPerMm),
                Of::Thickness => y.unit == Unit::Mm,
            };
        if !is_right {
            let what = format!("`{}` over `{}` is no {}", y.name, x.name, of.words());
            return Err(wrong(path, what));
        }
        // Where frames follow each other, the last one counts.
        let frame = csv.column("travel_mm").filter(|_| of == Of::Thickness);
        let at = |row: &crate::table::Record| frame.map(|frame| row.fields.get(frame).unwrap_or("").to_owned());
        let last = csv.rows.last().map(at);
        let mut points = Vec::new();
        for row in csv.rows.iter().filter(|row| Some(at(row)) == last) {
            let number = |column: &Column| {
                let number = row.number(column.at);
                number.map_err(|error| {
                    wrong(path, format!("{} {}, column `{}`: {}", csv.counted, row.line, column.name, error.what))
                })
            };
            if let (Some(a), Some(b)) = (number(x)?, number(y)?) {
                points.push((a * x.factor, b * y.factor));
            }
        }
        if points.len() < 2 {
            return Err(wrong(path, format!("`{}` over `{}` has fewer than two points", y.name, x.name)));
        }
        Ok(Curve { name, of, unit: y.unit, points })
    }

    /// Whether some run has what each curve is of, where the curve is.
    pub(super) fn check(&self, candidates: &[Candidate]) -> Result<(), StudyError> {
        let Some(first) = candidates.first() else { return Ok(()) };
        for curve in &self.curves {
            let force = first.extent().force_unit();
            if curve.of == Of::Load && curve.unit != force {
                let what =
                    format!("its forces are in {}, those of the runs in {}", curve.unit.symbol(), force.symbol());
                return Err(wrong(&self.path, what));
            }
            let end = |candidate: &Candidate| match curve.of {
                Of::Load => candidate.travel(),
                Of::Thickness => candidate.case.model().blank.length,
            };
            let furthest = candidates.iter().map(end).fold(0.0, f64::max);
            let least = curve.points.iter().map(|p| p.0).fold(f64::INFINITY, f64::min);
            if least > furthest {
                let what = format!(
                    "{}: its {} begins at {least} mm and the runs end at {furthest} mm",
                    curve.name,
                    curve.of.words()
                );
                return Err(StudyError::new(what, "look at the unit in the header, or let the run go on further"));
            }
        }
        Ok(())
    }
}

impl Of {
    fn words(self) -> &'static str {
        match self {
            Self::Load => "force over travel",
            Self::Thickness => "thickness over the initial distance from the axis",
        }
    }
}

/// The columns of a name: that with a unit alone behind it, or all that go on after it.
fn columns(csv: &Csv, stem: &str) -> Result<Vec<Column>, String> {
    let named = csv
        .header
        .fields
        .iter()
        .enumerate()
        .filter(|(_, name)| name.strip_prefix(stem).is_some_and(|rest| rest.is_empty() || rest.starts_with('_')));
    let mut columns = Vec::new();
    for (at, name) in named {
        let (unit, factor) = csv.unit(at).map_err(|error| error.to_string())?;
        columns.push(Column { at, name: name.to_owned(), unit, factor });
    }
    let is_plain = |column: &Column| {
        let unit = column.name[stem.len()..].trim_start_matches('_').replace("_per_", "/");
        parse(&format!("1 {unit}")).is_ok()
    };
    match columns.iter().position(is_plain) {
        Some(plain) => Ok(vec![columns.swap_remove(plain)]),
        None => Ok(columns),
    }
}

fn wrong(path: &Path, what: impl std::fmt::Display) -> StudyError {
    StudyError::new(format!("{}: {what}", path.display()), format!("a curve has {EXAMPLE}"))
}
