//! What a run must keep to: `no red`, `thinning < 20 % and punch_force <= 60 kN`.
//!
//! ```text
//! no red                 no row of the verdict is red            no red or amber
//! ROW not red            that row is not                         wrinkling not red or amber
//! no tear                the sheet does not tear
//! NUMBER < VALUE UNIT    <, <=, >, >= of a number of the run      draw_in >= 8 mm
//! ... and ...            all of them
//! ```
//!
//! A number of a sheet that tore is none of the part: such a run keeps no condition on a number.

use super::number::Named;
use crate::assess::Light;
use crate::study::{Judged, Row, Solved, StudyError};
use crate::units::{Parsed, did_you_mean, parse};

/// What a run must keep to.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// As it was written.
    pub text: String,
    terms: Vec<Term>,
}

#[derive(Clone, Debug, PartialEq)]
enum Term {
    /// No row of these is of the light, or worse.
    Light {
        row: Option<String>,
        worst: Light,
    },
    Untorn,
    Number {
        name: Named,
        is_less: bool,
        or_equal: bool,
        limit: Parsed,
    },
}

/// What is said of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// All is kept.
    Holds,
    /// Something is not.
    Fails,
    /// The run says neither, and why.
    Neither(String),
}

const USAGE: &str = "write \"no red\", \"no red or amber\", \"no tear\", \"ROW not red\" or \"NUMBER < VALUE UNIT\", \
                     several joined by `and`, such as \"no red and thinning < 20 %\"";

impl Condition {
    /// Reads a condition.
    ///
    /// # Errors
    /// When a part of it is none of the above.
    pub fn read(text: &str) -> Result<Self, StudyError> {
        let terms = text.split(" and ").map(term).collect::<Result<_, _>>()?;
        Ok(Self { text: text.split_whitespace().collect::<Vec<_>>().join(" "), terms })
    }

    /// Refuses a condition on a number or a row that a run of the case does not have.
    ///
    /// # Errors
    /// Where there is none of that name, or its limit is in another unit.
    pub fn check(&self, solved: &Solved) -> Result<(), StudyError> {
        for term in &self.terms {
            match term {
                Term::Number { name, limit, .. } => drop(name.limit(name.find(solved)?, limit)?),
                Term::Light { row: Some(row), .. } if !solved.judged.iter().any(|judged| judged.key == row) => {
                    let rows = || solved.judged.iter().map(|judged| judged.key);
                    let near = did_you_mean(row, rows());
                    let help = format!("{near}it has {}", rows().collect::<Vec<_>>().join(", "));
                    return Err(StudyError::new(format!("the verdict on this case has no row `{row}`"), help));
                }
                Term::Light { .. } | Term::Untorn => {}
            }
        }
        Ok(())
    }

    /// The numbers that it limits, each with its limit.
    pub fn numbers(&self) -> impl Iterator<Item = (&Named, &Parsed)> {
        self.terms.iter().filter_map(|term| match term {
            Term::Number { name, limit, .. } => Some((name, limit)),
            _ => None,
        })
    }

    /// What is said of a run.
    pub fn judge(&self, row: &Row) -> Said {
        let solved = match usable(row) {
            Ok(solved) => solved,
            Err(why) => return Said::Neither(why),
        };
        let mut all = Said::Holds;
        for said in self.terms.iter().map(|term| term.judge(solved)) {
            match said {
                Said::Fails => return Said::Fails,
                Said::Neither(_) => all = said,
                Said::Holds => {}
            }
        }
        all
    }

    /// How far each part of it is kept, over its limit: below 0 where it is not \[–\]; one value for every part, whatever the
    /// run came to. A part that no number says is kept or not by 1.
    pub fn margins(&self, row: &Row) -> Vec<f64> {
        let Ok(solved) = usable(row) else { return vec![-1.0; self.terms.len()] };
        self.terms.iter().map(|term| term.margin(solved)).collect()
    }

    /// Its parts, as they were written.
    pub fn parts(&self) -> impl Iterator<Item = &str> {
        self.text.split(" and ").map(str::trim)
    }
}

/// What came of a run that says something of the part.
pub(super) fn usable(row: &Row) -> Result<&Solved, String> {
    let solved = row.result.as_ref().map_err(|why| String::from(first_line(why)))?;
    if solved.outcome.end.lost { Err(solved.outcome.end.why.clone()) } else { Ok(solved) }
}

