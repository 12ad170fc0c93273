//! `stampflow report`: a case solved and written as one HTML page.

use super::{compare::Variants, compare::to_compare, *};

options! {
    /// Solve a case and write a report, one HTML page
    Args {
        case: PathBuf [] "Case file",
        output: Option<PathBuf> = "FILE" [long, short, alias = "out"]
            "The file to write [default: out/<case>/report.html]",
        against: Vec<PathBuf> = "CASE.toml|CURVE.csv" [long]
            "Compare with another case or with measured curves; as often as needed",
        date: Option<String> = "DATE" [long] "Date in the title block, or none [default: the case's, else today]",
        no_error_bars: bool [long, hide_short_help = true] "Skip the finer runs for error bars",
        no_advice: bool [long, hide_short_help = true] "Give no advice: try no changes of a red or amber design",
        force: bool [long, hide_short_help = true] "Replace a file that is no report, too",
    } variants: Variants, common: Common;
}

pub fn report(args: &Args) -> Result<Code> {
    let case = args.common.overrides.load(&args.case)?;
    let path = args.page(&case)?;
    place::file(&path, &case.inputs, "--output")?;
    can_write(&path).map_err(unusable("--output"))?;
    let files: Vec<PathBuf> = std::iter::once(&args.case).chain(&args.against).cloned().collect();
    let is_compared = files.len() > 1 || !args.variants.also.is_empty();
    let compared = is_compared.then(|| to_compare(&files, &args.variants, &args.common.overrides.all())).transpose()?;
    let progress = args.common.progress();
    let solved = Solved::new(progress.watch(&case).solve(case), &progress, !args.no_error_bars, !args.no_advice);
    let Solved { solution, verification, answer, findings } = &solved;
    let versus = compared.map(|(candidates, curves)| {
        let count = progress.count(format!("{}, compared", solution.case.name));
        let bars = verification.clone().unwrap_or_else(|| stampflow::study::verify::verify(solution, &count).bars);
        let (first, threads) = (Some((solution.clone(), bars)), Threads { threads: None }.count());
        SideBySide::solve(&candidates, curves, first, threads, &count)
    });
    let report = Report::answered(solution, verification.as_ref(), (answer.clone(), findings.clone()));
    let report = report.dated(page::date(args.date.clone().or(solution.case.title_block.date.clone())));
    let versus = versus.transpose()?;
    let report = versus.iter().fold(report, Report::against);
    let written = write(&path, report.html().as_bytes());
    let value = with(report.json(), json!({ "files": written.iter().map(|()| &path).collect::<Vec<_>>() }));
    emit(args.common.json(), value, || match &written {
        Ok(()) => solved.sentence(&format!("{} is written", path.display())),
        Err(_) => solved.screen(ScreenText::default()),
    })?;
    written?;
    Ok(solved.code(false))
}

impl Args {
    fn page(&self, case: &Case) -> Result<PathBuf> {
        let default = || place::folder(Path::new("out"), case).map(|folder| folder.join("report.html"));
        let path = self.output.clone().map_or_else(default, Ok)?;
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("html");
        let what = format!("a report is an HTML page, not .{ending}: write -o NAME.html; a browser prints it as PDF");
        ensure!(matches!(ending, "html" | "htm"), bad_request(what));
        let is_free = self.force || path.symlink_metadata().is_err() || path.is_dir() || is_report(&path);
        let what = "is there and is no report of ours: choose another name with -o, or replace it with --force";
        ensure!(is_free, bad_request(format!("{} {what}", path.display())));
        Ok(path)
    }
}
