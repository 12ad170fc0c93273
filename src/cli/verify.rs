//! `stampflow verify`: how much of every number is mesh, step, points and contact.

use super::*;
use stampflow::study::verify::{self, BEGINNING, FILE, Outcome, Verification};

options! {
    /// Refine mesh, steps and contact for an error bar of every number
    Args {
        cases: Vec<PathBuf> = "CASE.toml" [required = true] "Case files",
        out: Option<PathBuf> = "DIR" [long, alias = "output"]
            "Also write verification.csv there, with every run's numbers; with several cases to DIR/<case>",
    } common: Common, threads: Threads;
}

pub fn verify(args: &Args) -> Result<Code> {
    let (cases, failed) = args.common.load_all(&args.cases);
    args.threads.apply()?;
    let progress = args.common.progress();
    let cases = cases.into_iter().take_while(|_| !is_interrupted());
    finish(cases.map(|case| one(args, &progress, case)).collect(), failed, args.cases.len() > 1)
}

fn one(args: &Args, progress: &Progress, case: Case) -> Result<Output> {
    let path = match &args.out {
        Some(dir) if args.cases.len() > 1 => Some(place::folder(dir, &case)?.join(FILE)),
        dir => dir.as_ref().map(|dir| dir.join(FILE)),
    };
    path.iter().try_for_each(|path| place::replaced(path, BEGINNING.as_bytes(), &case.inputs, "--out"))?;
    let start = Instant::now();
    let solution = progress.watch(&case).solve(case);
    let verification = verify::verify(&solution, &progress.count(format!("{}, finer", solution.case.name)));
    let seconds = start.elapsed().as_secs_f64();
    let written = path.iter().map(|path| write(path, &verification.csv()).map_err(Into::into));
    let failed: Vec<anyhow::Error> = written.filter_map(Result::err).collect();
    let moved = verification.bars.moved(&solution);
    let code = if is_done(&solution) { Code::Done } else { Code::StoppedEarly };
    if args.common.json() {
        let own = json!({ "case": solution.case.name, "seconds": seconds, "lights": moved, "file": path });
        return Ok(Output { code, json: Some(with(as_json(&verification), own)), failed, ..Output::default() });
    }
    // Of the verdict's numbers only the forming limit's is in no other list.
    let is_printed = |own: &&Number| own.origin != Origin::Verdict || own.quantity.key == "forming_limit";
    let row = |own: &Number| [own.quantity.label.to_owned(), own.quantity.amount.to_string(), own.made_of()];
    let rows = verification.bars.numbers.iter().filter(is_printed).map(row);
    let title = format!("{}: {} finer runs, ", solution.case.name, verification.outcomes.len() - 1);
    let path = path.filter(|_| failed.is_empty());
    let screen = wrapped(format!("{title}{}\n\n", Amount::time(seconds)))
        + table(&["Quantity", "Value", "Made of (observed order)"], rows)
        + "\n"
        + list(verification.bars.notes.iter().chain(&moved))
        + path.map_or(String::new(), |path| format!("{} is written\n", path.display()));
    Ok(Output { code, screen, failed, ..Output::default() })
}

fn as_json(verification: &Verification) -> Value {
    let part = |part: &Contribution| {
        let (error, order, share) = (rounded(part.error), part.order.map(rounded), rounded(part.share));
        let (direction, extrapolated) = (part.direction.replace([' ', '-'], "_"), part.extrapolated);
        json!({ "direction": direction, "share": share, "error": error, "order": order, "extrapolated": extrapolated })
    };
    let number = |n: &Number| with(json!(n), json!({ "parts": n.contributions.iter().map(part).collect::<Value>() }));
    let run = |Outcome { direction, times, end, .. }: &Outcome| {
        let direction = direction.map(|direction| direction.key());
        json!({ "direction": direction, "times": times, "stages": end.stages, "end": end.kind, "complete": end.complete })
    };
    let numbers: Value = verification.bars.numbers.iter().map(number).collect();
    let runs: Value = verification.outcomes.iter().map(run).collect();
    json!({ "numbers": numbers, "told": verification.bars.notes, "runs": runs })
}
