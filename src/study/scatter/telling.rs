//! What a sample says, in the words of the shop.

use super::found::{Event, Found, Influence, What};
use crate::assess::Light;
use crate::units::{Amount, joined};

/// Rank correlations below say nothing, little, and those above say nearly all \[–\].
const NOTHING: f64 = 0.1;
const LITTLE: f64 = 0.5;
const NEARLY_ALL: f64 = 0.9;

/// What scatters, as it is called.
pub fn called(key: &str) -> String {
    let known = |key: &str| match key {
        "friction" => "friction".into(),
        "strength" => "strength".into(),
        "blank.thickness" => "thickness".into(),
        "tools.holder.force" => "holder force".into(),
        other => String::from(other.to_owned()),
    };
    joined(key.split(" & ").map(known), " & ")
}

/// A share of parts, in percent.
fn parts(share: f64) -> Amount {
    Amount::share(share)
}

impl Influence {
    /// What a light hangs on most, and how much: `friction decides 71 % of it`, `it goes with friction, closely`.
    pub fn told(&self, found: &Found) -> Option<String> {
        self.most(found, |factor, _| format!("it goes with {factor}"))
    }

    /// The same of a number, which rises or falls: `it falls with thickness, closely`.
    pub fn of_number(&self, found: &Found) -> Option<String> {
        self.most(found, |factor, rank| match rank > 0.0 {
            true => format!("it rises with {factor}"),
            false => format!("it falls with {factor}"),
        })
    }

    fn most(&self, found: &Found, goes: impl Fn(String, f64) -> String) -> Option<String> {
        if let Some(indices) = &self.indices {
            let (group, index) =
                indices.iter().enumerate().max_by(|a, b| a.1.total.value.total_cmp(&b.1.total.value))?;
            let [first, total] = [index.first.value, index.total.value].map(|share| parts(share.clamp(0.0, 1.0)));
            let factor = called(&found.groups[group]);
            // What intervals do not tell apart is not told apart.
            return Some(if index.total.low < index.first.high {
                format!("{factor} decides {total} of it")
            } else {
                format!("{factor} decides {first} of it alone, {total} with others")
            });
        }
        let ranks = self.ranks.iter().enumerate().filter_map(|(i, rank)| Some((i, (*rank)?)));
        let (factor, rank) = ranks.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let how = match rank.abs() {
            rank if rank > NEARLY_ALL => "closely",
            rank if rank > LITTLE => "",
            _ => "weakly",
        };
        (rank.abs() > NOTHING).then(|| joined([goes(called(&found.factors[factor]), rank), how.into()], ", "))
    }
}

impl Event {
    /// `thinning is red in 3.2 % of parts, 2.1 to 4.7 %`; of so many parts that were tried
    fn told(&self, of: usize) -> String {
        let [chance, low, high] = [self.chance.value, self.chance.low, self.chance.high].map(parts);
        match (self.what, self.light) {
            (What::Tear, _) if self.hits == 0 => {
                format!("none of {of} parts tore, though up to {high} may")
            }
            (What::Tear, _) => {
                format!("{chance} of the parts tear, {low} to {high}")
            }
            (What::Verdict, Light::Red) if self.hits == 0 => {
                format!("none of {of} parts was red, though up to {high} may be")
            }
            (What::Verdict, Light::Red) => {
                format!("{chance} of the parts are red, {low} to {high}")
            }
            (What::Verdict, _) => format!("{chance} of the parts are amber at worst, {low} to {high}"),
            (What::Row(_), Light::Red) => {
                format!("{label} is red in {chance} of the parts, {low} to {high}", label = self.label)
            }
            (What::Row(_), _) => {
                format!("{label} is amber in {chance} of the parts, {low} to {high}", label = self.label)
            }
        }
    }
}

impl Found {
    /// Parts that say something.
    fn known(&self) -> usize {
        self.runs - self.failed
    }

    /// The answer in a sentence: how many tear, how many are red.
    pub fn sentence(&self) -> String {
        let told = |what: What| {
            let event = self.events.iter().find(|event| event.what == what && event.light == Light::Red)?;
            let decides = event.influence.told(self).filter(|_| event.hits > 0);
            Some(joined([event.told(self.known())].into_iter().chain(decides), "; "))
        };
        joined([What::Tear, What::Verdict].into_iter().filter_map(told), "; ")
    }

    /// What is told below: lights that are red in some run, how sure this is, and runs that say nothing.
    pub fn sentences(&self) -> Vec<String> {
        let red = self.events.iter().filter(|event| event.light == Light::Red && matches!(event.what, What::Row(_)));
        let red =
            red.map(|event| joined([event.told(self.known())].into_iter().chain(event.influence.told(self)), "; "));
        let sure = format!(
            "from {n} runs; each interval holds the truth in 95 of 100 such studies, if what scatters is as it was given",
            n = self.known()
        );
        let failed = (!self.failures.is_empty()).then(|| {
            let of = |(why, count): (&String, &usize)| match *count {
                1 => format!("{n} {why}", n = 1_usize),
                count => format!("{count} such as “{why}”"),
            };
            format!("{n} runs say nothing of the part and are left out: {why}; were all of them red, {share} of the parts would be \
                 red besides", n = self.failures.values().sum::<usize>(), why = joined(self.failures.iter().map(of), ", "), share = parts(self.failed as f64 / self.runs as f64))
        });
        red.chain([sure]).chain(failed).collect()
    }
}
