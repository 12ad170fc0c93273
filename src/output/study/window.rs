//! Process windows: lines of equal thinning, the zones where designs fail, and the case with its distances to their borders.

use super::zones::{BORDER, OWN, entry, ground, lines};
use crate::plot::chart::{Chart, Color, Look, Panel, Scale, Series};
use crate::study::verify::Of;
use crate::study::{Found, Meets, Point, Results, Window, Zone};
use crate::table::capitalised;

/// Height of a window, and of one among others \[px\].
const HEIGHTS: [f64; 2] = [430.0, 270.0];
const LINE: Color = (70, 70, 70);
const ISOLINE: Look = Look::Line { color: LINE, width: 1.3, dash: &[] };
/// Lines of equal thinning, at most.
const LINES: f64 = 8.0;
/// Points along a line that its label is tried at, over its length.
const PLACES: [f64; 5] = [0.5, 0.35, 0.65, 0.2, 0.8];
/// Shorter lines, over the window, say nothing.
const SHORT: f64 = 0.12;
/// Paper around the outermost designs, over the window.
const PAPER: f64 = 0.025;
/// Labels are at least so far apart, over the window's width and height.
const APART: f64 = 0.14;
/// A zone has its name in it where so large a circle has room, over the window.
const ROOM: f64 = 0.09;

/// One window, or one for each value of a third axis.
pub(super) fn chart(results: &Results, windows: &[Window], title: String, notes: Vec<String>) -> Chart {
    let isolines = isolines_of(results);
    let zones: Vec<Zone> =
        Zone::ALL.into_iter().filter(|zone| results.rows.iter().any(|found| found.fails.contains(zone))).collect();
    let mut panels: Vec<Panel> =
        windows.iter().map(|window| panel(results, window, isolines.as_ref(), &zones)).collect();
    if let Some(first) = panels.first_mut() {
        first.series.extend(zones.iter().map(|zone| entry(*zone)));
        if let Some((place, _)) = &isolines {
            let number = results.number(*place);
            let label = format!("{} [{}]", String::from(number.label), number.amount.unit.symbol());
            first.series.push(Series::new(label, Vec::new(), ISOLINE));
        }
        if windows.iter().any(|window| window.own().is_some()) && windows.len() > 1 {
            let look = Look::Triangles { color: (0, 0, 0) };
            first.series.push(Series::new(capitalised(&String::from("the case as it stands")), Vec::new(), look));
        }
    }
    Chart { title, legend: String::new(), panels, notes }
}

/// The number whose lines are drawn, thinning where it changes, and its values, round ones.
fn isolines_of(results: &Results) -> Option<(usize, Vec<f64>)> {
    let deciding = results.deciding(usize::MAX);
    let thinning = results.place(Of::Verdict, "thinning").filter(|place| deciding.contains(place));
    let place = thinning.or(deciding.first().copied())?;
    // What tears first is not on the way to what is whole.
    let (low, high) = results.span(place, is_whole)?;
    let rough = (high - low) / LINES;
    let ten = 10_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|digit| digit * ten).find(|step| *step >= rough)?;
    let levels = ((low / step).ceil() as i64..=(high / step).floor() as i64).map(|n| n as f64 * step);
    Some((place, levels.collect()))
}

/// Whether a design came to its end in one piece.
fn is_whole(found: &Found) -> bool {
    found.is_known() && !found.red.iter().any(|row| ["stop", "localisation"].contains(&row.as_str()))
}

fn panel(results: &Results, window: &Window, isolines: Option<&(usize, Vec<f64>)>, zones: &[Zone]) -> Panel {
    let [x, y] = padded(window);
    let relative = |p: Point| ((p.0 - x.0) / (x.1 - x.0), (p.1 - y.0) / (y.1 - y.0));
    let mut series = Vec::new();
    let regions: Vec<(Zone, Vec<crate::study::Region>)> =
        zones.iter().map(|zone| (*zone, window.zone(*zone).0)).collect();
    for look in [ground, lines] {
        for (zone, regions) in &regions {
            let filled = regions.iter().filter(|region| !region.outlines.is_empty());
            series.extend(filled.map(|region| Series::silent(region.polygon(), look(*zone))));
        }
    }
    let mut taken: Vec<Point> = Vec::new();
    let own = window.own();
    taken.extend(own.map(relative));
    let own_series = own.map_or_else(Vec::new, |own| stands(results, window, own, window.at.is_some(), [x, y]));
    let named = own_series.iter().filter(|series| series.look == Look::Name);
    taken.extend(named.flat_map(|series| &series.points).map(|p| relative(*p)));
    if let Some(own) = own.filter(|_| window.at.is_none()) {
        let (at_x, at_y) = relative(beside(own, [x, y]));
        taken.extend([-0.13, 0.0, 0.13].map(|off| (at_x + off, at_y)));
    }
    let mut names = Vec::new();
    for (place, level) in isolines.iter().flat_map(|(place, levels)| levels.iter().map(move |level| (*place, *level))) {
        let found = window.isolines(place, level, is_whole);
        let long = |line: &&Vec<Point>| length(line.iter().map(|p| relative(*p))) > SHORT;
        let found: Vec<Vec<Point>> = found.iter().filter(long).cloned().collect();
        let longest = found.iter().max_by(|a, b| a.len().cmp(&b.len()));
        if let Some(at) = longest.and_then(|line| free(line, &taken, relative)) {
            taken.push(relative(at));
            let amount = results.number(place).amount.of(level).to(crate::units::Digits::Given(3));
            names.push(Series::new(amount.to_string(), vec![at], Look::Name));
        }
        series.extend(found.into_iter().map(|line| Series::silent(line, ISOLINE)));
    }
    for (_, regions) in &regions {
        let borders = regions.iter().flat_map(|region| region.borders.iter().cloned());
        series.extend(borders.map(|line| Series::silent(line, BORDER)));
    }
    series.extend(names);
    let is_small = window.at.is_some();
    if !is_small {
        let sound = (String::from("sound"), None);
        let failed = zones.iter().map(|zone| (zone.label().to_string(), Some(*zone)));
        for (name, zone) in std::iter::once(sound).chain(failed) {
            if let Some(at) = middle(window, |found| found.worst() == zone, relative, &taken) {
                taken.push(relative(at));
                series.push(Series::new(name, vec![at], Look::Name));
            }
        }
    }
    series.extend(own_series);
    let caption = window.at.map(|(third, place)| {
        let axis = &results.axes[third];
        let value = axis.told(axis.values[place]).to_string();
        Series::new(format!("{} {value}", String::from(axis.message())), Vec::new(), Look::Text)
    });
    series.extend(caption);
    let height = HEIGHTS[usize::from(is_small)];
    let scale = if is_small { Scale::Multiple { height, x, y } } else { Scale::Window { height, x, y } };
    let up = window.y.map_or(&results.axes[window.x], |y| &results.axes[y]);
    Panel { x: results.axes[window.x].axis(), y: up.axis(), series, scale }
}

