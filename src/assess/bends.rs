//! Bends: radii of tools and of the formed sheet over its thickness.

use super::design::{SHARP, THIN, bent_strength};
use super::tear::nose;
use super::{Finding, Run};
use crate::geometry::{Arc, CORNER, Point};
use crate::model::tool_sizes::extent;
use crate::model::{Model, Role, Theory, Tool};
use crate::solver::solution::StageSolution;
use crate::units::{Amount, Digits};

/// For sharp bends. A shell's normal stress is of second order in t/R, and only if the whole section is stretched.
const ADVICE: &str = "take larger radii; below 5 t strains and spring-back are computed only roughly";

pub(super) fn tool_radius(model: &Model, tool: &Tool) -> Option<Finding> {
    let smallest = tool.profile.corners().min_by(|a, b| a.radius.total_cmp(&b.radius))?;
    let why = match model.blank.theory {
        Theory::Bending | Theory::Selective => "beyond thin-shell theory",
        Theory::Membrane => "bending, which membrane theory leaves out, matters there",
    };
    let text = format!("the {}'s radius of {} is {{}}: {why}", tool.role.name(), Amount::size(smallest.radius));
    let ratio = Amount::thicknesses(smallest.radius / model.blank.thickness);
    Finding::warning("tool_radius", "Tool radius", text).number(ratio).at_least(THIN, None).if_beyond()
}

pub(super) fn radius(run: &Run) -> Option<Finding> {
    let sharpest = run.largest(|step| step.sharpest_bend).filter(|sharpest| *sharpest > 0.0)?;
    let judged = Finding::judged("bend_radius", "Bending radius", "{} at the sharpest bend");
    let judged = judged.number(Amount::thicknesses(1.0 / sharpest)).at_least(THIN, SHARP);
    Some(judged.source("thin-shell theory; the numbers are declared rules of thumb").advice(ADVICE))
}

/// Strength that the sheet keeps over the sharpest of punch noses and die shoulders.
///
/// # References
/// 4ming, Forming handbook, "Punch radius", equation 1 (4ming.de/en/forming-handbook/punch-radius): the nose ≥ 4 to 5
/// thicknesses. For the shoulder, and [`SHARP`], a declared rule of thumb; the strength is derived at [`bent_strength`].
pub(super) fn strength(run: &Run) -> Option<Finding> {
    let corners = run.stages.iter().enumerate().flat_map(|(stage, solved)| {
        corners(solved).map(move |(name, arc)| (name, arc.radius, arc.radius / solved.model.blank.thickness, stage))
    });
    let (name, radius, ratio, stage) = corners.min_by(|a, b| a.2.total_cmp(&b.2))?;
    let (radius, times) = (Amount::size(radius), Amount::thicknesses(ratio));
    let text = format!("the {name} of {radius} is {times}: the sheet keeps {{}} of its strength there");
    let [wanted, least] = [THIN, SHARP].map(bent_strength);
    let ([thin, sharp], share) = ([THIN, SHARP].map(Amount::given_thicknesses), Amount::share(wanted));
    Finding::judged("bent_strength", "Strength over radii", run.of_stage(text, stage))
        .number(Amount::share(bent_strength(ratio)))
        .at_least(100.0 * wanted, 100.0 * least)
        .limit(format!("{share} = ρ ln(1 + 1/ρ) at ρ = {thin}, red below {sharp}"))
        .source("4ming, Forming handbook, Punch radius: 4 to 5 thicknesses; the share: equilibrium of a bent strip")
        .advice(ADVICE)
        .into()
}

fn corners(solved: &StageSolution) -> impl Iterator<Item = (&'static str, Arc)> {
    let model = &solved.model;
    let forms = model.release.is_none() && !solved.steps.is_empty();
    let shoulder = |die: &Tool| die.profile.corners().max_by(|a, b| a.center.x.total_cmp(&b.center.x));
    let tool = |role| model.tool(role).filter(|_| forms);
    let nose = tool(Role::Punch).and_then(nose).map(|arc| ("punch's nose", arc));
    nose.into_iter().chain(tool(Role::Die).and_then(shoulder).map(|arc| ("die's shoulder", arc)))
}

pub(super) fn sharp_corner(model: &Model, tool: &Tool) -> Option<Finding> {
    let is_met = |at: Point| reaches(model, tool, at);
    let sharp: Vec<_> = tool.profile.vertices().filter(|v| v.turn.abs() > CORNER && is_met(v.point)).collect();
    let first = sharp.first()?;
    let others = if sharp.len() > 1 { format!(" and at {} more", sharp.len() - 1) } else { String::new() };
    let [r, z] = [first.point.x, first.point.y].map(Amount::size);
    let text = format!(
        "the {}'s profile has a sharp corner, radius 0, of {{}} at r = {r}, z = {z} (as placed, z = 0 is the flat sheet's \
         middle){others}: no sheet can follow it",
        tool.role.name()
    );
    Finding::warning("sharp_corner", "Sharp corner", text)
        .number(Amount::angle(first.turn.abs().to_degrees()).to(Digits::Given(1)))
        .at_most(CORNER.to_degrees(), None)
        .advice("draw an arc, or give `fillet`")
        .source("the radius that a shell follows")
        .into()
}

fn reaches(model: &Model, tool: &Tool, at: Point) -> bool {
    let within_blank = at.x < model.blank.length;
    match tool.role {
        // Deeper than the travel it stays below the sheet.
        Role::Punch => {
            let top = tool.profile.extreme(true, model.blank.length).map_or(0.0, |top| top.y);
            within_blank && at.y > top - model.travel
        }
        Role::Die => within_blank,
        // The sheet goes up and away from a holder's inner edge.
        Role::Holder => within_blank && at.x > extent(tool).0 + model.blank.thickness,
    }
}
