//! The runs of a search: made when they are asked for, many at once, each known by its index.

use crate::study::hash::short_hash;
use crate::study::verify::Watch;
use crate::study::{Bars, Columns, Design, Designs, Row, Solved, Span, Subject, one, side_by_side};
use std::convert::Infallible;

/// Who keeps the runs as they come: the header of their table, and the line of the next one, which counts the designs so far.
pub type Keep<'a> = &'a mut (dyn FnMut(&[String], &[String]) + Sync);

/// The runs of a search, in the order in which they were made.
pub struct Trials<'a> {
    subject: &'a Subject,
    spans: &'a [Span],
    key: String,
    threads: usize,
    watch: &'a dyn Watch,
    /// Runs that are to be expected, for whoever counts.
    expected: usize,
    /// What came of each.
    pub rows: Vec<Row>,
    keep: Option<(Columns, Keep<'a>)>,
}

/// Counts on from the runs before.
pub(super) struct Further<'a> {
    pub watch: &'a dyn Watch,
    pub before: usize,
    pub expected: usize,
}

impl Watch for Further<'_> {
    fn wants_to_stop(&self) -> bool {
        self.watch.wants_to_stop()
    }

    fn ran(&self, done: usize, _: usize) {
        let done = self.before + done;
        self.watch.ran(done, self.expected.max(done + 1));
    }
}

impl<'a> Trials<'a> {
    /// Of a case, none made yet.
    pub fn new(subject: &'a Subject, spans: &'a [Span], threads: usize, watch: &'a dyn Watch, expected: usize) -> Self {
        let key = short_hash([subject.key(), &format!("{spans:?}")]);
        Self { subject, spans, key, threads, watch, expected, rows: Vec::new(), keep: None }
    }

    /// The same with someone who keeps its runs, the columns of which are those of the case as it stands.
    pub fn keeping(mut self, base: &Solved, keep: Keep<'a>) -> Self {
        self.keep = Some((Columns::of(&self, base), keep));
        self
    }

    /// The table of all runs: its header and its lines.
    pub fn table(&self, columns: &Columns) -> (Vec<String>, Vec<Vec<String>>) {
        (columns.header(), self.rows.iter().map(|row| columns.line(self, row)).collect())
    }

    /// Adds a run, the next by its index.
    pub(super) fn add(&mut self, mut row: Row) {
        row.design.index = self.rows.len() as u64;
        self.rows.push(row);
        if let Some((columns, keep)) = self.keep.take() {
            let line = self.rows.last().map(|row| columns.line(self, row)).unwrap_or_default();
            keep(&columns.header(), &line);
            self.keep = Some((columns, keep));
        }
    }

    /// Makes runs at values of the spans side by side, and returns their indices; `None` where they were interrupted.
    pub fn run(&mut self, points: &[Vec<f64>]) -> Option<Vec<usize>> {
        let first = self.rows.len();
        let designs: Vec<Design> =
            points.iter().enumerate().map(|(i, point)| design(self.spans, first + i, point)).collect();
        let further = Further { watch: self.watch, before: first, expected: self.expected };
        let subject = self.subject;
        let Ok(()) = side_by_side(
            &designs,
            self.threads,
            &further,
            |design| one(subject, design.clone(), Bars::Without, &further),
            |row| {
                self.add(row);
                Ok::<_, Infallible>(())
            },
        );
        let is_whole = self.rows.len() == first + points.len();
        is_whole.then(|| (first..self.rows.len()).collect())
    }
}

/// The design at values of the spans.
pub(super) fn design(spans: &[Span], index: usize, point: &[f64]) -> Design {
    let values: Vec<_> = spans.iter().zip(point).map(|(span, x)| span.values(*x)).collect();
    let settings = spans.iter().zip(&values).flat_map(|(span, values)| span.settings(values)).collect();
    Design { index: index as u64, values: values.into_iter().flatten().collect(), settings }
}

impl Designs for Trials<'_> {
    fn subject(&self) -> &Subject {
        self.subject
    }

    fn key(&self) -> &str {
        &self.key
    }

    fn headers(&self) -> Vec<String> {
        self.spans.iter().flat_map(Span::keys).map(|vary| vary.header()).collect()
    }

    fn count(&self) -> u64 {
        self.rows.len() as u64
    }

    fn design(&self, index: u64) -> Design {
        self.rows[index as usize].design.clone()
    }
}

/// Why runs came to nothing, each reason once with how often.
pub fn reasons(all: impl Iterator<Item = String>) -> Vec<(String, usize)> {
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for why in all {
        match reasons.iter_mut().find(|(known, _)| *known == why) {
            Some((_, count)) => *count += 1,
            None => reasons.push((why, 1)),
        }
    }
    reasons
}
