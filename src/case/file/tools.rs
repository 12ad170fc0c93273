//! `[tools.punch]`, `[tools.die]`, `[tools.holder]`, `[[tools.beads]]`.

use super::{Friction, Given, Section};
use crate::units::{Dimensioned, Force, Length, LineForce, NonNegative, Positive, Speed, Stress, Time};
use schemars::JsonSchema;
use serde::Deserialize;

/// The rigid tools; each is placed where it touches the flat sheet.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Tools {
    /// The punch, below the sheet.
    pub punch: Option<Punch>,
    /// The die, above the sheet.
    pub die: Option<Die>,
    /// The blank holder, below the sheet.
    pub holder: Option<Holder>,
    /// Draw beads across the flange, as line restraints.
    #[serde(default)]
    pub beads: Vec<Bead>,
}

/// A draw bead as a line restraint: it holds the sheet back while the sheet passes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Bead {
    /// Distance of its line from the axis or symmetry plane.
    #[schemars(example = "70 mm")]
    pub at: Positive<Length>,
    /// Restraining force per length of the line, of which a plane section has one on each side.
    #[schemars(example = "100 N/mm")]
    pub restraining: NonNegative<LineForce>,
    /// Closing force per length of the line, taken from the holder's force; none when not given.
    #[schemars(example = "150 N/mm")]
    pub closing: Option<NonNegative<LineForce>>,
}

/// The punch moves towards +z; exactly one of the shapes is given.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Punch {
    /// Spherical nose.
    pub hemispherical: Option<Hemispherical>,
    /// Flat face, corner and straight wall.
    pub flat: Option<Flat>,
    /// Gently curved face, corner and straight wall.
    pub crowned: Option<Crowned>,
    /// A section of one's own, from the axis outward.
    pub profile: Option<Section>,
    /// Coulomb's coefficient of friction, 0 to 1, or another law; that of its side of the sheet when not given.
    #[schemars(example = 0.08)]
    pub friction: Option<Friction>,
    /// How far the punch goes from where it touches the flat sheet.
    #[schemars(example = "25 mm")]
    pub travel: Option<Positive<Length>>,
    /// Punch speed, 1 mm/s when not given; hardening without rate dependence does not feel it.
    #[schemars(example = "1 mm/s")]
    pub speed: Option<Positive<Speed>>,
    /// Instead of travel and speed: the travel over time, rising from 0 mm at 0 s, straight between its points; the last one is
    /// the whole travel.
    #[schemars(example = &(("0 s", "0 mm"), ("2 s", "10 mm"), ("4 s", "30 mm")))]
    pub motion: Option<Vec<(NonNegative<Time>, NonNegative<Length>)>>,
}

/// Spherical nose (plane strain: cylindrical).
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Hemispherical {
    /// Radius of the nose and of the wall.
    #[schemars(example = "25.4 mm")]
    pub radius: Positive<Length>,
}

/// Flat face, corner and straight wall.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
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
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
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
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
#[schemars(extend("dependentRequired" = { "throat": ["shoulder"] }))]
pub struct Die {
    /// Radius of the opening (plane strain: half width).
    #[schemars(example = "31.25 mm")]
    pub throat: Option<Positive<Length>>,
    /// Radius of the corner over which the sheet is drawn.
    #[schemars(example = "6 mm")]
    pub shoulder: Option<Positive<Length>>,
    /// A section of one's own, from outside inward.
    pub profile: Option<Section>,
    /// Coulomb's coefficient of friction, 0 to 1, or another law; that of its side of the sheet when not given.
    #[schemars(example = 0.08)]
    pub friction: Option<Friction>,
}

