//! `stampflow explain`: what a word means.

use super::code::{BadRequest, Code};
use super::options::{Json, Told};
use super::say::{Shown, say, say_json};
use super::table::{Cell, table, wrapped};
use stampflow::message::{Form, Message, Term, terms};
use stampflow::units::closest;

pub const HELP: &str = "\
Examples:
  stampflow explain \"wrinkle index\"
  stampflow explain Rp0.2
  stampflow explain Niederhalter --lang de
  stampflow explain";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// The word, in any case; without one all are listed
    term: Vec<String>,
    #[command(flatten)]
    told: Told,
    #[command(flatten)]
    json: Json,
}

pub fn explain(args: &Args) -> anyhow::Result<Code> {
    let form = args.told.form();
    let word = args.term.join(" ");
    if word.is_empty() {
        return match args.json.json {
            true => say_json(&terms().iter().map(|term| value(term, form)).collect::<Vec<_>>()),
            false => say(list(form)),
        };
    }
    let Some(term) = Term::of(&word) else { return Err(unknown(&word, form).into()) };
    match args.json.json {
        true => say_json(&value(term, form)),
        false => say(wrapped(&format!("{}\n", told(term, form)))),
    }
}

/// For programs.
fn value(term: &'static Term, form: Form) -> serde_json::Value {
    serde_json::json!({
        "word": form.tell(term.name.as_str()),
        "also": term.also,
        "meaning": form.tell(term.meaning.as_str()),
    })
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

fn unknown(word: &str, form: Form) -> BadRequest {
    let near = closest(word, terms().iter().flat_map(|term| term.words().chain(term.translated())));
    let with = || Term::with(word).map(|term| format!("`{}`", form.tell(term.name.as_str()))).collect::<Vec<_>>();
    let help = match (near.first(), with()) {
        (Some(near), _) => format!("did you mean `{near}`?"),
        (None, with) if !with.is_empty() => format!("did you mean {}?", with.join(" or ")),
        (None, _) => "`stampflow explain` lists the words".to_owned(),
    };
    BadRequest(format!("no word {word:?} is explained here; {help}"))
}
