//! Contact within the assembly: which node touches which tool, with what pressure, and what that adds to the system.

use super::assembly::Workspace;
use crate::contact::friction::Coulomb;
use crate::contact::penalty::Smooth;
use crate::contact::{Visitor, touch};
use crate::geometry::{Point, Profile};
use crate::model::{Iteration, Model, Motion};
use crate::state::State;
use nalgebra::{Matrix3, Vector3};

/// A tool as the solver uses it.
#[derive(Clone, Debug)]
pub(super) struct ActiveTool {
    pub profile: Profile,
    pub friction: f64,
    pub motion: Motion,
    /// Index among the shared unknowns, for a tool whose position is one.
    pub shared: Option<usize>,
    /// Travel at which the sheet left this tool's reach for good \[mm\]; it takes no part from then on.
    pub released: Option<f64>,
}

impl ActiveTool {
    /// Whether the tool takes part at all: a holder without force does not.
    fn is_absent(&self) -> bool {
        self.released.is_some() || (matches!(self.motion, Motion::Force(_)) && self.shared.is_none())
    }
}

/// One node against one tool at the end of the step under trial; forces are zero when it is out of reach.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Contact {
    /// Distance of the mid-surface from the tool \[mm\]; infinite until measured when far away.
    pub distance: f64,
    pub normal: f64,
    pub tangential: f64,
    pub slip: f64,
    /// Gap, pressure and slope of the last iteration, from which the carried pressure follows.
    gap: f64,
    pressure: Smooth,
}

impl Contact {
    /// A node that nothing presses, `distance` \[mm\] away.
    pub fn free(distance: f64) -> Self {
        Self { distance, ..Self::default() }
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
        let lost = self.tools.iter_mut().enumerate().find(|(_, tool)| {
            let inner = tool.profile.pieces().iter().map(|p| p.first().x.min(p.last().x)).fold(f64::INFINITY, f64::min);
            !tool.is_absent() && tool.shared.is_some() && edge < inner
        });
        lost.map(|(j, tool)| {
            tool.released = Some(state.travel);
            let pairs = j * n..(j + 1) * n;
            self.contacts[pairs.clone()].fill(Contact::free(f64::INFINITY));
            pairs
        })
    }

    /// Measures the distances that the iterations did not need; the balance of work does.
    pub fn measure_far(&mut self) {
        let n = self.nodes.len();
        for (pair, contact) in self.contacts.iter_mut().enumerate().filter(|(_, c)| c.distance.is_infinite()) {
            let (tool, x) = (pair / n, self.nodes[pair % n]);
            let position = Point::new(x[0], x[1] - self.tool_position[tool]);
            contact.distance = self.tools[tool].profile.closest(position).distance;
            self.far[pair] = Far { position, distance: contact.distance };
        }
    }

    /// Pressure of every tool on every node at the end of the step \[MPa\].
    pub fn pressures(&self) -> impl Iterator<Item = f64> {
        self.contacts.iter().map(|c| c.pressure.value)
    }

    /// Contact and friction of every tool with every node it reaches; returns the largest force of one on one.
    pub(super) fn contact(&mut self, model: &Model, state: &State, dt: f64, iteration: usize) -> f64 {
        let mut largest: f64 = 0.0;
        self.penetration = 0.0;
        self.active_contacts = 0;
        let last = self.nodes.len() - 1;
        let system = &mut self.system;
        for (j, tool) in self.tools.iter().enumerate() {
            self.tool_force[j] = 0.0;
            if tool.is_absent() {
                continue;
            }
            let friction = Coulomb { coefficient: tool.friction, slip: model.settings.slip_speed * model.speed * dt };
            let moved = self.tool_position[j] - state.tools[j];
            for i in 0..=last {
                let (before, after) = (i.max(1) - 1, i.min(last - 1));
                let thickness = 0.5 * (self.thickness[before] + self.thickness[after]);
                let x = &self.nodes[i];
                let position = Point::new(x[0], x[1] - self.tool_position[j]);
                let pair = j * (last + 1) + i;
                let contact = &mut self.contacts[pair];
                let carried = &mut self.carried[pair];
                // A distance changes no faster than the node moves: far away it need not be measured again.
                let far = &mut self.far[pair];
                let free = *carried == 0.0 && contact.pressure.slope == 0.0 && state.pressure[pair] == 0.0;
                if free && far.distance - (position - far.position).norm() > 0.5 * thickness + self.penalty.reach() {
                    *contact = Contact::free(f64::INFINITY);
                    continue;
                }
                let closest = tool.profile.closest(position);
                *far = Far { position, distance: closest.distance };
                let gap = closest.distance - 0.5 * thickness;
                if model.settings.iteration != Iteration::PrimalDual {
                    *carried = 0.0;
                } else if iteration > 0 {
                    *carried = (contact.pressure.value + contact.pressure.slope * (gap - contact.gap)).max(0.0);
                }
                let node = Visitor {
                    carried: *carried,
                    position,
                    relative: Point::new(self.moves[i][0], self.moves[i][1] - moved),
                    thickness,
                    area: self.areas[i],
                };
                *contact = Contact { distance: closest.distance, gap, ..Contact::default() };
                let Some(touch) = touch(&closest, &self.penalty, &friction, &node) else { continue };
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
                self.penetration = self.penetration.max(-touch.gap / thickness);
                self.active_contacts += usize::from(touch.gap < 0.0);
            }
        }
        largest
    }
}
