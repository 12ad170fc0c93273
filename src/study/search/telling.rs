//! What a search has found, in sentences.

use super::{Answer, Best, Found, Goal, Named, Quest, Side, Wish};
use crate::study::Row;
use crate::study::verify::Verification;
use crate::units::{Amount, Digits, joined};
use crate::units::{Unit, significant};
use std::ops::RangeInclusive;

impl Quest {
    /// The answer in one sentence.
    pub fn sentence(&self, answer: &Answer) -> String {
        found(self, answer)
    }

    /// What is to be known of the answer, and what error bars of its run leave open.
    pub fn sentences(&self, answer: &Answer, bars: Option<&Verification>) -> Vec<String> {
        let open = left_open(self, answer, &self.named(), bars);
        beside(self, answer).into_iter().chain(open).collect()
    }

    /// The numbers that it is about.
    pub fn named(&self) -> Vec<&Named> {
        match &self.goal {
            Goal::Keep(condition) => condition.numbers().map(|(name, _)| name).collect(),
            Goal::Reach(target) => vec![&target.name],
        }
    }
}

impl Wish {
    /// The best, with the values of all keys.
    pub fn sentence(&self, found: &Best) -> String {
        let condition = self.condition.as_ref().map_or_else(String::new, |condition| condition.text.clone());
        let Some(best) = found.best else {
            return format!("“{condition}” holds in none of {n} runs", n = found.rows.len());
        };
        let row = &found.rows[best];
        let mut values = row.design.values.iter();
        let keys = self.spans.iter().map(|span| {
            let x = values.by_ref().take(span.keys().len()).next().and_then(|value| value.number);
            format!("{key} = {x}", key = span.label(), x = span.told(x.unwrap_or(f64::NAN)))
        });
        let keys = joined(keys, ", ");
        let number = row.result.as_ref().ok().and_then(|solved| self.number.find(solved).ok());
        let value = number.map_or_else(String::new, |number| number.amount.to(Digits::Significant(4)).into());
        format!("{number} is {value} at {keys}", number = self.number.text)
    }
}

impl Best {
    /// What is to be known of it; nothing where no run keeps the condition.
    pub fn sentences(&self) -> Vec<String> {
        if self.best.is_none() {
            return Vec::new();
        }
        let binds = (!self.binding.is_empty()).then(|| format!("what binds: {parts}", parts = self.binding.join(", ")));
        let runs = format!(
            "{grid} runs over all keys, {steps} from the best of them on",
            grid = self.grid,
            steps = self.rows.len() - self.grid
        );
        binds.into_iter().chain([runs]).collect()
    }
}

