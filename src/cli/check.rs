//! `stampflow check`: what a case means and, with `--run`, what comes of it.

use super::*;
use stampflow::assess::check::{self, Check};

options! {
    /// Explain a case; with --run solve it and give a verdict
    Args {
        case: PathBuf [] "Case file",
        run: bool [long] "Also solve it and give a verdict",
        verbose: bool [long, short] "With --run: also explain the case, as without",
        no_error_bars: bool [long] "With --run: skip the finer runs for error bars",
        no_advice: bool [long] "With --run: try no changes of a red or amber design",
        strict: bool [long] "With --run: end with exit code 4 where the verdict is red",
    } common: Common;
}

pub fn check(args: &Args) -> Result<Code> {
    let (case, is_json) = (args.common.overrides.load(&args.case)?, args.common.json());
    let report = check::report(&case);
    let value = serde_json::to_value(&report)?;
    if !args.run {
        return emit(is_json, value, || wrapped(report.to_string()));
    }
    let progress = args.common.progress();
    let solved = Solved::new(progress.watch(&case).solve(case), &progress, !args.no_error_bars, !args.no_advice);
    let (verdict, warnings) = (solved.verdict(), sentences(&solved.findings, Kind::Warning));
    let own = json!({ "complete": solved.solution.is_complete(), "verdict": verdict, "run_warnings": warnings });
    emit(is_json, with(value, own), || {
        solved.screen() + verdict_table(args.verbose.then_some(&report), &solved.findings)
    })?;
    Ok(solved.code(args.strict))
}

/// The meaning of the case if wanted, and every row of the verdict.
fn verdict_table(report: Option<&Check>, findings: &[Finding]) -> ScreenText {
    let rows = judgements(findings).map(|finding| {
        let limit = format!("{} ({})", finding.limit, finding.source);
        let light = Cell::Light(finding.light, String::new());
        [finding.label.into(), light, finding.statement().into(), limit.into()]
    });
    let unchecked = by_advice(findings, Light::Grey).into_iter().filter(|group| !group[0].advice.is_empty());
    let unchecked = unchecked.map(|group| {
        let labels: Vec<_> = group.iter().map(|finding| finding.label).collect();
        format!("  - {}: {}\n", labels.join(", "), group[0].advice)
    });
    let unchecked: String = unchecked.collect();
    let title = if unchecked.is_empty() { "" } else { "\nNot checked\n" };
    let end = format!("\n{}\n{title}{unchecked}", headline(findings));
    let meaning = report.map_or_else(ScreenText::default, |report| wrapped(format!("{report}\n")));
    let headers = ["Verdict", "Light", "Found", "Limit (source)"];
    ScreenText::from("\n") + meaning + table::<[Cell; 4]>(&headers, rows) + wrapped(end)
}
