//! What a bent section does when its tools are taken away, and what compensates it.

use super::{Finding, Light, run::Run};
use crate::case::Springback;
use crate::measure::{Change, EDGE, FLANGE_ANGLE, OPENING_ANGLE, Quantity, Shape, changes};
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
        return Some(grey(why.to_owned(), advice.to_owned()));
    };
    let changes = changes(&Shape::of(before), &Shape::of(after));
    let judged: Vec<Judged> = limits.of(&changes).collect();
    if judged.is_empty() {
        let angles = changes.iter().filter(|change| change.quantity.unit == Unit::Degree);
        let said: Vec<String> = angles.map(|change| format!("{} {}", change.quantity.label, change.text())).collect();
        let over = changes.iter().filter_map(|change| overbend(change, change.before?));
        let over: Vec<String> = over.collect();
        let advice = format!("[springback] with the part's tolerance{}", compensated(&over));
        return (!said.is_empty()).then(|| grey(said.join(", "), advice));
    }
    let worst = judged.iter().max_by(|a, b| a.used().total_cmp(&b.used()))?;
    let found: Vec<String> = judged.iter().map(Judged::found).collect();
    let bounds: Vec<String> = judged.iter().map(Judged::limit).collect();
    let over: Vec<String> = judged.iter().filter_map(|judged| overbend(&judged.change, judged.wanted)).collect();
    let tension = "more tension in the walls (holder force, beads) and smaller radii spring back less";
    Some(
        Finding::judged("springback", "Spring-back", Light::of(worst.used(), [NEAR, 1.0]), found.join("; "))
            .against(worst.missed(), worst.change.quantity.unit, bounds.join("; "))
            .source("the part's tolerance, [springback]; near it from 80 % on, a declared rule of thumb")
            .advice(format!("{tension}{}", compensated(&over))),
    )
}

fn grey(found: String, advice: String) -> Finding {
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
    fn found(&self) -> String {
        let quantity = self.change.quantity;
        format!("{} {}, off by {}", quantity.label, self.change.text(), quantity.signed(self.missed()))
    }

    /// `90.0° ± 1.0°`.
    fn limit(&self) -> String {
        let quantity = self.change.quantity;
        format!("{} ± {}", quantity.text(self.wanted), quantity.text(self.tolerance))
    }
}

/// The angle under the tools that leaves the wanted one, to the first order: as much further as it springs back from where it
/// is now. `None` of what is no angle of a tool.
fn overbend(change: &Change, wanted: f64) -> Option<String> {
    let quantity = change.quantity;
    let back = change.change().filter(|_| [OPENING_ANGLE.key, FLANGE_ANGLE.key].contains(&quantity.key))?;
    let label = quantity.label.to_lowercase();
    Some(format!("{label} {} (over-bent by {})", quantity.text(wanted - back), quantity.text(back.abs())))
}

/// `; or tools that bend to an opening angle ...`; nothing where there is no angle.
fn compensated(over: &[String]) -> String {
    if over.is_empty() {
        return String::new();
    }
    format!(
        "; or over-bend under the tools to {}, a first estimate that takes the spring-back as it is now: run again, and go on by \
         what is left",
        over.join(", ")
    )
}
