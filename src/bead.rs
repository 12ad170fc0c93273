//! Draw bead by its section: a plane-strain strip that is bent into the groove and then pulled through.
//!
//! The forming run takes both forces of the strip as a line restraint. It does not thin the sheet as the strip is thinned.

use crate::geometry::{Piece, Point, Profile};
use crate::model::{Bead, Blank, Edge, Geometry, Grading, Heat, Mode, Model, Motion, Role, Round, Settings, Stage};
use crate::model::{ThicknessRule, Tool, tool_sizes::shoulder_end};
use crate::solver::solution::{StageSolution, Stop};
use crate::table::{Field, Table};
use crate::units::{Amount, Unit, rounded, significant};
use std::{f64::consts::FRAC_PI_2, sync::Mutex, sync::PoisonError};

/// Elements on a quarter of the smaller radius, their greatest length over the thickness \[–\], and most elements.
const PER_QUARTER: f64 = 12.0;
const LONGEST: f64 = 0.65;
const ELEMENTS: usize = 600;
/// Points through the thickness of a strip that flows, an even number with the whole moment, and of an elastic one.
const FLOWING: (usize, ThicknessRule) = (10, ThicknessRule::Parts);
const ELASTIC: (usize, ThicknessRule) = (11, ThicknessRule::Lobatto);
/// Pulled length over the path through the bead \[–\], and its share before forces are means: they are steady from a third on.
const PULLED: f64 = 1.25;
const BEFORE: f64 = 2.0 / 3.0;
/// Flat ends beyond the groove, usual clearance, and distance of the faces of holder and die, over the thickness \[–\]: declared.
/// From 1.0 to 1.05 of the last the restraint of a bead of 5 mm in 1 mm of steel falls by 9 %.
const FLATS: f64 = 4.0;
const CLEARANCE: f64 = 1.1;
const APART: f64 = 1.02;
const REMEMBERED: usize = 64;

/// Strip pulled through a bead; forces are per length of the bead's line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// Distance of the bead from the axis or symmetry plane \[mm\].
    pub at: f64,
    /// Travel of the bead from where it touches the flat sheet \[mm\].
    pub penetration: f64,
    /// Force at the end of closing \[N/mm\].
    pub closing: f64,
    /// Force that pulls the strip through \[N/mm\].
    pub restraining: f64,
    /// Force that keeps the bead closed meanwhile \[N/mm\].
    pub uplift: f64,
    /// Thinning of the strip that has passed the bead \[–\].
    pub thinning: f64,
}

const FIELDS: [Field<Drawn>; 6] = [
    Field::new("at", "Distance of the bead from the axis or symmetry plane", Unit::Mm, |row| row.at),
    Field::new("penetration", "Penetration", Unit::Mm, |row| row.penetration),
    Field::new("closing", "Closing force", Unit::NPerMm, |row| row.closing),
    Field::new("restraining", "Restraining force", Unit::NPerMm, |row| row.restraining),
    Field::new("uplift", "Force that keeps it closed", Unit::NPerMm, |row| row.uplift),
    Field::new("thinning", "Thinning behind it", Unit::None, |row| row.thinning),
];

/// Angle from the bead's tip to its flank \[rad\], half widths of bead, groove, and groove with its edges \[mm\].
fn widths(bead: &Round, t: f64) -> (f64, [f64; 3]) {
    let turn = (1.0 - bead.height / bead.radius).max(0.0).acos();
    let half = bead.radius * turn.sin();
    let wall = half + bead.clearance.unwrap_or(CLEARANCE * t);
    (turn, [half, wall, wall + bead.shoulder])
}

/// Sections of die and holder up to `end`, the bead at `at` \[mm\], its groove so deep that the sheet is off its bottom.
fn sections(bead: &Round, t: f64, at: f64, end: f64) -> [Profile; 2] {
    let (turn, [half, wall, edge]) = widths(bead, t);
    let line = |from: [f64; 2], to: [f64; 2]| Piece::line(from.into(), to.into());
    let arc = |x: f64, z: f64, radius, start, sweep| Piece::arc(Point::new(x, z), radius, start, sweep);
    let (face, start) = (0.5 * t, 0.5 * t + bead.shoulder);
    let top = start + bead.height + t;
    let groove = [
        line([end, face], [at + edge, face]),
        arc(at + edge, start, bead.shoulder, -FRAC_PI_2, -FRAC_PI_2),
        line([at + wall, start], [at + wall, top]),
        line([at + wall, top], [at - wall, top]),
        line([at - wall, top], [at - wall, start]),
        arc(at - edge, start, bead.shoulder, 0.0, -FRAC_PI_2),
        line([at - edge, face], [0.0, face]),
    ];
    let (foot, center) = (-face - bead.height, -face - bead.radius);
    let flank = center + bead.radius * turn.cos();
    let ridge = [
        line([0.0, foot], [at - half, foot]),
        line([at - half, foot], [at - half, flank]),
        arc(at, center, bead.radius, FRAC_PI_2 + turn, -2.0 * turn),
        line([at + half, flank], [at + half, foot]),
        line([at + half, foot], [end, foot]),
    ];
    [&groove[..], &ridge].map(|pieces| {
        let pieces = pieces.iter().filter(|piece| piece.length() > 1e-7 * bead.radius);
        Profile::new(pieces.copied().collect()).expect("a connected chain")
    })
}

