//! `[tools.punch]`, `[tools.die]`, `[tools.holder]`.

use super::Section;
use crate::quantity::{Force, Fraction, Length, LineForce, NonNegative, Positive, Quantity, Speed};
use schemars::JsonSchema;
use serde::Deserialize;

/// The rigid tools; each is placed where it touches the flat sheet.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tools {
    pub punch: Option<Punch>,
    pub die: Option<Die>,
    pub holder: Option<Holder>,
}

/// The punch moves towards +z; exactly one of the shapes is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Punch {
    pub hemispherical: Option<Hemispherical>,
    pub flat: Option<Flat>,
    pub crowned: Option<Crowned>,
    /// A section of one's own, from the axis outward.
    pub profile: Option<Section>,
    /// Coulomb's coefficient of friction, 0 to 1.
    #[schemars(example = 0.08)]
    pub friction: Fraction,
    /// How far the punch goes from where it touches the flat sheet.
    #[schemars(example = "25 mm")]
    pub travel: Positive<Length>,
    /// Punch speed, 1 mm/s when not given; hardening without rate dependence does not feel it.
    #[schemars(example = "1 mm/s")]
    pub speed: Option<Positive<Speed>>,
}

/// Spherical nose (plane strain: cylindrical).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hemispherical {
    #[schemars(example = "25.4 mm")]
    pub radius: Positive<Length>,
}

/// Flat face, corner and straight wall.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flat {
    /// Radius of the wall (axisymmetric).
    #[schemars(example = "30 mm")]
    pub radius: Option<Positive<Length>>,
    /// Half width between the walls (plane strain).
    #[schemars(example = "30 mm")]
    pub half_width: Option<Positive<Length>>,
    /// Radius of the corner.
    #[schemars(example = "6 mm")]
    pub nose: Positive<Length>,
}

/// Gently curved face, corner and straight wall.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Crowned {
    /// Radius of the wall (axisymmetric).
    #[schemars(example = "330 mm")]
    pub radius: Option<Positive<Length>>,
    /// Half width between the walls (plane strain).
    #[schemars(example = "330 mm")]
    pub half_width: Option<Positive<Length>>,
    /// Radius of curvature of the face, larger than the punch's own radius.
    #[schemars(example = "2800 mm")]
    pub face: Positive<Length>,
    /// Radius of the corner.
    #[schemars(example = "10 mm")]
    pub nose: Positive<Length>,
}

/// The die stands still above the sheet: `throat` and `shoulder`, or a `profile`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Die {
    /// Radius of the opening (plane strain: half width).
    #[schemars(example = "31.25 mm")]
    pub throat: Option<Positive<Length>>,
    /// Radius of the corner over which the sheet is drawn.
    #[schemars(example = "6 mm")]
    pub shoulder: Option<Positive<Length>>,
    /// A section of one's own, from outside inward.
    pub profile: Option<Section>,
    /// Coulomb's coefficient of friction, 0 to 1.
    #[schemars(example = 0.08)]
    pub friction: Fraction,
}

/// The blank holder presses the sheet against the die: a flat ring from its inner radius outward, or a `profile`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Holder {
    /// Inner radius (axisymmetric).
    #[schemars(example = "32 mm")]
    pub inner_radius: Option<Positive<Length>>,
    /// Distance of its inner edge from the symmetry plane (plane strain).
    #[schemars(example = "341 mm")]
    pub inner_half_width: Option<Positive<Length>>,
    /// A section of one's own, from inside outward.
    pub profile: Option<Section>,
    /// Force of the whole ring ("80 kN"), or per depth of the modelled half in plane strain ("1300 N/mm").
    #[schemars(example = "10 kN")]
    pub force: HolderForce,
    /// Coulomb's coefficient of friction, 0 to 1; the die's when not given.
    #[schemars(example = 0.08)]
    pub friction: Option<Fraction>,
}

/// A force, or a force per length of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HolderForce {
    Ring(NonNegative<Force>),
    PerDepth(NonNegative<LineForce>),
}

impl<'de> Deserialize<'de> for HolderForce {
    fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        /// The text, after what is no text has been refused with the words of a force.
        struct Written;
        impl serde::de::Visitor<'_> for Written {
            type Value = HolderForce;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                write!(f, "a force with its unit, such as \"80 kN\" (axisymmetric) or \"1300 N/mm\" (plane strain)")
            }

            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<HolderForce, E> {
                let per_depth = crate::quantity::parse(text).is_ok_and(|p| p.dimension == LineForce::KIND.dimension);
                let force = if per_depth {
                    text.parse().map(HolderForce::PerDepth)
                } else {
                    text.parse().map(HolderForce::Ring)
                };
                force.map_err(E::custom)
            }

            fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<HolderForce, E> {
                self.visit_str(&value.to_string())
            }

            fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<HolderForce, E> {
                self.visit_str(&value.to_string())
            }
        }
        from.deserialize_any(Written)
    }
}

impl JsonSchema for HolderForce {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        "HolderForce".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "string", "examples": ["80 kN", "1300 N/mm"] })
    }
}
