//! Sizes that several templates derive.

use super::inputs::Inputs;
use super::rules::{self, CAREFUL_RATIO, LIMITING_RATIO, Picked};
use super::sheet::Sheet;
use crate::author::writer::{Values, joined, plain};
use crate::case::CaseError;
use crate::model::{Extent, Geometry};

impl Values {
    /// Sets the number of elements for a blank and its smallest radius \[mm\], `times` as fine as usual.
    pub fn elements(&mut self, blank: f64, corner: f64, times: usize) {
        let why = format!("{} per 90° of the smallest radius, were they equal; finer there", 10 * times);
        self.set("elements", times * rules::elements(blank, corner), &why);
    }

    /// Sets a holder that presses on a flat from the end of the shoulder to the edge \[mm\], by a pressure \[MPa\].
    ///
    /// # Errors
    /// When the shoulder leaves no flat.
    pub fn holder(&mut self, geometry: Geometry, [end, edge]: [f64; 2], pressure: &Picked) -> Result<(), CaseError> {
        let what = || {
            let [end, edge] = [end, edge].map(plain);
            format!(
                "the blank ends at {edge}, where the die's shoulder still bends it (up to {end}): there is nothing to hold"
            )
        };
        ensure(edge > end, what, "make the part higher, or --shoulder or --clearance smaller")?;
        let whole = Extent::of(geometry, None);
        let force = pressure.value * (whole.area(edge) - whole.area(end));
        self.lengths([("holder", &Picked::by(end, "where the die's shoulder ends"))]);
        match geometry {
            Geometry::Axisymmetric => self.set("force", newtons(force), &joined(&["of the whole ring", &pressure.why])),
            Geometry::PlaneStrain => {
                let why = joined(&["per mm of depth, both sides together", &pressure.why]);
                self.set("force", format!("\"{force:.1} N/mm\""), &why);
            }
        }
        Ok(())
    }
}

/// Refuses sizes that do not fit each other.
pub(super) fn ensure(fits: bool, what: impl FnOnce() -> String, help: &str) -> Result<(), CaseError> {
    if fits { Ok(()) } else { Err(CaseError::bare(what(), help.to_owned())) }
}

/// Draw ratio of the blank for a part of this height.
///
/// # Errors
/// When one draw does not reach it; the message has the height that it reaches, and `or` what else may be done.
pub(super) fn draw_ratio(blank_for: impl Fn(f64) -> f64, height: f64, punch: f64, or: &str) -> Result<f64, CaseError> {
    let ratio = |height: f64| blank_for(height) / punch;
    let wanted = ratio(height);
    let tenths = (1..=(10.0 * height) as u32).map(|tenths| 0.1 * f64::from(tenths));
    let most = tenths.take_while(|height| ratio(*height) <= LIMITING_RATIO).last();
    let help = most.map_or(or.to_owned(), |most| format!("--height of {} or less; or {or}", plain(most)));
    let what = || {
        let [blank, punch] = [blank_for(height), punch].map(plain);
        format!(
            "a blank of {blank} radius for a punch of {punch} is a draw ratio of {wanted:.2}, above the limit of one draw, \
             {LIMITING_RATIO}"
        )
    };
    ensure(wanted <= LIMITING_RATIO, what, &help).map(|()| wanted)
}

/// Pressure of a round part's holder, on a flat from the end of the shoulder to the edge \[mm\].
pub(super) fn round_pressure(inputs: &Inputs, sheet: &Sheet, ratio: f64, punch: f64, flat: [f64; 2]) -> Picked {
    let rule = || rules::holder_pressure(ratio, 2.0 * punch, flat, sheet.thickness, sheet.tensile_strength);
    inputs.pick("holder-pressure", rule)
}

/// Warning near the limit of one draw.
pub(super) fn warning(ratio: f64) -> String {
    if ratio <= CAREFUL_RATIO {
        return String::new();
    }
    format!(
        " The draw ratio of {ratio:.2} is close to the limit of one draw ({CAREFUL_RATIO} for DC04, 4ming): it may tear."
    )
}

/// Ring force as TOML, rounded up.
pub(super) fn newtons(force: f64) -> String {
    match force >= 1e4 {
        true => format!("\"{:.2} kN\"", 1e-2 * (0.1 * force).ceil()),
        false => format!("\"{:.0} N\"", force.ceil()),
    }
}

/// Radius of the punch's corner.
///
/// # Errors
/// When it is larger than the punch's radius or half-width \[mm\].
pub(super) fn nose(inputs: &Inputs, sheet: &Sheet, punch: f64) -> Result<Picked, CaseError> {
    let nose = inputs.pick("nose", || rules::tool_radius(sheet.thickness));
    let what = || format!("a nose radius of {} does not fit a punch of {}", plain(nose.value), plain(punch));
    ensure(nose.value <= punch, what, "make --nose smaller (it is 6 thicknesses when not given) or the punch larger")?;
    Ok(nose)
}

/// Radius or half-width of the die's opening round a punch.
pub(super) fn throat(punch: f64, clearance: &Picked) -> Picked {
    Picked::by(punch + clearance.value, format!("punch and clearance{}", clearance.reason(", ")))
}
