//! What all tools do to each contact point, put into the system: elements side by side.

use crate::element::surface::{MotionForces, STATIONS, Station, difference, of_node, stations};
use crate::numerics::Real;
use crate::numerics::number::{Instructions, LANES, Lanes, beside, values};
use crate::solver::evaluation::{Evaluation, Linearisation};
use crate::solver::push::{FIRST, Push, SECOND};
use crate::solver::step::Step;

/// An element that tools press.
#[derive(Clone, Copy)]
struct Pressed<T> {
    pushes: [Push<T>; STATIONS],
    /// Its differences r₂−r₁, z₂−z₁ \[mm\], θ₂−θ₁.
    difference: [T; 3],
    /// t \[mm\], and its derivatives by r₁+r₂, r₂−r₁, z₂−z₁.
    thickness: T,
    thinning: [T; 3],
}

/// Forces on the motions of an element's nodes, and of its matrix the blocks 11, 12, 21, 22, column after column.
struct Forces<T> {
    nodes: [[T; 3]; 2],
    blocks: Option<[[T; 9]; 4]>,
}

/// Adds what all tools do to the sheet.
#[inline(always)]
pub fn assemble(simd: impl Instructions, step: &Step, at: &Linearisation, out: &mut Evaluation) {
    let elements = step.bends.len();
    for first in (0..elements).step_by(LANES) {
        let last = (first + LANES).min(elements);
        let bends = step.bends[first];
        if !out.pushes[STATIONS * first..STATIONS * last].iter().any(Push::acts) {
            continue;
        }
        let together = last == first + LANES && step.bends[first..last].iter().all(|b| *b == bends);
        if together {
            let four = [pressed(out, first), pressed(out, first + 1), pressed(out, first + 2), pressed(out, first + 3)];
            let Forces { nodes: [a, b], blocks } = beside(simd, &four).forces(stations(bends), at.residual_alone);
            let blocks = match blocks {
                Some([aa, ab, ba, bb]) => Some([values(aa), values(ab), values(ba), values(bb)]),
                None => None,
            };
            put(first, &Forces { nodes: [values(a), values(b)], blocks }, out);
            continue;
        }
        for e in first..last {
            let Forces { nodes, blocks } = pressed(out, e).forces(stations(step.bends[e]), at.residual_alone);
            let nodes = nodes.map(|node| node.map(|force| [force]));
            let blocks = blocks.map(|blocks| blocks.map(|block| block.map(|entry| [entry])));
            put(e, &Forces { nodes, blocks }, out);
        }
    }
}

#[inline(always)]
fn pressed(out: &Evaluation, e: usize) -> Pressed<f64> {
    Pressed {
        pushes: [out.pushes[STATIONS * e], out.pushes[STATIONS * e + 1]],
        difference: difference(&out.nodes[e], &out.nodes[e + 1]),
        thickness: out.thickness[e],
        thinning: out.thickness_rows[e],
    }
}

#[inline(always)]
fn beside<S: Instructions>(simd: S, of: &[Pressed<f64>; LANES]) -> Pressed<Lanes<S>> {
    macro_rules! push {
        ($k:literal) => {
            Push {
                force: [beside!(simd, of, pushes[$k].force[0]), beside!(simd, of, pushes[$k].force[1])],
                squeeze: beside!(simd, of, pushes[$k].squeeze),
                force_by_place: [
                    [
                        beside!(simd, of, pushes[$k].force_by_place[0][0]),
                        beside!(simd, of, pushes[$k].force_by_place[0][1]),
                    ],
                    [
                        beside!(simd, of, pushes[$k].force_by_place[1][0]),
                        beside!(simd, of, pushes[$k].force_by_place[1][1]),
                    ],
                ],
                force_by_thickness: [
                    beside!(simd, of, pushes[$k].force_by_thickness[0]),
                    beside!(simd, of, pushes[$k].force_by_thickness[1]),
                ],
                squeeze_by_place: [
                    beside!(simd, of, pushes[$k].squeeze_by_place[0]),
                    beside!(simd, of, pushes[$k].squeeze_by_place[1]),
                ],
                squeeze_by_thickness: beside!(simd, of, pushes[$k].squeeze_by_thickness),
            }
        };
    }
    Pressed {
        pushes: [push!(0), push!(1)],
        difference: [
            beside!(simd, of, difference[0]),
            beside!(simd, of, difference[1]),
            beside!(simd, of, difference[2]),
        ],
        thickness: beside!(simd, of, thickness),
        thinning: [beside!(simd, of, thinning[0]), beside!(simd, of, thinning[1]), beside!(simd, of, thinning[2])],
    }
}

