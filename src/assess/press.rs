//! Press: force and energy against its ratings.

use super::*;
use crate::case::Press;
use crate::model::Gas;
use crate::table::JOULES;
use crate::units::DisplaySettings;

/// Share of a rating from which on little of it is left \[–\]: a declared rule of thumb.
const NEAR: f64 = 0.8;
/// Rating over the largest load \[–\]: a declared rule of thumb.
const RESERVE: f64 = 1.2;
/// Largest force of tools that move a sheet and do not form it, by rounding: declared \[N, or N/mm\].
const NOTHING: f64 = 1e-6;
/// Gap of tools that are pressed home over the thickness \[–\]: declared.
const HOME: f64 = 1.05;
/// Metric tonne-force \[N\].
const TONNE: f64 = 9806.65;

/// Largest load of a press: its ram bears the punch, or a pressure that opens the tools, and with it what presses the holder.
struct Load<'a> {
    stage: usize,
    on: &'a StageSolution,
    step: &'a StepRecord,
    /// Forces of all tools.
    forces: &'a [f64],
    /// True where the run ends as tools squeeze the sheet: their force has no bound.
    squeezes: bool,
}

impl<'a> Load<'a> {
    fn of(stage: usize, on: &'a StageSolution) -> impl Iterator<Item = Self> {
        let squeezes = on.stop.kind == StopKind::ToolsClosed;
        on.steps.iter().zip(&on.tool_forces).map(move |(step, forces)| Self { stage, on, step, forces, squeezes })
    }

    /// Largest over all stages, of forces over what the press permits at their travel; `None` if nothing presses.
    pub fn largest(stages: &'a [StageSolution], press: &Press) -> Option<Self> {
        let steps = formed(stages).flat_map(|(stage, on)| Self::of(stage, on));
        let share = |load: &Self| load.force() / press.permitted(load.left()).unwrap_or(1.0);
        steps.filter(|load| load.driven() > NOTHING).max_by(|a, b| share(a).total_cmp(&share(b)))
    }

    /// Force in the unit of the section.
    pub fn amount(&self, force: f64) -> Amount {
        Amount::force(force, self.on.model.extent().force_unit())
    }

    /// Travel left \[mm\].
    pub fn left(&self) -> f64 {
        self.on.model.travel - self.step.travel
    }

    /// Force of a holder that is pressed, with what its distance blocks bear and its beads take \[N, or N/mm\].
    pub fn holder(&self) -> f64 {
        match self.on.model.tool(Role::Holder).map(|holder| &holder.motion) {
            Some(Motion::Pressed(press)) => {
                let given = if self.on.model.beads.is_empty() { 0.0 } else { press.force.at(self.step.travel) };
                given.max(self.step.holder_force + self.step.block_force)
            }
            _ => 0.0,
        }
    }

    /// Force of the punch and of further tools that move up with it or by a path \[N, or N/mm\].
    fn driven(&self) -> f64 {
        let is_driven = |tool: &Tool| !matches!(tool.motion, Motion::Fixed | Motion::Pressed(_));
        let tools = self.on.model.tools.iter().zip(self.forces);
        let below = tools.filter(|(tool, _)| matches!(tool.role, Role::Lower(_)) && is_driven(tool));
        self.step.punch_force + below.map(|(_, force)| force).sum::<f64>() + self.closing() + self.thrust()
    }

    /// Force of the pressure on the seal of a fed tube \[N, or N/mm\].
    pub fn thrust(&self) -> f64 {
        self.on.model.thrust(self.step.pressure)
    }

    /// Force that holds tools without a punch closed on a flat sheet: the larger pressure over its seal's area \[N, or N/mm\].
    pub fn closing(&self) -> f64 {
        let model = &self.on.model;
        let given = |gas: &Gas| gas.pressure.prescribed(self.step.time);
        let known: f64 = model.gas.iter().filter_map(|gas| Some(gas.face.sign() * given(gas)?)).sum();
        let force = |g: &Gas| given(g).unwrap_or((self.step.pressure - known).abs()) * model.extent().area(g.within);
        let is_held = model.travel == 0.0 && model.blank.meridian.is_none();
        model.gas.iter().filter(|_| is_held).map(force).fold(0.0, f64::max)
    }

