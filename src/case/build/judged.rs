//! `[press]` and `[springback]`: ratings and tolerances for the verdict.

use super::{blank, values::force};
use crate::case::file::{CaseFile, HolderForce};
use crate::case::source::Source;
use crate::case::{CaseError, Press, Springback};
use crate::model::{Extent, Geometry};
use crate::units::Dimensioned;

/// Rating of the press in the units of the run's forces and work.
pub(in crate::case) fn press(file: &CaseFile, source: &Source) -> Result<Press, CaseError> {
    let extent = Extent::of(file.geometry, blank::depth(file, source)?);
    let rated = |given: HolderForce| {
        let force = force(given, "press.force", extent, source)?;
        let help = "write its rating, or leave it out";
        source.require(force > 0.0, "press.force", "a press without force forms nothing", help)?;
        Ok::<_, CaseError>(force)
    };
    let known = file.press.energy.is_none() || extent != Extent::PerDepth;
    let what = "in plane strain the length of the part is not known";
    let help = "give blank.depth, or leave it out: the work per mm of depth is in the summary";
    source.require(known, "press.energy", what, help)?;
    Ok(Press { force: file.press.force.map(rated).transpose()?, energy: file.press.energy.map(Dimensioned::value) })
}

/// Checked tolerances on spring-back.
pub(in crate::case) fn springback(case: &CaseFile, source: &Source) -> Result<Springback, CaseError> {
    let Some(given) = case.springback else { return Ok(Springback::default()) };
    if given.ring.is_some() {
        let key = "springback.ring";
        let help = "drop it: a ring is cut from an axisymmetric cup";
        source.require(case.geometry == Geometry::Axisymmetric, key, "a strip has no ring to cut", help)?;
        let released = case.stages.last().is_some_and(|stage| stage.release.is_some());
        let what = "the last stage takes no tools away: the moment that remains in the wall is not known";
        let help = "add [[stages]] with release = true, and mode = \"elasto_viscoplastic\" with young and poisson to [material]";
        source.require(released, key, what, help)?;
    }
    let what = "an angle of 180° or more between the legs is no bend";
    let help = "write the angle between the legs, such as \"90 deg\"";
    source.require(given.angle.is_none_or(|angle| angle < 180.0), "springback.angle", what, help)?;
    source.one_of("springback", &["tolerance", "wall_tolerance"], "keep one of them")?;
    let no_angle = given.tolerance.or(given.wall_tolerance).is_none();
    let nothing = !given.is_given() && given.ring.is_none();
    let what = "[springback] has no `tolerance`: nothing says how far the angle may miss";
    let help = "write tolerance = \"1 deg\" of the angle between both walls, or wall_tolerance = \"0.5 deg\" of each";
    source.require(!no_angle || (given.angle.is_none() && !nothing), "springback", what, help)?;
    Ok(given)
}
