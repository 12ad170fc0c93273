//! The word that was probably meant.

/// The words closest to `word`, at most three: few edits, upper and lower case counted as half of one.
pub fn closest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let word: String = word.chars().take(64).collect();
    let allowed = match word.chars().count() {
        0..=2 => 2,
        3..=5 => 4,
        _ => 6,
    };
    let half_edits = |other: &str| {
        let in_lower_case = strsim::levenshtein(&word.to_ascii_lowercase(), &other.to_ascii_lowercase());
        strsim::levenshtein(&word, other) + in_lower_case
    };
    let near = known.map(|known| (half_edits(known), known));
    let mut near: Vec<_> = near.filter(|(d, k)| *d <= allowed && *d < 2 * k.chars().count()).collect();
    near.sort_by_key(|(d, _)| *d);
    let best = near.first().map_or(0, |(d, _)| *d);
    near.into_iter().filter(|(d, _)| *d <= best + 1).map(|(_, k)| k).take(3).collect()
}

/// A question to stand before what is known, with a space at its end; nothing where no known word is close.
pub(crate) fn did_you_mean<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> String {
    closest(word, known).first().map_or(String::new(), |near| format!("did you mean `{near}`? "))
}
