//! What presses the sheet other than the punch: the holder's force, gas, and beads that hold it back.

use super::context::Sheet;
use crate::case::file::{self, Given, HolderForce, Stiffness};
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::{extent, shoulder_end};
use crate::model::{Bead, Extent, Face, Gas, Motion, Press, Pressure, RateControl, Role, Tool};
use crate::numerics::PiecewiseLinear;
use crate::units::Unit;
use crate::units::{Amount, Digits};
use crate::units::{Dimensioned, Length, NonNegative, Positive, Stress, Time};

/// How the holder is pressed or held: exactly one of the four ways.
pub(super) fn holder(
    holder: &file::Holder,
    profile: &crate::geometry::Profile,
    die: &Tool,
    sheet: &Sheet,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Motion, CaseError> {
    let given = [
        ("force", holder.force.is_some()),
        ("pressure", holder.pressure.is_some()),
        ("gap", holder.gap.is_some()),
        ("spring", holder.spring.is_some()),
    ];
    let given: Vec<&str> = given.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect();
    if given.len() > 1 {
        let what = format!("the holder is held in {} ways: {}", given.len(), given.join(" and "));
        return Err(source.error(&format!("tools.holder.{}", given[1]), what, "keep one of them"));
    }
    if let Some(gap) = holder.gap {
        let (gap, t) = (gap.value(), sheet.thickness);
        if gap < t {
            let what = format!("the holder's gap of {gap} mm is less than the sheet's thickness of {t} mm");
            return Err(source.error("tools.holder.gap", what, format!("at least {t} mm; 1.02 to 1.1 times is usual")));
        }
        return Ok(Motion::Gap(gap));
    }
    if let Some(pressure) = holder.pressure {
        let inner = profile.least_r().max(shoulder_end(die));
        let area = sheet.extent.area(sheet.length) - sheet.extent.area(inner);
        let force = pressure.value() * area.max(0.0);
        derived.push(format!(
            "the holder's force is its pressure on the initial area, {pressure} on {area} mm², {force}",
            pressure = Amount::given_stress(pressure.value()),
            area = Amount::new(area, Unit::None, Digits::Significant(4)),
            force = Amount::force(force, sheet.extent.force_unit())
        ));
        return Ok(Motion::Pressed(Press::constant(force)));
    }
    if let Some(spring) = holder.spring {
        let stiffness = match spring.stiffness {
            Stiffness::InAll(c) => in_all(c.value(), sheet.extent),
            Stiffness::PerDepth(c) => per_depth(c.value(), sheet.extent),
        };
        let stiffness = stiffness.map_err(|what| {
            let help = if sheet.extent == Extent::Ring { "\"5 kN/mm\"" } else { "\"50 N/mm^2\"" };
            let help = format!("such as stiffness = {help}");
            source.error("tools.holder.spring.stiffness", format!("{what} `stiffness` is {}", of(sheet.extent)), help)
        })?;
        let preload = force(spring.preload, "tools.holder.spring.preload", "preload", sheet.extent, source)?;
        return Ok(Motion::Pressed(Press { force: preload.into(), stiffness }));
    }
    let Some(given) = &holder.force else {
        return Err(source.missing("tools.holder", "force"));
    };
    Ok(Motion::Pressed(Press { force: holder_force(given, sheet.extent, source)?, stiffness: 0.0 }))
}

/// A force that stays, or its history over the travel.
pub(super) fn holder_force(
    given: &Given<NonNegative<Length>, HolderForce>,
    extent: Extent,
    source: &Source,
) -> Result<PiecewiseLinear, CaseError> {
    let path = "tools.holder.force";
    let points: Vec<(f64, f64)> = given
        .points()
        .into_iter()
        .enumerate()
        .map(|(i, (x, value))| {
            let path = if matches!(given, Given::Points(_)) { format!("{path}.{i}") } else { path.to_owned() };
            Ok((x, force(value, &path, "force", extent, source)?))
        })
        .collect::<Result<_, CaseError>>()?;
    history(points, path, "travels", source)
}

fn history(points: Vec<(f64, f64)>, path: &str, what: &str, source: &Source) -> Result<PiecewiseLinear, CaseError> {
    if points.is_empty() {
        return Err(source.error(path, "the list of points is empty", "write [x, value] pairs, or one value"));
    }
    if let Some(i) = points.windows(2).position(|w| w[1].0 <= w[0].0) {
        let text = format!("the {what} of the points must rise, found {} after {}", points[i + 1].0, points[i].0);
        return Err(source.error(&format!("{path}.{}", i + 1), text, "sort the points, each place once"));
    }
    Ok(PiecewiseLinear::new(points).expect("checked above"))
}

/// Whether a force in N or N/mm can be told from round-off; none at all is a case of its own.
fn presses(force: f64) -> bool {
    force == 0.0 || force >= 1e-6
}

pub(super) fn force(
    force: HolderForce,
    path: &str,
    key: &str,
    extent: Extent,
    source: &Source,
) -> Result<f64, CaseError> {
    let force = match force {
        HolderForce::InAll(force) => in_all(force.value(), extent),
        HolderForce::PerDepth(force) => per_depth(force.value(), extent),
    };
    let (what, help) = match force {
        Ok(force) if presses(force) => return Ok(force),
        Ok(_) => (format!("this `{key}` is next to nothing"), "check the unit, or write 0 for none".to_owned()),
        Err(case) if extent == Extent::Ring => {
            (format!("{case} `{key}` is {}", of(extent)), format!("write a force, such as {key} = \"80 kN\""))
        }
        Err(case) => (
            format!("{case} `{key}` is {}", of(extent)),
            format!("write a force per length, such as {key} = \"2600 N/mm\", or give blank.depth"),
        ),
    };
    Err(source.error(path, what, help))
}

/// A force or stiffness that is given in all; else the case that it does not fit.
fn in_all(value: f64, extent: Extent) -> Result<f64, &'static str> {
    if extent == Extent::PerDepth { Err("in plane strain without blank.depth") } else { Ok(value) }
}

