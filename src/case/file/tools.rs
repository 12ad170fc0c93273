//! `[tools]` and the tools of `[[stages]]`: shapes placed where they touch the flat sheet.

use super::contact::{Bead, Friction, Spring};
use super::further::{Further, further_tools};
use super::section::Section;
use super::*;
use crate::units::Speed;

/// Least radius of a tool, and least opening \[mm\].
const SMALLEST: f64 = 1e-3;
const WIDTHS: [&str; 3] = ["radius", "diameter", "half_width"];

/// The rigid tools; each is placed where it touches the flat sheet.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tools {
    /// Punch, at smaller z than the sheet, which pictures draw on top.
    pub punch: Option<Punch>,
    /// Die, at larger z than the sheet.
    pub die: Option<Die>,
    /// Blank holder, on the punch's side.
    pub holder: Option<Holder>,
    /// Pad on the die's side.
    pub pad: Option<Pad>,
    /// Tools beside these, each with its name and its drive.
    #[serde(default)]
    pub further: Vec<Further>,
    /// Draw beads across the flange, as line restraints.
    #[serde(default)]
    pub beads: Vec<Bead>,
}

/// Struct of a tool with the keys of all tools; `shapes` make it a new one in a later stage.
macro_rules! tool {
    ($(#[$attribute:meta])* $tool:ident, shapes $($shape:ident)+; $($own:tt)+) => {
        #[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        $(#[$attribute])*
        pub struct $tool {
            $($own)+
            /// A section of one's own: of punch and holder from the axis outward, of a die from outside inward.
            profile: Option<Section>,
            /// Coulomb's coefficient of friction, 0 to 1, or another law. When not given that of its side of the sheet; a
            /// holder then has the die's.
            friction: Option<Friction>,
            /// Later stages: distance along z, positive along the punch travel; a holder that moves has no force.
            #[serde(rename = "move")]
            axial: Option<Length>,
            /// Later stages: distance away from the axis or symmetry plane.
            aside: Option<Length>,
        }

        impl $tool {
            const SHAPES: &[&str] = &[$(stringify!($shape)),+];

            fn keys(&self) -> ToolKeys<'_> {
                ToolKeys {
                    role: Role::$tool,
                    profile: self.profile.as_ref(),
                    friction: self.friction,
                    moves: [self.aside, self.axial],
                    shapes: Self::SHAPES,
                    is_shaped: self.profile.is_some() $(|| self.$shape.is_some())+,
                }
            }
        }
    };
}

#[derive(Clone, Copy)]
pub struct ToolKeys<'a> {
    pub role: Role,
    pub profile: Option<&'a Section>,
    pub friction: Option<Friction>,
    /// Away from the axis or symmetry plane and along z.
    pub moves: [Option<Length>; 2],
    /// Keys of shapes other than a profile.
    pub shapes: &'static [&'static str],
    /// True if it has a shape, which in a later stage makes it a new tool.
    pub is_shaped: bool,
}

impl Tools {
    pub fn keys(&self) -> impl Iterator<Item = ToolKeys<'_>> {
        let [punch, die] = [self.punch.as_ref().map(Punch::keys), self.die.as_ref().map(Die::keys)];
        let [holder, pad] = [self.holder.as_ref().map(Holder::keys), self.pad.as_ref().map(Pad::keys)];
        [punch, die, holder, pad].into_iter().flatten()
    }
}

tool! {
    /// Punch, moving towards +z; exactly one of the shapes is given. In a later stage a shape makes it a new one, which is
    /// brought up until it touches the sheet.
    Punch, shapes hemispherical flat crowned;
    /// Spherical nose.
    hemispherical: Option<Hemispherical>,
    /// Flat face, corner and straight wall.
    flat: Option<Flat>,
    /// Gently curved face, corner and straight wall.
    crowned: Option<Crowned>,
    /// Punch travel from where it touches the flat sheet.
    pub travel: Option<Positive<Length>>,
    /// Punch speed, 1 mm/s when not given; hardening without rate dependence does not feel it.
    pub speed: Option<Positive<Speed>>,
    /// Instead of travel and speed: the travel over time, rising from 0 mm at 0 s to the whole travel, straight between.
    pub motion: Option<Vec<(NonNegative<Time>, NonNegative<Length>)>>,
}

