//! Rows of a tension test's file: columns by their headers, true strain and stress row by row.

use super::flow_curve::Reduction;
use crate::study::measured_curve::{SCATTER, csv_error, has_word};
use crate::study::{Result, StudyError, ensure, fail};
use crate::table::{Csv, Unit};

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

#[derive(Clone, Copy)]
struct Column {
    index: usize,
    is_true: bool,
    /// True strain without the elastic part.
    is_plastic: bool,
    /// Factor from the file's unit to strain or MPa.
    factor: f64,
}

const WIDTH: [&str; 3] = ["width", "transverse", "lateral"];
const RATIO: [Unit; 2] = [Unit::None, Unit::Percent];
pub(super) const EXAMPLE: &str =
    "write for example engineering_strain_percent,engineering_stress_MPa in the first line and 5,312 below it";
const NAMES: &str = "name them as in `engineering_strain_percent,engineering_stress_MPa`, `true_strain,true_stress_MPa`, \
                     `plastic_strain,true_stress_MPa` or `elongation_mm,force_kN`, or as your tester does: `Kraft [kN];Weg [mm]`";
const FEWEST: usize = 5;
/// Fall of the strain from one row to the next that is noise of an extensometer \[–\].
const BACK: f64 = 1e-3;
/// No sheet strains further before it necks \[–\].
const LARGEST: f64 = 3.0;

pub(super) fn rows(csv: &Csv, name: &str, reduction: &Reduction) -> Result<(Vec<FlowPoint>, bool)> {
    let not = [&SCATTER[..], &WIDTH].concat();
    let column = |any: &[&str], none: &[&str], units: &[Unit]| Column::find(csv, name, any, none, units);
    let scatter_column = column(&SCATTER, &[], &[Unit::MPa])?;
    let width_column = column(&WIDTH, &[], &RATIO)?;
    let curve = column(&["strain"], &[&not[..], &["rate"]].concat(), &RATIO)?;
    let curve = curve.zip(column(&["stress"], &not, &[Unit::MPa])?);
    let (strain_column, stress_column) = if let Some((strain, stress)) = curve {
        let help = "plastic strain goes with true stress: give `true_stress_MPa`";
        let what = format!("{name} has plastic strain over engineering stress");
        ensure(!strain.is_plastic || stress.is_true, what, help)?;
        (strain, stress)
    } else {
        let what = format!("{name} has no columns of strain and stress, nor of elongation and force");
        let elongation = column(&["elongation", "extension", "displacement"], &not, &[Unit::Mm])?;
        let Some((elongation, force)) = elongation.zip(column(&["force", "load"], &not, &[Unit::N])?) else {
            return fail(format!("{what}; it has {}", csv.names()), NAMES);
        };
        let Some((section, gauge)) = reduction.section.zip(reduction.gauge) else {
            let help = "give --section \"20 mm^2\" and --gauge \"80 mm\" of the specimen";
            return fail(format!("{name} has force and elongation"), help);
        };
        let per = |column: Column, size: f64| Column { factor: column.factor / size, ..column };
        (per(elongation, gauge), per(force, section))
    };
    let (mut rows, mut furthest, mut back) = (Vec::<FlowPoint>::new(), f64::NEG_INFINITY, None);
    for row in &csv.rows {
        let number = |column: Option<Column>| {
            let number = column.map_or(Ok(None), |column| row.number(column.index));
            let number = number.map_err(|error| csv_error(name, error))?;
            Ok::<_, StudyError>(number.zip(column).map(|(number, column)| number * column.factor))
        };
        let (at, count, wanted) = (format!("{name}, line {}", row.line), row.fields.len(), csv.header.fields.len());
        let help = "complete the row or take it out; a value that is not known is empty, as in `5.0,`";
        ensure(count >= wanted, format!("{at}: {count} numbers stand under {wanted} columns"), help)?;
        let Some((strain, stress)) = number(Some(strain_column))?.zip(number(Some(stress_column))?) else { continue };
        let what = format!("{at}: a strain of {strain} is none of a tension test");
        ensure(strain.abs() <= LARGEST, what, "in per cent, the header ends so: strain_percent")?;
        let strain = strain_column.logarithmic(strain);
        let longer = if stress_column.is_true { 1.0 } else { strain.exp() };
        let scatter = number(scatter_column)?.map(|scatter| scatter * longer);
        let what = format!("{at}: a standard deviation of {} MPa", scatter.unwrap_or(0.0));
        ensure(scatter.is_none_or(|s| s > 0.0), what, "it must be above 0, or empty in all rows")?;
        let width = width_column.zip(number(width_column)?).map(|(column, width)| column.logarithmic(width));
        if strain < furthest - BACK {
            back.get_or_insert(format!("{at}: the strain goes back from {furthest:.4} to {strain:.4}"));
        }
        furthest = furthest.max(strain);
        rows.push(FlowPoint { strain, stress: stress * longer, scatter, width });
    }
    if rows.iter().any(|row| row.scatter.is_none()) {
        rows.iter_mut().for_each(|row| row.scatter = None);
    }
    let is_positive = |value: fn(&FlowPoint) -> f64| {
        rows.iter().map(value).max_by(|a, b| a.abs().total_cmp(&b.abs())).is_some_and(|largest| largest > 0.0)
    };
    let few = format!("{name} has {} rows with strain and stress, fewer than {FEWEST}", rows.len());
    let compression = format!("{name} is a test in compression: its strains or stresses are negative");
    let is_tension = is_positive(|row| row.strain) && is_positive(|row| row.stress);
    ensure(rows.len() >= FEWEST, few, EXAMPLE)?;
    ensure(is_tension, compression, "for a law of hardening, give both positive")?;
    ensure(back.is_none(), back.unwrap_or_default(), "one test a file, without unloading: cut out what goes back")?;
    Ok((rows, strain_column.is_plastic))
}

impl Column {
    fn find(csv: &Csv, file: &str, any: &[&str], none: &[&str], units: &[Unit]) -> Result<Option<Self>> {
        let is = |header: &str| has_word(header, any) && !has_word(header, none);
        let found = csv.header.fields.iter().enumerate().find(|(_, header)| is(header));
        let Some((index, header)) = found else { return Ok(None) };
        let (unit, factor) = match csv.unit(index) {
            Err(_) if units.contains(&Unit::None) => (Unit::None, 1.0),
            Ok((Unit::Percent, _)) => (Unit::Percent, 0.01),
            Ok(unit) => unit,
            Err(error) => return fail(format!("{file}: {error}"), NAMES),
        };
        let what = format!("{file}: column `{header}` is in {}, which does not fit its name", unit.symbol());
        ensure(units.contains(&unit), what, NAMES)?;
        let is_plastic = has_word(header, &["plastic"]);
        let is_true = is_plastic || has_word(header, &["true", "log", "logarithmic", "cauchy"]);
        Ok(Some(Self { index, is_true, is_plastic, factor }))
    }

    fn logarithmic(self, strain: f64) -> f64 {
        if self.is_true { strain } else { strain.ln_1p() }
    }
}
