//! What is told of fitted laws.

use super::estimate::Estimates;
use super::flow_curve::FlowCurve;
use super::law_fits::{AS_GOOD, LawFits};
use crate::units::{Amount, Digits, joined};
use crate::units::{Unit, significant};

/// Pairs of numbers that are as closely tied go together \[–\].
const TIED: f64 = 0.98;
/// The points say nothing for one law over another whose criterion is larger by no more.
const NEAR: f64 = 10.0;
/// The strain beyond the points at which laws are compared, over their end \[–\].
const BEYOND: f64 = 2.0;
/// Stresses that differ by less are the same \[–\].
const SAME: f64 = 0.01;

/// A plain number to three digits.
fn number(value: f64) -> Amount {
    Amount::new(value, Unit::None, Digits::Significant(3))
}

/// Pairs of numbers that points cannot tell apart.
pub(super) fn tied(estimates: &Estimates, least: f64) -> Vec<String> {
    let pair = |(i, j, correlation): (usize, usize, f64)| {
        format!(
            "{first} and {second} can hardly be told apart by these points: correlation {correlation}; one may be off where the other makes up for it.",
            first = estimates.all[i].key,
            second = estimates.all[j].key,
            correlation = Amount::new(correlation, Unit::None, Digits::Decimals(2))
        )
    };
    estimates.alike(least).into_iter().map(pair).collect()
}

impl FlowCurve {
    /// What follows from the test, in a line.
    pub fn sentence(&self) -> String {
        let young = self.young.map(|young| {
            let amount = Amount::stress(significant(young, 3));
            match self.is_fitted {
                true => format!("slope of the elastic line {amount}"),
                false => format!("E {amount} as given"),
            }
        });
        let yields = self.yield_stress.map(|stress| format!("yields at {stress}", stress = Amount::stress(stress)));
        let end = match self.uniform {
            Some(uniform) => format!(
                "largest force at a plastic strain of {uniform}, {stress}: cut there",
                uniform = number(uniform),
                stress = Amount::stress(self.strength)
            ),
            None => "the force does not fall: no cut".into(),
        };
        let used = format!(
            "{n} points from {from} to {to}",
            n = self.points.len(),
            from = number(self.points.first().map_or(0.0, |p| p.strain)),
            to = number(self.end())
        );
        let r = self.r.map(|(r, error)| {
            format!("r {r}", r = Amount::new(r, Unit::None, Digits::Decimals(3)).with_bar(error.max(1e-3)))
        });
        let parts = young.into_iter().chain(yields).chain([end, used]).chain(r);
        format!("{file}: {parts}.", file = self.short_name(), parts = joined(parts, "; "))
    }
}

impl LawFits {
    /// Which law to use, and why; what to be careful about.
    pub fn sentences(&self) -> Vec<String> {
        let best = self.best();
        let mut told = Vec::new();
        if self.fits.len() > 1 {
            told.push(self.reason());
        }
        for estimate in &best.estimates.all {
            if let Some(bound) = estimate.pushed {
                told.push(format!(
                    "{key} is pushed against the end of its range, {bound}: the law is not made for these points.",
                    key = estimate.key,
                    bound = match estimate.unit.as_str() {
                        "" => number(bound),
                        _ => Amount::stress(bound),
                    }
                ));
            }
        }
        told.extend(tied(&best.estimates, TIED));
        if best.bows {
            told.push("The points lie to one side of the law and then to the other, in bows: the law is not quite of their shape, and standard errors, which know of scatter only, are too small.".into());
        }
        told.extend(self.beyond());
        told.extend(self.averages());
        told
    }

    fn reason(&self) -> String {
        let best = self.best();
        let others = || self.fits.iter().filter(|fit| fit.kind != best.kind);
        let next = others().filter(|fit| !fit.is_pushed()).min_by(|a, b| a.aic.total_cmp(&b.aic));
        let law = best.kind.label();
        match next {
            Some(next) if next.aic < best.aic + AS_GOOD && next.kind.count() > best.kind.count() => format!(
                "Use {law}: {other} with its {more} numbers is no better than chance allows, and {n} numbers are enough.",
                other = next.kind.label(),
                more = next.kind.count(),
                n = best.kind.count()
            ),
            Some(next) => format!(
                "Use {law}: it misses the points by {rms} in the mean, {other}, the next, by {more}; for its number of parameters that is better by {aic} on Akaike's scale, where 2 is chance and 10 is sure.",
                rms = Amount::new(best.rms, Unit::MPa, Digits::Significant(2)),
                other = next.kind.label(),
                more = Amount::new(next.rms, Unit::MPa, Digits::Significant(2)),
                aic = Amount::new(next.aic - best.aic, Unit::None, Digits::Significant(2))
            ),
            None => format!("Use {law}: numbers of all others are pushed against the end of their range."),
        }
    }

    /// What laws that fit as well say where no point is.
    fn beyond(&self) -> Option<String> {
        let best = self.best();
        let strain = BEYOND * self.end();
        let near = self.fits.iter().filter(|fit| fit.aic <= best.aic + NEAR || self.fits.len() <= 3);
        let stresses: Vec<f64> = near.map(|fit| fit.hardening.at(strain).stress).collect();
        let (low, high) = stresses.iter().fold((f64::INFINITY, 0.0), |(l, h): (f64, f64), s| (l.min(*s), h.max(*s)));
        let (stress, half) = best.band(strain, None);
        let own = format!(
            "Beyond the points, at a strain of {strain}, {law} says {stress}",
            strain = number(strain),
            law = best.kind.label(),
            stress = half.map_or(Amount::stress(stress), |half| Amount::stress(stress).with_bar(half))
        );
        match stresses.len() {
            1 => Some(format!("{own}, if the law holds there.")),
            _ if high - low < SAME * stress => Some(format!("{own}; laws that fit about as well say the same.")),
            _ => Some(format!(
                "{own}; laws that fit about as well say {low} to {high}: that is how much is not known there.",
                low = Amount::stress(low),
                high = Amount::stress(high)
            )),
        }
    }

    /// r̄ and Δr, where all three directions were measured.
    fn averages(&self) -> Option<String> {
        let [r0, r45, r90] = self.r_values()?;
        let decimal = |r: f64| Amount::new(r, Unit::None, Digits::Decimals(3));
        Some(format!(
            "r̄ = (r0 + 2 r45 + r90)/4 = {mean}, Δr = (r0 − 2 r45 + r90)/2 = {ears}.",
            mean = decimal(0.25 * (r0 + 2.0 * r45 + r90)),
            ears = decimal(0.5 * (r0 - 2.0 * r45 + r90))
        ))
    }
}
