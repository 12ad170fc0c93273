//! `stampflow trace`: one step of the solver, iteration by iteration.

use super::*;
use stampflow::model::Iteration::{self, Newton, PrimalDual, Secant};
use stampflow::solver::trace::{IterationHistory, NoSuchStep, Trace, TraceRequest, trace as trace_step};

const METHODS: [(&str, &[Iteration]); 4] =
    [("primal-dual", &[PrimalDual]), ("newton", &[Newton]), ("secant", &[Secant]), ("all", &Iteration::ALL)];

options! {
    /// Show one step of the solver, iteration by iteration
    Args {
        case: PathBuf = "CASE.toml" [] "Case file",
        step: usize = "N" [long] "Number of the step, from 1, as load_travel.csv counts its rows",
        stage: usize = "N" [long, default_value_t = 1] "Number of the stage, from 1",
        methods: Vec<&'static [Iteration]> = "METHOD" [long, visible_alias = "method", value_delimiter = ',', value_parser = one_of(METHODS)]
            "Matrices of the corrector [default: the case's own]",
        tolerance: Option<f64> = "NORM" [long, value_parser = tolerance]
            "Tolerance of the norm in this step, 1e-12 to 0.1 [default: the case's own]",
        out: Option<PathBuf> = "FILE.csv" [long] "Also write every iteration there",
        quiet: bool [long, short, hide_short_help = true] "Show no progress",
    } overrides: Overrides;
}

/// Reads a tolerance of the norm \[–\]; smaller ones are round-off.
fn tolerance(text: &str) -> Result<f64, String> {
    let norm = text.parse().map_err(|_| "give a number, such as 1e-10".to_owned())?;
    (1e-12..=0.1).contains(&norm).then_some(norm).ok_or_else(|| "give 1e-12 to 0.1".to_owned())
}

pub fn trace(Args { case, step, stage, methods, tolerance, out, quiet, overrides }: Args) -> Result<Code> {
    let case = overrides.load(&case)?;
    out.iter().try_for_each(|path| place::replaced(path, &tables::step_iterations(&[]), &case.inputs, "--out"))?;
    let request = TraceRequest { stage, step, matrices: methods.concat(), tolerance };
    let trace = match trace_step(&case.stages, &request, &mut Progress::new(quiet).watch(&case)) {
        Ok(trace) => trace,
        Err(NoSuchStep::Interrupted) => return Ok(Code::Interrupted),
        Err(error) => return Err(bad_request(error.to_string())),
    };
    let Trace { before, record, dt, .. } = &trace;
    let stage = case.stage_label(trace.stage - 1).map_or(String::new(), |stage| format!(" {stage}"));
    let head = format!(
        "{}{stage}, step {}: from {:.4} to {:.4} mm of travel, in {dt:.3e} s, tolerance {:.0e}",
        case.name, record.step, before.travel, record.travel, trace.tolerance
    );
    let printed = print(trace.histories.iter().fold(wrapped(head), |text, history| text + iterations(history)));
    out.iter().try_for_each(|path| write(path, &tables::step_iterations(&trace.histories)))?;
    printed
}

fn iterations(history: &IterationHistory) -> ScreenText {
    let pass = history.last_pass();
    let start = pass.first().map_or("", |row| row.start.key());
    let head = format!("\n{} matrix, start: {start}\n\n", history.matrix.key());
    let headers = ["iteration", "velocity", "taken", "residual", "largest at", "cut off", "contact", "sticking"];
    let n = history.count();
    let end = match history.end {
        Some(_) => format!("In equilibrium after {n} iterations of all tries."),
        None => format!("No equilibrium after {n} iterations of all tries: the run would halve the step."),
    };
    let rate = history.rate().map_or("Too few to show a rate: --tolerance 1e-11 goes on.".to_owned(), |rate| {
        let order =
            rate.order.map_or("No clear order of convergence".to_owned(), |p| format!("Order of convergence {p:.1}"));
        format!("{order}; the last iteration leaves {:.2} % of the error.", 100.0 * rate.left)
    });
    wrapped(head) + table(&headers, pass.iter().map(cells)) + wrapped(format!("{end} {rate}"))
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
