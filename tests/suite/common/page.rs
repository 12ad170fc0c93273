//! Figures of the book, and of comments of cases, that a test computes. `UPDATE=1` writes them.

use crate::common::prelude::*;

/// Tests run side by side, and a page is one file.
static WRITING: Mutex<()> = Mutex::new(());

/// Holds what is shown in a file of the project to what is computed, or writes that in its place.
fn hold(file: &str, shown: impl Fn(&str) -> String, computed: impl Fn(&str) -> String) {
    let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
    let one_at_a_time = WRITING.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let text = fs::read_to_string(&path).expect("shipped");
    let (shown, computed) = (shown(&text), computed(&text));
    if shown != computed && std::env::var_os("UPDATE").is_some() {
        fs::write(&path, text.replace(&shown, &computed)).expect("writable");
        return;
    }
    drop(one_at_a_time);
    assert_eq!(shown, computed, "{file}; with UPDATE=1 it is written");
}

/// Holds the row of `docs/agreement.md` that begins with these cells to the rest of them.
pub fn agreement(begins: &str, rest: &[String]) {
    let begins = format!("| {begins} |");
    let shown = |page: &str| {
        let shown: Vec<&str> = page.lines().filter(|line| line.starts_with(&begins)).collect();
        let [shown] = shown[..] else { panic!("{} rows of the page begin with {begins}", shown.len()) };
        shown.to_owned()
    };
    hold("docs/agreement.md", shown, |_| format!("{begins} {} |", rest.join(" | ")));
}

/// Holds a sentence of `docs/agreement.md` to its figures, as [`told`] does.
pub fn agrees(sentence: &str, figures: &[String]) {
    told("docs/agreement.md", sentence, figures);
}

/// Holds a sentence of a file to its figures, each `{}` one of them; it may go over lines of a text or comment.
pub fn told(file: &str, sentence: &str, figures: &[String]) {
    const FIGURE: &str = r"([+−-]?[0-9]+(?:[.,][0-9]+)?(?:e[−-]?[0-9]+)?)";
    let pattern = regex::escape(sentence).replace(r"\{\}", FIGURE).replace(' ', r"\s+(?:# )?");
    let pattern = Regex::new(&pattern).expect("a pattern");
    let found = |text: &str| {
        let mut found = pattern.captures_iter(text);
        let one = found.next().unwrap_or_else(|| panic!("{file} does not say: {sentence}"));
        assert!(found.next().is_none(), "{file} says it twice: {sentence}");
        let places: Vec<_> = one.iter().flatten().map(|part| part.range()).collect();
        assert_eq!(places.len(), 1 + figures.len(), "figures of: {sentence}");
        places
    };
    let computed = |text: &str| {
        let places = found(text);
        let (mut told, mut from) = (String::new(), places[0].start);
        for (place, figure) in places[1..].iter().zip(figures) {
            told += &text[from..place.start];
            told += figure;
            from = place.end;
        }
        told + &text[from..places[0].end]
    };
    hold(file, |text| text[found(text)[0].clone()].to_owned(), computed);
}

/// Numbers as they are told, 1.2 and 3.4.
pub fn plain(values: &[f64], decimals: usize) -> Vec<String> {
    values.iter().map(|value| format!("{value:.decimals$}").replace('-', "−")).collect()
}

/// Shares as they are told in percent with their signs, +1.2 and −3.4; what rounds to nothing has none.
pub fn signed(shares: &[f64], decimals: usize) -> Vec<String> {
    let one = |share: &f64| {
        let text = format!("{:+.decimals$}", 100.0 * share);
        match text.contains(|c: char| ('1'..='9').contains(&c)) {
            true => text.replace('-', "−"),
            false => text[1..].to_owned(),
        }
    };
    shares.iter().map(one).collect()
}

/// A share as a bound in percent, rounded up to one digit that counts: 0.04.
pub fn at_most(share: f64) -> Vec<String> {
    let unit = 10f64.powf((100.0 * share).log10().floor());
    let decimals = (-unit.log10().round()).max(0.0) as usize;
    // What round-off adds makes no digit more.
    plain(&[(100.0 * share / unit - 1e-9).ceil() * unit], decimals)
}

/// Shares of a cell as signed percentages, `+1.2, −3.4 %`.
pub fn percent(shares: &[f64], decimals: usize) -> String {
    signed(shares, decimals).join(", ") + " %"
}