    /// Force of these and of the holder at the same instant \[N, or N/mm\].
    pub fn force(&self) -> f64 {
        self.driven() + self.holder()
    }

    /// Least rating of a press for it and its error bar, rounded up: `67 kN (6.8 t)`.
    pub fn rating(&self, bar: f64) -> String {
        // Up to the upper end of the bar as it is printed.
        let bar = if bar > 0.0 { rounded_up(bar, 1 + i32::from(format!("{bar:e}").starts_with('1'))) } else { 0.0 };
        with_tonnes(self.amount(rounded_up((1.0 - 1e-10) * f64::max(RESERVE * self.force(), self.force() + bar), 2)))
    }
}

/// Force on the ram at each step, the holder's with it \[N, or N/mm\].
pub fn on_ram(stage: &StageSolution) -> Vec<f64> {
    Load::of(0, stage).map(|load| load.force()).collect()
}

type Peak<'a> = Option<(usize, &'a StepRecord, f64)>;

fn largest(stages: &[StageSolution], values: fn(&StageSolution) -> Vec<f64>) -> Peak<'_> {
    let steps = formed(stages).flat_map(|(i, on)| on.steps.iter().zip(values(on)).map(move |(s, v)| (i, s, v)));
    steps.max_by(|a, b| a.2.total_cmp(&b.2)).filter(|(.., value)| *value > NOTHING)
}

/// Largest force of the tools that [work](StageSolution::working_force).
pub fn largest_force(stages: &[StageSolution]) -> Peak<'_> {
    largest(stages, StageSolution::working_force)
}

/// Largest force over all stages and the press for it with its error bar \[N, or N/mm\], or largest pressure if no punch moves.
pub(super) fn load(case: &Case, stages: &[StageSolution], bar: f64) -> Option<Quantity> {
    let stage = |i: usize| if formed(stages).count() > 1 { format!("in stage {}", i + 1) } else { String::new() };
    let Some((i, peak, force)) = largest_force(stages) else {
        let pressures = |on: &StageSolution| on.steps.iter().map(|step| step.pressure.abs()).collect();
        let (i, peak, pressure) = largest(stages, pressures)?;
        let at = format!("at a height of {}", Amount::place(peak.pole_height.abs()));
        let at = if stages[i].model.blank.is_open() { "at its largest".into() } else { at };
        let pressure = Quantity::new("pressure", "Pressure", Amount::stress(pressure));
        return Some(pressure.at(joined([stage(i), at], ", ")));
    };
    let pressed = Load::largest(stages, &case.press)?;
    let of_seal = |thrust: f64| format!("{} of it the pressure's on the seal", pressed.amount(thrust));
    let seal = Some(pressed.thrust()).filter(|thrust| *thrust > 0.0).map(of_seal).unwrap_or_default();
    let of = |on: &StageSolution| match on.model.worker() {
        role @ (Role::Upper(_) | Role::Lower(_)) => format!("of the {}", on.model.name_of(role)),
        _ => String::new(),
    };
    let at = format!("at {}", instant(&stages[i], peak.travel, peak.time));
    let at = joined([of(&stages[i]), stage(i), at, seal], ", ");
    let others = formed(stages).filter(|(other, _)| *other != i).filter_map(|(other, on)| {
        let force = Some(on.working_force().into_iter().fold(0.0, f64::max)).filter(|force| *force > 0.0)?;
        Some(joined([format!("{} in stage {}", pressed.amount(force), other + 1), of(on)], " "))
    });
    let model = &stages[i].model;
    let is_home = |gap: &f64| *gap < HOME * model.blank.thickness && 2.0 * bar > force;
    let gap = estimate::clearance(model, model.travel).filter(is_home);
    let home = gap.map_or("", |_| "the gap of the closed tools decides it").to_owned();
    let about = joined([at, joined(others, ", "), home, press(case, &pressed, bar)], "; ");
    Some(Quantity::new("punch_force", model.force_label(), pressed.amount(force)).at(about))
}

