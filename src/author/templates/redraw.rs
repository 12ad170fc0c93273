//! A cup drawn twice: a wider one first, then through a smaller die.

use super::cups::{Cup, RUNS, declared_trim};
use super::sizes::Draw;
use super::*;
use crate::case::parse;
use crate::measure::part_height;
use rules::REDRAW_RATIO;
use std::f64::consts::PI;

/// Slope of the second die and the sleeve \[°\], a declared rule of thumb: a flat beside the throat has no room.
const CONE: f64 = 40.0;
/// Least width between the cones over the thickness \[–\].
const LEAST_CLAMPED: f64 = 0.1;

/// Share of the wanted height by which the second punch first moves \[–\].
const REDRAWN: f64 = 0.9;

/// Sizes whose run reaches the wanted height with its rim on the second die's shoulder: what one run misses, the next has more.
///
/// A case that does not run to its end keeps the declared trim.
pub(super) fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let given = inputs.number("trim");
    let first = || Second {
        trim: given.map_or_else(declared_trim, Picked::input),
        travel: Picked::by(
            REDRAWN * (inputs.value("height") - sheet.thickness),
            "nine tenths of the height (declared)",
        ),
    };
    let mut second = first();
    for _ in 0..RUNS {
        let (sizes, rim) = with_second(inputs, sheet, &second)?;
        let Ok(case) = parse(&sizes.fill(find("redraw")?.text), "redraw.toml", &[]) else { break };
        let run = case.solve(&mut ());
        let end = run.stages.get(1).filter(|stage| stage.stop.is_complete()).and_then(|stage| stage.frames.last());
        let Some((height, frame)) = end.and_then(|frame| Some((part_height(frame)?, frame))) else {
            return Ok(with_second(inputs, sheet, &first())?.0);
        };
        let (wanted, edge) = (inputs.value("height"), frame.nodes[frame.nodes.len() - 1].r);
        let missing = wanted - height;
        // Wall of the area that is left on the cone beyond the shoulder.
        let spare = 0.5 * (edge * edge - rim * rim) / CONE.to_radians().cos() / inputs.value("punch-radius");
        let why = "as runs of this case need";
        second.travel = Picked::by(1e-3 * (1e3 * (second.travel.value + missing)).round(), why);
        if given.is_none() {
            let trim = second.trim.value + (missing - spare) / wanted;
            second.trim = Picked { value: (1e3 * trim).round() / 1e3, why: why.into() };
        }
    }
    Ok(with_second(inputs, sheet, &second)?.0)
}

/// Travel of the second punch \[mm\], and the blank's share of height beyond the wanted one \[–\].
struct Second {
    trim: Picked,
    travel: Picked,
}

