//! The texts that are a quantity as a regular expression, for editors that know the schema of a case file only.

use super::gauge::GAUGES;
use super::kind::Kind;
use super::unit::{CELSIUS, Dimension, LENGTH, NONE, TEMPERATURE, UNITS};

/// A number as the parser reads it.
const NUMBER: &str = r"[+\-−]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+\-−]?[0-9]+)?";
/// The second and third power as they may be written.
const SQUARE: &str = r"(?:\^?2|²)";
const CUBE: &str = r"(?:\^?3|³)";
/// What may be a unit in a longer product.
const WORD: &str = "[A-Za-z_%]+";
/// Any power.
const POWER: &str = r"(?:\^-?[0-9]|[0-9]|²|³)?";

/// The expression that texts of these kinds match, as ECMA 262 and Rust's `regex` read it.
///
/// One unit, and the quotient of two, are told apart by what they measure. Products and longer quotients of words all match:
/// whether they are units, and of the dimension, is for the program to say.
pub(crate) fn pattern(kinds: &[&Kind]) -> String {
    let mut units: Vec<String> = kinds.iter().flat_map(|kind| written(kind.dimension)).collect();
    let product = format!(r"{WORD}{POWER}(?:\s*[*·]\s*|\s+){WORD}{POWER}");
    let longer = format!(r"(?:/\s*)?{WORD}{POWER}(?:(?:\s*[*·/]\s*|\s+){WORD}{POWER}){{2,}}");
    units.extend([product, longer]);
    let mut forms = vec![format!(r"{NUMBER}\s*(?:{})", units.join("|"))];
    if kinds.iter().any(|kind| kind.dimension == LENGTH) {
        let gauges = GAUGES.map(|gauge| gauge.to_string()).collect::<Vec<_>>().join("|");
        forms.push(format!(r"{NUMBER}\s*t|(?:{gauges})\s*(?:ga_steel|ga_al)"));
    }
    format!(r"^\s*(?:{})\s*$", forms.join("|"))
}

/// Units of a dimension, and quotients that are of it: `MPa`, `N/mm2`, `/s`.
fn written(dimension: Dimension) -> Vec<String> {
    let mut forms: Vec<String> = alternatives(|of| of == dimension).into_iter().collect();
    if dimension == TEMPERATURE {
        forms.push(CELSIUS.to_owned());
    }
    let mut classes: Vec<Dimension> = Vec::new();
    for unit in &UNITS {
        if !classes.contains(&unit.2) {
            classes.push(unit.2);
        }
    }
    for by in &classes {
        for (power, spelled) in [(1, ""), (2, SQUARE), (3, CUBE)] {
            let over = dimension.times(*by, power);
            let below = alternatives(|of| of == *by).unwrap_or_default();
            if over == NONE {
                forms.push(format!(r"/\s*{below}{spelled}"));
            }
            forms.extend(alternatives(|of| of == over).map(|above| format!(r"{above}\s*/\s*{below}{spelled}")));
        }
    }
    forms
}

/// The units whose dimension is as wanted, longest first, so that none is taken for the beginning of another.
fn alternatives(is: impl Fn(Dimension) -> bool) -> Option<String> {
    let mut names: Vec<&str> = UNITS.iter().filter(|unit| is(unit.2)).map(|unit| unit.0).collect();
    names.sort_by_key(|name| std::cmp::Reverse(name.chars().count()));
    (!names.is_empty()).then(|| format!("(?:{})", names.join("|")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{
        Dimensioned, Force, Length, LineForce, QuantityError, Speed, StrainRate, Stress, Temperature, Time,
    };
    use regex::Regex;

    fn agrees<Q: Dimensioned + std::str::FromStr<Err = QuantityError>>() {
        let pattern = Regex::new(&pattern(&[Q::KIND])).expect("an expression");
        let names = || UNITS.iter().map(|unit| unit.0).chain([CELSIUS, "ga_steel", "ga_al", "furlong"]);
        let powers = ["", "^2", "2", "²", "^3", "3", "³"];
        let quotients = names()
            .flat_map(|a| names().map(move |b| (a, b)))
            .flat_map(|(a, b)| powers.map(|power| [format!("{a}/{b}{power}"), format!("/{b}{power}")]));
        let mut accepted = 0;
        for unit in names().map(str::to_owned).chain(quotients.flatten()).chain([String::new()]) {
            for text in [format!("20 {unit}"), format!("20{unit}")] {
                let read = match text.parse::<Q>() {
                    // Far out of range is the right unit all the same.
                    Ok(_) | Err(QuantityError::TooLarge { .. }) => true,
                    Err(_) => false,
                };
                assert_eq!(pattern.is_match(&text), read, "{text:?} as {}", Q::KIND.name);
                accepted += usize::from(read);
            }
        }
        assert!(accepted > 0, "{}", Q::KIND.name);
    }

    /// Trust: over every unit, quotient of two and power, against the parser.
    #[test]
    fn an_expression_takes_the_units_that_the_parser_takes_and_no_other() {
        agrees::<Length>();
        agrees::<Force>();
        agrees::<Stress>();
        agrees::<LineForce>();
        agrees::<Time>();
        agrees::<Speed>();
        agrees::<StrainRate>();
        agrees::<Temperature>();
    }

    #[test]
    fn an_expression_takes_every_example_and_number() {
        let length = Regex::new(&pattern(&[Length::KIND])).expect("an expression");
        for text in ["0.9 mm", " 5. mm", ".5 in", "-3e-1 mm", "−3 mm", "0.035\"", "6 t", "20 ga_al", "2 m^2/m*m/m"] {
            assert!(length.is_match(text), "{text}");
        }
        for text in ["0.9", "mm", "0,9 mm", "1 2 mm", "5 mm//s", "31 ga_al", "9 kN", ". mm"] {
            assert!(!length.is_match(text), "{text}");
        }
    }
}
