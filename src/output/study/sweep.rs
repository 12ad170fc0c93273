//! The pictures of a sweep, chosen by what is varied.

use super::{curves, tornado, window};
use crate::results::Chart;
use crate::study::{How, Results, Said, Zone, windows};
use crate::units::joined;

/// Each picture by the stem of its file: curves over one axis, a process window over two, one for each value of a third, a
/// tornado of keys that are changed one at a time; none of more axes.
pub fn pictures(results: &Results, name: &str) -> Vec<(&'static str, Chart)> {
    let windows = windows(results);
    let wide = results.wide();
    let axes = wide.iter().map(|axis| results.axes[*axis].message());
    let title = |what: String| format!("{name}: {}", what.to_string());
    let made = match (results.plan.how(), windows.as_slice()) {
        (How::OneAtATime, _) => {
            let title = title("what moves it most, one key at a time".into());
            ("tornado", tornado::chart(results, title, with(results)))
        }
        (How::Combined, [one]) if one.y.is_none() => {
            let title = title(joined(axes, ""));
            ("curves", curves::chart(results, one, title, notes(results)))
        }
        (How::Combined, [_]) => {
            let title = title(format!("process window, {axes}", axes = joined(axes, " × ")));
            ("window", window::chart(results, &windows, title, notes(results)))
        }
        (How::Combined, [_, ..]) => {
            let title = title(format!("process windows, {axes}", axes = joined(axes, " × ")));
            ("windows", window::chart(results, &windows, title, notes(results)))
        }
        (How::Combined, []) => return Vec::new(),
    };
    vec![(made.0, made.1.displayed())]
}

/// What stands below: how far the case is from the borders, and how borders were found.
fn notes(results: &Results) -> Vec<String> {
    let said = Said::of(results);
    let distances = said.distances.iter().map(|distance| distance.told(results).to_string() + ".");
    let distances: Vec<String> = distances.collect();
    let mut notes: Vec<String> = if distances.is_empty() { Vec::new() } else { vec![distances.join(" ")] };
    let met = Zone::ALL.into_iter().filter(|zone| results.rows.iter().any(|found| found.fails.contains(zone)));
    let (by_numbers, half_way): (Vec<Zone>, Vec<Zone>) =
        met.partition(|zone| windows(results).iter().all(|window| window.zone(*zone).1));
    let listed = |zones: Vec<Zone>| joined(zones.into_iter().map(|zone| zone.label().to_owned()), ", ");
    if !by_numbers.is_empty() {
        let zones = listed(by_numbers);
        notes.push(format!("Borders between designs where their number passes its limit: {zones}."));
    }
    if !half_way.is_empty() {
        let zones = listed(half_way);
        notes.push(format!("Borders half-way between designs where no number passes a limit: {zones}."));
    }
    notes.extend(with(results));
    notes
}

/// Keys that go together with others.
fn with(results: &Results) -> Vec<String> {
    let together = results.axes.iter().filter(|axis| !axis.with.is_empty());
    let told = together
        .map(|axis| format!("{key} goes together with {others}.", key = axis.message(), others = axis.with.join(", ")));
    told.collect()
}
