//! `[solver]`, `[stop]` and `[output]`.

use super::motion::Drive;
use super::patch::equally_spaced;
use super::values::count;
use crate::case::file;
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::throat;
use crate::model::{ModelError, Role, Settings, StopRules, Tool};
use crate::units::{Dimensioned, rounded};

pub(super) fn check(settings: &Settings, source: &Source) -> Result<(), CaseError> {
    let Err(error) = settings.check() else { return Ok(()) };
    let short = |what: &str| what.trim_start_matches("settings.").to_owned();
    Err(match error {
        ModelError::Range { what, .. } if short(&what) == "first_step" => {
            let Settings { min_step, first_step, max_step, .. } = settings;
            let steps = ["first_step", "max_step", "min_step"].map(|key| format!("solver.{key}"));
            let given = steps.iter().find(|path| source.has(path)).unwrap_or(&steps[0]);
            let what = format!(
                "steps must satisfy min_step <= first_step <= max_step, found {min_step}, {first_step}, {max_step}"
            );
            source.error(given, what, "they are fractions of the travel")
        }
        ModelError::Count { what, value, least, most } => {
            let what = short(&what);
            let help = format!("the nearest that can be solved: {what} = {}", value.clamp(least, most));
            source.error(&format!("solver.{what}"), ModelError::Count { what, value, least, most }.to_string(), help)
        }
        ModelError::Range { what, value, least, most } => {
            let (what, help) = (short(&what), "leave it out: the default serves every case");
            source.error(&format!("solver.{what}"), ModelError::Range { what, value, least, most }.to_string(), help)
        }
        error => source.error("solver", error.to_string(), "leave it out: the default serves every case"),
    })
}

/// When a run ends before its full travel.
pub(super) fn stop(rules: &StopRules, tools: &[Tool], source: &Source) -> Result<(), CaseError> {
    let path = "stop.contact_share";
    if let Some(share) = rules.contact_share.filter(|share| *share > 1.0) {
        let what = format!("`contact_share` must lie between 0 and 100 %, found {} %", rounded(100.0 * share));
        return Err(source.error(path, what, "a corner never fills to the last: 95 % is a part that is formed"));
    }
    if rules.contact_share.is_some() && tools.iter().all(|tool| tool.role == Role::Holder) {
        let what = "`contact_share` asks for contact with a punch or a die, and there is none";
        return Err(source.error(path, what, "add [tools.die], or drop it"));
    }
    let opens = |die: &Tool| die.role == Role::Die && throat(die).is_some();
    if rules.drawn_through && !tools.iter().any(opens) {
        let what = "`drawn_through` asks for a cup that is pushed through the die, and no die is open";
        return Err(source.error("stop.drawn_through", what, "drop it, or give the die a throat"));
    }
    Ok(())
}

/// Frames closer than this share of the travel are one, and nearer than that no step is worth taking [–].
const SAME: f64 = 1e-9;
const CLOSEST: f64 = 1e-6;

/// Times at which the state is kept [s], rising, the last one the end of the run.
pub(super) fn frames(file: &file::Output, drive: &Drive, source: &Source) -> Result<Vec<f64>, CaseError> {
    let Drive { travel, duration, .. } = *drive;
    let Some(list) = &file.frames else {
        let n = count(source, "output.count", file.count.unwrap_or(4), 1..=1000)?;
        return Ok(equally_spaced(duration, n));
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
