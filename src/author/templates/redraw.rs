//! A cup drawn twice: a wider one first, then through a smaller die.

use super::cup::{Cup, RIM_SHOULDER, TRIM, declared_trim};
use super::sizes::{newtons, round_pressure};
use super::*;
use crate::author::writer::{joined, mm, profile_text};
use crate::geometry::Point;
use rules::REDRAW_RATIO;
use std::f64::consts::PI;

pub(super) const TEMPLATE: Template = Template {
    name: "redraw",
    about: "a cup too high for one draw, in two stages: drawn wider, then redrawn",
    own: &[
        Choice::length("punch-radius", "30 mm", "radius of the second punch").or_diameter("punch-diameter"),
        Choice::length("height", "60 mm", "height of the whole cup; the second draw stops at nine tenths of it"),
        Choice::new("trim", Kind::SHARE, "8 %", TRIM),
        Choice::length("first-radius", "1.3 punch radii", "radius of the first punch").or_diameter("first-diameter"),
        Choice::length("nose", "6 thicknesses", "radius of both punches' corners"),
        Choice { about: "radius of both dies' corners", ..RIM_SHOULDER },
        Choice::length("clearance", "t √β", "gap between punch and die, both draws"),
        HOLDER_PRESSURE,
    ],
    text: include_str!("redraw.toml"),
    sizes,
};

/// Share of the wanted height that the second draw forms [–].
const REDRAWN: f64 = 0.9;
/// Slope of the second die and the sleeve \[°\], a declared rule of thumb: a flat beside the throat has no room.
const CONE: f64 = 40.0;
/// Least width between the cones over the thickness \[–\].
const LEAST_CLAMPED: f64 = 0.1;

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let cup = Cup::read(inputs, sheet, inputs.pick("trim", declared_trim))?;
    let blank = cup.blank(t);
    let why = format!("{REDRAW_RATIO} times the second punch: what DC04 takes in a second draw (4ming)");
    let first = inputs.pick("first-radius", || Picked::by(REDRAW_RATIO * cup.radius, why));
    let or = "a smaller --trim; more than two draws are not written here";
    let ratio = draw_ratio(|height| cup.blank_for(height, t), cup.height, first.value, or)?;
    let whole_ratio = blank.value / cup.radius;
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
    let wide = throat(first.value, &clearance);
    let flat = [wide.value + shoulder.value, blank.value];
    let pressure = round_pressure(inputs, sheet, ratio, first.value, flat);
    // Height of the first cup, which has the same area.
    let (middle, nose) = (first.value + 0.5 * t, cup.nose.value + 0.5 * t);
    let bottom = rules::cup_area(middle, nose, nose);
    let first_height = nose + (PI * blank.value * blank.value - bottom) / (2.0 * PI * middle) + 0.5 * t;
    let first_height = first_height / (1.0 + cup.trim.value);
    let mut sizes = sheet.values(false);
    // With usual elements the second force oscillates as nodes leave the shoulder.
    sizes.elements(blank.value, shoulder.value.min(cup.nose.value), 2);
    sizes.set("wall_height", plain(cup.height), "");
    sizes.set("first", plain(first.value), "");
    sizes.set("second", plain(cup.radius), "");
    sizes.set("warning", warning(ratio), "");
    sizes.set("diameter", plain(2.0 * cup.radius), "");
    sizes.lengths([
        ("blank", &blank),
        ("radius", &first),
        ("nose", &cup.nose),
        ("throat", &wide),
        ("shoulder", &shoulder),
    ]);
    sizes.lengths([("travel", &rules::drawn_travel(first_height, shoulder.value, t))]);
    sizes.holder(Geometry::Axisymmetric, flat, &pressure)?;
    let [radius, nose] = [cup.radius, cup.nose.value].map(Picked::input);
    // The rim has thickened twice and is shorter than by its area: drawn on, it would leave the die.
    let travel =
        Picked::by(REDRAWN * (cup.height - t), "nine tenths of the height: the rest stays on the die (declared)");
    sizes.lengths([("second_radius", &radius), ("second_nose", &nose), ("move", &travel)]);
    sizes.set("second_die", ring.die(), &joined(&["throat and shoulder", &plain(ring.throat), &plain(ring.shoulder)]));
    sizes.set("sleeve", ring.sleeve(4.0 * first_height), "");
    let area = PI * (ring.outer.powi(2) - ring.throat.powi(2));
    sizes.set(
        "second_force",
        newtons(pressure.value * area),
        "the first holder's pressure on the sleeve's ring (declared)",
    );
    Ok(sizes)
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
