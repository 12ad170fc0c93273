//! `[[stages]]`: each a patch on the model of the stage before.

use super::context::{Sheet, ToolContext};
use super::friction::{self, Frictions};
use super::patch::{Pace, StagePatch, ToolPatch, at_rest};
use super::values::count;
use super::{limits, loads, material, tools};
use crate::case::file::{self, CaseFile, Given};
use crate::case::files::Folder;
use crate::case::{CaseError, source::Source};
use crate::geometry::{Point, Profile};
use crate::model::{Beginning, Mode, Model, Motion, Press, Release, Role, Stage, Tool};
use crate::numerics::PiecewiseLinear;
use crate::units::{Dimensioned, Length, rounded};

/// Name of the first stage where it has none.
const FIRST: &str = "forming";
/// Most stages of a case, and letters of a name.
const MOST: usize = 50;
const LONGEST: usize = 40;
/// Share of the travel over which a holder's force goes over to that of the next stage \[–\].
const RAMP: f64 = 0.2;
/// Longest path of a tool over the blank's length \[–\].
const FURTHEST: f64 = 3.0;

/// All stages: the first one, and those that are patches on it.
pub(super) fn convert(
    file: &CaseFile,
    first: Model,
    source: &Source,
    folder: Folder,
    derived: &mut Vec<String>,
) -> Result<Vec<Stage>, CaseError> {
    let name = file.stage.name.clone().unwrap_or_else(|| FIRST.to_owned());
    check_name(&name, "stage.name", source)?;
    if file.stages.len() > MOST {
        let what = format!("a case has {} later stages, more than {MOST}", file.stages.len());
        return Err(source.error(&format!("stages.{MOST}"), what, "leave out what is not needed"));
    }
    let mut stages = vec![Stage { name, model: first, begin: Beginning::default() }];
    let mut frictions = Frictions::of(file);
    for (i, written) in file.stages.iter().enumerate() {
        let path = format!("stages.{i}");
        check_name(&written.name, &format!("{path}.name"), source)?;
        if stages.iter().any(|other| other.name == written.name) {
            let what = format!("two stages are called `{}`", written.name);
            return Err(source.error(&format!("{path}.name"), what, "name them apart: each has its own folder"));
        }
        let (first, before) = (&stages[0].model, &stages[i].model);
        let context = StageContext { written, before, first, source, folder, path };
        let mut said = Vec::new();
        source.enter_stage(Some((i, &written.name)));
        let stage = context.stage(&mut frictions, &mut said)?;
        derived.extend(said.into_iter().map(|what| format!("stage {name}: {what}", name = written.name)));
        stages.push(stage);
    }
    source.enter_stage(None);
    Ok(stages)
}

fn check_name(name: &str, path: &str, source: &Source) -> Result<(), CaseError> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if (1..=LONGEST).contains(&name.len()) && name.chars().all(plain) {
        return Ok(());
    }
    let what = format!("a stage cannot be called \"{name}\": it names a folder");
    Err(source.error(path, what, format!("at most {LONGEST} letters, digits, - and _, such as \"redraw\"")))
}

/// The table of a stage, and what it is read against.
struct StageContext<'a> {
    written: &'a file::Stage,
    before: &'a Model,
    first: &'a Model,
    source: &'a Source<'a>,
    folder: Folder<'a>,
    /// Key path of the stage.
    path: String,
}

/// What is written of a tool, whichever it is.
struct WrittenTool {
    role: Role,
    /// How far it goes away from the axis and along z \[mm\].
    path: Option<Point>,
    /// Whether it has a shape, which makes it a new tool.
    shaped: bool,
    friction: Option<file::Friction>,
}

