//! `[blank]`.

use super::{section::Section, *};
use crate::model::{Grading, Preform, ThicknessRule};

/// Sheet before forming: flat, a tube, or of any meridian.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Blank {
    /// Radius of the blank (axisymmetric).
    radius: Option<Positive<Length>>,
    /// Diameter of the blank, instead of `radius`.
    diameter: Option<Positive<Length>>,
    /// Length from the symmetry plane to the edge (plane strain).
    half_length: Option<Positive<Length>>,
    /// Radius of a hole around the axis (axisymmetric); its edge is free.
    hole: Option<Positive<Length>>,
    /// Diameter of the hole, instead of `hole`.
    hole_diameter: Option<Positive<Length>>,
    /// Tube around the axis, instead of a flat blank: from z = 0 down.
    tube: Option<Tube>,
    /// Meridian of the mid-surface, instead of a flat blank: lines and arcs, or the name of a CSV file as of a tool's profile. It
    /// begins nearer the axis, or above where the sheet stands upright; the die's side is on its left.
    profile: Option<Section>,
    /// Folder of an earlier run's results, whose sheet at its end goes on in this case: with its shape, thickness and strains.
    /// `thickness` is that of the sheet before the earlier run.
    earlier_run: Option<String>,
    /// Support of its first end where that is not on the axis.
    #[serde(default)]
    #[schemars(extend("default" = "free"))]
    inner_edge: Edge,
    /// Feed of the outer edge upward over time, rising from 0 mm at 0 s, as of a tube that is bulged; it takes the place of a punch.
    pub feed: Option<Vec<(NonNegative<Time>, NonNegative<Length>)>>,
    /// Expansion that the edge of the hole bears, measured, for the verdict.
    edge_limit: Option<model::EdgeLimit>,
    /// Length of the part across the section (plane strain): forces and works are then of the whole part, else per mm of it.
    pub depth: Option<Positive<Length>>,
    /// Initial thickness, 0.001 to 50 mm.
    thickness: Positive<Length>,
    /// Parts of a tailored blank.
    #[serde(default)]
    pub zones: Vec<super::zones::Zone>,
    /// Number of elements from the axis or symmetry plane to the edge, 2 to 2000.
    #[schemars(range(min = 2, max = 2000), extend("default" = 100))]
    elements: Option<i64>,
    /// Distribution of element sizes.
    #[serde(default)]
    #[schemars(extend("default" = "radii"))]
    grading: Grading,
    /// Shell theory of the sheet.
    #[serde(default)]
    #[schemars(extend("default" = "bending"))]
    theory: Theory,
    /// Integration points through the thickness of elements that bend, 3 to 101. When not given: 5 by the flow law, 9 in
    /// plane strain, 15 for an elasto-viscoplastic sheet, 25 where a stage releases the sheet.
    #[schemars(range(min = 3, max = 101))]
    layers: Option<i64>,
    /// Support of the outer edge.
    #[serde(default)]
    #[schemars(extend("default" = "free"))]
    edge: Edge,
}

/// Tube, by the sizes that it is ordered by.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Tube {
    /// Outside diameter.
    diameter: Positive<Length>,
    /// Length along the axis; half of it where its first end is its middle, with inner_edge = "guided".
    length: Positive<Length>,
}

/// Thicknesses of sheet, foil to plate \[mm\].
const THICKNESS: RangeInclusive<f64> = 1e-3..=50.0;
/// Largest distance from the axis or the middle to the edge \[mm\]: three times the beds of the largest presses.
const LARGEST: f64 = 10_000.0;
/// Least length of a blank over its thickness \[–\].
const SLENDER: f64 = 5.0;
// Points through the thickness. By the flow law 5 of a round part, whose moments hardly matter, and 9 of a strip, which is formed
// by bending: its moment is 2.6 % too large with five points and 1.0 % with nine. Of an elastic sheet 15: with few, each that
// yields lets the moment jump. For spring-back 25: the moment of an elastic-perfectly plastic strip is then within 0.3 %.
const FLOWING: i64 = 5;
const BENT: i64 = 9;
const ELASTIC: i64 = 15;
const RELEASED: i64 = 25;

fn thickness_points(case: &CaseFile) -> (ThicknessRule, i64) {
    let mut modes = case.stages.iter().map(|stage| stage.mode).chain([case.material.mode]).flatten();
    match case.geometry {
        _ if case.stages.iter().any(|stage| stage.release().is_some()) => (ThicknessRule::Lobatto, RELEASED),
        _ if modes.any(|mode| mode != Mode::Flow) => (ThicknessRule::Lobatto, ELASTIC),
        Geometry::PlaneStrain => (ThicknessRule::Parts, BENT),
        Geometry::Axisymmetric => (ThicknessRule::Parts, FLOWING),
    }
}

impl CaseFile {
    pub fn extent(&self, source: &Source) -> Result<Extent> {
        let depth = self.blank.depth.map(Dimensioned::value);
        let what = "`depth` is the length across a plane section, this case is axisymmetric";
        let help = "drop it, or change `geometry`; how deep is drawn is the travel";
        source.require(depth.is_none() || self.geometry == Geometry::PlaneStrain, "blank.depth", what, help)?;
        Ok(Extent::of(self.geometry, depth))
    }

