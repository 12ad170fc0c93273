//! Contact within the assembly: which node touches which tool, with what pressure, and what that adds to the system.

use super::assembly::{Trial, Workspace};
use super::attempt::Step;
use crate::contact::friction::Friction;
use crate::contact::penalty::{Penalty, ValueAndSlope};
use crate::contact::{ContactNode, touch};
use crate::element::kinematics::Reference;
use crate::geometry::{Point, Profile};
use crate::model::{Iteration, Model, Motion, Role, Settings};
use crate::state::{State, thickness_at};
use nalgebra::{Matrix3, Vector3};

/// Most rounds that one shift of the augmented Lagrangian stands for.
const LONGEST_SERIES: f64 = 20.0;

/// Cosine between the normals of two tools below which they press on opposite faces \[–\].
const OPPOSED: f64 = -0.5;

/// A tool as the solver uses it.
#[derive(Clone, Debug)]
pub(super) struct ActiveTool {
    pub role: Role,
    pub profile: Profile,
    pub friction: Friction,
    pub motion: Motion,
    /// Index among the shared unknowns, for a tool whose position is one.
    pub shared: Option<usize>,
    /// Travel at which the sheet left this tool's reach for good \[mm\]; it takes no part and stands still from then on.
    pub released: Option<f64>,
}

impl ActiveTool {
    /// Whether the tool takes part at all: a holder without force does not.
    fn is_absent(&self) -> bool {
        self.released.is_some() || (matches!(self.motion, Motion::Pressed(_)) && self.shared.is_none())
    }
}

/// One node against one tool at the end of the step under trial; forces are zero when it is out of reach.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Contact {
    /// Distance of the mid-surface from the tool \[mm\]; infinite until measured when far away.
    pub distance: f64,
    /// Gap between the tool and the sheet's face \[mm\]; infinite when far away.
    pub gap: f64,
    pub normal: f64,
    pub tangential: f64,
    pub slip: f64,
    /// Pressure and slope of the last iteration, from which the carried pressure follows.
    pub pressure: ValueAndSlope,
    /// Normal from the tool to the sheet.
    pub facing: Point,
}

impl Contact {
    /// A node that nothing presses, `distance` \[mm\] away.
    pub fn free(distance: f64) -> Self {
        Self { distance, gap: f64::INFINITY, ..Self::default() }
    }

    /// Whether the tool presses: the sheet's face is in it, or held at it.
    pub fn is_pressed(&self, penalty: &Penalty) -> bool {
        self.pressure.value > penalty.at_touch()
    }
}

/// Where a node was last measured against a tool, in the tool's frame, and how far away it was [mm].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Far {
    pub position: Point,
    pub distance: f64,
}

impl Workspace {
    /// Lifts a pressed tool off once the blank's edge has run out from under it: what is left to press on is a corner,
    /// from which the sheet would snap. Returns the contacts that end.
    pub fn release(&mut self, state: &State) -> Option<std::ops::Range<usize>> {
        let edge = state.nodes[state.nodes.len() - 1][0];
        let n = state.nodes.len();
        let lost = self.tools.iter_mut().enumerate().find(|(j, tool)| {
            let inner = tool.profile.pieces().iter().map(|p| p.first().x.min(p.last().x)).fold(f64::INFINITY, f64::min);
            !tool.is_absent() && tool.shared.is_some() && edge < inner + state.aside[*j]
        });
        lost.map(|(j, tool)| {
            tool.released = Some(state.travel);
            let pairs = j * n..(j + 1) * n;
            self.contacts[pairs.clone()].fill(Contact::free(f64::INFINITY));
            pairs
        })
    }