/// Groove of the die and closed bead of the holder at a flat sheet, of each bead of a model that is given by its section.
pub fn shapes(model: &Model) -> impl Iterator<Item = [Profile; 2]> {
    let t = model.blank.thickness;
    model.beads.iter().filter_map(|bead| Some((bead.at, bead.round?))).map(move |(at, round)| {
        let [groove, ridge] = sections(&round, t, at, at + 2.0 * widths(&round, t).1[2]);
        [groove, ridge.shifted(round.height)].map(|all| {
            let pieces = all.pieces();
            Profile::new(pieces[1..pieces.len() - 1].to_vec()).expect("a part of a chain")
        })
    })
}

/// Penetration of a closed bead \[mm\]: its height, less what holder and die are more than one thickness apart.
fn penetration(case: &Model, bead: &Round) -> f64 {
    let apart = match case.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Gap(gap)) => *gap,
        _ => APART * case.blank.thickness,
    };
    bead.height + case.blank.thickness - apart
}

/// Solves the closed bead at `at` \[mm\] of a case: its line restraint, the largest force that closes it \[N/mm\], and a sentence.
/// Fails with mistake and remedy of a bead that does not fit, or, then true, in which the strip's run stops.
pub fn closed(case: &Model, bead: &Round, at: f64) -> Result<(Bead, f64, String), (String, &'static str, bool)> {
    let (t, end, way) = (case.blank.thickness, case.blank.length, penetration(case, bead));
    let (flat, half) = (case.tool(Role::Die).map_or(0.0, shoulder_end), widths(bead, t).1[2]);
    let [groove, ridge] = sections(bead, t, at, at + 2.0 * half);
    let room = rounded(ridge.distance_to(&groove, Point::new(0.0, way)).0);
    let refused = |what: String, help| Err((what, help, false));
    if bead.radius.min(bead.shoulder) < t {
        return refused(format!("a radius is less than the sheet's thickness, {t} mm"), "check the unit");
    } else if at - half < flat || at + half > end {
        let groove = format!("the groove reaches from {} to {} mm", rounded(at - half), rounded(at + half));
        return refused(format!("{groove}, the flange from {flat:.3} to {end} mm"), "smaller radii, or another place");
    } else if way < 0.01 * t {
        return refused("the holder stays too far off".into(), "a higher bead, or a smaller gap of the holder");
    } else if room < 0.999 * t {
        return refused(format!("{room} mm between bead and groove are less than {t} mm"), "a larger clearance");
    }
    let drawn = solve(case, bead, at, way).map_err(|stop| {
        let what = format!("no strip comes through the bead at {at} mm: {stop}");
        (what, "a lower bead, larger radii, more clearance or less friction", true)
    })?;
    let forces = [drawn.restraining, drawn.uplift, drawn.closing.max(drawn.uplift)];
    let [force, closing, shut] = forces.map(|force| significant(force, 3));
    let (closes, thinning) =
        (format!("{shut} N/mm close it, {closing} N/mm keep it so"), Amount::share(drawn.thinning));
    let pulled = format!("as a strip that is pulled through it; its thinning by {thinning} is left out");
    let line = Bead { at, restraining: force.into(), closing, round: Some(*bead) };
    Ok((line, shut, format!("the bead at {at} mm restrains by {force} N/mm; {closes}, {pulled}")))
}

