//! What came of the designs of a study, column by column: of each no more is kept than its row.

use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::study::{Columns, Row, Solved, Value, Zone};

/// Which designs the rows are of; numbers by their headers, and words by theirs.
pub type Table<'py> = (Bound<'py, PyArray1<u64>>, Vec<(String, Bound<'py, PyArray1<f64>>)>, Vec<(String, Vec<String>)>);

/// The columns of words.
const WORDS: [&str; 6] = ["verdict", "fails", "red", "amber", "end", "reason"];

/// Rows on their way.
pub struct Rows {
    indices: Vec<u64>,
    /// Columns of what is varied.
    headers: Vec<String>,
    /// Its values, in their order.
    varied: Vec<Vec<Value>>,
    /// By their headers, in the order in which they came up; NaN where a design has no such number.
    numbers: Vec<(String, Vec<f64>)>,
    /// What each took; of rows that were read it is not known.
    seconds: Vec<f64>,
    words: [Vec<String>; WORDS.len()],
}

impl Rows {
    /// None yet, of designs in which this is varied.
    pub fn of(headers: Vec<String>) -> Self {
        Self {
            indices: Vec::new(),
            varied: vec![Vec::new(); headers.len()],
            headers,
            numbers: Vec::new(),
            seconds: Vec::new(),
            words: Default::default(),
        }
    }

    /// Those of a study's table, with its digits; a half row at its end is none.
    pub fn read(headers: Vec<String>, columns: &Columns, table: &[u8]) -> Self {
        let mut rows = Self::of(headers);
        let whole = table.iter().rposition(|byte| *byte == b'\n').map_or(0, |last| last + 1);
        let mut reader = csv::Reader::from_reader(&table[..whole]);
        let header = reader.headers().cloned().unwrap_or_default();
        let place = |name: &str| header.iter().position(|own| own == name);
        let varied: Vec<Option<usize>> = columns.varied.iter().map(|name| place(name)).collect();
        let numbered = columns.numbers.iter().chain(&columns.bars);
        let numbers: Vec<(&String, Option<usize>)> = numbered.map(|name| (name, place(name))).collect();
        let [index, others] = ["index", "other_numbers"].map(place);
        let words = WORDS.map(place);
        for record in reader.records().flatten() {
            let field = |at: Option<usize>| at.and_then(|at| record.get(at)).unwrap_or_default();
            let number = |text: &str| text.parse::<f64>().ok();
            let values = varied.iter().map(|at| Value { text: field(*at).to_owned(), number: number(field(*at)) });
            let other = field(others).split(' ').filter_map(|pair| pair.split_once('='));
            let named = numbers.iter().map(|(name, at)| ((*name).clone(), number(field(*at))));
            let named = named.chain(other.map(|(name, value)| (name.to_owned(), number(value))));
            let named = named.filter_map(|(name, value)| Some((name, value?))).collect();
            let index = field(index).parse().unwrap_or_default();
            rows.add(index, values.collect(), named, words.map(|at| field(at).to_owned()));
        }
        rows
    }

    /// The next design's.
    pub fn push(&mut self, row: Row) {
        let named = row.result.iter().flat_map(|solved| {
            let errors = solved.errors().filter_map(|(header, half)| Some((header, half?)));
            solved.named().into_iter().chain(errors)
        });
        let named = named.collect();
        self.seconds.push(row.seconds);
        self.add(row.design.index, row.design.values, named, words(row.result));
    }

    fn add(&mut self, index: u64, values: Vec<Value>, named: Vec<(String, f64)>, words: [String; WORDS.len()]) {
        let before = self.indices.len();
        self.indices.push(index);
        for (column, value) in self.varied.iter_mut().zip(values) {
            column.push(value);
        }
        for (header, value) in named {
            match self.numbers.iter_mut().find(|(known, _)| *known == header) {
                Some((_, column)) => column.push(value),
                None => {
                    let mut column = vec![f64::NAN; before];
                    column.push(value);
                    self.numbers.push((header, column));
                }
            }
        }
        self.numbers.iter_mut().for_each(|(_, column)| column.resize(before + 1, f64::NAN));
        for (column, word) in self.words.iter_mut().zip(words) {
            column.push(word);
        }
    }

    /// As arrays.
    pub fn table(self, py: Python<'_>) -> Table<'_> {
        let (mut numbers, mut words) = (Vec::new(), Vec::new());
        for (header, values) in self.headers.into_iter().zip(self.varied) {
            // The case as it stands is no word.
            match values.iter().all(|value| value.number.is_some() || value.text.is_empty()) {
                true => {
                    let values: Vec<f64> = values.iter().map(|value| value.number.unwrap_or(f64::NAN)).collect();
                    numbers.push((header, values.into_pyarray(py)));
                }
                false => words.push((header, values.into_iter().map(|value| value.text).collect())),
            }
        }
        let seconds = (self.seconds.len() == self.indices.len()).then_some(("seconds".to_owned(), self.seconds));
        let found = self.numbers.into_iter().chain(seconds);
        numbers.extend(found.map(|(header, values)| (header, values.into_pyarray(py))));
        words.extend(WORDS.iter().map(|name| (*name).to_owned()).zip(self.words));
        (self.indices.into_pyarray(py), numbers, words)
    }
}

/// The light of the verdict, the ways in which a design fails, its rows that are red and amber, and how it ended and why.
fn words(result: Result<Solved, String>) -> [String; WORDS.len()] {
    match result {
        Ok(Solved { outcome, light, red, amber, fails, .. }) => {
            let end = outcome.end;
            let reason = if end.complete { String::new() } else { end.why.to_string() };
            let fails: Vec<&str> = fails.iter().map(|zone| zone.key()).collect();
            [light.name().into(), fails.join(" "), red.join(" "), amber.join(" "), end.kind.into(), reason]
        }
        Err(why) => {
            let nothing = String::new;
            [nothing(), Zone::Lost.key().into(), nothing(), nothing(), "not run".into(), why]
        }
    }
}
