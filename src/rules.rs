//! Rules of die design that pick what is not given, each with its source. Lengths in mm, stresses in MPa.
//!
//! # References
//! *4ming*: Interactive Sheet Metal Forming Technical Guide, 4Ming e.K. (4ming.de/en/forming-handbook), pages "Punch
//! radius", "Die clearance" and "Limiting drawing ratio, second draw without intermediate annealing" with its table of draw
//! ratios after Oehler and Kaiser; the books that it quotes were not read. *Amada*: Bending procedures, table "Die V-width
//! selection" (amada.de).

use crate::material::{Material, flow::ROOM_TEMPERATURE};
use crate::units::rounded_up;
use std::{f64::consts::FRAC_PI_2, f64::consts::PI, ops::RangeInclusive};

/// Radius over thickness below which shells are no longer thin \[–\]: a declared rule of thumb.
pub const THIN: f64 = 5.0;
/// Blank over punch that one draw of mild steel reaches \[–\]: a declared rule of thumb, above 4ming's table.
pub const LIMITING_RATIO: f64 = 2.2;
/// Excess over a draw ratio of 4ming's table that its two decimals hide \[–\]; radii of cases are rounded too.
pub const ROUNDED_RATIO: f64 = 5e-3;
/// Largest reduction of a wall's thickness by ironing in one pass \[–\].
///
/// # References
/// Chinese Journal of Mechanical Engineering 2022, doi 10.1186/s10033-022-00681-9, table 8: below 35 % at each ironing die.
pub const IRONING_LIMIT: f64 = 0.35;
/// Radius over thickness of tools \[–\], see [`tool_radius`].
const RADIUS: f64 = 6.0;
/// Gap of a draw over the thickness from which the die sizes the rim \[–\], declared: a wall above 1.5 t is not to size.
pub const SIZED: f64 = 1.45;
/// Distance from its bend at which a flange's rim is held down, over the thickness \[–\]: a declared rule of thumb.
const HELD_OUT: f64 = 8.0;
/// Widths of blanks and tools \[mm\].
pub const WIDTHS: RangeInclusive<f64> = 10.0..=1000.0;
/// Width of the widest blank that a template writes \[mm\].
pub const WIDEST: f64 = 3000.0;
/// Elements per 90° of the sharpest corner of a mesh of equal elements \[–\].
const PER_QUARTER: f64 = 10.0;
/// Most draws that are planned: the rule of [`Metal::total`] has an example of four.
pub const MOST_DRAWS: usize = 4;
/// Height that is trimmed off a rim over that of the part, and least over the thickness \[–\]: declared rules of thumb.
const TRIM: [f64; 2] = [0.04, 2.0];

/// Draw ratios that a metal takes, and the holder pressure that shops set for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metal {
    /// Name in sentences.
    pub name: &'static str,
    /// Young's modulus up to which a sheet is taken for it \[MPa\], declared.
    young: f64,
    /// Blank over first cup, and first cup over second one without annealing \[–\], for a punch of 100 mm (4ming).
    pub ratios: [f64; 2],
    /// Usual pressure on the flange \[MPa\]: steel 2 to 2.5, copper alloys 2 to 2.4, aluminium 1.2 to 1.5 (Tschätsch, Praxis
    /// der Umformtechnik, not read).
    pub pressure: f64,
}

/// By Young's modulus, the least first. Half-hard AlMg3, the careful row of two, stands for aluminium; copper is declared.
const METALS: [Metal; 4] = [
    Metal { name: "aluminium (AlMg3)", young: 90e3, ratios: [2.0, 1.4], pressure: 1.2 },
    Metal { name: "copper and brass", young: 150e3, ratios: [2.0, 1.3], pressure: 2.0 },
    Metal { name: "stainless steel (1.4301)", young: 200e3, ratios: [2.0, 1.25], pressure: 2.5 },
    Metal { name: "mild steel (DC04)", young: f64::INFINITY, ratios: [2.0, 1.3], pressure: 2.5 },
];

/// Steel that may crack hours or days after it was formed, as it turns into martensite.
pub const AUSTENITIC: Metal = METALS[2];

