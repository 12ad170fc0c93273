//! `[material.voids]`.

use crate::case::file;
use crate::case::{CaseError, source::Source};
use crate::material::Gtn;
use crate::material::gtn::{Coalescence, Nucleation};
use crate::units::Quantity;

/// Largest initial porosity \[–\]: beyond it the sheet is a sieve.
const POROUS: f64 = 0.3;

pub(super) fn convert(file: file::Voids, source: &Source) -> Result<Gtn, CaseError> {
    let fail = |key: &str, what: String, help: &str| Err(source.error(&format!("material.voids.{key}"), what, help));
    let q1 = file.q1.map_or(1.5, Quantity::value);
    let q3 = file.q3.map_or(q1 * q1, Quantity::value);
    let voids = Gtn {
        q1,
        q2: file.q2.map_or(1.0, Quantity::value),
        q3,
        initial: file.initial.value(),
        nucleation: file.nucleation.map(|n| Nucleation {
            fraction: n.fraction.value(),
            strain: n.strain.value(),
            deviation: n.deviation.value(),
        }),
        coalescence: file
            .coalescence
            .map(|c| Coalescence { critical: c.critical.value(), fracture: c.fracture.value() }),
    };
    for (key, value, least, most) in [("q1", q1, 0.5, 5.0), ("q2", voids.q2, 0.1, 5.0), ("q3", q3, 0.1, 25.0)] {
        if !(least..=most).contains(&value) {
            return fail(
                key,
                format!("`{key}` must lie between {least} and {most}, found {value}"),
                "1.5, 1 and 2.25 are usual",
            );
        }
    }
    if q3 > q1 * q1 * (1.0 + 1e-9) {
        let what = format!("`q3` must not exceed q1² = {}, found {q3}", q1 * q1);
        return fail("q3", what, "leave it out: it is q1² then");
    }
    if let Some(c) = voids.coalescence {
        if c.critical >= c.fracture {
            let what = format!("voids join from {} on and the sheet is gone at {}", c.critical, c.fracture);
            return fail("coalescence.fracture", what, "fracture must lie above critical: 0.15 and 0.25 are usual");
        }
        if c.fracture > 1.0 / q1 {
            let what = format!("`fracture` must not exceed 1/q1 = {:.3}, found {}", 1.0 / q1, c.fracture);
            return fail("coalescence.fracture", what, "there the sheet bears nothing without coalescence either");
        }
    }
    let most = voids.coalescence.map_or(POROUS, |c| c.critical.min(POROUS));
    if voids.initial > most {
        let what = format!("an initial porosity of {} is more than {most}", voids.initial);
        return fail("initial", what, "sheet metal has 0 to 0.02");
    }
    if let Some(n) = voids.nucleation.filter(|n| n.deviation > n.strain) {
        let what = format!("a deviation of {} is wider than the mean strain of {}", n.deviation, n.strain);
        return fail("nucleation.deviation", what, "strain = 0.3 and deviation = 0.1 are usual");
    }
    Ok(voids)
}