/// A force or stiffness that is given per mm of depth; else the case that it does not fit.
fn per_depth(value: f64, extent: Extent) -> Result<f64, &'static str> {
    match extent {
        Extent::Ring => Err("in an axisymmetric case"),
        Extent::PerDepth => Ok(value),
        Extent::Depth(depth) => Ok(value * depth),
    }
}

/// What a force or stiffness that does not fit should have been of.
fn of(extent: Extent) -> &'static str {
    if extent == Extent::Ring { "that of the whole ring" } else { "per mm of depth, of both halves together" }
}

/// Norm of the strain rate that a superplastic pressure holds, when none is given \[–\].
const NORM: f64 = 10.0;

/// A pressure over time; one pressure and no punch is raised over the run's `alone`.
fn gas_history(
    given: &Given<NonNegative<Time>, NonNegative<Stress>>,
    key: &str,
    alone: Option<Positive<Time>>,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<PiecewiseLinear, CaseError> {
    let mut points: Vec<(f64, f64)> = given.points().into_iter().map(|(t, p)| (t, p.value())).collect();
    if let (Given::Constant(pressure), Some(duration)) = (given, alone) {
        points.push((duration.value(), pressure.value()));
        points[0].1 = 0.0;
        let (pressure, time) = (Amount::given_stress(pressure.value()), Amount::time(duration.value()));
        derived.push(match key {
            "lower" => format!("the pressure of {pressure} on the lower face is raised evenly over the run's {time}"),
            _ => format!("the pressure of {pressure} on the upper face is raised evenly over the run's {time}"),
        });
    }
    history(points, &format!("gas.{key}.pressure"), "times", source)
}

/// Caps and the norm belong to a pressure that is found, not to one that is given.
fn caps(face: &file::GasFace, key: &str, source: &Source) -> Result<(), CaseError> {
    let given = [
        ("max_pressure", "caps", face.max_pressure.is_some()),
        ("max_pressure_rate", "caps", face.max_pressure_rate.is_some()),
        ("norm", "belongs to", face.norm.is_some()),
    ];
    let Some((alone, does, _)) = given.into_iter().find(|(.., given)| *given && face.strain_rate.is_none()) else {
        return Ok(());
    };
    let what = format!("`{alone}` {does} a pressure that holds a strain rate, and there is no `strain_rate`");
    Err(source.error(&format!("gas.{key}.{alone}"), what, "drop it, or give a strain_rate instead of the pressure"))
}

/// The gas on each face that has one.
pub(super) fn gas(
    file: &file::Gas,
    tools: &[Tool],
    sheet: &Sheet,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Vec<Gas>, CaseError> {
    let tool = |role: Role| tools.iter().find(|t| t.role == role);
    let mut gas = Vec::new();
    for (face, key, given) in [(Face::Lower, "lower", &file.lower), (Face::Upper, "upper", &file.upper)] {
        let Some(given) = given else { continue };
        caps(given, key, source)?;
        let pressure = match (&given.pressure, given.strain_rate) {
            (Some(pressure), None) => {
                let alone = file.duration.filter(|_| tool(Role::Punch).is_none());
                Pressure::OverTime(gas_history(pressure, key, alone, source, derived)?)
            }
            (None, Some(target)) => {
                let exponent = given.norm.map_or(NORM, Dimensioned::value);
                if !(1.0..=50.0).contains(&exponent) {
                    let what = format!("`norm` must lie between 1 and 50, found {exponent}");
                    return Err(source.error(&format!("gas.{key}.norm"), what, "10 follows the fastest place closely"));
                }
                let mut control = RateControl::new(target.value(), exponent);
                control.max_pressure = given.max_pressure.map_or(f64::INFINITY, Dimensioned::value);
                control.max_rise = given.max_pressure_rate.map_or(f64::INFINITY, Dimensioned::value);
                Pressure::Rate(control)
            }
            (Some(_), Some(_)) => {
                let what = "both a pressure and a strain rate are given";
                return Err(source.error(&format!("gas.{key}.strain_rate"), what, "keep one: the other follows"));
            }
            (None, None) => return Err(source.missing(&format!("gas.{key}"), "pressure")),
        };
        let seal = match face {
            Face::Lower => tool(Role::Holder).map(|holder| ("the holder's inner edge", extent(holder).0)),
            Face::Upper => tool(Role::Die).map(|die| ("the end of the die's shoulder", shoulder_end(die))),
        };
        let within = match (given.within, seal) {
            (Some(within), _) => within.value(),
            (None, Some((what, r))) => {
                derived.push(format!("gas acts up to {what}, {r}", r = Amount::size(r)));
                r
            }
            (None, None) => sheet.length,
        };
        gas.push(Gas { face, pressure, within });
    }
    if gas.iter().filter(|gas| matches!(gas.pressure, Pressure::Rate(_))).count() > 1 {
        let what = "both faces hold a strain rate, and there is one sheet";
        return Err(source.error("gas.upper.strain_rate", what, "give one of the faces a pressure: the other follows"));
    }
    if gas.is_empty() {
        return Err(source.error("gas", "[gas] has no pressure", "add lower = { pressure = \"5 MPa\" } or upper"));
    }
    Ok(gas)
}

/// The draw beads, on the flat of the die.
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
        let bead = Bead {
            at: bead.at.value(),
            restraining: bead.restraining.value(),
            closing: bead.closing.map_or(0.0, Dimensioned::value),
        };
        let Some(die) = tool(Role::Die) else {
            return Err(source.error(&path, "a bead needs a die to sit on", "add [tools.die], or drop the bead"));
        };
        let flat = shoulder_end(die);
        if bead.at < flat || bead.at >= sheet.length {
            let what = format!(
                "a bead at {} mm is not on the flange, from the end of the die's shoulder at {flat:.3} mm to the blank's \
                 edge at {} mm",
                bead.at, sheet.length
            );
            return Err(source.error(&format!("{path}.at"), what, "check the unit and the blank"));
        }
        beads.push(bead);
    }
    let line = |bead: &Bead| sheet.extent.times() * bead.line(sheet.extent.geometry());
    let closing: f64 = beads.iter().map(|bead| bead.closing * line(bead)).sum();
    let Some(Motion::Pressed(press)) = tool(Role::Holder).map(|holder| &holder.motion) else { return Ok(beads) };
    if closing > 0.0 && closing >= press.force.smallest() {
        let unit = sheet.extent.force_unit().symbol();
        let what = format!(
            "closing the beads takes {closing:.0} {unit}, the holder has only {:.0} {unit}",
            press.force.smallest()
        );
        return Err(source.error("tools.beads.0", what, "raise the holder's force, or lower the closing force"));
    }
    Ok(beads)
}
