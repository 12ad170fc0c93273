//! Punches of a round part's draws, and the stages after the first.

use super::*;
use crate::units::Amount;
use crate::writer::{recessed_punch, redraw::Ring};

/// Share of the gap before that a ring leaves, declared: well within the 35 % of a pass; and the most rings.
const RING: f64 = 0.75;
const MOST_RINGS: f64 = 9.0;
/// Least wall over the sheet's thickness, declared: what rings leave of a can.
const THINNEST: f64 = 0.35;
/// Radius of a ring's entry, and its land, over the sheet's thickness \[–\], declared.
const ENTRY: f64 = 20.0;
const LAND: f64 = 1.0;

impl Cup<'_> {
    /// Thickness that each ironing ring leaves, in equal shares \[mm\].
    pub(super) fn walls(&self, last: &Tools) -> Result<Vec<f64>, CaseError> {
        self.inputs.only_with("rings", "wall")?;
        let Some(wall) = self.inputs.number("wall") else { return Ok(Vec::new()) };
        let Part { flange, step, recess, .. } = self.part;
        let stays = flange.is_some() || step.is_some() || recess.is_some() || self.inputs.number("travel").is_some();
        let what = || "a wall is ironed of a cup that is drawn through its die".to_owned();
        ensure(!stays, what, "leave --wall out, or --flange, --step-radius, --recess and --travel")?;
        let (drawn, least) = (last.clearance.value, THINNEST * self.sheet.thickness);
        let [wanted, from, to] = [wall, least, drawn].map(plain);
        let what = || format!("rings leave {from} of the sheet at least and begin below the gap of {to}, not {wanted}");
        ensure((least..drawn).contains(&wall), what, "another --wall, or leave it out")?;
        let rings = self.inputs.pick("rings", || Picked::by(((wall / drawn).ln() / RING.ln()).ceil(), "")).value;
        let what = || format!("--rings {rings} is no number of rings");
        ensure(rings.fract() == 0.0 && (1.0..=MOST_RINGS).contains(&rings), what, "a whole number from 1 to 9")?;
        let share = Amount::share(1.0 - (wall / drawn.min(self.sheet.thickness)).powf(1.0 / rings));
        let what =
            || format!("{rings} rings iron {share} of the wall each, more than {:.0} %", 100.0 * rules::IRONING_LIMIT);
        ensure(share.value <= 100.0 * rules::IRONING_LIMIT, what, "more --rings, or a thicker --wall")?;
        Ok((1..=rings as i32).map(|i| rounded(drawn * (wall / drawn).powf(f64::from(i) / rings))).collect())
    }

    /// Text of the stages after the first draw, with the holder's pressure of that \[MPa\], and of rings to these walls \[mm\].
    pub(super) fn later(&self, tools: &[Tools], pressure: f64, walls: &[f64]) -> String {
        let (thickness, mut is_held, mut text) = (self.sheet.thickness, true, String::new());
        for (i, pair) in tools.windows(2).enumerate() {
            let [before, now] = [&pair[0], &pair[1]];
            let (gap, outer) = (throat(now.radius, &now.clearance), before.radius - 0.5 * thickness);
            let (throat, is_reverse) = (gap.value, self.inputs.is_on("reverse"));
            let widest = Picked::by(0.5 * (outer - throat), "half the width of the ring inside the cup");
            let round = if is_reverse && now.shoulder.value > widest.value { &widest } else { &now.shoulder };
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
        let last = &tools[tools.len() - 1];
        for (i, wall) in walls.iter().enumerate() {
            let mut ring = Values::default();
            let before = if i > 0 { walls[i - 1] } else { last.clearance.value };
            let share = format!(", {:.0} % below the gap before", 100.0 * (1.0 - wall / before));
            let [wall, name] = [plain(*wall), format!("\"iron-{}\"", i + 1)];
            let texts = [("name", name), ("wall", wall), ("share", share)];
            texts.into_iter().for_each(|(key, text)| ring.set(key, text, ""));
            ring.set("friction", rounded(self.inputs.value("friction")), "");
            let (shoulder, land) = (ENTRY * thickness, LAND * thickness);
            let travel = rounded_up(HIGHER * last.cup * thickness / walls[i] + 0.5 * shoulder + land, 3);
            let sizes = [("throat", last.radius + walls[i]), ("shoulder", shoulder), ("land", land), ("move", travel)];
            sizes.into_iter().for_each(|(key, size)| ring.set(key, mm(size), ""));
            if is_held && i == 0 {
                ring.set("remove", "[\"holder\"]", "");
            }
            text += &ring.fill(include_str!("../ring_stage.toml"));
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