/// Closing of a bead of a case at `place` by `way`, and the pull through it \[mm\], of a strip of the case's sheet: elastic where its
/// constants are known, with the case's back-stresses, else by the flow law.
pub fn stages(case: &Model, bead: &Round, place: f64, way: f64) -> [Stage; 2] {
    let (t, half) = (case.blank.thickness, widths(bead, case.blank.thickness).1[2]);
    let pull = PULLED * 2.0 * half.hypot(bead.height);
    let at = t * (1.0 + FLATS) + half + 2.0 * bead.height + pull;
    let end = at + half + FLATS * t;
    let is_elastic = case.material.elastic.is_some() && case.material.gtn.is_none();
    let size = (FRAC_PI_2 / PER_QUARTER * bead.radius.min(bead.shoulder)).min(LONGEST * t);
    let elements = (((end - t) / size).ceil() as usize).min(ELEMENTS);
    let (layers, rule) = if is_elastic { ELASTIC } else { FLOWING };
    let (grading, edge) = (Grading::Uniform, Edge::Clamped);
    let blank = Blank { hole: t, elements, grading, layers, rule, edge, ..Blank::new(end, t) };
    let friction = |role| case.tool(role).or(case.tool(Role::Die)).map_or(0.0.into(), |tool| tool.friction);
    let tool = |role, profile, motion| Tool { role, profile, friction: friction(role), motion };
    let [die, holder] = sections(bead, t, at, end + 2.0 * pull);
    let closes = Motion::Path(Point::new(0.0, way));
    let tools = vec![tool(Role::Die, die, Motion::Fixed), tool(Role::Holder, holder, closes)];
    let model = Model {
        geometry: Geometry::PlaneStrain,
        mode: if is_elastic { Mode::ElastoViscoplastic } else { Mode::Flow },
        // The strain bounds the steps.
        settings: Settings { max_step: 0.03, ..Settings::default() },
        heat: case.heat.as_ref().map(|heat| Heat { initial: heat.initial.at(place).into(), flow: None }),
        timed: case.timed,
        ..Model::new(blank, case.material.clone(), tools, way)
    };
    let mut pulled = Model { travel: pull, ..model.clone() };
    (pulled.blank.edge, pulled.tools[1].motion) = (Edge::Pulled { speed: 1.0 }, Motion::Fixed);
    [model, pulled].map(|model| {
        let duration = model.travel / case.speed;
        let model = Model { speed: case.speed, duration, frames: vec![duration], ..model };
        Stage { name: String::new(), model, begin: Default::default() }
    })
}

/// Forces and thinning of both stages of the strip of a bead at `at` \[mm\].
/// Fails with the end of the stage that did not come to its own.
pub fn drawn(bead: &Round, at: f64, solved: &[StageSolution]) -> Result<Drawn, Stop> {
    if let Some(early) = solved.iter().find(|stage| !stage.stop.is_complete()) {
        return Err(early.stop.clone());
    }
    let [closing, pull] = [&solved[0], &solved[solved.len() - 1]];
    let (t, end, halves) = (pull.model.blank.thickness, &pull.end, pull.model.extent().times());
    let steady = pull.steps.partition_point(|step| step.travel < BEFORE * pull.model.travel);
    let (first, last) = (pull.steps[steady - 1], pull.steps[pull.steps.len() - 1]);
    let length = halves * (last.travel - first.travel);
    let uplift = pull.steps[steady - 1..].windows(2).map(|w| w[1].holder_force * (w[1].travel - w[0].travel));
    let half = widths(bead, t).1[2];
    let center = pull.model.blank.length - half - FLATS * t;
    let has_passed = |e: &usize| end.middle(*e) < center - half && end.nodes[*e][0] > center + half;
    let passed: Vec<f64> = (0..end.thickness.len()).filter(has_passed).map(|e| end.thickness[e]).collect();
    let (restraining, uplift) = ((last.work.external - first.work.external) / length, uplift.sum::<f64>() / length);
    let thinning = 1.0 - passed.iter().sum::<f64>() / (t * passed.len() as f64);
    let penetration = closing.model.travel;
    let closing = closing.steps.last().map_or(0.0, |step| step.holder_force / halves);
    Ok(Drawn { at, penetration, closing, restraining, uplift, thinning })
}

/// Solves the strip of a bead of a case at `at` that is closed by `way` \[mm\], the same strip once.
fn solve(case: &Model, bead: &Round, at: f64, way: f64) -> Result<Drawn, Stop> {
    type Solved = ([Stage; 2], Result<Drawn, Stop>);
    static SOLVED: Mutex<Vec<Solved>> = Mutex::new(Vec::new());
    let all = || SOLVED.lock().unwrap_or_else(PoisonError::into_inner);
    let stages = stages(case, bead, at, way);
    if let Some((_, known)) = all().iter().find(|(strip, _)| *strip == stages) {
        return known.clone().map(|drawn| Drawn { at, ..drawn });
    }
    let drawn = drawn(bead, at, &crate::solver::solve(&stages, &mut ()));
    all().insert(0, (stages, drawn.clone()));
    all().truncate(REMEMBERED);
    drawn
}

/// Forces and thinning over the penetration of the beads of a case that are given by their section; `None` without any.
pub fn table(case: &Model) -> Option<Table> {
    let rounds = case.beads.iter().filter_map(|bead| Some((bead.at, bead.round?)));
    let strips = rounds.flat_map(|(at, round)| [0.25, 0.5, 0.75, 1.0].map(|share| (at, round, share)));
    let rows = strips.filter_map(|(at, round, share)| solve(case, &round, at, share * penetration(case, &round)).ok());
    let rows: Vec<Drawn> = rows.collect();
    rows.first()?;
    Some(Table::new(FIELDS.iter().map(|field| field.column(case.extent(), &rows)).collect()))
}
