//! `stampflow run`: from case files to folders of results.

use super::code::{BadRequest, unusable};
use super::job::{Job, Solved, solve_all};
use super::progress::{Kept, Progress};
use super::reel::Reels;
use super::{Code, Overrides, Threads, say};
use stampflow::output::{OUTPUTS, Summary, can_write, can_write_all, csv, trace, write};
use std::fmt::Write;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case files; several run side by side
    #[arg(required = true, value_name = "CASE.toml")]
    cases: Vec<PathBuf>,
    /// Folder for the results [default: out/<case>]; with several cases DIR/<case>
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overrides: Overrides,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    /// Also write every iteration of the solver to this file (one case only)
    #[arg(long, value_name = "FILE.csv")]
    trace: Option<PathBuf>,
    /// Also write the kept frames for ParaView: section.pvd, tools.pvd and, axisymmetric, revolved.pvd
    #[arg(long)]
    vtu: bool,
    /// Also write shapes.gif, the section and the load as they move
    #[arg(long)]
    animate: bool,
    #[command(flatten)]
    threads: Threads,
}

/// What is written, from the list that writes it.
pub fn help() -> String {
    let mut help = String::from(
        "Written, each file complete or not at all; what an earlier run left in the folder is replaced:\n",
    );
    for output in OUTPUTS {
        let _ = writeln!(help, "  {:<18} {}", output.file, output.about);
    }
    help + "  section.pvd, ...   with --vtu: every kept frame for ParaView, with its tools and, axisymmetric, turned about the axis\n  \
            shapes.gif         with --animate: the section and the load as they move\n\
            \x20 compare_*.png, csv overlay and differences for every reference the case is compared with\n\
            Of a case with several stages each has a folder of its own, 1-draw, 2-retract, ..., and stages.csv sums them up\n\n\
            Examples:\n  \
            stampflow run cases/quickstart.toml\n  \
            stampflow run cases/quickstart.toml --set tools.punch.friction=0.1 --out out/friction-0.1\n  \
            stampflow run cases/*.toml --out results --quiet\n\n\
            Exit codes: 0 done (full travel or time, or the contact share asked for), 2 bad input (nothing is written), 3 stopped early (results are kept), 1 anything else"
}

pub fn run(args: &Args) -> anyhow::Result<Code> {
    if args.trace.is_some() && args.cases.len() > 1 {
        return Err(BadRequest("--trace writes the iterations of one case: give one case".to_owned()).into());
    }
    let jobs = load(args)?;
    let several = jobs.len() > 1;
    for job in &jobs {
        can_write_all(&folder(args, several, &job.case.name)).map_err(unusable("--out"))?;
    }
    if let Some(path) = &args.trace {
        can_write(path).map_err(unusable("--trace"))?;
    }
    args.threads.apply()?;
    let progress = Progress::new(args.quiet);
    let reports = solve_all(
        jobs,
        |case| {
            let kept =
                Kept { trace: args.trace.as_ref().map(|_| Vec::new()), reels: args.animate.then(Reels::default) };
            progress.watch(&case.name, &case.model, kept)
        },
        |solved| {
            let dir = folder(args, several, solved.name());
            let files = solved.write(&dir, args.vtu)?;
            if let (Some(path), Some(iterations)) = (&args.trace, &solved.kept.trace) {
                write(path, &csv(&trace::table(iterations)))?;
            }
            Ok((report(&solved, &dir, files.len()), solved.is_complete()))
        },
    );
    let mut code = Code::Done;
    let mut failure = None;
    for report in reports {
        match report {
            Ok((text, complete)) => {
                say(&if several { text + "\n" } else { text })?;
                code = if complete { code } else { Code::StoppedEarly };
            }
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    failure.map_or(Ok(code), Err)
}

/// All cases, or the first thing that is wrong with one of them.
fn load(args: &Args) -> anyhow::Result<Vec<Job>> {
    let mut jobs: Vec<Job> = Vec::new();
    for path in &args.cases {
        let job = Job::load(path, &args.overrides.set)?;
        if let Some(other) = jobs.iter().find(|other| other.case.name == job.case.name) {
            return Err(BadRequest(format!(
                "{} and {} would write into one folder: run them one by one with --out",
                other.case.path.display(),
                path.display()
            ))
            .into());
        }
        jobs.push(job);
    }
    Ok(jobs)
}

fn folder(args: &Args, several: bool, name: &str) -> PathBuf {
    match &args.out {
        Some(dir) if several => dir.join(name),
        Some(dir) => dir.clone(),
        None => Path::new("out").join(name),
    }
}

fn report(solved: &Solved, dir: &Path, files: usize) -> String {
    let summaries = solved.subjects().map(|subject| Summary::of(&subject).to_string());
    let mut text = summaries.collect::<Vec<_>>().join("\n");
    let stages = solved.stages();
    if !stages.is_empty() {
        let _ = writeln!(text, "\nStages\n{stages}");
    }
    for comparison in &solved.comparisons {
        let _ = writeln!(text, "{}", comparison.sentence());
    }
    let _ = writeln!(text, "{files} files in {}", dir.display());
    text
}
