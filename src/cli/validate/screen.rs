//! What `validate` prints: a line a comparison, why those outside are out, and how many of each kind are inside.

use crate::cli::say::Shown;
use crate::cli::table::{Cell, Tone, table, width, wrapped};
use stampflow::compare::{Comparison, KINDS, Verdict};
use stampflow::units::joined;

/// The name of a case, and one of its comparisons.
pub type Compared = (String, Comparison);

const HEADERS: [&str; 6] = ["case", "kind", "quantity", "found", "reference", "verdict"];
/// Between two columns.
const GAP: usize = 2;
/// A name of a case is not cut shorter.
const SHORTEST: usize = 8;

/// All of it.
pub fn screen(all: &[Compared]) -> Shown {
    let reasons = Reasons::of(all);
    let mut rows: Vec<[Cell; 6]> = all.iter().map(|one| row(one, reasons.number(one))).collect();
    let headers = HEADERS.map(|header| String::from(header));
    let widest = |column: usize| {
        let cells = rows.iter().map(|row| row[column].text.chars().count());
        cells.chain([headers[column].chars().count()]).max().unwrap_or(0)
    };
    let others: usize = (1..HEADERS.len()).map(|column| widest(column) + GAP).sum();
    let room = width().saturating_sub(others).max(SHORTEST);
    for [name, ..] in &mut rows {
        name.text = shortened(&name.text, room);
    }
    table(Some(headers.each_ref().map(String::as_str)), rows)
        + wrapped(&reasons.told())
        + wrapped(&format!("\n{}", counts(all)))
}

/// A name within so many letters.
fn shortened(name: &str, room: usize) -> String {
    if name.chars().count() <= room {
        return name.to_owned();
    }
    name.chars().take(room - 1).chain(['…']).collect()
}

fn row((case, comparison): &Compared, reason: Option<usize>) -> [Cell; 6] {
    let tone = match comparison.verdict {
        _ if comparison.is_failure() => Tone::Bad,
        Verdict::In => Tone::Good,
        _ => Tone::Warning,
    };
    let value = |value: Option<String>| Cell::plain(value.unwrap_or_else(|| "–".to_owned()));
    let verdict = String::from(comparison.verdict.told());
    let text = reason.map_or_else(|| verdict.clone(), |number| format!("{verdict} {number}"));
    [
        Cell::plain(case),
        value(comparison.source.is_some().then(|| String::from(kind(comparison)))),
        Cell::plain(String::from(comparison.spec.against.label())),
        value(comparison.farthest().map(|value| value.to_string())),
        value(comparison.target()),
        Cell { text, tone },
    ]
}

fn kind(comparison: &Comparison) -> String {
    comparison.source.as_ref().map_or_else(|| "not stated".into(), |source| source.kind())
}

/// Why comparisons are not inside, each reason once.
struct Reasons<'a>(Vec<Vec<&'a Compared>>);

impl<'a> Reasons<'a> {
    fn of(all: &'a [Compared]) -> Self {
        let mut groups: Vec<Vec<&Compared>> = Vec::new();
        for one in all.iter().filter(|(_, comparison)| comparison.verdict != Verdict::In) {
            let is_same = |group: &&mut Vec<&Compared>| {
                let (first, other) = (&group[0].1, &one.1);
                first.spec.reason == other.spec.reason
                    && first.spec.against.name() == other.spec.against.name()
                    && first.outcome() == other.outcome()
            };
            match groups.iter_mut().find(is_same) {
                Some(group) => group.push(one),
                None => groups.push(vec![one]),
            }
        }
        Self(groups)
    }

    /// Of the reason, from 1; `None` of what is inside.
    fn number(&self, one: &Compared) -> Option<usize> {
        self.0.iter().position(|group| group.iter().any(|other| std::ptr::eq(*other, one))).map(|at| at + 1)
    }

    /// `1  cup, diameter 3.4 mm above (+0.7 %): friction is not known (a demonstration: no failure)`.
    fn told(&self) -> String {
        let lines = self.0.iter().enumerate().map(|(i, group)| {
            let names: Vec<&str> = group.iter().map(|(case, _)| case.as_str()).collect();
            let first = &group[0].1;
            let missed = match first.verdict {
                Verdict::Out => first.worst().unwrap_or_default(),
                verdict => String::from(verdict.told()),
            };
            let demonstration = match first.spec.demonstration {
                true => String::from(" (a demonstration, no failure: the input is not that of the reference)"),
                false => String::new(),
            };
            let quantity = String::from(first.spec.against.label());
            let reason = match first.verdict {
                Verdict::NoData => {
                    let file = first.spec.reference.file_name().unwrap_or_default().to_string_lossy().into_owned();
                    format!("{file} is not there")
                }
                _ => first.spec.reason.trim_end_matches('.').to_owned(),
            };
            format!("\n{}  {}, {quantity} {missed}: {reason}{demonstration}", i + 1, names.join(", "))
        });
        lines.collect::<String>() + "\n"
    }
}

/// `experiment: 1 of 3 inside`, a line a kind; what has no data is no comparison.
fn counts(all: &[Compared]) -> String {
    let name = |one: &Compared| String::from(kind(&one.1));
    let compared: Vec<&Compared> = all.iter().filter(|(_, c)| c.verdict != Verdict::NoData).collect();
    let mut kinds: Vec<String> = KINDS.iter().map(|kind| String::from(*kind)).collect();
    for one in &compared {
        if !kinds.contains(&name(one)) {
            kinds.push(name(one));
        }
    }
    let lines = kinds.into_iter().filter_map(|kind| {
        let of = || compared.iter().filter(|one| name(one) == kind);
        let inside = of().filter(|(_, c)| c.verdict == Verdict::In).count();
        let shown = of().filter(|(_, c)| c.verdict != Verdict::In && c.spec.demonstration).count();
        let n = of().count();
        let counted = format!("{kind}: {inside} of {n} inside");
        let shown = match shown {
            0 => String::new(),
            shown => format!("{shown} outside as demonstrations"),
        };
        (n > 0).then(|| String::from(joined([counted, shown], ", ")) + "\n")
    });
    let missing = all.len() - compared.len();
    let missing = match missing {
        0 => String::new(),
        n => format!("no data: {n}") + "\n",
    };
    lines.collect::<String>() + &missing
}
