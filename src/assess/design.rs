//! Rules of die design that pick what is not given, each with its source. Lengths in mm, stresses in MPa.
//!
//! # References
//! *4ming*: Interactive Sheet Metal Forming Technical Guide, 4Ming e.K. (4ming.de/en/forming-handbook), pages "Punch
//! radius", "Die clearance" and "Clearance according to Oehler/Kaiser" with its table of draw ratios. The books that it
//! quotes (Tschätsch 2003; Semmlinger, Hellwig 1990; Oehler, Kaiser 1993; Lange 1990) were not read. *Amada*: Bending
//! procedures, table "Die V-width selection" (amada.de). What has no source that could be read is called a declared rule of
//! thumb.

use crate::material::Material;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Radius over thickness below which shells are no longer thin \[–\]: a declared rule of thumb.
pub const THIN: f64 = 5.0;
/// Radius over thickness below which a bend is no longer a shell's at all \[–\], its outer fibre strained by a fifth: a
/// declared rule of thumb.
pub const SHARP: f64 = 2.0;
/// Blank over punch that one draw of mild steel reaches \[–\]: a declared rule of thumb, above 4ming's table. A higher r̄ reaches
/// more, a lower one less.
pub const LIMITING_RATIO: f64 = 2.2;
/// A draw ratio above this is close to the limit: that of DC04 for a punch of 100 mm (4ming, table of draw ratios).
pub const CAREFUL_RATIO: f64 = 2.0;
/// First cup over redrawn cup, of DC04 in the second draw (4ming, table of draw ratios).
pub const REDRAW_RATIO: f64 = 1.3;
/// Largest reduction of a wall's thickness by ironing in one pass \[–\]: the layout of a drawn and ironed cylinder keeps its
/// section's reduction below 35 % at each ironing die, and below 50 % in a stage that redraws and irons (Chinese Journal of
/// Mechanical Engineering 2022, doi 10.1186/s10033-022-00681-9, table 8). The Library of Manufacturing, "Ironing of sheet
/// metal" (thelibraryofmanufacturing.com/ironing.html), calls 40 % to 60 % usual and does not say in how many passes; the
/// lower one is kept.
pub const IRONING_LIMIT: f64 = 0.35;
/// Radius over thickness of tools [–]: see [`tool_radius`].
const RADIUS: f64 = 6.0;
/// How far from its bend a flange's rim is held down, over the thickness \[–\]: see [`levelling_force`].
const HELD_OUT: f64 = 8.0;
/// Elements per 90° of the sharpest corner that a blank of equal elements would have [–].
const PER_QUARTER: f64 = 10.0;
/// Height for which a blank is made beyond the wanted one, over that one [–]: a declared rule of thumb.
pub const TRIM: f64 = 0.08;
/// Reason of [`TRIM`].
pub const TRIMMED: &str = "because the rim thickens (declared)";
/// How far a rim has gone round the die's shoulder when a cup counts as drawn [rad].
const RIM: f64 = FRAC_PI_4;

/// Tensile strength \[MPa\]: largest nominal stress σ exp(−ε), reached where dσ/dε = σ (A. Considère, 1885).
pub fn tensile_strength(material: &Material) -> f64 {
    let strains = (0..=2000).map(|i| f64::from(i) * 5e-4);
    strains.map(|strain| material.monotonic(strain, 0.0).stress * (-strain).exp()).fold(0.0, f64::max)
}

/// The pressure that keeps a flange from wrinkling \[MPa\], usually named after Siebel, with the punch diameter d and the
/// draw ratio β: p = 0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m.
///
/// # References
/// Read in: 4ming, Forming handbook, "Blankholder pressure", equation 1 (4ming.de/en/forming-handbook/blankholder-pressure),
/// p = [(β₀ − 1)² + d₁/(200 s₀)] R_m/400, after H. Kugler, Umformtechnik, Hanser, München (2009): for steel on steel with
/// drawing oil, and up to four times as much with drawing foil on both sides. Not read: E. Siebel, H. Beisswänger,
/// Tiefziehen, Hanser, München (1955); H. Tschätsch, Metal Forming Practise, which is quoted with the same form; books
/// that are said to have (β − 1)³ with factors from 0.002 to 0.003. At β = 2 both forms agree; below it the square asks
/// for more.
pub fn siebel(beta: f64, diameter: f64, thickness: f64, strength: f64) -> f64 {
    0.0025 * ((beta - 1.0).powi(2) + 0.5 * diameter / (100.0 * thickness)) * strength
}

