//! Punches of a round part's draws, and the stages after the first.

use super::*;
use crate::writer::{recessed_punch, redraw::Ring};

impl Cup<'_> {
    /// Text of the stages after the first draw, with the holder's pressure of that \[MPa\].
    pub(super) fn redraws(&self, tools: &[Tools], pressure: f64) -> String {
        let (thickness, mut is_held, mut text) = (self.sheet.thickness, true, String::new());
        for (i, pair) in tools.windows(2).enumerate() {
            let [before, now] = [&pair[0], &pair[1]];
            let (gap, outer) = (throat(now.radius, &now.clearance), before.radius - 0.5 * thickness);
            let (throat, is_reverse) = (gap.value, self.inputs.is_on("reverse"));
            let widest = Picked::by(0.5 * (outer - throat), "half the width of the ring inside the cup");
            let narrow = is_reverse && now.shoulder.value > widest.value;
            let round = if narrow { &widest } else { &now.shoulder };
            let (shoulder, nose) = (round.value, before.nose.value);
            let ring = Ring { thickness, outer, nose, throat, shoulder, is_reverse };
            let mut stage = Values::default();
            let name = if i > 0 { format!("\"redraw-{}\"", i + 1) } else { "\"redraw\"".into() };
            let size = |length: f64, picked: &Picked| plain(length) + &picked.reason(", ");
            let why = format!("throat Ø {}; shoulder {}", size(2.0 * throat, &gap), size(shoulder, round));
            let given = [("name", name, ""), ("punch", now.punch.clone(), ""), ("die", ring.die(), why.as_str())];
            given.into_iter().for_each(|(name, value, why)| stage.set(name, value, why));
            stage.set("friction", rounded(self.inputs.value("friction")), "");
            stage.lengths([("move", &now.travel)]);
            let (bend, shape) = if is_reverse { ("lip", "lip by 180°") } else { ("cone", "cone of 40°") };
            stage.set(bend, shape, "");
            if self.inputs.is_on("anneal") {
                stage.set("anneal", true, "");
            }
            let has_sleeve = ring.has_room();
            if has_sleeve {
                stage.set("sleeve", ring.sleeve(4.0 * before.cup), "");
                let why = "the first holder's pressure on the sleeve's ring (declared)";
                stage.set("force", newtons(rounded_up(pressure * ring.area(), 3)), why);
            } else if is_reverse {
                stage.set("turn_over", true, "");
            } else {
                let (share, ratio) = (50.0 * thickness / before.radius, before.radius / now.radius);
                stage.set("unheld", format!("{share:.1} % of the diameter before, the redraw ratio {ratio:.2}"), "");
            }
            if is_held && !has_sleeve {
                stage.set("remove", "[\"holder\"]", "");
            }
            is_held = has_sleeve;
            text += &stage.fill(include_str!("../redraw_stage.toml"));
            text.push('\n');
        }
        text.trim_end().to_owned()
    }

    /// Punch of a draw; the last one has the bottom's shape, a recess's a hollow deeper by what the gap has over the sheet.
    pub(super) fn punch(&self, is_last: bool, radius: f64, nose: f64, gap: f64) -> String {
        let [wall, corner] = [radius, nose].map(mm);
        match (self.part.dome.map(mm), self.part.recess) {
            (Some(face), _) if is_last => format!("crowned = {{ radius = {wall}, face = {face}, nose = {corner} }}"),
            (_, Some([at, depth])) => {
                let depth = depth + gap - self.sheet.thickness;
                recessed_punch([radius, nose, 4.0 * self.part.height], [at, depth], self.part.slope(depth))
            }
            _ => format!("flat = {{ radius = {wall}, nose = {corner} }}"),
        }
    }
}
