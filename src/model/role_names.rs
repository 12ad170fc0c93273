//! Names of the tools in English, German and French, for layers of drawings and keys of case files.

use super::Role;

/// Names of each tool in small letters without accents and separators; those that contain another tool's come first.
const WORDS: [(Option<Role>, &str); 5] = [
    (None, "stempelhalter portepoincon"),
    (
        Some(Role::Pad),
        "pad ejector gegenhalter gegenstempel counterpunch counterholder contrepoincon auswerfer ejecteur",
    ),
    (Some(Role::Punch), "punch stempel patrize poincon"),
    (Some(Role::Die), "die matrix drawring matrize ziehring gesenk matrice"),
    (
        Some(Role::Holder),
        "holder binder holddown pressurering niederhalter blechhalter faltenhalter serreflan serretole presseflan",
    ),
];

/// Words before the number of an operation: `OP20`, `AFO 20` (Arbeitsfolge), `Stufe 2`, `passe_2`.
const OPERATIONS: [&str; 7] = ["op", "afo", "operation", "stage", "station", "stufe", "passe"];
const ACCENTS: &str = "àáâãäå=a ç=c èéêë=e ìíîï=i ñ=n òóôõö=o ùúûü=u ß=ss œ=oe";
/// Length up to which names are searched at the ends of words only: "Radien" is no die.
const SHORT: usize = 3;

impl Role {
    /// Tools that a text names, in the order of [`ALL`](Self::ALL): `upper punch`, `OP20_PUNCH`, `Matrize 1`.
    pub fn named_in(text: &str) -> Vec<Self> {
        let words = letters(text);
        let (mut whole, mut found) = (words.concat(), Vec::new());
        for (role, word) in WORDS.iter().flat_map(|(role, names)| names.split(' ').map(move |word| (role, word))) {
            let is_named = match word.len() {
                ..=SHORT => words.iter().any(|part| part.starts_with(word) || part.ends_with(word)),
                _ => whole.contains(word),
            };
            if is_named {
                whole = whole.replace(word, " ");
                found.extend(role);
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// Number of the operation that a text names: 20 of `OP20_PUNCH`.
pub fn operation_in(text: &str) -> Option<u32> {
    let lower = text.to_lowercase();
    let starts = lower.char_indices().filter(|(i, _)| !lower[..*i].ends_with(char::is_alphabetic));
    let number = |(i, word): (usize, &str)| {
        let rest = lower[i..].strip_prefix(word)?.trim_start_matches(|c: char| " _-.#".contains(c));
        rest.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
    };
    starts.flat_map(|(i, _)| OPERATIONS.map(|word| (i, word))).find_map(number)
}

fn letters(text: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut after_small = false;
    for c in text.chars() {
        // Marks of decomposed accents belong to the letter before.
        if ('\u{300}'..='\u{36f}').contains(&c) {
            continue;
        }
        if !c.is_alphabetic() || c.is_uppercase() && after_small {
            words.push(String::new());
        }
        after_small = c.is_lowercase();
        let word = words.last_mut().expect("there is one");
        for c in c.to_lowercase().filter(|c| c.is_alphabetic()) {
            let mut plain = ACCENTS.split(' ').filter_map(|pair| pair.split_once('='));
            match plain.find(|(accented, _)| accented.contains(c)) {
                Some((_, plain)) => word.push_str(plain),
                None => word.push(c),
            }
        }
    }
    words.retain(|word| !word.is_empty());
    words
}
