//! `stampflow trace`: one step of the solver, iteration by iteration.

mod shown;

use super::code::{BadRequest, Code};
use super::options::{self, Json, Overrides};
use super::say::{say, say_json};
use super::{interrupt, job, place};
use clap::ValueEnum;
use serde_json::{Value, json};
use stampflow::Observer;
use stampflow::case::Case;
use stampflow::model::Iteration;
use stampflow::output::trace::step_csv;
use stampflow::output::write;
use stampflow::solver::trace::{self, Asked, Iterated, Pass, Trace};
use stampflow::units::rounded;
use std::path::PathBuf;

pub const HELP: &str = "\
The run goes up to the step as always. The step is then solved once more from the state \
before it: the predictor, and each iteration with the increment of the velocities, how \
much of it was taken, and the residual that it leaves; elements in cut-off, points in \
contact, points that stick. With several methods each starts from the same state. FILE.csv \
has every iteration of every try. The book's page on convergence explains the words.

Examples:
  stampflow trace cup.toml --step 40
  stampflow trace cup.toml --step 40 --methods all
  stampflow trace cup.toml --step 40 --methods newton --tolerance 1e-11
  stampflow trace cup.toml --stage 2 --step 1 --out step.csv

Exit codes: 0 done, 2 bad input or no such step, 130 interrupted";

/// What a step may be told to come down to \[–\]: below is round-off.
const TOLERANCES: std::ops::RangeInclusive<f64> = 1e-12..=1e-1;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case file
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// Number of the step, from 1, as load_travel.csv counts its rows
    #[arg(long, value_name = "N")]
    step: usize,
    /// Number of the stage, from 1
    #[arg(long, value_name = "N", default_value_t = 1)]
    stage: usize,
    /// Matrices of the corrector, each from the same state: primal-dual, newton, secant or all [default: the case's own]
    #[arg(long, visible_alias = "method", value_name = "METHOD", value_delimiter = ',', hide_possible_values = true)]
    methods: Vec<Method>,
    /// What the norm is to come down to in this step alone, 1e-12 to 0.1 [default: the case's own]
    #[arg(long, value_name = "NORM", value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Also write every iteration of every try to this file
    #[arg(long, value_name = "FILE.csv")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overrides: Overrides,
    #[command(flatten)]
    form: options::Told,
    #[command(flatten)]
    json: Json,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    #[value(alias = "primal_dual")]
    PrimalDual,
    Newton,
    Secant,
    All,
}

fn tolerance(text: &str) -> Result<f64, String> {
    let norm = text.parse().map_err(|_| "give a number, such as 1e-10".to_owned())?;
    match TOLERANCES.contains(&norm) {
        true => Ok(norm),
        false => Err(format!("give {:e} to {}", TOLERANCES.start(), TOLERANCES.end())),
    }
}

/// Ends a run when the program is to end.
struct Interrupted;

impl Observer for Interrupted {
    fn wants_to_stop(&mut self) -> bool {
        interrupt::is_wanted()
    }
}

pub fn trace(args: &Args) -> anyhow::Result<Code> {
    let case = job::load(&args.case, &args.overrides.all())?;
    if let Some(path) = &args.out {
        place::replaced(path, &step_csv(None), "--out")?;
        place::file(path, &case.inputs, "--out")?;
    }
    let asked =
        Asked { stage: args.stage, step: args.step, matrices: matrices(&args.methods), tolerance: args.tolerance };
    let trace = match trace::trace(&case.stages, &asked, &mut Interrupted) {
        Ok(trace) => trace,
        Err(error) if error.is_interrupted() => return Ok(Code::Interrupted),
        Err(error) => return Err(BadRequest(error.to_string()).into()),
    };
    if let Some(path) = &args.out {
        write(path, &step_csv(Some(&trace)))?;
    }
    match args.json.json {
        true => say_json(&json(&case, &trace)),
        false => say(shown::screen(&case, &trace, args.form.form())),
    }
}

fn matrices(methods: &[Method]) -> Vec<Iteration> {
    let mut matrices = Vec::new();
    for method in methods {
        let named: &[Iteration] = match method {
            Method::PrimalDual => &[Iteration::PrimalDual],
            Method::Newton => &[Iteration::Newton],
            Method::Secant => &[Iteration::Secant],
            Method::All => &[Iteration::PrimalDual, Iteration::Newton, Iteration::Secant],
        };
        for matrix in named {
            if !matrices.contains(matrix) {
                matrices.push(*matrix);
            }
        }
    }
    matrices
}

/// Everything but what stands at each node, for programs.
fn json(case: &Case, trace: &Trace) -> Value {
    let iterated = |i: &Iterated| {
        json!({
            "iteration": i.iteration,
            "velocity_norm": i.velocity_norm.map(rounded),
            "share": i.share.map(rounded),
            "residual_norm": rounded(i.residual_norm),
            "worst_r_mm": rounded(i.nodes[i.worst_node][0]),
            "cut_off_elements": i.cut_off(),
            "contacts": i.touching.len(),
            "sticking": i.sticking(),
        })
    };
    let pass = |pass: &Pass| {
        json!({
            "matrix": trace::key(pass.matrix),
            "cutoff": pass.cutoff.map(rounded),
            "iterations": pass.iterated.iter().map(iterated).collect::<Vec<_>>(),
        })
    };
    let ways = trace.ways.iter().map(|way| {
        let tries = way.attempts.iter().map(
            |attempt| json!({ "start": attempt.key(), "passes": attempt.passes.iter().map(pass).collect::<Vec<_>>() }),
        );
        json!({
            "method": trace::key(way.matrix),
            "converged": way.converged,
            "iterations": way.count(),
            "order": way.rate().and_then(|rate| rate.order).map(rounded),
            "left": way.rate().map(|rate| rounded(rate.left)),
            "tries": tries.collect::<Vec<_>>(),
        })
    });
    json!({
        "case": case.name,
        "stage": trace.asked.stage,
        "step": trace.asked.step,
        "from_travel_mm": rounded(trace.before.travel),
        "to_travel_mm": rounded(trace.record.travel),
        "duration_s": rounded(trace.dt),
        "tolerance": trace.tolerance(),
        "elements": trace.before.thickness.len(),
        "methods": ways.collect::<Vec<_>>(),
    })
}
