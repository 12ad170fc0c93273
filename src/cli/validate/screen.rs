//! What `validate` prints: a line a comparison, why those outside are out, and how many of each kind are inside.

use crate::cli::say::Shown;
use crate::cli::table::{Cell, Tone, table, width, wrapped};
use stampflow::compare::{Comparison, KINDS, Verdict};
use stampflow::message::{Form, Message, message};

/// The name of a case, and one of its comparisons.
pub type Compared = (String, Comparison);

const HEADERS: [&str; 6] = ["case", "kind", "quantity", "found", "reference", "verdict"];
/// Between two columns.
const GAP: usize = 2;
/// A name of a case is not cut shorter.
const SHORTEST: usize = 8;

/// All of it.
pub fn screen(all: &[Compared], form: Form) -> Shown {
    let reasons = Reasons::of(all);
    let mut rows: Vec<[Cell; 6]> = all.iter().map(|one| row(one, reasons.number(one), form)).collect();
    let headers = HEADERS.map(|header| form.tell(header));
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
        + wrapped(&reasons.told(form))
        + wrapped(&format!("\n{}", counts(all, form)))
}

/// A name within so many letters.
fn shortened(name: &str, room: usize) -> String {
    if name.chars().count() <= room {
        return name.to_owned();
    }
    name.chars().take(room - 1).chain(['…']).collect()
}

fn row((case, comparison): &Compared, reason: Option<usize>, form: Form) -> [Cell; 6] {
    let tone = match comparison.verdict {
        _ if comparison.is_failure() => Tone::Bad,
        Verdict::In => Tone::Good,
        _ => Tone::Warning,
    };
    let value = |value: Option<String>| Cell::plain(value.unwrap_or_else(|| "–".to_owned()));
    let verdict = form.tell(comparison.verdict.told());
    let text = reason.map_or_else(|| verdict.clone(), |number| format!("{verdict} {number}"));
    [
        Cell::plain(case),
        value(comparison.source.is_some().then(|| form.tell(kind(comparison)))),
        Cell::plain(form.tell(comparison.spec.against.label())),
        value(comparison.farthest().map(|value| value.told(form))),
        value(comparison.target(form)),
        Cell { text, tone },
    ]
}

fn kind(comparison: &Comparison) -> Message {
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
    fn told(&self, form: Form) -> String {
        let lines = self.0.iter().enumerate().map(|(i, group)| {
            let names: Vec<&str> = group.iter().map(|(case, _)| case.as_str()).collect();
            let first = &group[0].1;
            let missed = match first.verdict {
                Verdict::Out => first.worst().unwrap_or_default(),
                verdict => form.tell(verdict.told()),
            };
            let demonstration = match first.spec.demonstration {
                true => form.tell(" (a demonstration, no failure: the input is not that of the reference)"),
                false => String::new(),
            };
            let quantity = form.tell(first.spec.against.label());
            let reason = match first.verdict {
                Verdict::NoData => {
                    let file = first.spec.reference.file_name().unwrap_or_default().to_string_lossy().into_owned();
                    form.tell(message!("{file} is not there", file = file))
                }
                _ => first.spec.reason.trim_end_matches('.').to_owned(),
            };
            format!("\n{}  {}, {quantity} {missed}: {reason}{demonstration}", i + 1, names.join(", "))
        });
        lines.collect::<String>() + "\n"
    }
}

/// `experiment: 1 of 3 inside`, a line a kind; what has no data is no comparison.
fn counts(all: &[Compared], form: Form) -> String {
    let name = |one: &Compared| form.tell(kind(&one.1));
    let compared: Vec<&Compared> = all.iter().filter(|(_, c)| c.verdict != Verdict::NoData).collect();
    let mut kinds: Vec<String> = KINDS.iter().map(|kind| form.tell(*kind)).collect();
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
        let counted = message!("{kind}: {inside} of {n} inside", kind = kind.clone(), inside = inside, n = n);
        let shown = match shown {
            0 => Message::default(),
            shown => message!("{n} outside as demonstrations", n = shown),
        };
        (n > 0).then(|| form.tell(Message::joined([counted, shown], ", ")) + "\n")
    });
    let missing = all.len() - compared.len();
    let missing = match missing {
        0 => String::new(),
        n => form.tell(message!("no data: {n}", n = n)) + "\n",
    };
    lines.collect::<String>() + &missing
}
