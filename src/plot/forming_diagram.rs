//! The forming limit diagram: zones below and above the curve, and the way that places take through them. A strip's places
//! all lie on one line of it, that of plane strain: there the major strain stands over the part instead.

use super::StageView;
use super::chart::{BLACK, Chart, Color, GREY, Look, Panel, Scale, Series, color, pale};
use crate::assess::CAREFUL;
use crate::forming_limit::{Assessment, CROOKED, Curve, Judged};
use crate::model::Geometry;
use crate::results::forming_limit;
use crate::table::fields::element::S0;
use crate::table::{Column, Unit};
use crate::units::{Amount, Digits, joined};

/// Points of a drawn path: more than the eye follows.
const DRAWN: usize = 60;
/// Paths that are drawn beside that of the least margin, evenly over the sheet.
const PATHS: usize = 24;
/// Height of the diagram, and of the strip's \[px\].
const HEIGHT: f64 = 450.0;
const STRIP_HEIGHT: f64 = 350.0;
/// What is shown beside the points, over their range, and at least \[–\].
const BESIDE: f64 = 0.25;
const LEAST_BESIDE: f64 = 0.08;
/// What is shown above the curve and all points, over their height.
const ABOVE: f64 = 0.12;
/// How finely the limit is drawn.
const FINE: usize = 100;

/// Of what is safe, near the limit, and beyond it: apart for colour-blind readers and in grey, the darker the worse.
const SAFE: Color = (232, 244, 248);
const MARGINAL: Color = (252, 226, 156);
const FAILED: Color = (231, 171, 143);
/// Of what is not judged, beyond the end of the curve.
const UNJUDGED: Color = (226, 226, 226);

const LIMIT: Look = Look::Line { color: BLACK, width: 2.4, dash: &[] };
const AXIS: Look = Look::Line { color: GREY, width: 0.8, dash: &[2.5, 3.0] };

/// The diagram.
pub fn plot(view: &StageView) -> Option<Chart> {
    let assessment = view.forming_limit()?;
    let limit = view.model().forming_limit.as_ref()?;
    let strains = Strains { engineering: view.pictures.engineering_strain };
    let (what, panel) = match view.geometry() {
        Geometry::Axisymmetric => ("forming limit diagram", diagram(view, assessment, limit, strains)),
        Geometry::PlaneStrain => ("major strain and forming limit", strip(view, assessment, limit, strains)),
    };
    let sources = limit.notes.iter().filter(|_| view.says_sources()).map(|note| String::from(note.clone()));
    let notes = std::iter::once(String::from(words(view, assessment))).chain(sources).chain(view.notes()).collect();
    Some(Chart { title: view.titled(what), legend: String::new(), panels: vec![panel], notes })
}

/// In which measure strains are drawn.
#[derive(Clone, Copy)]
pub(crate) struct Strains {
    /// Over the initial length, as sheet makers have them; else logarithmic.
    pub engineering: bool,
}

impl Strains {
    /// A logarithmic strain in that measure.
    pub fn of(self, strain: f64) -> f64 {
        if self.engineering { strain.exp_m1() } else { strain }
    }

    /// Of minor and major strain.
    pub fn point(self, [minor, major]: [f64; 2]) -> (f64, f64) {
        (self.of(minor), self.of(major))
    }

    /// Of minor and major strain.
    pub fn axes(self) -> [crate::table::Axis; 2] {
        if !self.engineering {
            return forming_limit::axes();
        }
        [
            ("strain_minor", "Minor engineering strain, mid-surface"),
            ("strain_major", "Major engineering strain, mid-surface"),
        ]
        .map(|(key, label)| Column::new(key, label, Unit::None, Vec::new()).axis())
    }
}

