//! `[tools]`: shapes placed where they touch the flat sheet.

use super::context::{Sheet, ToolContext};
use super::friction::{self, Frictions};
use super::values::by_geometry;
use super::{loads, section};
use crate::case::file;
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::model::{Motion, Role, Tool};
use crate::units::{Dimensioned, Length, Positive, rounded};

/// No tool is sharper and no opening smaller than a micrometre [mm].
const SMALLEST: f64 = 1e-3;

/// The tools of the first stage.
pub(super) fn convert(
    context: &ToolContext,
    frictions: &Frictions,
    derived: &mut Vec<String>,
) -> Result<Vec<Tool>, CaseError> {
    let ToolContext { sheet, source, .. } = context;
    let mut tools: Vec<Tool> = Vec::new();
    for role in Role::ALL {
        let die = tools.iter().find(|tool| tool.role == Role::Die);
        if role == Role::Holder && context.written.holder.is_some() && die.is_none() {
            let what = "a holder needs a die to press against";
            return Err(source.error("tools.holder", what, "add [tools.die], or drop the holder and clamp the edge"));
        }
        let Some(profile) = new_profile(context, role, derived)? else { continue };
        let motion = match (role, &context.written.holder, die) {
            (Role::Punch, ..) => Motion::Travel,
            (Role::Holder, Some(holder), Some(die)) => loads::holder(holder, &profile, die, sheet, source, derived)?,
            _ => Motion::Fixed,
        };
        tools.push(Tool { role, profile, friction: friction::of(role, frictions, source, derived)?, motion });
    }
    Ok(tools)
}

/// The placed section of a tool that is new; `None` when there is no such tool.
pub(super) fn new_profile(
    context: &ToolContext,
    role: Role,
    derived: &mut Vec<String>,
) -> Result<Option<Profile>, CaseError> {
    let file::Tools { punch, die, holder, .. } = context.written;
    match role {
        Role::Punch => punch.as_ref().map(|punch| punch_profile(punch, context, derived)),
        Role::Die => die.as_ref().map(|die| die_profile(die, context, derived)),
        Role::Holder => holder.as_ref().map(|holder| holder_profile(holder, context, derived)),
    }
    .transpose()
}

/// The placed section of a tool, new or standing; `None` when there is no such tool.
pub(super) fn profile(context: &ToolContext, role: Role) -> Result<Option<Profile>, CaseError> {
    let new = new_profile(context, role, &mut Vec::new())?; // said where the tool itself is made
    let standing = || context.standing.iter().find(|tool| tool.role == role);
    Ok(new.or_else(|| standing().map(|tool| tool.profile.clone())))
}

fn punch_profile(punch: &file::Punch, context: &ToolContext, derived: &mut Vec<String>) -> Result<Profile, CaseError> {
    let ToolContext { sheet, source, .. } = context;
    let t = sheet.thickness;
    let given = [
        ("hemispherical", punch.hemispherical.is_some()),
        ("flat", punch.flat.is_some()),
        ("crowned", punch.crowned.is_some()),
        ("profile", punch.profile.is_some()),
    ];
    let given: Vec<&str> = given.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect();
    let [_] = given[..] else {
        let what = match given.len() {
            0 => "the punch has no shape".to_owned(),
            _ => format!("the punch has {} shapes: {}", given.len(), given.join(" and ")),
        };
        let help = "give one of hemispherical = { radius }, flat = { radius, nose }, crowned = { radius, face, nose }, \
                    profile = [..] or \"punch.csv\"";
        let path = given.get(1).map_or("tools.punch".to_owned(), |shape| format!("tools.punch.{shape}"));
        return Err(source.error(&path, what, help));
    };
    if let Some(shape) = &punch.hemispherical {
        let radius = size(source, "tools.punch.hemispherical.radius", shape.radius.value())?;
        return Ok(Profile::hemispherical_punch(radius, t));
    }
    if let Some(shape) = &punch.flat {
        let radius = punch_radius(source, "flat", sheet, shape.radius, shape.half_width)?;
        let nose = nose_within(source, "flat", shape.nose.value(), radius)?;
        return Ok(Profile::flat_punch(radius, nose, t));
    }
    if let Some(shape) = &punch.crowned {
        let radius = punch_radius(source, "crowned", sheet, shape.radius, shape.half_width)?;
        let nose = nose_within(source, "crowned", shape.nose.value(), radius)?;
        let face = shape.face.value();
        if face < radius + SMALLEST || nose > radius - SMALLEST {
            let what = format!(
                "a crowned face of radius {} mm does not fit a punch of {} mm, nose {} mm",
                rounded(face),
                rounded(radius),
                rounded(nose)
            );
            let help = "the face must be larger than the punch and the nose smaller; else use flat or hemispherical";
            return Err(source.error("tools.punch.crowned.face", what, help));
        }
        return Ok(Profile::crowned_punch(radius, face, nose, t));
    }
    let section = punch.profile.as_ref().expect("exactly one shape is given, and it is none of the above");
    section::convert(section, Role::Punch, context, derived)
}

