//! The tolerances on spring-back.

use crate::case::file::CaseFile;
use crate::case::source::Source;
use crate::case::{CaseError, Springback};
use crate::units::Quantity;

/// The tolerances in the units of what is measured.
pub(in crate::case) fn springback(file: &CaseFile, source: &Source) -> Result<Springback, CaseError> {
    let Some(file) = &file.springback else { return Ok(Springback::default()) };
    let degrees = |radians: f64| radians.to_degrees();
    let found = Springback {
        angle: file.angle.map(|angle| degrees(angle.value())),
        tolerance: file.tolerance.map(|angle| degrees(angle.value())),
        wall_tolerance: file.wall_tolerance.map(|angle| degrees(angle.value())),
        flange_tolerance: file.flange_tolerance.map(|angle| degrees(angle.value())),
        edge_tolerance: file.edge_tolerance.map(Quantity::value),
    };
    if found.angle.is_some_and(|angle| angle >= 180.0) {
        let what = "an angle of 180° or more between the legs is no bend";
        return Err(source.error("springback.angle", what, "write the angle between the legs, such as \"90 deg\""));
    }
    if found.tolerance.is_some() && found.wall_tolerance.is_some() {
        let what = "`tolerance` is of the angle between both walls, twice that of `wall_tolerance`: both are given";
        return Err(source.error("springback.wall_tolerance", what, "keep one of them"));
    }
    let no_angle = found.tolerance.or(found.wall_tolerance).is_none();
    if no_angle && (found.angle.is_some() || !found.is_given()) {
        let what = "[springback] has no `tolerance`: nothing says how far the angle may miss";
        let help =
            "write tolerance = \"1 deg\" of the angle between both walls, or wall_tolerance = \"0.5 deg\" of each";
        return Err(source.error("springback", what, help));
    }
    Ok(found)
}
