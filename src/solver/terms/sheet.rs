//! Internal forces of the sheet: every element strained to the trial positions by the law of its metal.

mod column;
mod lanes;

use crate::element::Node;
use crate::element::kinematics::{EPS_S, EPS_T};
use crate::element::section::{Alone, Blocks, Internal, Law, Memory, Strained};
use crate::element::surface::{STATIONS, stations};
use crate::material::flow::{FlowLaw, Iterates, Quadratic, Rows};
use crate::material::{PointLaw, YieldCriterion};
use crate::model::{Iteration, Mode};
use crate::numerics::Grid;
use crate::numerics::number::{Instructions, LANES, values};
use crate::solver::evaluation::{Evaluation, Linearisation};
use crate::solver::step::{Step, elastoplastic_law};
use crate::solver::trial::Trial;
use column::Together;
use std::ops::Range;

/// Least tension of a membrane in its matrix, over its yield force \[–\]; it fades once the velocity norm is below [`SLACK_NORM`].
const SLACK_TENSION: f64 = 0.5;
const SLACK_NORM: f64 = 0.05;

/// A holder that neither sheet nor block holds, and a sheet that tools going back leave free, are kept in place by this
/// share of a block's stiffness \[–\]: a force of millionths of those that form the sheet.
pub const STABILISATION: f64 = 1e-7;

