//! What a bent section does when its tools are taken away, and what compensates it.

use super::{Finding, Light, run::Run};
use crate::case::Springback;
use crate::measure::{Change, EDGE, FLANGE_ANGLE, OPENING_ANGLE, Quantity, Shape, changes};
use crate::message::{Message, message};
use crate::model::{Geometry, Mode, Role};
use crate::table::Unit;

/// Share of a tolerance above which the scatter of sheet and process may use the rest: from coil to coil spring-back varies by
/// a fifth and more \[–\].
const NEAR: f64 = 0.8;

/// A quantity of the released part against what is wanted.
struct Judged {
    change: Change,
    wanted: f64,
    /// After less wanted, in the unit of the quantity.
    missed: f64,
    tolerance: f64,
}

/// The part after a stage that takes the tools away, against its tolerances where the case names them; and of a section in
/// plane strain by the flow law, that nothing springs back.
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
            "[material] mode = \"elasto_viscoplastic\" with young and poisson, and a stage with release = true";
        return Some(grey(why, advice));
    };
    let changes = changes(&Shape::of(before), &Shape::of(after));
    let judged: Vec<Judged> = limits.of(&changes).collect();
    if judged.is_empty() {
        return unjudged(limits, &changes);
    }
    let worst = judged.iter().max_by(|a, b| a.used().total_cmp(&b.used()))?;
    let over = judged.iter().filter_map(|judged| overbend(&judged.change, judged.wanted));
    let less = match run.case.model().tool(Role::Holder) {
        Some(_) => "more tension in the walls (holder force, beads) and smaller radii spring back less",
        None => "a smaller radius springs back less",
    };
    Some(
        Finding::judged(
            "springback",
            "Spring-back",
            Light::of(worst.used(), [NEAR, 1.0]),
            Message::joined(judged.iter().map(Judged::found), "; "),
        )
        .against(
            worst.missed.abs(),
            worst.change.quantity.unit,
            Message::joined(judged.iter().map(Judged::limit), "; "),
        )
        .at_most(NEAR * worst.tolerance, worst.tolerance)
        .source("the part's tolerance, [springback]; near it from 80 % on, a declared rule of thumb")
        .advice(Message::joined([less.into(), compensated(over)], "; ")),
    )
}

/// What cannot be held against a tolerance: none is given, or nothing was found to measure.
fn unjudged(limits: &Springback, changes: &[Change]) -> Option<Finding> {
    if limits.is_given() {
        let advice = "a bend by ten degrees or more, and a straight leg behind it that can be measured";
        return Some(grey("no angle was found to measure", advice));
    }
    let angles = changes.iter().filter(|change| change.quantity.unit == Unit::Degree);
    let said = Message::joined(angles.map(|change| change.quantity.named(change.told())), ", ");
    let over = changes.iter().filter_map(|change| overbend(change, change.before?));
    let advice = Message::joined(["[springback] with the part's tolerance".into(), compensated(over)], "; ");
    (!said.is_empty()).then(|| grey(said, advice))
}

fn grey(found: impl Into<Message>, advice: impl Into<Message>) -> Finding {
    Finding::judged("springback", "Spring-back", Light::Grey, found)
        .limit("the part's tolerance, not in the case")
        .advice(advice)
}

impl Springback {
    /// What is judged of what was measured.
    fn of<'a>(&'a self, changes: &'a [Change]) -> impl Iterator<Item = Judged> + 'a {
        let limits: [(Quantity, Option<f64>, Option<f64>); 3] = [
            (OPENING_ANGLE, self.angle, self.tolerance),
            (FLANGE_ANGLE, None, self.flange_tolerance),
            (EDGE, None, self.edge_tolerance),
        ];
        limits.into_iter().filter_map(|(quantity, wanted, tolerance)| {
            let change = *changes.iter().find(|change| change.quantity.key == quantity.key)?;
            let after = change.after?;
            let wanted = wanted.or(change.before)?;
            Some(Judged { change, wanted, missed: after - wanted, tolerance: tolerance? })
        })
    }
}

impl Judged {
    /// Share of the tolerance \[–\].
    fn used(&self) -> f64 {
        self.missed.abs() / self.tolerance
    }

    /// `Opening angle 90.0° → 94.9°, off by +4.9°`.
    fn found(&self) -> Message {
        let quantity = self.change.quantity;
        let by = quantity.signed(self.missed);
        quantity.named(message!("{change}, off by {by}", change = self.change.told(), by = by))
    }

    /// `90.0° ± 1.0°`.
    fn limit(&self) -> Message {
        let quantity = self.change.quantity;
        let (wanted, tolerance) = (quantity.told(self.wanted), quantity.told(self.tolerance));
        message!("{wanted} ± {tolerance}", wanted = wanted, tolerance = tolerance)
    }
}

/// The angle under the tools that leaves the wanted one, to the first order: as much further as it springs back from where it
/// is now. `None` of what is no angle of a tool.
fn overbend(change: &Change, wanted: f64) -> Option<Message> {
    let quantity = change.quantity;
    let back = change.change().filter(|_| [OPENING_ANGLE.key, FLANGE_ANGLE.key].contains(&quantity.key))?;
    let (angle, by) = (quantity.told(wanted - back), quantity.told(back.abs()));
    Some(quantity.named(message!("{angle}, over-bent by {by}", angle = angle, by = by)))
}

/// Nothing where there is no angle.
fn compensated(over: impl Iterator<Item = Message>) -> Message {
    let over = Message::joined(over, "; ");
    if over.is_empty() {
        return over;
    }
    message!(
        "or tools that over-bend ({over}), a first estimate with the spring-back as it is now: run again, and go on by what is \
         left",
        over = over
    )
}
