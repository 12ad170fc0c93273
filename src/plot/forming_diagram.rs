//! Forming limit diagram: zones below and above the curve, and strain paths. A strip's places all have plane strain: the
//! major strain is drawn over the blank instead.

use super::StageView;
use super::chart::{Chart, Color, Panel, Scale, Series, Style, bounds};
use super::palette::{BLACK, GREY, color};
use crate::assess::CAREFUL;
use crate::forming_limit::{Assessment, CROOKED, Curve, Judged};
use crate::model::Geometry;
use crate::table::fields::element::S0;
use crate::table::{Axis, Unit};
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
/// Points of the drawn limit.
const FINE: usize = 100;
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
    let measure = StrainMeasure { is_engineering: view.pictures.engineering_strain };
    let (what, panel) = match view.geometry() {
        Geometry::Axisymmetric => ("forming limit diagram", diagram(view, assessment, limit, measure)),
        Geometry::PlaneStrain => ("major strain and forming limit", strip(view, assessment, limit, measure)),
    };
    let sources = limit.notes.iter().filter(|_| view.states_sources()).map(ToString::to_string);
    let notes = std::iter::once(summary(view, assessment)).chain(sources).chain(view.notes()).collect();
    Some(Chart::new(view.titled(what), vec![panel], notes))
}

/// Measure of drawn strains: engineering or logarithmic.
#[derive(Clone, Copy)]
pub(crate) struct StrainMeasure {
    pub is_engineering: bool,
}

impl StrainMeasure {
    /// Converts a logarithmic strain.
    pub fn convert(self, strain: f64) -> f64 {
        if self.is_engineering { strain.exp_m1() } else { strain }
    }

    /// Converts minor and major strain.
    pub fn point(self, [minor, major]: [f64; 2]) -> (f64, f64) {
        (self.convert(minor), self.convert(major))
    }

    /// Axes of minor and major strain.
    pub fn axes(self) -> [Axis; 2] {
        let measure = if self.is_engineering { "engineering" } else { "true" };
        ["Minor", "Major"].map(|which| Axis::named(format!("{which} {measure} strain, mid-surface"), Unit::None))
    }
}

/// Minor and major strain of every place, with the paths of some.
fn diagram(view: &StageView, assessment: &Assessment, limit: &Curve, measure: StrainMeasure) -> Panel {
    let points = |path: &[[f64; 2]]| path.iter().map(|p| measure.point(*p)).collect::<Vec<_>>();
    let path = |e: usize| points(&thinned(&view.stage.paths.of(e)));
    let (worst, every) = (worst(assessment), assessment.elements.len().div_ceil(PATHS).max(1));

    let (low, high) = bounds(assessment.elements.iter().map(|e| e.minor).chain([0.0]));
    let around = (AROUND * (high - low)).max(LEAST_AROUND);
    let minors = (low - around, high + around);
    let curve = limit_points(limit, minors);
    let majors = assessment.elements.iter().map(|e| e.major);
    let (least, largest) = bounds(majors.chain(curve.iter().map(|p| p[1])).chain([0.0]));
    let top = (1.0 + ABOVE) * largest;
    // The minor strain is not the larger one: zones and curve end where both are equal.
    let right = minors.1.min(top);

    let below = |share: f64| {
        let mut outline: Vec<[f64; 2]> = curve.iter().map(|p| [p[0], share * p[1]]).filter(|p| p[0] <= p[1]).collect();
        let last = outline.last().copied().unwrap_or_default();
        outline.extend([[last[0], last[0].min(last[1])], [least, least], [minors.0, least]]);
        outline
    };
    let all = [[minors.0, top], [right, top], [right, right], [least, least], [minors.0, least]];
    let zone = |label: &str, outline: &[[f64; 2]], fill| Series::new(label, points(outline), Style::area(fill));
    let mut series = vec![
        zone("Failed", &all, FAILED),
        zone(&marginal_label(), &below(1.0), MARGINAL),
        zone("Safe", &below(CAREFUL), SAFE),
    ];
    series.extend(limit.ends_at().map(|end| {
        let level = limit.major_at(end);
        let beyond = [[end, level], [right.min(level), level], [right, level.max(right)], [right, top], [end, top]];
        zone("Not judged: the limit has ended", &beyond, NOT_JUDGED)
    }));
    series.push(Series::silent(points(&[[0.0, least], [0.0, top]]), AXIS));
    series.extend((0..assessment.elements.len()).step_by(every).map(|e| Series::silent(path(e), PATH)));
    let places = |is_hoop: bool| {
        let those = assessment.elements.iter().filter(|element| element.hoop_is_major == is_hoop);
        those.map(|element| measure.point([element.minor, element.major])).collect::<Vec<_>>()
    };
    let kinds = [
        ("Major strain along the meridian", places(false), Style::Dots { color: color(0) }),
        ("Major strain along the hoop", places(true), Style::Triangles { color: color(2) }),
    ];
    let kinds = kinds.into_iter().filter(|(_, points, _)| !points.is_empty());
    series.extend(kinds.map(|(label, points, style)| Series::new(label, points, style)));
    let drawn: Vec<[f64; 2]> = curve.into_iter().filter(|p| p[0] <= p[1] && limit.knows(p[0])).collect();
    series.push(Series::new(limit_label(limit), points(&drawn), LIMIT));
    let worst_path = path(worst);
    let end = worst_path.last().copied().into_iter().collect();
    series.push(Series::silent(worst_path, Style::solid(color(1), 2.2)));
    series.push(Series::new(worst_label(&assessment.elements[worst]), end, Style::Circles { color: color(1) }));
    let [x, y] = measure.axes();
    let range = |(low, high)| (measure.convert(low), measure.convert(high));
    let scale = Scale::Window { height: HEIGHT, x: range((minors.0, right)), y: range((least, top)) };
    Panel::new(x, y, scale).with(series)
}