tool! {
    /// Die, standing still at larger z than the sheet: `throat` and `shoulder`, or a `profile`. In a later stage a shape makes
    /// it a new one, which is brought up until it touches the sheet.
    #[schemars(extend("dependentRequired" = { "throat": ["shoulder"], "throat_diameter": ["shoulder"] }))]
    Die, shapes throat throat_diameter shoulder land relief cone tractrix mouth mouth_diameter;
    /// Radius of the opening (plane strain: half width).
    throat: Option<Positive<Length>>,
    /// Diameter of the opening, instead of `throat`, of a round die.
    throat_diameter: Option<Positive<Length>>,
    /// Radius of the corner over which the sheet is drawn; with `cone` or `tractrix` that of the mouth's edge.
    pub shoulder: Option<Positive<Length>>,
    /// Length of the cylindrical part behind the shoulder; without end when not given.
    pub land: Option<Positive<Length>>,
    /// Angle to the axis by which the die opens behind its land, 0.5° to 60°; 3° when not given.
    pub relief: Option<Angle>,
    /// Conical entry: its angle to the axis, 5° to 80°.
    pub cone: Option<Angle>,
    /// Tractrix as the entry, for a draw without a holder.
    pub tractrix: Option<bool>,
    /// Place where the die's face ends and a cone or a tractrix begins (plane strain: half width); the blank's edge when not given.
    pub mouth: Option<Positive<Length>>,
    /// Diameter of the mouth, instead of `mouth`, of a round die.
    pub mouth_diameter: Option<Positive<Length>>,
}

tool! {
    /// Blank holder, pressing the sheet against the die: a flat ring from its inner radius outward, or a `profile`. In a later
    /// stage a shape makes it a new one, which is brought up until it touches the sheet. Where a profile and the die
    /// cannot both lie on the flat sheet, for a bead or a slope, the holder closes over the sheet before the punch comes.
    Holder, shapes inner_radius inner_diameter inner_half_width;
    /// Inner radius (axisymmetric).
    inner_radius: Option<Positive<Length>>,
    /// Inner diameter, instead of `inner_radius`.
    inner_diameter: Option<Positive<Length>>,
    /// Distance of its inner edge from the symmetry plane (plane strain).
    inner_half_width: Option<Positive<Length>>,
    /// Force of the whole holder ("80 kN"); in plane strain of both sides together, per mm of depth ("2600 N/mm") unless
    /// blank.depth is given. Or its history over the punch travel: [["0 mm", "40 kN"], ["20 mm", "80 kN"]]. In a later stage
    /// one force is reached from the last one over the first fifth of the travel, at once where nothing moves.
    pub force: Option<History<NonNegative<Length>, HolderForce>>,
    /// Pressure times the initial area between holder and the die's flat: a force that stays.
    pub pressure: Option<NonNegative<Stress>>,
    /// Fixed distance between the faces of holder and die: distance blocks.
    pub gap: Option<Positive<Length>>,
    /// Springs or a cushion: the force grows as the holder is pushed away from the die.
    pub spring: Option<Spring>,
}

tool! {
    /// Pad, ejector or counter-punch: a flat face on the die's side, or a `profile`, pressed against the punch, which pushes it
    /// back. It holds the bottom flat. In a later stage a shape makes it a new one, brought down until it touches the sheet.
    Pad, shapes radius diameter half_width;
    /// Radius (axisymmetric).
    radius: Option<Positive<Length>>,
    /// Diameter, instead of `radius`.
    diameter: Option<Positive<Length>>,
    /// Half width (plane strain).
    half_width: Option<Positive<Length>>,
    /// Radius of its edge; a thickness when not given.
    pub nose: Option<Positive<Length>>,
    /// Force of the whole pad as that of a holder, or its history over the punch travel, as of a gas spring.
    pub force: Option<History<NonNegative<Length>, HolderForce>>,
    /// Pressure times the area of its face: a force that stays.
    pub pressure: Option<NonNegative<Stress>>,
    /// Springs: the force grows as the punch pushes the pad back.
    pub spring: Option<Spring>,
}

