//! Advice: of changes that were solved, those that help.

use super::*;
use std::cmp::Reverse;

const MOST: usize = 3;
/// Least gain of a number that is worth a change, as a share of it \[–\] and in points of percent: declared.
const WORTH: f64 = 0.05;
const POINTS: f64 = 2.0;
/// Rows that ask for less pull: no shop holds the sheet more against them.
const PULLED: [&str; 6] = ["tearing", "forming_limit", "thinning", "fracture", "ironing", "localisation"];
const PULLS: [(&str, bool); 4] =
    [("pressure", true), ("holder force", true), ("bead force", true), ("holder gap", false)];

/// Rows that no change of a size moves: input that is missing, drives, and the solution itself.
pub(super) const NO_DESIGN: [&str; 6] =
    ["overlap", "idle_tool", "friction", "hardening_range", "yield_condition", "solution_quality"];

/// Change of one size that was solved.
pub struct Tried {
    /// Size with its new value: `die radius 8 mm`.
    pub words: String,
    /// Size, of which one value is given.
    pub size: &'static str,
    /// True of a larger value.
    pub is_more: bool,
    /// Verdict with it.
    pub findings: Vec<Finding>,
}

/// Whether a row asks for another design.
pub fn is_open(row: &Finding) -> bool {
    row.light > Light::Green && !NO_DESIGN.contains(&row.key)
}

/// Puts the changes that help beside the worst row that each improves, the best first.
pub fn advise(findings: &mut [Finding], tried: &[Tried]) {
    let own = |key: &str| judgements(findings).find(|own| own.key == key).map_or(Light::Green, |own| own.light);
    let worsens = |new: &Finding| new.light > own(new.key).max(Light::Green);
    let mut helpful: Vec<(&Tried, usize, f64)> = Vec::new();
    for one in tried.iter().filter(|one| !judgements(&one.findings).any(worsens)) {
        // The gap or a ring more is what a shop changes.
        let open = findings.iter().enumerate().filter(|(_, row)| is_open(row) && row.key != "ironing");
        let gains = open.filter_map(|(i, row)| Some((i, one.gain(row)?)));
        helpful.extend(gains.min_by_key(|(i, _)| Reverse(findings[*i].light)).map(|(row, gain)| (one, row, gain)));
    }
    helpful.sort_by(|a, b| score(&a.0.findings).cmp(&score(&b.0.findings)).then(b.2.total_cmp(&a.2)));
    let (mut sizes, mut texts): (Vec<&str>, Vec<(usize, String)>) = Default::default();
    for (one, row, _) in helpful {
        let text = one.text(&findings[row]).filter(|_| sizes.len() < MOST && !sizes.contains(&one.size));
        if let Some(text) = text {
            sizes.push(one.size);
            texts.push((row, text));
        }
    }
    for (i, row) in findings.iter_mut().enumerate() {
        let own = texts.iter().filter(|(of, _)| *of == i).map(|(_, text)| text.as_str());
        // The over-bend and the cut of a hole are no sizes of the case.
        let kept = ["springback", "edge"].contains(&row.key).then_some(row.advice.as_str());
        let own: Vec<&str> = kept.into_iter().chain(own).collect();
        if !own.is_empty() {
            row.advice = own.join("; or ");
        }
    }
}

impl Tried {
    fn gain(&self, row: &Finding) -> Option<f64> {
        let pulls = PULLS.contains(&(self.size, self.is_more)) && PULLED.contains(&row.key);
        let new = judgements(&self.findings).find(|n| n.key == row.key && n.light > Light::Grey && !pulls)?;
        let by = row.limits().and_then(|limits| {
            let by = row.value()? - new.value()?;
            Some(if limits.sense == Sense::AtMost { by } else { -by })
        });
        let least = row.quantity.as_ref().map_or(0.0, |own| {
            own.amount.bar.unwrap_or(0.0).max(if own.amount.unit == Unit::Percent { POINTS } else { 0.0 })
        });
        match (row.light as usize).checked_sub(new.light as usize)? {
            _ if by.is_some_and(|by| by < least) => None,
            0 if row.light == Light::Red => None,
            0 => Some(by? / row.value()?.abs()).filter(|share| *share >= WORTH).map(|share| share.min(0.99)),
            lights => Some(lights as f64),
        }
    }

    /// `die radius 8 mm: 21 → 14 %`; the row's limit stands beside it. `None` if no digit changes.
    fn text(&self, row: &Finding) -> Option<String> {
        let Self { words, findings, .. } = self;
        let Some(new) = judgements(findings).find(|new| new.key == row.key) else { return Some(words.clone()) };
        let amount = |row: &Finding| row.limits().and(row.quantity.as_ref()).map(|q| Amount { bar: None, ..q.amount });
        match amount(row).zip(amount(new)) {
            Some((from, to)) if from.parts().0 == to.parts().0 => None,
            Some((from, to)) => Some(format!("{words}: {} → {to}", from.parts().0)),
            None => Some(format!("{words}: {} → {}", row.light.name(), new.light.name())),
        }
    }
}

fn score(findings: &[Finding]) -> (Light, usize, usize) {
    let lights = || judgements(findings).filter(|row| !NO_DESIGN.contains(&row.key)).map(|row| row.light);
    let count = |light| lights().filter(|own| *own == light).count();
    (lights().max().unwrap_or(Light::Grey), count(Light::Red), count(Light::Amber))
}