impl Metal {
    /// Metal of a sheet, by its elasticity; mild steel without one.
    pub fn of(material: &Material) -> Self {
        let young = material.elastic.map_or(f64::MAX, |elastic| elastic.young);
        METALS.into_iter().find(|metal| young <= metal.young).unwrap_or(METALS[3])
    }

    /// Blank over the last cup that so many draws reach \[–\]: β₁ + (n − 1) C, where the second draw gives C = β₁ (β₂ − 1).
    ///
    /// # References
    /// 4ming, "Limiting drawing ratio, second draw without intermediate annealing", equation 1, after Herold and Kluge (1994).
    pub fn total(&self, draws: usize) -> f64 {
        let [first, second] = self.ratios;
        first * (1.0 + (second - 1.0) * (draws as f64 - 1.0))
    }

    /// Number of draws for a blank over the last cup.
    pub fn draws(&self, ratio: f64) -> usize {
        let [first, second] = self.ratios;
        1 + (((ratio - ROUNDED_RATIO) / first - 1.0) / (second - 1.0)).max(0.0).ceil() as usize
    }
}

/// Height that is trimmed off the rim of a drawn part, whose ears and uneven edge go with it \[mm\].
pub fn trim(height: f64, thickness: f64) -> Picked {
    let [share, least] = TRIM;
    Picked::by((share * height).max(least * thickness), "4 % of the height, 2 thicknesses at least (declared)")
}

/// Tensile strength \[MPa\]: largest nominal stress σ exp(−ε), reached where dσ/dε = σ (A. Considère, 1885).
pub fn tensile_strength(material: &Material) -> f64 {
    material.load_maximum(1.0, ROOM_TEMPERATURE)[1]
}

/// Holder pressure against wrinkles after Siebel \[MPa\]: p = 0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m.
///
/// Source: 4ming, "Blankholder pressure", equation 1, after H. Kugler, Umformtechnik (2009): for steel on steel with oil.
pub fn siebel(beta: f64, diameter: f64, thickness: f64, strength: f64) -> f64 {
    0.0025 * ((beta - 1.0).powi(2) + 0.5 * diameter / (100.0 * thickness)) * strength
}

/// Number with the rule that picked it; no rule if it was given.
#[derive(Clone, Debug, PartialEq)]
pub struct Picked {
    /// Number in the solver's unit.
    pub value: f64,
    /// Rule in words; empty if the number was given.
    pub why: String,
}

impl Picked {
    /// Number by a rule, rounded to a thousandth as the case file has it.
    pub fn by(value: f64, why: impl Into<String>) -> Self {
        Self { value: (value * 1e3).round() / 1e3, why: why.into() }
    }

    /// Number by a rule, to the nearest multiple of a step.
    pub fn nearest(value: f64, step: f64, why: impl Into<String>) -> Self {
        Self::by((value / step).round() * step, why)
    }

    /// Number by a rule, to the next multiple of a step.
    pub fn up(value: f64, step: f64, why: impl Into<String>) -> Self {
        // Sums of multiples have binary noise.
        Self::by((value / step - 1e-6).ceil() * step, why)
    }

    /// Number that the user has given.
    pub fn input(value: f64) -> Self {
        Self { value, why: String::new() }
    }

    /// Number that the user has given, or that a rule picks.
    pub fn or(input: Option<f64>, rule: impl FnOnce() -> Self) -> Self {
        input.map_or_else(rule, Self::input)
    }

    /// True if the user has given it.
    pub fn is_given(&self) -> bool {
        self.why.is_empty()
    }

    /// Rule behind a lead, as in `, 6 thicknesses`; empty if the number was given.
    pub fn reason(&self, lead: &str) -> String {
        if self.is_given() { String::new() } else { format!("{lead}{}", self.why) }
    }
}

/// Radius of a punch's nose or a die's shoulder, 6 t (4ming, "Punch radius", equation 1: 4 to 5 t; shoulder: declared).
pub fn tool_radius(thickness: f64) -> Picked {
    Picked::up(RADIUS * thickness, 0.1, "6 thicknesses: a punch wants 4 to 5 (4ming), shells want 5")
}

