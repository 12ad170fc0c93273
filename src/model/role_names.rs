//! The words that shops have for the tools, in English, German and French: layers of drawings and keys of case files.

use super::Role;

/// What each tool is called, in small letters without accents and separators; longer words contain shorter ones of the same tool.
const WORDS: [(Role, &[&str]); 3] = [
    (Role::Punch, &["punch", "stempel", "patrize", "poincon"]),
    (Role::Die, &["die", "matrix", "drawring", "matrize", "ziehring", "gesenk", "matrice"]),
    (
        Role::Holder,
        &[
            "holder",
            "binder",
            "holddown",
            "pressurering",
            "niederhalter",
            "blechhalter",
            "faltenhalter",
            "serreflan",
            "serretole",
            "presseflan",
        ],
    ),
];

/// Common words that go before another and leave the tool what it is: `blank holder`, `Ziehstempel`.
const BEFORE: [&str; 6] = ["blank", "draw", "drawing", "forming", "zieh", "blech"];

/// Tools that a section does not have, though a tool's word is in theirs: what stands against the punch, what carries a tool.
const OTHERS: [&str; 7] =
    ["gegenhalter", "gegenstempel", "counterpunch", "counterholder", "contrepoincon", "stempelhalter", "portepoincon"];

/// Words up to this length are looked for at the ends of a text's words only \[letters\]: "Radien" is no die.
const SHORT: usize = 3;

impl Role {
    /// The tool that a whole word or phrase means: `binder`, `Blank holder`, `Ziehstempel`, `serre-flan`. Case, accents and
    /// separators do not count.
    pub fn from_word(word: &str) -> Option<Self> {
        let word: String = letters(word).concat();
        let means = |word: &str| WORDS.iter().find(|(_, words)| words.contains(&word)).map(|(role, _)| *role);
        means(&word).or_else(|| BEFORE.iter().find_map(|before| means(word.strip_prefix(before)?)))
    }

    /// The tools that a text names somewhere, in the order of [`ALL`](Self::ALL): `upper punch`, `OP20_PUNCH`, `Matrize 1`.
    pub fn named_in(text: &str) -> Vec<Self> {
        let words = letters(text);
        let mut whole = words.concat();
        for other in OTHERS {
            whole = whole.replace(other, " ");
        }
        let names = |word: &&str| {
            if word.len() > SHORT {
                return whole.contains(*word);
            }
            words.iter().any(|part| part.starts_with(*word) || part.ends_with(*word))
        };
        WORDS.iter().filter(|(_, words)| words.iter().any(names)).map(|(role, _)| *role).collect()
    }
}

/// The words of a text: runs of small letters without accents; a capital after a small letter begins another.
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
        c.to_lowercase().filter(|c| c.is_alphabetic()).for_each(|c| add_plain(word, c));
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Adds a small letter without its accent.
fn add_plain(word: &mut String, c: char) {
    match c {
        'à'..='å' => word.push('a'),
        'ç' => word.push('c'),
        'è'..='ë' => word.push('e'),
        'ì'..='ï' => word.push('i'),
        'ñ' => word.push('n'),
        'ò'..='ö' => word.push('o'),
        'ù'..='ü' => word.push('u'),
        'ß' => word.push_str("ss"),
        'œ' => word.push_str("oe"),
        _ => word.push(c),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: the words of the trade, written out by hand.
    #[test]
    fn a_word_means_its_tool_in_three_languages() {
        let said = |words: &[&str], role| {
            for word in words {
                assert_eq!(Role::from_word(word), Some(role), "{word}");
            }
        };
        said(&["punch", "PUNCH", "Stempel", "Ziehstempel", "draw punch", "Poinçon", "poinc\u{327}on"], Role::Punch);
        said(&["die", "matrix", "draw ring", "draw_die", "Matrize", "Ziehring", "matrice"], Role::Die);
        said(&["holder", "binder", "blank holder", "blank_holder", "Blankholder", "blank-holder"], Role::Holder);
        said(&["Niederhalter", "Blechhalter", "Blech-Niederhalter", "serre-flan", "serre-tôle"], Role::Holder);
        for word in ["", "blank", "Gegenhalter", "punch holder", "ring", "died", "punches 2"] {
            assert_eq!(Role::from_word(word), None, "{word}");
        }
    }

    #[test]
    fn a_text_names_the_tools_whose_words_it_holds() {
        use Role::{Die, Holder, Punch};
        for (text, roles) in [
            ("OP20_PUNCH", &[Punch][..]),
            ("upper punch", &[Punch]),
            ("LowerDie2", &[Die]),
            ("lowerdie", &[Die]),
            ("OP10 - Ziehstempel unten", &[Punch]),
            ("SERRE FLAN", &[Holder]),
            ("Blank holder 1", &[Holder]),
            ("punch and die", &[Punch, Die]),
            ("die holder", &[Die, Holder]),
            // What stands against the punch or carries it is no tool of a section.
            ("Gegenhalter", &[]),
            ("counter-punch", &[]),
            ("Stempelhalter", &[]),
            ("Radien", &[]),
            ("centre line", &[]),
        ] {
            assert_eq!(Role::named_in(text), roles, "{text}");
        }
    }
}
