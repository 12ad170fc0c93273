//! `profile`: custom section of a tool.

use super::untagged::untagged;
use crate::model::Role;
use crate::units::{Length, NonNegative, Positive};
use schemars::JsonSchema;
use serde::Deserialize;

/// Section of a tool, the sheet on the left as one goes along it: steps, the name of a CSV file with points, or a table.
///
/// Wherever it is drawn along z, it is moved to where it touches the flat sheet.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
pub enum Section {
    /// Lines and arcs.
    Steps(Vec<ProfileStep>),
    /// CSV file, looked up from the case file's folder: columns `r_mm,z_mm` (any unit of length; `x_mm` in plane
    /// strain) and optionally `radius_mm`, the fillet radius at the point. Without any fillet, corners of less than 25°
    /// are rounded off by tangent arcs: the points are taken as chords of a curve.
    File(String),
    /// A file with a fillet, or a tool made from another.
    Table(SectionTable),
}

/// `{ file, fillet }`, `{ offset_of, by, shoulder, closed_at }` or `{ mirror_of }`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "fillet": ["file"], "offset_of": ["by"], "by": ["offset_of"], "shoulder": ["offset_of"], "closed_at": ["offset_of", "shoulder"] }))]
pub struct SectionTable {
    /// CSV file with points.
    #[schemars(example = "die.csv")]
    pub file: Option<String>,
    /// Fillet radius of all inner points of the file that have none of their own; "0 mm" keeps them sharp.
    #[schemars(example = "5 mm")]
    pub fillet: Option<NonNegative<Length>>,
    /// Punch or die whose outline this tool follows, so that the two close on each other: every point of this
    /// tool then lies `by` away from the other. A sharp corner of the other becomes an arc of radius `by`.
    #[schemars(example = &"punch")]
    pub offset_of: Option<Role>,
    /// Gap between the two tools when they have closed: the sheet's thickness and the clearance.
    #[schemars(example = "1.2 mm")]
    pub by: Option<Positive<Length>>,
    /// Die around a punch with a wall: the cavity ends at the die's face, on which the flat sheet lies, with this
    /// radius. Without it the offset is the whole die: for a punch that is drawn as far as the blank reaches.
    #[schemars(example = "6 mm")]
    pub shoulder: Option<Positive<Length>>,
    /// Only with `shoulder`: punch travel at which the gap is `by` everywhere, which is how deep the cavity is; the
    /// whole travel when not given. Without `shoulder` it follows from the die touching the flat sheet.
    #[schemars(example = "25 mm")]
    pub closed_at: Option<Positive<Length>>,
    /// Tool on the other side of the flat sheet whose mirror image this one is: a holder of the die's form,
    /// or a die of the holder's.
    #[schemars(example = &"die")]
    pub mirror_of: Option<Role>,
}

/// One step of a drawn section: `from` first, then `to` for straight lines, `arc_to` with `center` and `turn` for arcs.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "arc_to": ["center", "turn"], "center": ["arc_to"], "turn": ["arc_to"] }))]
pub struct ProfileStep {
    /// First point: [r, z].
    pub from: Option<[Length; 2]>,
    /// End of a straight line: [r, z].
    pub to: Option<[Length; 2]>,
    /// End of an arc: [r, z].
    pub arc_to: Option<[Length; 2]>,
    /// Centre of the arc: [r, z].
    pub center: Option<[Length; 2]>,
    /// Sense of the arc as one goes along it.
    #[schemars(example = &"right")]
    pub turn: Option<Turn>,
}

/// Sense of an arc as one goes along it, r to the right and z upward.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Turn {
    /// Counter-clockwise: a hollow of the tool.
    Left,
    /// Clockwise: a convex corner that bends the sheet.
    Right,
}

untagged!(
    [] Section, "a list of steps, the name of a CSV file such as \"die.csv\", or a table",
    text(file) => Ok(Section::File(file.to_owned())),
    list => Section::Steps,
    table => Section::Table
);