/// Share of the press's rating, or press for a load and its error bar \[N, or N/mm\].
fn press(case: &Case, load: &Load, bar: f64) -> String {
    let with_holder = if load.holder() > 0.0 { " with the holder" } else { "" };
    let feed = if load.thrust() > 0.0 { " for the feed of one end alone" } else { "" };
    if load.squeezes {
        return "no press is given: the tools squeeze the sheet".into();
    }
    let error = if bar > (RESERVE - 1.0) * load.force() { ", or the load and its error bar" } else { "" };
    let Some(rating) = case.press.permitted(load.left()) else {
        let rating = load.rating(bar);
        return format!("press of at least {rating}{with_holder}{feed} ({RESERVE} × the load{error}, rounded up)");
    };
    let (share, rating) = (Amount::share(load.force() / rating), load.amount(rating));
    match &case.press.drive {
        Some(_) => format!("{share} of the {} that the drive permits{with_holder}", with_tonnes(rating)),
        None => format!("{share} of the press's {}{with_holder}", with_tonnes(rating.to(Digits::Given(3)))),
    }
}

/// Force that holds tools closed against a pressure: of a die that is split along a tube, by the section inside of both halves.
pub(super) fn closing(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    if let Some(tube) = stages.last().filter(|on| on.model.is_half_tube() && on.model.tool(Role::Die).is_some()) {
        let section = |pair: &[NodeRecord]| (pair[0].r + pair[1].r - pair[1].thickness) * (pair[0].z - pair[1].z).abs();
        let section: f64 = tube.frames.last()?.nodes.windows(2).map(section).sum();
        let force = Amount::force(2.0 * section * super::largest(tube, |step| step.pressure), Unit::N);
        let about = "of a die split along the axis: largest pressure times section inside both halves, an estimate";
        return Some(Quantity::new("closing_force", "Closing force", force.to(Digits::Significant(3))).at(about));
    }
    let load = Load::largest(stages, &case.press).filter(|load| load.closing() > 0.0)?;
    Some(Quantity::new("closing_force", "Closing force", load.amount(load.force())).at(press(case, &load, 0.0)))
}

pub(super) fn pad(stage: &StageSolution) -> Option<Quantity> {
    let unit = stage.model.tool(Role::Pad).map(|_| stage.model.extent().force_unit())?;
    let force = Amount::force(super::largest(stage, |step| step.pad_force), unit);
    Some(Quantity::new("pad_force", "Pad", force.to(Digits::Significant(3))).at("at its largest, against the punch"))
}

pub(super) fn clamp(stage: &StageSolution) -> Option<Quantity> {
    let pull = Some(super::largest(stage, |step| step.edge_force)).filter(|pull| *pull > 0.0)?;
    let pull = Amount::force(pull, stage.model.extent().force_unit()).to(Digits::Significant(3));
    let about = worded(stage.model.geometry, "pull on the held edge, all round", "pull on both held edges");
    Some(Quantity::new("clamp_force", "Clamp", pull).at(format!("{about}, at its largest")))
}

pub(super) fn further(stages: &[StageSolution]) -> Option<Quantity> {
    let model = &stages.last()?.model;
    let amount = |force: f64| Amount::force(force, model.extent().force_unit()).to(Digits::Significant(3));
    let largest = |name: &String| {
        let peaks = stages.iter().flat_map(StageSolution::further_peaks).filter(|(_, other, _)| other == name);
        amount(peaks.map(|(.., peak)| peak).fold(0.0, f64::max))
    };
    let (first, others) = model.further.split_first()?;
    let others = others.iter().map(|name| format!("{name} {}", largest(name)));
    let about = joined(["at its largest".to_owned()].into_iter().chain(others), "; ");
    let force = Quantity::new("further_force", "Further tool", largest(first)).at(about);
    Some(Quantity { name: Some(crate::units::capitalised(first)), ..force })
}

