//! What came of the designs of a study, column by column: of each no more is kept than its row.

use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::study::{Row, Solved, Value};

/// Numbers by their headers, and words by theirs.
pub type Table<'py> = (Vec<(String, Bound<'py, PyArray1<f64>>)>, Vec<(String, Vec<String>)>);

/// Rows on their way.
pub struct Rows {
    /// Columns of what is varied.
    headers: Vec<String>,
    /// Its values, in their order.
    varied: Vec<Vec<Value>>,
    /// By their headers, in the order in which they came up; NaN where a design has no such number.
    numbers: Vec<(String, Vec<f64>)>,
    seconds: Vec<f64>,
    words: [(&'static str, Vec<String>); 5],
}

impl Rows {
    /// None yet, of designs in which this is varied.
    pub fn of(headers: Vec<String>) -> Self {
        Self {
            varied: vec![Vec::new(); headers.len()],
            headers,
            numbers: Vec::new(),
            seconds: Vec::new(),
            words: ["verdict", "red", "amber", "end", "reason"].map(|name| (name, Vec::new())),
        }
    }

    /// The next design's.
    pub fn push(&mut self, row: Row) {
        let before = self.seconds.len();
        for (column, value) in self.varied.iter_mut().zip(row.design.values) {
            column.push(value);
        }
        if let Ok(solved) = &row.result {
            for (header, value) in solved.named() {
                match self.numbers.iter_mut().find(|(known, _)| *known == header) {
                    Some((_, column)) => column.push(value),
                    None => {
                        let mut column = vec![f64::NAN; before];
                        column.push(value);
                        self.numbers.push((header, column));
                    }
                }
            }
        }
        self.seconds.push(row.seconds);
        self.numbers.iter_mut().for_each(|(_, column)| column.resize(before + 1, f64::NAN));
        for ((_, column), word) in self.words.iter_mut().zip(words(row.result)) {
            column.push(word);
        }
    }

    /// As arrays.
    pub fn table(self, py: Python<'_>) -> Table<'_> {
        let (mut numbers, mut words) = (Vec::new(), Vec::new());
        for (header, values) in self.headers.into_iter().zip(self.varied) {
            match values.iter().map(|value| value.number).collect::<Option<Vec<f64>>>() {
                Some(values) => numbers.push((header, values.into_pyarray(py))),
                None => words.push((header, values.into_iter().map(|value| value.text).collect())),
            }
        }
        let found = self.numbers.into_iter().chain([("seconds".to_owned(), self.seconds)]);
        numbers.extend(found.map(|(header, values)| (header, values.into_pyarray(py))));
        words.extend(self.words.into_iter().map(|(name, column)| (name.to_owned(), column)));
        (numbers, words)
    }
}

/// The light of the verdict, its rows that are red and amber, and how a design ended and why.
fn words(result: Result<Solved, String>) -> [String; 5] {
    match result {
        Ok(Solved { outcome, light, red, amber, .. }) => {
            let end = outcome.end;
            let reason = if end.complete { String::new() } else { end.why.to_string() };
            [light.name().into(), red.join(" "), amber.join(" "), end.kind.into(), reason]
        }
        Err(why) => [String::new(), String::new(), String::new(), "not run".into(), why],
    }
}
