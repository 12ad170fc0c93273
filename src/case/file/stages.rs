//! `[stage]` and `[[stages]]`: operations after the first one.

use super::{Crowned, Die, Flat, Friction, Given, Hemispherical, Holder, HolderForce, Punch, Section};
use crate::model::{Edge, Mode, ReleaseStiffness, Role};
use crate::units::{Length, NonNegative, Positive, Speed, Time};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, de};
use std::fmt;

/// The first stage, which is what the rest of the file describes.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct FirstStage {
    /// Names its folder where there are several stages; "forming" when not given.
    #[schemars(example = &"draw")]
    pub name: Option<String>,
}

/// One more operation on the same sheet; what is not said stays as in the stage before, but tools that went stand still.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Stage {
    /// Letters, digits, `-` and `_`: it names a folder.
    #[schemars(example = &"retract")]
    pub name: String,
    /// The punch, where it is new, moves or has another friction.
    pub punch: Option<StagePunch>,
    /// The die, likewise.
    pub die: Option<StageDie>,
    /// The holder, likewise, or with another force.
    pub holder: Option<StageHolder>,
    /// Tools that are no longer there.
    #[serde(default)]
    #[schemars(example = &("holder",))]
    pub remove: Vec<Role>,
    /// How the outer edge is held.
    pub edge: Option<Edge>,
    /// Sets equivalent strain and stress back to nothing before the stage.
    #[serde(default)]
    pub anneal: bool,
    /// Cuts the sheet at this current distance from the axis or symmetry plane before the stage; whole elements go.
    #[schemars(example = "80 mm")]
    pub trim: Option<Positive<Length>>,
    /// How the metal answers to strain.
    pub mode: Option<Mode>,
    /// Takes the tools away: the forces of contact fade to nothing, and the sheet springs back. True, or the stiffness that it
    /// is iterated with: "updated", which true means, or "constant".
    pub release: Option<Release>,
    /// Speed of the tool that goes furthest; that of the first stage when not given.
    #[schemars(example = "1 mm/s")]
    pub speed: Option<Positive<Speed>>,
    /// Instead of the speed; 1 s where no tool goes anywhere and it is not given.
    #[schemars(example = "2 s")]
    pub duration: Option<Positive<Time>>,
    /// Number of equally spaced instants that are kept, 1 to 1000; 4 when not given.
    #[schemars(range(min = 1, max = 1000), example = 4)]
    pub frames: Option<i64>,
}

/// The punch of a later stage; a shape makes it a new one, which is brought up from below until it touches the sheet.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct StagePunch {
    /// How far it goes along z in the stage, towards the die where positive.
    #[serde(rename = "move")]
    #[schemars(example = "-30 mm")]
    pub axial: Option<Length>,
    /// How far it goes away from the axis or symmetry plane in the stage.
    #[schemars(example = "5 mm")]
    pub aside: Option<Length>,
    /// As in the first stage.
    #[schemars(example = 0.08)]
    pub friction: Option<Friction>,
    /// A new punch with a spherical nose.
    pub hemispherical: Option<Hemispherical>,
    /// A new punch with a flat face.
    pub flat: Option<Flat>,
    /// A new punch with a gently curved face.
    pub crowned: Option<Crowned>,
    /// A section of one's own, from the axis outward.
    pub profile: Option<Section>,
}

/// The die of a later stage; a shape makes it a new one, which is brought down from above until it touches the sheet.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct StageDie {
    /// How far it goes along z in the stage, away from the punch where positive.
    #[serde(rename = "move")]
    #[schemars(example = "30 mm")]
    pub axial: Option<Length>,
    /// How far it goes away from the axis or symmetry plane in the stage.
    #[schemars(example = "5 mm")]
    pub aside: Option<Length>,
    /// As in the first stage.
    #[schemars(example = 0.08)]
    pub friction: Option<Friction>,
    /// Radius of the opening (plane strain: half width).
    #[schemars(example = "31.25 mm")]
    pub throat: Option<Positive<Length>>,
    /// Radius of the corner over which the sheet is drawn.
    #[schemars(example = "6 mm")]
    pub shoulder: Option<Positive<Length>>,
    /// A section of one's own, from outside inward.
    pub profile: Option<Section>,
}

/// The blank holder of a later stage; a shape makes it a new one, which is brought up from below until it touches the sheet.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct StageHolder {
    /// How far it goes along z in the stage, away from the die where negative; it then has no force.
    #[serde(rename = "move")]
    #[schemars(example = "-5 mm")]
    pub axial: Option<Length>,
    /// How far it goes away from the axis or symmetry plane in the stage.
    #[schemars(example = "5 mm")]
    pub aside: Option<Length>,
    /// As in the first stage, a history over the travel of this one. One force is reached from that of the stage before over
    /// the first fifth of the travel, at once where nothing moves.
    #[schemars(example = "20 N")]
    pub force: Option<Given<NonNegative<Length>, HolderForce>>,
    /// As in the first stage.
    #[schemars(example = 0.08)]
    pub friction: Option<Friction>,
    /// Inner radius (axisymmetric).
    #[schemars(example = "32 mm")]
    pub inner_radius: Option<Positive<Length>>,
    /// Distance of its inner edge from the symmetry plane (plane strain).
    #[schemars(example = "341 mm")]
    pub inner_half_width: Option<Positive<Length>>,
    /// A section of one's own, from inside outward.
    pub profile: Option<Section>,
}

impl From<StagePunch> for Punch {
    fn from(new: StagePunch) -> Self {
        let StagePunch { hemispherical, flat, crowned, profile, friction, .. } = new;
        Self { hemispherical, flat, crowned, profile, friction, ..Self::default() }
    }
}

impl From<StageDie> for Die {
    fn from(new: StageDie) -> Self {
        let StageDie { throat, shoulder, profile, friction, .. } = new;
        Self { throat, shoulder, profile, friction }
    }
}

impl From<StageHolder> for Holder {
    fn from(new: StageHolder) -> Self {
        let StageHolder { inner_radius, inner_half_width, profile, force, friction, .. } = new;
        Self { inner_radius, inner_half_width, profile, force, friction, ..Self::default() }
    }
}

/// Whether the tools are taken away, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Release(pub Option<ReleaseStiffness>);

impl<'de> Deserialize<'de> for Release {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Either;
        impl de::Visitor<'_> for Either {
            type Value = Release;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "true, false, \"updated\" or \"constant\"")
            }

            fn visit_bool<E: de::Error>(self, on: bool) -> Result<Release, E> {
                Ok(Release(on.then_some(ReleaseStiffness::Updated)))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Release, E> {
                ReleaseStiffness::deserialize(de::value::StrDeserializer::new(text)).map(|s| Release(Some(s)))
            }
        }
        from.deserialize_any(Either)
    }
}

impl JsonSchema for Release {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Release".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let (switch, stiffness) = (generator.subschema_for::<bool>(), generator.subschema_for::<ReleaseStiffness>());
        schemars::json_schema!({ "anyOf": [switch, stiffness] })
    }
}
