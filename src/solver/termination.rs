//! Rules that end a run before its full travel.
//!
//! Each rule gives a state's excess over it as a number that is continuous in time; its root is the instant of the end.

use super::{no_equilibrium::reached, *};
use crate::forming_limit::Onset;
use crate::solver::solution::neck::{Neck, neck};
use crate::units::Amount;

/// Thickness left at which the sheet has failed, whatever its surroundings do \[–\].
const GONE: f64 = 0.2;
/// Share of its maximum by which the load has fallen at a neck that goes on past it \[–\]: a declared rule of thumb.
const FALLEN: f64 = 0.02;
/// Share of the run for which a neck must last \[–\].
const LASTING: f64 = 0.01;
/// Distance of the rim behind the shoulder's end when the cup is through the die, over the initial thickness \[–\].
const THROUGH: f64 = 1.0;
/// Round-off of lengths over the thickness \[–\].
const ROUND_OFF: f64 = 1e-6;
/// Distance of two rigid tools over the initial thickness at which the run ends \[–\], sooner where a further tool squeezes it.
const CLOSED: f64 = 0.5;
const SQUEEZED: f64 = 0.9;

#[derive(Clone)]
struct Throat {
    die: usize,
    /// Least radius of the die \[mm\].
    radius: f64,
    /// Lowest height of the die as drawn, and of its throat, where the shoulder ends \[mm\].
    face: f64,
    end: f64,
}

#[derive(Clone, Default)]
pub(super) struct Termination {
    /// Time since which a neck has taken over \[s\].
    necking_since: Option<f64>,
    /// Time since which a place thins faster than at the load maximum, though the load has fallen \[s\].
    fading_since: Option<f64>,
    /// Largest punch force \[N, or N/mm\], and the thinning rate of the thinnest place then \[1/s\].
    peak: f64,
    rate_at_peak: f64,
    throat: Option<Throat>,
    /// Travel at which two tools close, their closest place \[mm\], and which tools they are.
    pub closed: Option<(f64, Point, [usize; 2])>,
    neck: Option<Neck>,
    /// Largest excess of the last state over a rule \[–\]; negative while the run goes on.
    pub excess: f64,
}

impl Termination {
    pub fn new(model: &Model, state: &State) -> Self {
        let edge = state.nodes[state.nodes.len() - 1][0];
        let throat = model.tool_index(Role::Die).map(|die| {
            let profile = &model.tools[die].profile;
            let (points, radius) = (profile.polyline(0.01), profile.least_r());
            let lowest = |r: f64| points.iter().filter(|p| p.x <= r).map(|p| p.y).fold(f64::INFINITY, f64::min);
            Throat { die, radius, face: lowest(f64::INFINITY), end: lowest(radius + ROUND_OFF * model.blank.thickness) }
        });
        let throat = throat.filter(|throat| model.blank.edge == Edge::Free && edge > throat.radius);
        Self { throat, closed: closed(model, state), excess: -1.0, ..Self::default() }
    }

    /// End of a run whose steps fail while a neck takes over.
    pub fn necking(&self, model: &Model, state: &State) -> Option<Stop> {
        let neck = neck(model, state, None);
        (model.stop.localised && self.necking_since.is_some()).then(|| localised(model, state, &neck))
    }

    pub fn after(&self, model: &Model, before: &State, state: &State, record: &StepRecord) -> Self {
        let mut now = Self { peak: self.peak.max(record.punch_force), ..self.clone() };
        if model.release.is_none() {
            let neck = neck(model, state, Some(before));
            let since = |holds: bool, before: Option<f64>| holds.then(|| before.unwrap_or(state.time));
            now.necking_since = since(neck.took_over, self.necking_since);
            if record.punch_force >= now.peak {
                now.rate_at_peak = neck.rate;
            }
            let fades = record.punch_force < (1.0 - FALLEN) * now.peak && neck.rate > now.rate_at_peak.max(0.0);
            now.fading_since = since(fades, self.fading_since);
            now.neck = Some(neck);
            now.excess = now.excesses(model, state, record).into_iter().map(|(excess, _)| excess).fold(-1.0, f64::max);
        }
        now
    }

    /// Excess of the time for which a neck has lasted \[–\].
    fn lasted(since: Option<f64>, model: &Model, state: &State) -> f64 {
        let lasted = since.map_or(0.0, |since| model.process_time(since, state.time - since));
        lasted / (LASTING * model.duration) - 1.0
    }

