//! A cup drawn twice: a wider one first, then through a smaller die.

use super::cup::Cup;
use super::inputs::{Choice, Inputs, Kind, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{HOLDER_PRESSURE, Tools, careful, flat_punch, newtons, throat};
use crate::assess::design::REDRAW_RATIO;
use crate::author::page::{mm, plain};
use crate::case::CaseError;
use crate::model::Geometry;
use crate::units::rounded;
use std::f64::consts::PI;

pub(super) const TEMPLATE: Template =
    Template::new("redraw", "a cup too high for one draw, in two stages: drawn wider, then redrawn", OPTIONS, write);

const OPTIONS: &[Choice] = &[
    Choice::radius(
        "punch-radius",
        "punch-diameter",
        Value("30 mm"),
        "radius of the second punch, half the cup's inner diameter",
    ),
    Choice::length("height", Value("60 mm"), "height of the whole cup; the second draw stops at nine tenths of it"),
    Choice::new("trim", Kind::Share, Rule("8 %"), "blank for that much more height: the rim thickens and is trimmed"),
    Choice::radius("first-radius", "first-diameter", Rule("1.3 punch radii"), "radius of the first punch"),
    Choice::length("nose", Rule("6 thicknesses"), "radius of both punches' corners"),
    Choice::length("shoulder", Rule("6 thicknesses of the rim"), "radius of both dies' corners"),
    Choice::length("clearance", Rule("t √β"), "gap between punch and die, both draws"),
    HOLDER_PRESSURE,
];

/// Share of the wanted height that the second draw forms [–].
const REDRAWN: f64 = 0.9;
/// Slope of the second die and the sleeve \[°\], a declared rule of thumb: the ring beside the throat is too narrow for a
/// flat between two corners of 90°.
const CONE: f64 = 40.0;
/// Least width over the thickness across which the two cones lie opposite each other \[–\].
const LEAST_CLAMPED: f64 = 0.1;

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let trim = inputs.pick("trim", || Picked { value: rules::TRIM, why: rules::TRIMMED.into() });
    let cup = Cup::read(inputs, &sheet, trim)?;
    let blank = cup.blank(t);
    let first = inputs.pick("first-radius", || {
        Picked::by(
            REDRAW_RATIO * cup.radius,
            format!("{} times the second punch: what DC04 takes in a second draw (4ming)", REDRAW_RATIO),
        )
    });
    let or = "a smaller --trim; more than two draws are not written here";
    let ratio = rules::draw_ratio(|height| cup.blank_for(height, t), cup.height, first.value, or)?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let shoulder = inputs.pick("shoulder", || rules::drawn_shoulder(t, blank.value / cup.radius, sheet.anisotropy()));
    let narrow = Picked::by(
        cup.radius + inputs.pick("clearance", || rules::drawing_clearance(t, blank.value / cup.radius)).value,
        "punch and t √β of both draws together",
    );
    // The sleeve stands inside the first cup and clamps what runs from its wall to the second die, cone on cone.
    let ring = Ring {
        thickness: t,
        outer: first.value - 0.5 * t,
        nose: cup.nose.value,
        throat: narrow.value,
        shoulder: shoulder.value,
    };
    if ring.clamped() < LEAST_CLAMPED * t {
        let what = format!(
            "a first punch of {} leaves no room for a holder beside the second die's throat of {}",
            plain(first.value),
            plain(narrow.value)
        );
        let remedy = "make --first-radius larger, or --nose, --shoulder or --clearance smaller";
        return Err(CaseError::bare(what, remedy.into()));
    }
    let wide = throat("punch", first.value, &clearance);
    let flat = [wide.value + shoulder.value, blank.value];
    let pressure =
        inputs.pick("holder-pressure", || rules::holder_pressure(ratio, 2.0 * first.value, flat, t, sheet.strength));
    // Height of the first cup, which has the same area.
    let first_height = {
        let (middle, nose) = (first.value + 0.5 * t, cup.nose.value + 0.5 * t);
        let bottom = rules::cup_area(middle, nose, nose);
        nose + (PI * blank.value * blank.value - bottom) / (2.0 * PI * middle) + 0.5 * t
    };
    let first_height = first_height / (1.0 + cup.trim.value);
    let mut punch = flat_punch("radius", first.value, &cup.nose);
    let reasons = [first.reason("radius: "), punch.why];
    punch.why = reasons.into_iter().filter(|why| !why.is_empty()).collect::<Vec<_>>().join("; ");
    let tools = Tools {
        geometry: Geometry::Axisymmetric,
        punch,
        travel: rules::drawn_travel(first_height, shoulder.value, t),
        throat: wide,
        shoulder: shoulder.clone(),
        holder: None,
    }
    .held(&pressure, blank.value)?;

    let mut page = begin(
        &format!(
            "A cup, {} high, drawn twice: to {} inside radius, then to {}.{}",
            plain(cup.height),
            plain(first.value),
            plain(cup.radius),
            careful(ratio)
        ),
        &format!("Redrawn cup, punch diameter {}", plain(2.0 * cup.radius)),
        Geometry::Axisymmetric,
        &sheet.notes("a made-up cup"),
    );
    page.table("stage", "");
    page.set("name", "\"draw\"", "");
    sheet.blank(&mut page, Geometry::Axisymmetric, &blank);
    page.set(
        "elements",
        2 * rules::elements(blank.value, shoulder.value.min(cup.nose.value)),
        "20 per 90° of the smallest radius, were they equal: with 10 the second force ticks as nodes leave the shoulder",
    );
    sheet.material(&mut page, false);
    sheet.forming_limit(&mut page);
    tools.write(&mut page, &sheet);

    let friction = rounded(sheet.friction);
    page.table("[stages]", "New tools, brought up to where they touch the drawn cup.");
    page.set("name", "\"redraw\"", "");
    // The rim has thickened twice and is shorter than by its area: drawn on, it would leave the die.
    let travel = Picked::by(
        REDRAWN * (cup.height - t),
        "nine tenths of the height: the rest, to be trimmed, stays on the die (declared)",
    );
    page.table("stages.punch", "");
    flat_punch("radius", cup.radius, &Picked::given(cup.nose.value)).write(&mut page);
    page.set("friction", friction, "");
    page.length("move", &travel);
    page.table(
        "stages.die",
        &format!(
            "Throat {}: {}. A cone of {CONE}° (declared) leads to its shoulder of {}, for a flat beside it has no room.",
            plain(narrow.value),
            narrow.why,
            plain(shoulder.value)
        ),
    );
    page.set("profile", ring.die(), "");
    page.set("friction", friction, "");
    page.table("stages.holder", "A sleeve inside the first cup, with the die's cone.");
    page.set("profile", ring.sleeve(4.0 * first_height), "");
    page.set("friction", friction, "");
    let area = PI * (ring.outer.powi(2) - ring.throat.powi(2));
    page.set("force", newtons(pressure.value * area), "the first holder's pressure on the sleeve's ring (declared)");
    Ok(page.text())
}