impl StageContext<'_> {
    fn error(&self, key: &str, what: impl Into<String>, help: &str) -> CaseError {
        self.source.error(&format!("{}.{key}", self.path), what, help)
    }

    /// The stage; `frictions` are those that were written so far.
    fn stage(&self, frictions: &mut Frictions, derived: &mut Vec<String>) -> Result<Stage, CaseError> {
        if !self.before.gas.is_empty() {
            derived.push("gas acts in the first stage only".into());
        }
        let standing = self.standing(frictions)?;
        let patch = self.patch(&standing, frictions, derived)?;
        let model = patch.applied_to(at_rest(self.before, self.first, standing));
        let pressed = model.tool(Role::Holder).is_some_and(|holder| matches!(holder.motion, Motion::Pressed(_)));
        if pressed && model.tool(Role::Die).is_none() {
            let help = "remove the holder too, or let it stand still or go back with `move`";
            return Err(self.error("remove", "the holder has no die to press against", help));
        }
        if model.tools.is_empty() && model.release.is_none() {
            let key = if self.written.remove.is_empty() { "name" } else { "remove" };
            let help = "write `release = true` in its place: what the tools exerted fades, and the sheet springs back";
            return Err(self.error(key, "no tool is left, and nothing holds the sheet", help));
        }
        limits::of_model(&model, &format!("{}.frames", self.path), self.source)?;
        Ok(Stage { name: self.written.name.clone(), model, begin: patch.begin })
    }

    /// The tools of the stage before that are still there.
    fn standing(&self, frictions: &mut Frictions) -> Result<Vec<Tool>, CaseError> {
        let mut tools = self.before.tools.clone();
        for (k, role) in self.written.remove.iter().enumerate() {
            if tools.iter().all(|tool| tool.role != *role) {
                let what = format!("there is no {} to remove", role.name());
                return Err(self.error(&format!("remove.{k}"), what, "drop it"));
            }
            tools.retain(|tool| tool.role != *role);
            *frictions.own(*role) = None;
        }
        Ok(tools)
    }

    fn patch(
        &self,
        standing: &[Tool],
        frictions: &mut Frictions,
        derived: &mut Vec<String>,
    ) -> Result<StagePatch, CaseError> {
        let written = self.tools();
        for tool in &written {
            let own = frictions.own(tool.role);
            *own = tool.friction.or(*own);
        }
        let pace = self.pace(&written)?;
        let mut tools = Vec::new();
        for tool in &written {
            tools.push(self.tool(tool, standing, pace.travel, frictions, derived)?);
        }
        let mut meets: Vec<Role> = written.iter().filter(|tool| tool.shaped).map(|tool| tool.role).collect();
        if let Some(holder) = tools.iter_mut().find(|tool| tool.role == Role::Holder) {
            self.press(holder, pace.travel, &mut meets)?;
        }
        let release = self.release(&written)?;
        let frames = count(self.source, &format!("{}.frames", self.path), self.written.frames.unwrap_or(4), 1..=1000)?;
        Ok(StagePatch {
            tools,
            pace,
            edge: self.written.edge,
            mode: self.mode(release)?,
            release,
            frames,
            begin: Beginning { anneal: self.written.anneal, trim: self.trim()?, meets },
        })
    }

    /// What is written of the tools, in the order of their roles.
    fn tools(&self) -> Vec<WrittenTool> {
        let file::Stage { punch, die, holder, .. } = self.written;
        let way = |axial: Option<Length>, radial: Option<Length>| {
            let mm = |length: Option<Length>| length.map_or(0.0, Dimensioned::value);
            (axial.is_some() || radial.is_some()).then(|| Point::new(mm(radial), mm(axial)))
        };
        let punch = punch.as_ref().map(|t| WrittenTool {
            role: Role::Punch,
            path: way(t.axial, t.aside),
            shaped: t.hemispherical.is_some() || t.flat.is_some() || t.crowned.is_some() || t.profile.is_some(),
            friction: t.friction,
        });
        let die = die.as_ref().map(|t| WrittenTool {
            role: Role::Die,
            path: way(t.axial, t.aside),
            shaped: t.throat.is_some() || t.shoulder.is_some() || t.profile.is_some(),
            friction: t.friction,
        });
        let holder = holder.as_ref().map(|t| WrittenTool {
            role: Role::Holder,
            path: way(t.axial, t.aside),
            shaped: t.inner_radius.is_some() || t.inner_half_width.is_some() || t.profile.is_some(),
            friction: t.friction,
        });
        [punch, die, holder].into_iter().flatten().collect()
    }

    /// The new tools of the stage, as the first stage would have them.
    fn new_tools(&self) -> file::Tools {
        let shaped: Vec<Role> = self.tools().iter().filter(|tool| tool.shaped).map(|tool| tool.role).collect();
        let file::Stage { punch, die, holder, .. } = self.written.clone();
        file::Tools {
            punch: punch.filter(|_| shaped.contains(&Role::Punch)).map(file::Punch::from),
            die: die.filter(|_| shaped.contains(&Role::Die)).map(file::Die::from),
            holder: holder.filter(|_| shaped.contains(&Role::Holder)).map(file::Holder::from),
            beads: Vec::new(),
        }
    }

    /// The longest path of a tool, and how fast it goes.
    fn pace(&self, tools: &[WrittenTool]) -> Result<Pace, CaseError> {
        let (mut travel, mut furthest) = (0.0, Role::Punch);
        for tool in tools {
            let path = tool.path.map_or(0.0, |way| way.y.hypot(way.x));
            if path > travel {
                (travel, furthest) = (path, tool.role);
            }
        }
        let length = self.first.blank.length;
        if travel > FURTHEST * length {
            let (way, length) = (rounded(travel), rounded(length));
            let what = format!("a way of {way} mm is more than {FURTHEST} times the blank's {length} mm");
            return Err(self.error(furthest.name(), what, "check the unit"));
        }
        let usual = self.first.speed;
        let (speed, duration) =
            (self.written.speed.map(Dimensioned::value), self.written.duration.map(Dimensioned::value));
        let (duration, speed) = match (speed, duration) {
            (Some(_), Some(_)) => {
                return Err(self.error("duration", "both a speed and a duration are given", "keep one"));
            }
            (Some(_), None) if travel == 0.0 => {
                let help = "write duration = \"1 s\", or let a tool `move`";
                return Err(self.error("speed", "a speed is given, and no tool goes anywhere", help));
            }
            (_, duration) if travel == 0.0 => (duration.unwrap_or(1.0), usual),
            (_, Some(duration)) => (duration, travel / duration),
            (speed, None) => (travel / speed.unwrap_or(usual), speed.unwrap_or(usual)),
        };
        let timed = self.first.timed || self.written.speed.is_some() || self.written.duration.is_some();
        Ok(Pace { travel, duration, speed, timed })
    }

    /// The shape, friction and motion that are written of a tool.
    fn tool(
        &self,
        tool: &WrittenTool,
        standing: &[Tool],
        travel: f64,
        frictions: &Frictions,
        derived: &mut Vec<String>,
    ) -> Result<ToolPatch, CaseError> {
        let WrittenTool { role, path, shaped, .. } = *tool;
        if !shaped && standing.iter().all(|other| other.role != role) {
            let what = format!("there is no {} in this stage", role.name());
            return Err(self.error(role.name(), what, "give it a shape as in [tools], or drop it"));
        }
        let profile = if shaped { self.profile(role, standing, travel, derived)? } else { None };
        let friction = (shaped || tool.friction.is_some())
            .then(|| friction::of(role, frictions, self.source, derived))
            .transpose()?;
        let motion = path.map(Motion::Path);
        Ok(ToolPatch { role, profile, friction, motion })
    }

    /// The section of a new tool, which may be made from one that stands.
    fn profile(
        &self,
        role: Role,
        standing: &[Tool],
        travel: f64,
        derived: &mut Vec<String>,
    ) -> Result<Option<Profile>, CaseError> {
        let sheet = Sheet::of(&self.before.blank, self.before.extent());
        let written = &self.new_tools();
        let (source, folder, profile) = (self.source, self.folder, tools::profile);
        tools::new_profile(&ToolContext { written, standing, sheet, travel, source, folder, profile }, role, derived)
    }

    /// The holder's force: one force is reached from the last one over the first part of the travel. A holder that stays and
    /// had none is brought up to the sheet.
    fn press(&self, holder: &mut ToolPatch, travel: f64, meets: &mut Vec<Role>) -> Result<(), CaseError> {
        let Some(given) = self.written.holder.as_ref().and_then(|holder| holder.force.as_ref()) else { return Ok(()) };
        let force = loads::holder_force(given, self.before.extent(), self.source)?;
        if holder.motion.is_some() {
            let help = "keep one: a holder that goes a given way has the force that this takes";
            return Err(self.error("holder.force", "the holder has both a way to go and a force", help));
        }
        let last = match self.before.tool(Role::Holder).map(|holder| &holder.motion) {
            Some(Motion::Pressed(press)) => Some(press.force.at(self.before.travel)),
            _ => None,
        };
        let stays = holder.profile.is_none();
        let force = match (given, last) {
            (Given::Constant(_), Some(last)) if stays && travel > 0.0 => {
                PiecewiseLinear::new(vec![(0.0, last), (RAMP * travel, force.at(0.0))]).unwrap_or(force)
            }
            _ => force,
        };
        holder.motion = Some(Motion::Pressed(Press { force, stiffness: 0.0 }));
        if stays && last.is_none() {
            meets.push(Role::Holder);
        }
        Ok(())
    }

    fn release(&self, tools: &[WrittenTool]) -> Result<Option<Release>, CaseError> {
        let Some(stiffness) = self.written.release.and_then(|release| release.0) else { return Ok(None) };
        if let Some(tool) = tools.iter().find(|tool| tool.path.is_some()) {
            let what = "tools that are taken away cannot move as well";
            return Err(self.error(tool.role.name(), what, "drop `move` and `aside`, or the release"));
        }
        Ok(Some(Release { stiffness }))
    }

    /// How the metal answers; what the flow law has formed springs back by D(E, ν).
    fn mode(&self, release: Option<Release>) -> Result<Option<Mode>, CaseError> {
        let (mode, key) = match self.written.mode {
            None if release.is_some() && self.before.mode == Mode::Flow => (Some(Mode::Elastic), "release"),
            mode => (mode, "mode"),
        };
        let path = format!("{}.{key}", self.path);
        let mode = mode.map(|mode| material::mode(mode, &self.before.material, &path, self.source)).transpose()?;
        if release.is_some() && mode == Some(Mode::Flow) {
            let help = "drop it, or write \"elastic\" or \"elasto_viscoplastic\"";
            return Err(self.error("mode", "the flow law has no elasticity, nothing springs back", help));
        }
        Ok(mode)
    }

    /// Where the sheet is cut \[mm\].
    fn trim(&self) -> Result<Option<f64>, CaseError> {
        let radius = self.written.trim.map(Dimensioned::value);
        let length = self.before.blank.length;
        if let Some(radius) = radius.filter(|radius| *radius >= length) {
            let what =
                format!("trimming at {} mm cuts nothing from a blank of {} mm", rounded(radius), rounded(length));
            return Err(self.error("trim", what, "it is the distance from the axis where the sheet is cut"));
        }
        Ok(radius)
    }
}
