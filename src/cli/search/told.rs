//! What a search has found, for people.

use super::super::say::Shown;
use super::super::table::{Cell, Tone, table, wrapped};
use stampflow::study::Row;
use stampflow::study::search::{Answer, Named, Quest};
use stampflow::study::verify::{Number, Of, Verification};
use stampflow::units::Amount;
use std::path::Path;

/// The answer, what is to be known of it, and the run on either side of it.
pub fn screen(quest: &Quest, answer: &Answer, bars: Option<&Verification>) -> Shown {
    let mut shown = wrapped(&format!("{}.", quest.sentence(answer).to_string()));
    for said in quest.sentences(answer, bars) {
        shown = shown + wrapped(&format!("- {}", said.to_string()));
    }
    let runs: Vec<usize> = answer.best.into_iter().chain(answer.other).collect();
    let runs: Vec<(String, &Row)> =
        runs.into_iter().map(|run| (quest.span.told(answer.value(run)).to_string(), &answer.rows[run])).collect();
    shown + "\n".into() + side_by_side(&String::from(quest.span.label()), &runs, &quest.named(), bars)
}

/// What was done, in what time, and where it is.
pub fn done(runs: usize, seconds: f64, dir: &Path) -> Shown {
    let time = Amount::time(seconds);
    let told = format!("{runs} runs in {time}: {dir}", dir = dir.display());
    wrapped(&format!("\n{}", told.to_string()))
}

/// Lights, ends and numbers of runs side by side; those of the first with their error bars.
pub fn side_by_side(key: &str, runs: &[(String, &Row)], named: &[&Named], bars: Option<&Verification>) -> Shown {
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
            let keys: Vec<String> = keys.iter().map(|key| String::from(solved.label(key))).collect();
            let light = String::from(solved.light.name());
            let text = if keys.is_empty() { light } else { format!("{light}: {}", keys.join(", ")) };
            Cell { text, tone: Tone::of(solved.light) }
        })
    });
    add(String::from("Verdict"), lights.collect());
    let ends = solved
        .iter()
        .map(|solved| Cell::plain(solved.map_or("–".into(), |solved| String::from(solved.outcome.end.kind))));
    add(String::from("End"), ends.collect());
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
            Cell::plain(amount.map_or_else(|| "–".into(), |amount| amount.to_string()))
        });
        add(String::from(number.label), cells.collect());
    }
    let values: Vec<&str> = runs.iter().map(|(value, _)| value.as_str()).chain(["", ""]).take(2).collect();
    if runs.is_empty() { Shown::default() } else { table(Some([key, values[0], values[1]]), rows) }
}
