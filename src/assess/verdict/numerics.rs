//! Whether the solution is good enough: balance of power, cut-off, penetration, moments of the layers.

use super::{Finding, Light, largest};
use crate::measure::moment_error;
use crate::model::Mode;
use crate::solution::StageSolution;
use crate::solver::warnings::{LARGEST_CUT_OFF, LARGEST_IMBALANCE, LARGEST_PENETRATION, formed};
use crate::table::Unit;

/// Error of a section's moment that a spring-back may carry \[–\].
const MOMENT: f64 = 0.05;

pub(super) fn judge(passes: &[StageSolution]) -> Vec<Finding> {
    if passes.iter().all(|pass| pass.steps.is_empty()) {
        return Vec::new();
    }
    let works = || passes.iter().filter(|pass| formed(&pass)).filter_map(|pass| Some(pass.steps.last()?.work));
    let imbalance = works().map(|work| work.imbalance().abs()).fold(0.0, f64::max);
    let cutoff = works().filter(|work| work.plastic > 0.0).map(|work| work.cutoff / work.plastic).fold(0.0, f64::max);
    let errors = passes.iter().filter(|pass| pass.model.mode != Mode::Flow && pass.model.release.is_none());
    let moment = errors.filter_map(|pass| moment_error(pass.frames.last()?)).map(|error| error.share);
    let mut findings = vec![
        share(
            ("power_balance", "Power balance"),
            (imbalance, LARGEST_IMBALANCE),
            "of the external work missing",
            "smaller steps (solver.max_step)",
        ),
        share(
            ("cutoff", "Cut-off"),
            (cutoff, LARGEST_CUT_OFF),
            "of the plastic work where the strain rate is cut off",
            "a smaller solver.cutoff_strain: stresses there are not the true ones",
        ),
        share(
            ("penetration", "Penetration"),
            (largest(passes, |step| step.penetration), LARGEST_PENETRATION),
            "of the thickness",
            "a larger solver.contact_stiffness, or contact by the augmented Lagrangian",
        ),
    ];
    findings.extend(moment.reduce(f64::max).map(|error| {
        share(
            ("moment_error", "Moment of the layers"),
            (error, MOMENT),
            "of the largest moment missed, estimated",
            "more layers (blank.layers)",
        )
    }));
    findings
}

fn share((key, label): (&'static str, &'static str), (value, limit): (f64, f64), what: &str, advice: &str) -> Finding {
    let light = Light::within(value, limit);
    Finding {
        key,
        label,
        light,
        value: Some(100.0 * value),
        unit: Unit::Percent,
        found: format!("{:.2} % {what}", 100.0 * value),
        limit: format!("{:.0} %", 100.0 * limit),
        source: "declared accuracy of the solver",
        advice: light.advice(advice),
    }
}