/// Thickness of a rim after a draw in which only its hoop is strained, t β^(1/(1 + r̄)), with that before the draw.
pub fn rim(thickness: f64, ratio: f64, anisotropy: f64) -> f64 {
    thickness * ratio.powf(1.0 / (1.0 + anisotropy))
}

/// Radius of a shoulder that a whole rim is drawn through: six times its thickness after the draw.
pub fn drawn_shoulder(rim: f64) -> Picked {
    let why = format!(
        "{RADIUS} thicknesses of the rim, {rim:.2} mm by t β^(1/(1 + r̄)) of this draw: shells want {THIN} with a margin (declared)"
    );
    // A small one goes up less: a short cup has little flat beside it.
    Picked::up(RADIUS * rim, if RADIUS * rim > 6.0 { 0.5 } else { 0.1 }, why)
}

/// Gap between punch and die of a cup, t √β of blank to punch: the rim, drawn in unstretched (4ming, "Die clearance").
pub fn drawing_clearance(thickness: f64, ratio: f64) -> Picked {
    let why = format!("t √β of blank to punch, β = {ratio:.2}, so that the rim is not ironed (4ming)");
    // In thin sheet 0.05 mm is a large part of the gap.
    let free = Picked::up(thickness * ratio.sqrt(), if thickness < 0.6 { 0.01 } else { 0.05 }, why);
    let why = format!("{SIZED} t, below t √β of blank to punch, β = {ratio:.2}: it irons the rim to size (declared)");
    let sized = Picked::nearest(SIZED * thickness, 0.01, why);
    if free.value > sized.value { sized } else { free }
}

/// Gap of a strip, which thickens nowhere, 1.1 t: a declared rule of thumb.
pub fn strip_clearance(thickness: f64) -> Picked {
    let why = "1.1 thicknesses, a declared rule of thumb: a strip does not thicken";
    Picked::up(1.1 * thickness, if thickness < 0.6 { 0.01 } else { 0.05 }, why)
}

/// Area of the mid-surface of a cup by Guldin's (Pappus') rule \[mm²\]: bottom, quarter of a torus, wall.
///
/// `radius` and `nose` are those of the mid-surface, `height` goes from the bottom's mid-surface to the rim \[mm\].
pub fn cup_area(radius: f64, nose: f64, height: f64) -> f64 {
    let flat = radius - nose;
    PI * flat * flat + 2.0 * PI * (flat + 2.0 * nose / PI) * FRAC_PI_2 * nose + 2.0 * PI * radius * (height - nose)
}

/// Radius of a blank of an area \[mm²\], which forming hardly changes \[mm\].
pub fn blank_of(area: f64) -> f64 {
    (area / PI).sqrt()
}

/// Travel at which the rim of a cup of this height, trim included, is a radius and 2 t behind the die's shoulder.
pub fn drawn_travel(height: f64, shoulder: f64, thickness: f64) -> Picked {
    let why = "at most: it ends when the rim is through the die's shoulder";
    Picked::up(height + 2.0 * (shoulder + thickness), 0.1, why)
}

/// Holder pressure on the flat of a flange, from where the shoulder ends to the edge \[mm\]: the largest of three.
///
/// The usual one of the metal; [`siebel`]'s; or that of the force that holds a flange down while it is bent over a shoulder that
/// ends at the radius a: the bend's full plastic moment R_m t²/4 per mm of circle, borne by the rim 8 t further out,
/// F = π a R_m t/16. Derived here but for the 8 t, which are declared; with less force the rim of a short cup rises before.
pub fn holder_pressure(usual: f64, ratio: f64, diameter: f64, [end, edge]: [f64; 2], t: f64, strength: f64) -> Picked {
    let force = 2.0 * PI * end * 0.25 * strength * t / HELD_OUT;
    // A blank that ends on the shoulder is refused elsewhere.
    let level = if edge > end { force / (PI * (edge * edge - end * end)) } else { 0.0 };
    let hinge = "π a R_m t/16 over its area: a hinge R_m t²/4 at the shoulder's end a, held 8 t further out (declared)";
    let usual = (usual, "usual for this metal: 2 to 2.5 for steel, 1.2 to 1.5 for aluminium (Tschätsch)");
    let by_siebel = "0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m: Siebel, after Kugler (2009)";
    let others = [(siebel(ratio, diameter, t, strength), by_siebel), (level, hinge)];
    let (pressure, rule) = others.into_iter().fold(usual, |most, next| if next.0 > most.0 { next } else { most });
    // Not rounded: the force is, upwards.
    Picked { value: pressure, why: format!("{pressure:.2} MPa on the flat of the flange, {rule}") }
}

