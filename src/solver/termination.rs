//! Why a run ends before its full travel, other than for want of equilibrium: what the sheet or the tools say.

use crate::geometry::Point;
use crate::model::{Edge, Model, Motion, Role};
use crate::numerics::bisect;
use crate::solution::neck::{AWAY, NEAR, Neck, neck};
use crate::solution::{StepRecord, Stop};
use crate::state::{State, waiting_displacement};

/// Thickness left at which the sheet has gone, whatever its surroundings do \[–\].
const GONE: f64 = 0.2;
/// Share of the run over which a neck must have kept its lead \[–\].
const LASTING: f64 = 0.01;
/// Distance of two rigid tools over the initial thickness at which the run ends \[–\].
const CLOSED: f64 = 0.5;

/// What a free edge may be drawn through.
struct Throat {
    /// Which of the model's tools the die is.
    die: usize,
    /// Least distance of the die from the axis, and its lowest place as drawn \[mm\].
    radius: f64,
    face: f64,
}

/// Looks at every accepted step for what ends the run.
pub(super) struct Termination {
    /// Time since which one place has taken over \[s\].
    necking_since: Option<f64>,
    peak: f64,
    throat: Option<Throat>,
    /// Travel at which punch and die are closed, and where \[mm\].
    closed: Option<(f64, Point)>,
}

impl Termination {
    /// At the start of a run from `state`.
    pub fn new(model: &Model, state: &State) -> Self {
        let edge = state.nodes[state.nodes.len() - 1][0];
        let drawn_in = |throat: &Throat| model.blank.edge == Edge::Free && edge > throat.radius;
        let die = model.tools.iter().position(|tool| tool.role == Role::Die);
        let throat = die.map(|die| {
            let profile = &model.tools[die].profile;
            let face = profile.polyline(0.01).iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
            Throat { die, radius: profile.least_r(), face }
        });
        let throat = throat.filter(drawn_in);
        Self { necking_since: None, peak: 0.0, throat, closed: closed(model, state) }
    }

    /// Time at which punch and die are closed \[s\], where they ever are.
    pub fn closes_at(&self, model: &Model) -> Option<f64> {
        self.closed.map(|(travel, _)| model.time_at(travel))
    }

    /// The end of a run whose steps fail while one place takes over: shorter steps would only follow it further.
    pub fn necking(&self, model: &Model, state: &State) -> Option<Stop> {
        let neck = neck(model, state, None);
        (model.stop.localised && self.necking_since.is_some()).then(|| localised(model, state, &neck))
    }

    /// Whether the run ends after the step that led from `before` to `state`.
    pub fn look(&mut self, model: &Model, before: &State, state: &State, record: &StepRecord) -> Option<Stop> {
        if model.release.is_some() {
            return None;
        }
        let travel = state.travel;
        if let Some((limit, at)) = self.closed.filter(|(limit, _)| travel >= limit * (1.0 - 1e-12)) {
            return Some(Stop::ToolsClosed { travel: limit, r: at.x, z: at.y });
        }
        // A free leg that has swung down below the die's face stands within the throat too, and has yet to pass it.
        let [r, z, _] = state.nodes[state.nodes.len() - 1];
        let inside = |throat: &Throat| r <= throat.radius && z - state.tools[throat.die].y > throat.face;
        if self.throat.as_ref().is_some_and(inside) {
            return Some(Stop::DrawnThrough { travel });
        }
        let gone = model.material.gtn.is_some_and(|voids| record.porosity >= voids.fracture());
        if gone {
            return Some(Stop::Coalesced { travel, s0: record.porous_s0, porosity: record.porosity });
        }
        if let Some(asked) = model.stop.contact_share.filter(|asked| record.contact_share >= *asked) {
            return Some(Stop::ContactShare { share: record.contact_share, asked, time: state.time, travel });
        }
        self.peak = self.peak.max(record.punch_force);
        let drop = 1.0 - record.punch_force / self.peak;
        if self.peak > 0.0 && model.stop.load_drop.is_some_and(|limit| drop >= limit) {
            return Some(Stop::LoadMaximum { travel, peak: self.peak, drop });
        }
        let neck = neck(model, state, Some(before));
        self.necking_since = if neck.took_over { self.necking_since.or(Some(state.time)) } else { None };
        let lasted = self
            .necking_since
            .is_some_and(|since| model.process_time(since, state.time - since) >= LASTING * model.duration);
        (model.stop.localised && (lasted || neck.share < GONE)).then(|| localised(model, state, &neck))
    }
}

fn localised(model: &Model, state: &State, neck: &Neck) -> Stop {
    Stop::Localised { travel: state.travel, s0: neck.s0, share: neck.share, why: why(model, state, neck) }
}

/// Where a neck sits, and what made it.
fn why(model: &Model, state: &State, neck: &Neck) -> String {
    let i = state.s0.partition_point(|&s| s < neck.s0).min(state.nodes.len() - 1);
    let closest = model.tools.iter().enumerate().map(|(j, tool)| {
        let distance = tool.profile.closest(state.in_frame_of(j, i)).distance - 0.5 * state.thickness_at(i);
        (tool.role, distance)
    });
    let place = match closest.min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((role, distance)) if distance < 0.5 * model.blank.thickness => format!("on the {}", role.name()),
        _ => "where no tool supports it".into(),
    };
    format!(
        "{place}, one place takes all the stretching while the sheet {NEAR} to {AWAY} thicknesses away has stopped: hardening \
         no longer makes up for thinning. Less holder force or friction, or a larger radius there, lets it go deeper"
    )
}

/// The travel at which punch and die come to [`CLOSED`] thicknesses on their way to each other, and where.
fn closed(model: &Model, state: &State) -> Option<(f64, Point)> {
    let index = |role: Role| model.tools.iter().position(|tool| tool.role == role);
    let (i, j) = (index(Role::Punch)?, index(Role::Die)?);
    let (punch, die) = (&model.tools[i], &model.tools[j]);
    // From where it is drawn: the little that it waits off the flat sheet does not count.
    let moved = |k: usize, travel: f64| {
        let tool = &model.tools[k];
        let way = match tool.motion {
            Motion::Travel => Point::new(0.0, travel),
            Motion::Path(way) => way * (travel / model.travel),
            _ => Point::zeros(),
        };
        state.tools[k] - Point::new(0.0, waiting_displacement(model, tool)) + way
    };
    let limit = CLOSED * model.blank.thickness;
    let apart = |travel: f64| punch.profile.distance_to(&die.profile, moved(i, travel) - moved(j, travel));
    // Looked at in a few places first: most punches never come close.
    const LOOKS: usize = 8;
    let travel_of = |k: usize| model.travel * k as f64 / LOOKS as f64;
    let nears = |k: usize| apart(travel_of(k)).0 < apart(travel_of(k - 1)).0;
    let hit = (1..=LOOKS).find(|&k| apart(travel_of(k)).0 < limit && nears(k))?;
    let is_closed = |travel: f64| apart(travel).0 < limit;
    let [_, high] = bisect(travel_of(hit - 1), travel_of(hit), 40, |travel| !is_closed(travel));
    (high < model.travel).then(|| (high, apart(high).1))
}
