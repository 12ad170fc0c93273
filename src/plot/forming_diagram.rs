//! Forming limit diagram: zones below and above the curve, and strain paths. A strip's places all have plane strain: the
//! major strain is drawn over the blank instead.

use super::chart::{Chart, Color, Panel, Scale, Series, Style, bounds};
use super::palette::{BLACK, GREY, color};
use super::{Captions, StageView};
use crate::assess::CAREFUL;
use crate::forming_limit::{Assessment, Curve, Judged};
use crate::model::Geometry;
use crate::plot::Axis;
use crate::plot::fields::element::S0;
use crate::table::Unit;
use crate::units::{Amount, Digits};

/// Points of a drawn path, and number of paths beside that of the least margin.
const PATH_POINTS: usize = 60;
const PATHS: usize = 24;
/// Heights of the diagram and of the strip's \[px\].
const HEIGHT: f64 = 450.0;
const STRIP_HEIGHT: f64 = 350.0;
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
    let (subject, mut panel) = match view.model().geometry {
        Geometry::Axisymmetric => ("forming limit diagram", diagram(view, assessment, limit)),
        Geometry::PlaneStrain => ("major strain and forming limit", strip(view, assessment, limit)),
    };
    if view.pictures.engineering_strain {
        let is_round = view.model().geometry == Geometry::Axisymmetric;
        let Scale::Window { x, y, .. } = &mut panel.scale else { return None };
        let points = panel.series.iter_mut().flat_map(|series| &mut series.points);
        let (minor, major) = points.map(|point| (&mut point.0, &mut point.1)).unzip::<_, _, Vec<_>, Vec<_>>();
        major.into_iter().chain([&mut y.0, &mut y.1]).for_each(|strain| *strain = strain.exp_m1());
        let minor = minor.into_iter().chain([&mut x.0, &mut x.1]).filter(|_| is_round);
        minor.for_each(|strain| *strain = strain.exp_m1());
    }
    let states_sources = matches!(view.pictures.captions, Captions::Own | Captions::Full);
    let sources = limit.notes.iter().filter(|_| states_sources).map(ToString::to_string);
    Some(view.chart(subject, vec![panel], std::iter::once(summary(view, assessment)).chain(sources)))
}

/// Axes of minor and major strain, engineering or logarithmic.
pub(super) fn strain_axes(is_engineering: bool) -> [Axis; 2] {
    let measure = if is_engineering { "engineering" } else { "true" };
    ["Minor", "Major"].map(|which| Axis::named(format!("{which} {measure} strain, mid-surface"), Unit::None))
}

fn zone(label: &str, outline: &[[f64; 2]], fill: Color) -> Series {
    Series::new(label, points(outline), Style::area(fill))
}

/// Zones above the limit, and below shares of it.
fn zones(all: &[[f64; 2]], below: impl Fn(f64) -> Vec<[f64; 2]>) -> [Series; 3] {
    let marginal = format!("Marginal, above {} of the limit", percent(CAREFUL));
    [zone("Failed", all, FAILED), zone(&marginal, &below(1.0), MARGINAL), zone("Safe", &below(CAREFUL), SAFE)]
}

fn points(of: &[[f64; 2]]) -> Vec<(f64, f64)> {
    of.iter().map(|p| (p[0], p[1])).collect()
}

