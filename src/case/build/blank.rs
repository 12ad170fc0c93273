//! `[blank]`.

use super::values::{count, radius_of};
use crate::case::file::CaseFile;
use crate::case::{CaseError, source::Source};
use crate::model::{Blank, Geometry, Mode, Theory, ThicknessRule};
use crate::units::{Dimensioned, rounded};
use std::ops::RangeInclusive;

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

/// Thickness rule and default number of points through the thickness.
fn thickness_points(case: &CaseFile) -> (ThicknessRule, i64) {
    let is_released = case.stages.iter().any(|stage| stage.release.is_some_and(|release| release.0.is_some()));
    let mut modes = case.stages.iter().map(|stage| stage.mode).chain([case.material.mode]).flatten();
    match case.geometry {
        _ if is_released => (ThicknessRule::Lobatto, RELEASED),
        _ if modes.any(|mode| mode != Mode::Flow) => (ThicknessRule::Lobatto, ELASTIC),
        Geometry::PlaneStrain => (ThicknessRule::Parts, BENT),
        Geometry::Axisymmetric => (ThicknessRule::Parts, FLOWING),
    }
}

/// Length of the part across a plane section \[mm\].
pub(super) fn depth(case: &CaseFile, source: &Source) -> Result<Option<f64>, CaseError> {
    let depth = case.blank.depth.map(Dimensioned::value);
    let what = "`depth` is the length across a plane section, this case is axisymmetric";
    let help = "drop it, or change `geometry`; how deep is drawn is the travel";
    source.require(depth.is_none() || case.geometry == Geometry::PlaneStrain, "blank.depth", what, help)?;
    Ok(depth)
}

pub(super) fn convert(case: &CaseFile, source: &Source) -> Result<Blank, CaseError> {
    let file = &case.blank;
    let (keys, lengths) = (["radius", "diameter", "half_length"], [file.radius, file.diameter, file.half_length]);
    let (key, length) = radius_of(source, "blank", case.geometry, keys, lengths)?;
    let thickness = file.thickness.value();
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
    let (rule, usual) = thickness_points(case);
    let layers = if file.theory == Theory::Membrane {
        source.note("membrane theory: bending stiffness is left out, one point through the thickness");
        1
    } else {
        count(source, "blank.layers", file.layers.unwrap_or(usual), 3..=101)?
    };
    Ok(Blank {
        length,
        thickness,
        elements: count(source, "blank.elements", file.elements, 2..=2000)?,
        grading: file.grading,
        theory: file.theory,
        layers,
        rule,
        edge: file.edge,
    })
}
