//! Sizes that several templates derive.

use super::{rules, rules::Metal, rules::Picked, rules::ROUNDED_RATIO, *};
use crate::model::Extent;

impl Values {
    /// Sets the number of elements for a blank and its smallest radius \[mm\], `times` as fine as usual.
    pub fn elements(&mut self, blank: f64, corner: f64, times: f64) {
        let why = format!("{:.0} per 90° of the smallest radius, were they equal; finer there", 10.0 * times);
        self.set("elements", (times * rules::elements(blank, corner) as f64).round(), &why);
    }

    /// Sets blank and die, and elements for the smaller of the shoulder and the punch's corner \[mm\].
    pub fn die(&mut self, blank: &Picked, throat: &Picked, shoulder: &Picked, corner: f64) {
        self.elements(blank.value, shoulder.value.min(corner), 1.0);
        self.lengths([("blank", blank), ("throat", throat), ("shoulder", shoulder)]);
    }

    /// Sets a holder that presses on a flat from the end of the shoulder to the edge \[mm\], by a pressure \[MPa\].
    pub fn holder(&mut self, geometry: Geometry, [end, edge]: [f64; 2], pressure: &Picked) -> Result<(), CaseError> {
        let what = || {
            let [end, edge] = [end, edge].map(|length| plain(significant(length, 4)));
            format!(
                "the blank ends at {edge}, where the shoulder still bends it (up to {end}): there is nothing to hold"
            )
        };
        ensure(edge > end, what, "make the part higher, or --shoulder or --clearance smaller")?;
        let whole = Extent::of(geometry, None);
        let force = rounded_up(pressure.value * (whole.area(edge) - whole.area(end)), 3);
        let (step, force, of) = match geometry {
            Geometry::Axisymmetric => (0.025, newtons(force), "of the whole ring"),
            Geometry::PlaneStrain => (0.05, format!("\"{force} N/mm\""), "per mm of depth, both sides together"),
        };
        self.lengths([("holder", &Picked::up(end, step, "where the die's shoulder ends"))]);
        self.set("force", force, &joined([of, &pressure.why], ", "));
        Ok(())
    }
}

pub(super) struct Draw {
    /// Radius of the punch and of its corner \[mm\].
    pub punch: f64,
    pub corner: f64,
    /// Draw ratio \[–\].
    pub ratio: f64,
    pub clearance: Picked,
    pub shoulder: Picked,
    pub blank: Picked,
}

impl Draw {
    /// Values of sheet, blank, die and holder, and the holder's pressure \[MPa\].
    pub fn values(&self, inputs: &Inputs, sheet: &Sheet) -> Result<(Values, f64), CaseError> {
        let Self { punch, corner, ratio, clearance, shoulder, blank } = self;
        let throat = throat(*punch, clearance);
        let flat = [throat.value + shoulder.value, blank.value];
        let (t, strength) = (sheet.thickness, sheet.tensile_strength);
        let Metal { name, ratios: [limit, _], pressure: usual, .. } = Metal::of(&sheet.metal);
        let rule = || rules::holder_pressure(usual, *ratio, 2.0 * punch, flat, t, strength);
        let pressure = inputs.pick("holder-pressure", rule);
        let doubt = format!(" The draw ratio {ratio:.2} is above {limit} of {name} in one draw (4ming): it may tear.");
        let warning = if *ratio > limit + ROUNDED_RATIO { doubt } else { String::new() };
        let mut sizes = sheet.values(false);
        sizes.die(blank, &throat, shoulder, *corner);
        sizes.set("diameter", plain(2.0 * punch), "");
        sizes.set("warning", warning, "");
        sizes.holder(Geometry::Axisymmetric, flat, &pressure)?;
        Ok((sizes, pressure.value))
    }
}

pub(super) fn ensure(fits: bool, what: impl FnOnce() -> String, help: &str) -> Result<(), CaseError> {
    if fits { Ok(()) } else { Err(CaseError::bare(what(), help.to_owned())) }
}

pub(super) fn draw_ratio(
    blank_for: impl Fn(f64) -> f64, [least, height]: [f64; 2], punch: f64, (limit, of): (f64, &str), or: &str,
) -> Result<f64, CaseError> {
    let ratio = |height: f64| blank_for(height) / punch;
    let wanted = ratio(height);
    let tenths = ((10.0 * least).ceil() as u32..=(10.0 * height) as u32).map(|tenths| 0.1 * f64::from(tenths));
    let most = tenths.take_while(|height| ratio(*height) <= limit).last().filter(|most| *most > least);
    let help = most.map_or(or.to_owned(), |most| format!("--height of {} or less; or {or}", plain(most)));
    let what = || {
        let [blank, punch] = [blank_for(height), punch].map(|length| plain(significant(length, 4)));
        let limit = rounded(limit);
        format!("a blank of {blank} radius for a punch of {punch} is a draw ratio of {wanted:.2}, above {limit}, {of}")
    };
    ensure(wanted <= limit, what, &help).map(|()| wanted)
}

pub(super) fn newtons(force: f64) -> String {
    match force >= 1e4 {
        true => format!("\"{} kN\"", trimmed(1e-2 * (0.1 * force).ceil(), 2)),
        false => format!("\"{:.0} N\"", force.ceil()),
    }
}

pub(super) fn nose(inputs: &Inputs, sheet: &Sheet, punch: f64) -> Result<Picked, CaseError> {
    let nose = inputs.pick("nose", || rules::tool_radius(sheet.thickness));
    let [nose_radius, t, punch_radius] = [nose.value, sheet.thickness, punch].map(plain);
    let what = || format!("a nose radius of {nose_radius} does not fit a punch of {punch_radius}, sheet of {t}");
    let help = "make --nose or --thickness smaller (a nose is 6 thicknesses when not given), or the punch larger";
    ensure(nose.value <= punch, what, help)?;
    Ok(nose)
}

pub(super) fn throat(punch: f64, clearance: &Picked) -> Picked {
    Picked::by(punch + clearance.value, format!("punch and clearance{}", clearance.reason(", ")))
}
