//! Measurements on the formed sheet: angles of wall and flange, curl of the wall, height and edge, named places.
//!
//! # Legs
//! A **leg** is a stretch of the meridian between bends of ten degrees or more, or a bend and the free edge. It begins and ends
//! where the curvature falls to a quarter of the bend's; towards an outer bend of its own sense, where a curled leg's curvature
//! has risen by a quarter of the difference. Where two bends of opposite sense meet, it is a thickness about their inflection.
//! The **wall** is the steepest leg behind a bend that made the sheet descend; the **flange** is the outermost leg, behind a
//! bend that brought it back. A tenth of a leg's length at both ends is left out.
//!
//! # Angles
//! ```text
//!   symmetry plane                     α    wall angle, to the axis: 0 upright, positive opened; of the chord, the straight
//!   │______  bottom                         line between the wall's ends
//!   │      \                           θ₁   between bottom plane and wall at the punch radius
//!   │       \  wall                     θ₂   between wall and flange at the die radius
//!   │        \________  flange         β    flange angle, of its chord to the horizontal: positive where the edge has
//!                                           turned towards the bottom
//!                                      2α   opening angle, between the chords of the two walls of the whole strip
//! ```
//! θ₁, θ₂ and ρ, the radius of the circle through three points of the wall (its ends and its middle), are the measures of
//! Numisheet '93, 2-D draw bending (Makinouchi, Nakamachi, Oñate, Wagoner, Proc. Numisheet '93, Isehara 1993; the page itself was
//! not read, and where on the wall its points lie is declared here). Opening angle: Numisheet 2002, benchmark B.

mod bands;
mod events;
mod meridian;
mod moment;
mod ring;
mod shape_measure;
mod stripping;

pub use bands::{Band, PartPlace, Stretch, along, bands, element_at, place_on_part, stretch};
pub use events::{Event, EventKind, events, rests_on_blocks};
pub use moment::moment_error;
pub use ring::{CutRing, Ring};
pub use shape_measure::{Change, EDGE, FLANGE_ANGLE, OPENING_ANGLE, SHAPE_MEASURES, ShapeMeasure, WALL_ANGLE, changes};

pub use stripping::stripping_force;

use crate::solver::solution::{Frame, NodeRecord};
use meridian::{ENDS, Meridian, Stretch as Between};

/// Largest sag of a straight leg over the thickness \[–\]: on 1 mm the thinnest leaf of a usual feeler gauge.
const STRAIGHT: f64 = 0.05;

/// Stretch of the sheet between bends.
#[derive(Clone, Debug, PartialEq)]
pub struct Leg {
    /// Ends of the chord [r, z] \[mm\], the inner one first.
    pub line: [[f64; 2]; 2],
    /// Slope of the chord away from the axis, middle above edge \[rad\]: −π/2 for an upright wall.
    pub slope: f64,
    /// Slopes of the sheet at both ends of the chord, the inner one first \[rad\].
    pub end_slopes: [f64; 2],
    /// Curvature of the circle through both ends and the middle \[1/mm\], positive with its centre outside, as curl has it.
    pub curvature: f64,
    /// Length of the chord \[mm\].
    pub length: f64,
    /// Mean thickness of the sheet \[mm\].
    pub thickness: f64,
}

/// Measurements on a frame; `None` for what it has not.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Steepest leg.
    pub wall: Option<Leg>,
    /// Outermost leg, behind a bend that brought the sheet back.
    pub flange: Option<Leg>,
    /// [Height over all](part_height) \[mm\].
    pub height: Option<f64>,
    /// Distance of the edge from the axis or the symmetry plane \[mm\].
    pub edge: Option<f64>,
}

impl Leg {
    fn of(meridian: &Meridian, Between { ends: [from, to], .. }: &Between) -> Self {
        let at = |share: f64| meridian.point_at(from + share * (to - from));
        let direction = |from: f64, to: f64| {
            let by = at(to) - at(from);
            by.y.atan2(by.x)
        };
        let ends = [ENDS, 1.0 - ENDS];
        let [inner, middle, outer] = [ends[0], 0.5, ends[1]].map(at);
        let chord = outer - inner;
        let sides = (middle - inner).norm() * (outer - middle).norm() * chord.norm();
        let (line, slope) = ([inner, outer].map(|p| [p.x, meridian.up * p.y]), direction(ends[0], ends[1]));
        let end_slopes = ends.map(|share| direction(share - 0.5 * ENDS, share + 0.5 * ENDS));
        let curvature = 2.0 * (middle - inner).perp(&chord) / sides;
        Self { line, slope, end_slopes, curvature, length: chord.norm(), thickness: meridian.thickness }
    }

    /// Radius of that circle \[mm\], with the sign of the curvature; infinite for a straight leg.
    pub fn radius(&self) -> f64 {
        let sag = 0.125 * self.curvature * self.length * self.length;
        if sag.abs() > STRAIGHT * self.thickness { 1.0 / self.curvature } else { f64::INFINITY }
    }
}

