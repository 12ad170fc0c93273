//! Holder's force and draw beads.

use super::tools::Sheet;
use super::values::{keys_present, radius_of};
use crate::case::file::{self, Given, HolderForce, Stiffness};
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::model::tool_sizes::shoulder_end;
use crate::model::{Bead, Extent, Motion, Press, Role, Tool};
use crate::numerics::PiecewiseLinear;
use crate::units::{Amount, Digits, Dimensioned, Length, NonNegative, Unit};

/// Least force that differs from round-off \[N or N/mm\].
const LEAST: f64 = 1e-6;

/// Support of the holder: exactly one of force, pressure, gap and spring.
pub(super) fn motion(
    holder: &file::Holder,
    profile: &Profile,
    die: &Tool,
    sheet: &Sheet,
    source: &Source,
) -> Result<Motion, CaseError> {
    let ways = keys_present([
        ("force", holder.force.is_some()),
        ("pressure", holder.pressure.is_some()),
        ("gap", holder.gap.is_some()),
        ("spring", holder.spring.is_some()),
    ]);
    if let Some(second) = ways.get(1) {
        let what = format!("the holder is held in {} ways: {}", ways.len(), ways.join(" and "));
        return Err(source.error(&format!("tools.holder.{second}"), what, "keep one of them"));
    }
    if let Some(gap) = holder.gap {
        let (gap, t) = (gap.value(), sheet.thickness);
        let what = format!("the holder's gap of {gap} mm is less than the sheet's thickness of {t} mm");
        let help = format!("at least {t} mm; 1.02 to 1.1 times is usual");
        source.require(gap >= t, "tools.holder.gap", what, help)?;
        return Ok(Motion::Gap(gap));
    }
    if let Some(pressure) = holder.pressure {
        let inner = profile.least_r().max(shoulder_end(die));
        let area = sheet.extent.area(sheet.length) - sheet.extent.area(inner);
        let force = pressure.value() * area.max(0.0);
        let (pressure, area) =
            (Amount::given_stress(pressure.value()), Amount::new(area, Unit::None, Digits::Significant(4)));
        let total = Amount::force(force, sheet.extent.force_unit());
        source
            .note(format!("the holder's force is its pressure on the initial area, {pressure} on {area} mm², {total}"));
        return Ok(Motion::Pressed(Press::constant(force)));
    }
    if let Some(spring) = holder.spring {
        let stiffness = match spring.stiffness {
            Stiffness::InAll(c) => of_whole(c.value(), sheet.extent),
            Stiffness::PerDepth(c) => per_depth(c.value(), sheet.extent),
        };
        let stiffness = stiffness.map_err(|what| {
            let help = if sheet.extent == Extent::Ring { "\"5 kN/mm\"" } else { "\"50 N/mm^2\"" };
            let what = format!("{what} `stiffness` is {}", reference(sheet.extent));
            source.error("tools.holder.spring.stiffness", what, format!("such as stiffness = {help}"))
        })?;
        let preload = force(spring.preload, "tools.holder.spring.preload", sheet.extent, source)?;
        return Ok(Motion::Pressed(Press { force: preload.into(), stiffness }));
    }
    let given = holder.force.as_ref().ok_or_else(|| source.missing("tools.holder", "force"))?;
    Ok(Motion::Pressed(Press { force: force_history(given, sheet.extent, source)?, stiffness: 0.0 }))
}

/// Force that stays, or its history over the travel.
pub(super) fn force_history(
    given: &Given<NonNegative<Length>, HolderForce>,
    extent: Extent,
    source: &Source,
) -> Result<PiecewiseLinear, CaseError> {
    let path = "tools.holder.force";
    let mut points = Vec::new();
    for (i, (x, value)) in given.points().into_iter().enumerate() {
        let path = if matches!(given, Given::Points(_)) { format!("{path}.{i}") } else { path.to_owned() };
        points.push((x, force(value, &path, extent, source)?));
    }
    history(points, path, "travels", source)
}

