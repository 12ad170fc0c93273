//! Measured curves: a CSV file whose columns name their quantities and end with their units.

use super::*;
use crate::case::comparison::{ComparedQuantity, Spec};
use crate::results::comparison::Computed;
use crate::table::{Csv, CsvError};

const TRAVEL: &[&str] = &["travel", "stroke"];
/// Quantities, words of their abscissae and of their ordinates.
const RULES: [(ComparedQuantity, &[&str], &[&str]); 4] = [
    (ComparedQuantity::PunchForce, TRAVEL, &["force", "load"]),
    (ComparedQuantity::DrawInAtTravel, TRAVEL, &["draw"]),
    (ComparedQuantity::ThicknessAtS0, &["s0"], &["thickness"]),
    (ComparedQuantity::ThicknessAtRadius, &["r", "radius"], &["thickness"]),
];
pub(super) const SCATTER: [&str; 6] = ["deviation", "stdev", "std", "scatter", "sd", "sigma"];
pub(super) const OF_FILE: &str = "give the path of a CSV file";
const OTHER: [&str; 4] = ["holder", "edge", "binder", "error"];
const EXAMPLE: &str = "a curve has columns such as travel_mm,punch_force_kN or s0_mm,thickness_mm or travel_mm,draw_in_mm, and \
                       maybe one such as standard_deviation_kN";

/// Reads a measured curve, whose columns name its quantity.
pub fn measured_curve(path: &Path) -> Result<Spec> {
    let name = path.display().to_string();
    let text = Disk.text(path, files::CSV).map_err(|error| StudyError::unreadable(path, &error, OF_FILE))?;
    let mut csv = Csv::read(&text, "the file", EXAMPLE).map_err(|error| csv_error(&name, error))?;
    let is = |name: &str, any: &[&str]| has_word(name, any) && !has_word(name, &OTHER) && !has_word(name, &SCATTER);
    let find = |any: &[&str]| csv.header.fields.iter().find(|name| is(name, any)).map(str::to_owned);
    let curve = RULES.iter().find_map(|(quantity, x, y)| Some((*quantity, vec![find(x)?, find(y)?])));
    let Some((quantity, columns)) = curve else {
        return fail(format!("{name} is no curve of a run; it has {}", csv.names()), EXAMPLE);
    };
    // Only the last frame of a table of thickness with one frame after another.
    if let (Some(travel), Some(_)) = (csv.column("travel_mm"), csv.column("s0_mm")) {
        let last = csv.rows.last().and_then(|row| row.fields.get(travel)).map(str::to_owned);
        csv.rows.retain(|row| row.fields.get(travel) == last.as_deref());
    }
    let spec = Spec { quantity, columns, tolerance: f64::INFINITY, ..Spec::default() };
    Ok(Spec { reference: path.to_owned(), data: Some(csv), ..spec })
}

pub(super) fn deviations(curve: &Spec, computed: &Computed) -> Option<Vec<f64>> {
    let csv = curve.data.as_ref()?;
    let unit = |name: &str| csv.column(name).and_then(|i| csv.unit(i).ok()).map(|(unit, _)| unit);
    let y = unit(&curve.columns[1]);
    let scatter = csv.header.fields.iter().find(|name| has_word(name, &SCATTER) && y.is_some() && unit(name) == y)?;
    let columns = vec![curve.columns[0].clone(), scatter.to_owned()];
    let sizes = computed.points(&Spec { columns, ..curve.clone() }).ok()?.into_iter().map(|point| point.reference);
    let sizes: Vec<f64> = sizes.filter(|size| *size > 0.0).collect();
    (sizes.len() == computed.points(curve).ok()?.len()).then_some(sizes)
}

pub(super) fn csv_error(name: &str, error: CsvError) -> StudyError {
    let line = error.line.map_or_else(String::new, |line| format!(", line {line}"));
    StudyError::new(format!("{name}{line}: {}", error.what), error.help)
}

pub(super) fn has_word(header: &str, any: &[&str]) -> bool {
    header.to_lowercase().split(|c: char| !c.is_alphanumeric()).any(|word| any.contains(&word))
}
