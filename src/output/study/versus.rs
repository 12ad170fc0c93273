//! Pictures of several runs side by side, and the table of their differences.

use crate::forming_limit::{self, Assessment, Curve};
use crate::model::Geometry;
use crate::plot::chart::{Chart, Panel, Scale, Series, Style};
use crate::plot::forming_diagram::{StrainMeasure, limit_points};
use crate::plot::palette::{BLACK, color};
use crate::plot::sections;
use crate::solver::solution::{Frame, NodeRecord, StageSolution};
use crate::study::versus::{Member, Of, Versus};
use crate::table::fields::element::{S0, THICKNESS};
use crate::table::fields::step::{PUNCH_FORCE, TRAVEL};
use crate::units::rounded;

/// The file of the table.
pub const TABLE: &str = "differences.csv";
/// What it begins with.
pub const BEGINNING: &str = "quantity,of,unit,run,name,value,error_bar,difference,within_error\n";

/// Height of curves \[px of a picture 800 wide\].
const HEIGHT: f64 = 350.0;
/// Height of strains, whose axis has the longest words \[likewise\].
const TALL: f64 = 450.0;
/// So many measured points are circles, more of them a line.
const CIRCLES: usize = 60;
/// What is shown beside the strains, over their range, and above them.
const BESIDE: f64 = 0.15;
/// Least height of the thickness axis over the initial thickness: smaller differences are noise \[–\].
const LEAST: f64 = 0.02;

/// A picture: name of its file without the ending, what it shows, and what is drawn.
pub struct Drawn {
    /// `compare_load`
    pub stem: &'static str,
    /// `punch force over the travel`
    pub about: &'static str,
    /// In the units and words of a form.
    pub chart: Chart,
}

/// Load, thickness, strains and sections of all runs, those that they have, with what was measured.
pub fn pictures(versus: &Versus, engineering_strain: bool) -> Vec<Drawn> {
    let strains = StrainMeasure { is_engineering: engineering_strain };
    let all = [
        ("compare_load", "punch force over the travel", load(versus)),
        ("compare_thickness", "thickness over the blank", thickness(versus)),
        ("compare_strains", "strains and forming limit", limits(versus, strains)),
        ("compare_sections", "the sections at the end", shapes(versus)),
    ];
    let drawn = all.into_iter().filter_map(|(stem, about, found)| {
        let (panel, note) = found?;
        let title = format!("Compared: {about}");
        let notes = note.into_iter().map(|note| String::from(note)).collect();
        let chart = Chart { title, legend: String::new(), panels: vec![panel], notes }.displayed();
        Some(Drawn { stem, about, chart })
    });
    drawn.collect()
}

/// A curve of every run that has it, in its own colour and dashes.
fn curves<'a>(
    versus: &'a Versus,
    points: impl Fn(&'a Member) -> Vec<(f64, f64)> + 'a,
) -> impl Iterator<Item = Series> + 'a {
    let series = versus
        .members
        .iter()
        .enumerate()
        .map(move |(i, member)| Series::new(String::from(member.label()), points(member), Style::curve(i)));
    series.filter(|series| !series.points.is_empty())
}

/// What was measured of a kind, told apart from the runs.
fn measured(versus: &Versus, of: Of) -> impl Iterator<Item = Series> {
    versus.curves().filter(move |(_, curve)| curve.of == of).map(|(i, curve)| {
        let place = versus.members.len() + i;
        let look =
            if curve.points.len() > CIRCLES { Style::curve(place) } else { Style::Circles { color: color(place) } };
        Series::new(curve.label(i).to_string(), curve.points.clone(), look)
    })
}

type Found = Option<(Panel, Option<String>)>;