/// Major strain over the strip, below its limit.
fn strip(view: &StageView, assessment: &Assessment, limit: &Curve, measure: StrainMeasure) -> Panel {
    let elements = &assessment.elements;
    let length = view.model().blank.length;
    let over = |value: &dyn Fn(&Judged) -> f64| -> Vec<(f64, f64)> {
        let ends = elements.first().map(|first| (0.0, measure.convert(value(first))));
        let last = elements.last().map(|last| (length, measure.convert(value(last))));
        let inner = elements.iter().map(|element| (element.s0, measure.convert(value(element))));
        ends.into_iter().chain(inner).chain(last).collect()
    };
    let (least, _) = bounds(elements.iter().map(|e| e.major).chain([0.0]));
    let top = bounds(elements.iter().map(|e| e.limit.max(e.major)).chain([0.0])).1 * (1.0 + ABOVE);
    let [low, high] = [least, top].map(|strain| measure.convert(strain));
    let zone = |label: &str, mut line: Vec<(f64, f64)>, fill| {
        line.extend([(length, low), (0.0, low)]);
        Series::new(label, line, Style::area(fill))
    };
    let worst = &elements[worst(assessment)];
    let at_worst = vec![(worst.s0, measure.convert(worst.major))];
    let [_, y] = measure.axes();
    let scale = Scale::Window { height: STRIP_HEIGHT, x: (0.0, length), y: (low, high) };
    Panel::new(S0.axis(view.extent()), y, scale).with([
        zone("Failed", vec![(0.0, high), (length, high)], FAILED),
        zone(&marginal_label(), over(&|e| e.limit), MARGINAL),
        zone("Safe", over(&|e| CAREFUL * e.limit), SAFE),
        Series::new(limit_label(limit), over(&|e| e.limit), LIMIT),
        Series::new("Major strain", over(&|e| e.major), Style::curve(0)),
        Series::new(worst_label(worst), at_worst, Style::Circles { color: color(1) }),
    ])
}

fn worst_label(worst: &Judged) -> String {
    let s0 = Amount::place(worst.s0);
    if worst.is_open() {
        return format!("Most strained beyond the end of the limit, s0 = {s0}");
    }
    format!("Nearest to the limit, {} of it, s0 = {s0}", percent(worst.ratio()))
}

fn marginal_label() -> String {
    format!("Marginal, above {} of the limit", percent(CAREFUL))
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

/// Points of the limit over a range of minor strains: its own, and evenly spaced ones between them.
pub(crate) fn limit_points(curve: &Curve, (low, high): (f64, f64)) -> Vec<[f64; 2]> {
    let even = (0..=FINE).map(|i| low + (high - low) * i as f64 / FINE as f64);
    let own = curve.points().iter().map(|p| p[0]).filter(|minor| (low..=high).contains(minor));
    let mut minors: Vec<f64> = even.chain(own).collect();
    minors.sort_by(f64::total_cmp);
    minors.into_iter().map(|minor| [minor, curve.major_at(minor)]).collect()
}

fn summary(view: &StageView, assessment: &Assessment) -> String {
    let mut sentences = Vec::new();
    if let Some(reached) = &assessment.reached {
        let (s0, travel) = (Amount::place(reached.s0), Amount::place(reached.travel).to(Digits::Decimals(2)));
        let time = Amount::time(reached.time).to(Digits::Decimals(4));
        let time = if view.model().timed { format!(" ({time})") } else { String::new() };
        sentences.push(format!("The limit is reached at s0 = {s0}, at {travel} of travel{time}."));
    } else if assessment.open().is_some() {
        sentences.push("The limit ends in plane strain, and places beyond its end are not judged.".to_owned());
    } else {
        sentences.push("The limit is not reached.".to_owned());
    }
    let worst = assessment.worst();
    if !worst.is_open() {
        let margin = Amount::strain(worst.margin()).to(Digits::Decimals(3));
        let (s0, share) = (Amount::place(worst.s0), percent(worst.ratio()));
        sentences.push(format!(
            "Least margin in major strain {margin} at s0 = {s0}, where the major strain is {share} of the limit."
        ));
    }
    if assessment.crooked() > 0 {
        sentences.push(format!(
            "{} of {} paths leave a straight line by more than {} of their length: limits are measured on straight ones.",
            assessment.crooked(),
            assessment.elements.len(),
            percent(CROOKED)
        ));
    }
    sentences.join(" ")
}

fn thinned(path: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let every = path.len().div_ceil(PATH_POINTS).max(1);
    let last = path.last().filter(|_| !(path.len() - 1).is_multiple_of(every));
    path.iter().step_by(every).chain(last).copied().collect()
}
