//! The answer on screen: the verdict's sentence, red and amber findings with what to change, key numbers.

use super::screen::{Cell, ScreenText, highlighted, table, wrapped};
use stampflow::assess::{Answer, Finding, Kind, Light, by_advice, judgements, sentences, size_doubts};
use stampflow::case::Case;
use stampflow::results::error_bars::ErrorBars;
use stampflow::units::joined;

/// Answer on a case, with its error bars.
pub fn answered(case: &Case, answer: &Answer, findings: &[Finding], bars: Option<&ErrorBars>) -> ScreenText {
    let list = |lines: Vec<String>| wrapped(&lines.iter().map(|line| format!("- {line}\n")).collect::<String>());
    let numbers = answer.numbers.iter();
    let numbers = numbers.map(|n| [n.label.to_string(), n.amount.to_string(), n.place.to_string()].map(Cell::from));
    let end = Some(answer.end.clone()).filter(|end| !end.is_empty());
    let bars = bars.map_or_else(Vec::new, ErrorBars::sentences);
    let warnings: Vec<String> = end.into_iter().chain(sentences(findings, Kind::Warning)).chain(bars).collect();
    let gap = if warnings.is_empty() { "" } else { "\n" };
    let text = sentence(&case.name, answer, "") + list(size_doubts(case)) + "\n".into() + judged(findings);
    let text = text + table(&[], numbers) + gap.into() + list(warnings);
    let unchecked = joined(judgements(findings).filter(|f| f.light == Light::Grey).map(|f| f.label.into()), ", ");
    if unchecked.is_empty() { text } else { text + wrapped(&format!("\nNot checked: {unchecked}.")) }
}

/// One line: `cup: RED: it tears in the wall.`, with `more` at its end.
pub fn sentence(case: &str, answer: &Answer, more: &str) -> ScreenText {
    let light = answer.light.name().to_uppercase();
    highlighted(&format!("{case}: {light}: {}. {more}", answer.sentence), &light, answer.light)
}

/// Red rows, then amber ones; advice stands once under the rows that it is good for.
fn judged(findings: &[Finding]) -> ScreenText {
    let mut rows: Vec<[Cell; 3]> = Vec::new();
    for light in [Light::Red, Light::Amber] {
        for alike in by_advice(findings, |is| is == light) {
            rows.extend(alike.iter().map(|finding| row(finding)));
            let advice = &alike[0].advice;
            if !advice.is_empty() {
                rows.push(["", "→ change", advice].map(Cell::from));
            }
            rows.push([""; 3].map(Cell::from));
        }
    }
    table(&[], rows)
}

fn row(finding: &Finding) -> [Cell; 3] {
    // Words have no limit.
    let value = match finding.value() {
        Some(_) => format!("{}; limit: {}", finding.found(), finding.limit),
        None => finding.found(),
    };
    let light = Cell::Light(finding.light, String::new());
    [light, Cell::from(finding.label), Cell::from(value)]
}