/// Spherical nose (plane strain: cylindrical).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [{ "required": ["radius"] }, { "required": ["diameter"] }]))]
pub struct Hemispherical {
    /// Radius of the nose and of the wall.
    radius: Option<Positive<Length>>,
    /// Diameter, instead of `radius`, of a round punch.
    diameter: Option<Positive<Length>>,
}

/// Flat face, corner and straight wall.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flat {
    /// Radius of the wall (axisymmetric).
    radius: Option<Positive<Length>>,
    /// Diameter of the wall, instead of `radius`.
    diameter: Option<Positive<Length>>,
    /// Half width between the walls (plane strain).
    half_width: Option<Positive<Length>>,
    /// Radius of the corner.
    nose: Positive<Length>,
}

/// Gently curved face, corner and straight wall.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Crowned {
    /// Radius of the wall (axisymmetric).
    radius: Option<Positive<Length>>,
    /// Diameter of the wall, instead of `radius`.
    diameter: Option<Positive<Length>>,
    /// Half width between the walls (plane strain).
    half_width: Option<Positive<Length>>,
    /// Radius of curvature of the face, larger than the punch's own radius.
    face: Positive<Length>,
    /// Radius of the corner.
    nose: Positive<Length>,
}

pub struct ToolContext<'a> {
    pub written: &'a Tools,
    /// Tools that remain from the stage before.
    pub standing: &'a [model::Tool],
    /// Names of all further tools.
    pub further: &'a [String],
    pub blank: &'a model::Blank,
    pub extent: Extent,
    /// Punch travel of the whole run \[mm\].
    pub travel: f64,
    pub source: &'a Source<'a>,
}

