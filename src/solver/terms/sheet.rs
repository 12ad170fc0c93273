//! Internal forces of the sheet: every element strained to the trial positions by the law of its metal.

use crate::element::Node;
use crate::element::section::Law;
use crate::element::surface::{STATIONS, stations};
use crate::material::PointLaw;
use crate::material::flow::FlowLaw;
use crate::model::{Iteration, Mode};
use crate::numerics::Grid;
use crate::solver::evaluation::{Evaluation, Linearisation};
use crate::solver::step::{Step, elastoplastic_law};
use crate::solver::trial::Trial;

/// Least tension of a membrane in its matrix, over its yield force \[–\]; it fades once the velocity norm is below [`SLACK_NORM`].
const SLACK_TENSION: f64 = 0.5;
const SLACK_NORM: f64 = 0.05;

/// A holder that neither sheet nor block holds, and a sheet that tools going back leave free, are kept in place by this
/// share of a block's stiffness \[–\]: a force of millionths of those that form the sheet.
pub const STABILISATION: f64 = 1e-7;

/// Internal forces p and their matrix, strains and thickness; `false` when an element has collapsed.
#[inline(always)]
pub fn add(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> bool {
    let Step { model, dt, .. } = *step;
    if model.mode != Mode::Flow {
        let law = elastoplastic_law(model, at.matrix, dt);
        return strain(law, step, &step.elastoplastic_points, &trial.moves, &mut trial.elastoplastic, at, out);
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
        cutoff: step.cutoff(trial.softening),
        duration: dt,
    };
    strain(law, step, &step.flow_points, &trial.moves, &mut trial.iterates, at, out)
}

#[inline(always)]
fn strain<L: PointLaw>(
    point: L,
    step: &Step,
    before: &Grid<L::PointState>,
    moves: &[Node],
    iterates: &mut Grid<L::Iterate>,
    at: &Linearisation,
    out: &mut Evaluation,
) -> bool {
    let rule = &step.process.rule;
    let slack_tension = SLACK_TENSION * (at.velocity_norm / SLACK_NORM).min(1.0);
    let law = Law { point, points: rule, slack_tension, forces_alone: at.residual_alone };
    let system = &mut out.system;
    out.currents.clear();
    let rows = before.rows().zip(iterates.rows_mut()).zip(out.updates.rows_mut());
    for ((e, reference), ((before, iterates), updates)) in step.references.iter().enumerate().zip(rows) {
        let Some(current) = reference.moved(moves[e], moves[e + 1]) else { return false };
        let internal = law.internal(&current, step.volume[e], step.section[e], before, iterates, updates);
        system.diagonal[e] += internal.own[0];
        system.upper[e] += internal.across;
        system.lower[e + 1] += internal.across.transpose();
        system.diagonal[e + 1] += internal.own[1];
        system.rhs[e] -= internal.force.fixed_rows::<3>(0);
        system.rhs[e + 1] -= internal.force.fixed_rows::<3>(3);
        let own = step.growth[e] * step.state.thickness[e] / step.section[e];
        out.thickness[e] = internal.thickness * own;
        out.thickness_rows[e] = internal.thickness_row.map(|by| by * own);
        out.currents.push(current);
        out.membrane_increment[e] = [current.strain[0], current.strain[1]];
        if let Some(rows) = out.membrane_rows.get_mut(e) {
            *rows = current.membrane_rows();
        }
    }
    true
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
