//! `stampflow run`: from case files to folders of results.

use super::*;

options! {
    /// Solve cases and write their tables and plots
    Args {
        cases: Vec<PathBuf> = "CASE.toml" [required = true] "Case files; several run side by side",
        out: Option<PathBuf> = "DIR" [long, alias = "output"]
            "Folder for the results, of several cases in a folder of each [default: out/<case>]",
        trace: Option<PathBuf> = "FILE.csv" [long, hide_short_help = true]
            "Also write every iteration of the solver there",
        vtu: bool [long, hide_short_help = true] "Also write the moving section for ParaView",
        animate: bool [long] "Also write shapes.gif, the moving section",
        report: bool [long] "Also write report.html",
        verbose: bool [long, short] "Also print mesh, steps, norms and works",
        error_bars: bool [long] "Compute error bars from finer runs, as `stampflow verify`",
        no_advice: bool [long, hide_short_help = true] "Give no advice: try no changes of a red or amber design",
        strict: bool [long, hide_short_help = true] "End with exit code 4 if the verdict is red",
    } common: Common, pictures: PictureOptions, threads: Threads;
}

const PAGE: &str = "report.html";

pub fn run(args: &Args) -> Result<Code> {
    let several = args.cases.len() > 1;
    let what = "--trace writes the iterations of one case: give one case";
    ensure!(args.trace.is_none() || !several, bad_request(what));
    let (cases, mut failed) = args.common.load_all(&args.cases);
    for (i, case) in cases.iter().enumerate() {
        let twin = cases[..i].iter().find(|other| other.name == case.name);
        let [one, other] = [case, twin.unwrap_or(case)].map(|case| case.path.display());
        let what = format!("{one} and {other} would write into one folder: run them one by one with --out");
        ensure!(twin.is_none(), bad_request(what));
    }
    let jobs = sound(cases.into_iter().map(|case| args.prepare(&case).map(|folder| (case, folder))), &mut failed);
    args.threads.apply()?;
    let progress = args.common.progress();
    // After an interrupt no other case begins.
    let solve = |(case, dir): (Case, _)| caught(&format!("case {}", case.name), || args.solve(case, dir, &progress));
    finish(jobs.into_par_iter().filter(|_| !is_interrupted()).map(solve).collect(), failed, several)
}

impl Args {
    fn prepare(&self, case: &Case) -> Result<(PathBuf, ResultFolder)> {
        self.pictures.pictures()?;
        let dir = match &self.out {
            Some(dir) if self.cases.len() == 1 => dir.clone(),
            out => place::folder(out.as_deref().unwrap_or(Path::new("out")), case)?,
        };
        if let Some(path) = &self.trace {
            place::outside(path, &dir, "--trace")?;
            place::replaced(path, &csv(&tables::iteration_table([].iter())), &case.inputs, "--trace")?;
        }
        let page = dir.join(PAGE);
        let what = format!("{} is there and is no report of ours: choose another folder with --out", page.display());
        ensure!(!self.report || page.symlink_metadata().is_err() || is_report(&page), bad_request(what));
        place::results(case, &dir)?;
        result_folder(case, &dir).map_err(unusable("--out")).map(|folder| (dir, folder))
    }

    fn solve(&self, case: Case, (dir, folder): (PathBuf, ResultFolder), progress: &Progress) -> Result<Output> {
        let mut watch = progress.watch(&case);
        watch.trace = self.trace.as_ref().map(|_| Vec::new());
        let extras = [(self.vtu, Extra::Vtu), (self.animate, Extra::Animation)];
        let extras = extras.into_iter().filter_map(|(is_wanted, extra)| is_wanted.then_some(extra));
        watch.recorder = FrameRecorder::new(extras.collect());
        let solved = Solved::new(watch.solve(case), progress, self.error_bars || self.report, !self.no_advice);
        let Solved { solution, verification, answer, findings } = &solved;
        let verification = verification.as_ref();
        let results = Results::of(solution)?.verified(verification).answered(answer, findings);
        let results = results.with_pictures(&self.pictures.pictures()?);
        let date = page::date(solution.case.title_block.date.clone());
        let page = || Report::answered(solution, verification, (answer.clone(), findings.clone())).dated(date).html();
        // Each is tried whatever became of the other.
        let written = results.write(&watch.recorder, self.report.then(|| (PAGE, page())), folder);
        let traced = self.trace.iter().zip(&watch.trace);
        let traced = traced.map(|(path, rows)| write(path, &csv(&tables::iteration_table(rows.iter().flatten()))));
        let mut output = Output { code: solved.code(self.strict), ..Output::default() };
        if self.common.json() {
            let comparisons = compare::as_json(results.comparisons.iter().map(|one| (&solution.case.name, one)));
            let (verdict, files) = (solved.verdict(), written.as_deref().unwrap_or_default());
            let own = json!({ "verdict": verdict, "comparisons": comparisons, "folder": dir, "files": files });
            output.json = Some(with(serde_json::to_value(CaseSummary::of(solution, &results.views))?, own));
        } else {
            let files: String = written.iter().map(|f| format!("{} files in {}", f.len(), dir.display())).collect();
            let whole = || solved.screen(ScreenText::default()) + self.rest(&results, &files);
            output.screen = if self.cases.len() > 1 && !self.verbose { solved.sentence(&files) } else { whole() };
        }
        output.failed = written.err().into_iter().chain(traced.filter_map(Result::err)).map(Into::into).collect();
        Ok(output)
    }

    fn rest(&self, results: &Results, files: &str) -> ScreenText {
        let summary = CaseSummary::of(results.solution, &results.views);
        let lines = Some(&summary.lines).filter(|lines| !lines.is_empty());
        let text = lines.map_or_else(ScreenText::default, |lines| wrapped(format!("\n{lines}")));
        let stages = summary.stages.iter().filter(|_| self.verbose);
        let text = stages.fold(text, |text, stage| text + "\n" + rows(stage.rows()));
        let comparisons = results.comparisons.iter().map(|comparison| comparison.sentence() + "\n");
        text + wrapped(format!("\n{}{files}\n", comparisons.collect::<String>()))
    }
}
