//! Fitted numbers, for programs.

use crate::numerics::profile::End;
use crate::study::fit::{CaseFit, Direction, Estimate, Estimates, FlowCurve, LawFit, LawFits, Matched, material_text};
use serde_json::{Value, json};

/// Laws beside each other, how sure their numbers are, and the tests that they are fitted to.
pub fn fit_law(fits: &LawFits) -> Value {
    let of_fit = |fit: &LawFit| {
        json!({
            "law": fit.kind.name(), "formula": fit.hardening.describe(), "rate": fit.rate.map(|rate| rate.to_string()),
            "r2": fit.r2, "rms_MPa": fit.rms, "aic": fit.aic, "bows": fit.bows, "points": fit.misses.len(),
            "parameters": fit.estimates.all.iter().map(estimate).collect::<Vec<_>>(), "correlations": correlations(&fit.estimates),
        })
    };
    let of_test = |test: &FlowCurve| {
        json!({
            "file": test.name, "young_MPa": test.young, "yield_stress_MPa": test.yield_stress, "strength_MPa": test.strength,
            "uniform_plastic_strain": test.uniform, "points": test.points.len(), "end": test.end(), "r": test.r.map(|r| r.0),
            "rate_per_s": test.rate, "direction_deg": test.direction,
        })
    };
    let of_direction = |d: &Direction| json!({ "direction_deg": d.angle, "tests": d.tests, "stress_ratio": d.ratio, "r": d.r, "r_error": d.r_error });
    json!({
        "best": fits.best().kind.name(),
        "laws": fits.fits.iter().map(of_fit).collect::<Vec<_>>(),
        "tests": fits.tests.iter().map(of_test).collect::<Vec<_>>(),
        "directions": fits.directions.iter().map(of_direction).collect::<Vec<_>>(),
        "told": fits.sentences().iter().map(ToString::to_string).collect::<Vec<_>>(),
        "material": material_text(fits, fits.best()),
    })
}

/// Keys of a case that meet measured curves, how sure they are, and the curves.
pub fn fit_case(fit: &CaseFit) -> Value {
    let curve = |matched: &Matched| {
        let points = matched.points.iter().map(|p| json!([p.x, p.reference, p.computed])).collect::<Vec<_>>();
        json!({ "file": matched.name, "left_out": matched.left_out, "x_measured_computed": points })
    };
    json!({
        "parameters": fit.estimates.all.iter().map(estimate).collect::<Vec<_>>(),
        "start": fit.start,
        "correlations": correlations(&fit.estimates),
        "rms": { "start": fit.rms[0], "end": fit.rms[1], "noise": fit.noise },
        "differences": fit.steps,
        "runs": fit.runs[0],
        "failed": fit.runs[1],
        "curves": fit.matched.iter().map(curve).collect::<Vec<_>>(),
        "set": fit.settings,
        "told": fit.sentences().iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

fn correlations(estimates: &Estimates) -> Vec<Vec<Option<f64>>> {
    let count = estimates.all.len();
    (0..count).map(|i| (0..count).map(|j| estimates.correlation(i, j)).collect()).collect()
}

fn at(end: End) -> Option<f64> {
    match end {
        End::At(value) => Some(value),
        End::Open | End::Unknown => None,
    }
}

fn estimate(e: &Estimate) -> Value {
    let [low, high] = e.ends.map(at);
    json!({
        "parameter": e.key, "unit": e.unit, "value": e.value, "standard_error": e.error, "low_95": low, "high_95": high,
        "bounds": e.bounds, "at_bound": e.pushed.is_some(),
    })
}
