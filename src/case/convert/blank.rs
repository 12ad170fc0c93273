//! `[blank]`.

use super::{by_geometry, count};
use crate::case::file::{self, Edge, Grading, Theory};
use crate::case::{CaseError, source::Source};
use crate::model::{self, Blank, Geometry};
use crate::quantity::{Quantity, rounded};
use std::ops::RangeInclusive;

/// Thicknesses of sheet, foil to plate [mm].
const THICKNESS: RangeInclusive<f64> = 1e-3..=50.0;
/// A blank shorter than this many thicknesses is no sheet [–].
const SLENDER: f64 = 5.0;

pub(super) fn convert(
    file: &file::Blank,
    geometry: Geometry,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Blank, CaseError> {
    let length = by_geometry(source, "blank", geometry, ("radius", file.radius), ("half_length", file.half_length))?;
    let thickness = file.thickness.value();
    if !THICKNESS.contains(&thickness) {
        let what = format!("`thickness` must lie between 0.001 and 50 mm, found {} mm", rounded(thickness));
        return Err(source.error("blank.thickness", what, "check the unit: sheet is 0.1 to 10 mm thick"));
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
    let theory = match file.theory {
        Theory::Bending => model::Theory::Bending,
        Theory::Membrane => model::Theory::Membrane,
        Theory::Selective => model::Theory::Selective,
    };
    let layers = match theory {
        model::Theory::Bending | model::Theory::Selective => count(source, "blank.layers", file.layers, 3..=101)?,
        model::Theory::Membrane => {
            derived.push("membrane theory: bending stiffness is left out, one point through the thickness".into());
            1
        }
    };
    Ok(Blank {
        length,
        thickness,
        elements: count(source, "blank.elements", file.elements, 2..=2000)?,
        grading: match file.grading {
            Grading::Uniform => model::Grading::Uniform,
            Grading::Radii => model::Grading::Radii,
        },
        theory,
        layers,
        edge: match file.edge {
            Edge::Free => model::Edge::Free,
            Edge::Clamped => model::Edge::Clamped,
        },
    })
}
