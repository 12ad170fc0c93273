//! `[tools]`: shapes placed where they touch the flat sheet.

use super::friction::{self, Frictions};
use super::values::{Key, keys_present, radius_of};
use super::{holder, section};
use crate::case::file::{self, Section};
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::model::{Blank, Extent, Motion, Role, Tool};
use crate::units::{Dimensioned, rounded};

/// Least radius of a tool, and least opening \[mm\].
const SMALLEST: f64 = 1e-3;

/// Flat sheet that tools are placed against.
pub(super) struct Sheet {
    pub extent: Extent,
    /// Radius or half-length \[mm\].
    pub length: f64,
    /// Thickness \[mm\].
    pub thickness: f64,
}

impl Sheet {
    pub fn new(blank: &Blank, extent: Extent) -> Self {
        Self { extent, length: blank.length, thickness: blank.thickness }
    }
}

/// Inputs of the tools of a stage.
pub(super) struct ToolContext<'a> {
    /// New tools.
    pub written: &'a file::Tools,
    /// Tools that remain from the stage before.
    pub standing: &'a [Tool],
    pub sheet: Sheet,
    /// Punch travel of the whole run \[mm\].
    pub travel: f64,
    pub source: &'a Source<'a>,
}

impl ToolContext<'_> {
    /// Custom section of a tool.
    pub fn section(&self, role: Role) -> Option<&Section> {
        match role {
            Role::Punch => self.written.punch.as_ref()?.profile.as_ref(),
            Role::Die => self.written.die.as_ref()?.profile.as_ref(),
            Role::Holder => self.written.holder.as_ref()?.profile.as_ref(),
        }
    }

    /// Placed section of a tool, new or standing.
    pub fn profile(&self, role: Role) -> Result<Option<Profile>, CaseError> {
        // Notes are taken where the tool itself is made.
        let new = self.source.silently(|| self.new_profile(role))?;
        let standing = || self.standing.iter().find(|tool| tool.role == role);
        Ok(new.or_else(|| standing().map(|tool| tool.profile.clone())))
    }

    /// Placed section of a new tool.
    pub fn new_profile(&self, role: Role) -> Result<Option<Profile>, CaseError> {
        let file::Tools { punch, die, holder, .. } = self.written;
        match role {
            Role::Punch => punch.as_ref().map(|punch| self.punch(punch)),
            Role::Die => die.as_ref().map(|die| self.die(die)),
            Role::Holder => holder.as_ref().map(|holder| self.holder(holder)),
        }
        .transpose()
    }

    fn punch(&self, punch: &file::Punch) -> Result<Profile, CaseError> {
        let shapes = keys_present([
            ("hemispherical", punch.hemispherical.is_some()),
            ("flat", punch.flat.is_some()),
            ("crowned", punch.crowned.is_some()),
            ("profile", punch.profile.is_some()),
        ]);
        let t = self.sheet.thickness;
        match punch {
            _ if shapes.len() != 1 => {}
            file::Punch { hemispherical: Some(shape), .. } => {
                let radius = ("radius", shape.radius);
                let radius = self.radius("tools.punch.hemispherical", radius, ("diameter", shape.diameter), radius)?;
                return Ok(Profile::hemispherical_punch(radius, t));
            }
            file::Punch { flat: Some(shape), .. } => {
                let (radius, diameter) = (("radius", shape.radius), ("diameter", shape.diameter));
                let radius = self.radius("tools.punch.flat", radius, diameter, ("half_width", shape.half_width))?;
                return Ok(Profile::flat_punch(radius, self.nose("flat", shape.nose.value(), radius)?, t));
            }
            file::Punch { crowned: Some(shape), .. } => return self.crowned(shape),
            file::Punch { profile: Some(section), .. } => return section::convert(section, Role::Punch, self),
            _ => {}
        }
        let what = match shapes.len() {
            0 => "the punch has no shape".to_owned(),
            n => format!("the punch has {n} shapes: {}", shapes.join(" and ")),
        };
        let help = "give one of hemispherical = { radius }, flat = { radius, nose }, crowned = { radius, face, nose }, \
                    profile = [..] or \"punch.csv\"";
        let path = shapes.get(1).map_or("tools.punch".to_owned(), |shape| format!("tools.punch.{shape}"));
        Err(self.source.error(&path, what, help))
    }

    fn crowned(&self, shape: &file::Crowned) -> Result<Profile, CaseError> {
        let (radius, diameter) = (("radius", shape.radius), ("diameter", shape.diameter));
        let radius = self.radius("tools.punch.crowned", radius, diameter, ("half_width", shape.half_width))?;
        let nose = self.nose("crowned", shape.nose.value(), radius)?;
        let face = shape.face.value();
        let [f, r, n] = [face, radius, nose].map(rounded);
        let what = format!("a crowned face of radius {f} mm does not fit a punch of {r} mm, nose {n} mm");
        let help = "the face must be larger than the punch and the nose smaller; else use flat or hemispherical";
        let fits = face >= radius + SMALLEST && nose <= radius - SMALLEST;
        self.source.require(fits, "tools.punch.crowned.face", what, help)?;
        Ok(Profile::crowned_punch(radius, face, nose, self.sheet.thickness))
    }

    fn die(&self, die: &file::Die) -> Result<Profile, CaseError> {
        let Some(section) = &die.profile else {
            let throat = ("throat", die.throat);
            let throat = self.radius("tools.die", throat, ("throat_diameter", die.throat_diameter), throat)?;
            let shoulder = die.shoulder.ok_or_else(|| self.source.missing("tools.die", "shoulder"))?.value();
            let shoulder = self.size("tools.die.shoulder", shoulder)?;
            return Ok(Profile::die(throat, shoulder, self.sheet.thickness));
        };
        let alone = die.throat.or(die.throat_diameter).or(die.shoulder).is_none();
        let help =
            "the radius is in the profile: change it there or in its drawing, or write throat and shoulder instead";
        let what = "the die has both a profile and a throat or shoulder";
        self.source.require(alone, "tools.die.profile", what, help)?;
        section::convert(section, Role::Die, self)
    }

    fn holder(&self, holder: &file::Holder) -> Result<Profile, CaseError> {
        let file::Holder { inner_radius, inner_diameter, inner_half_width, .. } = *holder;
        let Some(section) = &holder.profile else {
            let (radius, diameter) = (("inner_radius", inner_radius), ("inner_diameter", inner_diameter));
            let inner = self.radius("tools.holder", radius, diameter, ("inner_half_width", inner_half_width))?;
            return Ok(Profile::holder(inner, self.sheet.thickness));
        };
        let alone = inner_radius.or(inner_diameter).or(inner_half_width).is_none();
        let what = "the holder has both a profile and an inner edge";
        self.source.require(alone, "tools.holder.profile", what, "keep one of them")?;
        section::convert(section, Role::Holder, self)
    }

    /// Radius or half-width of a shape \[mm\].
    fn radius(&self, table: &str, radius: Key, diameter: Key, strip: Key) -> Result<f64, CaseError> {
        let (key, value) = radius_of(self.source, table, self.sheet.extent.geometry(), radius, diameter, strip)?;
        self.size(&format!("{table}.{key}"), value)
    }

    fn size(&self, path: &str, value: f64) -> Result<f64, CaseError> {
        let key = path.rsplit('.').next().unwrap_or(path);
        let what = format!("`{key}` is too small: {value:e} mm, at least {SMALLEST} mm");
        let help = "check the unit; thin-shell theory wants radii above five thicknesses";
        self.source.require(value >= SMALLEST, path, what, help)?;
        Ok(value)
    }

    fn nose(&self, shape: &str, nose: f64, radius: f64) -> Result<f64, CaseError> {
        let path = format!("tools.punch.{shape}.nose");
        let nose = self.size(&path, nose)?;
        let what = format!("a nose of {} mm is larger than the punch of {} mm", rounded(nose), rounded(radius));
        let help = format!("at most {} mm: then it is hemispherical", rounded(radius));
        self.source.require(nose <= radius, &path, what, help)?;
        // A flat shorter than round-off is none.
        Ok(if radius - nose < 1e-3 * SMALLEST { radius } else { nose })
    }
}

