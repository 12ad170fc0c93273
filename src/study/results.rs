//! A study read back from its table: what its pictures and its answer are made of, whoever ran it.

use super::StudyError;
use super::plan::{Designs, How, Plan};
use super::row::{Columns, Solved, header};
use super::varied::Varied;
use super::zone::Zone;
use crate::assess::Light;
use crate::study::verify::{Number, Of};
use crate::units::Sense;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// A study with all of its rows.
#[derive(Clone, Debug)]
pub struct Results<'a> {
    /// What was run.
    pub plan: &'a Plan,
    /// What came of the case as it stands.
    pub base: &'a Solved,
    /// Its axes.
    pub axes: Vec<Varied>,
    /// What came of each design, by its index.
    pub rows: Vec<Found>,
}

/// What came of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// In the order of the base's numbers, in their units; NaN where it has none.
    pub numbers: Vec<f64>,
    /// Half the error bars likewise; empty where none were asked for.
    pub bars: Vec<f64>,
    /// `None` where it was not run.
    pub light: Option<Light>,
    /// Every way in which it fails; empty where it is sound.
    pub fails: Vec<Zone>,
    /// The verdict's rows that are red.
    pub red: Vec<String>,
}

impl<'a> Results<'a> {
    /// Reads a study's table.
    ///
    /// # Errors
    /// When it cannot be read or has not the rows of the study.
    pub fn read(path: &Path, plan: &'a Plan, base: &'a Solved) -> Result<Self, StudyError> {
        let shown = path.display().to_string();
        let file = File::open(path).map_err(|error| wrong(&shown, format!("cannot be read: {error}")))?;
        Self::of(file, &shown, plan, base)
    }

    /// The same of what is called so.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn of(table: impl Read, shown: &str, plan: &'a Plan, base: &'a Solved) -> Result<Self, StudyError> {
        let wrong = |what: String| wrong(shown, what);
        let columns = Columns::of(plan, base);
        let mut table = csv::Reader::from_reader(table);
        let headers = table.headers().map_err(|error| wrong(format!("cannot be read: {error}")))?.clone();
        let place = |name: &String| headers.iter().position(|own| own == name);
        let places = |names: &[String]| names.iter().map(place).collect::<Option<Vec<usize>>>();
        let named = |name: &str| place(&name.to_owned());
        let all = (places(&columns.numbers), places(&columns.bars), named("verdict"), named("fails"), named("red"));
        let (Some(numbers), Some(bars), Some(verdict), Some(fails), Some(red)) = all else {
            return Err(wrong("has other columns than this study".into()));
        };
        let mut rows = Vec::new();
        for record in table.records() {
            let record = record.map_err(|error| wrong(format!("cannot be read: {error}")))?;
            let number = |place: &usize| record[*place].parse().unwrap_or(f64::NAN);
            rows.push(Found {
                numbers: numbers.iter().map(number).collect(),
                bars: bars.iter().map(number).collect(),
                light: LIGHTS.into_iter().find(|light| light.name() == &record[verdict]),
                fails: record[fails].split(' ').filter_map(Zone::from_key).collect(),
                red: record[red].split(' ').filter(|row| !row.is_empty()).map(str::to_owned).collect(),
            });
        }
        if rows.len() as u64 != plan.count() {
            return Err(wrong(format!("has {} rows of {}", rows.len(), plan.count())));
        }
        let axes = plan.axes().iter().map(|axis| Varied::of(axis, plan.subject())).collect();
        Ok(Self { plan, base, axes, rows })
    }

    /// The numbers that designs are compared by, each with its place in [`Found::numbers`].
    pub fn numbers(&self) -> impl Iterator<Item = (usize, &Number)> {
        self.base.outcome.numbers.iter().enumerate()
    }

    /// The place of a number.
    pub fn place(&self, of: Of, key: &str) -> Option<usize> {
        self.numbers().find(|(_, number)| number.of == of && number.key == key).map(|(place, _)| place)
    }

    /// The place of the number of a row of the verdict that turns red at a limit, the limit, and on which side of it the number
    /// is good.
    pub fn limit(&self, row: &str) -> Option<(usize, f64, Sense)> {
        let judged = self.base.judged.iter().find(|judged| judged.key == row)?;
        let limits = judged.limits?;
        Some((self.place(Of::Verdict, row)?, limits.red?, limits.sense))
    }

    /// The rows that its pictures are about: of one at a time all but the case as it stands.
    pub fn designs(&self) -> &[Found] {
        let first = usize::from(self.plan.how() == How::OneAtATime);
        &self.rows[first.min(self.rows.len())..]
    }

    /// Places of the axes that have several values: one value by itself has no borders.
    pub fn wide(&self) -> Vec<usize> {
        (0..self.axes.len()).filter(|axis| self.axes[*axis].values.len() > 1).collect()
    }

    /// The column of a number.
    pub fn column(&self, place: usize) -> String {
        header(&self.base.outcome.numbers[place])
    }
}

fn wrong(shown: &str, what: String) -> StudyError {
    StudyError::new(format!("{shown} {what}"), "begin anew with --restart, or choose another --out")
}

const LIGHTS: [Light; 4] = [Light::Grey, Light::Green, Light::Amber, Light::Red];

impl Found {
    /// Whether it says anything.
    pub fn is_known(&self) -> bool {
        !self.fails.contains(&Zone::NoResult)
    }

    /// Whether it does not fail.
    pub fn is_sound(&self) -> bool {
        self.fails.is_empty()
    }

    /// The way in which it fails that is asked for first; `None` where it is sound.
    pub fn worst(&self) -> Option<Zone> {
        self.fails.first().copied()
    }
}