/// The case, and the ways to the borders that it may meet.
fn stands(results: &Results, window: &Window, own: Point, is_small: bool, [x, y]: [(f64, f64); 2]) -> Vec<Series> {
    if is_small {
        return vec![Series::silent(vec![own], Look::Triangles { color: (0, 0, 0) })];
    }
    let mut series = Vec::new();
    for distance in window.distances().iter().filter(|distance| distance.meets != Meets::End) {
        let is_along = distance.axis == window.x;
        let place = results.axes[distance.axis].spacing.place(distance.to);
        let to = if is_along { (place, own.1) } else { (own.0, place) };
        series.push(Series::silent(vec![own, to], OWN));
        let by = results.axes[distance.axis].difference(distance.to - distance.from).to_string();
        let share = if is_along { (to.0 - own.0).abs() / (x.1 - x.0) } else { (to.1 - own.1).abs() / (y.1 - y.0) };
        if share > APART {
            let at = (0.5 * (own.0 + to.0), 0.5 * (own.1 + to.1));
            series.push(Series::new(by, vec![at], Look::Name));
        }
    }
    let label = capitalised(&String::from("the case as it stands"));
    series.push(Series::new(label, vec![own, beside(own, [x, y])], Look::Callout));
    series
}

/// Where the label of a point stands: away from the nearer edges.
fn beside(own: Point, [x, y]: [(f64, f64); 2]) -> Point {
    let off = |v: f64, (low, high): (f64, f64)| {
        let side = if v > 0.5 * (low + high) { -1.0 } else { 1.0 };
        v + side * 0.17 * (high - low)
    };
    (off(own.0, x), off(own.1, y))
}

/// Of a line over the window.
fn length(points: impl Iterator<Item = Point>) -> f64 {
    let points: Vec<Point> = points.collect();
    points.windows(2).map(|pair| (pair[0].0 - pair[1].0).hypot(pair[0].1 - pair[1].1)).sum()
}

/// The ranges of a window with a little paper around the outermost designs.
fn padded(window: &Window) -> [(f64, f64); 2] {
    window.ranges().map(|(low, high)| (low - PAPER * (high - low), high + PAPER * (high - low)))
}

/// A place along a line that is far from those that are taken.
fn free(line: &[Point], taken: &[Point], relative: impl Fn(Point) -> Point) -> Option<Point> {
    let is_free = |at: &Point| taken.iter().all(|other| is_apart(relative(*at), *other));
    let is_inside = |at: &Point| {
        let (x, y) = relative(*at);
        (0.06..0.94).contains(&x) && (0.04..0.96).contains(&y)
    };
    let places = PLACES.into_iter().map(|share| line[(share * (line.len() - 1) as f64) as usize]);
    places.filter(is_inside).find(is_free)
}

fn is_apart(a: Point, b: Point) -> bool {
    (a.0 - b.0).hypot(a.1 - b.1) > APART
}

/// The design that is furthest inside of those of a kind, where there is room for a name.
fn middle(
    window: &Window,
    is: impl Fn(&Found) -> bool,
    relative: impl Fn(Point) -> Point,
    taken: &[Point],
) -> Option<Point> {
    let (inside, outside): (Vec<_>, Vec<_>) = window.points().partition(|(_, found)| is(found));
    let far = |at: Point| {
        let (x, y) = relative(at);
        // The window's edges cut a name off, left and right more than above and below.
        let edge = (0.6 * x.min(1.0 - x)).min(y.min(1.0 - y));
        let others = outside.iter().map(|(other, _)| relative(*other)).chain(taken.iter().copied());
        others.map(|other| (x - other.0).hypot(y - other.1)).fold(edge, f64::min)
    };
    let best = inside.into_iter().map(|(at, _)| (at, far(at))).max_by(|a, b| a.1.total_cmp(&b.1));
    best.filter(|(_, room)| *room > ROOM).map(|(at, _)| at)
}
