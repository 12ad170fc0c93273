//! `[solver]`, `[stop]` and `[output]`.

use super::motion::Drive;
use super::stages::equally_spaced;
use super::values::count;
use crate::case::file;
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::throat;
use crate::model::{Role, Settings, StopRules, Tool};
use crate::units::{Dimensioned, rounded};

/// Distance over the travel below which frames are one, and below which they are an error \[–\].
const SAME: f64 = 1e-9;
const CLOSEST: f64 = 1e-6;

pub(super) fn check(settings: &Settings, source: &Source) -> Result<(), CaseError> {
    let Err(error) = settings.check() else { return Ok(()) };
    let key = error.what.trim_start_matches("settings.");
    if key == "first_step" {
        let Settings { min_step, first_step, max_step, .. } = settings;
        let given = source.written("solver", &["first_step", "max_step", "min_step"]);
        let path = format!("solver.{}", given.first().unwrap_or(&key));
        let what = format!(
            "steps must satisfy min_step <= first_step <= max_step, found {min_step}, {first_step}, {max_step}"
        );
        return Err(source.error(&path, what, "they are fractions of the travel"));
    }
    let help = match error.nearest {
        Some(nearest) => format!("the nearest that can be solved: {key} = {nearest}"),
        None => "leave it out: the default serves every case".to_owned(),
    };
    Err(source.error(&format!("solver.{key}"), error.to_string().replace("settings.", ""), help))
}

/// Conditions that end a run before its full travel.
pub(super) fn stop(rules: &StopRules, tools: &[Tool], source: &Source) -> Result<(), CaseError> {
    let path = "stop.contact_share";
    let share = rules.contact_share.unwrap_or(0.0);
    let what = format!("`contact_share` must lie between 0 and 100 %, found {} %", rounded(100.0 * share));
    source.require(share <= 1.0, path, what, "a corner never fills to the last: 95 % is a part that is formed")?;
    let touched = rules.contact_share.is_none() || tools.iter().any(|tool| tool.role != Role::Holder);
    let what = "`contact_share` asks for contact with a punch or a die, and there is none";
    source.require(touched, path, what, "add [tools.die], or drop it")?;
    let opens = tools.iter().any(|die| die.role == Role::Die && throat(die).is_some());
    let what = "`drawn_through` asks for a cup that is pushed through the die, and no die is open";
    let help = "drop it, or give the die a throat";
    source.require(!rules.drawn_through || opens, "stop.drawn_through", what, help)
}

/// Times at which the state is kept \[s\], rising, the last one the end of the run.
pub(super) fn frames(file: &file::Output, drive: &Drive, source: &Source) -> Result<Vec<f64>, CaseError> {
    let Drive { travel, duration, .. } = *drive;
    let Some(list) = &file.frames else {
        let n = count(source, "output.count", file.count.unwrap_or(4), 1..=1000)?;
        return Ok(equally_spaced(duration, n));
    };
    source.one_of("output", &["frames", "count"], "keep one of them")?;
    let what = "`frames` are punch travels, and there is no punch";
    let help = "write count = 8 for as many instants, equally spaced";
    source.require(travel > 0.0, "output.frames", what, help)?;
    let mut frames: Vec<f64> = list.iter().map(|f| f.value()).collect();
    for (i, frame) in frames.iter().enumerate() {
        let what = format!("a frame at {} mm lies beyond the travel of {} mm", rounded(*frame), rounded(travel));
        let help = "drop it, or lengthen tools.punch.travel";
        source.require(*frame <= travel * (1.0 + SAME), &format!("output.frames.{i}"), what, help)?;
    }
    frames.retain(|&f| f < travel * (1.0 - SAME));
    frames.sort_by(f64::total_cmp);
    frames.dedup_by(|later, earlier| *later - *earlier < SAME * travel);
    let mut before = 0.0;
    for &frame in &frames {
        let (last, next) = (rounded(before), rounded(frame));
        let what = format!("frames at {last} and {next} mm are closer than a millionth of the travel");
        let help = "keep one of them; the flat sheet at 0 mm is none";
        source.require(frame - before >= CLOSEST * travel, "output.frames", what, help)?;
        before = frame;
    }
    Ok(frames.into_iter().map(|f| drive.time_at(f)).chain([duration]).collect())
}
