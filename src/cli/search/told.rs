//! What a search has found, for people.

use super::super::say::Shown;
use super::super::table::{Cell, Tone, table, wrapped};
use stampflow::message::{Amount, Digits, Form, Message, message};
use stampflow::study::Row;
use stampflow::study::search::{Answer, Found, Goal, Named, Quest, Side};
use stampflow::units::{Unit, significant};
use stampflow::verification::{Number, Of, Verification};
use std::ops::RangeInclusive;
use std::path::Path;

/// The answer, what is to be known of it, and the run on either side of it.
pub fn screen(quest: &Quest, answer: &Answer, bars: Option<&Verification>, form: Form) -> Shown {
    let mut shown = wrapped(&format!("{}.", found(quest, answer).told(form)));
    let named: Vec<&Named> = match &quest.goal {
        Goal::Keep(condition) => condition.numbers().map(|(name, _)| name).collect(),
        Goal::Reach(target) => vec![&target.name],
    };
    for said in beside(quest, answer).into_iter().chain(left_open(quest, answer, &named, bars)) {
        shown = shown + wrapped(&format!("- {}", said.told(form)));
    }
    let runs: Vec<usize> = answer.best.into_iter().chain(answer.other).collect();
    let runs: Vec<(String, &Row)> =
        runs.into_iter().map(|run| (quest.span.told(answer.value(run)).told(form), &answer.rows[run])).collect();
    shown + "\n".into() + side_by_side(&form.tell(quest.span.label()), &runs, &named, bars, form)
}

/// What was done, in what time, and where it is.
pub fn done(runs: usize, seconds: f64, dir: &Path, form: Form) -> Shown {
    let time = Amount::time(seconds);
    let told = message!("{n} runs in {time}: {dir}", n = runs, time = time, dir = dir.display().to_string());
    wrapped(&format!("\n{}", told.told(form)))
}

/// The answer in one sentence.
fn found(quest: &Quest, answer: &Answer) -> Message {
    let at = |x: f64| quest.span.told(x);
    let key = Message::from(quest.span.label());
    let [low, high] = quest.span.ends();
    match (&quest.goal, &answer.bracket.found) {
        (_, Found::Interrupted) => {
            message!("{key}: interrupted by the user, {n} runs are kept", key = key, n = answer.rows.len())
        }
        (_, Found::Failed) => {
            message!("{key}: no run came to anything from {low} to {high}", key = key, low = at(low), high = at(high))
        }
        (Goal::Keep(condition), found) => {
            let condition = condition.text.clone();
            match (found, quest.side) {
                (Found::Between([inner, outer]), Side::Largest) => message!(
                    "{key}: “{condition}” holds up to {inner}, at {outer} no more",
                    key = key,
                    condition = condition,
                    inner = at(*inner),
                    outer = at(*outer)
                ),
                (Found::Between([inner, outer]), Side::Smallest) => message!(
                    "{key}: “{condition}” holds from {inner} on, at {outer} not yet",
                    key = key,
                    condition = condition,
                    inner = at(*inner),
                    outer = at(*outer)
                ),
                (Found::Everywhere(x), _) => message!(
                    "{key}: “{condition}” holds to the end of the span, {x}: the limit is beyond it",
                    key = key,
                    condition = condition,
                    x = at(*x)
                ),
                (Found::Open(x), _) => message!(
                    "{key}: “{condition}” holds at {x}, and beyond it no run came to anything",
                    key = key,
                    condition = condition,
                    x = at(*x)
                ),
                _ => message!(
                    "{key}: “{condition}” holds nowhere from {low} to {high}, where {n} runs were made",
                    key = key,
                    condition = condition,
                    low = at(low),
                    high = at(high),
                    n = answer.rows.len()
                ),
            }
        }
        (Goal::Reach(target), _) => reached(quest, answer, &target.name),
    }
}

/// Of a number that shall have a value.
fn reached(quest: &Quest, answer: &Answer, name: &Named) -> Message {
    let key = Message::from(quest.span.label());
    let wanted = answer.wanted.unwrap_or(f64::NAN);
    let told = |row: &Row, value: Option<f64>| {
        let number = row.result.as_ref().ok().and_then(|solved| name.find(solved).ok());
        number.map_or_else(Message::default, |number| match value {
            Some(value) => Amount::new(value, number.amount.unit, Digits::Converted(4)).into(),
            None => number.amount.to(Digits::Significant(4)).into(),
        })
    };
    let rough = |row: &Row, value: f64| told(row, Some(significant(value, 4)));
    if let (Some(best), Found::Between(_)) = (answer.best, &answer.bracket.found) {
        let row = &answer.rows[best];
        return message!(
            "{key} = {x}: {number} is {value}, wanted {wanted}",
            key = key,
            x = quest.span.told(answer.value(best)),
            number = name.text.clone(),
            value = told(row, None),
            wanted = told(row, Some(wanted))
        );
    }
    let decided = answer.bracket.trials.iter().filter_map(|trial| trial.1);
    let [low, high] = decided.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [x.min(low), x.max(high)]);
    let Some(row) = answer.rows.iter().find(|row| row.result.is_ok()) else { return Message::default() };
    message!(
        "{key}: {number} is {low} to {high} over the span, and {wanted} nowhere",
        key = key,
        number = name.text.clone(),
        low = rough(row, wanted + low),
        high = rough(row, wanted + high),
        wanted = told(row, Some(wanted))
    )
}

