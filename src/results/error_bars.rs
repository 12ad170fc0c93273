//! Every number and curve of a verified case with its error bar.

use super::csv::{number, records};
use super::{Files, Results};
use crate::table::Unit;
use crate::verification::Band;

/// Name of the file.
pub(super) const FILE: &str = "error_bars.csv";

const HEADERS: [&str; 7] = ["told_by", "quantity", "unit", "at_mm", "value", "error_bar", "made_of"];

/// One row per number and per point of a curve in the solver's units; the reason where there is no bar.
pub(super) fn files(results: &Results) -> Files {
    let Some(verification) = results.verification else { return Vec::new() };
    let force = results.solution.case.model().extent().force_unit();
    let mut rows = vec![HEADERS.map(str::to_owned)];
    rows.extend(verification.numbers.iter().map(|own| {
        let half = own.half().map_or_else(String::new, number);
        let (quantity, unit) = (&own.quantity, own.quantity.amount.unit.spelled());
        let [origin, key, unit] = [own.origin.key(), quantity.key, unit].map(str::to_owned);
        [origin, key, unit, String::new(), number(quantity.value()), half, own.made_of()]
    }));
    let curves = [("punch_force", force, &verification.load), ("thickness", Unit::Mm, &verification.thickness)];
    for (key, unit, band) in curves {
        rows.extend(band.iter().flat_map(points).map(|[at, value, half]| {
            let [at, value, half] = [at, value, half].map(number);
            ["curve".to_owned(), key.to_owned(), unit.spelled().to_owned(), at, value, half, String::new()]
        }));
    }
    vec![(FILE.to_owned(), records(rows))]
}

/// Place, value and half the width of a band.
fn points(band: &Band) -> impl Iterator<Item = [f64; 3]> {
    let sides = band.low.iter().zip(&band.high);
    band.x.iter().zip(sides).map(|(x, (low, high))| [*x, 0.5 * (low + high), 0.5 * (high - low)])
}
