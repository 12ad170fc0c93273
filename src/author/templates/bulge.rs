//! A clamped disc bulged by oil.

use super::*;

pub(super) const TEMPLATE: Template = Template {
    name: "bulge",
    about: "a clamped disc bulged by oil through a round opening",
    own: &[
        Choice::length("opening", "50 mm", "radius of the die's opening").or_diameter("opening-diameter"),
        Choice::length("height", "0.4 openings", "height of the dome that the pressure is for"),
        SHOULDER,
        Choice::new("pressure", Kind::STRESS, "of a spherical membrane", "pressure at the end"),
    ],
    text: include_str!("bulge.toml"),
    sizes,
};

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let opening = inputs.value("opening");
    let height = inputs.number("height").unwrap_or(0.4 * opening);
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    // Even biaxial stress over yield stress; at the same plastic work the strain is smaller by it.
    let biaxial = sheet.metal.yield_criterion.biaxial_factor();
    let stress = |strain: f64| biaxial * sheet.metal.hardening.at(strain / biaxial).stress;
    let pressure_at = |height: f64| rules::bulge_pressure(opening, height, t, stress);
    let why =
        format!("p = 2 σ t/R of a spherical cap {} high, t₀/t = (1 + h²/a²)² (Hill 1950, not read)", plain(height));
    let pressure = inputs.pick("pressure", || Picked::by(pressure_at(height), why));
    let largest = (1..=100).map(|i| pressure_at(0.01 * f64::from(i) * opening)).fold(0.0, f64::max);
    let what = || {
        let (height, pressure) = (plain(height), pressure.value);
        format!(
            "the sheet bears {largest:.2} MPa at most: a dome {height} high and a pressure of {pressure:.2} MPa are beyond that, \
             it would burst"
        )
    };
    let is_rising = height <= opening && pressure_at(height) >= pressure_at(0.98 * height);
    ensure(is_rising && pressure.value < largest, what, "make --height or --pressure smaller")?;
    let blank = Picked::by(opening + shoulder.value, "clamped where the die's shoulder ends");
    let mut sizes = sheet.values(false);
    sizes.elements(blank.value, shoulder.value, 1);
    sizes.set("diameter", plain(2.0 * opening), "");
    sizes.set("pressure", format!("\"{} MPa\"", rounded(pressure.value)), &pressure.why);
    sizes.lengths([("blank", &blank), ("throat", &Picked::input(opening)), ("shoulder", &shoulder)]);
    Ok(sizes)
}
