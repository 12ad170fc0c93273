//! Options that several verbs have.

use stampflow::case::TitleBlock;

/// The option of every verb that has a result.
#[derive(Debug, clap::Args)]
pub struct Json {
    /// Print JSON for programs instead, and errors as JSON too; shows no progress
    #[arg(long)]
    pub json: bool,
}

impl Json {
    /// Whether the command line asks for JSON, be the rest of it right or wrong.
    pub fn is_asked_for() -> bool {
        std::env::args_os().any(|arg| arg == "--json")
    }
}

/// The option of every verb that reads a case.
#[derive(Debug, clap::Args)]
pub struct Overrides {
    /// Replace what the case says: a dotted path of keys and a value with its unit, as often as needed
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

/// The option of every verb that solves several cases.
#[derive(Debug, clap::Args)]
pub struct Threads {
    /// Threads for cases that run side by side, at most 256 [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
}

impl Threads {
    /// Makes it so, once and before anything runs.
    pub fn apply(&self) -> anyhow::Result<()> {
        if let Some(threads) = self.threads {
            rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global()?;
        }
        Ok(())
    }
}

/// What a report's title block says in place of the case's `[report]`.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Title block, in place of what the case's [report] says")]
pub struct Titles {
    /// Name of the part
    #[arg(long, value_name = "TEXT")]
    part: Option<String>,
    /// Number of the part or its drawing
    #[arg(long, value_name = "TEXT")]
    number: Option<String>,
    /// Revision of the part or its drawing
    #[arg(long, value_name = "TEXT")]
    revision: Option<String>,
    /// Who answers for the report
    #[arg(long, value_name = "TEXT")]
    author: Option<String>,
    /// For whom the author works
    #[arg(long, value_name = "TEXT")]
    company: Option<String>,
    /// Day of the report, as it is to be written
    #[arg(long, value_name = "TEXT")]
    date: Option<String>,
}

impl Titles {
    /// As a report takes it.
    pub fn title_block(&self) -> TitleBlock {
        let Self { part, number, revision, author, company, date } = self;
        let [part, number, revision, author, company, date] =
            [part, number, revision, author, company, date].map(Clone::clone);
        TitleBlock { part, number, revision, author, company, date }
    }
}