    /// Neck that has taken over, or goes on past the load maximum, and has lasted, also where the run goes on.
    pub fn necked(&self, model: &Model, state: &State) -> Option<Onset> {
        let lasts = |since| Self::lasted(since, model, state) >= 0.0;
        let neck = self.neck.filter(|_| lasts(self.necking_since) || lasts(self.fading_since))?;
        Some(Onset { s0: neck.s0, time: state.time, travel: state.travel })
    }

    /// Excess of the state over each rule in the order of precedence \[–\]; NaN where the rule does not apply.
    fn excesses(&self, model: &Model, state: &State, record: &StepRecord) -> [(f64, StopKind); 8] {
        let beyond = |value: f64, limit: Option<f64>| limit.map_or(f64::NAN, |limit| value / limit - 1.0);
        let through = self.throat.as_ref().map_or(f64::NAN, |throat| {
            let [r, z, _] = state.nodes[state.nodes.len() - 1];
            let (within, height) = (throat.radius - r, z - state.tools[throat.die].y);
            let beyond = match model.stop.drawn_through {
                true => height - throat.end - THROUGH * model.blank.thickness,
                false => height - throat.face,
            };
            within.min(beyond) / model.blank.thickness
        });
        let lasted = Self::lasted(self.necking_since, model, state);
        let neck = self.neck.filter(|_| model.stop.localised);
        let edge_limit = model.blank.edge_limit.filter(|_| model.stop.edge_limit).map(|limit| limit.expansion);
        let drop = model.stop.load_drop.filter(|_| self.peak > 0.0);
        [
            (beyond(state.travel, self.closed.map(|(limit, ..)| limit * (1.0 - 1e-12))), StopKind::ToolsClosed),
            (through, if model.stop.drawn_through { StopKind::LeftDie } else { StopKind::DrawnThrough }),
            (beyond(record.porosity, model.material.gtn.map(|voids| voids.fracture())), StopKind::Coalesced),
            (beyond(record.edge_expansion(&model.blank), edge_limit), StopKind::EdgeLimit),
            (beyond(record.contact_share, model.stop.contact_share), StopKind::ContactShare),
            (beyond(1.0 - record.punch_force / self.peak, drop), StopKind::LoadMaximum),
            (neck.map_or(f64::NAN, |neck| lasted.max(1.0 - neck.share / GONE)), StopKind::Localised),
            (beyond(record.holder_force, model.stop.holder_force), StopKind::HolderClosed),
        ]
    }

    /// Reason why the run ends with `state`; `None` if it goes on.
    pub fn stop(&self, model: &Model, state: &State, record: &StepRecord) -> Option<Stop> {
        if self.excess < 0.0 {
            return None;
        }
        let (_, kind) = self.excesses(model, state, record).into_iter().find(|(excess, _)| *excess >= 0.0)?;
        let [travel, hole] = [state.travel, record.hole].map(Amount::place);
        let at = format!("at {travel} of travel");
        let text = match kind {
            StopKind::ToolsClosed => {
                let (travel, place, pair) = self.closed?;
                let [travel, r, z] = [travel, place.x, place.y].map(Amount::place);
                let [name, other] = pair.map(|k| model.name_of(model.tools[k].role));
                let apart = Amount::share(ends_at(model, pair));
                format!(
                    "tools closed: at {travel} of travel {name} and {other} are {apart} of the sheet's thickness apart and \
                     close further, near r = {r}, z = {z}"
                )
            }
            StopKind::LeftDie => {
                format!("drawn through: {at} the rim has left the shoulder: strip it off the punch")
            }
            StopKind::DrawnThrough => format!("drawn through: the blank's edge has passed the die's throat {at}"),
            StopKind::Coalesced => {
                let (s0, voids) = (Amount::place(record.porous_s0), Amount::share(record.porosity));
                let text = format!("voids grown together {at}: the sheet tears at s0 = {s0}, with {voids} of voids");
                return Some(Stop::at(kind, record.porous_s0, text));
            }
            StopKind::EdgeLimit => format!("edge cracked: at {travel} the hole is Ø {hole}, its limit"),
            StopKind::ContactShare => {
                let (share, limit) = (Amount::share(record.contact_share), model.stop.contact_share?);
                let (at, limit) = (reached(state), Amount::given_share(limit));
                format!("contact share reached: at {at} {share} of the sheet lies on its tools ({limit} asked for)")
            }
            StopKind::LoadMaximum => {
                let drop = Amount::share(1.0 - record.punch_force / self.peak);
                let peak = Amount::force(self.peak, model.extent().force_unit());
                format!("load maximum passed: {at} the load is {drop} below its peak of {peak}")
            }
            StopKind::Localised => return Some(localised(model, state, &self.neck?)),
            _ => format!("holder closed: it has reached its force after {travel}"),
        };
        Some(Stop::new(kind, text))
    }
}

