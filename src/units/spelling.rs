//! The word that was probably meant.

/// The words closest to `word`, at most three: few edits, upper and lower case counted as half of one.
pub fn closest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let allowed = match word.chars().count() {
        0..=2 => 2,
        3..=5 => 4,
        _ => 6,
    };
    let mut near: Vec<(usize, &str)> =
        known.map(|k| (half_edits(word, k), k)).filter(|(d, k)| *d <= allowed && *d < 2 * k.chars().count()).collect();
    near.sort_by_key(|(d, _)| *d);
    let best = near.first().map_or(0, |(d, _)| *d);
    near.into_iter().filter(|(d, _)| *d <= best + 1).map(|(_, k)| k).take(3).collect()
}

/// A question to stand before what is known, with a space at its end; nothing where no known word is close.
pub(crate) fn did_you_mean<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> String {
    closest(word, known).first().map_or(String::new(), |near| format!("did you mean `{near}`? "))
}

/// Levenshtein's distance in halves; a change of case costs one half.
fn half_edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).map(|j| 2 * j).collect();
    for ca in a.chars().take(64) {
        let mut diagonal = row[0];
        row[0] += 2;
        for (j, &cb) in b.iter().enumerate() {
            let change = if ca == cb { 0 } else { 2 - usize::from(ca.eq_ignore_ascii_case(&cb)) };
            let best = (diagonal + change).min(row[j] + 2).min(row[j + 1] + 2);
            diagonal = row[j + 1];
            row[j + 1] = best;
        }
    }
    row[b.len()]
}
