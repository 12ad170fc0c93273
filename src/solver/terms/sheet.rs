//! Internal forces of the sheet: every element strained to the trial positions by the law of its metal.

use crate::element::{kinematics::EPS_S, kinematics::EPS_T, section::Section};
use crate::material::PointLaw;
use crate::solver::{corrector::LARGEST_MOVE, evaluation::Linearisation, step::elastoplastic_law, *};
use std::ops::Range;

/// Least tension of a membrane in its matrix, over its yield force \[–\]; of the flow law it fades once the velocity norm is
/// below [`SLACK_NORM`], of the elastic laws with the square of the last move.
const SLACK_TENSION: f64 = 0.5;
const SLACK_NORM: f64 = 0.05;

/// A holder that neither sheet nor block holds, a sheet that tools going back leave free, and an elastic membrane, are kept in
/// place by this share of a block's stiffness \[–\]: a force of millionths of those that form the sheet; of the membrane, whose
/// whole span it holds back in each step, 0.3 % of the work at most in `strip_draw`.
pub const STABILISATION: f64 = 1e-7;

/// Internal forces p and their matrix, strains and thickness; `false` when an element has collapsed.
pub fn add(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> bool {
    let Step { model, dt, .. } = *step;
    if model.mode != Mode::Flow {
        let last_move = match at.iteration {
            0 => LARGEST_MOVE * model.blank.thickness,
            _ => trial.line.length * trial.line.direction.iter().map(|d| d.xy().norm()).fold(0.0, f64::max),
        };
        // All of it until the sheet is at rest: the last move makes it fade.
        let slack = (if at.velocity_norm == 0.0 { 0.0 } else { SLACK_TENSION }, last_move);
        let (points, iterates) = (&step.elastoplastic_points, &mut trial.elastoplastic);
        return step.context.metals.iter().all(|metal| {
            let law = elastoplastic_law(model, metal.material, at.matrix, dt);
            add_elements(step, (&law, &metal.elements), points, iterates, (&trial.moves, slack), at, out)
        });
    }
    // The secant matrix asks for the least besides the stress.
    let matrix = if at.residual_alone { Iteration::Secant } else { at.matrix };
    let slack = (SLACK_TENSION * (at.velocity_norm / SLACK_NORM).min(1.0), f64::INFINITY);
    step.context.metals.iter().all(|metal| {
        let law = metal.material.flow_law(matrix, step.cutoff(trial.softening), dt);
        let (points, iterates) = (&step.flow_points, &mut trial.iterates);
        add_elements(step, (&law, &metal.elements), points, iterates, (&trial.moves, slack), at, out)
    })
}

fn add_elements<L: PointLaw>(
    step: &Step, (law, elements): (&L, &Range<usize>), points: &Grid<L::PointState>, iterates: &mut Grid<L::Iterate>,
    (moves, (slack_tension, last_move)): (&[Node], (f64, f64)), at: &Linearisation, out: &mut Evaluation,
) -> bool {
    let section = Section { law, rule: &step.context.rule, slack_tension, last_move, forces_alone: at.residual_alone };
    for e in elements.clone() {
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

/// Keeps a sheet from floating along z once the tools that go away have left it, and a slack membrane.
pub fn stabilise(step: &Step, trial: &Trial, out: &mut Evaluation) {
    // An elastic membrane has no stiffness across itself where only a holder's pressure slackens it.
    let may_be_slack = step.model.mode != Mode::Flow && step.model.blank.theory != Theory::Bending;
    if !step.model.may_be_left() && !may_be_slack {
        return;
    }
    for (e, areas) in step.areas.chunks_exact(STATIONS).enumerate() {
        for (area, station) in areas.iter().zip(step.stations()) {
            for (i, share) in [e, e + 1].into_iter().zip(station.shape) {
                let stiffness = STABILISATION * step.context.penalty.stiffness * area * share;
                out.system.rhs[i].y -= stiffness * trial.moves[i][1];
                out.system.diagonal[i][(1, 1)] += stiffness;
            }
        }
    }
}
