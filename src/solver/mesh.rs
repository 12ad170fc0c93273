//! Mesh of the flat blank from the axis outward.

use crate::geometry::Arc;
use crate::model::{Edge, Geometry, Grading, Model, Role};
use std::f64::consts::FRAC_PI_2;

/// Elements per 90° of a tool's corner: with fewer the load oscillates as nodes pass the lip.
pub const PER_QUARTER: f64 = 12.0;

/// Largest ratio of element sizes \[–\].
const LARGEST_RATIO: f64 = 3.0;

/// Part of the blank that meets a corner, and its element size \[mm\].
struct Zone {
    from: f64,
    to: f64,
    size: f64,
}

/// Initial distances of the nodes from the axis \[mm\], rising from 0, or from the edge of a hole, to the blank's length.
pub fn nodes(model: &Model) -> Vec<f64> {
    match model.blank.grading {
        Grading::Uniform => graded(model, model.blank.elements, &[]),
        Grading::Radii => graded(model, model.blank.elements, &zones(model)),
        Grading::Divided { of } => divided(&graded(model, of, &zones(model)), model.blank.elements),
    }
}

fn divided(nodes: &[f64], n: usize) -> Vec<f64> {
    let elements = nodes.len() - 1;
    let at = |i: usize| {
        let (e, part) = (i * elements / n, i * elements % n);
        let from = nodes[e];
        if part == 0 { from } else { from + (nodes[e + 1] - from) * part as f64 / n as f64 }
    };
    (0..=n).map(at).collect()
}

fn graded(model: &Model, n: usize, zones: &[Zone]) -> Vec<f64> {
    let [start, end] = model.blank.ends();
    let length = end - start;
    let finest = zones.iter().map(|z| z.size).fold(f64::INFINITY, f64::min);
    if finest >= length / n as f64 {
        return (0..=n).map(|i| start + length * i as f64 / n as f64).collect();
    }
    // Density = 1/size: the zones' own, a floor elsewhere, blended, then raised or scaled until it integrates to n.
    const SAMPLES: usize = 4000;
    let of_zones = |k: usize| {
        let s = start + length * (k as f64 + 0.5) / SAMPLES as f64;
        zones.iter().fold(f64::NEG_INFINITY, |density, z| {
            density.max((1.0 - (z.from - s).max(s - z.to).max(0.0) / (6.0 * z.size)) / z.size)
        })
    };
    let of_zones: Vec<f64> = (0..SAMPLES).map(of_zones).collect();
    // Convex and piecewise linear in the floor: Newton's method, from above, ends on the one that is looked for.
    let (wanted, lowest) = (n as f64 * SAMPLES as f64 / length, 1.0 / (LARGEST_RATIO * finest));
    let (mut floor, mut raised) = (1.0 / finest, SAMPLES + 1);
    let scale = loop {
        let below = of_zones.iter().filter(|density| **density <= floor).count();
        let sum: f64 = of_zones.iter().filter(|density| **density > floor).sum();
        if below == raised || floor <= lowest {
            break wanted / (sum + floor * below as f64);
        }
        (floor, raised) = (((wanted - sum) / below as f64).max(lowest), below);
    };

    let mut nodes = vec![start];
    let mut passed = 0.0;
    for (k, density) in of_zones.iter().enumerate() {
        let step = scale * density.max(floor) * length / SAMPLES as f64;
        while nodes.len() < n && passed + step >= nodes.len() as f64 {
            nodes.push(start + length * (k as f64 + (nodes.len() as f64 - passed) / step) / SAMPLES as f64);
        }
        passed += step;
    }
    nodes.push(end);
    nodes
}

fn zones(model: &Model) -> Vec<Zone> {
    let length = model.blank.length;
    if model.blank.meridian.is_some() {
        return Vec::new();
    }
    // Largest draw-in \[mm\].
    let drawn_in = model.travel * if model.geometry == Geometry::Axisymmetric { 0.6 } else { 1.0 };
    let corners = model.tools.iter().flat_map(|tool| tool.profile.corners().map(|corner| (tool.role, corner)));
    let zone = |(role, corner): (Role, Arc)| {
        let (size, arc) = (corner.radius * FRAC_PI_2 / PER_QUARTER, corner.radius * corner.sweep.abs());
        let ends = [corner.at(0.0).x, corner.at(1.0).x];
        let (inner, outer) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let [from, to] = match role {
            Role::Punch => [inner - 0.5 * arc, inner + 1.5 * arc],
            // A free blank flows over the shoulder: everything from the shoulder outward will pass it.
            Role::Die if model.blank.edge == Edge::Free => [inner, length.min(outer + drawn_in)],
            Role::Die => [inner - arc, outer + arc],
            _ => return None,
        };
        (from < length).then_some(Zone { from, to, size })
    };
    corners.filter_map(zone).collect()
}
