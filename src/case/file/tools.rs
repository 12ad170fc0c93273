//! `[tools]` and the tools of `[[stages]]`.

use super::untagged::untagged;
use super::{Given, HolderForce, Section, Stiffness};
use crate::contact::friction;
use crate::material::law::Family;
use crate::model::Role;
use crate::units::{Dimensioned, Fraction, Length, LineForce, NonNegative, Positive, Speed, Stress, Time};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::IntoDeserializer;

/// The friction law of one tool: Coulomb's coefficient, 0 to 1, or exactly one other law.
#[derive(Clone, Copy, Debug, PartialEq, JsonSchema)]
#[schemars(untagged)]
pub enum Friction {
    /// Coulomb's coefficient.
    Coefficient(Fraction),
    /// Another law with its parameters.
    Law(friction::FrictionTable),
}

impl Friction {
    /// Laws that it gives.
    pub fn laws(self) -> Vec<friction::Friction> {
        match self {
            Self::Coefficient(coefficient) => vec![coefficient.value().into()],
            Self::Law(table) => friction::Friction::named(table),
        }
    }
}

untagged!(
    [] Friction, "a plain number, such as 0.1, or a law, such as { tresca = { factor = 0.2 } }",
    number(number) => Fraction::deserialize(number.into_deserializer()).map(Friction::Coefficient),
    table => Friction::Law
);

/// Friction by the face of the sheet, for tools without their own, and the source of all friction numbers.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sides {
    /// Face that punch and holder touch: a coefficient, 0 to 1, or a law.
    #[schemars(example = 0.08)]
    pub punch_side: Option<Friction>,
    /// Face that the die touches: a coefficient, 0 to 1, or a law.
    #[schemars(example = 0.08)]
    pub die_side: Option<Friction>,
    /// Source of the coefficients of all tools: how they were measured, or author and year; left out if they are assumed.
    #[schemars(example = &"strip drawing with this oil")]
    pub source: Option<String>,
}

/// The rigid tools; each is placed where it touches the flat sheet.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tools {
    /// Punch, below the sheet.
    pub punch: Option<Punch>,
    /// Die, above the sheet.
    pub die: Option<Die>,
    /// Blank holder, below the sheet.
    pub holder: Option<Holder>,
    /// Draw beads across the flange, as line restraints.
    #[serde(default)]
    pub beads: Vec<Bead>,
}

/// Keys that all tools have.
#[derive(Clone, Copy, Debug)]
pub struct ToolKeys<'a> {
    /// Role.
    pub role: Role,
    /// Section of its own.
    pub profile: Option<&'a Section>,
    /// Friction of its own.
    pub friction: Option<Friction>,
    /// Moves of a later stage, away from the axis or symmetry plane and along z.
    pub moves: [Option<Length>; 2],
    /// True if it has a shape, which in a later stage makes it a new tool.
    pub is_shaped: bool,
}

macro_rules! tool_keys {
    ($tool:expr, $role:ident, $($shape:ident)+) => {
        $tool.as_ref().map(|tool| ToolKeys {
            role: Role::$role,
            profile: tool.profile.as_ref(),
            friction: tool.friction,
            moves: [tool.aside, tool.axial],
            is_shaped: tool.profile.is_some() $(|| tool.$shape.is_some())+,
        })
    };
}

impl Tools {
    /// Common keys of each tool, in the order of their roles.
    pub fn keys(&self) -> impl Iterator<Item = ToolKeys<'_>> {
        let punch = tool_keys!(self.punch, Punch, hemispherical flat crowned);
        let die = tool_keys!(self.die, Die, throat throat_diameter shoulder);
        let holder = tool_keys!(self.holder, Holder, inner_radius inner_diameter inner_half_width);
        [punch, die, holder].into_iter().flatten()
    }
}

/// Draw bead as a line restraint: it holds the sheet back while the sheet passes it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [{ "required": ["at"] }, { "required": ["diameter"] }]))]
pub struct Bead {
    /// Distance of its line from the axis or symmetry plane.
    #[schemars(example = "70 mm")]
    pub at: Option<Positive<Length>>,
    /// Diameter of its line, instead of `at`, of a round part.
    #[schemars(example = "140 mm")]
    pub diameter: Option<Positive<Length>>,
    /// Restraining force per length of the line, of which a plane section has one on each side.
    #[schemars(example = "100 N/mm")]
    pub restraining: NonNegative<LineForce>,
    /// Closing force per length of the line, taken from the holder's force; none when not given.
    #[schemars(example = "150 N/mm")]
    pub closing: Option<NonNegative<LineForce>>,
}