fn load(versus: &Versus) -> Found {
    let extent = versus.members.first()?.solution.case.model().extent();
    let series: Vec<Series> = curves(versus, |member| member.outcome().load.clone()).collect();
    let scale = Scale::Fit { height: HEIGHT, least: 0.0 };
    let (x, y) = (TRAVEL.axis(extent), PUNCH_FORCE.axis(extent));
    (!series.is_empty())
        .then(|| (Panel::new(x, y, scale).with(series.into_iter().chain(measured(versus, Of::Load))), None))
}

fn thickness(versus: &Versus) -> Found {
    let model = versus.members.first()?.solution.case.model();
    let (extent, least) = (model.extent(), LEAST * model.blank.thickness);
    let series: Vec<Series> = curves(versus, |member| member.outcome().thickness.clone()).collect();
    let scale = Scale::Fit { height: HEIGHT, least };
    let (x, y) = (S0.axis(extent), THICKNESS.axis(extent));
    (!series.is_empty())
        .then(|| (Panel::new(x, y, scale).with(series.into_iter().chain(measured(versus, Of::Thickness))), None))
}

/// The last stage that was run, and how it ended.
fn end(member: &Member) -> Option<(&StageSolution, &Frame)> {
    let stage = member.solution.stages.last()?;
    Some((stage, stage.frames.last()?))
}

/// A run with a forming limit.
struct Limited<'a> {
    place: usize,
    member: &'a Member,
    limit: &'a Curve,
    assessment: Assessment,
}

/// Strains from the axis to the edge, and the limits: minor and major of a cup, of a strip the major over the blank.
fn limits(versus: &Versus, strains: StrainMeasure) -> Found {
    let limited = versus.members.iter().enumerate().filter_map(|(place, member)| {
        let (stage, _) = end(member)?;
        let limit = stage.model.forming_limit.as_ref()?;
        let assessment = forming_limit::assess(limit, &stage.paths)?;
        Some(Limited { place, member, limit, assessment })
    });
    let limited: Vec<Limited> = limited.collect();
    let first = limited.first()?;
    let model = versus.members.first()?.solution.case.model();
    let is_strip = model.geometry == Geometry::PlaneStrain;
    let one_limit = limited.iter().all(|other| other.limit.points() == first.limit.points());
    let ends = || limited.iter().flat_map(|run| &run.assessment.elements);
    let [low, high] = [f64::min as fn(f64, f64) -> f64, f64::max].map(|of| ends().map(|e| e.minor).fold(0.0, of));
    let beside = BESIDE * (high - low).max(0.2);
    let minors = (low - beside, high + beside);
    let line = |run: &Limited| -> Vec<(f64, f64)> {
        if is_strip {
            return run.assessment.elements.iter().map(|e| (e.s0, strains.convert(e.limit))).collect();
        }
        let curve = limit_points(run.limit, minors).into_iter().filter(|p| p[0] <= p[1] && run.limit.knows(p[0]));
        curve.map(|p| strains.point(p)).collect()
    };
    let places = |run: &Limited| -> Vec<(f64, f64)> {
        let elements = run.assessment.elements.iter();
        match is_strip {
            true => elements.map(|e| (e.s0, strains.convert(e.major))).collect(),
            false => elements.map(|e| strains.point([e.minor, e.major])).collect(),
        }
    };
    let places = limited.iter().map(|run| (run, places(run)));
    let mut series: Vec<Series> = places
        .map(|(run, points)| Series::new(String::from(run.member.label()), points, Style::curve(run.place)))
        .collect();
    if one_limit {
        let label = format!("Limit: {curve}", curve = first.limit.name);
        series.push(Series::new(label, line(first), Style::Line { color: BLACK, width: 1.6, dash: &[] }));
    } else {
        series.extend(limited.iter().map(|run| {
            let label = format!("Limit of {run}", run = run.member.mark);
            Series::new(label, line(run), Style::curve(run.place).faint())
        }));
    }
    let tallest = series.iter().flat_map(|series| &series.points).map(|point| point.1).fold(0.0, f64::max);
    let lowest = ends().map(|element| strains.convert(element.major)).fold(0.0, f64::min);
    let y_range = (lowest, (1.0 + BESIDE) * tallest);
    let [minor, major] = strains.axes();
    let (x, x_range) = match is_strip {
        true => (S0.axis(model.extent()), (0.0, model.blank.length)),
        false => (minor, (strains.convert(minors.0), strains.convert(minors.1))),
    };
    let note = "Each line goes through the places of a sheet from its middle to its edge.".to_owned();
    let scale = Scale::Window { height: TALL, x: x_range, y: y_range };
    Some((Panel::new(x, major, scale).with(series), Some(note).filter(|_| !is_strip)))
}

