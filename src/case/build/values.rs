//! Values that are read and said in the same way everywhere.

use crate::case::{CaseError, source::Source};
use crate::geometry::Point;
use crate::model::Geometry;
use crate::units::{Dimensioned, Length, Positive, rounded};

/// A length \[mm\] whose key depends on the geometry, and that key; the other geometry's key is an error that says so.
pub(super) fn by_geometry(
    source: &Source,
    table: &str,
    geometry: Geometry,
    axisymmetric: (&'static str, Option<Positive<Length>>),
    plane_strain: (&'static str, Option<Positive<Length>>),
) -> Result<(&'static str, f64), CaseError> {
    let (name, (key, value), (other_name, (other, wrong))) = match geometry {
        Geometry::Axisymmetric => ("axisymmetric", axisymmetric, ("plane strain", plane_strain)),
        Geometry::PlaneStrain => ("plane strain", plane_strain, ("axisymmetric", axisymmetric)),
    };
    match (value, wrong) {
        (_, Some(wrong)) => Err(source.error(
            &format!("{table}.{other}"),
            format!("`{other}` belongs to {other_name} cases, this one is {name}"),
            format!("write {key} = \"{} mm\", or change `geometry`", rounded(wrong.value())),
        )),
        (Some(value), None) => Ok((key, value.value())),
        (None, None) => Err(source.missing(table, key)),
    }
}

/// A whole number within limits.
pub(super) fn count(
    source: &Source,
    path: &str,
    value: i64,
    range: std::ops::RangeInclusive<i64>,
) -> Result<usize, CaseError> {
    if range.contains(&value) {
        return Ok(value as usize);
    }
    let key = path.rsplit('.').next().unwrap_or(path);
    let what = format!("`{key}` must lie between {} and {}, found {value}", range.start(), range.end());
    let help = if value < *range.start() { range.start() } else { range.end() };
    Err(source.error(path, what, format!("the nearest that can be solved: {key} = {help}")))
}

/// Coordinates in words.
pub(super) fn place_of(at: Point) -> String {
    // Adding 0 takes the sign from a rounded −0.
    let round = |x: f64| (x * 1e4).round() / 1e4 + 0.0;
    format!("r = {} mm, z = {} mm", round(at.x), round(at.y))
}
