//! `[[stages]]`: each the model of the stage before with what it says changed.

use super::tools::{Sheet, Shop, die_profile, holder_profile, punch_profile};
use super::{count, friction, limits, loads, material};
use crate::case::file::{self, CaseFile, ReleaseStiffness};
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::history::History;
use crate::model::{self, Edge, Model, Motion, Press, Release, Role, Stiffness, StopRules, Tool};
use crate::quantity::{Quantity, rounded};
use crate::stage::{Beginning, Stage};
use std::path::Path;

/// Name of the first stage where it has none.
const FIRST: &str = "forming";
/// Most stages of a case, and letters of a name.
const MOST: usize = 50;
const LONGEST: usize = 40;
/// Share of the travel over which a holder's force goes over to that of the next stage \[–\].
const RAMP: f64 = 0.2;
/// Longest path of a tool over the blank's length \[–\].
const FURTHEST: f64 = 3.0;

/// The name of the first stage, and the stages after it.
pub(super) fn convert(
    file: &CaseFile,
    first: &Model,
    source: &Source,
    folder: &Path,
    derived: &mut Vec<String>,
) -> Result<(String, Vec<Stage>), CaseError> {
    let name = file.stage.name.clone().unwrap_or_else(|| FIRST.to_owned());
    check_name(&name, "stage.name", source)?;
    if file.stages.len() > MOST {
        let what = format!("a case has {} later stages, more than {MOST}", file.stages.len());
        return Err(source.error(&format!("stages.{MOST}"), what, "leave out what is not needed"));
    }
    let mut case = file.clone();
    let mut stages: Vec<Stage> = Vec::new();
    for (i, written) in file.stages.iter().enumerate() {
        let path = format!("stages.{i}.name");
        check_name(&written.name, &path, source)?;
        if written.name == name || stages.iter().any(|other| other.name == written.name) {
            let what = format!("two stages are called `{}`", written.name);
            return Err(source.error(&path, what, "name them apart: each has its own folder"));
        }
        let before = stages.last().map_or(first, |stage| &stage.model);
        let source = &source.of_stage(i)?;
        let next = Next { written, before, first, source, folder, path: format!("stages.{i}") };
        let mut said = Vec::new();
        let stage = next.stage(&mut case, &mut said)?;
        derived.extend(said.into_iter().map(|what| format!("stage {}: {what}", written.name)));
        stages.push(stage);
    }
    Ok((name, stages))
}

fn check_name(name: &str, path: &str, source: &Source) -> Result<(), CaseError> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if (1..=LONGEST).contains(&name.len()) && name.chars().all(plain) {
        return Ok(());
    }
    let what = format!("a stage cannot be called \"{name}\": it names a folder");
    Err(source.error(path, what, format!("at most {LONGEST} letters, digits, - and _, such as \"redraw\"")))
}

/// A stage on its way from what was written.
struct Next<'a> {
    written: &'a file::Stage,
    before: &'a Model,
    first: &'a Model,
    source: &'a Source<'a>,
    folder: &'a Path,
    /// Key path of the stage.
    path: String,
}

/// What is written of a tool, whichever it is.
struct Said {
    role: Role,
    path: Option<(f64, f64)>,
    shaped: bool,
    friction: bool,
}