/// The middle of the sheet at the end of every run, with the tools of the first.
fn shapes(versus: &Versus) -> Found {
    let first = versus.members.first()?;
    let (stage, frame) = end(first)?;
    let nodes = versus.members.iter().filter_map(end).flat_map(|(_, frame)| &frame.nodes);
    let length = versus.members.iter().map(|m| m.solution.case.model().blank.length).fold(0.0, f64::max);
    let window = sections::window(nodes, length);
    let at = |node: &NodeRecord| (node.r, node.z);
    let middle = |member: &Member| end(member).map_or_else(Vec::new, |(_, frame)| frame.nodes.iter().map(at).collect());
    let sheets: Vec<Series> = curves(versus, middle).collect();
    let tools = sections::tools(&stage.model, Some(frame), length);
    let note = format!(
        "Lines are the middle of the sheet at the end of each run; the tools are those of {run}.",
        run = first.mark
    );
    Some((sections::panel(stage.model.geometry, window).with(tools).with(sheets), Some(note)))
}

/// One row for every number of every run, then what the verdict says and how it ended.
pub fn csv(versus: &Versus) -> Vec<u8> {
    let never = "memory does not refuse a row";
    let mut writer = csv::Writer::from_writer(BEGINNING.as_bytes().to_vec());
    let mut put = |row: [String; 9]| writer.write_record(row).expect(never);
    let number = |value: f64| rounded(value).to_string();
    for compared in versus.compared() {
        let own = &compared.number;
        let (key, of, unit) = (own.key, own.of.key(), own.amount.unit.spelled());
        for (i, (member, value)) in versus.members.iter().zip(&compared.values).enumerate() {
            let change = i.checked_sub(1).map(|i| compared.changes[i]);
            let value_of = |amount: &crate::units::Amount| number(amount.value);
            put([
                key.into(),
                of.into(),
                unit.into(),
                member.mark.clone(),
                member.name.to_string(),
                value.as_ref().map_or_else(String::new, value_of),
                value.and_then(|amount| amount.bar()).map_or_else(String::new, number),
                change.and_then(|change| change.value()).map_or_else(String::new, number),
                match change.and_then(|change| change.is_within()) {
                    Some(true) => "yes".into(),
                    Some(false) => "no".into(),
                    None => String::new(),
                },
            ]);
        }
    }
    let none = String::new;
    for misfit in versus.misfits() {
        for (member, found) in versus.members.iter().zip(&misfit.of_members) {
            let (value, unit) = found.map_or_else(|| (none(), ""), |(rms, _)| (number(rms.value), rms.unit.spelled()));
            let key = format!("rms off {}", misfit.curve);
            let (mark, name) = (member.mark.clone(), member.name.to_string());
            put([key, "measured".into(), unit.into(), mark, name, value, none(), none(), none()]);
        }
    }
    for member in &versus.members {
        let words = [("verdict", member.light.name().to_owned()), ("end", member.outcome().end.kind.to_owned())];
        for (key, word) in words {
            let (mark, name) = (member.mark.clone(), member.name.to_string());
            put([key.into(), "run".into(), none(), mark, name, word, none(), none(), none()]);
        }
    }
    writer.into_inner().expect(never)
}
