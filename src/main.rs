//! The command line. A case file that is dropped on the program, its only argument, gets a report beside it.

mod bug;
mod cli;

use std::{ffi::OsString, io::IsTerminal, io::stdin, path::Path, process::ExitCode};

fn main() -> ExitCode {
    let words: Vec<OsString> = std::env::args_os().collect();
    let Some(words) = report_on_dropped(&words) else { return cli::main(&words) };
    let code = cli::main(&words);
    if cfg!(windows) || stdin().is_terminal() {
        eprintln!("Press Enter to close this window.");
        let _ = stdin().read_line(&mut String::new());
    }
    code
}

/// Command line of the report `cup_report.html` beside `cup.toml`, the only argument.
fn report_on_dropped(words: &[OsString]) -> Option<Vec<OsString>> {
    let [program, case] = words else { return None };
    let (path, mut page) = (Path::new(case), Path::new(case).file_stem()?.to_owned());
    page.push("_report.html");
    let report =
        [program.clone(), "report".into(), "-o".into(), path.with_file_name(page).into(), "--".into(), case.clone()];
    path.extension()?.eq_ignore_ascii_case("toml").then(|| report.into())
}
