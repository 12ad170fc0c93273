//! A tension test as its file has it: columns by their headers, true strain and stress row by row.

use crate::study::error::ensure;
use crate::study::measured_curve::{SCATTER, csv_error, has_word, read_csv};
use crate::study::{StudyError, fail};
use crate::table::{Csv, Unit};
use std::path::Path;

/// A tension test: true strain and stress, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Tension {
    /// Name of the file.
    pub name: String,
    pub(super) rows: Vec<FlowPoint>,
    pub(super) is_plastic: bool,
}

/// Point of a test or of a flow curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowPoint {
    /// True strain; of a flow curve or a plastic test without the elastic part \[–\].
    pub strain: f64,
    /// True stress \[MPa\].
    pub stress: f64,
    /// Standard deviation of the true stress \[MPa\].
    pub scatter: Option<f64>,
    /// True strain across \[–\].
    pub width: Option<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Measure {
    Engineering,
    True,
    /// True, without the elastic part.
    Plastic,
}

#[derive(Clone, Copy, Debug)]
struct Column {
    place: usize,
    measure: Measure,
    /// Factor from the file's unit to strain or MPa.
    factor: f64,
}

const WIDTH: [&str; 3] = ["width", "transverse", "lateral"];
const RATIO: [Unit; 2] = [Unit::None, Unit::Percent];
const EXAMPLE: &str =
    "write for example engineering_strain_percent,engineering_stress_MPa in the first line and 5,312 below it";
const NAMES: &str = "name them as in `engineering_strain_percent,engineering_stress_MPa`, `true_strain,true_stress_MPa`, \
                     `plastic_strain,true_stress_MPa` or `elongation_mm,force_kN`";
const FEWEST: usize = 5;
/// Fall of the strain from one row to the next that is noise of an extensometer \[–\].
const BACK: f64 = 1e-3;
/// No sheet strains further before it necks \[–\].
const LARGEST: f64 = 3.0;

impl Tension {
    /// Reads a test; `section` \[mm²\] and `gauge` \[mm\] turn force and elongation into stress and strain.
    pub fn load(path: &Path, section: Option<f64>, gauge: Option<f64>) -> Result<Self, StudyError> {
        Self::new(&read_csv(path, EXAMPLE)?, &path.to_string_lossy(), section, gauge)
    }

    /// Reads a test from a text.
    pub fn read(text: &str, name: &str, section: Option<f64>, gauge: Option<f64>) -> Result<Self, StudyError> {
        let csv = Csv::read(text, "the test", EXAMPLE).map_err(|error| csv_error(name, &error))?;
        Self::new(&csv, name, section, gauge)
    }