/// Punch, moving towards +z; exactly one of the shapes is given. In a later stage a shape makes it a new one, which is brought
/// up from below until it touches the sheet.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
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
    /// Punch travel from where it touches the flat sheet.
    #[schemars(example = "25 mm")]
    pub travel: Option<Positive<Length>>,
    /// Punch speed, 1 mm/s when not given; hardening without rate dependence does not feel it.
    #[schemars(example = "1 mm/s")]
    pub speed: Option<Positive<Speed>>,
    /// Instead of travel and speed: the travel over time, rising from 0 mm at 0 s, straight between its points; the last one is
    /// the whole travel.
    #[schemars(example = &(("0 s", "0 mm"), ("2 s", "10 mm"), ("4 s", "30 mm")))]
    pub motion: Option<Vec<(NonNegative<Time>, NonNegative<Length>)>>,
    /// Later stages: distance along z, towards the die where positive.
    #[serde(rename = "move")]
    #[schemars(example = "-30 mm")]
    pub axial: Option<Length>,
    /// Later stages: distance away from the axis or symmetry plane.
    #[schemars(example = "5 mm")]
    pub aside: Option<Length>,
}

/// Spherical nose (plane strain: cylindrical).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [{ "required": ["radius"] }, { "required": ["diameter"] }]))]
pub struct Hemispherical {
    /// Radius of the nose and of the wall.
    #[schemars(example = "25.4 mm")]
    pub radius: Option<Positive<Length>>,
    /// Diameter, instead of `radius`, of a round punch.
    #[schemars(example = "50.8 mm")]
    pub diameter: Option<Positive<Length>>,
}

/// Flat face, corner and straight wall.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flat {
    /// Radius of the wall (axisymmetric).
    #[schemars(example = "30 mm")]
    pub radius: Option<Positive<Length>>,
    /// Diameter of the wall, instead of `radius`.
    #[schemars(example = "60 mm")]
    pub diameter: Option<Positive<Length>>,
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
    /// Diameter of the wall, instead of `radius`.
    #[schemars(example = "660 mm")]
    pub diameter: Option<Positive<Length>>,
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

/// Die, standing still above the sheet: `throat` and `shoulder`, or a `profile`. In a later stage a shape makes it a new one,
/// which is brought down from above until it touches the sheet.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "throat": ["shoulder"], "throat_diameter": ["shoulder"] }))]
pub struct Die {
    /// Radius of the opening (plane strain: half width).
    #[schemars(example = "31.25 mm")]
    pub throat: Option<Positive<Length>>,
    /// Diameter of the opening, instead of `throat`, of a round die.
    #[schemars(example = "62.5 mm")]
    pub throat_diameter: Option<Positive<Length>>,
    /// Radius of the corner over which the sheet is drawn.
    #[schemars(example = "6 mm")]
    pub shoulder: Option<Positive<Length>>,
    /// A section of one's own, from outside inward.
    pub profile: Option<Section>,
    /// Coulomb's coefficient of friction, 0 to 1, or another law; that of its side of the sheet when not given.
    #[schemars(example = 0.08)]
    pub friction: Option<Friction>,
    /// Later stages: distance along z, away from the punch where positive.
    #[serde(rename = "move")]
    #[schemars(example = "30 mm")]
    pub axial: Option<Length>,
    /// Later stages: distance away from the axis or symmetry plane.
    #[schemars(example = "5 mm")]
    pub aside: Option<Length>,
}

/// Blank holder, pressing the sheet against the die: a flat ring from its inner radius outward, or a `profile`. In a later stage
/// a shape makes it a new one, which is brought up from below until it touches the sheet.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Holder {
    /// Inner radius (axisymmetric).
    #[schemars(example = "32 mm")]
    pub inner_radius: Option<Positive<Length>>,
    /// Inner diameter, instead of `inner_radius`.
    #[schemars(example = "64 mm")]
    pub inner_diameter: Option<Positive<Length>>,
    /// Distance of its inner edge from the symmetry plane (plane strain).
    #[schemars(example = "341 mm")]
    pub inner_half_width: Option<Positive<Length>>,
    /// A section of one's own, from inside outward. Where it and the die cannot both lie on the flat sheet, for a bead or a slope,
    /// the holder closes over the sheet before the punch comes.
    pub profile: Option<Section>,
    /// Force of the whole holder ("80 kN"); in plane strain on both sides of the symmetry plane together, per mm of depth
    /// ("2600 N/mm"), or in all where blank.depth is given. Or its history over the punch travel: [["0 mm", "40 kN"],
    /// ["20 mm", "80 kN"]]. The holder's position follows. In a later stage one force is reached from the last one over the first
    /// fifth of the travel, at once where nothing moves.
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
    /// Later stages: distance along z, away from the die where negative; it then has no force.
    #[serde(rename = "move")]
    #[schemars(example = "-5 mm")]
    pub axial: Option<Length>,
    /// Later stages: distance away from the axis or symmetry plane.
    #[schemars(example = "5 mm")]
    pub aside: Option<Length>,
}

/// Soft holder.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Force where the holder touches the flat sheet, of the whole holder as `force`.
    #[schemars(example = "10 kN")]
    pub preload: HolderForce,
    /// Force per move of the whole holder, "5 kN/mm"; in plane strain per depth as well, "50 N/mm^2", unless blank.depth is
    /// given.
    #[schemars(example = "5 kN/mm")]
    pub stiffness: Stiffness,
}
