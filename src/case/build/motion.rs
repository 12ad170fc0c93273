//! Drive and duration of the run: the punch at its speed or along its history, or gas alone.

use crate::case::file::CaseFile;
use crate::case::{CaseError, source::Source};
use crate::numerics::PiecewiseLinear;
use crate::units::{Dimensioned, Length, NonNegative, Time, rounded};

/// Least rise between points of a history over the whole \[–\].
const CLOSEST: f64 = 1e-6;

/// Travel \[mm\], its history, speed \[mm/s\] and duration \[s\], as in [`crate::model::Model`].
pub(super) struct Drive {
    pub travel: f64,
    pub schedule: Option<PiecewiseLinear>,
    pub speed: f64,
    pub duration: f64,
    /// True if the case gives a speed, a motion or a duration.
    pub timed: bool,
}

impl Drive {
    /// Time at a punch travel \[s\].
    pub fn time_at(&self, travel: f64) -> f64 {
        self.schedule.as_ref().map_or(travel / self.speed, |schedule| schedule.reaches(travel))
    }
}

/// Key that gives the punch travel.
pub(super) fn travel_key(source: &Source) -> &'static str {
    if source.has("tools.punch.motion") { "tools.punch.motion" } else { "tools.punch.travel" }
}

/// Punch travel at its speed or along its history, or the gas for its duration.
pub(super) fn drive(file: &CaseFile, length: f64, source: &Source) -> Result<Drive, CaseError> {
    let Some(punch) = &file.tools.punch else {
        let gas = file.gas.as_ref().ok_or_else(|| source.missing("tools", "punch"))?;
        let duration = gas.duration.ok_or_else(|| source.missing("gas", "duration"))?.value();
        return Ok(Drive { travel: 0.0, schedule: None, speed: length / duration, duration, timed: true });
    };
    let help = "drop it: the punch's travel and speed say how long the run takes";
    source.refuse("gas", &["duration"], "and a punch are both given", help)?;
    let Some(points) = &punch.motion else {
        let travel = punch.travel.ok_or_else(|| source.missing("tools.punch", "travel"))?.value();
        let (speed, timed) = (punch.speed.map_or(1.0, Dimensioned::value), punch.speed.is_some());
        return Ok(Drive { travel, schedule: None, speed, duration: travel / speed, timed });
    };
    let help = "drop it: the motion says travel and speed";
    source.refuse("tools.punch", &["speed", "travel"], "and `motion` are both given", help)?;
    let schedule = history(points, source)?;
    let &(duration, travel) = schedule.points().last().expect("a history has points");
    Ok(Drive { travel, schedule: Some(schedule), speed: travel / duration, duration, timed: true })
}

/// Travel over time, checked point by point.
fn history(points: &[(NonNegative<Time>, NonNegative<Length>)], source: &Source) -> Result<PiecewiseLinear, CaseError> {
    const PATH: &str = "tools.punch.motion";
    let points: Vec<(f64, f64)> = points.iter().map(|(time, travel)| (time.value(), travel.value())).collect();
    let [first, .., last] = points.as_slice() else {
        let what = format!("`motion` needs at least two points, found {}", points.len());
        return Err(source.error(PATH, what, "write [[\"0 s\", \"0 mm\"], [\"5 s\", \"20 mm\"]], or travel and speed"));
    };
    let what = format!("`motion` must begin with 0 mm at 0 s, found {} mm at {} s", rounded(first.1), rounded(first.0));
    let help = "the punch begins where it touches the flat sheet";
    source.require(*first == (0.0, 0.0), &format!("{PATH}.0"), what, help)?;
    for (i, w) in points.windows(2).enumerate() {
        for (unit, from, to, whole) in [("s", w[0].0, w[1].0, last.0), ("mm", w[0].1, w[1].1, last.1)] {
            let (before, after) = (rounded(from), rounded(to));
            let what = format!(
                "`motion` must rise by a millionth of the whole or more, found {after} {unit} after {before} {unit}"
            );
            let help = "the punch neither rests nor returns: sort the points, and let it move from each to the next";
            source.require(to - from >= CLOSEST * whole && to > from, &format!("{PATH}.{}", i + 1), what, help)?;
        }
    }
    Ok(PiecewiseLinear::new(points).expect("checked above"))
}