/// Builds the tools of the first stage.
pub(super) fn convert(context: &ToolContext, frictions: &Frictions) -> Result<Vec<Tool>, CaseError> {
    let source = context.source;
    let mut tools: Vec<Tool> = Vec::new();
    let file::Tools { punch, die, holder, .. } = context.written;
    let moved = [
        ("punch", punch.as_ref().map(|t| (t.axial, t.aside))),
        ("die", die.as_ref().map(|t| (t.axial, t.aside))),
        ("holder", holder.as_ref().map(|t| (t.axial, t.aside))),
    ];
    for (tool, moves) in moved {
        let (axial, aside) = moves.unwrap_or_default();
        let key = if axial.is_some() { "move" } else { "aside" };
        let what = format!("`{key}` is for tools of later stages");
        let help = "drop it, or move it to [[stages]]";
        source.require(axial.or(aside).is_none(), &format!("tools.{tool}.{key}"), what, help)?;
    }
    for role in Role::ALL {
        let die = tools.iter().find(|tool| tool.role == Role::Die);
        let alone = role == Role::Holder && context.written.holder.is_some() && die.is_none();
        let help = "add [tools.die], or drop the holder and clamp the edge";
        source.require(!alone, "tools.holder", "a holder needs a die to press against", help)?;
        let Some(profile) = context.new_profile(role)? else { continue };
        let motion = match (role, &context.written.holder, die) {
            (Role::Punch, ..) => Motion::Travel,
            (Role::Holder, Some(holder), Some(die)) => holder::motion(holder, &profile, die, &context.sheet, source)?,
            _ => Motion::Fixed,
        };
        tools.push(Tool { role, profile, friction: friction::law(role, frictions, source)?, motion });
    }
    Ok(tools)
}
