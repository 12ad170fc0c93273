//! Punch, die and holder of a template, as the case file has them.

use super::inputs::{Choice, Kind, Rule};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use crate::assess::design::CAREFUL_RATIO;
use crate::author::page::{Page, across, mm, plain};
use crate::case::CaseError;
use crate::model::{Extent, Geometry};
use crate::units::rounded;

/// Options of the tools that several templates have.
pub(super) const NOSE: Choice = Choice::length("nose", Rule("6 thicknesses"), "radius of the punch's corner");
pub(super) const SHOULDER: Choice = Choice::length("shoulder", Rule("6 thicknesses"), "radius of the die's corner");
pub(super) const HOLDER_PRESSURE: Choice = Choice::new(
    "holder-pressure",
    Kind::Stress,
    Rule("Siebel's, or what keeps the rim down"),
    "pressure of the holder on the flange",
);

/// A tool's shape: key, value, and why it has these sizes.
pub(super) struct Shape {
    pub key: &'static str,
    pub value: String,
    pub why: String,
}

impl Shape {
    pub fn write(&self, page: &mut Page) {
        page.set(self.key, &self.value, &self.why);
    }
}

/// The tools of one draw.
pub(super) struct Tools {
    pub geometry: Geometry,
    pub punch: Shape,
    pub travel: Picked,
    /// Radius or half-width of the die's opening, and of its shoulder \[mm\].
    pub throat: Picked,
    pub shoulder: Picked,
    /// Force \[N or N/mm\] of a holder from the end of the shoulder on.
    pub holder: Option<Picked>,
}

impl Tools {
    /// Where the die's shoulder ends \[mm\].
    fn shoulder_end(&self) -> f64 {
        self.throat.value + self.shoulder.value
    }

    /// These with a holder whose force is a pressure on the flat of the flange, from the end of the shoulder to the edge.
    ///
    /// # Errors
    /// When no flange lies there.
    pub fn held(self, pressure: &Picked, edge: f64) -> Result<Self, CaseError> {
        let end = self.shoulder_end();
        if edge <= end {
            let what = format!(
                "the blank ends at {}, where the die's shoulder still bends it (up to {}): there is nothing to hold",
                plain(edge),
                plain(end)
            );
            return Err(CaseError::bare(what, "make the part higher, or --shoulder or --clearance smaller".into()));
        }
        let whole = Extent::of(self.geometry, None);
        let area = whole.area(edge) - whole.area(end);
        let holder = Picked { value: pressure.value * area, why: pressure.why.clone() };
        Ok(Self { holder: Some(holder), ..self })
    }

    /// Writes the tables of the tools.
    pub fn write(&self, page: &mut Page, sheet: &Sheet) {
        let friction = rounded(sheet.friction);
        page.table(
            "tools.punch",
            "All tools are placed where they touch the flat sheet; the punch then moves by `travel`.",
        );
        self.punch.write(page);
        page.set("friction", friction, "");
        page.length("travel", &self.travel);
        page.table("tools.die", "");
        page.length("throat", &self.throat);
        page.length("shoulder", &self.shoulder);
        page.set("friction", friction, "");
        let Some(force) = &self.holder else { return };
        let inner = Picked::by(self.shoulder_end(), "where the die's shoulder ends");
        page.table("tools.holder", "");
        match self.geometry {
            Geometry::Axisymmetric => {
                page.length("inner_radius", &inner);
                page.set("force", newtons(force.value), &format!("of the whole ring{}", force.reason(": ")));
            }
            Geometry::PlaneStrain => {
                page.length("inner_half_width", &inner);
                page.set(
                    "force",
                    format!("\"{:.1} N/mm\"", force.value),
                    &format!("per mm of depth, both sides together{}", force.reason(": ")),
                );
            }
        }
    }
}

/// A ring force as a case file has it, rounded up: a holder that presses less than its rule asks for is doubted.
pub(super) fn newtons(force: f64) -> String {
    if force >= 1e4 {
        format!("\"{:.2} kN\"", 1e-2 * (0.1 * force).ceil())
    } else {
        format!("\"{:.0} N\"", force.ceil())
    }
}