    pub fn blank(&self, source: &Source) -> Result<model::Blank> {
        let file = &self.blank;
        let thickness = file.thickness.value();
        let meridian = self.meridian(source)?;
        let (keys, lengths) = (["radius", "diameter", "half_length"], [file.radius, file.diameter, file.half_length]);
        let (key, length) = match &meridian {
            Some((key, meridian, _)) => (*key, meridian.length()),
            None => radius_of(source, "blank", self.geometry, keys, lengths)?,
        };
        let (long, thick) = (rounded(length), rounded(thickness));
        let what = format!("`thickness` must lie between 0.001 and 50 mm, found {thick} mm");
        let help = "check the unit: sheet is 0.1 to 10 mm thick";
        source.require(THICKNESS.contains(&thickness), "blank.thickness", what, help)?;
        let what = format!("`{key}` is {long} mm from the middle, larger than any blank of a press shop");
        let help = format!("check the unit: {LARGEST} mm at most");
        source.require(length <= LARGEST, &format!("blank.{key}"), what, help)?;
        let what = format!("a blank of {long} mm is too small for a thickness of {thick} mm");
        let help = "shells are at least five thicknesses long: check the units";
        source.require(length >= SLENDER * thickness, "blank.thickness", what, help)?;
        let holes = [file.hole, file.hole_diameter, None];
        let hole = if let Some((_, meridian, _)) = &meridian {
            // Zero but for round-off.
            Some(meridian.first().x).filter(|x| *x > 1e-6).unwrap_or(0.0)
        } else if holes.iter().any(Option::is_some) {
            let (key, hole) = radius_of(source, "blank", self.geometry, ["hole", "hole_diameter", "radius"], holes)?;
            let room = length - SLENDER * thickness;
            let what = format!("a hole of {} mm radius does not fit the blank of {long} mm", rounded(hole));
            let help = format!("from half a thickness to {} mm, where 5 thicknesses of sheet are left", rounded(room));
            source.require((0.5 * thickness..=room).contains(&hole), &format!("blank.{key}"), what, help)?;
            let what = "the pressure would escape through the hole";
            source.require(self.gas.is_none(), &format!("blank.{key}"), what, "drop the hole or [gas]")?;
            hole
        } else {
            0.0
        };
        let (rule, usual) = thickness_points(self);
        let layers = if file.theory == Theory::Membrane {
            source.note("membrane theory: bending stiffness is left out, one point through the thickness");
            1
        } else {
            count(source, "blank.layers", file.layers.unwrap_or(usual), 3..=101)?
        };
        let elements = count(source, "blank.elements", file.elements.unwrap_or(100), 2..=2000)?;
        let Blank { grading, theory, inner_edge, edge_limit, .. } = *file;
        let edge = if file.feed.is_some() { Edge::Fed } else { file.edge };
        let (meridian, preform) = meridian.map_or((None, None), |(_, meridian, preform)| (Some(meridian), preform));
        let usual = model::Blank::new(length, thickness);
        let blank = model::Blank { hole, meridian, preform, inner_edge, edge_limit, elements, ..usual };
        Ok(model::Blank { grading, theory, layers, rule, edge, ..blank })
    }

    fn meridian(&self, source: &Source) -> Result<Option<(&'static str, Profile, Option<Preform>)>> {
        let keys = ["tube", "profile", "earlier_run", "radius", "diameter", "half_length"];
        let blank = &self.blank;
        let (key, meridian, preform) = match (&blank.tube, &blank.profile, &blank.earlier_run) {
            (None, None, None) => return Ok(None),
            (Some(tube), ..) => {
                let (thickness, across) = (blank.thickness.value(), tube.diameter.value());
                let (radius, length) = (0.5 * (across - thickness), tube.length.value());
                let is_tube = radius > 0.5 * thickness && length >= SLENDER * thickness;
                let what = "a tube is axisymmetric, wider than two walls and longer than five";
                let help = "check diameter, length and thickness, or draw the sheet as `profile`";
                source.require(is_tube && self.geometry == Geometry::Axisymmetric, "blank.tube", what, help)?;
                let line = Piece::line(Point::new(radius, 0.0), Point::new(radius, -length));
                ("tube", Profile::new(vec![line]).expect("a line with a length"), None)
            }
            (_, Some(profile), _) => {
                ("profile", profile.drawn("blank.profile", ("sheet", self.geometry), source)?, None)
            }
            (.., Some(folder)) => {
                let (meridian, preform) = preform::read(folder, blank.thickness.value(), self.geometry, source)?;
                ("earlier_run", meridian, Some(preform))
            }
        };
        source.one_of("blank", &keys, "each of them is the whole sheet: keep one")?;
        let what = "belongs to a flat blank";
        source.refuse("blank", &["hole", "hole_diameter"], what, "let the profile begin at the hole's edge")?;
        Ok(Some((key, meridian, preform)))
    }
}
