//! Every number and curve of a case with its error bar: [`FILE`].

use super::csv::number;
use super::{Files, Results};
use crate::study::verify::{Band, Verification};
use crate::table::Unit;

/// The file.
pub(super) const FILE: &str = "error_bars.csv";

const HEADERS: [&str; 7] = ["told_by", "quantity", "unit", "at_mm", "value", "error_bar", "made_of"];

/// [`FILE`], of a case that was verified.
pub(super) fn files<'a>(results: &'a Results<'a>) -> Files<'a> {
    let force = results.solution.case.model().extent().force_unit();
    Box::new(results.verification.into_iter().map(move |verification| (FILE.to_owned(), csv(verification, force))))
}

/// A row for every number, and for every point of a curve, in the solver's units: the truth lies within `error_bar` of the
/// value; empty where there is none, and why stands at the end.
fn csv(verification: &Verification, force: Unit) -> Vec<u8> {
    let mut rows = vec![HEADERS.map(str::to_owned)];
    rows.extend(verification.bars.iter().map(|bar| {
        let amount = bar.number.amount;
        let half = bar.half.map_or_else(String::new, number);
        let (told_by, key) = (bar.number.of.key().to_owned(), bar.number.key.to_owned());
        let unit = amount.unit.spelled().to_owned();
        [told_by, key, unit, String::new(), number(amount.value), half, bar.made_of().to_string()]
    }));
    let curves = [("punch_force", force, &verification.load), ("thickness", Unit::Mm, &verification.thickness)];
    for (key, unit, band) in curves {
        rows.extend(band.iter().flat_map(points).map(|[at, value, half]| {
            let [at, value, half] = [at, value, half].map(number);
            ["curve".to_owned(), key.to_owned(), unit.spelled().to_owned(), at, value, half, String::new()]
        }));
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    let never = "memory does not refuse a row";
    rows.iter().for_each(|row| writer.write_record(row).expect(never));
    writer.into_inner().expect(never)
}

/// Where, the curve there, and half the band.
fn points(band: &Band) -> impl Iterator<Item = [f64; 3]> {
    let sides = band.low.iter().zip(&band.high);
    band.x.iter().zip(sides).map(|(x, (low, high))| [*x, 0.5 * (low + high), 0.5 * (high - low)])
}
