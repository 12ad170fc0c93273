//! Spring-back against tolerances.

use super::*;
use crate::case::Springback;
use crate::material::chaboche::shifting;
use crate::measure::{Change, EDGE, FLANGE_ANGLE, OPENING_ANGLE, Shape, WALL_ANGLE, changes};

/// Share of a tolerance that leaves room for scatter: from coil to coil spring-back varies by a fifth and more \[–\].
const NEAR: f64 = 0.8;
/// A wall that leans less from the punch's was drawn against it \[°\]; a strip bent in air leans by tens of degrees.
const BESIDE: f64 = 8.0;
const MEASURES: [&str; 4] = ["bottom_to_wall", "wall_to_flange", "curl_radius", FLANGE_ANGLE.key];

struct Judged<'a> {
    change: &'a Change,
    wanted: f64,
    /// True if the wanted angle is that of the punch's wall.
    of_punch: bool,
    /// After less wanted, in the unit of the quantity.
    missed: f64,
    tolerance: f64,
}

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let limits = &run.case.springback;
    let Some([before, after]) = last.released() else {
        let flows = last.model.geometry == Geometry::PlaneStrain && last.model.mode == Mode::Flow;
        let why = match flows {
            true => "not computed: the flow law has no elasticity",
            false if limits.is_given() => "not computed: no stage takes the tools away",
            false => return None,
        };
        let advice =
            "a stage with `release = true`, and [material] mode = \"elasto_viscoplastic\" with young and poisson";
        return Some(grey(why, advice));
    };
    let changes = changes(&Shape::of(before), &Shape::of(after));
    let wall = punch_wall(&last.model, &changes);
    let judged: Vec<Judged> = limits.judged(&changes, wall).collect();
    let Some(worst) = judged.iter().max_by(|a, b| a.used().total_cmp(&b.used())) else {
        return unjudged(limits, &changes);
    };
    let is_judged = |change: &&Change| judged.iter().any(|one| one.change.quantity.key == change.quantity.key);
    let others = MEASURES.iter().filter_map(|key| changes.iter().find(|change| change.quantity.key == *key));
    let others = others.filter(|change| !is_judged(change));
    let others = others.map(|change| format!("{} {change}", change.quantity.label));
    let mut limits: Vec<String> = judged.iter().map(Judged::limit).collect();
    limits.dedup();
    let is_isotropic = shifting(last.model.material.chaboche).is_none();
    let law = is_isotropic.then(|| "by isotropic hardening, no [[material.kinematic]]".to_owned());
    let texts = ["{} off".to_owned()].into_iter().chain(judged.iter().map(Judged::text)).chain(others).chain(law);
    let missed = Amount::new(worst.missed.abs(), worst.change.quantity.unit, Digits::Significant(3));
    let finding = Finding::judged("springback", "Spring-back", joined(texts, "; ")).number(missed);
    let finding = finding.at_most(NEAR * worst.tolerance, worst.tolerance).limit(joined(limits, "; "));
    let source = "the part's tolerance, [springback]; near it from 80 % on, a declared rule of thumb";
    Some(finding.source(source).advice(advice(run, &judged, wall)))
}

fn advice(run: &Run, judged: &[Judged], wall: Option<f64>) -> String {
    let is_held = run.case.model().tool(Role::Holder).is_some();
    let off = |keys: &[&str]| judged.iter().find(|one| keys.contains(&one.change.quantity.key) && one.used() > NEAR);
    let flange = off(&[FLANGE_ANGLE.key]);
    let about = if is_held { "stretch the wall straight by a bead that closes late" } else { "over-bend by runs" };
    let angle = |degrees: f64| Amount::new(degrees, Unit::Degree, Digits::Decimals(1));
    let search = format!("{about}: `stampflow search {} --for over-bend`", run.case.path.display());
    let slope = "slope the faces of die and holder the other way by";
    let Some(worst) = off(&[OPENING_ANGLE.key, WALL_ANGLE.key]) else {
        let turn = flange.map(|flange| flange.missed.abs());
        return turn.map_or(search, |turn| format!("{slope} {} (one step, not a run)", angle(turn)));
    };
    let walls = if worst.change.quantity.key == OPENING_ANGLE.key { 2.0 } else { 1.0 };
    let [tools, back] = [worst.change.before.unwrap_or_default(), worst.missed].map(|both| both / walls);
    let step = "one step, not a run: the tools' angle less the error";
    let walls = match wall {
        None => format!("over-bend to {} under the tools ({step}); or {search}", angle(walls * (tools - back))),
        Some(wall) => {
            let cam = if wall < back { ", past upright, so by a cam" } else { "" };
            let fixed = if worst.of_punch { "; first write the part's own [springback] angle" } else { "" };
            let [back, to] = [back, 90.0 + wall - back].map(angle);
            let lean = format!("lean punch and die walls back by {back}, to {to} from the bottom{cam} ({step}){fixed}");
            // A longer travel does not turn a wall that lies against the punch's, and a bead that is there had its search.
            if is_held && run.case.model().beads.is_empty() { joined([search, lean], "; or ") } else { lean }
        }
    };
    joined([walls].into_iter().chain(flange.map(|_| format!("then {slope} what is left of the flange's angle"))), "; ")
}

