//! The tolerances on spring-back, and the ring of the split-ring test.

use crate::case::file::CaseFile;
use crate::case::source::Source;
use crate::case::{CaseError, Springback};
use crate::measure::Ring;
use crate::model::Geometry;
use crate::units::Dimensioned;

/// The tolerances in the units of what is measured.
pub(in crate::case) fn springback(file: &CaseFile, source: &Source) -> Result<Springback, CaseError> {
    let case = file;
    let Some(file) = &case.springback else { return Ok(Springback::default()) };
    let degrees = |radians: f64| radians.to_degrees();
    let found = Springback {
        angle: file.angle.map(|angle| degrees(angle.value())),
        tolerance: file.tolerance.map(|angle| degrees(angle.value())),
        wall_tolerance: file.wall_tolerance.map(|angle| degrees(angle.value())),
        flange_tolerance: file.flange_tolerance.map(|angle| degrees(angle.value())),
        edge_tolerance: file.edge_tolerance.map(Dimensioned::value),
        ring: file.ring.map(|ring| Ring { from: ring.from.value(), height: ring.height.value() }),
    };
    if found.ring.is_some() {
        of_a_cup(case, source)?;
    }
    if found.angle.is_some_and(|angle| angle >= 180.0) {
        let what = "an angle of 180° or more between the legs is no bend";
        return Err(source.error("springback.angle", what, "write the angle between the legs, such as \"90 deg\""));
    }
    if found.tolerance.is_some() && found.wall_tolerance.is_some() {
        let what = "`tolerance` is of the angle between both walls, twice that of `wall_tolerance`: both are given";
        return Err(source.error("springback.wall_tolerance", what, "keep one of them"));
    }
    let no_angle = found.tolerance.or(found.wall_tolerance).is_none();
    let nothing = !found.is_given() && found.ring.is_none();
    if no_angle && (found.angle.is_some() || nothing) {
        let what = "[springback] has no `tolerance`: nothing says how far the angle may miss";
        let help =
            "write tolerance = \"1 deg\" of the angle between both walls, or wall_tolerance = \"0.5 deg\" of each";
        return Err(source.error("springback", what, help));
    }
    Ok(found)
}

/// A ring is cut from a round part whose tools are gone.
fn of_a_cup(case: &CaseFile, source: &Source) -> Result<(), CaseError> {
    let key = "springback.ring";
    if case.geometry == Geometry::PlaneStrain {
        return Err(source.error(key, "a strip has no ring to cut", "drop it: a ring is of an axisymmetric cup"));
    }
    if case.stages.last().is_none_or(|stage| stage.release.is_none()) {
        let what = "the last stage takes no tools away: what the wall keeps of its moment is not known";
        let help = "add [[stages]] with release = true, and mode = \"elasto_viscoplastic\" with young and poisson to [material]";
        return Err(source.error(key, what, help));
    }
    Ok(())
}