impl Next<'_> {
    fn error(&self, key: &str, what: impl Into<String>, help: &str) -> CaseError {
        self.source.error(&format!("{}.{key}", self.path), what, help)
    }

    /// The stage; `case` is the case as it would be written for it alone, as far as its tools go.
    fn stage(&self, case: &mut CaseFile, derived: &mut Vec<String>) -> Result<Stage, CaseError> {
        let Self { written, before, first, .. } = *self;
        let mut model = before.clone();
        for tool in &mut model.tools {
            tool.motion = match &tool.motion {
                Motion::Travel | Motion::Path { .. } | Motion::Fixed => Motion::Fixed,
                Motion::Pressed(press) => {
                    let force = press.force.at(before.travel).into();
                    Motion::Pressed(Press { force, stiffness: press.stiffness })
                }
                Motion::Gap(gap) => Motion::Gap(*gap),
            };
        }
        if !model.gas.is_empty() {
            derived.push("gas acts in the first stage only".into());
            model.gas.clear();
        }
        model.stop = StopRules { localised: first.stop.localised, ..StopRules::default() };
        model.schedule = None;
        self.remove(&mut model, case)?;
        let tools = self.tools(case);
        let (travel, duration, speed) = self.pace(&tools)?;
        (model.travel, model.duration, model.speed) = (travel, duration, speed);
        let mut begin = Beginning { anneal: written.anneal, ..Beginning::default() };
        for said in &tools {
            self.place(said, &mut model, case, &mut begin, derived)?;
        }
        self.press(&mut model, &mut begin)?;
        if model.tool(Role::Holder).is_some_and(|holder| matches!(holder.motion, Motion::Pressed(_)))
            && model.tool(Role::Die).is_none()
        {
            let help = "remove the holder too, or let it stand still or go back with `move`";
            return Err(self.error("remove", "the holder has no die to press against", help));
        }
        if let Some(edge) = written.edge {
            model.blank.edge = if edge == file::Edge::Free { Edge::Free } else { Edge::Clamped };
        }
        model.release = self.release(&tools)?;
        // What the flow law has formed springs back by D(E, ν).
        let springs = model.release.is_some() && model.mode == model::Mode::Flow;
        let (mode, key) = match written.mode {
            None if springs => (Some(file::Mode::Elastic), "release"),
            mode => (mode, "mode"),
        };
        if let Some(mode) = mode {
            model.mode = material::mode(mode, &model.material, &format!("{}.{key}", self.path), self.source)?;
        }
        if model.release.is_some() && model.mode == model::Mode::Flow {
            let help = "drop it, or write \"elastic\" or \"elasto_viscoplastic\"";
            return Err(self.error("mode", "the flow law has no elasticity, nothing springs back", help));
        }
        if model.release.is_some() {
            model.tools.iter_mut().for_each(|tool| tool.motion = Motion::Fixed);
        }
        begin.trim = written.trim.map(Quantity::value);
        if let Some(radius) = begin.trim.filter(|radius| *radius >= before.blank.length) {
            let (radius, length) = (rounded(radius), rounded(before.blank.length));
            let what = format!("trimming at {radius} mm cuts nothing from a blank of {length} mm");
            return Err(self.error("trim", what, "it is the distance from the axis where the sheet is cut"));
        }
        let frames = count(self.source, &format!("{}.frames", self.path), written.frames.unwrap_or(4), 1..=1000)?;
        model.frames = (1..frames).map(|i| duration * i as f64 / frames as f64).chain([duration]).collect();
        limits::of_model(&model, self.source)?;
        Ok(Stage { name: written.name.clone(), model, begin })
    }

    /// Takes the tools away that are no longer there.
    fn remove(&self, model: &mut Model, case: &mut CaseFile) -> Result<(), CaseError> {
        for (k, name) in self.written.remove.iter().enumerate() {
            let role = Role::from(*name);
            if model.tool(role).is_none() {
                let what = format!("there is no {} to remove", role.name());
                return Err(self.error(&format!("remove.{k}"), what, "drop it"));
            }
            model.tools.retain(|tool| tool.role != role);
            match role {
                Role::Punch => case.tools.punch = None,
                Role::Die => case.tools.die = None,
                Role::Holder => case.tools.holder = None,
            }
        }
        Ok(())
    }

    /// What is said of the tools, written into `case` as the first stage would have it.
    fn tools(&self, case: &mut CaseFile) -> Vec<Said> {
        let way = |axial: Option<crate::quantity::Length>, aside: Option<crate::quantity::Length>| {
            let mm = |length: Option<crate::quantity::Length>| length.map_or(0.0, Quantity::value);
            (axial.is_some() || aside.is_some()).then(|| (mm(axial), mm(aside)))
        };
        let mut tools = Vec::new();
        if let Some(punch) = &self.written.punch {
            let shaped = punch.hemispherical.is_some()
                || punch.flat.is_some()
                || punch.crowned.is_some()
                || punch.profile.is_some();
            let path = way(punch.axial, punch.aside);
            tools.push(Said { role: Role::Punch, path, shaped, friction: punch.friction.is_some() });
            let old = case.tools.punch.take();
            let friction = punch.friction.or(old.as_ref().and_then(|old| old.friction));
            case.tools.punch = match old {
                Some(old) if !shaped => Some(file::Punch { friction, ..old }),
                _ => Some(file::Punch {
                    hemispherical: punch.hemispherical.clone(),
                    flat: punch.flat.clone(),
                    crowned: punch.crowned.clone(),
                    profile: punch.profile.clone(),
                    friction,
                    travel: None,
                    speed: None,
                    motion: None,
                }),
            };
        }
        if let Some(die) = &self.written.die {
            let shaped = die.throat.is_some() || die.shoulder.is_some() || die.profile.is_some();
            let path = way(die.axial, die.aside);
            tools.push(Said { role: Role::Die, path, shaped, friction: die.friction.is_some() });
            let old = case.tools.die.take();
            let friction = die.friction.or(old.as_ref().and_then(|old| old.friction));
            case.tools.die = match old {
                Some(old) if !shaped => Some(file::Die { friction, ..old }),
                _ => {
                    let file::StageDie { throat, shoulder, ref profile, .. } = *die;
                    Some(file::Die { throat, shoulder, profile: profile.clone(), friction })
                }
            };
        }
        if let Some(holder) = &self.written.holder {
            let shaped = holder.inner_radius.is_some() || holder.inner_half_width.is_some() || holder.profile.is_some();
            let path = way(holder.axial, holder.aside);
            tools.push(Said { role: Role::Holder, path, shaped, friction: holder.friction.is_some() });
            let old = case.tools.holder.take();
            let friction = holder.friction.or(old.as_ref().and_then(|old| old.friction));
            let force = holder.force.clone();
            case.tools.holder = match old {
                Some(old) if !shaped => Some(file::Holder { friction, force, ..old }),
                _ => Some(file::Holder {
                    inner_radius: holder.inner_radius,
                    inner_half_width: holder.inner_half_width,
                    profile: holder.profile.clone(),
                    force,
                    pressure: None,
                    gap: None,
                    spring: None,
                    friction,
                }),
            };
        }
        tools
    }

    /// Travel \[mm\], duration \[s\] and speed \[mm/s\]: the longest path of a tool, and how fast it goes.
    fn pace(&self, tools: &[Said]) -> Result<(f64, f64, f64), CaseError> {
        let (mut travel, mut furthest) = (0.0, Role::Punch);
        for said in tools {
            let path = said.path.map_or(0.0, |(axial, aside)| axial.hypot(aside));
            if path > travel {
                (travel, furthest) = (path, said.role);
            }
        }
        let length = self.first.blank.length;
        if travel > FURTHEST * length {
            let (way, length) = (rounded(travel), rounded(length));
            let what = format!("a way of {way} mm is more than {FURTHEST} times the blank's {length} mm");
            return Err(self.error(furthest.name(), what, "check the unit"));
        }
        let duration = self.written.duration.map(Quantity::value);
        match (self.written.speed, duration) {
            (Some(_), Some(_)) => Err(self.error("duration", "both a speed and a duration are given", "keep one")),
            (Some(_), None) if travel == 0.0 => {
                let help = "write duration = \"1 s\", or let a tool `move`";
                Err(self.error("speed", "a speed is given, and no tool goes anywhere", help))
            }
            (speed, None) if travel > 0.0 => {
                let speed = speed.map_or(self.first.speed, Quantity::value);
                Ok((travel, travel / speed, speed))
            }
            (_, Some(duration)) if travel > 0.0 => Ok((travel, duration, travel / duration)),
            (_, duration) => Ok((travel, duration.unwrap_or(1.0), self.first.speed)),
        }
    }

    /// Gives a tool its new shape, friction and motion.
    fn place(
        &self,
        said: &Said,
        model: &mut Model,
        case: &CaseFile,
        begin: &mut Beginning,
        derived: &mut Vec<String>,
    ) -> Result<(), CaseError> {
        let Said { role, path, shaped, .. } = *said;
        let name = role.name();
        if !shaped && model.tool(role).is_none() {
            let what = format!("there is no {name} in this stage");
            return Err(self.error(name, what, "give it a shape as in [tools], or drop it"));
        }
        let motion = path.map_or(Motion::Fixed, |(axial, aside)| Motion::Path { axial, aside });
        if shaped {
            let profile = self.profile(role, model, case, derived)?;
            let friction = friction::of(role, case, self.source, derived)?;
            model.tools.retain(|tool| tool.role != role);
            model.tools.push(Tool { role, profile, friction, motion });
            model.tools.sort_by_key(|tool| Role::ALL.iter().position(|role| *role == tool.role));
            begin.meets.push(role);
            return Ok(());
        }
        let friction = said.friction.then(|| friction::of(role, case, self.source, derived)).transpose()?;
        for tool in model.tools.iter_mut().filter(|tool| tool.role == role) {
            tool.friction = friction.unwrap_or(tool.friction);
            if path.is_some() {
                tool.motion = motion.clone();
            }
        }
        Ok(())
    }

    /// The section of a new tool.
    fn profile(
        &self,
        role: Role,
        model: &Model,
        case: &CaseFile,
        derived: &mut Vec<String>,
    ) -> Result<Profile, CaseError> {
        let sheet = Sheet { geometry: model.geometry, length: model.blank.length, thickness: model.blank.thickness };
        let shop = Shop { case, sheet, travel: model.travel, source: self.source, folder: self.folder };
        let never = "written by `tools`";
        match role {
            Role::Punch => punch_profile(case.tools.punch.as_ref().expect(never), &shop, derived),
            Role::Die => die_profile(case.tools.die.as_ref().expect(never), &shop, derived),
            Role::Holder => holder_profile(case.tools.holder.as_ref().expect(never), &shop, derived),
        }
    }

    /// The holder's force: one force is reached from the last one over the first part of the travel.
    fn press(&self, model: &mut Model, begin: &mut Beginning) -> Result<(), CaseError> {
        let Some(given) = self.written.holder.as_ref().and_then(|holder| holder.force.as_ref()) else { return Ok(()) };
        let (geometry, travel) = (model.geometry, model.travel);
        let force = loads::holder_force(given, geometry, self.source)?;
        let last = match self.before.tool(Role::Holder).map(|holder| &holder.motion) {
            Some(Motion::Pressed(press)) => Some(press.force.at(self.before.travel)),
            _ => None,
        };
        let Some(holder) = model.tools.iter_mut().find(|tool| tool.role == Role::Holder) else { return Ok(()) };
        if matches!(holder.motion, Motion::Path { .. }) {
            let help = "keep one: a holder that goes a given way has the force that this takes";
            return Err(self.error("holder.force", "the holder has both a way to go and a force", help));
        }
        let stays = !begin.meets.contains(&Role::Holder);
        let force = match (given, last) {
            (file::Given::Constant(_), Some(last)) if stays && travel > 0.0 => {
                History::new(vec![(0.0, last), (RAMP * travel, force.at(0.0))]).unwrap_or(force)
            }
            _ => force,
        };
        holder.motion = Motion::Pressed(Press { force, stiffness: 0.0 });
        if stays && last.is_none() {
            begin.meets.push(Role::Holder);
        }
        Ok(())
    }

    fn release(&self, tools: &[Said]) -> Result<Option<Release>, CaseError> {
        let Some(stiffness) = self.written.release.and_then(|release| release.0) else { return Ok(None) };
        if let Some(said) = tools.iter().find(|said| said.path.is_some()) {
            let what = "tools that are taken away cannot move as well";
            return Err(self.error(said.role.name(), what, "drop `move` and `aside`, or the release"));
        }
        let stiffness = match stiffness {
            ReleaseStiffness::Updated => Stiffness::Updated,
            ReleaseStiffness::Constant => Stiffness::Constant,
        };
        Ok(Some(Release { stiffness }))
    }
}

impl From<file::Mode> for model::Mode {
    fn from(mode: file::Mode) -> Self {
        match mode {
            file::Mode::Flow => Self::Flow,
            file::Mode::ElastoViscoplastic => Self::ElastoViscoplastic,
            file::Mode::Elastic => Self::Elastic,
        }
    }
}
