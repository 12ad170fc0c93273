//! Record of a converged step.

use super::{restraints::Seal, *};

pub(super) fn record(converged: &Converged, before: &Evaluation, next: &State, rejected: usize) -> StepRecord {
    let Converged { step, trial, evaluation, outcome, .. } = converged;
    let (model, times) = (step.model, step.model.extent().times());
    let force_of = |role: Role| model.tool_index(role).map_or(0.0, |j| times * evaluation.tool_force[j].y);
    let is_fed = model.blank.edge == Edge::Fed;
    let thickness = &next.thickness;
    let thinnest = (0..thickness.len()).fold(0, |a, b| if thickness[b] < thickness[a] { b } else { a });
    let (n, holder) = (evaluation.nodes.len(), model.tool_index(Role::Holder));
    let gap = |role: Role, node: usize| model.tool_index(role).map_or(f64::INFINITY, |j| next.gap(model, j, node));
    let gaps = |node: usize| Role::ALL.map(|role| gap(role, node));
    StepRecord {
        step: step.number,
        time: step.end(),
        travel: step.travel(),
        punch_force: force_of(Role::Punch) + if is_fed { times * evaluation.edge_reaction.y } else { 0.0 },
        holder_force: force_of(Role::Holder),
        pad_force: -force_of(Role::Pad),
        edge_force: if is_fed || model.blank.edge == Edge::Free { 0.0 } else { times * evaluation.edge_reaction.x },
        draw_in: model.blank.edge_radius() - evaluation.nodes[n - 1][0],
        hole: if model.blank.has_hole() { next.hole() } else { 0.0 },
        thinnest: thickness[thinnest],
        thinnest_s0: next.middle(thinnest),
        pole_height: evaluation.nodes[0][1],
        pressure: model.gas.iter().zip(&trial.gas).map(|(gas, pressure)| gas.face.sign() * pressure).sum(),
        held_rate: model.rate_control().map_or(0.0, |control| control.target * evaluation.held_rate.norm),
        on_cap: evaluation.held_rate.on_cap,
        contact_share: contact_share(converged),
        edge_gap: gaps(n - 1),
        middle_gap: gaps(0),
        die_slope: model.tool_index(Role::Die).map_or(0.0, |j| {
            // By the normal towards the sheet: −z on a flat die.
            let normal = model.tools[j].profile.closest(next.in_frame_of(j, n - 1)).normal;
            normal.x.abs().atan2(-normal.y)
        }),
        holder_move: holder.filter(|_| model.release.is_none()).map_or(0.0, |j| trial.tools[j].y),
        block_force: times * evaluation.block_force,
        penetration: evaluation.penetration(),
        strain_increment: converged.strain_increment(),
        sharpest_bend: sharpest_bend(evaluation, next),
        iterations: outcome.iterations,
        rejected,
        velocity_norm: outcome.increment,
        residual_norm: outcome.residual_norm,
        ..contact_shares(converged, before)
    }
}

fn contact_shares(converged: &Converged, before: &Evaluation) -> StepRecord {
    let Converged { step, evaluation, .. } = converged;
    let (model, penalty) = (step.model, &step.context.penalty);
    let rim = model.blank.length - StepRecord::RIM * model.blank.thickness;
    let (mut touching, mut sticking, mut contact_changes) = (0_usize, 0_usize, 0_usize);
    let (mut held, mut on_rim) = (0.0, 0.0);
    for (j, tool) in step.context.tools.iter().enumerate() {
        for (i, (now, then)) in evaluation.contacts.row(j).iter().zip(before.contacts.row(j)).enumerate() {
            let active = now.is_active(penalty);
            contact_changes += usize::from(active != then.is_active(penalty));
            touching += usize::from(active);
            sticking += usize::from(active && now.slip.abs() < step.slip_scale);
            if tool.role == Role::Holder {
                held += now.normal;
                on_rim += if step.state.middle(i / STATIONS) >= rim { now.normal } else { 0.0 };
            }
        }
    }
    let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
    let (rim_share, sticking) = (share(on_rim, held), share(sticking as f64, touching as f64));
    StepRecord { rim_share, sticking, contact_changes, ..StepRecord::default() }
}

/// Share of the current area inside the seal that lies on the punch or the die \[–\].
fn contact_share(converged: &Converged) -> f64 {
    let Converged { step, evaluation, .. } = converged;
    let within = step.model.gas.iter().map(|gas| gas.within).reduce(f64::max).unwrap_or(f64::INFINITY);
    let seal = Seal::find(&step.state.nodes, within, step.model.geometry);
    let forming = [Role::Punch, Role::Die].map(|role| step.model.tool_index(role));
    // Distance from lying on the nearest tool, extrapolated from the contact points to the element's ends.
    let gaps = |i: usize| forming.into_iter().flatten().map(move |j| evaluation.contacts[(j, i)].gap);
    let off = |i: usize| gaps(i).fold(f64::INFINITY, f64::min) - step.context.penalty.lying();
    let ends = |e: usize| {
        let (a, b) = (off(STATIONS * e), off(STATIONS * e + 1));
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a) / step.stations()[1].xi);
        [middle - half, middle + half]
    };
    let (mut touching, mut whole) = (0.0, 0.0);
    for (e, [meridional, hoop]) in evaluation.membrane_increment.iter().enumerate() {
        let area = seal.inside(e) * step.references[e].area() * (meridional + hoop).exp();
        whole += area;
        touching += area * negative_share(ends(e));
    }
    touching / whole
}

/// Share of a line over which a linear function is negative, by its values at the ends \[–\].
fn negative_share([a, b]: [f64; 2]) -> f64 {
    match (a < 0.0, b < 0.0) {
        (true, true) => 1.0,
        (false, false) => 0.0,
        _ => a.min(b) / (a.min(b) - a.max(b)),
    }
}

/// Thickness over the smallest radius of the mid-surface, from the angle between neighbouring elements \[–\].
fn sharpest_bend(evaluation: &Evaluation, next: &State) -> f64 {
    let bends = (0..next.thickness.len() - 1).map(|e| {
        let (a, b) = (next.along(e), next.along(e + 1));
        let (la, lb) = (a.norm(), b.norm());
        let sine = (a.perp(&b) / (la * lb)).clamp(-1.0, 1.0);
        sine.abs().asin() / (0.5 * (la + lb)) * evaluation.thickness[e]
    });
    bends.fold(0.0, f64::max)
}