/// Where the second die and the sleeve hold the sheet, all \[mm\].
struct Ring {
    thickness: f64,
    /// The sleeve's outside and the radius of its corner.
    outer: f64,
    nose: f64,
    /// The die's throat, which is also the sleeve's bore, and the radius of its shoulder.
    throat: f64,
    shoulder: f64,
}

impl Ring {
    fn sine() -> f64 {
        CONE.to_radians().sin()
    }

    /// Where the sleeve's cone goes over into its corner, which ends at z = 0.
    fn cone_end(&self) -> [f64; 2] {
        let cosine = CONE.to_radians().cos();
        [self.outer - self.nose * (1.0 - Self::sine()), self.nose * cosine]
    }

    /// Where the die's cone goes over into its shoulder, which ends at z = 0.
    fn cone_start(&self) -> [f64; 2] {
        let cosine = CONE.to_radians().cos();
        [self.throat + self.shoulder * (1.0 - Self::sine()), -self.shoulder * cosine]
    }

    /// Where the sleeve's cone begins, at the round of a thickness of its inner edge, and the centre of this round: the cup's
    /// bottom lies on it first.
    fn edge(&self) -> [[f64; 2]; 2] {
        let (sine, cosine) = CONE.to_radians().sin_cos();
        let (round, [x, z]) = (self.thickness, self.cone_end());
        let center = self.throat + round;
        let height = z + ((x - center) * sine - round) / cosine;
        [[center + round * sine, height + round * cosine], [center, height]]
    }

    /// Width across which the sheet has both cones opposite each other, along r \[mm\].
    fn clamped(&self) -> f64 {
        let ([[edge, _], _], die) = (self.edge(), self.cone_start()[0] - self.thickness * Self::sine());
        self.cone_end()[0] - die.max(edge)
    }

    fn die(&self) -> String {
        let ([x, z], far) = (self.cone_start(), 1.5 * self.outer);
        let (throat, center) = (self.throat, self.throat + self.shoulder);
        section([
            format!("{{ from = {} }}", point(far, z - (far - x) * CONE.to_radians().tan())),
            format!("{{ to = {} }}", point(x, z)),
            format!("{{ arc_to = {}, center = {}, turn = \"right\" }}", point(throat, 0.0), point(center, 0.0)),
            format!("{{ to = {} }}", point(throat, 4.0 * far)),
        ])
    }

    fn sleeve(&self, length: f64) -> String {
        let [x, z] = self.cone_end();
        let (outer, center) = (self.outer, self.outer - self.nose);
        let [[begin, height], [middle, level]] = self.edge();
        section([
            format!("{{ from = {} }}", point(self.throat, -length)),
            format!("{{ to = {} }}", point(self.throat, level)),
            format!("{{ arc_to = {}, center = {}, turn = \"right\" }}", point(begin, height), point(middle, level)),
            format!("{{ to = {} }}", point(x, z)),
            format!("{{ arc_to = {}, center = {}, turn = \"right\" }}", point(outer, 0.0), point(center, 0.0)),
            format!("{{ to = {} }}", point(outer, -length)),
        ])
    }
}

fn point(x: f64, z: f64) -> String {
    format!("[{}, {}]", mm(x), mm(z))
}

fn section<const N: usize>(steps: [String; N]) -> String {
    format!("[\n    {},\n]", steps.join(",\n    "))
}