    /// Takes up the pressures that a state begins with, and what they push with; friction has to set in anew.
    pub fn resume(&mut self, model: &Model, state: &State) {
        if model.release.is_some() {
            return;
        }
        let n = state.nodes.len();
        let mut areas = vec![0.0; n];
        for (e, pair) in state.nodes.windows(2).enumerate() {
            let theory = model.blank.theory.of_element(state.bends[e]);
            let [a, b] = Reference::new(model.geometry, theory, pair[0], pair[1]).tributary();
            areas[e] += a;
            areas[e + 1] += b;
        }
        for (pair, pressure) in state.pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            let (j, i) = (pair / n, pair % n);
            let closest = self.tools[j]
                .profile
                .closest(Point::new(state.nodes[i][0] - state.aside[j], state.nodes[i][1] - state.tools[j]));
            let contact = &mut self.contacts[pair];
            contact.pressure.value = *pressure;
            contact.normal = areas[i] * pressure;
            contact.facing = closest.normal;
            self.tool_force[j] += contact.normal * closest.normal.y;
            self.tool_force_aside[j] += contact.normal * closest.normal.x;
        }
    }

    /// Measures the distances that the iterations did not need; the balance of work does.
    pub fn measure_far(&mut self) {
        let n = self.nodes.len();
        for (pair, contact) in self.contacts.iter_mut().enumerate().filter(|(_, c)| c.distance.is_infinite()) {
            let (tool, x) = (pair / n, self.nodes[pair % n]);
            let position = Point::new(x[0] - self.tool_aside[tool], x[1] - self.tool_position[tool]);
            contact.distance = self.tools[tool].profile.closest(position).distance;
            self.far[pair] = Far { position, distance: contact.distance };
        }
    }

    /// Pressure of every tool on every node at the end of the step \[MPa\].
    pub fn pressures(&self) -> impl Iterator<Item = f64> {
        self.contacts.iter().map(|c| c.pressure.value)
    }

    /// By how much the sheet at node `i` is too thick for the gap between two tools that do not give way and press it from
    /// both faces \[mm\]; `None` where there are no such two.
    pub fn squeeze(&self, i: usize) -> Option<f64> {
        let n = self.nodes.len();
        let held = |j: usize| {
            let contact = &self.contacts[j * n + i];
            (self.tools[j].shared.is_none() && contact.is_pressed(&self.penalty)).then_some(contact)
        };
        let pairs = (0..self.tools.len()).flat_map(|j| (0..j).map(move |k| (j, k)));
        let squeezes = pairs.filter_map(|(j, k)| {
            let (a, b) = (held(j)?, held(k)?);
            (a.facing.dot(&b.facing) < OPPOSED).then_some(-(a.gap + b.gap))
        });
        squeezes.max_by(f64::total_cmp)
    }

    /// Largest penetration over the thickness where the sheet is not squeezed \[–\]: what the contact method lets through.
    pub fn penetration(&self) -> f64 {
        let n = self.nodes.len();
        let deep = self.contacts.iter().enumerate().filter(|(pair, c)| c.gap < 0.0 && self.squeeze(pair % n).is_none());
        deep.map(|(pair, c)| -c.gap / self.thickness_at(pair % n)).fold(0.0, f64::max)
    }

    /// One round of the augmented Lagrangian: shifts every gap by what is left of it, λ ← min(0, λ + g). Returns `false`
    /// when nothing penetrates, or is pressed from afar, by more than [`Settings::PENETRATION`].
    ///
    /// Where the sheet hardly gives way, as a rigid zone does until it yields, g falls slowly from round to round; then the
    /// shift is what the series of its rounds adds up to, by the ratio of the last two (A. C. Aitken, 1926).
    ///
    /// Between two tools that do not give way there is no gap to find; there the penalty stays.
    ///
    /// # References
    /// M. R. Hestenes, Multiplier and gradient methods, J. Optim. Theory Appl. 4 (1969) 303–320; contact: J. C. Simo,
    /// T. A. Laursen, Computers & Structures 42 (1992) 97–116.
    pub fn augment(&mut self, round: usize) -> bool {
        let n = self.nodes.len();
        let mut worst: f64 = 0.0;
        for pair in 0..self.contacts.len() {
            let gap = self.contacts[pair].gap;
            if (gap < 0.0 || self.shift[pair] < 0.0) && gap.is_finite() && self.squeeze(pair % n).is_none() {
                worst = worst.max(gap.abs() / self.thickness_at(pair % n));
            }
        }
        if worst <= Settings::PENETRATION {
            return false;
        }
        for pair in 0..self.contacts.len() {
            let gap = self.contacts[pair].gap;
            if gap.is_finite() && self.squeeze(pair % n).is_none() {
                let ratio = if round > 0 { gap / self.last_gap[pair] } else { 0.0 };
                let series = if (0.0..1.0).contains(&ratio) { (1.0 / (1.0 - ratio)).min(LONGEST_SERIES) } else { 1.0 };
                self.last_gap[pair] = gap;
                self.shift[pair] = (self.shift[pair] + series * gap).min(0.0);
                self.carried[pair] = self.contacts[pair].pressure.value;
            }
        }
        true
    }

    /// Thickness that contact sees at node `i` \[mm\].
    pub fn thickness_at(&self, i: usize) -> f64 {
        thickness_at(&self.thickness, i)
    }

    /// Contact and friction of every tool with every node it reaches; returns the largest force of one on one.
    pub(super) fn contact(&mut self, step: &Step, trial: &Trial) -> f64 {
        let Step { model, state, dt, .. } = *step;
        let mut largest: f64 = 0.0;
        self.active_contacts = 0;
        let last = self.nodes.len() - 1;
        let slip_scale = model.settings.slip_speed * model.speed * model.nominal(state.time, dt);
        let system = &mut self.system;
        for (j, tool) in self.tools.iter().enumerate() {
            (self.tool_force[j], self.tool_force_aside[j]) = (0.0, 0.0);
            if tool.is_absent() {
                continue;
            }
            let moved = Point::new(self.tool_aside[j] - state.aside[j], self.tool_position[j] - state.tools[j]);
            for i in 0..=last {
                let (before, after) = (i.max(1) - 1, i.min(last - 1));
                let thickness = thickness_at(&self.thickness, i);
                let x = &self.nodes[i];
                let position = Point::new(x[0] - self.tool_aside[j], x[1] - self.tool_position[j]);
                let pair = j * (last + 1) + i;
                let contact = &mut self.contacts[pair];
                let carried = &mut self.carried[pair];
                // A distance changes no faster than the node moves: far away it need not be measured again.
                let far = &mut self.far[pair];
                let free = *carried == 0.0 && contact.pressure.slope == 0.0 && state.pressure[pair] == 0.0;
                let shift = self.shift[pair];
                let reach = 0.5 * thickness + self.penalty.reach() - shift;
                if free && far.distance - (position - far.position).norm() > reach {
                    *contact = Contact::free(f64::INFINITY);
                    continue;
                }
                let closest = tool.profile.closest(position);
                *far = Far { position, distance: closest.distance };
                let gap = closest.distance - 0.5 * thickness;
                if trial.matrix != Iteration::PrimalDual {
                    *carried = 0.0;
                } else if trial.iteration > 0 {
                    *carried = (contact.pressure.value + contact.pressure.slope * (gap - contact.gap)).max(0.0);
                }
                let node = ContactNode {
                    carried: *carried,
                    position,
                    relative: Point::new(self.moves[i][0], self.moves[i][1]) - moved,
                    thickness,
                    area: self.areas[i],
                    shift,
                    slip_scale,
                    duration: dt,
                    shear_yield: self.shear_yield[i],
                };
                *contact = Contact { distance: closest.distance, gap, facing: closest.normal, ..Contact::default() };
                let Some(touch) = touch(&closest, &self.penalty, &tool.friction, &node) else { continue };
                contact.normal = touch.normal;
                contact.tangential = touch.tangential;
                contact.slip = touch.slip;
                contact.pressure = touch.pressure;

                system.rhs[i].x += touch.force.x;
                system.rhs[i].y += touch.force.y;
                let mut own = Matrix3::zeros();
                own.fixed_view_mut::<2, 2>(0, 0).copy_from(&touch.by_position);
                system.diagonal[i] -= own;
                if let Some(k) = tool.shared {
                    let by_tool = touch.by_position.column(1);
                    system.columns[i][k] += Vector3::new(by_tool.x, by_tool.y, 0.0);
                    system.rows[i][k] += own.row(1).transpose();
                    system.corner[(k, k)] -= by_tool.y;
                }
                // The sheet thins as its elements stretch: ∂F/∂t ∂t/∂x reaches both neighbours.
                let by_thickness = Vector3::new(touch.by_thickness.x, touch.by_thickness.y, 0.0) * 0.5;
                for e in [before, after] {
                    let row = &self.thickness_rows[e];
                    let first = Vector3::new(row[0], row[1], row[2]);
                    let second = Vector3::new(row[3], row[4], row[5]);
                    let (first_block, second_block) = if e == i {
                        (&mut system.diagonal[i], &mut system.upper[i])
                    } else {
                        (&mut system.lower[i], &mut system.diagonal[i])
                    };
                    *first_block -= by_thickness * first.transpose();
                    *second_block -= by_thickness * second.transpose();
                    if let Some(k) = tool.shared {
                        system.rows[e][k] += first * by_thickness.y;
                        system.rows[e + 1][k] += second * by_thickness.y;
                    }
                }

                largest = largest.max(touch.force.norm());
                self.tool_force[j] += touch.force.y;
                self.tool_force_aside[j] += touch.force.x;
                self.active_contacts += usize::from(touch.gap < 0.0);
            }
        }
        largest
    }
}
