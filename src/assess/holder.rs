//! Holder: force, lift, distance blocks, closing over a bead that is drawn in the sections of holder and die.

use super::estimate::{held_from, holder_pressure, tensile_strength};
use super::{Finding, Light, Run, material};
use crate::geometry::Arc;
use crate::measure::rests_on_blocks;
use crate::model::tool_sizes::{flat_level, shoulder_end};
use crate::model::{Geometry, Model, Motion, Role, Tool};
use crate::solver::closing_way;
use crate::solver::solution::{StageSolution, StepRecord};
use crate::units::Amount;

/// Lift over the thickness that is reported, and at which the flange is no longer held \[–\].
const LIFTED: f64 = 0.3;
const OFF: f64 = 1.0;
/// Gap over the thickness that a holder may keep \[–\]: thickening of a flange that is drawn.
const OPEN: f64 = 0.1;
/// Width of a flange that no longer buckles as it runs out over the shoulder, its rim tilting, over the thickness \[–\].
const RUN_OUT: f64 = 2.0 * StepRecord::RIM;
/// Normal pressure over the tensile strength that a shell, which yields without one, can overlook \[–\].
const PRESSURE: f64 = 0.1;
/// Share of the holder's force on the rim alone from which it is reported \[–\].
const RIM_SHARE: f64 = 0.9;
/// Share of the travel from which resting on the blocks is reported \[–\].
const RESTS: f64 = 0.1;

/// True if a pressed tool acts, or does not.
fn is_pressed(tool: &Tool, acts: bool) -> bool {
    matches!(&tool.motion, Motion::Pressed(press) if press.is_idle() != acts)
}

pub(super) fn idle(model: &Model) -> Option<Finding> {
    let text = "the holder has no force and takes no part: the flange may swing up through where it is drawn";
    let warning = Finding::warning("holder_force", "Holder", text).number(Amount::count(0.0)).limit("above 0");
    model.tools.iter().any(|tool| is_pressed(tool, false)).then_some(warning)
}

/// Holder pressure above the strength of the sheet, unless the hardening law is to blame.
pub(super) fn crushing(model: &Model) -> Option<Finding> {
    let strength = tensile_strength(&model.material);
    let pressure = holder_pressure(model).filter(|_| !material::is_weak(model))?;
    let limit = Amount::stress(strength);
    let text = format!("the holder presses with {{}}, more than the sheet's tensile strength of {limit}");
    let warning = Finding::warning("holder_pressure", "Holder pressure", text).number(Amount::stress(pressure));
    warning.at_most(limit, strength, None).advice("check its force").if_beyond()
}

/// Lift of a pressed holder until the flange runs out, six thicknesses wide \[mm\]. A narrower flange no longer buckles,
/// and its rim tilts as it goes over the shoulder.
pub fn holder_lift(stage: &StageSolution) -> Option<f64> {
    let model = &stage.model;
    model.tool(Role::Holder).filter(|holder| is_pressed(holder, true) && model.release.is_none())?;
    let width = model.blank.length - held_from(model)?;
    let held = stage.steps.iter().filter(|step| width - step.draw_in > RUN_OUT * model.blank.thickness);
    // A holder that has closed over a bead is lifted from there.
    let closed = stage.closing.map_or(0.0, |closing| closing.way - closing.gap);
    Some(held.map(|step| closed - step.holder_move).fold(0.0, f64::max))
}

