//! `stampflow report`: a case solved and written as pages for people.

use super::code::{BadRequest, Code, unusable};
use super::compare::{Variants, to_compare};
use super::error_bars::ErrorBars;
use super::job;
use super::many::asked;
use super::options::{self, Json, Overrides};
use super::place;
use super::progress::{Kept, Progress};
use super::say::{say, say_json};
use super::titles::Titles;
use clap::ValueEnum;
use serde_json::json;
use stampflow::message::message;
use stampflow::output::{Extra, FrameRecorder, can_write, is_report, remove_others, write};
use stampflow::report::{Document, Report, figure_folder, html, is_figure, markdown, pdf};
use stampflow::study::verify::quick;
use stampflow::study::versus::Asked;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;

pub const HELP: &str = "\
The HTML file holds its pictures and needs nothing else. The PDF file has A4 pages with numbers and contents. Markdown comes
with its pictures as SVG files in a folder beside it, report_figures. Each number has its error bar, estimated from one
coarser run, or from finer runs with --error-bars. A report of an earlier run is replaced; any other file is left alone.

Examples:
  stampflow report cases/quickstart.toml
  stampflow new cup -o cup.toml
  stampflow report cup.toml -o cup_report.html
  stampflow report cases/hat_springback.toml -o hat.html --set tools.punch.friction=0.1
  stampflow report cases/quickstart.toml -o cup.pdf --part Cup --number 4711 --revision B --author Ito
  stampflow report cases/quickstart.toml -o cup.md
  stampflow report cases/quickstart.toml --also friction=0.12
  stampflow report cases/quickstart.toml --json

Exit codes: 0 done, 2 bad input (nothing is written), 3 stopped early (the report says where and why), 130 interrupted, 1 anything else";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case file
    case: PathBuf,
    #[command(flatten)]
    overrides: Overrides,
    /// The file to write [default: out/<case>/report.html]
    #[arg(long, short, alias = "out", value_name = "FILE")]
    output: Option<PathBuf>,
    /// Kind of file [default: by the ending of FILE, else html]
    #[arg(long)]
    format: Option<Format>,
    /// Let the reader move the section over the travel, by a slider (HTML only; a MB more)
    #[arg(long)]
    slider: bool,
    /// Beside the case: another case, or a CSV file of measured curves; as often as needed (see stampflow compare)
    #[arg(long, value_name = "CASE.toml|CURVE.csv")]
    against: Vec<PathBuf>,
    #[command(flatten)]
    variants: Variants,
    /// Replace a file that is no report, too
    #[arg(long)]
    force: bool,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    json: Json,
    #[command(flatten)]
    bars: ErrorBars,
    #[command(flatten)]
    form: options::Told,
    #[command(flatten)]
    titles: Titles,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    Html,
    Md,
    Pdf,
}

impl Format {
    /// The file's name where none is given.
    fn name(self) -> &'static str {
        match self {
            Self::Html => "report.html",
            Self::Md => "report.md",
            Self::Pdf => "report.pdf",
        }
    }
}