impl<T: Real> Pressed<T> {
    /// Forces, and where they are asked for their derivatives.
    #[inline(always)]
    fn forces(&self, stations: &[Station; STATIONS], forces_alone: bool) -> Forces<T> {
        let Self { pushes, difference, thickness, thinning } = self;
        let zero = thickness.constant(0.0);
        let mut sheet = MotionForces { force: [zero; 5], matrix: [[zero; 5]; 5] };
        let slopes = [stations[0].slope(*difference), stations[1].slope(*difference)];
        for k in 0..STATIONS {
            pushes[k].load(&slopes[k], thinning, &mut sheet.force);
        }
        let nodes = [of_node(FIRST, &sheet.force), of_node(SECOND, &sheet.force)];
        if forces_alone {
            return Forces { nodes, blocks: None };
        }
        for k in 0..STATIONS {
            pushes[k].stiffen(&stations[k], &slopes[k], thinning, &mut sheet.matrix);
        }
        // Q ∂²t, ∂²t = ∂t ∂tᵀ/t − t ∂²(ε_s + ε_θ), all of it by ∂t = −t ∂(ε_s + ε_θ).
        let square = (pushes[0].squeeze + pushes[1].squeeze) / *thickness;
        let [hoop, r, z] = *thinning;
        let [by_hoop, by_r, by_z] = [square * hoop, square * r, square * z];
        let m = &mut sheet.matrix;
        m[0][0] = m[0][0] + by_hoop * hoop * 2.0;
        m[2][2] = m[2][2] + (by_r * r * 2.0 - by_z * z);
        m[3][3] = m[3][3] + (by_z * z * 2.0 - by_r * r);
        for (i, j, value) in [(0, 2, by_hoop * r), (0, 3, by_hoop * z), (2, 3, by_r * z * 3.0)] {
            m[i][j] = m[i][j] + value;
            m[j][i] = m[j][i] + value;
        }
        let blocks = [
            sheet.block(FIRST, FIRST),
            sheet.block(FIRST, SECOND),
            sheet.block(SECOND, FIRST),
            sheet.block(SECOND, SECOND),
        ];
        Forces { nodes, blocks: Some(blocks) }
    }
}

/// Puts elements, entry by entry, into the system: the `first` one and those after it.
#[inline(always)]
fn put<const N: usize>(first: usize, forces: &Forces<[f64; N]>, out: &mut Evaluation) {
    let system = &mut out.system;
    let [a, b] = &forces.nodes;
    for k in 0..N {
        let e = first + k;
        for (node, forces) in [(e, a), (e + 1, b)] {
            let rhs = &mut system.rhs[node];
            for d in 0..3 {
                rhs[d] += forces[d][k];
            }
        }
        if let Some([aa, ab, ba, bb]) = &forces.blocks {
            for (node, own) in [(e, aa), (e + 1, bb)] {
                let block = &mut system.diagonal[node];
                for j in 0..9 {
                    block[j] -= own[j][k];
                }
            }
            let (upper, lower) = (&mut system.upper[e], &mut system.lower[e + 1]);
            for j in 0..9 {
                upper[j] -= ab[j][k];
                lower[j] -= ba[j][k];
            }
        }
    }
}
