//! A tension test as its file has it.

use super::columns::{Columns, Measure};
use crate::study::measured_data::csv_error;
use crate::study::{MeasuredData, StudyError};
use crate::table::Csv;

/// A tension test: true strain and stress, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Tension {
    /// Name of the file, or what it is called.
    pub name: String,
    pub(super) rows: Vec<TensionRow>,
    /// Whether its strains are plastic ones.
    pub(super) is_plastic: bool,
}

/// A row of a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TensionRow {
    /// True strain, plastic where the test says so \[–\].
    pub strain: f64,
    /// True stress \[MPa\].
    pub stress: f64,
    /// Standard deviation of the true stress, where it is known \[MPa\].
    pub scatter: Option<f64>,
    /// True strain across \[–\].
    pub width: Option<f64>,
}

const EXAMPLE: &str =
    "write for example engineering_strain_percent,engineering_stress_MPa in the first line and 5,312 below it";
/// Fewest rows of a test.
const FEWEST: usize = 5;
/// A strain falls by no more than this from one row to the next: noise of an extensometer \[–\].
const BACK: f64 = 1e-3;
/// No sheet strains further before it necks \[–\].
const LARGEST: f64 = 3.0;

impl Tension {
    /// Reads a test; of a force and an elongation `section` \[mm²\] and `gauge` \[mm\] make stress and strain.
    ///
    /// # Errors
    /// When it cannot be read, a column is missing or without its unit, strains go back, or it is no tension.
    pub fn load(data: &MeasuredData, section: Option<f64>, gauge: Option<f64>) -> Result<Self, StudyError> {
        let csv = data.table(EXAMPLE)?;
        Self::of(&csv, &data.to_string(), section, gauge)
    }

    /// Reads a test from a text.
    ///
    /// # Errors
    /// Those of [`load`](Self::load).
    pub fn read(text: &str, name: &str, section: Option<f64>, gauge: Option<f64>) -> Result<Self, StudyError> {
        let csv = Csv::read(text, "the test", EXAMPLE).map_err(|error| csv_error(name, &error))?;
        Self::of(&csv, name, section, gauge)
    }

    fn of(csv: &Csv, name: &str, section: Option<f64>, gauge: Option<f64>) -> Result<Self, StudyError> {
        let at = |line: usize| format!("{name}, {} {line}", csv.counted);
        let columns = Columns::of(csv, name)?;
        let (per_strain, per_stress) = match (columns.is_force, section, gauge) {
            (true, Some(section), Some(gauge)) => (1.0 / gauge, 1.0 / section),
            (true, ..) => {
                let what = format!("{name} has force and elongation");
                return Err(StudyError::new(what, "give --section \"20 mm^2\" and --gauge \"80 mm\" of the specimen"));
            }
            _ => (1.0, 1.0),
        };
        let mut rows: Vec<TensionRow> = Vec::new();
        let mut lines = Vec::new();
        for row in &csv.rows {
            let [found, wanted] = [row.fields.len(), csv.header.fields.len()];
            if found < wanted {
                let what = format!("{}: {found} numbers stand under {wanted} columns", at(row.line));
                return Err(StudyError::new(
                    what,
                    "complete the row or take it out; a value that is not known is empty, as in `5.0,`",
                ));
            }
            let number = |place: super::columns::Place| {
                let number = row
                    .number(place.column)
                    .map_err(|error| StudyError::new(format!("{}: {}", at(row.line), error.what), error.help));
                number.map(|number| number.map(|number| number * place.factor))
            };
            let (Some(strain), Some(stress)) = (number(columns.strain)?, number(columns.stress)?) else { continue };
            let (strain, stress) = (strain * per_strain, stress * per_stress);
            if strain.abs() > LARGEST {
                let what = format!("{}: a strain of {strain} is none of a tension test", at(row.line));
                return Err(StudyError::new(what, "in per cent, the header ends so: strain_percent"));
            }
            let log = |strain: f64, measure| if measure == Measure::Engineering { strain.ln_1p() } else { strain };
            let true_strain = log(strain, columns.strain.measure);
            let longer = if columns.stress.measure == Measure::True { 1.0 } else { true_strain.exp() };
            let scatter = columns.scatter.map(number).transpose()?.flatten().map(|scatter| scatter * longer);
            let width = columns.width.map(|place| Ok::<_, StudyError>(number(place)?.map(|w| log(w, place.measure))));
            let new = TensionRow {
                strain: true_strain,
                stress: stress * longer,
                scatter,
                width: width.transpose()?.flatten(),
            };
            if let Some(scatter) = scatter.filter(|scatter| *scatter <= 0.0) {
                let what = format!("{}: a standard deviation of {scatter} MPa", at(row.line));
                return Err(StudyError::new(what, "it must be above 0, or empty in all rows"));
            }
            rows.push(new);
            lines.push(row.line);
        }
        if rows.iter().any(|row| row.scatter.is_none()) {
            rows.iter_mut().for_each(|row| row.scatter = None);
        }
        if rows.len() < FEWEST {
            let what = format!("{name} has {} rows with strain and stress, fewer than {FEWEST}", rows.len());
            return Err(StudyError::new(what, EXAMPLE));
        }
        let tension = |value: fn(&TensionRow) -> f64| {
            let (low, high) =
                rows.iter().map(value).fold((0.0, 0.0), |(low, high): (f64, f64), x| (low.min(x), high.max(x)));
            high > -low
        };
        if !tension(|row| row.strain) || !tension(|row| row.stress) {
            let what = format!("{name} is a test in compression: its strains or stresses are negative");
            return Err(StudyError::new(what, "for a law of hardening, give both positive"));
        }
        let mut furthest = f64::NEG_INFINITY;
        for (row, line) in rows.iter().zip(lines) {
            if row.strain < furthest - BACK {
                let what = format!("{}: the strain goes back from {furthest:.4} to {:.4}", at(line), row.strain);
                return Err(StudyError::new(what, "one test a file, without unloading: cut out what goes back"));
            }
            furthest = furthest.max(row.strain);
        }
        Ok(Self { name: name.to_owned(), rows, is_plastic: columns.strain.measure == Measure::Plastic })
    }
}