/// Share of the strength in plane-strain tension that a sheet carries where it is bent over a radius a \[–\], of the radius
/// over the thickness ρ = a/t:
///
/// ```text
/// dσ_r/dr = (σ_θ − σ_r)/r,  σ_θ − σ_r = σ,  σ_r(a + t) = 0     →    N = ∫ σ_θ dr = a σ ln(1 + t/a),   N/(σ t) = ρ ln(1 + 1/ρ)
/// ```
///
/// of a metal that flows through the whole section and hardens no more: the tool's pressure N/a does a part of the straining.
/// Derived here; 0.95 at ten thicknesses, 0.91 at five, 0.81 at two.
pub fn bent_strength(ratio: f64) -> f64 {
    ratio * ratio.recip().ln_1p()
}

/// A number and the rule that picked it; no rule where it was given.
#[derive(Clone, Debug, PartialEq)]
pub struct Picked {
    /// The number, in the solver's unit.
    pub value: f64,
    /// The rule, in words; empty where the number was given.
    pub why: String,
}

impl Picked {
    /// By a rule; lengths and forces are kept to a thousandth, as the case file has them.
    pub fn by(value: f64, why: impl Into<String>) -> Self {
        Self { value: (value * 1e3).round() / 1e3, why: why.into() }
    }

    /// A number that the user has given.
    pub fn given(value: f64) -> Self {
        Self { value, why: String::new() }
    }

    /// The number that the user has given, or what a rule picks.
    pub fn or(given: Option<f64>, rule: impl FnOnce() -> Self) -> Self {
        given.map_or_else(rule, Self::given)
    }

    /// Whether the user has given it.
    pub fn is_given(&self) -> bool {
        self.why.is_empty()
    }

    /// The rule behind a lead, as in `, 6 thicknesses`; empty where the number was given.
    pub fn reason(&self, lead: &str) -> String {
        if self.is_given() { String::new() } else { format!("{lead}{}", self.why) }
    }
}

/// Radius of a punch's nose or a die's shoulder, 6 t: above the 4 to 5 thicknesses that 4ming asks of a punch ("Punch
/// radius", equation 1), and above the 5 below which shells are no longer thin. For the shoulder a declared rule of thumb.
pub fn tool_radius(thickness: f64) -> Picked {
    Picked::by(RADIUS * thickness, "6 thicknesses: a punch wants 4 to 5 (4ming), shells want 5")
}

/// Radius of the shoulder of a die that the whole blank is drawn through: that of [`tool_radius`] for the thickest that comes
/// over it, the rim, which arrives t' = t β^(1/(1 + r̄)) thick (compressed round the axis alone). It is bent to 6.5 of its own
/// thicknesses then, above the 5 of thin shells by more than meshes and steps move that.
pub fn drawn_shoulder(thickness: f64, ratio: f64, anisotropy: f64) -> Picked {
    let rim = RADIUS * thickness * ratio.powf(1.0 / (1.0 + anisotropy));
    let why = format!(
        "{RADIUS} thicknesses of the rim, t β^(1/(1 + r̄)) thick, β = {ratio:.2}: shells want {THIN} with a margin (declared)"
    );
    Picked::by(0.01 * (100.0 * rim).ceil(), why)
}

/// Gap between punch and die of a cup, t √β: as thick as the rim of a blank becomes that is drawn in by the ratio β and
/// not stretched, so that it is not ironed (4ming, "Die clearance", equation 1, where it is the largest clearance).
pub fn drawing_clearance(thickness: f64, ratio: f64) -> Picked {
    Picked::by(
        thickness * ratio.sqrt(),
        format!("t √β with the draw ratio β = {ratio:.2}, so that the rim is not ironed (4ming)"),
    )
}

/// Gap of a strip, which thickens nowhere, 1.1 t: a declared rule of thumb.
pub fn strip_clearance(thickness: f64) -> Picked {
    Picked::by(1.1 * thickness, "1.1 thicknesses, a declared rule of thumb: a strip does not thicken")
}

/// Area of the mid-surface of a cup by Guldin's (Pappus') rule: bottom, quarter of a torus, wall.
///
/// `radius` and `nose` are those of the mid-surface, `height` goes from the bottom's mid-surface to the rim \[mm\].
/// With d = 2 `radius` it is π/4 of d² + 4 d h − (8 − 2π) r d + (12 − 4π) r², that is d² + 4 d h − 1.72 r d − 0.57 r².
pub fn cup_area(radius: f64, nose: f64, height: f64) -> f64 {
    let flat = radius - nose;
    let corner = 2.0 * PI * (flat + 2.0 * nose / PI) * FRAC_PI_2 * nose;
    PI * flat * flat + corner + 2.0 * PI * radius * (height - nose)
}

