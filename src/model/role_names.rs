//! Names of the tools in English, German and French, for layers of drawings and keys of case files.

use super::Role;

/// Names of each tool in small letters without accents and separators.
const WORDS: [(Role, &str); 3] = [
    (Role::Punch, "punch stempel patrize poincon"),
    (Role::Die, "die matrix drawring matrize ziehring gesenk matrice"),
    (
        Role::Holder,
        "holder binder holddown pressurering niederhalter blechhalter faltenhalter serreflan serretole presseflan",
    ),
];

/// Letters with an accent, and without.
const ACCENTS: &str = "àáâãäå=a ç=c èéêë=e ìíîï=i ñ=n òóôõö=o ùúûü=u ß=ss œ=oe";

/// Prefixes that do not change the tool: `blank holder`, `Ziehstempel`.
const BEFORE: [&str; 6] = ["blank", "draw", "drawing", "forming", "zieh", "blech"];

/// Names of other tools that contain a tool's name.
const OTHERS: [&str; 7] =
    ["gegenhalter", "gegenstempel", "counterpunch", "counterholder", "contrepoincon", "stempelhalter", "portepoincon"];

/// Length up to which names are searched at the ends of words only: "Radien" is no die.
const SHORT: usize = 3;

impl Role {
    /// Tool of a whole word or phrase, without case, accents and separators: `binder`, `Ziehstempel`, `serre-flan`.
    pub fn from_word(word: &str) -> Option<Self> {
        let word: String = letters(word).concat();
        let means = |word: &str| {
            WORDS.iter().find(|(_, words)| words.split(' ').any(|other| other == word)).map(|(role, _)| *role)
        };
        means(&word).or_else(|| BEFORE.iter().find_map(|before| means(word.strip_prefix(before)?)))
    }

    /// Tools that a text names, in the order of [`ALL`](Self::ALL): `upper punch`, `OP20_PUNCH`, `Matrize 1`.
    pub fn named_in(text: &str) -> Vec<Self> {
        let words = letters(text);
        let mut whole = words.concat();
        for other in OTHERS {
            whole = whole.replace(other, " ");
        }
        let names = |word: &str| match word.len() {
            ..=SHORT => words.iter().any(|part| part.starts_with(word) || part.ends_with(word)),
            _ => whole.contains(word),
        };
        WORDS.iter().filter(|(_, words)| words.split(' ').any(names)).map(|(role, _)| *role).collect()
    }
}

/// Words of a text in small letters without accents; a capital after a small letter begins another.
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

#[cfg(test)]
mod tests {
    use super::*;
    use Role::{Die, Holder, Punch};

    /// Trust: the words of the trade, written out by hand.
    #[test]
    fn words_and_texts_name_their_tools_in_three_languages() {
        for (words, role) in [
            ("punch, PUNCH, Stempel, Ziehstempel, draw punch, Poinçon, poinc\u{327}on", Some(Punch)),
            ("die, matrix, draw ring, draw_die, Matrize, Ziehring, matrice", Some(Die)),
            ("holder, binder, blank holder, blank_holder, Blech-Niederhalter, serre-flan, serre-tôle", Some(Holder)),
            ("blank, Gegenhalter, punch holder, ring, died, punches 2", None),
        ] {
            words.split(", ").for_each(|word| assert_eq!(Role::from_word(word), role, "{word}"));
        }
        for (texts, roles) in [
            ("OP20_PUNCH, upper punch, OP10 - Ziehstempel unten", &[Punch][..]),
            ("LowerDie2, lowerdie", &[Die]),
            ("SERRE FLAN, Blank holder 1", &[Holder]),
            ("punch and die", &[Punch, Die]),
            ("die holder", &[Die, Holder]),
            ("Gegenhalter, counter-punch, Stempelhalter, Radien, centre line", &[]),
        ] {
            texts.split(", ").for_each(|text| assert_eq!(Role::named_in(text), roles, "{text}"));
        }
    }
}
