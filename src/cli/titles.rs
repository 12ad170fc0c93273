//! Options of a report's title block.

use stampflow::case::TitleBlock;

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
