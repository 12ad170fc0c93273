//! `[blank]`.

use super::values::{by_geometry, count};
use crate::case::file::CaseFile;
use crate::case::{CaseError, source::Source};
use crate::model::{Blank, Geometry, Mode, Theory, ThicknessRule};
use crate::units::{Dimensioned, rounded};
use std::ops::RangeInclusive;

/// Thicknesses of sheet, foil to plate [mm].
const THICKNESS: RangeInclusive<f64> = 1e-3..=50.0;
/// From the axis or the middle to the edge [mm]: the beds of the largest presses are a third of that.
const LARGEST: f64 = 10_000.0;
/// A blank shorter than this many thicknesses is no sheet [–].
const SLENDER: f64 = 5.0;
/// Points through the thickness by the flow law: of a round part, which is formed by stretching and drawing, and whose moments
/// hardly matter; and of a strip, which is formed by bending alone: its moment is 2.6 % too large with five points and 1.0 %
/// with nine. Where the sheet is elastic too: with few, each that yields lets the moment jump, and the sheet snaps. And for
/// spring-back: the moment of an elastic-perfectly plastic strip is then within 0.3 %.
const FLOWING: i64 = 5;
const BENT: i64 = 9;
const ELASTIC: i64 = 15;
const RELEASED: i64 = 25;

/// Whether a stage releases the sheet.
fn is_released(case: &CaseFile) -> bool {
    case.stages.iter().any(|stage| stage.release.is_some_and(|release| release.0.is_some()))
}

/// Whether the sheet is elastic in any stage.
fn is_elastic(case: &CaseFile) -> bool {
    let modes = case.stages.iter().map(|stage| stage.mode).chain([case.material.mode]);
    is_released(case) || modes.flatten().any(|mode| mode != Mode::Flow)
}

/// Points through the thickness where the case does not say.
fn automatic(case: &CaseFile, geometry: Geometry) -> i64 {
    match (is_released(case), is_elastic(case), geometry) {
        (true, ..) => RELEASED,
        (_, true, _) => ELASTIC,
        (.., Geometry::PlaneStrain) => BENT,
        (.., Geometry::Axisymmetric) => FLOWING,
    }
}

/// Length of the part across a plane section \[mm\].
pub(in crate::case) fn depth(case: &CaseFile, source: &Source) -> Result<Option<f64>, CaseError> {
    let depth = case.blank.depth.map(Dimensioned::value);
    if depth.is_some() && case.geometry == Geometry::Axisymmetric {
        let what = "`depth` is the length across a plane section, this case is axisymmetric";
        return Err(source.error(
            "blank.depth",
            what,
            "drop it, or change `geometry`; how deep is drawn is the travel",
        ));
    }
    Ok(depth)
}

pub(super) fn convert(
    case: &CaseFile,
    geometry: Geometry,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Blank, CaseError> {
    let file = &case.blank;
    let (key, length) =
        by_geometry(source, "blank", geometry, ("radius", file.radius), ("half_length", file.half_length))?;
    let thickness = file.thickness.value();
    if !THICKNESS.contains(&thickness) {
        let what = format!("`thickness` must lie between 0.001 and 50 mm, found {} mm", rounded(thickness));
        return Err(source.error("blank.thickness", what, "check the unit: sheet is 0.1 to 10 mm thick"));
    }
    if length > LARGEST {
        let what = format!("`{key}` is {} mm, larger than any blank of a press shop", rounded(length));
        return Err(source.error(&format!("blank.{key}"), what, format!("check the unit: {LARGEST} mm at most")));
    }
    if length < SLENDER * thickness {
        let what =
            format!("a blank of {} mm is too small for a thickness of {} mm", rounded(length), rounded(thickness));
        return Err(source.error(
            "blank.thickness",
            what,
            "shells are at least five thicknesses long: check the units",
        ));
    }
    let layers = match file.theory {
        Theory::Bending | Theory::Selective => {
            count(source, "blank.layers", file.layers.unwrap_or_else(|| automatic(case, geometry)), 3..=101)?
        }
        Theory::Membrane => {
            derived.push("membrane theory: bending stiffness is left out, one point through the thickness".into());
            1
        }
    };
    Ok(Blank {
        length,
        thickness,
        elements: count(source, "blank.elements", file.elements, 2..=2000)?,
        grading: file.grading,
        theory: file.theory,
        layers,
        rule: if is_elastic(case) { ThicknessRule::Lobatto } else { ThicknessRule::Parts },
        edge: file.edge,
    })
}
