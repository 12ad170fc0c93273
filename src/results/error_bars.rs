//! Error bars of a verified case: of every number and curve, and of every run.

use super::csv::{number, records};
use super::{Files, Results};
use crate::table::Unit;
use crate::verification::{Band, Number, Outcome, Verification};

/// Name of the file with every number and curve.
pub(super) const FILE: &str = "error_bars.csv";

/// Name of the file with the numbers of every run.
pub const RUNS: &str = "verification.csv";

/// First columns of [`RUNS`], by which it is recognised.
pub const BEGINNING: &str = "told_by,quantity,unit,value,error_bar";

const HEADERS: [&str; 7] = ["told_by", "quantity", "unit", "at_mm", "value", "error_bar", "made_of"];

/// Origin, key and unit of a number.
fn name(own: &Number) -> [String; 3] {
    [own.origin.key(), own.quantity.key, own.quantity.amount.unit.spelled()].map(str::to_owned)
}

fn cell(value: Option<f64>) -> String {
    value.map_or_else(String::new, number)
}

/// One row per number and per point of a curve in the solver's units; the reason if there is no bar.
pub(super) fn files(results: &Results) -> Files {
    let Some(verification) = results.verification else { return Vec::new() };
    let force = results.solution.case.model().extent().force_unit();
    let mut rows = vec![HEADERS.map(str::to_owned)];
    rows.extend(verification.numbers.iter().map(|own| {
        let [origin, key, unit] = name(own);
        [origin, key, unit, String::new(), number(own.quantity.value()), cell(own.half()), own.made_of()]
    }));
    let curves = [("punch_force", force, &verification.load), ("thickness", Unit::Mm, &verification.thickness)];
    for (key, unit, band) in curves {
        rows.extend(band.iter().flat_map(points).map(|point| {
            let [at, value, half] = point.map(number);
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

/// Content of [`RUNS`]: a row per number with its error bar, and a column for every finer run.
pub fn runs_csv(verification: &Verification) -> Vec<u8> {
    let runs: Vec<&Outcome> = verification.outcomes.iter().filter(|run| run.direction.is_some()).collect();
    let names = runs.iter().map(|run| format!("{}_{}", run.direction.map_or("", |d| d.key()), run.times));
    let header = BEGINNING.split(',').map(str::to_owned).chain(names).collect();
    let rows = verification.numbers.iter().map(|own| {
        let values = [Some(own.quantity.value()), own.half()].into_iter().chain(runs.iter().map(|run| run.value(own)));
        name(own).into_iter().chain(values.map(cell)).collect::<Vec<_>>()
    });
    records(std::iter::once(header).chain(rows))
}
