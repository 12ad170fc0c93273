//! `stampflow trace`: one step of the solver, iteration by iteration.

use super::code::{BadRequest, Code};
use super::options::Overrides;
use super::progress::{Progress, Records};
use super::screen::{Cell, ScreenText, print, table, wrapped};
use super::{job, place};
use stampflow::case::Case;
use stampflow::model::Iteration;
use stampflow::results::tables::{matrix_key, step_iterations};
use stampflow::results::write;
use stampflow::solver::solution::IterationRecord;
use stampflow::solver::trace::{IterationHistory, NoSuchStep, Trace, TraceRequest, trace as trace_step};
use std::path::PathBuf;

pub const HELP: &str = "\
The run goes up to the step as always. The step is then solved once more from the state \
before it: the predictor, and each iteration with the increment of the velocities, how \
much of it was taken, and the residual that it leaves; elements in cut-off, points in \
contact, points that stick. With several methods each starts from the same state. FILE.csv \
has every iteration of every try. The book's page on convergence explains the words.

Examples:
  stampflow trace cup.toml --step 40
  stampflow trace cup.toml --step 40 --methods all --tolerance 1e-11
  stampflow trace cup.toml --stage 2 --step 1 --out step.csv

Exit codes: 0 done, 2 bad input or no such step, 130 interrupted";

/// Tolerances of the norm \[–\]; smaller ones are round-off.
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
    /// Matrices of the corrector: primal-dual, newton, secant or all [default: the case's own]
    #[arg(long, visible_alias = "method", value_name = "METHOD", value_parser = methods)]
    methods: Option<std::vec::Vec<Iteration>>,
    /// Tolerance of the norm in this step, 1e-12 to 0.1 [default: the case's own]
    #[arg(long, value_name = "NORM", value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Also write every iteration there
    #[arg(long, value_name = "FILE.csv")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overrides: Overrides,
}

fn tolerance(text: &str) -> Result<f64, String> {
    let norm = text.parse().map_err(|_| "give a number, such as 1e-10".to_owned())?;
    match TOLERANCES.contains(&norm) {
        true => Ok(norm),
        false => Err(format!("give {:e} to {}", TOLERANCES.start(), TOLERANCES.end())),
    }
}

pub fn trace(args: &Args) -> anyhow::Result<Code> {
    let case = job::load(&args.case, &args.overrides.all())?;
    if let Some(path) = &args.out {
        place::replaced(path, &step_iterations(&[]), "--out")?;
        place::file(path, &case.inputs, "--out")?;
    }
    let request = TraceRequest {
        stage: args.stage,
        step: args.step,
        matrices: args.methods.clone().unwrap_or_default(),
        tolerance: args.tolerance,
    };
    let mut watch = Progress::new(true).watch(&case, Records::default());
    let trace = match trace_step(&case.stages, &request, &mut watch) {
        Ok(trace) => trace,
        Err(NoSuchStep::Interrupted) => return Ok(Code::Interrupted),
        Err(error) => return Err(BadRequest(error.to_string()).into()),
    };
    if let Some(path) = &args.out {
        write(path, &step_iterations(&trace.histories))?;
    }
    print(screen(&case, &trace))
}

fn methods(text: &str) -> Result<Vec<Iteration>, String> {
    let matrices = text.split(',').map(|method| match method {
        "primal-dual" | "primal_dual" => Ok(vec![Iteration::PrimalDual]),
        "newton" => Ok(vec![Iteration::Newton]),
        "secant" => Ok(vec![Iteration::Secant]),
        "all" => Ok(vec![Iteration::PrimalDual, Iteration::Newton, Iteration::Secant]),
        _ => Err("give primal-dual, newton, secant or all".to_owned()),
    });
    Ok(matrices.collect::<Result<Vec<_>, _>>()?.concat())
}

/// Rows shown at the beginning and at the end of a longer table.
const SHOWN: [usize; 2] = [12, 6];

fn screen(case: &Case, trace: &Trace) -> ScreenText {
    let Trace { before, record, dt, .. } = trace;
    let stage = case.stage_label(trace.stage - 1).map_or(String::new(), |stage| format!(" {stage}"));
    let head = format!(
        "{}{stage}, step {}: from {:.4} to {:.4} mm of travel, in {dt:.3e} s, tolerance {:.0e}",
        case.name, record.step, before.travel, record.travel, trace.tolerance
    );
    trace.histories.iter().fold(wrapped(&head), |shown, history| shown + iterations(history))
}

/// Iterations of the last pass, and how fast they converge.
fn iterations(history: &IterationHistory) -> ScreenText {
    let pass = history.last_pass();
    let start = pass.first().map_or("", |row| row.start.key());
    let head = format!("\n{} matrix, start: {start}\n\n", matrix_key(history.matrix));
    let headers = ["iteration", "velocity", "taken", "residual", "largest at", "cut off", "contact", "sticking"];
    let mut rows: Vec<[Cell; 8]> = pass.iter().map(|row| cells(row).map(Cell::from)).collect();
    if rows.len() > SHOWN[0] + SHOWN[1] {
        let gap = ["…", "", "", "", "", "", "", ""].map(Cell::from);
        rows.splice(SHOWN[0]..pass.len() - SHOWN[1], [gap]);
    }
    let n = history.count();
    let end = match history.end {
        Some(_) => format!("In equilibrium after {n} iterations of all tries."),
        None => format!("No equilibrium after {n} iterations of all tries: the run would halve the step."),
    };
    let rate = match history.rate() {
        None => "Too few to show a rate: --tolerance 1e-11 goes on.".to_owned(),
        Some(rate) => {
            let order = rate.order.map(|p| format!("Order of convergence {p:.1}"));
            let order = order.unwrap_or("No clear order of convergence".to_owned());
            format!("{order}; the last iteration leaves {:.2} % of the error.", 100.0 * rate.left)
        }
    };
    wrapped(&head) + table(&headers, rows) + wrapped(&format!("{end} {rate}"))
}

fn cells(row: &IterationRecord) -> [String; 8] {
    let moved = |text: String| if row.iteration == 0 { "–".to_owned() } else { text };
    [
        row.iteration.to_string(),
        moved(format!("{:.2e}", row.velocity_norm)),
        moved(format!("{:.2}", row.share)),
        format!("{:.2e}", row.residual_norm),
        format!("{:.2} mm", row.worst_r),
        row.cut_off.to_string(),
        row.touching.to_string(),
        row.sticking.to_string(),
    ]
}
