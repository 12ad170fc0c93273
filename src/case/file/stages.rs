//! `[stage]` and `[[stages]]`: operations after the first one, each changes the model of the stage before.

use super::drive::{Drive, check_settings, equally_spaced};
use super::further::{self, Further};
use super::tools::{Die, Holder, Pad, Punch, ToolKeys};
use super::*;
use crate::model::{Beginning, Press, ReleaseStiffness};
use crate::units::{Fraction, Speed};

const FIRST: &str = "forming";
const LONGEST: usize = 40;
/// Share of the travel over which a holder's force goes over to that of the next stage \[–\].
const RAMP: f64 = 0.2;
/// Longest path of a tool over the blank's length \[–\].
const FURTHEST: f64 = 3.0;

/// First stage, which the rest of the file describes.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FirstStage {
    /// Names its folder where there are several stages; "forming" when not given.
    pub name: Option<String>,
}

/// Further operation on the same sheet; omitted keys stay as in the stage before, but tools that moved stand still.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stage {
    /// Letters, digits, `-` and `_`: it names a folder.
    name: String,
    /// Punch that is new, moves or has another friction.
    punch: Option<Punch>,
    /// Die, likewise.
    die: Option<Die>,
    /// Holder, likewise, or with another force.
    holder: Option<Holder>,
    /// Pad, likewise.
    pad: Option<Pad>,
    /// Further tools that are new, move or have another force.
    #[serde(default)]
    further: Vec<Further>,
    /// Tools that are no longer there, by their names.
    #[serde(default)]
    remove: Vec<String>,
    /// Support of the outer edge.
    edge: Option<Edge>,
    /// Sets equivalent strain and stress back to nothing before the stage.
    #[serde(default)]
    anneal: bool,
    /// Turns the sheet over before the stage, as for a reverse redraw; every tool that is left is brought up to it.
    #[serde(default)]
    turn_over: bool,
    /// Cuts the sheet at this current distance from the axis or symmetry plane before the stage; whole elements go.
    trim: Option<Positive<Length>>,
    /// Diameter of the cut, instead of `trim`, of a round part.
    trim_diameter: Option<Positive<Length>>,
    /// Response to strain.
    pub mode: Option<Mode>,
    /// Takes the tools away: contact forces fade, and the sheet springs back. True or "updated", or "constant" stiffness.
    release: Option<Release>,
    /// Largest step as a fraction of the stage; that of `solver` when not given. A release bears 0.05.
    max_step: Option<Fraction>,
    /// Speed of the tool that goes furthest; that of the first stage when not given.
    speed: Option<Positive<Speed>>,
    /// Instead of the speed; 1 s where no tool goes anywhere and it is not given.
    duration: Option<Positive<Time>>,
    /// Number of equally spaced instants that are kept, 1 to 1000; 4 when not given.
    #[schemars(range(min = 1, max = 1000))]
    frames: Option<i64>,
}

/// Release of the tools: the stiffness of its iterations, or none.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(untagged, inline)]
pub enum Release {
    Switch(bool),
    Stiffness(ReleaseStiffness),
}

untagged!(
    [] Release, "true, false, \"updated\" or \"constant\"",
    switch(on) => Ok(Release::Switch(on)),
    text(name) => ReleaseStiffness::deserialize(name.into_deserializer()).map(Release::Stiffness)
);

impl Stage {
    pub fn release(&self) -> Option<ReleaseStiffness> {
        match self.release? {
            Release::Switch(on) => on.then_some(ReleaseStiffness::Updated),
            Release::Stiffness(stiffness) => Some(stiffness),
        }
    }
}

