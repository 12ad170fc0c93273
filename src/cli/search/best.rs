//! The best of several keys: `--minimise`, `--maximise`.

use super::super::code::{BadRequest, Code};
use super::super::many::asked;
use super::super::progress::Progress;
use super::super::say::{say, say_json};
use super::super::table::wrapped;
use super::ask::{Args, Places};
use super::json::{run, shown};
use super::told;
use serde_json::json;
use stampflow::message::{Digits, Message, message};
use stampflow::output::study::search::plot_best;
use stampflow::study::search::{Best, Condition, Named, Sense, optimise_keeping as best_of};
use stampflow::study::{Row, Span, Subject};
use stampflow::units::rounded;
use std::time::Instant;

pub fn optimise(args: &Args, places: &Places) -> anyhow::Result<Code> {
    let (text, sense) = match (&args.minimise, &args.maximise) {
        (Some(text), _) => (text.as_str(), Sense::Least),
        (None, text) => (text.as_deref().unwrap_or_default(), Sense::Most),
    };
    let name = Named::read(text).ok_or_else(|| BadRequest("no number is named to be best".into()))?;
    let subject = Subject::new(&args.case, args.many.overrides.all()).map_err(asked)?;
    let spans =
        args.vary.iter().map(|vary| Span::read(vary, &subject)).collect::<Result<Vec<_>, _>>().map_err(asked)?;
    if !(1..=6).contains(&spans.len()) {
        return Err(BadRequest("a best is looked for over 1 to 6 keys: give each with --vary".into()).into());
    }
    let condition = args.condition.as_deref().map(Condition::read).transpose().map_err(asked)?;
    let count = args.many.count(&args.case, "runs");
    let start = Instant::now();
    let mut keep = |header: &[String], lines: &[Vec<String>]| places.keep(header, lines);
    let found = best_of(&subject, &spans, (&name, sense), condition.as_ref(), args.many.threads(), (&count, &mut keep));
    let found = found.map_err(asked)?;
    let seconds = start.elapsed().as_secs_f64();
    places.table(&found.table.0, &found.table.1)?;
    let form = args.many.told.form();
    places.picture(args, plot_best(&spans, &name, condition.as_ref(), &found, form))?;
    let solution = match found.best.filter(|_| !found.interrupted) {
        Some(best) => {
            let case = subject.case(&found.rows[best].design.settings)?;
            Subject::solution(case, &count).ok()
        }
        None => None,
    };
    let bars = solution.and_then(|solution| args.bars.of(&solution, &Progress::new(true), true));
    let code = match found.best {
        _ if found.interrupted => Code::Interrupted,
        Some(_) => Code::Done,
        None => Code::Failed,
    };
    if args.many.json.json {
        let keys = spans.iter().flat_map(Span::keys).map(stampflow::study::Vary::header);
        let values = found.best.map(|best| {
            let values = found.rows[best].design.values.iter().map(|value| json!(value.number));
            keys.zip(values).collect::<serde_json::Map<_, _>>()
        });
        say_json(&json!({
            "number": name.text,
            "values": values,
            "best": found.best.map(|best| run(f64::NAN, &found.rows[best], bars.as_ref())),
            "binding": found.binding,
            "runs": found.rows.len(),
            "seconds": rounded(seconds),
            "file": shown(&places.table),
        }))?;
        return Ok(code);
    }
    say(wrapped(&format!("{}.", sentence(&spans, &name, condition.as_ref(), &found).told(form))))?;
    if let Some(best) = found.best {
        for said in beside(&found) {
            say(wrapped(&format!("- {}", said.told(form))))?;
        }
        let runs = [(form.tell("best"), &found.rows[best])];
        let named: Vec<&Named> =
            condition.iter().flat_map(Condition::numbers).map(|(name, _)| name).chain([&name]).collect();
        say("\n")?;
        say(told::side_by_side("", &runs, &named, bars.as_ref(), form))?;
    }
    say(told::done(found.rows.len(), seconds, &places.dir, form))?;
    Ok(code)
}

/// The best, with the values of all keys.
fn sentence(spans: &[Span], name: &Named, condition: Option<&Condition>, found: &Best) -> Message {
    let condition = condition.map_or_else(String::new, |condition| condition.text.clone());
    let Some(best) = found.best else {
        return message!("“{condition}” holds in none of {n} runs", condition = condition, n = found.rows.len());
    };
    let row = &found.rows[best];
    let mut values = row.design.values.iter();
    let keys = spans.iter().map(|span| {
        let x = values.by_ref().take(span.keys().len()).next().and_then(|value| value.number);
        message!("{key} = {x}", key = Message::from(span.label()), x = span.told(x.unwrap_or(f64::NAN)))
    });
    let keys = Message::joined(keys, ", ");
    message!("{number} is {value} at {keys}", number = name.text.clone(), value = value(name, row), keys = keys)
}

fn value(name: &Named, row: &Row) -> Message {
    let number = row.result.as_ref().ok().and_then(|solved| name.find(solved).ok());
    number.map_or_else(Message::default, |number| number.amount.to(Digits::Significant(4)).into())
}

fn beside(found: &Best) -> Vec<Message> {
    let mut said = Vec::new();
    if !found.binding.is_empty() {
        said.push(message!("what binds: {parts}", parts = found.binding.join(", ")));
    }
    said.push(message!(
        "{grid} runs over all keys, {steps} from the best of them on",
        grid = found.grid,
        steps = found.rows.len() - found.grid
    ));
    said
}