/// Force as the data sheet of a press has it, in metric tonnes-force too: `812 kN (83 t)`.
fn with_tonnes(force: Amount) -> String {
    // A rating in tonnes has many digits in kN.
    let force = force.with_value(significant(force.value, 4));
    match force.unit {
        Unit::N if DisplaySettings::current() == DisplaySettings::Si => {
            format!("{force} ({} t)", Amount::new(force.value / TONNE, Unit::None, Digits::Significant(2)))
        }
        _ => force.to_string(),
    }
}

/// Drive without a force to permit, or a motion that it gives the punch.
pub(super) fn no_force(case: &Case) -> Option<Finding> {
    case.press.drive.as_ref().filter(|drive| drive.pace.is_none() && case.press.force.is_none())?;
    let text = "[press.drive] has no force to permit and no motion: it changes nothing";
    let warning = Finding::warning("press_drive", "Press drive", text).limit("a force beside it").source("[press]");
    Some(warning.advice("give the nominal force, [press] force, or its strokes_per_minute, or drop it"))
}

pub(super) fn force(run: &Run) -> Option<Finding> {
    let press = &run.case.press;
    let load = Load::largest(run.stages, press)?;
    let permitted = press.permitted(load.left());
    let amount = |force| load.amount(force);
    let instant = match load.closing() {
        0.0 => instant(load.on, load.step.travel, load.step.time),
        _ => Amount::stress(load.step.pressure.abs()).to_string(),
    };
    let at = format!("{{}}{} at {instant}", per_depth(amount(0.0)));
    let parts = [(load.holder(), "the holder's"), (load.thrust(), "the pressure's on the seal")];
    let parts = parts.into_iter().filter(|(force, _)| *force > 0.0);
    let parts = joined(parts.map(|(force, of)| format!("{} of it {of}", amount(force))), ", ");
    let angle = press.drive.as_ref().map_or_else(String::new, |drive| {
        format!(", {} before the bottom dead centre", Amount::angle(drive.degrees(load.left())))
    });
    let at = joined([at + &angle, at_event(load.on, load.step)], " ");
    let text = run.of_stage(joined([at, parts], ": "), load.stage);
    let finding = rated(Finding::judged("press_force", "Press force", text), amount(load.force()), permitted);
    Some(match permitted.filter(|_| press.drive.is_some()) {
        _ if load.squeezes => finding.light(Light::Grey).limit("none while the tools squeeze the sheet").advice(""),
        Some(force) => finding.limit(format!("{} there, by the torque of the drive", with_tonnes(amount(force)))),
        None => finding,
    })
}

pub(super) fn energy(run: &Run) -> Option<Finding> {
    let work = |step: &StepRecord| (JOULES * step.work.external, ());
    let forms = |stage: &StageSolution| stage.model.release.is_none() && stage.model.travel > 0.0;
    let (i, work, ()) = run.peak(|_, stage| stage.steps.last().filter(|_| forms(stage)).map(work))?;
    let work = Amount::force(work, run.stages.first()?.model.extent().energy_unit());
    let rating = run.case.press.energy.map(|energy| JOULES * energy);
    let share = rating
        .map_or(String::new(), |rating| format!(", {} of what a stroke gives", Amount::share(work.value / rating)));
    let text = run.of_stage(format!("{{}}{}{share}", per_depth(work)), i);
    Some(rated(Finding::judged("energy", "Energy", text), work, rating))
}

fn per_depth(load: Amount) -> &'static str {
    if matches!(load.unit, Unit::N | Unit::Joule) { "" } else { " of depth" }
}

fn rated(judged: Finding, load: Amount, rating: Option<f64>) -> Finding {
    let (judged, depth) = (judged.number(load).source("the press's data sheet"), per_depth(load));
    let Some(rating) = rating else {
        let depth = if depth.is_empty() { "" } else { "blank.depth, and " };
        let advice = format!("give {depth}`[press]` force and energy: the ratings on its data sheet");
        return judged.light(Light::Grey).limit("the press's rating, not in the case").advice(advice);
    };
    let rated = with_tonnes(load.with_value(rating).to(Digits::Given(3)));
    judged.at_most(NEAR * rating, rating).limit(format!("{rated}{depth}"))
}
