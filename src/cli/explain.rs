//! `stampflow explain`: what a word means.

use super::code::{BadRequest, Code};
use super::options::Told;
use super::say::{Shown, say};
use super::table::{Cell, table, wrapped};
use stampflow::message::{Form, Message, Term, terms};
use stampflow::units::closest;

pub const HELP: &str = "\
Examples:
  stampflow explain \"wrinkle index\"
  stampflow explain Rp0.2
  stampflow explain";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// The word, in any case; without one all are listed
    term: Vec<String>,
    #[command(flatten)]
    told: Told,
}

pub fn explain(args: &Args) -> anyhow::Result<Code> {
    let form = args.told.form();
    let word = args.term.join(" ");
    if word.is_empty() {
        return say(list(form));
    }
    let Some(term) = Term::of(&word) else { return Err(unknown(&word).into()) };
    say(wrapped(&format!("{}\n", told(term, form))))
}

/// `thinning: how much ...`
fn told(term: &'static Term, form: Form) -> String {
    let also = if term.also.is_empty() { String::new() } else { format!(" ({})", term.also.join(", ")) };
    format!(
        "{}{also}: {}",
        Message::from(term.name.as_str()).told(form),
        Message::from(term.meaning.as_str()).told(form)
    )
}

fn list(form: Form) -> Shown {
    let row = |term: &'static Term| {
        [Cell::plain(Message::from(term.name.as_str()).told(form)), Cell::plain(term.also.join(", "))]
    };
    table(None, terms().iter().map(row).collect())
}

fn unknown(word: &str) -> BadRequest {
    let near = closest(word, terms().iter().flat_map(Term::words));
    let help = match near.first() {
        Some(near) => format!("did you mean `{near}`?"),
        None => "`stampflow explain` lists the words".to_owned(),
    };
    BadRequest(format!("no word {word:?} is explained here; {help}"))
}