/// The first line of a reason, without the mark that errors of case files begin with.
fn first_line(why: &str) -> String {
    let line = why.lines().map(|line| line.trim().trim_start_matches(['×', ' '])).find(|line| !line.is_empty());
    line.unwrap_or("no reason").to_owned()
}

impl Term {
    fn judge(&self, solved: &Solved) -> Said {
        let kept = |is: bool| if is { Said::Holds } else { Said::Fails };
        match self {
            Self::Untorn => kept(!solved.tears),
            Self::Light { row, worst } => {
                let is_lit = |rows: &[&str]| rows.iter().any(|key| row.as_ref().is_none_or(|row| row == key));
                kept(!(is_lit(&solved.red) || *worst == Light::Amber && is_lit(&solved.amber)))
            }
            Self::Number { .. } if solved.tears => Said::Fails,
            Self::Number { name, is_less, or_equal, limit } => {
                let of = name.find(solved).and_then(|number| Ok((number.amount.value, name.limit(number, limit)?)));
                match of {
                    Ok((value, limit)) if value == limit => kept(*or_equal),
                    Ok((value, limit)) => kept((value < limit) == *is_less),
                    Err(_) => Said::Neither(format!("the run has no number {name}", name = name.text)),
                }
            }
        }
    }

    fn margin(&self, solved: &Solved) -> f64 {
        let kept = if self.judge(solved) == Said::Holds { 1.0 } else { -1.0 };
        match self {
            _ if solved.tears => -1.0,
            Self::Untorn => kept,
            Self::Light { row, worst } => {
                let rows = solved.judged.iter().filter(|judged| row.as_ref().is_none_or(|row| row == judged.key));
                let to = |judged: &Judged| if *worst == Light::Amber { judged.to_amber() } else { judged.to_red() };
                let least = rows.filter_map(to).fold(f64::INFINITY, f64::min);
                // A light that no number says, or the other way round, counts as it is.
                if (least < 0.0) == (kept < 0.0) { least.clamp(-1.0, 1.0) } else { 0.1 * kept }
            }
            Self::Number { name, is_less, limit, .. } => {
                let of = name.find(solved).and_then(|number| Ok((number.amount.value, name.limit(number, limit)?)));
                let Ok((value, limit)) = of else { return kept };
                let inside = if *is_less { limit - value } else { value - limit };
                inside / if limit == 0.0 { 1.0 } else { limit.abs() }
            }
        }
    }
}

fn term(text: &str) -> Result<Term, StudyError> {
    let wrong = || StudyError::new(format!("`{}` is no condition", text.trim()), USAGE);
    let words: Vec<&str> = text.split_whitespace().collect();
    let worst = |words: &[&str]| match words {
        ["red"] => Some(Light::Red),
        ["amber"] | ["red", "or", "amber"] | ["amber", "or", "red"] => Some(Light::Amber),
        _ => None,
    };
    if let ["no", "tear" | "tears" | "tearing"] = words[..] {
        return Ok(Term::Untorn);
    }
    if let Some(worst) = words.strip_prefix(&["no"]).and_then(worst) {
        return Ok(Term::Light { row: None, worst });
    }
    if let Some(at) = words.iter().position(|word| *word == "not") {
        let row =
            words[..at].iter().filter(|word| **word != "is").copied().collect::<Vec<_>>().join("_").to_lowercase();
        return worst(&words[at + 1..])
            .filter(|_| !row.is_empty())
            .map(|worst| Term::Light { row: Some(row), worst })
            .ok_or_else(wrong);
    }
    let at = text.find(['<', '>', '≤', '≥']).ok_or_else(wrong)?;
    let (name, rest) = text.split_at(at);
    let sign = rest.chars().next().unwrap_or('<');
    let rest = &rest[sign.len_utf8()..];
    let (or_equal, value) = match rest.strip_prefix('=') {
        Some(value) => (true, value),
        None => (matches!(sign, '≤' | '≥'), rest),
    };
    let limit = quantity(value)?;
    Ok(Term::Number {
        name: Named::read(name).ok_or_else(wrong)?, is_less: matches!(sign, '<' | '≤'), or_equal, limit
    })
}

/// A number with a unit as in a case file, where ° are degrees too.
pub(super) fn quantity(text: &str) -> Result<Parsed, StudyError> {
    let text = text.trim();
    let text = if text.ends_with("°C") { text.to_owned() } else { text.replace('°', " deg") };
    parse(&text)
        .map_err(|error| StudyError::new(error.to_string(), "write a number with a unit, such as 20 % or 60 kN"))
}