/// Minor and major strain of every place, with the paths of some.
fn diagram(view: &StageView, assessment: &Assessment, limit: &Curve, strains: Strains) -> Panel {
    let paths = |e: usize| drawn(&view.stage.paths.of(e)).into_iter().map(|p| strains.point(p)).collect::<Vec<_>>();
    let (worst, every) = (worst(assessment), assessment.elements.len().div_ceil(PATHS).max(1));
    let some = (0..assessment.elements.len()).step_by(every).map(paths);
    let some: Vec<Vec<(f64, f64)>> = some.collect();
    let emphasised = paths(worst);

    let ends = || assessment.elements.iter().map(|element| (element.minor, element.major));
    let (low, high) = ends().fold((0.0_f64, 0.0_f64), |(low, high), (minor, _)| (low.min(minor), high.max(minor)));
    let beside = (BESIDE * (high - low)).max(LEAST_BESIDE);
    let minors = (low - beside, high + beside);
    // The minor strain is not the larger one: the curve ends where they are alike.
    let curve = along(limit, minors);
    let largest = ends().map(|end| end.1).chain(curve.iter().map(|p| p[1])).fold(0.0, f64::max);
    let top = (1.0 + ABOVE) * largest;
    let least = ends().map(|end| end.1).fold(0.0, f64::min);
    let right = minors.1.min(top);

    // From the lower left, below or above the curve, to the line on which both strains are alike.
    let share = |share: f64| curve.iter().map(move |p| [p[0], share * p[1]]).filter(|p| p[0] <= p[1]);
    let below = |level: f64| {
        let mut outline: Vec<[f64; 2]> = share(level).collect();
        let last = outline.last().copied().unwrap_or_default();
        outline.extend([[last[0], last[0].min(last[1])], [least.min(0.0), least.min(0.0)], [minors.0, least.min(0.0)]]);
        outline
    };
    let all = vec![
        [minors.0, top],
        [right, top],
        [right, right],
        [least.min(0.0), least.min(0.0)],
        [minors.0, least.min(0.0)],
    ];
    let zone = |label: String, outline: Vec<[f64; 2]>, fill| {
        let points = outline.into_iter().map(|p| strains.point(p)).collect();
        Series::new(String::from(label), points, Look::Area { fill, edge: None })
    };
    let mut series = vec![
        zone("Failed".into(), all, FAILED),
        zone(marginal(), below(1.0), MARGINAL),
        zone("Safe".into(), below(CAREFUL), SAFE),
    ];
    series.extend(limit.ends_at().map(|end| {
        let level = limit.major_at(end);
        let beyond = vec![[end, level], [right.min(level), level], [right, level.max(right)], [right, top], [end, top]];
        zone("Not judged: the limit has ended".into(), beyond, UNJUDGED)
    }));
    series.extend([Series::silent(vec![strains.point([0.0, least.min(0.0)]), strains.point([0.0, top])], AXIS)]);
    let thin = Look::Line { color: pale(GREY), width: 0.9, dash: &[] };
    series.extend(some.into_iter().map(|path| Series::silent(path, thin)));
    let of = |is: fn(&Judged) -> bool| {
        let those = assessment.elements.iter().filter(|element| is(element));
        those.map(|element| strains.point([element.minor, element.major])).collect::<Vec<_>>()
    };
    let places = [
        ("Major strain along the meridian", of(|element| !element.hoop_is_major), Look::Dots { color: color(0) }),
        ("Major strain along the hoop", of(|element| element.hoop_is_major), Look::Triangles { color: color(2) }),
    ];
    let places = places.into_iter().filter(|(_, points, _)| !points.is_empty());
    series.extend(places.map(|(label, points, look)| Series::new(String::from(label), points, look)));
    let name = String::from(named(limit));
    let shown = curve.iter().filter(|p| p[0] <= p[1] && limit.knows(p[0])).map(|p| strains.point(*p)).collect();
    series.push(Series::new(name, shown, LIMIT));
    let end = emphasised.last().copied().into_iter().collect();
    series.push(Series::silent(emphasised, Look::Line { color: color(1), width: 2.2, dash: &[] }));
    series.push(Series::new(
        String::from(nearest(&assessment.elements[worst])),
        end,
        Look::Circles { color: color(1) },
    ));
    let [x, y] = strains.axes();
    let window = (minors.0, right);
    let scale = Scale::Window {
        height: HEIGHT,
        x: (strains.of(window.0), strains.of(window.1)),
        y: (strains.of(least.min(0.0)), strains.of(top)),
    };
    Panel { x, y, series, scale }
}