fn found(quest: &Quest, answer: &Answer) -> String {
    let at = |x: f64| quest.span.told(x);
    let key = String::from(quest.span.label());
    let [low, high] = quest.span.ends();
    match (&quest.goal, &answer.bracket.found) {
        (_, Found::Interrupted) => {
            format!("{key}: interrupted by the user, {n} runs are kept", n = answer.rows.len())
        }
        (_, Found::Failed) => {
            format!("{key}: no run came to anything from {low} to {high}", low = at(low), high = at(high))
        }
        (Goal::Keep(condition), found) => {
            let condition = condition.text.clone();
            match (found, quest.side) {
                (Found::Between([inner, outer]), Side::Largest) => format!(
                    "{key}: “{condition}” holds up to {inner}, at {outer} no more",
                    inner = at(*inner),
                    outer = at(*outer)
                ),
                (Found::Between([inner, outer]), Side::Smallest) => format!(
                    "{key}: “{condition}” holds from {inner} on, at {outer} not yet",
                    inner = at(*inner),
                    outer = at(*outer)
                ),
                (Found::Everywhere(x), _) => format!(
                    "{key}: “{condition}” holds to the end of the span, {x}: the limit is beyond it",
                    x = at(*x)
                ),
                (Found::Open(x), _) => {
                    format!("{key}: “{condition}” holds at {x}, and beyond it no run came to anything", x = at(*x))
                }
                _ => format!(
                    "{key}: “{condition}” holds nowhere from {low} to {high}, where {n} runs were made",
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
fn reached(quest: &Quest, answer: &Answer, name: &Named) -> String {
    let key = String::from(quest.span.label());
    let wanted = answer.wanted.unwrap_or(f64::NAN);
    let told = |row: &Row, value: Option<f64>| {
        let number = row.result.as_ref().ok().and_then(|solved| name.find(solved).ok());
        number.map_or_else(String::new, |number| match value {
            Some(value) => Amount::new(value, number.amount.unit, Digits::Converted(4)).into(),
            None => number.amount.to(Digits::Significant(4)).into(),
        })
    };
    let rough = |row: &Row, value: f64| told(row, Some(significant(value, 4)));
    if let (Some(best), Found::Between(_)) = (answer.best, &answer.bracket.found) {
        let row = &answer.rows[best];
        if let Some([from, to]) = answer.jump() {
            return format!(
                "{key} = {x}: {number} is {value}, not {wanted}: it jumps from {from} to {to} there",
                x = quest.span.told(answer.value(best)),
                number = name.text,
                value = told(row, None),
                wanted = told(row, Some(wanted)),
                from = rough(row, from),
                to = rough(row, to)
            );
        }
        return format!(
            "{key} = {x}: {number} is {value}, wanted {wanted}",
            x = quest.span.told(answer.value(best)),
            number = name.text,
            value = told(row, None),
            wanted = told(row, Some(wanted))
        );
    }
    let decided = answer.bracket.trials.iter().filter_map(|trial| trial.1);
    let [low, high] = decided.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [x.min(low), x.max(high)]);
    let Some(row) = answer.rows.iter().find(|row| row.result.is_ok()) else { return String::new() };
    format!(
        "{key}: {number} is {low} to {high} over the span, and {wanted} nowhere",
        number = name.text,
        low = rough(row, wanted + low),
        high = rough(row, wanted + high),
        wanted = told(row, Some(wanted))
    )
}

/// What the error bar of a number leaves open of the key, by the slope of the number over it.
fn left_open(quest: &Quest, answer: &Answer, named: &[&Named], bars: Option<&Verification>) -> Vec<String> {
    let open = |name: &&Named| {
        let number = name.find(answer.rows[answer.best?].result.as_ref().ok()?).ok()?;
        let half = bars?.bar(number.of, number.key)?.half?;
        let width = significant((half / answer.slope(quest, name)?).abs(), 2);
        let bar = Amount::new(half, number.amount.unit, Digits::Significant(2));
        Some(format!(
            "the error bar of {number}, ± {bar}, leaves ± {width} of it open",
            number = name.text,
            width = quest.span.difference(width)
        ))
    };
    named.iter().filter_map(open).collect()
}

/// What is to be known of the answer: its tolerance, the draw ratio, where the condition comes and goes, what failed.
fn beside(quest: &Quest, answer: &Answer) -> Vec<String> {
    let at = |x: f64| quest.span.told(x);
    let mut said = Vec::new();
    if let Found::Between([inner, outer]) = answer.bracket.found {
        said.push(format!("known within {width}", width = quest.span.difference(outer - inner)));
    }
    if let Some([best, other]) = answer.draw_ratios.filter(|_| matches!(quest.goal, Goal::Keep(_))) {
        let [best, other] = [best, other].map(|ratio| Amount::new(ratio, Unit::None, Digits::Decimals(3)));
        said.push(format!("the draw ratio is {best}, beyond it {other}"));
    }
    let stretch =
        |range: &RangeInclusive<f64>| format!("{from} to {to}", from = at(*range.start()), to = at(*range.end()));
    let stretches = &answer.bracket.stretches;
    if matches!(quest.goal, Goal::Keep(_)) && stretches.len() > 1 {
        let all = joined(stretches.iter().map(stretch), ", ");
        said.push(format!("it comes and goes over the span, and holds at {all}"));
    }
    if let Some(mixed) = &answer.bracket.mixed {
        said.push(format!("it comes and goes from {stretch}: more margin than that", stretch = stretch(mixed)));
    }
    if matches!((&quest.goal, &answer.bracket.found), (Goal::Keep(_), Found::Nowhere)) {
        said.extend(often_red(&answer.rows));
    }
    said.extend(
        answer.best.filter(|_| matches!(quest.goal, Goal::Keep(_))).and_then(|best| unasked(&answer.rows[best])),
    );
    said.extend(answer.failed.iter().map(|(why, n)| format!("{n} of the runs say neither: {why}", n = *n)));
    said
}

/// What is red at the answer, for the condition does not ask for it.
fn unasked(row: &Row) -> Option<String> {
    let solved = row.result.as_ref().ok().filter(|solved| !solved.red.is_empty())?;
    let rows = joined(solved.red.iter().map(|key| String::from(solved.label(key))), ", ");
    Some(format!("red there, which the condition does not ask for: {rows}; all other keys stay as the case has them"))
}

/// The row of the verdict that is red in most runs.
fn often_red(rows: &[Row]) -> Option<String> {
    let solved = rows.iter().flat_map(|row| &row.result);
    let all: Vec<&'static str> = solved.flat_map(|solved| solved.red.iter().map(|key| solved.label(key))).collect();
    let count = |label: &str| all.iter().filter(|red| **red == label).count();
    let most = *all.iter().max_by_key(|label| count(label))?;
    Some(format!("red in {n} of them: {most}", n = count(most)))
}