/// Lift of the holder until the flange runs out, its first pressure, and whether the rim takes nearly all of its force.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let model = &first.model;
    let thickness = model.blank.thickness;
    let lift = holder_lift(first)?;
    let judged = |text: String| Finding::judged("holder", "Holder", text);
    if let Some(open) = if_open(first, judged("not judged: it stands open by {} on its bead".into())) {
        return Some(open.limit("closed on the sheet"));
    }
    let last = first.steps.iter().rev().find(|step| step.holder_force > 0.0)?;
    let (pressure, strength) = (holder_pressure(model).unwrap_or(0.0), tensile_strength(&model.material));
    let presses = pressure > PRESSURE * strength;
    let mut text = format!("lifted by {{}} at most; presses with {} at first", Amount::stress(pressure));
    if last.rim_share > RIM_SHARE {
        text += &format!("; at the end it sits on the outer {} only", Amount::size(StepRecord::RIM * thickness));
    }
    let [lifted, off] = [LIFTED, OFF].map(|times| Amount::thickness(times * thickness));
    let limit = format!("lifted by {lifted}, red above {off}; {}", Amount::stress(PRESSURE * strength));
    let judged = judged(run.of_stage(text, 0)).number(Amount::thickness(lift));
    let judged = judged.at_most(limit, LIFTED * thickness, OFF * thickness);
    let light = judged.light.max(if presses { Light::Amber } else { Light::Green });
    Some(judged.light(light).advice(match presses {
        false => "more holder force; a larger die shoulder raises the flange less",
        true => "less holder force: the flange is squeezed thinner",
    }))
}

pub(super) fn lifted(stage: &StageSolution) -> Option<Finding> {
    let text = "the holder is lifted by {} at most: the flange thickens or rises under it";
    let warning = Finding::warning("holder_lift", "Holder", text).number(Amount::thickness(holder_lift(stage)?));
    let most = LIFTED * stage.model.blank.thickness;
    warning.at_most(Amount::thickness(most), most, None).if_beyond()
}

/// Holder that rests on its distance blocks, where it presses no sheet, for a large part of the travel.
pub(super) fn rests(stage: &StageSolution) -> Option<Finding> {
    let (mut longest, mut from) = ([0.0; 2], 0.0);
    for record in &stage.steps {
        from = if rests_on_blocks(record) { from } else { record.travel };
        if record.travel - from > longest[1] - longest[0] {
            longest = [from, record.travel];
        }
    }
    let [begin, end] = longest.map(Amount::place);
    let text =
        format!("the holder rests on its distance blocks from {begin} to {end} of travel, and does not hold the sheet");
    Finding::warning("holder_rests", "Distance blocks", text)
        .number(Amount::place(longest[1] - longest[0]))
        .at_most(format!("{} of the travel", Amount::given_share(RESTS)), RESTS * stage.model.travel, None)
        .if_beyond()
}

pub(super) fn lost(stage: &StageSolution) -> Option<Finding> {
    let mut tools = stage.model.tools.iter().zip(&stage.left_at);
    let (tool, travel) = tools.find_map(|(tool, left)| Some((tool.role.name(), (*left)?)))?;
    let text = format!("the sheet left the {tool} at {{}} of travel; the {tool} stands still from there on");
    let warning = Finding::warning("holder_lost", "Holder", text).number(Amount::place(travel));
    Some(warning.at_least("the whole travel", stage.model.travel, None))
}

pub(super) fn closes(model: &Model) -> Option<Finding> {
    let text = "holder and die do not lie flat on the sheet: the holder closes over it by {} before the punch comes";
    Some(Finding::assumed(text).number(Amount::place(closing_way(model)?)))
}

pub(super) fn stays_open(stage: &StageSolution) -> Option<Finding> {
    let force = Amount::force(stage.closing?.force, stage.model.extent().force_unit());
    let text = format!("the holder did not close: with {force} it stands open by {{}} when the draw begins");
    let warning = if_open(stage, Finding::warning("holder_open", "Holder", text))?;
    Some(warning.light(Light::Amber).limit(format!("open by at most {} t", Amount::number(OPEN))))
}

/// A finding on a holder that stands too far open when the draw begins, with its gap; grey, for nothing else is judged then.
pub(super) fn if_open(stage: &StageSolution, finding: Finding) -> Option<Finding> {
    let gap = stage.closing?.gap;
    (gap > OPEN * stage.model.blank.thickness).then(|| {
        let more = "more holder force, until it closes";
        let advice = match DrawnBead::of(&stage.model) {
            Some(bead) => format!("{more}; or a flat holder and die with the bead as a line: {}", bead.line()),
            None => more.into(),
        };
        finding.number(Amount::thickness(gap)).light(Light::Grey).advice(advice)
    })
}

