//! `[tools]`: shapes placed where they touch the flat sheet.

use super::{by_geometry, section};
use crate::case::file::{self, HolderForce, Section};
use crate::case::{CaseError, explain::missing, source::Source};
use crate::geometry::Profile;
use crate::model::{Geometry, Motion, Role, Tool};
use crate::quantity::{Length, Positive, Quantity};
use std::path::Path;

/// What tools are placed against.
pub(super) struct Sheet {
    pub geometry: Geometry,
    /// Radius or half-length [mm].
    pub length: f64,
    /// Thickness [mm].
    pub thickness: f64,
}

/// What tools are made from.
pub(super) struct Shop<'a> {
    pub tools: &'a file::Tools,
    pub sheet: Sheet,
    /// Punch travel of the whole run [mm].
    pub travel: f64,
    pub source: &'a Source<'a>,
    /// Where profile files are looked up.
    pub folder: &'a Path,
}

pub(super) fn convert(shop: &Shop, derived: &mut Vec<String>) -> Result<Vec<Tool>, CaseError> {
    let Shop { tools: file, sheet, source, .. } = shop;
    let punch = file.punch.as_ref().ok_or_else(|| missing(source, "tools", "punch"))?;
    let mut tools = vec![Tool {
        role: Role::Punch,
        profile: punch_profile(punch, shop, derived)?,
        friction: punch.friction.value(),
        motion: Motion::Travel,
    }];
    if let Some(die) = &file.die {
        tools.push(Tool {
            role: Role::Die,
            profile: die_profile(die, shop, derived)?,
            friction: die.friction.value(),
            motion: Motion::Fixed,
        });
    }
    if let Some(holder) = &file.holder {
        let Some(die) = &file.die else {
            let what = "a holder needs a die to press against";
            return Err(source.error("tools.holder", what, "add [tools.die], or drop the holder and clamp the edge"));
        };
        if holder.friction.is_none() {
            derived.push(format!("the holder's friction is the die's, {}", die.friction));
        }
        tools.push(Tool {
            role: Role::Holder,
            profile: holder_profile(holder, shop, derived)?,
            friction: holder.friction.unwrap_or(die.friction).value(),
            motion: Motion::Force(holder_force(holder.force, sheet.geometry, source)?),
        });
    }
    Ok(tools)
}

impl Shop<'_> {
    /// The placed section of a tool; `None` when there is no such tool.
    pub fn profile(&self, role: Role) -> Result<Option<Profile>, CaseError> {
        let derived = &mut Vec::new(); // said where the tool itself is made
        match role {
            Role::Punch => self.tools.punch.as_ref().map(|punch| punch_profile(punch, self, derived)),
            Role::Die => self.tools.die.as_ref().map(|die| die_profile(die, self, derived)),
            Role::Holder => self.tools.holder.as_ref().map(|holder| holder_profile(holder, self, derived)),
        }
        .transpose()
    }

    /// The section that is written for a tool.
    pub fn section(&self, role: Role) -> Option<&Section> {
        match role {
            Role::Punch => self.tools.punch.as_ref()?.profile.as_ref(),
            Role::Die => self.tools.die.as_ref()?.profile.as_ref(),
            Role::Holder => self.tools.holder.as_ref()?.profile.as_ref(),
        }
    }
}

fn punch_profile(punch: &file::Punch, shop: &Shop, derived: &mut Vec<String>) -> Result<Profile, CaseError> {
    let Shop { sheet, source, .. } = shop;
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
        return Ok(Profile::hemispherical_punch(shape.radius.value(), t));
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
        if face <= radius || nose >= radius {
            let what =
                format!("a crowned face of radius {face} mm does not fit a punch of {radius} mm, nose {nose} mm");
            let help = "the face must be larger than the punch and the nose smaller; else use flat or hemispherical";
            return Err(source.error("tools.punch.crowned.face", what, help));
        }
        return Ok(Profile::crowned_punch(radius, face, nose, t));
    }
    let section = punch.profile.as_ref().expect("exactly one shape is given, and it is none of the above");
    section::convert(section, Role::Punch, shop, derived)
}

fn punch_radius(
    source: &Source,
    shape: &str,
    sheet: &Sheet,
    radius: Option<Positive<Length>>,
    half_width: Option<Positive<Length>>,
) -> Result<f64, CaseError> {
    let table = format!("tools.punch.{shape}");
    by_geometry(source, &table, sheet.geometry, ("radius", radius), ("half_width", half_width))
}

fn nose_within(source: &Source, shape: &str, nose: f64, radius: f64) -> Result<f64, CaseError> {
    if nose <= radius {
        return Ok(nose);
    }
    let what = format!("a nose of {nose} mm is larger than the punch of {radius} mm");
    Err(source.error(
        &format!("tools.punch.{shape}.nose"),
        what,
        format!("at most {radius} mm: then it is hemispherical"),
    ))
}

fn die_profile(die: &file::Die, shop: &Shop, derived: &mut Vec<String>) -> Result<Profile, CaseError> {
    let Shop { sheet, source, .. } = shop;
    match (&die.profile, die.throat, die.shoulder) {
        (Some(section), None, None) => section::convert(section, Role::Die, shop, derived),
        (None, Some(throat), Some(shoulder)) => Ok(Profile::die(throat.value(), shoulder.value(), sheet.thickness)),
        (Some(_), ..) => {
            let what = "the die has both a profile and a throat or shoulder";
            Err(source.error("tools.die.profile", what, "keep the profile, or throat and shoulder"))
        }
        (None, None, _) => Err(missing(source, "tools.die", "throat")),
        (None, _, None) => Err(missing(source, "tools.die", "shoulder")),
    }
}

fn holder_profile(holder: &file::Holder, shop: &Shop, derived: &mut Vec<String>) -> Result<Profile, CaseError> {
    let Shop { sheet, source, .. } = shop;
    let Some(section) = &holder.profile else {
        let radius = ("inner_radius", holder.inner_radius);
        let half_width = ("inner_half_width", holder.inner_half_width);
        let inner = by_geometry(source, "tools.holder", sheet.geometry, radius, half_width)?;
        return Ok(Profile::holder(inner, sheet.thickness));
    };
    if holder.inner_radius.or(holder.inner_half_width).is_some() {
        let what = "the holder has both a profile and an inner edge";
        return Err(source.error("tools.holder.profile", what, "keep one of them"));
    }
    section::convert(section, Role::Holder, shop, derived)
}

fn holder_force(force: HolderForce, geometry: Geometry, source: &Source) -> Result<f64, CaseError> {
    let (what, help) = match (geometry, force) {
        (Geometry::Axisymmetric, HolderForce::Ring(force)) => return Ok(force.value()),
        (Geometry::PlaneStrain, HolderForce::PerDepth(force)) => return Ok(force.value()),
        (Geometry::Axisymmetric, HolderForce::PerDepth(_)) => {
            ("in an axisymmetric case `force` is that of the whole ring", "write a force, such as force = \"80 kN\"")
        }
        (Geometry::PlaneStrain, HolderForce::Ring(_)) => (
            "in plane strain `force` is per depth of the modelled half",
            "write a force per length, such as force = \"1300 N/mm\"",
        ),
    };
    Err(source.error("tools.holder.force", what, help))
}
