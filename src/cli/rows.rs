//! Which rows of a study's table are run, and what becomes of those that an earlier run has left.

use super::code::BadRequest;
use super::say::warn;
use stampflow::study::{Earlier, Journal, Shard};

/// So many runs are begun without a word.
const MANY: u64 = 100_000;

/// The options of every verb whose rows are known by their indices.
#[derive(Debug, clap::Args)]
pub struct Rows {
    /// Go on with the rows that an earlier run has left, once no other run is at it
    #[arg(long)]
    resume: bool,
    /// Remove the rows that an earlier run has left
    #[arg(long, conflicts_with = "resume")]
    restart: bool,
    /// Run one part of so many, such as 7/64, into a table of its own
    #[arg(long, value_name = "K/N")]
    shard: Option<Shard>,
    /// Begin more than 100 000 runs without asking
    #[arg(long)]
    yes: bool,
}

impl Rows {
    /// The part that is run.
    pub fn shard(&self) -> Shard {
        self.shard.unwrap_or(Shard::WHOLE)
    }

    /// The indices of its designs, of so many; where there are very many of them without having been meant, `fewer` says how to
    /// ask for less.
    pub fn indices(&self, designs: u64, fewer: &str) -> anyhow::Result<Vec<u64>> {
        let runs = self.shard().count(designs);
        if runs > MANY && !self.yes {
            let what = format!("{runs} runs are asked for, more than {MANY}");
            return Err(BadRequest(format!("{what}: give --yes if that is meant, or {fewer}, or --shard")).into());
        }
        Ok(self.shard().indices(designs))
    }

    /// What becomes of rows that are there.
    pub fn earlier(&self) -> Earlier {
        match (self.resume, self.restart) {
            (true, _) => Earlier::Resume,
            (_, true) => Earlier::Restart,
            _ => Earlier::Refuse,
        }
    }
}

/// Whether all rows of a journal are there; where not, says how to go on.
pub fn all_there(journal: &Journal, all: usize) -> bool {
    let done = journal.done();
    if done < all {
        warn(format!("{done} of {all} runs are in {}; --resume goes on with the others", journal.part().display()));
    }
    done == all
}