impl Shape {
    /// Measures a frame.
    pub fn of(frame: &Frame) -> Self {
        let (height, edge) = (part_height(frame), frame.nodes.last().map(|edge| edge.r));
        let Some(meridian) = Meridian::of(frame) else { return Self { wall: None, flange: None, height, edge } };
        let descent = |leg: &Between| {
            let [from, to] = leg.ends.map(|end| meridian.point_at(end));
            (from - to).y / (from - to).norm()
        };
        let legs = meridian.legs();
        // Behind a bend that made the sheet descend, and behind one that brought it back.
        let wall = legs.iter().filter(|leg| leg.sense < 0.0).max_by(|a, b| descent(a).total_cmp(&descent(b)));
        let flange = legs.last().filter(|leg| leg.sense > 0.0);
        let [wall, flange] = [wall, flange].map(|leg| leg.map(|leg| Leg::of(&meridian, leg)));
        Self { wall, flange, height, edge }
    }

    /// Angle between the wall's chord and the direction of the punch \[°\]: 0 upright, positive opened.
    pub fn wall_angle(&self) -> Option<f64> {
        self.wall.as_ref().map(|wall| 90.0 + wall.slope.to_degrees())
    }

    /// Angle between the wall and its mirror image beyond the symmetry plane \[°\].
    pub fn opening_angle(&self) -> Option<f64> {
        self.wall_angle().map(|angle| 2.0 * angle)
    }

    /// θ₁, between the bottom plane and the wall at the punch radius \[°\].
    pub fn bottom_to_wall(&self) -> Option<f64> {
        self.wall.as_ref().map(|wall| 180.0 + wall.end_slopes[0].to_degrees())
    }

    /// Angle of the flange to the horizontal \[°\]: positive where the edge has turned towards the bottom.
    pub fn flange_angle(&self) -> Option<f64> {
        self.flange.as_ref().map(|flange| flange.slope.to_degrees())
    }

    /// θ₂, between wall and flange at the die radius \[°\].
    pub fn wall_to_flange(&self) -> Option<f64> {
        Some(180.0 - (self.flange.as_ref()?.end_slopes[0] - self.wall.as_ref()?.end_slopes[1]).to_degrees())
    }

    /// ρ of the side-wall curl \[mm\]: positive where its centre lies outside, infinite for a straight wall.
    pub fn curl_radius(&self) -> Option<f64> {
        self.wall.as_ref().map(Leg::radius)
    }
}

/// Diameters outside, over the wall, from the second node to the edge \[mm\].
pub fn outside_diameters(frame: &Frame) -> impl Iterator<Item = f64> {
    frame.nodes.windows(2).map(|pair| {
        let (along, rise) = (pair[1].r - pair[0].r, pair[1].z - pair[0].z);
        2.0 * pair[1].r + pair[1].thickness * rise.abs() / along.hypot(rise)
    })
}

/// Outside height of a part along the punch travel \[mm\]: from the bottom's outer face to the flange's, or to the rim's edge.
pub fn part_height(frame: &Frame) -> Option<f64> {
    let nodes = &frame.nodes;
    let faces = nodes.iter().enumerate().map(|(i, node)| {
        let after = nodes[(i + 1).min(nodes.len() - 1)];
        // The middle lies level.
        let is_middle = i == 0 && node.r == 0.0;
        let before = if is_middle { NodeRecord { r: -after.r, ..after } } else { nodes[i.saturating_sub(1)] };
        let (along, rise) = (after.r - before.r, after.z - before.z);
        let half = 0.5 * node.thickness * along.abs() / along.hypot(rise);
        [node.z - half, node.z + half]
    });
    let [low, high] = faces.reduce(|[low, high], [below, above]| [low.min(below), high.max(above)])?;
    Some(high - low)
}

/// Outer face of the bottom along the punch travel \[mm\].
pub fn bottom(frame: &Frame) -> Option<f64> {
    frame.nodes.iter().map(|node| node.z + 0.5 * node.thickness).reduce(f64::max)
}

/// Point of the middle and thickness of the wall \[mm\] at this outside height of a part, the nearest to the rim.
pub fn wall_at(frame: &Frame, height: f64) -> Option<[f64; 3]> {
    let level = bottom(frame)? - height;
    let (a, b) = frame.nodes.iter().zip(&frame.nodes[1..]).rev().find(|(a, b)| (a.z >= level) != (b.z >= level))?;
    let share = (level - a.z) / (b.z - a.z);
    Some([(a.r, b.r), (a.z, b.z), (a.thickness, b.thickness)].map(|(a, b)| a + share * (b - a)))
}

/// Thickness and initial distance from the axis of the thickest element \[mm\].
pub fn thickest(frame: &Frame) -> Option<(f64, f64)> {
    let thickest = frame.elements.iter().max_by(|a, b| a.thickness.total_cmp(&b.thickness))?;
    Some((thickest.thickness, thickest.s0))
}