/// Radius of a blank of this area \[mm²\]: the sheet keeps its area, its mean thickness hardly changing.
pub fn blank_of(area: f64) -> f64 {
    (area / PI).sqrt()
}

/// Travel at which a cup of this overall height has its rim half way (45°) round the shoulder: the flange is used up, and
/// the die still guides the edge. The mid-surface rises by (r + t/2)(1 − cos 45°) on that way.
pub fn drawn_travel(height: f64, shoulder: f64, thickness: f64) -> Picked {
    let risen = (shoulder + 0.5 * thickness) * (1.0 - RIM.cos());
    Picked::by(height - thickness + risen, "until the rim stands half way round the die's shoulder: no flange is left")
}

/// Force on a whole ring that holds a flange down while it is bent over a shoulder that ends at the radius a \[N\]: the bend's
/// full plastic moment R_m t²/4 per mm of circle, borne by the rim 8 t further out, F = 2π a R_m t²/4/(8 t) = π a R_m t/16.
/// Derived here but for the 8 t, which are declared: a flange that is narrower soon runs out. With less force the rim of a short
/// cup rises before.
pub fn levelling_force(shoulder_end: f64, thickness: f64, strength: f64) -> f64 {
    2.0 * PI * shoulder_end * 0.25 * strength * thickness / HELD_OUT
}

/// A template's holder pressure on the flat of a flange, from where the shoulder ends to the edge \[mm\]: [`siebel`]'s, or the
/// one of [`levelling_force`] where that is more.
pub fn holder_pressure(ratio: f64, diameter: f64, [end, edge]: [f64; 2], thickness: f64, strength: f64) -> Picked {
    let siebel = siebel(ratio, diameter, thickness, strength);
    let level = levelling_force(end, thickness, strength) / (PI * (edge * edge - end * end));
    // Of a blank that ends on the shoulder there is nothing to hold, which is refused elsewhere.
    let (pressure, rule) = if edge > end && level > siebel {
        (
            level,
            "π a R_m t/16 over its area: a plastic hinge R_m t²/4 at the shoulder's end a, held 8 t further out (declared)",
        )
    } else {
        (siebel, "0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m: Siebel, after Kugler (2009)")
    };
    let why = format!("{pressure:.2} MPa on the flat of the flange, {rule}");
    // Not rounded: the force is, upwards.
    Picked { value: pressure, why }
}

/// Holder pressure on a strip, 1 % of the tensile strength: a declared rule of thumb, for it cannot wrinkle in plane strain.
pub fn strip_pressure(strength: f64) -> Picked {
    Picked::by(0.01 * strength, "1 % of the tensile strength on the flange, a declared rule of thumb")
}

/// Elements: as many as give 10 per 90° of the smallest radius if all were equal; the mesh is finer at the radii then.
pub fn elements(length: f64, radius: f64) -> usize {
    (length * PER_QUARTER / (FRAC_PI_2 * radius)).ceil().clamp(40.0, 400.0) as usize
}

/// Width of a V: six times the punch's nose, for sheet bent in air over a V takes an inner radius of a sixth of its width
/// (Amada, "iR becomes approx. iR = V/6").
pub fn v_width(nose: f64) -> Picked {
    Picked::by(6.0 * nose, "6 noses: sheet bent in air takes a sixth of the V's width as its radius (Amada)")
}

/// Length of the mid-surface in a bend of 90° \[mm\].
pub fn quarter_bend(radius: f64, thickness: f64) -> f64 {
    FRAC_PI_2 * (radius + 0.5 * thickness)
}

/// Travel that turns the legs of a U upright: nose, shoulder and the sheet between, and two thicknesses of wall.
pub fn upright_travel(nose: f64, shoulder: f64, thickness: f64) -> Picked {
    Picked::by(
        nose + shoulder + 3.0 * thickness,
        "nose, shoulder, the sheet and two thicknesses of wall: the legs stand upright",
    )
}

/// Pressure that holds a clamped disc of radius a at the height h as a spherical cap: p = 2 σ t/R with R = (a² + h²)/(2h),
/// pole strain ε = 2 ln(1 + h²/a²) and t = t₀ exp(−ε) (R. Hill, 1950, as usually quoted; not read).
pub fn bulge_pressure(opening: f64, height: f64, thickness: f64, stress: impl Fn(f64) -> f64) -> f64 {
    let cap = 1.0 + (height / opening).powi(2);
    let strain = 2.0 * cap.ln();
    let radius = 0.5 * opening * opening * cap / height;
    2.0 * stress(strain) * thickness * (-strain).exp() / radius
}