fn unjudged(limits: &Springback, changes: &[Change]) -> Option<Finding> {
    if limits.is_given() {
        let advice = "a bend by ten degrees or more, and a straight leg behind it that can be measured";
        return Some(grey("no angle was found to measure", advice));
    }
    let angles = changes.iter().filter(|change| change.quantity.unit == Unit::Degree);
    let text = joined(angles.map(|change| format!("{} {change}", change.quantity.label)), ", ");
    (!text.is_empty()).then(|| grey(text, "`[springback]` with the part's tolerance"))
}

fn grey(text: impl Into<String>, advice: &str) -> Finding {
    let judged = Finding::judged("springback", "Spring-back", text).light(Light::Grey);
    judged.limit("the part's tolerance, not in the case").advice(advice)
}

/// Angle of the punch's steepest straight wall to its direction \[°\], 0 upright, if the sheet's wall lies against it.
fn punch_wall(model: &Model, changes: &[Change]) -> Option<f64> {
    let sheet = changes.iter().find(|change| change.quantity.key == WALL_ANGLE.key)?.before?;
    let angles = model.tool(Role::Punch)?.profile.pieces().iter().filter_map(|piece| match piece {
        Piece::Segment(line) => {
            let along = line.to - line.from;
            Some((along.x.atan2(along.y.abs()) * -along.y.signum()).to_degrees())
        }
        Piece::Arc(_) => None,
    });
    angles.min_by(|a, b| a.abs().total_cmp(&b.abs())).filter(|angle| (angle - sheet).abs() < BESIDE)
}

impl Springback {
    /// Judged measures; `wall` is the angle of the punch's wall \[°\], from which its own target and that of both walls come.
    fn judged<'a>(&'a self, changes: &'a [Change], wall: Option<f64>) -> impl Iterator<Item = Judged<'a>> + 'a {
        let limits = [
            (OPENING_ANGLE, self.angle, wall.map(|angle| 2.0 * angle), self.tolerance),
            (WALL_ANGLE, self.angle.map(|angle| 0.5 * angle), wall, self.wall_tolerance),
            (FLANGE_ANGLE, self.flange_angle, None, self.flange_tolerance),
            (EDGE, None, None, self.edge_tolerance),
        ];
        limits.into_iter().filter_map(move |(quantity, given, of_punch, tolerance)| {
            let change = changes.iter().find(|change| change.quantity.key == quantity.key)?;
            let wanted = given.or(of_punch).or(change.before)?;
            let (missed, of_punch) = (change.after? - wanted, given.is_none() && of_punch.is_some());
            Some(Judged { change, wanted, of_punch, missed, tolerance: tolerance? })
        })
    }
}

impl Judged<'_> {
    /// Share of the tolerance \[–\].
    fn used(&self) -> f64 {
        self.missed.abs() / self.tolerance
    }

    fn text(&self) -> String {
        let quantity = self.change.quantity;
        let from = format!("{} {}", quantity.label, self.change);
        let share = match quantity.key {
            key if key == OPENING_ANGLE.key => 0.5,
            key if key == WALL_ANGLE.key => 1.0,
            _ => return from,
        };
        let Some(change) = self.change.change() else { return from };
        let verb = if change < 0.0 { "closes" } else { "opens" };
        format!("{from}, each wall {verb} by {}", quantity.difference_text(share * change.abs()))
    }

    fn limit(&self) -> String {
        let quantity = self.change.quantity;
        let of = if self.of_punch { " of the punch's wall" } else { "" };
        let [wanted, tolerance] = [self.wanted, self.tolerance].map(|given| quantity.difference_text(given));
        format!("{wanted} ± {tolerance}{of}")
    }
}