pub fn report(args: &Args) -> anyhow::Result<Code> {
    let case = job::load(&args.case, &args.overrides.all())?;
    let format = args.format()?;
    if args.slider && format != Format::Html {
        return Err(BadRequest(
            "a slider moves only on an HTML page: leave out --slider, or write -o NAME.html".into(),
        )
        .into());
    }
    let path = match &args.output {
        Some(path) => path.clone(),
        None => place::folder(Path::new("out"), &case)?.join(format.name()),
    };
    if !args.force {
        refuse_others(&path, format)?;
    }
    place::file(&path, &case.inputs, "--output")?;
    let beside = args.beside()?;
    if format == Format::Md {
        can_write(&figure_folder(&path).join("figure.svg")).map_err(unusable("--output"))?;
    }

    let extras = args.slider.then_some(Extra::Animation);
    let kept = Kept { trace: None, recorder: FrameRecorder::new(extras.into_iter().collect()) };
    let progress = Progress::new(args.quiet || args.json.json);
    let (solution, kept) = progress.watch(&case, kept).solve(case);
    let verification = args.bars.of(&solution, &progress, true);
    let versus = beside.map(|all| {
        let bars = verification.clone().unwrap_or_else(|| quick(&solution, &()));
        let threads = available_parallelism().map_or(1, usize::from);
        all.solve(Some((solution.clone(), bars)), threads, &progress.count(format!("{}, compared", solution.case.name)))
    });
    let versus = versus.transpose().map_err(asked)?;
    let report = Report::verified(&solution, verification.as_ref()).titled(args.titles.title_block());
    let report = versus.iter().fold(report, Report::against);
    let report = if args.slider { report.moving(&kept.recorder) } else { report };
    let form = args.form.form();
    let saved = save(&report.told(form), &path, format);
    let said = match (&saved, args.json.json) {
        (_, true) => {
            let mut value = report.json();
            value["files"] = json!(saved.as_deref().unwrap_or_default());
            say_json(&value)
        }
        (Ok(_), false) => say(form.tell(message!("{file} is written", file = path.display().to_string()))),
        // What was computed is told at least.
        (Err(_), false) => say(solution.summary().told(form)),
    };
    saved?;
    said?;
    Ok(if solution.is_complete() { Code::Done } else { Code::StoppedEarly })
}

/// Writes the pictures first: a text that is there has all of them. An earlier report's go.
fn save(document: &Document, path: &Path, format: Format) -> anyhow::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let bytes = match format {
        Format::Html => html(document).into_bytes(),
        Format::Pdf => pdf(document),
        Format::Md => {
            let folder = figure_folder(path);
            let name = folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
            let (text, pictures) = markdown(document, &name);
            for (name, svg) in pictures {
                let file = folder.join(name);
                write(&file, svg.as_bytes())?;
                files.push(file);
            }
            remove_others(&folder, &files, is_figure)?;
            text.into_bytes()
        }
    };
    write(path, &bytes)?;
    files.insert(0, path.to_owned());
    Ok(files)
}

/// A file of someone else's stays, and so does a folder where our pictures would go without a report beside it.
fn refuse_others(path: &Path, format: Format) -> Result<(), BadRequest> {
    let refuse = |what: &Path| {
        let what = what.display();
        Err(BadRequest(format!(
            "{what} is there and is no report of ours: choose another name with -o, or replace it with --force"
        )))
    };
    let is_there = path.symlink_metadata().is_ok();
    if is_there && !path.is_dir() && !is_report(path) {
        return refuse(path);
    }
    let folder = figure_folder(path);
    if format == Format::Md && !is_there && folder.symlink_metadata().is_ok() { refuse(&folder) } else { Ok(()) }
}

impl Args {
    /// The case with all that it is compared with, where it is.
    fn beside(&self) -> anyhow::Result<Option<Asked>> {
        if self.against.is_empty() && self.variants.also.is_empty() {
            return Ok(None);
        }
        let files: Vec<PathBuf> = std::iter::once(&self.case).chain(&self.against).cloned().collect();
        to_compare(&files, &self.variants, &self.overrides.all()).map(Some)
    }

    /// As asked for, or by the file's ending.
    fn format(&self) -> Result<Format, BadRequest> {
        let ending = self.output.as_ref().and_then(|path| path.extension()).map(|ending| ending.to_string_lossy());
        match (self.format, ending.as_deref()) {
            (Some(format), _) => Ok(format),
            (None, None | Some("html" | "htm")) => Ok(Format::Html),
            (None, Some("md" | "markdown")) => Ok(Format::Md),
            (None, Some("pdf")) => Ok(Format::Pdf),
            (None, Some(other)) => Err(BadRequest(format!(
                "a report is no .{other} file: write -o NAME.html, NAME.pdf or NAME.md, or give --format html, pdf or md with any name"
            ))),
        }
    }
}
