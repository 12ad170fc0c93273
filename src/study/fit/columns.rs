//! Columns of a tension test by their headers.

use crate::study::StudyError;
use crate::table::{Csv, Unit};

/// Strain and stress measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// To the size at the beginning.
    Engineering,
    /// To the present size.
    True,
    /// True, without the elastic part.
    Plastic,
}

/// Column of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub column: usize,
    pub measure: Measure,
    /// Factor from the file's unit to the solver's.
    pub factor: f64,
}

/// The columns of a test.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Columns {
    /// Strain, or elongation where `is_force`.
    pub strain: Place,
    /// Stress, or force.
    pub stress: Place,
    pub is_force: bool,
    pub scatter: Option<Place>,
    pub width: Option<Place>,
}

const SCATTER: [&str; 6] = ["deviation", "stdev", "std", "scatter", "sd", "sigma"];
const WIDTH: [&str; 3] = ["width", "transverse", "lateral"];
const STRAIN: [&str; 1] = ["strain"];
const STRESS: [&str; 1] = ["stress"];
const FORCE: [&str; 2] = ["force", "load"];
const ELONGATION: [&str; 3] = ["elongation", "extension", "displacement"];

const EXAMPLE: &str = "name them as in `engineering_strain_percent,engineering_stress_MPa`, `true_strain,true_stress_MPa`, \
                       `plastic_strain,true_stress_MPa` or `elongation_mm,force_kN`";

impl Columns {
    /// Finds them.
    pub fn of(csv: &Csv, file: &str) -> Result<Self, StudyError> {
        let words: Vec<Vec<String>> = csv.header.fields.iter().map(words).collect();
        let has = |i: usize, any: &[&str]| words[i].iter().any(|word| any.contains(&word.as_str()));
        let find = |any: &[&str], none: &[&[&str]]| {
            (0..words.len()).find(|&i| has(i, any) && !none.iter().any(|none| has(i, none)))
        };
        let place = |column: usize, units: &[Unit]| Self::place(csv, file, column, &words[column], units);
        let of_strain = [Unit::None, Unit::Percent];
        let strain = find(&STRAIN, &[&SCATTER, &WIDTH, &["rate"]]);
        let stress = find(&STRESS, &[&SCATTER]);
        let (force, elongation) = (find(&FORCE, &[&SCATTER]), find(&ELONGATION, &[&SCATTER]));
        let scatter = find(&SCATTER, &[]).map(|column| place(column, &[Unit::MPa])).transpose()?;
        let width = find(&WIDTH, &[]).map(|column| place(column, &of_strain)).transpose()?;
        let (strain, stress, is_force) = match (strain, stress, elongation, force) {
            (Some(strain), Some(stress), ..) => (place(strain, &of_strain)?, place(stress, &[Unit::MPa])?, false),
            (_, _, Some(elongation), Some(force)) => (place(elongation, &[Unit::Mm])?, place(force, &[Unit::N])?, true),
            _ => {
                let what = format!(
                    "{file} has no columns of strain and stress, nor of elongation and force; it has {}",
                    csv.names()
                );
                return Err(StudyError::new(what, EXAMPLE));
            }
        };
        if strain.measure == Measure::Plastic && stress.measure != Measure::True {
            let what = format!("{file} has plastic strain over engineering stress");
            return Err(StudyError::new(what, "plastic strain goes with true stress: give `true_stress_MPa`"));
        }
        Ok(Self { strain, stress, is_force, scatter, width })
    }

    fn place(csv: &Csv, file: &str, column: usize, words: &[String], units: &[Unit]) -> Result<Place, StudyError> {
        let header = csv.header.fields.get(column).unwrap_or_default();
        let wrong = |what: String| StudyError::new(format!("{file}: {what}"), EXAMPLE);
        let (unit, factor) = match csv.unit(column) {
            Err(_) if units.contains(&Unit::None) => (Unit::None, 1.0),
            Ok((Unit::Percent, _)) => (Unit::Percent, 0.01),
            found => found.map_err(|error| wrong(error.to_string()))?,
        };
        if !units.contains(&unit) {
            return Err(wrong(format!("column `{header}` is in {}, which does not fit its name", unit.symbol())));
        }
        let has = |any: &[&str]| words.iter().any(|word| any.contains(&word.as_str()));
        let measure = if has(&["plastic"]) {
            Measure::Plastic
        } else if has(&["true", "log", "logarithmic", "cauchy"]) {
            Measure::True
        } else {
            Measure::Engineering
        };
        Ok(Place { column, measure, factor })
    }
}

fn words(header: &str) -> Vec<String> {
    header.to_lowercase().split(|c: char| !c.is_alphanumeric()).map(str::to_owned).collect()
}