pub(super) fn bead(model: &Model) -> Option<Finding> {
    let bead = DrawnBead::of(model).filter(|_| closing_way(model).is_some())?;
    let around = match model.geometry {
        Geometry::Axisymmetric => "from the axis",
        Geometry::PlaneStrain => "from the symmetry plane",
    };
    let text =
        format!("the bead {{}} {around} closes with the holder; as a line on flat tools it would be {}", bead.line());
    Some(Finding::assumed(text).number(Amount::place(bead.at)))
}

/// Height of a bead over the flat, over the thickness \[–\].
const STANDS_OUT: f64 = 0.25;
/// Effective stress and strain of plane strain over those of tension \[–\]: 2/√3.
const PLANE: f64 = 1.154_700_538_379_251_7;

struct DrawnBead {
    /// Distance of its tip from the axis or symmetry plane \[mm\].
    at: f64,
    /// Estimated restraining force when closed, per length of its line \[N/mm\].
    restraining: f64,
}

impl DrawnBead {
    /// Bead of the tool that stands out of its flat towards the sheet, on the die's flange.
    ///
    /// The force is that of the work of plane bending and unbending over each convex corner of both tools on the flange, from
    /// the edge inward, with the friction around it; the sheet hardens from each to the next, its thickness stays:
    ///
    /// ```text
    /// T ← (T + M/ρ) exp(μθ) + M/ρ,   M = 2/√3 σ t²/4,   ρ = R + t/2,   Δε = 2/√3 t/(4ρ) by each of the two
    /// ```
    ///
    /// Closed, the sheet goes round all of each corner. Declared: an elementary estimate, tried against the solver's own bead.
    fn of(model: &Model) -> Option<Self> {
        let (holder, die) = (model.tool(Role::Holder)?, model.tool(Role::Die)?);
        let from = shoulder_end(die);
        let within = |x: f64| x > from && x < model.blank.length;
        let at = tip(holder, 1.0, within, model).or_else(|| tip(die, -1.0, within, model))?;
        let on_flange = |arc: &Arc| within(arc.center.x) && within(arc.at(0.0).x.min(arc.at(1.0).x));
        let bends = [holder, die].into_iter().flat_map(|tool| {
            tool.profile.corners().filter(on_flange).map(|arc| (arc, tool.friction.largest_coefficient()))
        });
        let mut bends: Vec<(Arc, f64)> = bends.collect();
        bends.sort_by(|a, b| b.0.center.x.total_cmp(&a.0.center.x));
        let t = model.blank.thickness;
        let (mut restraining, mut strain) = (0.0, 0.0);
        for (arc, friction) in bends {
            let rho = arc.radius + 0.5 * t;
            let mut bent = || {
                let step = PLANE * t / (4.0 * rho);
                strain += step;
                PLANE * model.material.hardening.at(strain - 0.5 * step).stress * t * t / (4.0 * rho)
            };
            restraining = (restraining + bent()) * (friction * arc.sweep.abs()).exp() + bent();
        }
        Some(Self { at, restraining })
    }

    fn line(&self) -> String {
        format!(
            "[[tools.beads]] at = \"{}\", restraining = \"{} N/mm\" (declared: the work of bending over its radii)",
            Amount::place(self.at),
            Amount::number(self.restraining.round())
        )
    }
}

/// Tip of a bead \[mm\]; `up` is +1 for a tool below the sheet.
fn tip(tool: &Tool, up: f64, within: impl Fn(f64) -> bool, model: &Model) -> Option<f64> {
    let level = up * flat_level(tool)?;
    let points = tool.profile.polyline(0.01).into_iter().filter(|p| within(p.x));
    let tip = points.max_by(|a, b| (up * a.y).total_cmp(&(up * b.y)))?;
    (up * tip.y > level + STANDS_OUT * model.blank.thickness).then_some(tip.x)
}
