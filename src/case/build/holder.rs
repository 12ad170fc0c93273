//! Holder's force and draw beads.

use super::tools::Sheet;
use super::values::{force, history, radius_of};
use crate::case::file::{self, Given, HolderForce};
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::model::tool_sizes::shoulder_end;
use crate::model::{Bead, Extent, Motion, Press, Role, Tool};
use crate::numerics::PiecewiseLinear;
use crate::units::{Amount, Digits, Dimensioned, Length, NonNegative, Unit};

const FORCE: &str = "tools.holder.force";

/// Support of the holder: exactly one of force, pressure, gap and spring.
pub(super) fn motion(
    holder: &file::Holder,
    profile: &Profile,
    die: &Tool,
    sheet: &Sheet,
    source: &Source,
) -> Result<Motion, CaseError> {
    let extent = sheet.extent;
    source.one_of("tools.holder", &["force", "pressure", "gap", "spring"], "keep one of them")?;
    if let Some(gap) = holder.gap {
        let (gap, t) = (gap.value(), sheet.thickness);
        let what = format!("the holder's gap of {gap} mm is less than the sheet's thickness of {t} mm");
        let help = format!("at least {t} mm; 1.02 to 1.1 times is usual");
        source.require(gap >= t, "tools.holder.gap", what, help)?;
        return Ok(Motion::Gap(gap));
    }
    if let Some(pressure) = holder.pressure {
        let inner = profile.least_r().max(shoulder_end(die));
        let area = extent.area(sheet.length) - extent.area(inner);
        let force = pressure.value() * area.max(0.0);
        let total = Amount::force(force, extent.force_unit());
        let (pressure, area) =
            (Amount::given_stress(pressure.value()), Amount::new(area, Unit::None, Digits::Significant(4)));
        source
            .note(format!("the holder's force is its pressure on the initial area, {pressure} on {area} mm², {total}"));
        return Ok(Motion::Pressed(Press::constant(force)));
    }
    if let Some(spring) = holder.spring {
        let stiffness = force(spring.stiffness, "tools.holder.spring.stiffness", extent, source)?;
        let preload = force(spring.preload, "tools.holder.spring.preload", extent, source)?;
        return Ok(Motion::Pressed(Press { force: preload.into(), stiffness }));
    }
    let given = holder.force.as_ref().ok_or_else(|| source.missing("tools.holder", "force"))?;
    Ok(Motion::Pressed(Press { force: force_history(given, extent, source)?, stiffness: 0.0 }))
}

/// Force that stays, or its history over the travel.
pub(super) fn force_history(
    given: &Given<NonNegative<Length>, HolderForce>,
    extent: Extent,
    source: &Source,
) -> Result<PiecewiseLinear, CaseError> {
    history(given, FORCE, "travels", source, |value, path| force(value, path, extent, source))
}

/// Draw beads, on the flat of the die.
pub(super) fn beads(
    file: &[file::Bead],
    tools: &[Tool],
    sheet: &Sheet,
    source: &Source,
) -> Result<Vec<Bead>, CaseError> {
    let tool = |role: Role| tools.iter().find(|t| t.role == role);
    let geometry = sheet.extent.geometry();
    let mut beads = Vec::new();
    for (i, bead) in file.iter().enumerate() {
        let path = format!("tools.beads.{i}");
        let lengths = [bead.at, bead.diameter, bead.at];
        let (key, at) = radius_of(source, &path, geometry, ["at", "diameter", "at"], lengths)?;
        let Some(die) = tool(Role::Die) else {
            return Err(source.error(&path, "a bead needs a die to sit on", "add [tools.die], or drop the bead"));
        };
        let (flat, edge) = (shoulder_end(die), sheet.length);
        let what = format!(
            "a bead at {at} mm is not on the flange, from the die's shoulder at {flat:.3} mm to the edge at {edge} mm"
        );
        source.require((flat..edge).contains(&at), &format!("{path}.{key}"), what, "check the unit and the blank")?;
        let (restraining, closing) = (bead.restraining.value(), bead.closing.map_or(0.0, Dimensioned::value));
        beads.push(Bead { at, restraining, closing });
    }
    let line = |bead: &Bead| sheet.extent.times() * bead.line(geometry);
    let closing: f64 = beads.iter().map(|bead| bead.closing * line(bead)).sum();
    if let Some(Motion::Pressed(press)) = tool(Role::Holder).map(|holder| &holder.motion) {
        let (unit, least) = (sheet.extent.force_unit().symbol(), press.force.smallest());
        let what = format!("closing the beads takes {closing:.0} {unit}, the holder has only {least:.0} {unit}");
        let help = "raise the holder's force, or lower the closing force";
        source.require(closing <= 0.0 || closing < least, "tools.beads.0", what, help)?;
    }
    Ok(beads)
}