/// Piecewise linear history with rising x, which error messages call `axis`.
pub(super) fn history(
    points: Vec<(f64, f64)>,
    path: &str,
    axis: &str,
    source: &Source,
) -> Result<PiecewiseLinear, CaseError> {
    source.require(!points.is_empty(), path, "the list of points is empty", "write [x, value] pairs, or one value")?;
    if let Some(i) = points.windows(2).position(|w| w[1].0 <= w[0].0) {
        let what = format!("the {axis} of the points must rise, found {} after {}", points[i + 1].0, points[i].0);
        return Err(source.error(&format!("{path}.{}", i + 1), what, "sort the points, each place once"));
    }
    Ok(PiecewiseLinear::new(points).expect("checked above"))
}

/// Force in the units of the extent.
pub(super) fn force(force: HolderForce, path: &str, extent: Extent, source: &Source) -> Result<f64, CaseError> {
    let key = path.split('.').rfind(|key| key.parse::<usize>().is_err()).unwrap_or(path);
    let force = match force {
        HolderForce::InAll(force) => of_whole(force.value(), extent),
        HolderForce::PerDepth(force) => per_depth(force.value(), extent),
    };
    let force = force.map_err(|case| {
        let help = match extent {
            Extent::Ring => format!("write a force, such as {key} = \"80 kN\""),
            _ => format!("write a force per length, such as {key} = \"2600 N/mm\", or give blank.depth"),
        };
        source.error(path, format!("{case} `{key}` is {}", reference(extent)), help)
    })?;
    let what = format!("this `{key}` is next to nothing");
    source.require(force == 0.0 || force >= LEAST, path, what, "check the unit, or write 0 for none")?;
    Ok(force)
}

/// Force or stiffness of the whole section; else the case that it does not fit.
fn of_whole(value: f64, extent: Extent) -> Result<f64, &'static str> {
    if extent == Extent::PerDepth { Err("in plane strain without blank.depth") } else { Ok(value) }
}

/// Force or stiffness that is given per mm of depth; else the case that it does not fit.
fn per_depth(value: f64, extent: Extent) -> Result<f64, &'static str> {
    match extent {
        Extent::Ring => Err("in an axisymmetric case"),
        Extent::PerDepth => Ok(value),
        Extent::Depth(depth) => Ok(value * depth),
    }
}

/// Part of the tools that forces and stiffnesses refer to.
fn reference(extent: Extent) -> &'static str {
    if extent == Extent::Ring { "that of the whole ring" } else { "per mm of depth, of both halves together" }
}

/// Draw beads, on the flat of the die.
pub(super) fn beads(
    file: &[file::Bead],
    tools: &[Tool],
    sheet: &Sheet,
    source: &Source,
) -> Result<Vec<Bead>, CaseError> {
    let tool = |role: Role| tools.iter().find(|t| t.role == role);
    let mut beads = Vec::new();
    for (i, bead) in file.iter().enumerate() {
        let path = format!("tools.beads.{i}");
        let (radius, geometry) = (("at", bead.at), sheet.extent.geometry());
        let (key, at) = radius_of(source, &path, geometry, radius, ("diameter", bead.diameter), radius)?;
        let (restraining, closing) = (bead.restraining.value(), bead.closing.map_or(0.0, Dimensioned::value));
        let Some(die) = tool(Role::Die) else {
            return Err(source.error(&path, "a bead needs a die to sit on", "add [tools.die], or drop the bead"));
        };
        let (flat, edge) = (shoulder_end(die), sheet.length);
        let what = format!(
            "a bead at {at} mm is not on the flange, from the end of the die's shoulder at {flat:.3} mm to the blank's edge \
             at {edge} mm"
        );
        source.require((flat..edge).contains(&at), &format!("{path}.{key}"), what, "check the unit and the blank")?;
        beads.push(Bead { at, restraining, closing });
    }
    let line = |bead: &Bead| sheet.extent.times() * bead.line(sheet.extent.geometry());
    let closing: f64 = beads.iter().map(|bead| bead.closing * line(bead)).sum();
    if let Some(Motion::Pressed(press)) = tool(Role::Holder).map(|holder| &holder.motion) {
        let (unit, least) = (sheet.extent.force_unit().symbol(), press.force.smallest());
        let what = format!("closing the beads takes {closing:.0} {unit}, the holder has only {least:.0} {unit}");
        let help = "raise the holder's force, or lower the closing force";
        source.require(closing <= 0.0 || closing < least, "tools.beads.0", what, help)?;
    }
    Ok(beads)
}
