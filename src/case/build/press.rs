//! The press's rating.

use super::{blank, loads::force};
use crate::case::file::{CaseFile, HolderForce};
use crate::case::source::Source;
use crate::case::{CaseError, Press};
use crate::model::Extent;
use crate::units::Dimensioned;

/// The rating of the press in the units of the run's forces and work.
pub(in crate::case) fn press(file: &CaseFile, source: &Source) -> Result<Press, CaseError> {
    let extent = Extent::of(file.geometry, blank::depth(file, source)?);
    let rated = |given: HolderForce| match force(given, "press.force", "force", extent, source)? {
        0.0 => {
            Err(source.error("press.force", "a press without force forms nothing", "write its rating, or leave it out"))
        }
        force => Ok(force),
    };
    if file.press.energy.is_some() && extent == Extent::PerDepth {
        let help = "give blank.depth, or leave it out: the work per mm of depth is in the summary";
        return Err(source.error("press.energy", "in plane strain the length of the part is not known", help));
    }
    Ok(Press {
        force: file.press.force.map(rated).transpose()?,
        energy: file.press.energy.map(|energy| energy.value()),
    })
}