/// Holder pressure on a strip, 1 % of the tensile strength: a declared rule of thumb, for it cannot wrinkle in plane strain.
pub fn strip_pressure(strength: f64) -> Picked {
    Picked::by(0.01 * strength, "1 % of the tensile strength on the flange, a declared rule of thumb")
}

/// Number of elements that would give 10 per 90° of the smallest radius if all were equal.
pub fn elements(length: f64, radius: f64) -> usize {
    (length * PER_QUARTER / (FRAC_PI_2 * radius)).ceil().clamp(40.0, 400.0) as usize
}

/// Width of a V: six times the punch's nose, because sheet bent in air takes a radius of V/6 (Amada).
pub fn v_width(nose: f64) -> Picked {
    Picked::nearest(6.0 * nose, 0.1, "6 noses: sheet bent in air takes a sixth of the V's width as its radius (Amada)")
}

/// Length of the mid-surface in a bend of 90° \[mm\].
pub fn quarter_bend(radius: f64, thickness: f64) -> f64 {
    FRAC_PI_2 * (radius + 0.5 * thickness)
}

/// Travel that turns the legs of a U upright: nose, shoulder and the sheet between, and two thicknesses of wall.
pub fn upright_travel(nose: f64, shoulder: f64, thickness: f64) -> Picked {
    let why = "nose, shoulder, the sheet and two thicknesses of wall: the legs stand upright";
    Picked::up(nose + shoulder + 3.0 * thickness, 0.1, why)
}

/// Pressure that holds a clamped disc of radius a at the height h as a spherical cap: p = 2 σ t/R with R = (a² + h²)/(2h),
/// pole strain ε = 2 ln(1 + h²/a²) and t = t₀ exp(−ε) (R. Hill, 1950, as usually quoted; not read).
pub fn bulge_pressure(opening: f64, height: f64, thickness: f64, stress: impl Fn(f64) -> f64) -> f64 {
    let cap = 1.0 + (height / opening).powi(2);
    let strain = 2.0 * cap.ln();
    let radius = 0.5 * opening * opening * cap / height;
    2.0 * stress(strain) * thickness * (-strain).exp() / radius
}

/// Pressure of oil that fills a corner, σ t/r with the flow stress at a strain \[MPa\]: to two digits, upwards.
pub fn filling_pressure(metal: &Material, strain: f64, thickness: f64, radius: f64) -> f64 {
    rounded_up(metal.hardening.at(strain).stress * thickness / radius, 2)
}

/// Holder force of a blank by the rules of [`holder_pressure`] without the usual one, which may be twice as much.
#[derive(Clone, Copy, Debug)]
pub struct HolderRule {
    /// Radius of the punch's mouth, and inner edge of the flat between holder and die \[mm\].
    pub punch: f64,
    /// Inner edge of the flat \[mm\].
    pub end: f64,
    /// \[mm\]
    pub thickness: f64,
    /// \[MPa\]
    pub strength: f64,
    /// Whether the case gives the holder a pressure.
    pub by_pressure: bool,
}

impl HolderRule {
    /// Pressure on a blank of this radius \[mm\] at its start \[MPa\].
    pub fn pressure(&self, blank: f64) -> f64 {
        let flat = [self.end, blank];
        holder_pressure(0.0, blank / self.punch, 2.0 * self.punch, flat, self.thickness, self.strength).value
    }

    /// Force on a blank of this radius \[mm\] at its start \[N\].
    pub fn force(&self, blank: f64) -> f64 {
        PI * (blank * blank - self.end * self.end) * self.pressure(blank)
    }
}
