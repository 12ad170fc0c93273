//! The forming limit diagram: the curve, and the way that every element takes below it or through it.

use super::StageView;
use super::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color, pale};
use crate::forming_limit::{Assessment, CROOKED, Curve};
use crate::table::fields::element::{S0, STRAIN_HOOP, STRAIN_MERIDIONAL};
use crate::table::fields::step::TRAVEL;
use crate::table::{Axis, Column, Table, Unit, worded};

/// Points of a drawn path: more than the eye follows.
const DRAWN: usize = 60;
/// Least height of the diagram \[–\].
const LEAST: f64 = 0.1;

fn minor(values: Vec<f64>) -> Column {
    Column::new("strain_minor", "Minor true strain, mid-surface", Unit::None, values)
}

fn major(values: Vec<f64>) -> Column {
    Column::new("strain_major", "Major true strain, mid-surface", Unit::None, values)
}

/// The axes of a forming limit diagram: minor and major strain.
pub(super) fn axes() -> [Axis; 2] {
    [minor(Vec::new()).axis(), major(Vec::new()).axis()]
}

/// The points of a curve.
pub fn curve(curve: &Curve) -> Table {
    let column = |i: usize| curve.points().iter().map(|point| point[i]).collect();
    Table::new(vec![minor(column(0)), major(column(1))])
}

pub(super) fn curve_of(view: &StageView) -> Option<Table> {
    view.model().forming_limit.as_ref().map(curve)
}

/// One row per element and accepted step: its strains and its distance to the curve; the crookedness is that of the whole
/// path.
pub(super) fn paths_of(view: &StageView) -> Option<Table> {
    let assessment = view.forming_limit()?;
    let curve = view.model().forming_limit.as_ref()?;
    let paths = &view.stage.paths;
    let mut columns: [Vec<f64>; 10] = Default::default();
    for (e, judged) in assessment.elements.iter().enumerate() {
        for (instant, [minor, major]) in paths.instants.iter().zip(paths.of(e)) {
            let [meridional, hoop] = instant.strains[e];
            let limit = curve.major_at(minor);
            let row = [
                judged.s0,
                instant.time,
                instant.travel,
                minor,
                major,
                meridional,
                hoop,
                limit,
                limit - major,
                judged.crookedness,
            ];
            columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
        }
    }
    let extent = view.extent();
    let [s0, time, travel, minors, majors, meridional, hoop, limit, margin, crookedness] = columns;
    Some(Table::new(vec![
        S0.filled(extent, s0),
        Column::new("time", "Time", Unit::Second, time),
        TRAVEL.filled(extent, travel),
        minor(minors),
        major(majors),
        STRAIN_MERIDIONAL.filled(extent, meridional),
        STRAIN_HOOP.filled(extent, hoop),
        Column::new("limit_major", "Major strain of the limit", Unit::None, limit),
        Column::new("margin", "Margin in major strain", Unit::None, margin),
        Column::new(
            "crookedness",
            "Distance of the path from a straight line, over its length",
            Unit::None,
            crookedness,
        ),
    ]))
}

/// The diagram.
pub fn plot(view: &StageView) -> Option<Chart> {
    let assessment = view.forming_limit()?;
    let limit = view.model().forming_limit.as_ref()?;
    let worst = assessment.worst();
    let thin = Look::Line { color: pale(GREY), width: 0.8, dash: &[] };
    let paths = (0..assessment.elements.len()).map(|e| Series::silent(drawn(&view.stage.paths.of(e)), thin));
    let ends = |hoop: bool| -> Vec<(f64, f64)> {
        let of_one = assessment.elements.iter().filter(|element| element.hoop_is_major == hoop);
        of_one.map(|element| (element.minor, element.major)).collect()
    };
    let (along, across) = (ends(false), ends(true));
    let worded = |axisymmetric, plane_strain| worded(view.geometry(), axisymmetric, plane_strain);
    let places = [
        (worded("Elements at the end, major strain along the meridian", "Elements at the end"), along, 0),
        (worded("Elements at the end, major strain along the hoop", "Elements at the end, shortened"), across, 2),
    ];
    let places = places.into_iter().filter(|(_, points, _)| !points.is_empty());
    let places = places.map(|(label, points, i)| Series::new(label, points, Look::Circles { color: color(i) }));
    let e = assessment.elements.iter().position(|element| element == worst)?;
    let path = Series::new(
        format!("Path of the least margin, s0 = {:.1} mm", worst.s0),
        drawn(&view.stage.paths.of(e)),
        Look::Line { color: color(0), width: 1.8, dash: &[] },
    );
    let curve = Series::new(
        format!("Forming limit: {}", limit.name),
        shown(limit, assessment),
        Look::Line { color: color(1), width: 2.8, dash: &[] },
    );
    // The origin and plane strain.
    let top = limit.plane_strain();
    let axis = Series::silent(vec![(0.0, 0.0), (0.0, top)], Look::Line { color: BLACK, width: 0.8, dash: &[2.5, 3.0] });
    let [x, y] = axes();
    Some(Chart {
        title: view.titled("forming limit diagram"),
        legend: "",
        panels: vec![Panel {
            x,
            y,
            series: paths.chain([axis, path]).chain(places).chain([curve]).collect(),
            scale: Scale::Fit { height: 450.0, least: LEAST },
        }],
        notes: std::iter::once(words(view, assessment))
            .chain(limit.notes.iter().cloned())
            .chain(view.notes())
            .collect(),
    })
}

/// What the diagram says.
fn words(view: &StageView, assessment: &Assessment) -> String {
    let worst = assessment.worst();
    let reached = assessment.reached.map_or("The limit is not reached.".to_owned(), |reached| {
        let time = if view.model().timed { format!(" ({:.4} s)", reached.time) } else { String::new() };
        format!("The limit is reached at s0 = {:.1} mm, at {:.2} mm of travel{time}.", reached.s0, reached.travel)
    });
    let crooked = match assessment.crooked() {
        0 => String::new(),
        n => format!(
            " {n} of {} paths leave a straight line by more than {:.0} % of their length: limits are measured on straight ones.",
            assessment.elements.len(),
            100.0 * CROOKED
        ),
    };
    format!(
        "{reached} Least margin in major strain {:.3} at s0 = {:.1} mm, where the major strain is {:.0} % of the limit.{crooked}",
        worst.margin(),
        worst.s0,
        100.0 * worst.ratio()
    )
}

/// The curve as far as it is wanted: to its own ends, and to the elements beyond them.
fn shown(curve: &Curve, assessment: &Assessment) -> Vec<(f64, f64)> {
    let least = assessment.elements.iter().map(|element| element.minor).fold(curve.points()[0][0], f64::min);
    let most = assessment.elements.iter().map(|element| element.minor).fold(f64::NEG_INFINITY, f64::max);
    let own = curve.points().iter().map(|p| (p[0], p[1]));
    let last = curve.points()[curve.points().len() - 1][0];
    let before = (least < curve.points()[0][0]).then(|| (least, curve.major_at(least)));
    let after = (most > last).then(|| (most, curve.major_at(most)));
    before.into_iter().chain(own).chain(after).collect()
}

fn drawn(path: &[[f64; 2]]) -> Vec<(f64, f64)> {
    let every = path.len().div_ceil(DRAWN).max(1);
    let last = path.last().filter(|_| !(path.len() - 1).is_multiple_of(every));
    path.iter().step_by(every).chain(last).map(|p| (p[0], p[1])).collect()
}