/// The blank holder presses the sheet against the die: a flat ring from its inner radius outward, or a `profile`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Holder {
    /// Inner radius (axisymmetric).
    #[schemars(example = "32 mm")]
    pub inner_radius: Option<Positive<Length>>,
    /// Distance of its inner edge from the symmetry plane (plane strain).
    #[schemars(example = "341 mm")]
    pub inner_half_width: Option<Positive<Length>>,
    /// A section of one's own, from inside outward. Where it and the die cannot both lie on the flat sheet, for a bead or a slope,
    /// the holder closes over the sheet before the punch comes.
    pub profile: Option<Section>,
    /// Force of the whole holder ("80 kN"); in plane strain on both sides of the symmetry plane together, per mm of depth
    /// ("2600 N/mm"), or in all where blank.depth is given. Or its history over the punch travel: [["0 mm", "40 kN"],
    /// ["20 mm", "80 kN"]]. The holder's position follows.
    #[schemars(example = "10 kN")]
    pub force: Option<Given<NonNegative<Length>, HolderForce>>,
    /// Pressure times the initial area between holder and the die's flat: a force that stays.
    #[schemars(example = "2.5 MPa")]
    pub pressure: Option<NonNegative<Stress>>,
    /// Fixed distance between the faces of holder and die: distance blocks.
    #[schemars(example = "1.1 mm")]
    pub gap: Option<Positive<Length>>,
    /// Springs or a cushion: the force grows as the holder is pushed away from the die.
    pub spring: Option<Spring>,
    /// Coulomb's coefficient of friction, 0 to 1, or another law; that of the punch's side or of the die when not given.
    #[schemars(example = 0.08)]
    pub friction: Option<Friction>,
}

/// A soft holder.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Spring {
    /// Force where the holder touches the flat sheet, of the whole holder as `force`.
    #[schemars(example = "10 kN")]
    pub preload: HolderForce,
    /// Force per move of the whole holder, "5 kN/mm"; in plane strain per depth as well, "50 N/mm^2", unless blank.depth is
    /// given.
    #[schemars(example = "5 kN/mm")]
    pub stiffness: Stiffness,
}

/// A stiffness of the whole holder: force per length, or force per length and depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stiffness {
    /// In all: axisymmetric, or in plane strain over a depth that is known.
    InAll(NonNegative<LineForce>),
    /// Per mm of depth, plane strain.
    PerDepth(NonNegative<Stress>),
}

/// A force of the whole section, or per mm of its depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HolderForce {
    /// In all: axisymmetric, or in plane strain over a depth that is known.
    InAll(NonNegative<Force>),
    /// Per mm of depth, plane strain.
    PerDepth(NonNegative<LineForce>),
}

/// Reads and describes an enum of one quantity in all and another per depth.
macro_rules! in_all_or_per_depth {
    ($type:ident, $in_all:ty, $per_depth:ty, $expected:literal, $name:literal, $examples:expr) => {
        impl<'de> Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                /// The text, after what is no text has been refused with the words of the quantity.
                struct Written;
                impl serde::de::Visitor<'_> for Written {
                    type Value = $type;

                    fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                        write!(f, $expected)
                    }

                    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<$type, E> {
                        let per_depth = crate::units::parse(text)
                            .is_ok_and(|p| p.dimension == <$per_depth as Dimensioned>::KIND.dimension);
                        let read = if per_depth {
                            text.parse().map($type::PerDepth)
                        } else {
                            text.parse().map($type::InAll)
                        };
                        read.map_err(E::custom)
                    }

                    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<$type, E> {
                        self.visit_str(&value.to_string())
                    }

                    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<$type, E> {
                        self.visit_str(&value.to_string())
                    }
                }
                from.deserialize_any(Written)
            }
        }

        impl JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                $name.into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let kinds = [<$in_all as Dimensioned>::KIND, <$per_depth as Dimensioned>::KIND];
                let pattern = crate::units::pattern(&kinds);
                let quantity = kinds.map(crate::units::Kind::measured).join(", or ");
                schemars::json_schema!({ "type": "string", "examples": $examples, "pattern": pattern, "x-quantity": quantity })
            }
        }
    };
}

in_all_or_per_depth!(
    HolderForce,
    NonNegative<Force>,
    NonNegative<LineForce>,
    "a force with its unit, such as \"80 kN\" (axisymmetric) or \"2600 N/mm\" (plane strain)",
    "HolderForce",
    ["80 kN", "2600 N/mm"]
);
in_all_or_per_depth!(
    Stiffness,
    NonNegative<LineForce>,
    NonNegative<Stress>,
    "a stiffness with its unit, such as \"5 kN/mm\" (axisymmetric) or \"50 N/mm^2\" (plane strain)",
    "Stiffness",
    ["5 kN/mm", "50 N/mm^2"]
);