/// The major strain over the strip, below its limit.
fn strip(view: &StageView, assessment: &Assessment, limit: &Curve, strains: Strains) -> Panel {
    let elements = &assessment.elements;
    let length = view.model().blank.length;
    let over = |value: &dyn Fn(&Judged) -> f64| -> Vec<(f64, f64)> {
        let ends = elements.first().map(|first| (0.0, strains.of(value(first))));
        let last = elements.last().map(|last| (length, strains.of(value(last))));
        let inner = elements.iter().map(|element| (element.s0, strains.of(value(element))));
        ends.into_iter().chain(inner).chain(last).collect()
    };
    let top = elements.iter().map(|e| e.limit.max(e.major)).fold(0.0, f64::max) * (1.0 + ABOVE);
    let least = elements.iter().map(|e| e.major).fold(0.0, f64::min);
    let [low, high] = [least, top].map(|strain| strains.of(strain));
    let below = |mut line: Vec<(f64, f64)>| {
        line.extend([(length, low), (0.0, low)]);
        line
    };
    let zone =
        |label: String, outline, fill| Series::new(String::from(label), outline, Look::Area { fill, edge: None });
    let worst = &elements[worst(assessment)];
    let series = vec![
        zone("Failed".into(), below(vec![(0.0, high), (length, high)]), FAILED),
        zone(marginal(), below(over(&|e| e.limit)), MARGINAL),
        zone("Safe".into(), below(over(&|e| CAREFUL * e.limit)), SAFE),
        Series::new(String::from(named(limit)), over(&|e| e.limit), LIMIT),
        Series::new(String::from("Major strain"), over(&|e| e.major), Look::curve(0)),
        Series::new(
            String::from(nearest(worst)),
            vec![(worst.s0, strains.of(worst.major))],
            Look::Circles { color: color(1) },
        ),
    ];
    let [_, y] = strains.axes();
    Panel {
        x: S0.axis(view.extent()),
        y,
        series,
        scale: Scale::Window { height: STRIP_HEIGHT, x: (0.0, length), y: (low, high) },
    }
}

fn nearest(worst: &Judged) -> String {
    let [share, s0] = [percent(worst.ratio()), Amount::place(worst.s0)];
    if worst.is_open() {
        return format!("Most strained beyond the end of the limit, s0 = {s0}");
    }
    format!("Nearest to the limit, {share} of it, s0 = {s0}")
}

fn marginal() -> String {
    format!("Marginal, above {share} of the limit", share = percent(CAREFUL))
}

fn named(limit: &Curve) -> String {
    format!("Limit: {curve}", curve = limit.name)
}

/// A share to a percent.
fn percent(share: f64) -> Amount {
    Amount::share(share).to(Digits::Decimals(0))
}

/// The number of the element with the least margin, or of the one that is strained most beyond the end of the curve where
/// none has reached it.
fn worst(assessment: &Assessment) -> usize {
    let open = assessment.open().filter(|_| assessment.reached.is_none());
    let worst = open.unwrap_or_else(|| assessment.worst());
    assessment.elements.iter().position(|element| element == worst).unwrap_or(0)
}

/// The curve over a range of minor strains: its own points, and some between them, so that shares of it are as fine.
pub(crate) fn along(curve: &Curve, (low, high): (f64, f64)) -> Vec<[f64; 2]> {
    let even = (0..=FINE).map(|i| low + (high - low) * i as f64 / FINE as f64);
    let own = curve.points().iter().map(|p| p[0]).filter(|minor| (low..=high).contains(minor));
    let mut minors: Vec<f64> = even.chain(own).collect();
    minors.sort_by(f64::total_cmp);
    minors.into_iter().map(|minor| [minor, curve.major_at(minor)]).collect()
}

/// What the diagram says.
fn words(view: &StageView, assessment: &Assessment) -> String {
    let worst = assessment.worst();
    let reached = assessment.reached.map_or_else(
        || match assessment.open() {
            Some(_) => "The limit ends in plane strain, and places beyond its end are not judged.".into(),
            None => String::from("The limit is not reached."),
        },
        |reached| {
            let (s0, travel) = (Amount::place(reached.s0), Amount::place(reached.travel).to(Digits::Decimals(2)));
            let time = Amount::time(reached.time).to(Digits::Decimals(4));
            match view.model().timed {
                true => format!("The limit is reached at s0 = {s0}, at {travel} of travel ({time})."),
                false => {
                    format!("The limit is reached at s0 = {s0}, at {travel} of travel.")
                }
            }
        },
    );
    let least = (!worst.is_open()).then(|| {
        format!(
            "Least margin in major strain {margin} at s0 = {s0}, where the major strain is {share} of the limit.",
            margin = Amount::strain(worst.margin()).to(Digits::Decimals(3)),
            s0 = Amount::place(worst.s0),
            share = percent(worst.ratio())
        )
    });
    let crooked = format!(
        "{n} of {all} paths leave a straight line by more than {share} of their length: limits are measured on straight ones.",
        n = assessment.crooked(),
        all = assessment.elements.len(),
        share = percent(CROOKED)
    );
    let crooked = Some(crooked).filter(|_| assessment.crooked() > 0);
    joined([Some(reached), least, crooked].into_iter().flatten(), " ")
}

fn drawn(path: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let every = path.len().div_ceil(DRAWN).max(1);
    let last = path.last().filter(|_| !(path.len() - 1).is_multiple_of(every));
    path.iter().step_by(every).chain(last).copied().collect()
}