/// Minor and major logarithmic strain of every place, with the paths of some.
fn diagram(view: &StageView, assessment: &Assessment, limit: &Curve) -> Panel {
    let elements = &assessment.elements;
    let path = |e: usize| {
        let path = view.stage.paths.of(e);
        let every = path.len().div_ceil(PATH_POINTS).max(1);
        path.iter().rev().step_by(every).map(|p| (p[0], p[1])).collect::<Vec<_>>()
    };
    let (worst, every) = (worst(assessment), elements.len().div_ceil(PATHS).max(1));

    let (low, high) = bounds(elements.iter().map(|e| e.minor).chain([0.0]));
    let around = (AROUND * (high - low)).max(LEAST_AROUND);
    let left = low - around;
    let minor = |i: usize| left + (high + around - left) * i as f64 / FINE as f64;
    let curve: Vec<[f64; 2]> = (0..=FINE).map(|i| [minor(i), limit.major_at(minor(i))]).collect();
    let majors = elements.iter().map(|e| e.major);
    let (least, largest) = bounds(majors.chain(curve.iter().map(|p| p[1])).chain([0.0]));
    let top = (1.0 + ABOVE) * largest;
    // The minor strain is not the larger one: zones and curve end where both are equal.
    let right = (high + around).min(top);

    let below = |share: f64| {
        let mut outline: Vec<[f64; 2]> = curve.iter().map(|p| [p[0], share * p[1]]).filter(|p| p[0] <= p[1]).collect();
        let last = outline.last().copied().unwrap_or_default();
        outline.extend([[last[0], last[0].min(last[1])], [least, least], [left, least]]);
        outline
    };
    let all = [[left, top], [right, top], [right, right], [least, least], [left, least]];
    let mut series = zones(&all, below).to_vec();
    series.extend(limit.ends_at().map(|end| {
        let level = limit.major_at(end);
        let beyond = [[end, level], [right.min(level), level], [right, level.max(right)], [right, top], [end, top]];
        zone("Not judged: the limit has ended", &beyond, NOT_JUDGED)
    }));
    series.push(Series::silent(vec![(0.0, least), (0.0, top)], AXIS));
    series.extend((0..elements.len()).step_by(every).map(|e| Series::silent(path(e), PATH)));
    for (label, is_hoop, style) in [
        ("Major strain along the meridian", false, Style::Dots { color: color(0) }),
        ("Major strain along the hoop", true, Style::Triangles { color: color(2) }),
    ] {
        let those = elements.iter().filter(|element| element.hoop_is_major == is_hoop);
        let those: Vec<_> = those.map(|element| (element.minor, element.major)).collect();
        series.extend((!those.is_empty()).then(|| Series::new(label, those, style)));
    }
    let drawn: Vec<[f64; 2]> = curve.into_iter().filter(|p| p[0] <= p[1] && limit.knows(p[0])).collect();
    series.push(Series::new(limit_label(limit), points(&drawn), LIMIT));
    let worst_path = path(worst);
    let end = worst_path.first().copied().into_iter().collect();
    series.push(Series::silent(worst_path, Style::solid(color(1), 2.2)));
    series.push(Series::new(worst_label(&elements[worst]), end, Style::Circles { color: color(1) }));
    let [x, y] = strain_axes(view.pictures.engineering_strain);
    Panel::new(x, y, Scale::Window { height: HEIGHT, x: (left, right), y: (least, top) }).with(series)
}

/// Major logarithmic strain over the strip, below its limit.
fn strip(view: &StageView, assessment: &Assessment, limit: &Curve) -> Panel {
    let elements = &assessment.elements;
    let length = view.model().blank.length;
    let over = |value: &dyn Fn(&Judged) -> f64| -> Vec<(f64, f64)> {
        let ends = elements.first().map(|first| (0.0, value(first)));
        let last = elements.last().map(|last| (length, value(last)));
        ends.into_iter().chain(elements.iter().map(|element| (element.s0, value(element)))).chain(last).collect()
    };
    let (low, _) = bounds(elements.iter().map(|e| e.major).chain([0.0]));
    let high = bounds(elements.iter().map(|e| e.limit.max(e.major)).chain([0.0])).1 * (1.0 + ABOVE);
    let all = [[0.0, high], [length, high], [length, low], [0.0, low]];
    let below = |share: f64| {
        let line = over(&|e| share * e.limit).into_iter().map(|(x, y)| [x, y]);
        line.chain([[length, low], [0.0, low]]).collect::<Vec<_>>()
    };
    let worst = &elements[worst(assessment)];
    let scale = Scale::Window { height: STRIP_HEIGHT, x: (0.0, length), y: (low, high) };
    let [_, y] = strain_axes(view.pictures.engineering_strain);
    Panel::new(S0.axis(view.extent()), y, scale).with(zones(&all, below)).with([
        Series::new(limit_label(limit), over(&|e| e.limit), LIMIT),
        Series::new("Major strain", over(&|e| e.major), Style::curve(0)),
        Series::new(worst_label(worst), vec![(worst.s0, worst.major)], Style::Circles { color: color(1) }),
    ])
}

fn worst_label(worst: &Judged) -> String {
    let s0 = Amount::place(worst.s0);
    if worst.is_open() {
        return format!("Most strained beyond the end of the limit, s0 = {s0}");
    }
    format!("Nearest to the limit, {} of it, s0 = {s0}", percent(worst.ratio()))
}

fn limit_label(limit: &Curve) -> String {
    format!("Limit: {}", limit.name)
}

fn percent(share: f64) -> Amount {
    Amount::share(share).to(Digits::Decimals(0))
}

/// Element with the least margin, or the one strained most beyond the end of the curve if none has reached it.
fn worst(assessment: &Assessment) -> usize {
    let open = assessment.open().filter(|_| assessment.reached.is_none());
    let worst = open.unwrap_or_else(|| assessment.worst());
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
        None => "The limit is not reached.".to_owned(),
    };
    let worst = assessment.worst();
    if !worst.is_open() {
        let margin = Amount::ratio(worst.margin()).to(Digits::Decimals(3));
        text += &format!(" Least margin in major strain {margin} at s0 = {}.", Amount::place(worst.s0));
    }
    text
}