pub fn stages(file: &CaseFile, first: Model, source: &Source) -> Result<Vec<model::Stage>> {
    let name = file.stage.name.clone().unwrap_or_else(|| FIRST.to_owned());
    check_name(&name, "stage.name", source)?;
    let mut stages = vec![model::Stage { name, model: first, begin: Beginning::default() }];
    let (mut frictions, press) = (Frictions::new(file), file.press_drive(source)?);
    for (i, written) in file.stages.iter().enumerate() {
        let path = format!("stages.{i}");
        check_name(&written.name, &format!("{path}.name"), source)?;
        let what = format!("two stages are called `{}`", written.name);
        let is_new = stages.iter().all(|other| other.name != written.name);
        source.require(is_new, &format!("{path}.name"), what, "name them apart: each has its own folder")?;
        source.enter_stage(Some((i, &written.name)));
        let (first, before) = (&stages[0].model, &stages[i].model);
        let Stage { punch, die, holder, pad, further, .. } = written.clone();
        let tools = Tools { punch, die, holder, pad, further, beads: Vec::new() };
        Role::ALL.into_iter().for_each(|role| {
            if written.remove.iter().any(|name| name == role.name()) {
                frictions.tools[role.index()] = None;
            }
        });
        tools.keys().for_each(|tool| frictions.add(&tool));
        let (tools, frictions, press) = (&tools, &frictions, press.as_ref());
        stages.push(StageContext { written, tools, frictions, press, before, first, source, path }.stage()?);
    }
    source.enter_stage(None);
    Ok(stages)
}

fn check_name(name: &str, path: &str, source: &Source) -> Result<()> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let ok = (1..=LONGEST).contains(&name.len()) && name.chars().all(plain);
    let help = format!("at most {LONGEST} letters, digits, - and _, such as \"redraw\"");
    source.require(ok, path, format!("a stage cannot be called \"{name}\": it names a folder"), help)
}

/// Move of a tool away from the axis and along z \[mm\].
fn path_of(tool: &ToolKeys) -> Option<Point> {
    let [aside, axial] = tool.moves.map(|length| length.map_or(0.0, Length::value));
    tool.moves.iter().any(Option::is_some).then(|| Point::new(aside, axial))
}

struct StageContext<'a> {
    written: &'a Stage,
    tools: &'a Tools,
    /// Those of the stages before, and this one's.
    frictions: &'a Frictions<'a>,
    press: Option<&'a crate::press::Drive>,
    before: &'a Model,
    first: &'a Model,
    source: &'a Source<'a>,
    path: String,
}

