//! `stampflow check`: what a case means and, with `--run`, what comes of it.

use super::*;

options! {
    /// Explain a case; with --run solve it and give a verdict
    Args {
        case: PathBuf [] "Case file",
        run: bool [long] "Also solve it and give a verdict",
        verbose: bool [long, short] "Print everything: sources, assumptions, every limit with its source",
        no_error_bars: bool [long, hide_short_help = true] "With --run: skip the finer runs for error bars",
        no_advice: bool [long, hide_short_help = true] "With --run: try no changes of a red or amber design",
        strict: bool [long, hide_short_help = true] "With --run: end with exit code 4 where the verdict is red",
    } common: Common;
}

pub fn check(args: &Args) -> Result<Code> {
    let (case, is_json) = (args.common.overrides.load(&args.case)?, args.common.json());
    let report = assess::check::report(&case);
    let value = serde_json::to_value(&report)?;
    let meaning = if args.verbose { format!("{report:#}") } else { report.to_string() };
    if !args.run {
        let doubts = if report.warnings.is_empty() { "no warnings; next" } else { "next" };
        let next = format!("stampflow check --run {}", args.case.display());
        return emit(is_json, value, || wrapped(format!("{meaning}\n{doubts}: {next}")));
    }
    let progress = args.common.progress();
    let solved = Solved::new(progress.watch(&case).solve(case), &progress, !args.no_error_bars, !args.no_advice);
    let (verdict, warnings) = (solved.verdict(), sentences(&solved.findings, Kind::Warning));
    let own = json!({ "complete": solved.solution.is_complete(), "verdict": verdict, "run_warnings": warnings });
    emit(is_json, with(value, own), || match args.verbose {
        true => solved.screen(wrapped(format!("\n{meaning}\n")) + every_row(&solved.findings)),
        false => {
            let green = judgements(&solved.findings).filter(|finding| finding.light == Light::Green);
            solved.screen(ScreenText::from("\n") + table(&["Green", "Found", "Limit"], green.map(Finding::brief)))
        }
    })?;
    Ok(solved.code(args.strict))
}

fn every_row(findings: &[Finding]) -> ScreenText {
    let rows = judgements(findings).map(|finding| {
        let light = Cell::Light(finding.light, String::new());
        [finding.label.into(), light, finding.statement().into(), finding.sourced_limit().into()]
    });
    table::<[Cell; 4]>(&["Verdict", "Light", "Found", "Limit (source)"], rows)
        + wrapped(format!("\n{}\n", headline(findings)))
}
