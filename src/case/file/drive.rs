//! Drive and duration of the run, its kept instants, `[solver]` and `[stop]`; limits on the size of a case.

use super::*;
use crate::forming_limit::Paths;
use crate::model::{Stage, tool_sizes::throat};
use crate::solver::solution::{ElementRecord, NodeRecord, PointRecord, StepRecord};
use crate::solver::state::MaterialPoint;

/// Distance of frames over the travel below which they are one \[–\].
const SAME: f64 = 1e-9;
/// Least distance of frames over the travel, and of points of a history over the whole \[–\].
const CLOSEST: f64 = 1e-6;

/// Kept instants: `frames` or `count`; the end of the travel always is.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Punch travels at which the state is kept.
    frames: Option<Vec<Positive<Length>>>,
    /// Number of equally spaced instants, 1 to 1000; default 4.
    #[schemars(range(min = 1, max = 1000))]
    count: Option<i64>,
}

/// Travel \[mm\], its history, speed \[mm/s\] and duration \[s\], as in [`crate::model::Model`].
pub struct Drive {
    pub travel: f64,
    pub schedule: Option<PiecewiseLinear>,
    pub speed: f64,
    pub duration: f64,
    /// True if the case gives a speed, a motion or a duration.
    pub timed: bool,
}

impl Drive {
    pub fn of(schedule: PiecewiseLinear) -> Self {
        let &(duration, travel) = schedule.points().last().expect("a history has points");
        Self { travel, schedule: Some(schedule), speed: travel / duration, duration, timed: true }
    }

    /// Time at a punch travel \[s\].
    pub fn time_at(&self, travel: f64) -> f64 {
        self.schedule.as_ref().map_or(travel / self.speed, |schedule| schedule.reaches(travel))
    }
}

pub fn travel_key(source: &Source) -> &'static str {
    if source.has("tools.punch.motion") { "tools.punch.motion" } else { "tools.punch.travel" }
}

impl CaseFile {
    pub fn drive(&self, length: f64, source: &Source) -> Result<Drive> {
        if let Some(feed) = &self.blank.feed {
            let what = "the edge is fed and a punch drives";
            source.require(self.tools.punch.is_none(), "blank.feed", what, "keep one")?;
            let help = "drop it: the feed says how long it takes";
            source.refuse("gas", &["duration"], "and a feed are both given", help)?;
            return driven_by(feed, "blank.feed", source);
        }
        let Some(punch) = &self.tools.punch else {
            let gas = self.gas.as_ref().ok_or_else(|| source.missing("tools", "punch"))?;
            let duration = gas.duration.ok_or_else(|| source.missing("gas", "duration"))?.value();
            return Ok(Drive { travel: 0.0, schedule: None, speed: length / duration, duration, timed: true });
        };
        let help = "drop it: the punch's travel and speed say how long the run takes";
        source.refuse("gas", &["duration"], "and a punch are both given", help)?;
        let Some(points) = &punch.motion else {
            let travel = punch.travel.ok_or_else(|| source.missing("tools.punch", "travel"))?.value();
            let stroke = judged::stroke_of(self.press_drive(source)?.as_ref(), travel, source)?;
            if let Some(schedule) = stroke.filter(|_| punch.speed.is_none()) {
                return Ok(Drive::of(schedule));
            }
            let (speed, timed) = (punch.speed.map_or(1.0, Dimensioned::value), punch.speed.is_some());
            return Ok(Drive { travel, schedule: None, speed, duration: travel / speed, timed });
        };
        let help = "drop it: the motion says travel and speed";
        source.refuse("tools.punch", &["speed", "travel"], "and `motion` are both given", help)?;
        driven_by(points, "tools.punch.motion", source)
    }
}

