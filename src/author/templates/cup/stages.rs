//! Punches of a round part's draws, and the stages after the first.

use super::*;
use crate::writer::redraw::Ring;

impl Cup<'_> {
    /// Text of the stages after the first draw, with the holder's pressure of that \[MPa\].
    pub(super) fn redraws(&self, tools: &[Tools], pressure: f64) -> String {
        let (thickness, mut is_held, mut text) = (self.sheet.thickness, true, String::new());
        for (i, pair) in tools.windows(2).enumerate() {
            let [before, now] = [&pair[0], &pair[1]];
            let (gap, outer) = (throat(now.radius, &now.clearance), before.radius - 0.5 * thickness);
            let [throat, shoulder] = [gap.value, now.shoulder.value];
            let ring = Ring { thickness, outer, nose: before.nose.value, throat, shoulder };
            let mut stage = Values::default();
            let name = if i > 0 { format!("\"redraw-{}\"", i + 1) } else { "\"redraw\"".into() };
            let size = |length: f64, picked: &Picked| plain(length) + &picked.reason(", ");
            let why = format!("throat Ø {}; shoulder {}", size(2.0 * throat, &gap), size(shoulder, &now.shoulder));
            let given = [("name", name, ""), ("punch", now.punch.clone(), ""), ("die", ring.die(), why.as_str())];
            given.into_iter().for_each(|(name, value, why)| stage.set(name, value, why));
            stage.set("friction", rounded(self.inputs.value("friction")), "");
            stage.lengths([("move", &now.travel)]);
            let has_sleeve = ring.has_room();
            if has_sleeve {
                stage.set("sleeve", ring.sleeve(4.0 * before.cup), "");
                let why = "the first holder's pressure on the sleeve's ring (declared)";
                stage.set("force", newtons(rounded_up(pressure * ring.area(), 3)), why);
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
                let [bend, width] = self.part.slope(depth);
                let [from, to, flat] = [at - 0.5 * width, at + 0.5 * width, radius - nose];
                let arc = |x: f64, y: f64, center: [f64; 2], left: bool| {
                    (Point::new(x, y), Some((Point::new(center[0], center[1]), left)))
                };
                let steps = [
                    (Point::new(from, -depth), None),
                    arc(at, -0.5 * depth, [from, bend - depth], true),
                    arc(to, 0.0, [to, -bend], false),
                    (Point::new(flat, 0.0), None),
                    arc(radius, -nose, [flat, -nose], false),
                    (Point::new(radius, -4.0 * self.part.height), None),
                ];
                format!("profile = {}", profile_text(Point::new(0.0, -depth), &steps, mm))
            }
            _ => format!("flat = {{ radius = {wall}, nose = {corner} }}"),
        }
    }
}
