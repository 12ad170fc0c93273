//! What a bent section does when its tools are taken away, and what compensates it.

use super::{Finding, Light, run::Run};
use crate::case::Springback;
use crate::measure::{Change, EDGE, FLANGE_ANGLE, OPENING_ANGLE, Quantity, Shape, changes};
use crate::message::{Message, message};
use crate::model::{Geometry, Mode};
use crate::table::Unit;

/// Share of a tolerance above which the scatter of sheet and process may use the rest: from coil to coil spring-back varies by
/// a fifth and more \[–\].
const NEAR: f64 = 0.8;

/// A quantity of the released part against what is wanted.
struct Judged {
    change: Change,
    wanted: f64,
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
        return Some(grey(why.into(), advice.into()));
    };
    let changes = changes(&Shape::of(before), &Shape::of(after));
    let judged: Vec<Judged> = limits.of(&changes).collect();
    if judged.is_empty() {
        let angles = changes.iter().filter(|change| change.quantity.unit == Unit::Degree);
        let said =
            angles.map(|change| message!("{label} {change}", label = change.quantity.label, change = change.told()));
        let said = Message::joined(said, ", ");
        let over = changes.iter().filter_map(|change| overbend(change, change.before?));
        let advice = compensated("[springback] with the part's tolerance", over);
        return (!said.is_empty()).then(|| grey(said, advice));
    }
    let worst = judged.iter().max_by(|a, b| a.used().total_cmp(&b.used()))?;
    let found = Message::joined(judged.iter().map(Judged::found), "; ");
    let limit = Message::joined(judged.iter().map(Judged::limit), "; ");
    let over = judged.iter().filter_map(|judged| overbend(&judged.change, judged.wanted));
    let tension = "more tension in the walls (holder force, beads) and smaller radii spring back less";
    Some(
        Finding::judged("springback", "Spring-back", Light::of(worst.used(), [NEAR, 1.0]), found)
            .against(worst.missed().abs(), worst.change.quantity.unit, limit)
            .at_most(NEAR * worst.tolerance, worst.tolerance)
            .source("the part's tolerance, [springback]; near it from 80 % on, a declared rule of thumb")
            .advice(compensated(tension, over)),
    )
}

fn grey(found: Message, advice: Message) -> Finding {
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
            Some(Judged { change, wanted: wanted.or(change.before)?, tolerance: tolerance? }).filter(Judged::is_there)
        })
    }
}

impl Judged {
    fn is_there(&self) -> bool {
        self.change.after.is_some()
    }

    /// After less wanted, in the unit of the quantity.
    fn missed(&self) -> f64 {
        self.change.after.map_or(0.0, |after| after - self.wanted)
    }

    /// Share of the tolerance \[–\].
    fn used(&self) -> f64 {
        self.missed().abs() / self.tolerance
    }

    /// `Opening angle 90.0° → 94.9°, off by +4.9°`.
    fn found(&self) -> Message {
        let quantity = self.change.quantity;
        message!(
            "{label} {change}, off by {missed}",
            label = quantity.label,
            change = self.change.told(),
            missed = quantity.signed(self.missed())
        )
    }

    /// `90.0° ± 1.0°`.
    fn limit(&self) -> Message {
        let quantity = self.change.quantity;
        message!(
            "{wanted} ± {tolerance}",
            wanted = quantity.told(self.wanted),
            tolerance = quantity.told(self.tolerance)
        )
    }
}

/// The angle under the tools that leaves the wanted one, to the first order: as much further as it springs back from where it
/// is now. `None` of what is no angle of a tool.
fn overbend(change: &Change, wanted: f64) -> Option<Message> {
    let quantity = change.quantity;
    let back = change.change().filter(|_| [OPENING_ANGLE.key, FLANGE_ANGLE.key].contains(&quantity.key))?;
    Some(message!(
        "{label} {angle} (over-bent by {back})",
        label = quantity.label,
        angle = quantity.told(wanted - back),
        back = quantity.told(back.abs())
    ))
}

/// What to change, and the tools' angles that compensate the spring-back where there are any.
fn compensated(advice: &'static str, over: impl Iterator<Item = Message>) -> Message {
    let angles = Message::joined(over, ", ");
    if angles.is_empty() {
        return advice.into();
    }
    message!(
        "{advice}; or over-bend under the tools: {angles}, a first estimate that takes the spring-back as it is now: run again, \
         and go on by what is left",
        advice = advice,
        angles = angles
    )
}