/// Refuses a nose that does not fit its punch.
///
/// # Errors
/// When the nose is larger than the punch's radius or half-width.
pub(super) fn nose_fits(nose: f64, punch: f64) -> Result<(), CaseError> {
    if nose <= punch {
        return Ok(());
    }
    let what = format!("a nose radius of {} does not fit a punch of {}", plain(nose), plain(punch));
    Err(CaseError::bare(what, "make --nose smaller (it is 6 thicknesses when not given) or the punch larger".into()))
}

/// Radius or half-width of the die's opening round a punch: its size and the clearance.
pub(super) fn throat(punch: &str, size: f64, clearance: &Picked) -> Picked {
    Picked::by(size + clearance.value, format!("{punch} and clearance{}", clearance.reason(", ")))
}

/// A word of warning near the limit of one draw.
pub(super) fn careful(ratio: f64) -> String {
    if ratio <= CAREFUL_RATIO {
        return String::new();
    }
    format!(
        " The draw ratio of {ratio:.2} is close to the limit of one draw ({} for DC04 with a 100 mm punch, 4ming): it may tear.",
        CAREFUL_RATIO
    )
}

/// A punch with a flat face; `size` names its radius or half width.
pub(super) fn flat_punch(size: &str, value: f64, nose: &Picked) -> Shape {
    Shape {
        key: "flat",
        value: format!("{{ {size} = {}, nose = {} }}", mm(value), mm(nose.value)),
        why: [across(value, size), nose.reason("nose: ")]
            .into_iter()
            .filter(|why| !why.is_empty())
            .collect::<Vec<_>>()
            .join(", "),
    }
}

/// A punch with a round nose.
pub(super) fn round_punch(radius: &Picked) -> Shape {
    Shape { key: "hemispherical", value: format!("{{ radius = {} }}", mm(radius.value)), why: radius.why.clone() }
}

/// The mesh, of which `[blank]` has the number of elements.
pub(super) fn elements(page: &mut Page, length: f64, radius: f64) {
    page.set(
        "elements",
        rules::elements(length, radius),
        "10 per 90° of the smallest radius, were they equal; finer there",
    );
}

/// The case file of a part that is drawn, or stretched where no holder is; `corner` is the smallest radius \[mm\] that
/// the sheet is bent over.
pub(super) fn draw(mut page: Page, sheet: &Sheet, blank: &Picked, corner: f64, tools: &Tools) -> String {
    drawn(&mut page, sheet, blank, &Draw { corner, depth: None, elastic: false }, tools);
    page.text()
}

/// What tells one draw from another, beside its sheet and its tools.
pub(super) struct Draw {
    /// Smallest radius that the sheet is bent over \[mm\].
    pub corner: f64,
    /// Of a strip, where it is known \[mm\].
    pub depth: Option<f64>,
    /// Whether the sheet is elastic too.
    pub elastic: bool,
}

/// Sheet and tools of a draw.
pub(super) fn drawn(page: &mut Page, sheet: &Sheet, blank: &Picked, draw: &Draw, tools: &Tools) {
    sheet.blank(page, tools.geometry, blank);
    if let Some(depth) = draw.depth {
        page.set("depth", mm(depth), "length of the part: forces are those of all of it");
    }
    if tools.holder.is_none() {
        page.set("edge", "\"clamped\"", "");
    }
    elements(page, blank.value, draw.corner);
    sheet.material(page, draw.elastic);
    sheet.forming_limit(page);
    tools.write(page, sheet);
}

/// The stage that takes the tools away.
pub(super) fn release(page: &mut Page) {
    page.table("[stages]", "All tools are taken away at once: their forces fade, and the sheet springs back.");
    page.set("name", "\"release\"", "");
    page.set("release", true, "");
}

/// The sheet and the tools of a strip that is bent, and the stage that takes them away.
pub(super) fn bend(page: &mut Page, sheet: &Sheet, blank: &Picked, nose: f64, tools: &Tools) {
    page.table("stage", "");
    page.set("name", "\"bend\"", "");
    sheet.blank(page, tools.geometry, blank);
    elements(page, blank.value, tools.shoulder.value.min(nose));
    sheet.material(page, true);
    tools.write(page, sheet);
    release(page);
}
