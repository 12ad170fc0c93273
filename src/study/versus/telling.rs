//! The table of differences as it is told, on a screen and in a report.

use super::{Change, Member, Versus};
use crate::assess::Light;
use crate::study::verify::Of;
use crate::units::{Amount, joined};

/// The columns of the table.
pub const COLUMNS: [&str; 4] = ["Quantity", "Run", "Value", "Difference to A"];

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it is of.
    pub label: String,
    /// Of every run, in their order.
    pub of_runs: Vec<Said>,
}

/// What a row says of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// The number with its error bar, or a word.
    pub value: String,
    /// How it differs from the first run's, or what stands behind a light; may be empty.
    pub change: String,
    /// Of a verdict.
    pub light: Option<Light>,
}

/// Where a run has no such number.
const NOTHING: &str = "–";

impl Versus {
    /// What letters and numbers stand for: runs, then measured curves.
    pub fn legend(&self) -> Vec<String> {
        let curves = self.curves().map(|(i, curve)| curve.label(i));
        self.members.iter().map(Member::label).chain(curves).collect()
    }

    /// Verdict and end, then every number but those that the verdict alone judges, then how far what was measured is.
    pub fn lines(&self) -> Vec<Line> {
        let of_runs = |said: &dyn Fn(&Member) -> Said| self.members.iter().map(said).collect();
        let mut lines = vec![
            Line { label: "Verdict".into(), of_runs: of_runs(&verdict) },
            Line { label: "End".into(), of_runs: of_runs(&|member| Said::of(member.outcome().end.why.clone())) },
        ];
        for compared in self.compared().into_iter().filter(|compared| compared.number.of != Of::Verdict) {
            let changes = std::iter::once(&Change::None).chain(&compared.changes);
            let said = compared.values.iter().zip(changes).map(|(value, change)| Said {
                change: change.told(),
                ..Said::of(value.map_or_else(|| NOTHING.into(), String::from))
            });
            lines.push(Line { label: compared.number.label.into(), of_runs: said.collect() });
        }
        for misfit in self.misfits() {
            let said = |found: &Option<(Amount, usize)>| match found {
                Some((rms, n)) => {
                    Said { change: format!("at {n} of {all} points", n = *n, all = misfit.points), ..Said::of(*rms) }
                }
                None => Said::of(NOTHING),
            };
            let label = format!("Off curve {n}, r.m.s.", n = misfit.number);
            lines.push(Line { label, of_runs: misfit.of_members.iter().map(said).collect() });
        }
        lines
    }
}

impl Said {
    fn of(value: impl Into<String>) -> Self {
        Self { value: value.into(), change: String::new(), light: None }
    }
}

/// The light, and the rows that it is from.
fn verdict(member: &Member) -> Said {
    let rows = match member.light {
        Light::Red => &member.red[..],
        Light::Amber => &member.amber,
        _ => &[],
    };
    let change = joined(rows.iter().map(|row| (*row).into()), ", ");
    Said { change, light: Some(member.light), ..Said::of(member.light.name()) }
}