fn driven_by(points: &[(NonNegative<Time>, NonNegative<Length>)], path: &str, source: &Source) -> Result<Drive> {
    let key = path.rsplit('.').next().unwrap_or(path);
    let points: Vec<(f64, f64)> = points.iter().map(|(time, travel)| (time.value(), travel.value())).collect();
    let [first, .., last] = points.as_slice() else {
        let what = format!("`{key}` needs at least two points, found {}", points.len());
        return Err(source.error(path, what, "write [[\"0 s\", \"0 mm\"], [\"5 s\", \"20 mm\"]], or travel and speed"));
    };
    let what = format!("`{key}` must begin with 0 mm at 0 s, found {} mm at {} s", rounded(first.1), rounded(first.0));
    let help = "the punch begins where it touches the flat sheet";
    source.require(*first == (0.0, 0.0), &format!("{path}.0"), what, help)?;
    for (i, w) in points.windows(2).enumerate() {
        for (unit, from, to, whole) in [("s", w[0].0, w[1].0, last.0), ("mm", w[0].1, w[1].1, last.1)] {
            let (before, after) = (rounded(from), rounded(to));
            let what = format!("`{key}` must rise by a millionth or more, found {after} {unit} after {before} {unit}");
            let help = "the punch neither rests nor returns: sort the points, and let it move from each to the next";
            source.require(to - from >= CLOSEST * whole && to > from, &format!("{path}.{}", i + 1), what, help)?;
        }
    }
    Ok(Drive::of(PiecewiseLinear::new(points).expect("checked above")))
}

pub fn check_settings(settings: &Settings, source: &Source) -> Result<()> {
    let Err(error) = settings.check() else { return Ok(()) };
    let key = error.what.trim_start_matches("settings.");
    if key == "first_step" {
        let Settings { min_step, first_step, max_step, .. } = settings;
        let given = source.written("solver", &["first_step", "max_step", "min_step"]);
        let path = format!("solver.{}", given.first().unwrap_or(&key));
        let what = format!("steps go min_step <= first_step <= max_step, found {min_step}, {first_step}, {max_step}");
        return Err(source.error(&path, what, "they are fractions of the travel"));
    }
    let help = match error.nearest {
        Some(nearest) => format!("the nearest that can be solved: {key} = {nearest}"),
        None => "leave it out: the default serves every case".to_owned(),
    };
    Err(source.error(&format!("solver.{key}"), error.to_string().replace("settings.", ""), help))
}

pub fn check_stop(rules: &StopRules, tools: &[Tool], source: &Source) -> Result<()> {
    let path = "stop.contact_share";
    let share = rules.contact_share.unwrap_or(0.0);
    let what = format!("`contact_share` must lie between 0 and 100 %, found {} %", rounded(100.0 * share));
    source.require(share <= 1.0, path, what, "a corner never fills to the last: 95 % is a part that is formed")?;
    let touched = rules.contact_share.is_none() || tools.iter().any(|tool| tool.role != Role::Holder);
    let what = "`contact_share` asks for contact with a punch or a die, and there is none";
    source.require(touched, path, what, "add [tools.die], or drop it")?;
    let opens = tools.iter().any(|die| die.role == Role::Die && throat(die).is_some());
    let what = "`drawn_through` asks for a cup that is pushed through the die, and no die is open";
    source.require(!rules.drawn_through || opens, "stop.drawn_through", what, "drop it, or give the die a throat")
}

