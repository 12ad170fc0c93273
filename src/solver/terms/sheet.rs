//! Internal forces of the sheet: every element strained to the trial positions by the law of its metal.

use crate::element::Node;
use crate::element::kinematics::{EPS_S, EPS_T};
use crate::element::section::Section;
use crate::element::surface::STATIONS;
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
pub fn add(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> bool {
    let Step { model, dt, .. } = *step;
    if model.mode != Mode::Flow {
        let law = elastoplastic_law(model, at.matrix, dt);
        return add_elements(step, &law, &step.elastoplastic_points, &mut trial.elastoplastic, &trial.moves, at, out);
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
    add_elements(step, &law, &step.flow_points, &mut trial.iterates, &trial.moves, at, out)
}

fn add_elements<L: PointLaw>(
    step: &Step,
    law: &L,
    points: &Grid<L::PointState>,
    iterates: &mut Grid<L::Iterate>,
    moves: &[Node],
    at: &Linearisation,
    out: &mut Evaluation,
) -> bool {
    let section = Section {
        law,
        rule: &step.context.rule,
        slack_tension: SLACK_TENSION * (at.velocity_norm / SLACK_NORM).min(1.0),
        forces_alone: at.residual_alone,
    };
    for e in 0..step.references.len() {
        let Some(current) = step.references[e].moved(moves[e], moves[e + 1]) else { return false };
        let stretch = [current.strain[EPS_S], current.strain[EPS_T]];
        out.membrane_increment[e] = stretch;
        if let Some(rows) = out.membrane_rows.get_mut(e) {
            *rows = current.strain_displacement().fixed_rows::<2>(EPS_S).into_owned();
        }
        let (points, iterates, updates) = (points.row(e), iterates.row_mut(e), out.updates.row_mut(e));
        let (volume, thickness) = (step.volume[e], step.section[e]);
        let (force, matrix) = section.internal(&current, volume, thickness, points, iterates, updates);
        let thickness = step.growth[e] * step.state.thickness[e] * (-stretch[0] - stretch[1]).exp();
        out.thickness[e] = thickness;
        out.thickness_rows[e] = current.stretch_rows() * -thickness;
        out.system.add_forces(e, &-force);
        if let Some(matrix) = matrix {
            out.system.add_element(e, &matrix);
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
        for (area, station) in areas.iter().zip(step.stations(e)) {
            for (i, share) in [e, e + 1].into_iter().zip(station.shape) {
                let stiffness = STABILISATION * step.context.penalty.stiffness * area * share;
                out.system.rhs[i].y -= stiffness * trial.moves[i][1];
                out.system.diagonal[i][(1, 1)] += stiffness;
            }
        }
    }
}
