//! Rows of the book's tables whose figures a test computes. `UPDATE=1` writes them.

use std::fs;
use std::sync::Mutex;

/// Tests run side by side, and a page is one file.
static WRITING: Mutex<()> = Mutex::new(());

/// Holds the row of `docs/agreement.md` that begins with these cells to the rest of them.
pub fn agreement(begins: &str, rest: &[String]) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/agreement.md");
    let one_at_a_time = WRITING.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let page = fs::read_to_string(path).expect("shipped");
    let begins = format!("| {begins} |");
    let row = format!("{begins} {} |", rest.join(" | "));
    let shown: Vec<&str> = page.lines().filter(|line| line.starts_with(&begins)).collect();
    let [shown] = shown[..] else { panic!("{} rows of the page begin with {begins}", shown.len()) };
    if shown != row && std::env::var_os("UPDATE").is_some() {
        fs::write(path, page.replace(shown, &row)).expect("writable");
        return;
    }
    drop(one_at_a_time);
    assert_eq!(shown, row, "docs/agreement.md; with UPDATE=1 it is written");
}

/// Numbers of a cell, `1.2, 3.4`.
pub fn listed(values: &[f64], decimals: usize) -> String {
    values.iter().map(|value| format!("{value:.decimals$}")).collect::<Vec<_>>().join(", ")
}

/// Shares of a cell as signed percentages, `+1.2, −3.4 %`.
pub fn percent(shares: &[f64], decimals: usize) -> String {
    let signed = shares.iter().map(|share| format!("{:+.decimals$}", 100.0 * share).replace('-', "−"));
    signed.collect::<Vec<_>>().join(", ") + " %"
}