/// Sizes, and the radius at which the second die's shoulder begins \[mm\].
fn with_second(inputs: &Inputs, sheet: &Sheet, second: &Second) -> Result<(Values, f64), CaseError> {
    let t = sheet.thickness;
    let cup = Cup::read(inputs, sheet, second.trim.clone())?;
    let blank = cup.blank(t);
    let why = format!("{REDRAW_RATIO} times the second punch: what DC04 takes in a second draw (4ming)");
    let first = inputs.pick("first-radius", || Picked::by(REDRAW_RATIO * cup.radius, why));
    let blank_for = |height| cup.blank_for(height, t);
    let or = "a larger --punch-radius; three draws are not written here";
    let whole_ratio = draw_ratio(blank_for, cup.height, cup.radius, 2, or)?;
    let ratio = draw_ratio(blank_for, cup.height, first.value, 1, "a larger --first-radius")?;
    let [clearance, second_clearance] =
        [ratio, whole_ratio].map(|ratio| inputs.pick("clearance", || rules::drawing_clearance(t, ratio)));
    let shoulder = inputs.pick("shoulder", || rules::drawn_shoulder(t, whole_ratio, sheet.r_value()));
    let ring = Ring {
        thickness: t,
        outer: first.value - 0.5 * t,
        nose: cup.nose.value,
        throat: throat(cup.radius, &second_clearance).value,
        shoulder: shoulder.value,
    };
    let what = || {
        let [first, throat] = [first.value, ring.throat].map(plain);
        format!("a first punch of {first} leaves no room for a holder beside the second die's throat of {throat}")
    };
    let help = "make --first-radius larger, or --nose, --shoulder or --clearance smaller";
    ensure(ring.clamped() >= LEAST_CLAMPED * t, what, help)?;
    // Height of the first cup, which has the same area.
    let (middle, nose) = (first.value + 0.5 * t, cup.nose.value + 0.5 * t);
    let bottom = rules::cup_area(middle, nose, nose);
    let first_height = nose + (PI * blank.value * blank.value - bottom) / (2.0 * PI * middle) + 0.5 * t;
    let first_height = first_height / (1.0 + cup.trim.value);
    let draw = Draw { punch: first.value, corner: cup.nose.value, ratio, clearance, shoulder, blank };
    let (mut sizes, pressure) = draw.values(inputs, sheet, ratio)?;
    // With usual elements the second force oscillates as nodes leave the shoulder.
    sizes.elements(draw.blank.value, ring.shoulder.min(ring.nose), 2);
    let lengths = [("wall_height", cup.height), ("first", first.value), ("second", cup.radius)];
    lengths.into_iter().for_each(|(name, length)| sizes.set(name, plain(length), ""));
    sizes.set("diameter", plain(2.0 * cup.radius), "");
    let [radius, nose] = [cup.radius, cup.nose.value].map(Picked::input);
    let travel = rules::drawn_travel(first_height, ring.shoulder, t);
    sizes.lengths([("radius", &first), ("nose", &cup.nose), ("travel", &travel)]);
    sizes.lengths([("second_radius", &radius), ("second_nose", &nose), ("move", &second.travel)]);
    sizes.set("second_die", ring.die(), &joined(&["throat and shoulder", &plain(ring.throat), &plain(ring.shoulder)]));
    sizes.set("sleeve", ring.sleeve(4.0 * first_height), "");
    let force = newtons(pressure * (PI * (ring.outer.powi(2) - ring.throat.powi(2))));
    sizes.set("second_force", force, "the first holder's pressure on the sleeve's ring (declared)");
    Ok((sizes, ring.cone_start().x))
}

/// Second die and sleeve, which clamp the sheet between two cones, all \[mm\].
struct Ring {
    thickness: f64,
    /// Outside of the sleeve, and radius of its corner.
    outer: f64,
    nose: f64,
    /// Throat of the die, also the sleeve's bore, and radius of its shoulder.
    throat: f64,
    shoulder: f64,
}

impl Ring {
    /// End of the sleeve's cone at its corner, which ends at z = 0.
    fn cone_end(&self) -> Point {
        let (sine, cosine) = CONE.to_radians().sin_cos();
        Point::new(self.outer - self.nose * (1.0 - sine), self.nose * cosine)
    }

    /// Begin of the die's cone at its shoulder, which ends at z = 0.
    fn cone_start(&self) -> Point {
        let (sine, cosine) = CONE.to_radians().sin_cos();
        Point::new(self.throat + self.shoulder * (1.0 - sine), -self.shoulder * cosine)
    }

    /// End of the round of a thickness at the sleeve's inner edge, and its centre.
    fn edge(&self) -> [Point; 2] {
        let (sine, cosine) = CONE.to_radians().sin_cos();
        let (round, end) = (self.thickness, self.cone_end());
        let center = self.throat + round;
        let height = end.y + ((end.x - center) * sine - round) / cosine;
        [Point::new(center + round * sine, height + round * cosine), Point::new(center, height)]
    }

    /// Radial width in which the cones face each other \[mm\].
    fn clamped(&self) -> f64 {
        let die = self.cone_start().x - self.thickness * CONE.to_radians().sin();
        self.cone_end().x - die.max(self.edge()[0].x)
    }

    fn die(&self) -> String {
        let (start, far) = (self.cone_start(), 1.5 * self.outer);
        let center = Point::new(self.throat + self.shoulder, 0.0);
        let steps = [
            (start, None),
            (Point::new(self.throat, 0.0), Some((center, false))),
            (Point::new(self.throat, 4.0 * far), None),
        ];
        profile_text(Point::new(far, start.y - (far - start.x) * CONE.to_radians().tan()), &steps, mm)
    }

    fn sleeve(&self, length: f64) -> String {
        let [edge, center] = self.edge();
        let steps = [
            (Point::new(self.throat, center.y), None),
            (edge, Some((center, false))),
            (self.cone_end(), None),
            (Point::new(self.outer, 0.0), Some((Point::new(self.outer - self.nose, 0.0), false))),
            (Point::new(self.outer, -length), None),
        ];
        profile_text(Point::new(self.throat, -length), &steps, mm)
    }
}