/// What the error bar of a number leaves open of the key, by the slope of the number over it.
fn left_open(quest: &Quest, answer: &Answer, named: &[&Named], bars: Option<&Verification>) -> Vec<Message> {
    let open = |name: &&Named| {
        let number = name.find(answer.rows[answer.best?].result.as_ref().ok()?).ok()?;
        let half = bars?.bar(number.of, number.key)?.half?;
        let width = significant((half / answer.slope(quest, name)?).abs(), 2);
        let bar = Amount::new(half, number.amount.unit, Digits::Significant(2));
        Some(message!(
            "the error bar of {number}, ± {bar}, leaves ± {width} of it open",
            number = name.text.clone(),
            bar = bar,
            width = quest.span.told(width)
        ))
    };
    named.iter().filter_map(open).collect()
}

/// What is to be known of the answer: its tolerance, the draw ratio, where the condition comes and goes, what failed.
fn beside(quest: &Quest, answer: &Answer) -> Vec<Message> {
    let at = |x: f64| quest.span.told(x);
    let mut said = Vec::new();
    if let Found::Between([inner, outer]) = answer.bracket.found {
        said.push(message!("known within {width}", width = at((outer - inner).abs())));
    }
    if let Some([best, other]) = answer.draw_ratios.filter(|_| matches!(quest.goal, Goal::Keep(_))) {
        let [best, other] = [best, other].map(|ratio| Amount::new(ratio, Unit::None, Digits::Decimals(3)));
        said.push(message!("the draw ratio is {best}, beyond it {other}", best = best, other = other));
    }
    let stretch =
        |range: &RangeInclusive<f64>| message!("{from} to {to}", from = at(*range.start()), to = at(*range.end()));
    let stretches = &answer.bracket.stretches;
    if matches!(quest.goal, Goal::Keep(_)) && stretches.len() > 1 {
        let all = Message::joined(stretches.iter().map(stretch), ", ");
        said.push(message!("it comes and goes over the span, and holds at {stretches}", stretches = all));
    }
    if let Some(mixed) = &answer.bracket.mixed {
        said.push(message!("it comes and goes from {stretch}: more margin than that", stretch = stretch(mixed)));
    }
    if matches!((&quest.goal, &answer.bracket.found), (Goal::Keep(_), Found::Nowhere)) {
        said.extend(often_red(&answer.rows));
    }
    said.extend(
        answer.failed.iter().map(|(why, n)| message!("{n} of the runs say neither: {why}", n = *n, why = why.clone())),
    );
    said
}

/// The row of the verdict that is red in most runs.
fn often_red(rows: &[Row]) -> Option<Message> {
    let solved = rows.iter().flat_map(|row| &row.result);
    let all: Vec<&'static str> = solved.flat_map(|solved| solved.red.iter().map(|key| solved.label(key))).collect();
    let count = |label: &str| all.iter().filter(|red| **red == label).count();
    let most = *all.iter().max_by_key(|label| count(label))?;
    Some(message!("red in {n} of them: {row}", n = count(most), row = most))
}

/// Lights, ends and numbers of runs side by side; those of the first with their error bars.
pub fn side_by_side(
    key: &str,
    runs: &[(String, &Row)],
    named: &[&Named],
    bars: Option<&Verification>,
    form: Form,
) -> Shown {
    let solved: Vec<_> = runs.iter().map(|(_, row)| row.result.as_ref().ok()).collect();
    let two = |mut cells: Vec<Cell>| {
        cells.resize(2, Cell::plain(""));
        cells
    };
    let mut rows: Vec<[Cell; 3]> = Vec::new();
    let mut add = |label: String, cells: Vec<Cell>| {
        if let Ok([first, second]) = <[Cell; 2]>::try_from(two(cells)) {
            rows.push([Cell::plain(label), first, second]);
        }
    };
    let lights = solved.iter().map(|solved| {
        solved.map_or(Cell::plain("–"), |solved| {
            let keys = if solved.red.is_empty() { &solved.amber } else { &solved.red };
            let keys: Vec<String> = keys.iter().map(|key| form.tell(solved.label(key))).collect();
            let light = form.tell(solved.light.name());
            let text = if keys.is_empty() { light } else { format!("{light}: {}", keys.join(", ")) };
            Cell { text, tone: Tone::of(solved.light) }
        })
    });
    add(form.tell("Verdict"), lights.collect());
    let ends =
        solved.iter().map(|solved| Cell::plain(solved.map_or("–".into(), |solved| form.tell(solved.outcome.end.kind))));
    add(form.tell("End"), ends.collect());
    let shown: Vec<&Number> = solved
        .iter()
        .flatten()
        .flat_map(|solved| {
            let own = solved.outcome.numbers.iter().filter(|number| number.of == Of::Answer);
            own.chain(named.iter().filter_map(|name| name.find(solved).ok()))
        })
        .collect();
    let is_first = |i: usize| !shown[..i].iter().any(|known| known.is(shown[i]));
    for number in (0..shown.len()).filter(|i| is_first(*i)).map(|i| shown[i]) {
        let cells = solved.iter().enumerate().map(|(run, solved)| {
            let own = solved.and_then(|solved| solved.outcome.numbers.iter().find(|own| own.is(number)));
            let bar = bars.filter(|_| run == 0).and_then(|bars| bars.bar(number.of, number.key));
            let amount = own.map(|own| bar.filter(|bar| bar.half.is_some()).map_or(own.amount, |bar| bar.amount()));
            Cell::plain(amount.map_or_else(|| "–".into(), |amount| amount.told(form)))
        });
        add(form.tell(number.label), cells.collect());
    }
    let values: Vec<&str> = runs.iter().map(|(value, _)| value.as_str()).chain(["", ""]).take(2).collect();
    if runs.is_empty() { Shown::default() } else { table(Some([key, values[0], values[1]]), rows) }
}
