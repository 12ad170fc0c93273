//! Punches of a round part's draws, and the stages after the first.

use super::*;
use crate::writer::redraw::Ring;

impl Cup<'_> {
    /// Text of the stages after the first draw, with the holder's pressure of that \[MPa\].
    pub(super) fn redraws(&self, tools: &[Tools], shoulder: f64, pressure: f64) -> String {
        let (thickness, mut is_held, mut text) = (self.sheet.thickness, true, String::new());
        for (i, pair) in tools.windows(2).enumerate() {
            let [before, now] = [&pair[0], &pair[1]];
            let throat = throat(now.radius, &now.clearance).value;
            let ring =
                Ring { thickness, outer: before.radius - 0.5 * thickness, nose: before.nose.value, throat, shoulder };
            let mut stage = Values::default();
            let name = if i > 0 { format!("\"redraw-{}\"", i + 1) } else { "\"redraw\"".into() };
            let why = joined(&["throat and shoulder", &plain(throat), &plain(shoulder)]);
            let given = [("name", name, ""), ("punch", now.punch.clone(), ""), ("die", ring.die(), why.as_str())];
            given.into_iter().for_each(|(name, value, why)| stage.set(name, value, why));
            stage.set("friction", rounded(self.inputs.value("friction")), "");
            stage.lengths([("move", &now.travel)]);
            let has_sleeve = ring.has_room();
            if has_sleeve {
                stage.set("sleeve", ring.sleeve(4.0 * before.cup), "");
                let why = "the first holder's pressure on the sleeve's ring (declared)";
                stage.set("force", newtons(rounded_up(pressure * ring.area(), 3)), why);
            } else if is_held {
                stage.set("remove", "[\"holder\"]", "no room for a sleeve: a cup as thick for its width needs none");
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
