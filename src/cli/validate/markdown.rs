//! Every comparison with all that is known of it, as a table for a document.

use super::screen::Compared;
use std::fmt::Write;

const HEADERS: &str = "\
| case | kind | quantity | reference | accepted | worst | verdict | reason |
|---|---|---|---|---|---|---|---|
";

/// One row a comparison.
pub fn markdown(all: &[Compared]) -> String {
    let mut text = HEADERS.to_owned();
    for (case, comparison) in all {
        let (spec, source) = (&comparison.spec, &comparison.source);
        let (kind, reference) = match source {
            Some(source) => (source.kind.as_str(), format!("{}, grade {}", source.citation, source.grade)),
            None => ("not stated", spec.reference.file_name().unwrap_or_default().to_string_lossy().into_owned()),
        };
        let worst = comparison.worst().unwrap_or_else(|| "–".to_owned());
        let (quantity, accepted, outcome) = (spec.against.name(), comparison.accepted(), comparison.outcome());
        let cells = [case, kind, quantity, &reference, &accepted, &worst, &outcome, &spec.reason];
        let cells = cells.map(|cell| cell.replace('|', "\\|").replace('\n', " "));
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text
}