/// Internal forces p and their matrix, strains and thickness; `false` when an element has collapsed.
#[inline(always)]
pub fn add(simd: impl Instructions, step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> bool {
    let Step { model, dt, .. } = *step;
    let cutoff = step.cutoff(trial.softening);
    let mut sheet = Sheet {
        step,
        moves: &trial.moves,
        law: Law {
            points: &step.process.rule,
            slack_tension: SLACK_TENSION * (at.velocity_norm / SLACK_NORM).min(1.0),
            forces_alone: at.residual_alone,
        },
        out,
    };
    let elements = 0..step.references.len();
    if model.mode != Mode::Flow {
        let law = elastoplastic_law(model, at.matrix, dt);
        return sheet.one_by_one(elements, &law, &step.elastoplastic_points, &mut trial.elastoplastic);
    }
    let material = &model.material;
    let law = FlowLaw {
        hardening: &material.hardening,
        rate: material.rate.as_ref(),
        softening: material.thermal.as_ref(),
        criterion: material.yield_criterion,
        voids: material.gtn.as_ref(),
        // The secant matrix asks for the least besides the stress.
        matrix: if at.residual_alone { Iteration::Secant } else { at.matrix },
        cutoff,
        duration: dt,
    };
    let iterates = &mut trial.iterates;
    let (None, YieldCriterion::Hill48(hill)) = (law.voids, law.criterion) else {
        return sheet.one_by_one(elements, &law, &step.flow_points, iterates);
    };
    let law = Quadratic { law, hill };
    for first in elements.clone().step_by(LANES) {
        let group = first..(first + LANES).min(elements.end);
        let bends = step.bends[first];
        let alike = group.len() == LANES && group.clone().all(|e| step.bends[e] == bends);
        let sound = if alike {
            sheet.side_by_side(simd, group, bends, &law, iterates)
        } else {
            sheet.one_by_one(group, &law, &step.flow_points, iterates)
        };
        if !sound {
            return false;
        }
    }
    true
}

/// What the elements of a sheet are added to.
struct Sheet<'a, 's> {
    step: &'a Step<'s>,
    moves: &'a [Node],
    law: Law<'a>,
    out: &'a mut Evaluation,
}

impl Sheet<'_, '_> {
    /// Adds elements, each by itself; `false` when one has collapsed.
    #[inline(always)]
    fn one_by_one<L: PointLaw>(
        &mut self,
        elements: Range<usize>,
        law: &L,
        before: &Grid<L::PointState>,
        memory: &mut impl Memory<L::Iterate>,
    ) -> bool {
        let Self { step, moves, .. } = *self;
        for e in elements {
            let Some(current) = step.references[e].moved(moves[e], moves[e + 1]) else { return false };
            self.out.membrane_increment[e] = [current.strain[EPS_S], current.strain[EPS_T]];
            if let Some(rows) = self.out.membrane_rows.get_mut(e) {
                *rows = current.membrane_rows();
            }
            let strained = Strained::new(&current, step.volume[e], step.section[e]);
            let (before, updates) = (before.row(e), self.out.updates.row_mut(e));
            let mut points = Alone { law, before, memory, element: e, updates };
            let Internal { force, blocks, thickness_row, thickness } =
                self.law.internal(&strained, step.bends[e], &mut points);
            let blocks = match blocks {
                Some(Blocks { own: [first, second], across }) => {
                    Some(Blocks { own: [one(first), one(second)], across: one(across) })
                }
                None => None,
            };
            let (thickness_row, thickness) = (one(thickness_row), [thickness]);
            self.put(e, &Internal { force: one(force), blocks, thickness_row, thickness });
        }
        true
    }

    /// Adds as many elements as there are lanes, which all bend or are all membranes; `false` when one has collapsed.
    #[inline(always)]
    fn side_by_side<S: Instructions>(
        &mut self,
        simd: S,
        elements: Range<usize>,
        bends: bool,
        law: &Quadratic,
        iterates: &mut Iterates,
    ) -> bool {
        let (first, step) = (elements.start, self.step);
        let moves = &self.moves[first..=elements.end];
        let Some(current) = lanes::moved(simd, &step.references[elements.clone()], moves) else { return false };
        let increment = values([current.strain[EPS_S], current.strain[EPS_T]]);
        for k in 0..LANES {
            self.out.membrane_increment[first + k] = [increment[0][k], increment[1][k]];
        }
        if !self.out.membrane_rows.is_empty() {
            let [along, around] = current.membrane_rows();
            let rows = [values(along), values(around)];
            for k in 0..LANES {
                for i in 0..4 {
                    self.out.membrane_rows[first + k][0][i] = rows[0][i][k];
                    self.out.membrane_rows[first + k][1][i] = rows[1][i][k];
                }
            }
        }
        let (volume, section) = (&step.volume[elements.clone()], &step.section[elements.clone()]);
        let element = Strained::new(&current, lanes::of(simd, volume), lanes::of(simd, section));
        let rows = Rows {
            simd,
            first,
            columns: self.out.updates.columns(),
            before: &step.points_abreast,
            iterates,
            updates: self.out.updates.rows_of_mut(elements),
        };
        let internal = self.law.internal(&element, bends, &mut Together { law, rows });
        self.put(first, &lanes::apart(&internal));
        true
    }

    /// Puts elements, entry by entry, into the system: the `first` one and those after it.
    #[inline(always)]
    fn put<const N: usize>(&mut self, first: usize, internal: &Internal<[f64; N]>) {
        let Self { step, out, .. } = self;
        let Evaluation { system, thickness, thickness_rows, .. } = &mut **out;
        for k in 0..N {
            let e = first + k;
            for (node, force) in [(e, 0), (e + 1, 3)] {
                let rhs = &mut system.rhs[node];
                for d in 0..3 {
                    rhs[d] -= internal.force[force + d][k];
                }
            }
            if let Some(Blocks { own: [first, second], across }) = &internal.blocks {
                for (node, own) in [(e, first), (e + 1, second)] {
                    let block = &mut system.diagonal[node];
                    for j in 0..9 {
                        block[j] += own[j][k];
                    }
                }
                let (upper, lower) = (&mut system.upper[e], &mut system.lower[e + 1]);
                for j in 0..9 {
                    upper[j] = across[j][k];
                    lower[TRANSPOSED[j]] = across[j][k];
                }
            }
            let own = step.growth[e] * step.state.thickness[e] / step.section[e];
            thickness[e] = internal.thickness[k] * own;
            for i in 0..3 {
                thickness_rows[e][i] = internal.thickness_row[i][k] * own;
            }
        }
    }
}

/// Place of each entry of a block in the transposed block.
const TRANSPOSED: [usize; 9] = [0, 3, 6, 1, 4, 7, 2, 5, 8];

/// Entries of one element.
#[inline(always)]
fn one<const N: usize>(entries: [f64; N]) -> [[f64; 1]; N] {
    entries.map(|entry| [entry])
}

/// Keeps a sheet from floating along z once the tools that go away have left it.
pub fn stabilise(step: &Step, trial: &Trial, out: &mut Evaluation) {
    if !step.model.may_be_left() {
        return;
    }
    for (e, areas) in step.areas.chunks_exact(STATIONS).enumerate() {
        for (area, station) in areas.iter().zip(stations(step.bends[e])) {
            for (i, share) in [e, e + 1].into_iter().zip(station.shape) {
                let stiffness = STABILISATION * step.process.penalty.stiffness * area * share;
                out.system.rhs[i].y -= stiffness * trial.moves[i][1];
                out.system.diagonal[i][(1, 1)] += stiffness;
            }
        }
    }
}
