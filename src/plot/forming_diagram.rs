//! Forming limit diagram: zones below and above the curve, and strain paths.

use super::*;
use crate::assess::CAREFUL;
use crate::forming_limit::{Assessment, Curve};
use crate::table::worded;

const PATH_POINTS: usize = 60;
const PATHS: usize = 24;
const HEIGHT: f64 = 450.0;
/// Space beside the points over their range, its least value \[–\], and space above over the height.
const AROUND: f64 = 0.25;
const LEAST_AROUND: f64 = 0.08;
const ABOVE: f64 = 0.12;
const FINE: usize = 200;
/// Zones, apart for colour-blind readers and in grey: the darker the worse.
const SAFE: Color = (232, 244, 248);
const MARGINAL: Color = (252, 226, 156);
const FAILED: Color = (231, 171, 143);
const NOT_JUDGED: Color = (226, 226, 226);
const LIMIT: Style = Style::Line { color: BLACK, width: 2.4, dash: &[] };
const AXIS: Style = Style::Line { color: GREY, width: 0.8, dash: &[2.5, 3.0] };
const PATH: Style = Style::Line { color: (210, 210, 210), width: 0.9, dash: &[] };

/// Diagram; `None` without a forming limit.
pub fn plot(view: &StageView) -> Option<Chart> {
    let assessment = view.forming_limit()?;
    let limit = view.model().forming_limit.as_ref()?;
    let mut panel = diagram(view, assessment, limit);
    if let (Scale::Window { x, y, .. }, true) = (&mut panel.scale, view.pictures.engineering_strain) {
        let points = panel.series.iter_mut().flat_map(|series| &mut series.points).chain([x, y]);
        points.for_each(|(a, b)| (*a, *b) = (a.exp_m1(), b.exp_m1()));
    }
    let states_sources = matches!(view.pictures.captions, Captions::Own | Captions::Full);
    let sources = limit.notes.iter().filter(|_| states_sources).map(ToString::to_string);
    Some(view.chart("forming limit diagram", vec![panel], std::iter::once(summary(view, assessment)).chain(sources)))
}

fn diagram(view: &StageView, assessment: &Assessment, limit: &Curve) -> Panel {
    let elements = &assessment.elements;
    let path = |e: usize| {
        let path = view.stage.paths.of(e);
        path.iter().rev().step_by(path.len().div_ceil(PATH_POINTS).max(1)).map(|p| (p[0], p[1])).collect::<Vec<_>>()
    };
    let (worst, every) = (worst(assessment), elements.len().div_ceil(PATHS).max(1));

    let (low, high) = bounds(elements.iter().map(|e| e.minor).chain([0.0]));
    let around = (AROUND * (high - low)).max(LEAST_AROUND);
    let left = low - around;
    let minor = |i: usize| left + (high + around - left) * i as f64 / FINE as f64;
    let curve: Vec<(f64, f64)> = (0..=FINE).map(|i| (minor(i), limit.major_at(minor(i)))).collect();
    let (least, largest) = bounds(elements.iter().map(|e| e.major).chain(curve.iter().map(|p| p.1)).chain([0.0]));
    let top = (1.0 + ABOVE) * largest;
    // The minor strain is not the larger one: zones and curve end where both are equal.
    let right = (high + around).min(top);

    let zone = |label: &str, outline, fill| Series::new(label, outline, Style::area(fill));
    let below = |share: f64| {
        let mut outline: Vec<_> = curve.iter().map(|p| (p.0, share * p.1)).filter(|p| p.0 <= p.1).collect();
        let last: (f64, f64) = outline.last().copied().unwrap_or_default();
        outline.extend([(last.0, last.0.min(last.1)), (least, least), (left, least)]);
        outline
    };
    let mut series = vec![
        zone("Failed", vec![(left, top), (right, top), (right, right), (least, least), (left, least)], FAILED),
        zone(&format!("Marginal, above {} of the limit", percent(CAREFUL)), below(1.0), MARGINAL),
        zone("Safe", below(CAREFUL), SAFE),
    ];
    series.extend(limit.ends_at().map(|end| {
        let level = limit.major_at(end);
        let beyond = [(end, level), (right.min(level), level), (right, level.max(right)), (right, top), (end, top)];
        zone("Not judged: the limit has ended", beyond.to_vec(), NOT_JUDGED)
    }));
    series.push(Series::silent(vec![(0.0, least), (0.0, top)], AXIS));
    series.extend((0..elements.len()).step_by(every).map(|e| Series::silent(path(e), PATH)));
    let hoop = ["along the meridian", "along the hoop"];
    let [along, across] = worded(view.model().geometry, hoop, ["in the plane", "out of the plane"]);
    let (dots, triangles) = (Style::Dots { color: color(0) }, Style::Triangles { color: color(2) });
    for (direction, is_hoop, style) in [(along, false, dots), (across, true, triangles)] {
        let those = elements.iter().filter(|element| element.hoop_is_major == is_hoop);
        let those: Vec<_> = those.map(|element| (element.minor, element.major)).collect();
        series.extend((!those.is_empty()).then(|| Series::new(format!("Major strain {direction}"), those, style)));
    }
    let drawn = curve.iter().copied().filter(|p| p.0 <= p.1 && limit.knows(p.0)).collect();
    series.push(Series::new(format!("Limit: {}", limit.name), drawn, LIMIT));
    let worst_path = path(worst);
    let end = worst_path.first().copied().into_iter().collect();
    series.push(Series::silent(worst_path, Style::solid(color(1), 2.2)));
    let nearest = format!("Nearest to the limit, {} of it", percent(elements[worst].ratio()));
    let nearest = if elements[worst].is_open() { "Most strained beyond the end of the limit" } else { &nearest };
    let label = format!("{nearest}, s0 = {}", Amount::place(elements[worst].s0));
    series.push(Series::new(label, end, Style::Circles { color: color(1) }));
    let measure = if view.pictures.engineering_strain { "engineering" } else { "true" };
    let [x, y] = ["Minor", "Major"].map(|of| Axis::named(format!("{of} {measure} strain, mid-surface"), Unit::None));
    Panel::new(x, y, Scale::Window { height: HEIGHT, x: (left, right), y: (least, top) }).with(series)
}

fn percent(share: f64) -> Amount {
    Amount::share(share).to(Digits::Decimals(0))
}

fn worst(assessment: &Assessment) -> usize {
    let worst = assessment.open().filter(|_| assessment.reached.is_none()).unwrap_or_else(|| assessment.worst());
    assessment.elements.iter().position(|element| element == worst).unwrap_or(0)
}

fn summary(view: &StageView, assessment: &Assessment) -> String {
    let mut text = match &assessment.reached {
        Some(reached) => {
            let (s0, travel) = (Amount::place(reached.s0), Amount::place(reached.travel).to(Digits::Decimals(2)));
            let time = if view.model().timed { format!(" ({})", Amount::time(reached.time)) } else { String::new() };
            format!("The limit is reached at s0 = {s0}, at {travel} of travel{time}.")
        }
        None if assessment.open().is_some() => {
            "The limit ends in plane strain, and places beyond its end are not judged.".to_owned()
        }
        None if assessment.elements.iter().any(|element| element.of_edge && element.margin() < 0.0) => {
            "Beyond the limit is only the edge, which has one of its own.".to_owned()
        }
        None => "The limit is not reached.".to_owned(),
    };
    let worst = assessment.worst();
    if !worst.is_open() {
        let margin = Amount::ratio(worst.margin()).to(Digits::Decimals(3));
        text += &format!(" Least margin in major strain {margin} at s0 = {}.", Amount::place(worst.s0));
    }
    text
}