fn localised(model: &Model, state: &State, neck: &Neck) -> Stop {
    let i = state.s0.partition_point(|&s| s < neck.s0).min(state.nodes.len() - 1);
    let closest = (0..model.tools.len()).map(|j| (model.tools[j].role, state.gap(model, j, i)));
    let place = match closest.min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((role, distance)) if distance < 0.5 * model.blank.thickness => format!("on the {}", model.name_of(role)),
        _ => "where no tool supports it".into(),
    };
    let (s0, left) = (Amount::place(neck.s0), Amount::share(neck.share));
    let pressure = model.gas.iter().find_map(|gas| gas.pressure.prescribed(state.time)).map(Amount::stress);
    let at = pressure.filter(|_| state.travel == 0.0).map_or_else(|| reached(state), |pressure| pressure.to_string());
    let less = if model.tool(Role::Holder).is_some() { "Less holder force or friction" } else { "Less friction" };
    let text = format!(
        "ended at {at} by a neck at s0 = {s0}, where {left} of its thickness is left; {place}, one place takes \
         all the stretching while the sheet beside it has stopped. {less}, or a larger radius there, \
         lets it go deeper"
    );
    Stop::at(StopKind::Localised, neck.s0, text)
}

/// Travel at which punch and die, or a further tool and a led one, first come within [`CLOSED`] thicknesses of each other on
/// opposite faces of the sheet, and their closest place.
fn closed(model: &Model, state: &State) -> Option<(f64, Point, [usize; 2])> {
    let tools = || model.tools.iter().enumerate().filter(|(_, tool)| !matches!(tool.motion, Motion::Pressed(_)));
    let meets = |a: &Tool, b: &Tool| match [a.role, b.role] {
        [Role::Punch, Role::Die] => true,
        roles => roles[0].side() != roles[1].side() && roles.iter().any(|role| role.further().is_some()),
    };
    let later = |(i, a)| tools().filter(move |(j, b)| *j > i && meets(a, b)).map(move |(j, _)| [i, j]);
    tools().flat_map(later).filter_map(|pair| closes(model, state, pair)).min_by(|a, b| a.0.total_cmp(&b.0))
}

fn ends_at(model: &Model, pair: [usize; 2]) -> f64 {
    if pair.iter().any(|k| model.tools[*k].role.further().is_some()) { SQUEEZED } else { CLOSED }
}

fn closes(model: &Model, state: &State, pair @ [i, j]: [usize; 2]) -> Option<(f64, Point, [usize; 2])> {
    // Without the waiting gap.
    let moved = |k: usize, travel: f64| {
        let tool = &model.tools[k];
        state.tools[k] - Point::new(0.0, waiting_displacement(model, tool))
            + tool.motion.displacement(travel, model.travel)
    };
    let [a, b] = pair.map(|k| &model.tools[k].profile);
    let apart = |travel: f64| a.distance_to(b, moved(i, travel) - moved(j, travel));
    // Coarse search first: most punches never come close.
    let end = ends_at(model, pair) * model.blank.thickness;
    const LOOKS: usize = 8;
    let travel_of = |k: usize| model.travel * k as f64 / LOOKS as f64;
    let nears = |k: usize| apart(travel_of(k)).0 < apart(travel_of(k - 1)).0;
    let hit = (1..=LOOKS).find(|&k| apart(travel_of(k)).0 < CLOSED * model.blank.thickness && nears(k))?;
    let is_closed = |travel: f64| apart(travel).0 < end;
    let [_, high] = bisect(travel_of(hit - 1), travel_of(hit), 40, |travel| !is_closed(travel));
    (high < model.travel).then(|| (high, apart(high).1, pair))
}
