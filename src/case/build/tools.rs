//! `[tools]`: shapes placed where they touch the flat sheet.

use super::friction::Frictions;
use super::values::radius_of;
use super::{holder, section};
use crate::case::file::{self, ToolKeys};
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::model::{Extent, Motion, Role, Tool};
use crate::units::{Dimensioned, Length, Positive, rounded};

/// Least radius of a tool, and least opening \[mm\].
const SMALLEST: f64 = 1e-3;
const ROUND: [&str; 3] = ["radius", "diameter", "half_width"];

/// Flat sheet that tools are placed against.
pub(super) struct Sheet {
    pub extent: Extent,
    /// Radius or half-length \[mm\].
    pub length: f64,
    /// Thickness \[mm\].
    pub thickness: f64,
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
    /// Written keys of a tool.
    pub fn keys(&self, role: Role) -> Option<ToolKeys<'_>> {
        self.written.keys().find(|tool| tool.role == role)
    }

    /// Placed section of a tool, new or standing.
    pub fn profile(&self, role: Role) -> Result<Option<Profile>, CaseError> {
        if self.keys(role).is_some_and(|tool| tool.is_shaped || self.standing.is_empty()) {
            // Notes are taken where the tool itself is made.
            return self.source.silently(|| self.new_profile(role)).map(Some);
        }
        Ok(self.standing.iter().find(|tool| tool.role == role).map(|tool| tool.profile.clone()))
    }

    /// Placed section of a new tool.
    pub fn new_profile(&self, role: Role) -> Result<Profile, CaseError> {
        if let Some(profile) = self.keys(role).and_then(|tool| tool.profile) {
            let (shapes, help): (&[&str], _) = match role {
                Role::Punch => (&["hemispherical", "flat", "crowned"], "keep one of the shapes"),
                Role::Die => (
                    &["throat", "throat_diameter", "shoulder"],
                    "the radius is in the profile: change it there or in its drawing, or write throat and shoulder instead",
                ),
                Role::Holder => (&["inner_radius", "inner_diameter", "inner_half_width"], "keep one of them"),
            };
            let table = format!("tools.{}", role.name());
            if let Some(key) = self.source.written(&table, shapes).first() {
                let what = format!("the {} has both a profile and `{key}`", role.name());
                return Err(self.source.error(&format!("{table}.profile"), what, help));
            }
            return section::convert(profile, role, self);
        }
        let (written, thickness) = (self.written, self.sheet.thickness);
        match (role, &written.punch, &written.die, &written.holder) {
            (Role::Punch, Some(punch), ..) => self.punch(punch, thickness),
            (Role::Die, _, Some(die), _) => {
                let (throat, across) = (die.throat, die.throat_diameter);
                let throat =
                    self.radius("tools.die", ["throat", "throat_diameter", "throat"], [throat, across, throat])?;
                let shoulder = die.shoulder.ok_or_else(|| self.source.missing("tools.die", "shoulder"))?;
                Ok(Profile::die(throat, self.size("tools.die.shoulder", shoulder.value())?, thickness))
            }
            (Role::Holder, .., Some(holder)) => {
                let keys = ["inner_radius", "inner_diameter", "inner_half_width"];
                let lengths = [holder.inner_radius, holder.inner_diameter, holder.inner_half_width];
                Ok(Profile::holder(self.radius("tools.holder", keys, lengths)?, thickness))
            }
            _ => Err(self.source.missing("tools", role.name())),
        }
    }

    fn punch(&self, punch: &file::Punch, thickness: f64) -> Result<Profile, CaseError> {
        let help = "give one of hemispherical = { radius }, flat = { radius, nose }, crowned = { radius, face, nose }, \
                    profile = [..] or \"punch.csv\"";
        self.source.one_of("tools.punch", &["hemispherical", "flat", "crowned"], help)?;
        if let Some(shape) = &punch.hemispherical {
            let (path, lengths) = ("tools.punch.hemispherical", [shape.radius, shape.diameter, shape.radius]);
            let radius = self.radius(path, ["radius", "diameter", "radius"], lengths)?;
            Ok(Profile::hemispherical_punch(radius, thickness))
        } else if let Some(shape) = &punch.flat {
            let radius = self.radius("tools.punch.flat", ROUND, [shape.radius, shape.diameter, shape.half_width])?;
            Ok(Profile::flat_punch(radius, self.nose("flat", shape.nose, radius)?, thickness))
        } else if let Some(shape) = &punch.crowned {
            let radius = self.radius("tools.punch.crowned", ROUND, [shape.radius, shape.diameter, shape.half_width])?;
            let (nose, face) = (self.nose("crowned", shape.nose, radius)?, shape.face.value());
            let [f, r, n] = [face, radius, nose].map(rounded);
            let what = format!("a crowned face of radius {f} mm does not fit a punch of {r} mm, nose {n} mm");
            let help = "the face must be larger than the punch and the nose smaller; else use flat or hemispherical";
            let fits = face >= radius + SMALLEST && nose <= radius - SMALLEST;
            self.source.require(fits, "tools.punch.crowned.face", what, help)?;
            Ok(Profile::crowned_punch(radius, face, nose, thickness))
        } else {
            Err(self.source.error("tools.punch", "the punch has no shape", help))
        }
    }

    /// Radius or half-width of a shape \[mm\].
    fn radius(
        &self,
        table: &str,
        keys: [&'static str; 3],
        lengths: [Option<Positive<Length>>; 3],
    ) -> Result<f64, CaseError> {
        let (key, value) = radius_of(self.source, table, self.sheet.extent.geometry(), keys, lengths)?;
        self.size(&format!("{table}.{key}"), value)
    }

    fn size(&self, path: &str, value: f64) -> Result<f64, CaseError> {
        let what = format!("this radius is too small: {value:e} mm, at least {SMALLEST} mm");
        let help = "check the unit; thin-shell theory wants radii above five thicknesses";
        self.source.require(value >= SMALLEST, path, what, help)?;
        Ok(value)
    }

    fn nose(&self, shape: &str, nose: Positive<Length>, radius: f64) -> Result<f64, CaseError> {
        let path = format!("tools.punch.{shape}.nose");
        let nose = self.size(&path, nose.value())?;
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
    for ToolKeys { role, .. } in context.written.keys() {
        let table = format!("tools.{}", role.name());
        source.refuse(
            &table,
            &["move", "aside"],
            "is for tools of later stages",
            "drop it, or move it to [[stages]]",
        )?;
        let die = tools.iter().find(|tool| tool.role == Role::Die);
        let help = "add [tools.die], or drop the holder and clamp the edge";
        source.require(role != Role::Holder || die.is_some(), &table, "a holder needs a die to press against", help)?;
        let profile = context.new_profile(role)?;
        let motion = match (role, &context.written.holder, die) {
            (Role::Punch, ..) => Motion::Travel,
            (Role::Holder, Some(holder), Some(die)) => holder::motion(holder, &profile, die, &context.sheet, source)?,
            _ => Motion::Fixed,
        };
        tools.push(Tool { role, profile, friction: frictions.law(role, source)?, motion });
    }
    Ok(tools)
}
