//! Quality of the solution: energy balance, nearly rigid zones, penetration, bending moments, sharp bends, strain paths, mesh.

use super::*;
use crate::forming_limit::Judged;
use crate::measure::moment_error;

struct Check {
    text: &'static str,
    advice: &'static str,
    /// Largest share allowed, and the one that is red, if any \[–\].
    limits: (f64, Option<f64>),
    /// Share of a stage \[–\].
    of: fn(&StageSolution) -> Option<f64>,
}

const WORK: Check = Check {
    text: "{} of the work is missing; in the balance of what the tools do",
    advice: "take smaller steps (solver.max_step)",
    limits: (0.01, None),
    of: |stage| stage.steps.last().map(|step| step.work.missing().abs()),
};

const CHECKS: [Check; 5] = [
    Check {
        text: "{} of the work is in rigid zones; there stresses are not the true ones",
        advice: "take a smaller solver.cutoff_strain",
        limits: (0.05, None),
        of: |stage| formed(stage).filter(|end| end.work.plastic > 0.0).map(|end| end.work.cutoff / end.work.plastic),
    },
    Check {
        text: "tools sink in by {} of the thickness",
        advice: "take a larger solver.contact_stiffness, or contact by the augmented Lagrangian",
        limits: (0.05, Some(0.1)),
        of: |stage| stage.steps.last().map(|_| largest(stage, |step| step.penetration)),
    },
    Check {
        text: "{} of the bending moment is missed; where it is largest",
        advice: "take more layers (blank.layers)",
        limits: (0.05, None),
        of: |stage| {
            let bends = stage.model.mode != Mode::Flow && stage.model.release.is_none();
            moment_error(stage.frames.last().filter(|_| bends)?)
        },
    },
    // Cups over noses of 2 t to 3 t agree with continuum solids within 2 % of force: middle radius 2.5 t.
    Check {
        text: "t is {} of the sharpest radius; more than thin-shell theory follows closely",
        advice: "take strains and spring-back there as rough, or take a larger radius",
        limits: (0.4, None),
        of: |stage| stage.steps.last().map(|_| largest(stage, |step| step.sharpest_bend)),
    },
    // Limit curves are measured on straight paths; one that the program chose is a guess anyway.
    Check {
        text: "crooked strain paths use {}; of the forming limit, which holds for straight ones",
        advice: "keep more margin there (strain_paths.csv of `run`)",
        limits: (0.5, None),
        of: |stage| {
            let assessment = assess(stage.model.forming_limit.as_ref().filter(|curve| !curve.is_usual)?, &stage.paths)?;
            assessment.elements.iter().filter(|judged| judged.is_crooked()).map(Judged::ratio).reduce(f64::max)
        },
    },
];

/// Strain of all steps below which a stage forms nothing \[–\]: shares of its work are meaningless.
const FORMED: f64 = 2e-3;

fn formed(stage: &StageSolution) -> Option<&StepRecord> {
    let strain: f64 = stage.steps.iter().map(|step| step.strain_increment).sum();
    stage.steps.last().filter(|_| strain > FORMED)
}

pub(super) fn judge(run: &Run) -> Option<Finding> {
    run.steps().next()?;
    let worst = |check: &Check| run.stages.iter().filter_map(check.of).reduce(f64::max);
    let largest = run.stages.iter().map(StageSolution::largest_work).fold(0.0, f64::max);
    let missing = if largest > 0.0 { worst(&WORK).unwrap_or(0.0) / largest } else { 0.0 };
    let all = [(&WORK, missing)].into_iter().chain(CHECKS.iter().filter_map(|check| Some((check, worst(check)?))));
    let is_red = |check: &Check, share: f64| check.limits.1.is_some_and(|red| share > red);
    let (check, share) = all.max_by(|&(a, x), &(b, y)| {
        is_red(a, x).cmp(&is_red(b, y)).then((x / a.limits.0).total_cmp(&(y / b.limits.0)))
    })?;
    let source = "declared accuracy of the solver; bends: continuum solids; strain paths: declared";
    let judged = Finding::judged("solution_quality", "Solution quality", check.text).number(Amount::share(share));
    let judged = judged.at_most(100.0 * check.limits.0, check.limits.1.map(|red| 100.0 * red));
    Some(judged.source(source).advice(check.advice))
}

