//! `[solver]`, `[stop]` and `[output]`.

use super::{count, motion::Drive};
use crate::case::file::{self, ContactMethod, Iteration, Norm};
use crate::case::{CaseError, source::Source};
use crate::model::{self, Role, Settings, StopRules, Tool};
use crate::units::{Quantity, rounded};

pub(super) fn convert(file: &file::Solver, source: &Source) -> Result<Settings, CaseError> {
    let default = Settings::default();
    let or = |value: Option<f64>, default: f64| value.unwrap_or(default);
    let settings = Settings {
        iteration: file.iteration.map_or(default.iteration, |i| match i {
            Iteration::PrimalDual => model::Iteration::PrimalDual,
            Iteration::Newton => model::Iteration::Newton,
            Iteration::Secant => model::Iteration::Secant,
        }),
        norm: file.norm.map_or(default.norm, |n| match n {
            Norm::Velocity => model::Norm::Velocity,
            Norm::Residual => model::Norm::Residual,
            Norm::Both => model::Norm::Both,
        }),
        tolerance: or(file.tolerance.map(Quantity::value), default.tolerance),
        max_iterations: match file.max_iterations {
            Some(n) => count(source, "solver.max_iterations", n, 1..=10_000)?,
            None => default.max_iterations,
        },
        max_step: or(file.max_step.map(Quantity::value), default.max_step),
        first_step: or(file.first_step.map(Quantity::value), default.first_step),
        min_step: or(file.min_step.map(Quantity::value), default.min_step),
        cutoff_strain: or(file.cutoff_strain.map(Quantity::value), default.cutoff_strain),
        contact_stiffness: or(file.contact_stiffness.map(Quantity::value), default.contact_stiffness),
        contact_smoothing: or(file.contact_smoothing.map(Quantity::value), default.contact_smoothing),
        slip_speed: or(file.slip_speed.map(Quantity::value), default.slip_speed),
        facets: file.facets.map(|n| count(source, "solver.facets", n, 1..=1000)).transpose()?,
        round_facets: file.round_facets.unwrap_or(default.round_facets),
        contact: file.contact.map_or(default.contact, |c| match c {
            ContactMethod::Penalty => model::ContactMethod::Penalty,
            ContactMethod::AugmentedLagrangian => model::ContactMethod::AugmentedLagrangian,
        }),
        strain_step: or(file.strain_step.map(Quantity::value), default.strain_step),
        bend_ratio: or(file.bend_ratio.map(Quantity::value), default.bend_ratio),
    };
    let ranges = [
        ("tolerance", settings.tolerance, 1e-12, 0.1),
        ("min_step", settings.min_step, 1e-12, 0.1),
        ("max_step", settings.max_step, 1e-5, 0.5),
        ("cutoff_strain", settings.cutoff_strain, 1e-10, 1e-2),
        ("contact_stiffness", settings.contact_stiffness, 1.0, 1e7),
        ("contact_smoothing", settings.contact_smoothing, 1e-6, 0.1),
        ("slip_speed", settings.slip_speed, 1e-6, 1.0),
        ("strain_step", settings.strain_step, 1e-3, 1.0),
        ("bend_ratio", settings.bend_ratio, 1e-4, 1.0),
    ];
    for (key, value, low, high) in ranges {
        if !(low..=high).contains(&value) {
            let what = format!("`{key}` must lie between {low:?} and {high:?}, found {value:?}");
            return Err(source.error(&format!("solver.{key}"), what, "leave it out: the default serves every case"));
        }
    }
    let Settings { min_step, first_step, max_step, .. } = settings;
    if !(min_step <= first_step && first_step <= max_step) {
        let what = format!(
            "steps must satisfy min_step <= first_step <= max_step, found {min_step}, {first_step}, {max_step}"
        );
        let key =
            ["first_step", "max_step", "min_step"].into_iter().zip([file.first_step, file.max_step, file.min_step]);
        let key = key.into_iter().find(|(_, given)| given.is_some()).map_or("first_step", |(key, _)| key);
        return Err(source.error(&format!("solver.{key}"), what, "they are fractions of the travel"));
    }
    Ok(settings)
}

/// When a run ends before its full travel.
pub(super) fn stop(file: &file::Stop, tools: &[Tool], source: &Source) -> Result<StopRules, CaseError> {
    let default = StopRules::default();
    let contact_share = file.contact_share.map(Quantity::value);
    let path = "stop.contact_share";
    if let Some(share) = contact_share.filter(|share| *share > 1.0) {
        let what = format!("`contact_share` must lie between 0 and 100 %, found {} %", rounded(100.0 * share));
        return Err(source.error(path, what, "a corner never fills to the last: 95 % is a part that is formed"));
    }
    if contact_share.is_some() && tools.iter().all(|tool| tool.role == Role::Holder) {
        let what = "`contact_share` asks for contact with a punch or a die, and there is none";
        return Err(source.error(path, what, "add [tools.die], or drop it"));
    }
    let load_drop = file.load_drop.map(Quantity::value);
    Ok(StopRules { localised: file.localised.unwrap_or(default.localised), load_drop, contact_share })
}

/// Frames closer than this share of the travel are one, and nearer than that no step is worth taking [–].
const SAME: f64 = 1e-9;
const CLOSEST: f64 = 1e-6;

/// Times at which the state is kept [s], rising, the last one the end of the run.
pub(super) fn frames(file: &file::Output, drive: &Drive, source: &Source) -> Result<Vec<f64>, CaseError> {
    let Drive { travel, duration, .. } = *drive;
    let Some(list) = &file.frames else {
        let n = count(source, "output.count", file.count.unwrap_or(4), 1..=1000)?;
        return Ok((1..n).map(|i| duration * i as f64 / n as f64).chain([duration]).collect());
    };
    if file.count.is_some() {
        return Err(source.error("output.count", "both `frames` and `count` are given", "keep one of them"));
    }
    if travel == 0.0 {
        let what = "`frames` are punch travels, and there is no punch";
        return Err(source.error("output.frames", what, "write count = 8 for as many instants, equally spaced"));
    }
    let mut frames: Vec<f64> = list.iter().map(|f| f.value()).collect();
    if let Some(i) = frames.iter().position(|&f| f > travel * (1.0 + 1e-9)) {
        let what = format!("a frame at {} mm lies beyond the travel of {} mm", rounded(frames[i]), rounded(travel));
        return Err(source.error(&format!("output.frames.{i}"), what, "drop it, or lengthen tools.punch.travel"));
    }
    frames.retain(|&f| f < travel * (1.0 - 1e-9));
    frames.sort_by(f64::total_cmp);
    frames.dedup_by(|later, earlier| *later - *earlier < SAME * travel);
    let mut before = 0.0;
    for &frame in &frames {
        if frame - before < CLOSEST * travel {
            let what = format!(
                "frames at {} and {} mm are closer than a millionth of the travel",
                rounded(before),
                rounded(frame)
            );
            return Err(source.error("output.frames", what, "keep one of them; the flat sheet at 0 mm is none"));
        }
        before = frame;
    }
    Ok(frames.into_iter().map(|f| drive.time_at(f)).chain([duration]).collect())
}