    fn new(csv: &Csv, name: &str, section: Option<f64>, gauge: Option<f64>) -> Result<Self, StudyError> {
        let not = [&SCATTER[..], &WIDTH].concat();
        let column = |any: &[&str], none: &[&str], units: &[Unit]| Column::find(csv, name, any, none, units);
        let scatter_column = column(&SCATTER, &[], &[Unit::MPa])?;
        let width_column = column(&WIDTH, &[], &RATIO)?;
        let curve = column(&["strain"], &[&not[..], &["rate"]].concat(), &RATIO)?;
        let curve = curve.zip(column(&["stress"], &not, &[Unit::MPa])?);
        let (strain_column, stress_column) = if let Some((strain, stress)) = curve {
            let fits = strain.measure != Measure::Plastic || stress.measure == Measure::True;
            let help = "plastic strain goes with true stress: give `true_stress_MPa`";
            ensure(fits, format!("{name} has plastic strain over engineering stress"), help)?;
            (strain, stress)
        } else {
            let elongation = column(&["elongation", "extension", "displacement"], &not, &[Unit::Mm])?;
            let what = format!("{name} has no columns of strain and stress, nor of elongation and force");
            let (elongation, force) = elongation
                .zip(column(&["force", "load"], &not, &[Unit::N])?)
                .ok_or_else(|| StudyError::new(format!("{what}; it has {}", csv.names()), NAMES))?;
            let help = "give --section \"20 mm^2\" and --gauge \"80 mm\" of the specimen";
            let missing = || StudyError::new(format!("{name} has force and elongation"), help);
            let (section, gauge) = section.zip(gauge).ok_or_else(missing)?;
            let per = |column: Column, size: f64| Column { factor: column.factor / size, ..column };
            (per(elongation, gauge), per(force, section))
        };
        let (mut rows, mut lines) = (Vec::new(), Vec::new());
        for row in &csv.rows {
            let at = format!("{name}, line {}", row.line);
            let [count, wanted] = [row.fields.len(), csv.header.fields.len()];
            let help = "complete the row or take it out; a value that is not known is empty, as in `5.0,`";
            ensure(count >= wanted, format!("{at}: {count} numbers stand under {wanted} columns"), help)?;
            let number = |column: Option<Column>| match column.map(|c| (row.number(c.place), c.factor)) {
                None => Ok(None),
                Some((Ok(number), factor)) => Ok(number.map(|number| number * factor)),
                Some((Err(error), _)) => fail(format!("{at}: {}", error.what), error.help),
            };
            let curve = number(Some(strain_column))?.zip(number(Some(stress_column))?);
            let Some((strain, stress)) = curve else { continue };
            let what = format!("{at}: a strain of {strain} is none of a tension test");
            ensure(strain.abs() <= LARGEST, what, "in per cent, the header ends so: strain_percent")?;
            let strain = strain_column.logarithmic(strain);
            let longer = if stress_column.measure == Measure::True { 1.0 } else { strain.exp() };
            let scatter = number(scatter_column)?.map(|scatter| scatter * longer);
            let what = format!("{at}: a standard deviation of {} MPa", scatter.unwrap_or(0.0));
            ensure(scatter.is_none_or(|s| s > 0.0), what, "it must be above 0, or empty in all rows")?;
            let width = width_column.zip(number(width_column)?).map(|(column, width)| column.logarithmic(width));
            rows.push(FlowPoint { strain, stress: stress * longer, scatter, width });
            lines.push(row.line);
        }
        if rows.iter().any(|row| row.scatter.is_none()) {
            rows.iter_mut().for_each(|row| row.scatter = None);
        }
        let what = format!("{name} has {} rows with strain and stress, fewer than {FEWEST}", rows.len());
        ensure(rows.len() >= FEWEST, what, EXAMPLE)?;
        let largest = |value: fn(&FlowPoint) -> f64| rows.iter().map(value).max_by(|a, b| a.abs().total_cmp(&b.abs()));
        let is_tension = largest(|row| row.strain) > Some(0.0) && largest(|row| row.stress) > Some(0.0);
        let what = format!("{name} is a test in compression: its strains or stresses are negative");
        ensure(is_tension, what, "for a law of hardening, give both positive")?;
        let mut furthest = f64::NEG_INFINITY;
        for (FlowPoint { strain, .. }, line) in rows.iter().zip(lines) {
            let what = format!("{name}, line {line}: the strain goes back from {furthest:.4} to {strain:.4}");
            ensure(*strain >= furthest - BACK, what, "one test a file, without unloading: cut out what goes back")?;
            furthest = furthest.max(*strain);
        }
        Ok(Self { name: name.to_owned(), rows, is_plastic: strain_column.measure == Measure::Plastic })
    }
}

impl Column {
    /// The first column whose header has one word and none of the others.
    fn find(csv: &Csv, file: &str, any: &[&str], none: &[&str], units: &[Unit]) -> Result<Option<Self>, StudyError> {
        let is = |header: &str| has_word(header, any) && !has_word(header, none);
        let found = csv.header.fields.iter().enumerate().find(|(_, header)| is(header));
        let Some((place, header)) = found else { return Ok(None) };
        let (unit, factor) = match csv.unit(place) {
            Err(_) if units.contains(&Unit::None) => (Unit::None, 1.0),
            Ok((Unit::Percent, _)) => (Unit::Percent, 0.01),
            Ok(unit) => unit,
            Err(error) => return fail(format!("{file}: {error}"), NAMES),
        };
        let what = format!("{file}: column `{header}` is in {}, which does not fit its name", unit.symbol());
        let measure = match header {
            header if has_word(header, &["plastic"]) => Measure::Plastic,
            header if has_word(header, &["true", "log", "logarithmic", "cauchy"]) => Measure::True,
            _ => Measure::Engineering,
        };
        ensure(units.contains(&unit), what, NAMES).map(|()| Some(Self { place, measure, factor }))
    }

    fn logarithmic(self, strain: f64) -> f64 {
        if self.measure == Measure::Engineering { strain.ln_1p() } else { strain }
    }
}