impl ToolContext<'_> {
    pub fn keys(&self, role: Role) -> Option<ToolKeys<'_>> {
        self.written.keys().find(|tool| tool.role == role)
    }

    pub fn profile(&self, role: Role) -> Result<Option<Profile>> {
        if self.keys(role).is_some_and(|tool| tool.is_shaped || self.standing.is_empty()) {
            // Notes are taken where the tool itself is made.
            return self.source.silently(|| self.new_profile(role)).map(Some);
        }
        Ok(self.standing.iter().find(|tool| tool.role == role).map(|tool| tool.profile.clone()))
    }

    pub fn drawn_profile(&self, role: Role) -> Result<Profile> {
        if let Some(ToolKeys { profile: Some(profile), shapes, .. }) = self.keys(role) {
            let table = format!("tools.{}", role.name());
            let shape = self.source.written(&table, shapes).first().copied().unwrap_or("");
            let what = format!("the {} has both a profile and `{shape}`", role.name());
            let help = "the radius is in the profile: change it there or in its drawing, or drop the profile";
            self.source.require(shape.is_empty(), &format!("{table}.profile"), what, help)?;
            return profile.placed(role, self);
        }
        let thickness = self.blank.thickness;
        match (role, &self.written.punch, &self.written.die, &self.written.holder) {
            (Role::Punch, Some(punch), ..) => self.punch(punch, thickness),
            (Role::Die, _, Some(die), _) => {
                let keys = ["throat", "throat_diameter", "throat"];
                let throat = self.radius("tools.die", keys, [die.throat, die.throat_diameter, die.throat])?;
                let shoulder = die.shoulder.ok_or_else(|| self.source.missing("tools.die", "shoulder"))?;
                let shoulder = self.size("tools.die.shoulder", shoulder.value())?;
                Ok(Profile::die_with(&self.opening(die, throat, shoulder)?, thickness))
            }
            (Role::Holder, .., Some(holder)) => {
                let keys = ["inner_radius", "inner_diameter", "inner_half_width"];
                let lengths = [holder.inner_radius, holder.inner_diameter, holder.inner_half_width];
                Ok(Profile::holder(self.radius("tools.holder", keys, lengths)?, thickness))
            }
            (Role::Pad, ..) if let Some(pad) = &self.written.pad => {
                let radius = self.radius("tools.pad", WIDTHS, [pad.radius, pad.diameter, pad.half_width])?;
                let nose = pad.nose.map_or(thickness, Dimensioned::value).min(radius);
                Ok(Profile::flat_punch(radius, nose, thickness).mirrored())
            }
            _ => Err(self.source.missing("tools", role.name())),
        }
    }

    fn punch(&self, punch: &Punch, thickness: f64) -> Result<Profile> {
        let help = "give one of hemispherical = { radius }, flat = { radius, nose }, crowned = { radius, face, nose }, \
                    profile = [..] or \"punch.csv\"";
        self.source.one_of("tools.punch", Punch::SHAPES, help)?;
        let of = |shape: &str, lengths| self.radius(&format!("tools.punch.{shape}"), WIDTHS, lengths);
        if let Some(Hemispherical { radius, diameter }) = punch.hemispherical {
            let (path, keys) = ("tools.punch.hemispherical", ["radius", "diameter", "radius"]);
            Ok(Profile::hemispherical_punch(self.radius(path, keys, [radius, diameter, radius])?, thickness))
        } else if let Some(Flat { radius, diameter, half_width, nose }) = punch.flat {
            let radius = of("flat", [radius, diameter, half_width])?;
            Ok(Profile::flat_punch(radius, self.nose("flat", nose, radius)?, thickness))
        } else if let Some(Crowned { radius, diameter, half_width, face, nose }) = punch.crowned {
            let radius = of("crowned", [radius, diameter, half_width])?;
            let (nose, face) = (self.nose("crowned", nose, radius)?, face.value());
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
    pub fn radius(&self, table: &str, keys: [&'static str; 3], lengths: [Option<Positive<Length>>; 3]) -> Result<f64> {
        let (key, value) = radius_of(self.source, table, self.extent.geometry(), keys, lengths)?;
        self.size(&format!("{table}.{key}"), value)
    }

    fn size(&self, path: &str, value: f64) -> Result<f64> {
        let what = format!("this radius is too small: {value:e} mm, at least {SMALLEST} mm");
        let help = "check the unit; thin-shell theory wants radii above five thicknesses";
        self.source.require(value >= SMALLEST, path, what, help)?;
        Ok(value)
    }

    fn nose(&self, shape: &str, nose: Positive<Length>, radius: f64) -> Result<f64> {
        let path = format!("tools.punch.{shape}.nose");
        let nose = self.size(&path, nose.value())?;
        let what = format!("a nose of {} mm is larger than the punch of {} mm", rounded(nose), rounded(radius));
        let help = format!("at most {} mm: then it is hemispherical", rounded(radius));
        self.source.require(nose <= radius, &path, what, help)?;
        // A flat shorter than round-off is none.
        Ok(if radius - nose < 1e-3 * SMALLEST { radius } else { nose })
    }

    pub fn tools(&self, frictions: &Frictions) -> Result<Vec<model::Tool>> {
        let mut tools: Vec<model::Tool> = Vec::new();
        for ToolKeys { role, .. } in self.written.keys() {
            let (table, source) = (format!("tools.{}", role.name()), self.source);
            let (why, help) = ("is for tools of later stages", "drop it, or move it to [[stages]]");
            source.refuse(&table, &["move", "aside"], why, help)?;
            let die = tools.iter().find(|tool| tool.role == Role::Die);
            let help = "add [tools.die], or drop the holder and clamp the edge";
            let what = "a holder needs a die to press against";
            source.require(role != Role::Holder || die.is_some(), &table, what, help)?;
            let profile = self.new_profile(role)?;
            let motion = match (role, &self.written.holder, die) {
                (Role::Punch, ..) => Motion::Travel,
                (Role::Holder, Some(holder), Some(die)) => holder.support(&profile, die, self)?,
                (Role::Pad, ..) if let Some(pad) = &self.written.pad => {
                    pad.support(&profile, self.blank.length, self.extent, source)?
                }
                _ => Motion::Fixed,
            };
            tools.push(model::Tool { role, profile, friction: frictions.law(role, source)?, motion });
        }
        tools.extend(further_tools(frictions, self)?);
        Ok(tools)
    }
}
