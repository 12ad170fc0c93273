//! A tension test as its file has it: columns by their headers, true strain and stress row by row.

use crate::study::measured_curve::{csv_error, has_word, read_csv};
use crate::study::{StudyError, fail};
use crate::table::{Csv, Unit};
use std::path::Path;

/// A tension test: true strain and stress, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Tension {
    /// Name of the file.
    pub name: String,
    pub(super) rows: Vec<TensionRow>,
    pub(super) is_plastic: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TensionRow {
    /// True strain, without the elastic part if the test is plastic \[–\].
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
struct Place {
    column: usize,
    measure: Measure,
    /// Factor from the file's unit to the solver's.
    factor: f64,
}

struct Columns {
    /// Elongation if `is_force`.
    strain: Place,
    /// Force if `is_force`.
    stress: Place,
    is_force: bool,
    scatter: Option<Place>,
    width: Option<Place>,
}

const SCATTER: [&str; 6] = ["deviation", "stdev", "std", "scatter", "sd", "sigma"];
const WIDTH: [&str; 3] = ["width", "transverse", "lateral"];
const FORCE: [&str; 2] = ["force", "load"];
const ELONGATION: [&str; 3] = ["elongation", "extension", "displacement"];
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
        let columns = Columns::new(csv, name)?;
        let [per_strain, per_stress] = match (columns.is_force, section, gauge) {
            (false, ..) => [1.0; 2],
            (true, Some(section), Some(gauge)) => [1.0 / gauge, 1.0 / section],
            (true, ..) => {
                let help = "give --section \"20 mm^2\" and --gauge \"80 mm\" of the specimen";
                return fail(format!("{name} has force and elongation"), help);
            }
        };
        let at = |line: usize| format!("{name}, line {line}");
        let (mut rows, mut lines) = (Vec::new(), Vec::new());
        for row in &csv.rows {
            let at = at(row.line);
            let [count, wanted] = [row.fields.len(), csv.header.fields.len()];
            if count < wanted {
                let help = "complete the row or take it out; a value that is not known is empty, as in `5.0,`";
                return fail(format!("{at}: {count} numbers stand under {wanted} columns"), help);
            }
            let number = |place: Place| match row.number(place.column) {
                Ok(number) => Ok(number.map(|number| number * place.factor)),
                Err(error) => fail(format!("{at}: {}", error.what), error.help),
            };
            let optional = |place: Option<Place>| place.map_or(Ok(None), number);
            let (Some(strain), Some(stress)) = (number(columns.strain)?, number(columns.stress)?) else { continue };
            let (strain, stress) = (strain * per_strain, stress * per_stress);
            if strain.abs() > LARGEST {
                let what = format!("{at}: a strain of {strain} is none of a tension test");
                return fail(what, "in per cent, the header ends so: strain_percent");
            }
            let strain = columns.strain.logarithmic(strain);
            let longer = if columns.stress.measure == Measure::True { 1.0 } else { strain.exp() };
            let scatter = optional(columns.scatter)?.map(|scatter| scatter * longer);
            if let Some(scatter) = scatter.filter(|scatter| *scatter <= 0.0) {
                let what = format!("{at}: a standard deviation of {scatter} MPa");
                return fail(what, "it must be above 0, or empty in all rows");
            }
            let width = columns.width.zip(optional(columns.width)?).map(|(place, width)| place.logarithmic(width));
            rows.push(TensionRow { strain, stress: stress * longer, scatter, width });
            lines.push(row.line);
        }
        if rows.iter().any(|row| row.scatter.is_none()) {
            rows.iter_mut().for_each(|row| row.scatter = None);
        }
        if rows.len() < FEWEST {
            let what = format!("{name} has {} rows with strain and stress, fewer than {FEWEST}", rows.len());
            return fail(what, EXAMPLE);
        }
        let is_tension = |value: fn(&TensionRow) -> f64| {
            let (low, high) =
                rows.iter().map(value).fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
            high > -low
        };
        if !is_tension(|row| row.strain) || !is_tension(|row| row.stress) {
            let what = format!("{name} is a test in compression: its strains or stresses are negative");
            return fail(what, "for a law of hardening, give both positive");
        }
        let mut furthest = f64::NEG_INFINITY;
        for (row, line) in rows.iter().zip(lines) {
            if row.strain < furthest - BACK {
                let what = format!("{}: the strain goes back from {furthest:.4} to {:.4}", at(line), row.strain);
                return fail(what, "one test a file, without unloading: cut out what goes back");
            }
            furthest = furthest.max(row.strain);
        }
        Ok(Self { name: name.to_owned(), rows, is_plastic: columns.strain.measure == Measure::Plastic })
    }
}

impl Columns {
    fn new(csv: &Csv, file: &str) -> Result<Self, StudyError> {
        let header = |i: usize| csv.header.fields.get(i).unwrap_or_default();
        let find = |any: &[&str], none: &[&[&str]]| {
            let is = |i: &usize| has_word(header(*i), any) && !none.iter().any(|none| has_word(header(*i), none));
            (0..csv.header.fields.len()).find(is)
        };
        let place = |column: usize, units: &[Unit]| Place::new(csv, file, column, units);
        let ratio = [Unit::None, Unit::Percent];
        let strain = find(&["strain"], &[&SCATTER, &WIDTH, &["rate"]]);
        let [stress, force, elongation] = [&["stress"][..], &FORCE, &ELONGATION].map(|any| find(any, &[&SCATTER]));
        let (strain, stress, is_force) = match (strain, stress, elongation, force) {
            (Some(strain), Some(stress), ..) => (place(strain, &ratio)?, place(stress, &[Unit::MPa])?, false),
            (_, _, Some(elongation), Some(force)) => (place(elongation, &[Unit::Mm])?, place(force, &[Unit::N])?, true),
            _ => {
                let what = format!("{file} has no columns of strain and stress, nor of elongation and force");
                return fail(format!("{what}; it has {}", csv.names()), NAMES);
            }
        };
        if strain.measure == Measure::Plastic && stress.measure != Measure::True {
            let help = "plastic strain goes with true stress: give `true_stress_MPa`";
            return fail(format!("{file} has plastic strain over engineering stress"), help);
        }
        let scatter = find(&SCATTER, &[]).map(|column| place(column, &[Unit::MPa])).transpose()?;
        let width = find(&WIDTH, &[]).map(|column| place(column, &ratio)).transpose()?;
        Ok(Self { strain, stress, is_force, scatter, width })
    }
}

impl Place {
    fn new(csv: &Csv, file: &str, column: usize, units: &[Unit]) -> Result<Self, StudyError> {
        let header = csv.header.fields.get(column).unwrap_or_default();
        let (unit, factor) = match csv.unit(column) {
            Err(_) if units.contains(&Unit::None) => (Unit::None, 1.0),
            Ok((Unit::Percent, _)) => (Unit::Percent, 0.01),
            Ok(unit) => unit,
            Err(error) => return fail(format!("{file}: {error}"), NAMES),
        };
        if !units.contains(&unit) {
            let symbol = unit.symbol();
            return fail(format!("{file}: column `{header}` is in {symbol}, which does not fit its name"), NAMES);
        }
        let measure = match header {
            header if has_word(header, &["plastic"]) => Measure::Plastic,
            header if has_word(header, &["true", "log", "logarithmic", "cauchy"]) => Measure::True,
            _ => Measure::Engineering,
        };
        Ok(Self { column, measure, factor })
    }

    fn logarithmic(self, strain: f64) -> f64 {
        if self.measure == Measure::Engineering { strain.ln_1p() } else { strain }
    }
}