impl StageContext<'_> {
    fn require(&self, ok: bool, key: &str, what: impl Into<String>, help: &str) -> Result<()> {
        self.source.require(ok, &format!("{}.{key}", self.path), what, help)
    }

    fn stage(&self) -> Result<model::Stage> {
        if !self.before.gas.is_empty() {
            self.source.note("pressure acts in the first stage only");
        }
        let mut model = self.at_rest();
        for (k, name) in self.written.remove.iter().enumerate() {
            let names = |tool: &model::Tool| [tool.role.name(), model.name_of(tool.role)];
            let removed = model.tools.iter().position(|tool| names(tool).contains(&name.as_str()));
            let what = format!("there is no {name} to remove");
            self.require(removed.is_some(), &format!("remove.{k}"), what, "drop it")?;
            removed.map(|at| model.tools.remove(at));
        }
        self.pace(&mut model)?;
        let max_step = self.written.max_step.map_or(self.first.settings.max_step, Fraction::value);
        model.settings.max_step = max_step;
        check_settings(&model.settings, self.source)?;
        let mut meets = Vec::new();
        for tool in self.tools.keys() {
            self.tool(&tool, &mut model)?;
            meets.extend(tool.is_shaped.then_some(tool.role));
        }
        meets.extend(further::changed(self.tools, &self.path, (self.frictions, self.source), &mut model)?);
        self.press(&mut model, &mut meets)?;
        self.release(&mut model)?;
        model.blank.edge = self.written.edge.unwrap_or(model.blank.edge);
        let frames_key = format!("{}.frames", self.path);
        let frames = count(self.source, &frames_key, self.written.frames.unwrap_or(4), 1..=1000)?;
        model.frames = equally_spaced(model.duration, frames);
        let Stage { turn_over, anneal, .. } = *self.written;
        meets.extend(model.tools.iter().map(|tool| tool.role).filter(|_| turn_over));
        let begin = Beginning { turn_over, anneal, trim: self.trim()?, meets };
        let pressed = model.tool(Role::Holder).is_some_and(|holder| matches!(holder.motion, Motion::Pressed(_)));
        let help = "remove the holder too, or let it stand still or go back with `move`";
        let what = "the holder has no die to press against";
        self.require(!pressed || model.tool(Role::Die).is_some(), "remove", what, help)?;
        let key = if self.written.remove.is_empty() { "name" } else { "remove" };
        let help = "write `release = true` instead: the contact forces fade, and the sheet springs back";
        let held = !model.tools.is_empty() || model.release.is_some();
        self.require(held, key, "no tool is left, and nothing holds the sheet", help)?;
        drive::of_model(&model, &frames_key, self.source)?;
        Ok(model::Stage { name: self.written.name.clone(), model, begin })
    }

    fn at_rest(&self) -> Model {
        let StopRules { localised, drawn_through, .. } = self.first.stop;
        let stop = StopRules { localised, drawn_through, ..StopRules::default() };
        let mut model = Model { gas: Vec::new(), schedule: None, release: None, stop, ..self.before.clone() };
        let last = |force: &PiecewiseLinear| force.at(self.before.travel).into();
        model.beads.iter_mut().for_each(|bead| bead.restraining = last(&bead.restraining));
        for tool in &mut model.tools {
            match &mut tool.motion {
                Motion::Pressed(press) => press.force = last(&press.force),
                Motion::Gap(_) => {}
                motion => *motion = Motion::Fixed,
            }
        }
        model
    }

    fn pace(&self, model: &mut Model) -> Result<()> {
        let moves = self.tools.keys().filter_map(|tool| Some((path_of(&tool)?, tool.role)));
        let further = self.written.further.iter().filter_map(|tool| Some((tool.moved?.value().abs(), Role::Punch)));
        let moves = moves.map(|(path, role)| (path.y.hypot(path.x), role)).chain(further);
        let (travel, furthest) = moves.fold((0.0, Role::Punch), |most, next| if next.0 > most.0 { next } else { most });
        let length = self.first.blank.length;
        let (path, blank) = (rounded(travel), rounded(length));
        let what = format!("a move of {path} mm is more than {FURTHEST} times the blank's {blank} mm");
        self.require(travel <= FURTHEST * length, furthest.name(), what, "check the unit")?;
        self.source.one_of(&self.path, &["speed", "duration"], "keep one")?;
        let speed = self.written.speed.map(Dimensioned::value);
        let duration = self.written.duration.map(Dimensioned::value);
        let help = "write duration = \"1 s\", or let a tool `move`";
        self.require(speed.is_none() || travel > 0.0, "speed", "a speed is given, and no tool moves", help)?;
        let usual = self.first.speed;
        (model.duration, model.speed) = match duration {
            _ if travel == 0.0 => (duration.unwrap_or(1.0), usual),
            Some(duration) => (duration, travel / duration),
            None => (travel / speed.unwrap_or(usual), speed.unwrap_or(usual)),
        };
        model.travel = travel;
        model.timed = self.first.timed || speed.is_some() || duration.is_some();
        let press = self.press.filter(|_| furthest == Role::Punch && travel > 0.0);
        let stroke = judged::stroke_of(press, travel, self.source)?;
        if let Some(schedule) = stroke.filter(|_| speed.is_none() && duration.is_none()) {
            let Drive { schedule, speed, duration, .. } = Drive::of(schedule);
            (model.schedule, model.speed, model.duration, model.timed) = (schedule, speed, duration, true);
        }
        Ok(())
    }

    fn tool(&self, written: &ToolKeys, model: &mut Model) -> Result<()> {
        let ToolKeys { role, is_shaped, .. } = *written;
        let back = path_of(written).map_or(0.0, |path| -path.y);
        let pad = self.tools.pad.as_ref().filter(|_| role == Role::Pad);
        let pad = pad.filter(|pad| pad.force.is_some() || pad.pressure.is_some() || pad.spring.is_some());
        let stray = ["travel", "speed", "motion", "pressure", "gap", "spring"];
        let (table, why) = (format!("{}.{}", self.path, role.name()), "is for tools of the first stage");
        let stray = if role == Role::Pad { &[][..] } else { &stray };
        self.source.refuse(&table, stray, why, "drop it: in a later stage `move` and `force` drive the tools")?;
        let what = format!("there is no {} in this stage", role.name());
        let help = "give it a shape as in [tools], or drop it";
        self.require(is_shaped || model.tool(role).is_some(), role.name(), what, help)?;
        let (extent, length) = (model.extent(), model.blank.length);
        if is_shaped {
            let (travel, written, source) = (model.travel, self.tools, self.source);
            let (standing, further, blank) = (&model.tools[..], &model.further[..], &model.blank);
            let profile =
                ToolContext { written, standing, further, blank, extent, travel, source }.new_profile(role)?;
            let friction = self.frictions.law(role, self.source)?;
            let is_new = self.before.tool(role).is_none_or(|tool| tool.profile != profile);
            let what = format!("the new punch moves away from the sheet by {} mm", rounded(back));
            let help = "write a positive `move`: the punch pushes the sheet along z; to take a punch away, `remove` it";
            self.require(role != Role::Punch || !is_new || back <= 0.0, "punch.move", what, help)?;
            model.tools.retain(|tool| tool.role != role);
            model.tools.push(Tool { role, profile, friction, motion: Motion::Fixed });
            model.tools.sort_by_key(|tool| tool.role);
        }
        for tool in model.tools.iter_mut().filter(|tool| tool.role == role) {
            if written.friction.is_some() && !is_shaped {
                tool.friction = self.frictions.law(role, self.source)?;
            }
            match (path_of(written), pad) {
                (Some(path), _) => tool.motion = Motion::Path(path),
                (None, Some(pad)) => tool.motion = pad.support(&tool.profile, length, extent, self.source)?,
                (None, None) => {}
            }
        }
        Ok(())
    }

    fn press(&self, model: &mut Model, meets: &mut Vec<Role>) -> Result<()> {
        let Some(holder) = &self.written.holder else { return Ok(()) };
        let Some(force) = holder.force_curve(self.before.extent(), self.source)? else { return Ok(()) };
        let moves = !self.source.written(&format!("{}.holder", self.path), &["move", "aside"]).is_empty();
        let help = "keep one: a holder that goes a given way has the force that this takes";
        self.require(!moves, "holder.force", "the holder has both a way to go and a force", help)?;
        let last = match self.before.tool(Role::Holder).map(|holder| &holder.motion) {
            Some(Motion::Pressed(press)) => Some(press.force.at(self.before.travel)),
            _ => None,
        };
        let stays = !meets.contains(&Role::Holder);
        let force = match (&holder.force, last) {
            (Some(History::Constant(_)), Some(last)) if stays && model.travel > 0.0 => {
                PiecewiseLinear::new(vec![(0.0, last), (RAMP * model.travel, force.at(0.0))]).unwrap_or(force)
            }
            _ => force,
        };
        if let Some(holder) = model.tools.iter_mut().find(|tool| tool.role == Role::Holder) {
            holder.motion = Motion::Pressed(Press { force, stiffness: 0.0 });
        }
        if stays && last.is_none() {
            meets.push(Role::Holder);
        }
        Ok(())
    }

    fn release(&self, model: &mut Model) -> Result<()> {
        model.release = self.written.release();
        let released = model.release.is_some();
        if let Some(tool) = self.tools.keys().find(|tool| released && path_of(tool).is_some()) {
            let help = "drop `move` and `aside`, or the release";
            self.require(false, tool.role.name(), "tools that are taken away cannot move as well", help)?;
        }
        if released {
            model.tools.iter_mut().for_each(|tool| tool.motion = Motion::Fixed);
            // A bead goes with the tools that it stands in.
            model.beads.clear();
        }
        let (mode, key) = match self.written.mode {
            None if released && self.before.mode == Mode::Flow => (Some(Mode::Elastic), "release"),
            mode => (mode, "mode"),
        };
        if let Some(mode) = mode {
            model.mode = checked_mode(mode, &self.before.material, &format!("{}.{key}", self.path), self.source)?;
        }
        let what = "the flow law has no elasticity, nothing springs back";
        let help = "drop it, or write \"elastic\" or \"elasto_viscoplastic\"";
        self.require(!released || mode != Some(Mode::Flow), "mode", what, help)
    }

    /// Distance of the cut from the axis or symmetry plane \[mm\].
    fn trim(&self) -> Result<Option<f64>> {
        let Stage { trim, trim_diameter, .. } = *self.written;
        if trim.or(trim_diameter).is_none() {
            return Ok(None);
        }
        let (keys, lengths) = (["trim", "trim_diameter", "trim"], [trim, trim_diameter, trim]);
        let (key, radius) = radius_of(self.source, &self.path, self.before.geometry, keys, lengths)?;
        let length = self.before.blank.length;
        let what = format!("trimming at {} mm cuts nothing from a blank of {} mm", rounded(radius), rounded(length));
        self.require(radius < length, key, what, "the cut is within the blank's edge")?;
        Ok(Some(radius))
    }
}