impl Output {
    /// Times at which the state is kept \[s\], rising, the last one the end of the run.
    pub fn frames(&self, drive: &Drive, source: &Source) -> Result<Vec<f64>> {
        let Drive { travel, duration, .. } = *drive;
        let Some(list) = &self.frames else {
            return Ok(equally_spaced(duration, count(source, "output.count", self.count.unwrap_or(4), 1..=1000)?));
        };
        source.one_of("output", &["frames", "count"], "keep one of them")?;
        let what = "`frames` are punch travels, and there is no punch";
        source.require(travel > 0.0, "output.frames", what, "write count = 8 for as many instants, equally spaced")?;
        let mut frames: Vec<f64> = list.iter().map(|f| f.value()).collect();
        for (i, frame) in frames.iter().enumerate() {
            let what = format!("a frame at {} mm lies beyond the travel of {} mm", rounded(*frame), rounded(travel));
            let help = "drop it, or lengthen tools.punch.travel";
            source.require(*frame <= travel * (1.0 + SAME), &format!("output.frames.{i}"), what, help)?;
        }
        frames.retain(|&f| f < travel * (1.0 - SAME));
        frames.sort_by(f64::total_cmp);
        frames.dedup_by(|later, earlier| *later - *earlier < SAME * travel);
        for (before, frame) in [0.0].iter().chain(&frames).zip(&frames) {
            let (last, next) = (rounded(*before), rounded(*frame));
            let what = format!("frames at {last} and {next} mm are closer than a millionth of the travel");
            let help = "keep one of them; the flat sheet at 0 mm is none";
            source.require(frame - before >= CLOSEST * travel, "output.frames", what, help)?;
        }
        Ok(frames.into_iter().map(|f| drive.time_at(f)).chain([duration]).collect())
    }
}

/// Instants of a run \[s\], the last one its end.
pub fn equally_spaced(duration: f64, count: usize) -> Vec<f64> {
    (1..count).map(|i| duration * i as f64 / count as f64).chain([duration]).collect()
}

/// Most rows of `profile.csv`: kept frames times elements.
const ROWS: usize = 500_000;
/// Memory of a run, all stages together \[bytes\]: ten stages with 1000 frames of 340 elements.
const MEMORY: usize = 500_000_000;

/// Key that gives the number of kept frames of a stage, the first one being stage 0.
pub fn frames_key(stage: usize, source: &Source) -> String {
    match stage {
        0 if source.has("output.frames") => "output.frames".into(),
        0 => "output.count".into(),
        later => format!("stages.{}.frames", later - 1),
    }
}

pub fn of_stages(stages: &[Stage], source: &Source) -> Result<()> {
    let (mut total, mut largest) = (0, (0, String::new(), ""));
    for (i, Stage { model, .. }) in stages.iter().enumerate() {
        let (frames, elements, points) = (model.frames.len(), model.blank.elements, model.blank.layers);
        // Every frame is landed on, and no step is longer than the longest.
        let steps = frames.max((1.0 / model.settings.max_step).round() as usize);
        let with_path = if model.forming_limit.is_some() { elements } else { 0 };
        let of_points = elements * points * (2 * size_of::<PointRecord>() + size_of::<MaterialPoint>());
        let of_frames = frames * elements * (size_of::<ElementRecord>() + size_of::<NodeRecord>()) + of_points;
        let of_steps = steps * size_of::<StepRecord>() + steps.min(Paths::MOST) * with_path * size_of::<[f64; 2]>();
        total += of_frames + of_steps;
        let of_frames = (of_frames, frames_key(i, source), "keep fewer frames, or fewer elements");
        let of_steps = (of_steps, "solver.max_step".into(), "take longer steps, or fewer elements");
        largest = [of_frames, of_steps].into_iter().fold(largest, |a, b| if b.0 > a.0 { b } else { a });
    }
    let [gigabytes, most] = [total, MEMORY].map(|bytes| bytes as f64 / 1e9);
    let what = format!("the stages ({}) fill {gigabytes:.2} GB, more than {most:.2} GB", stages.len());
    source.require(total <= MEMORY, &largest.1, what, largest.2)
}

pub fn of_model(model: &Model, frames_key: &str, source: &Source) -> Result<()> {
    let (frames, elements) = (model.frames.len(), model.blank.elements);
    let rows = frames * elements;
    let what = format!("{frames} frames of {elements} elements are {rows} rows, more than {ROWS}");
    source.require(rows <= ROWS, frames_key, what, format!("keep at most {} frames", ROWS / elements))
}
