//! `[stage]` and `[[stages]]`: operations after the first one.

use super::untagged::{inline_schema, untagged};
use super::{Die, Holder, Punch};
use crate::model::{Edge, Mode, ReleaseStiffness, Role};
use crate::units::{Length, Positive, Speed, Time};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::IntoDeserializer;

/// First stage, which the rest of the file describes.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FirstStage {
    /// Names its folder where there are several stages; "forming" when not given.
    #[schemars(example = &"draw")]
    pub name: Option<String>,
}

/// Further operation on the same sheet; omitted keys stay as in the stage before, but tools that moved stand still.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stage {
    /// Letters, digits, `-` and `_`: it names a folder.
    #[schemars(example = &"retract")]
    pub name: String,
    /// Punch that is new, moves or has another friction.
    pub punch: Option<Punch>,
    /// Die, likewise.
    pub die: Option<Die>,
    /// Holder, likewise, or with another force.
    pub holder: Option<Holder>,
    /// Tools that are no longer there.
    #[serde(default)]
    #[schemars(example = &("holder",))]
    pub remove: Vec<Role>,
    /// Support of the outer edge.
    pub edge: Option<Edge>,
    /// Sets equivalent strain and stress back to nothing before the stage.
    #[serde(default)]
    pub anneal: bool,
    /// Cuts the sheet at this current distance from the axis or symmetry plane before the stage; whole elements go.
    #[schemars(example = "80 mm")]
    pub trim: Option<Positive<Length>>,
    /// Diameter of the cut, instead of `trim`, of a round part.
    #[schemars(example = "160 mm")]
    pub trim_diameter: Option<Positive<Length>>,
    /// Response to strain.
    pub mode: Option<Mode>,
    /// Takes the tools away: the contact forces fade to zero, and the sheet springs back. True, or the stiffness of the
    /// iterations: "updated", which true means, or "constant".
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

/// Release of the tools: the stiffness of its iterations, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Release(pub Option<ReleaseStiffness>);

untagged!(
    [] Release, "true, false, \"updated\" or \"constant\"",
    switch(on) => Ok(Release(on.then_some(ReleaseStiffness::Updated))),
    text(name) => ReleaseStiffness::deserialize(name.into_deserializer()).map(|stiffness| Release(Some(stiffness)))
);

inline_schema!([] Release, "Release", |generator| {
    let (switch, stiffness) = (generator.subschema_for::<bool>(), generator.subschema_for::<ReleaseStiffness>());
    schemars::json_schema!({ "anyOf": [switch, stiffness] })
});