fn punch_radius(
    source: &Source,
    shape: &str,
    sheet: &Sheet,
    radius: Option<Positive<Length>>,
    half_width: Option<Positive<Length>>,
) -> Result<f64, CaseError> {
    let table = format!("tools.punch.{shape}");
    let (key, found) =
        by_geometry(source, &table, sheet.extent.geometry(), ("radius", radius), ("half_width", half_width))?;
    size(source, &format!("{table}.{key}"), found)
}

/// A radius or width that can be drawn.
fn size(source: &Source, path: &str, value: f64) -> Result<f64, CaseError> {
    if value >= SMALLEST {
        return Ok(value);
    }
    let key = path.rsplit('.').next().unwrap_or(path);
    let what = format!("`{key}` must be at least {SMALLEST} mm, found {value:e} mm");
    Err(source.error(path, what, "check the unit; thin-shell theory wants radii above five thicknesses"))
}

fn nose_within(source: &Source, shape: &str, nose: f64, radius: f64) -> Result<f64, CaseError> {
    let nose = size(source, &format!("tools.punch.{shape}.nose"), nose)?;
    if nose <= radius {
        // What is left of the flat beside a nose that is all but the whole radius is round-off.
        return Ok(if radius - nose < 1e-3 * SMALLEST { radius } else { nose });
    }
    let what = format!("a nose of {} mm is larger than the punch of {} mm", rounded(nose), rounded(radius));
    Err(source.error(
        &format!("tools.punch.{shape}.nose"),
        what,
        format!("at most {} mm: then it is hemispherical", rounded(radius)),
    ))
}

/// What to write for a die that is drawn and has a radius of its own.
const DRAWN: &str =
    "the radius is in the profile: change it there or in its drawing, or write throat and shoulder in its place";

fn die_profile(die: &file::Die, context: &ToolContext, derived: &mut Vec<String>) -> Result<Profile, CaseError> {
    let ToolContext { sheet, source, .. } = context;
    match (&die.profile, die.throat, die.shoulder) {
        (Some(section), None, None) => section::convert(section, Role::Die, context, derived),
        (None, Some(throat), Some(shoulder)) => Ok(Profile::die(
            size(source, "tools.die.throat", throat.value())?,
            size(source, "tools.die.shoulder", shoulder.value())?,
            sheet.thickness,
        )),
        (Some(_), ..) => {
            let what = "the die has both a profile and a throat or shoulder";
            Err(source.error("tools.die.profile", what, DRAWN))
        }
        (None, None, _) => Err(source.missing("tools.die", "throat")),
        (None, _, None) => Err(source.missing("tools.die", "shoulder")),
    }
}

fn holder_profile(
    holder: &file::Holder,
    context: &ToolContext,
    derived: &mut Vec<String>,
) -> Result<Profile, CaseError> {
    let ToolContext { sheet, source, .. } = context;
    let Some(section) = &holder.profile else {
        let radius = ("inner_radius", holder.inner_radius);
        let half_width = ("inner_half_width", holder.inner_half_width);
        let (key, inner) = by_geometry(source, "tools.holder", sheet.extent.geometry(), radius, half_width)?;
        return Ok(Profile::holder(size(source, &format!("tools.holder.{key}"), inner)?, sheet.thickness));
    };
    if holder.inner_radius.or(holder.inner_half_width).is_some() {
        let what = "the holder has both a profile and an inner edge";
        return Err(source.error("tools.holder.profile", what, "keep one of them"));
    }
    section::convert(section, Role::Holder, context, derived)
}