/// Plastic strain, or stress over the yield stress, from which a point has yielded again \[–\].
const YIELDED: f64 = 1e-4;
/// Share of the sheet that is reported \[–\].
const LEAST: f64 = 1e-3;

pub(super) fn yields_again(stage: &StageSolution) -> Option<Finding> {
    let (model, end) = (&stage.model, &stage.end);
    model.release?;
    let before = &stage.start.as_ref()?.through.points;
    let layers = model.blank.points();
    let (mut volume, mut total) = (0.0, 0.0);
    for (i, (point, before)) in end.points.iter().zip(before).enumerate() {
        let e = i / layers.len();
        let share = end.volume[e] * layers[i % layers.len()].weight;
        let limit = model.material_at(end.middle(e)).yield_stress(point.strain, end.temperature[e]);
        let beyond = model.mode != Mode::ElastoViscoplastic
            && model.material.yield_criterion.equivalent_stress(point.stress) > limit * (1.0 + YIELDED);
        total += share;
        volume += if beyond || point.strain - before.strain_equivalent > YIELDED { share } else { 0.0 };
    }
    let text = match model.mode {
        Mode::Elastic => "{} of the sheet would yield again as the tools are taken away, which elasticity leaves out",
        _ => "{} of the sheet yields again as the tools are taken away",
    };
    let share = Amount::share(volume / total);
    Finding::warning("yields_again", "Unloading", text).number(share).at_most(100.0 * LEAST, None).if_beyond()
}

/// Elements per 90° below which the load oscillates as nodes pass a corner, and the advised number \[–\].
const PER_QUARTER: [f64; 2] = [8.0, 10.0];

pub(super) fn mesh(model: &Model) -> Option<Finding> {
    let [least, advised] = PER_QUARTER;
    let fit = estimate::coarsest_corner(model).filter(|fit| fit.per_quarter < least)?;
    let elements = (model.blank.elements as f64 * advised / fit.per_quarter).ceil() as usize;
    let text = format!(
        "{{}} elements per 90° at the {}'s radius of {}: the load will oscillate as nodes pass it",
        model.name_of(fit.role),
        Amount::size(fit.radius)
    );
    let warning = Finding::warning("mesh", "Mesh", text).number(Amount::norm(fit.per_quarter)).at_least(least, None);
    Some(warning.advice(format!("take about {elements} elements, which give {advised}")))
}

const UPRIGHT: f64 = 0.9994;

pub(super) fn line_end(model: &Model, tool: &Tool) -> Option<Finding> {
    let (behind, whole) = match tool.role {
        Role::Punch => (-1.0, "its nose and its wall"),
        Role::Die => (1.0, "its shoulder and its wall"),
        _ => return None,
    };
    let (name, face) = (tool.role.name(), tool.profile.extreme(tool.role == Role::Punch, model.blank.ends())?.y);
    // The sheet lies left of the line: its last end is the one that is passed.
    let (at, away) = tool.profile.ends()[1]?;
    let depth = behind * (at.y - face);
    if model.blank.is_open() || at.x >= model.blank.length || depth >= model.travel || away.y.abs() >= UPRIGHT {
        return None;
    }
    let [r, z, travel, to] = [at.x, at.y, model.travel, face + behind * model.travel].map(Amount::size);
    let text = format!(
        "the {name}'s line ends at r = {r}, z = {z} (as placed, z = 0 is the flat sheet's middle), {{}} of the {travel} of travel \
         behind its face: the sheet bends over the end as over a sharp edge"
    );
    let warning = Finding::warning("line_end", "End of a tool", text).number(Amount::size(depth));
    let warning = warning.at_least(model.travel, None).source("a tool acts only where it is drawn");
    Some(warning.advice(format!("draw {whole} on to an upright wall, or as far as z = {to}")))
}
