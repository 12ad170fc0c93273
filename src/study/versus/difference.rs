//! The numbers of several runs, and what of their differences is more than error.

use super::{Member, Versus};
use crate::study::verify::Number;
use crate::units::{Amount, Digits, joined};

/// Two numbers nearer to each other than that, over their size, are one and the same \[–\]: what is written of them is.
const SAME: f64 = 1e-9;

/// A number of all runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// The number, as the first run that has it tells it.
    pub number: Number,
    /// Of every run, with its error bar where there is one; `None` where a run has no such number.
    pub values: Vec<Option<Amount>>,
    /// Against the first run, of every run after it.
    pub changes: Vec<Change>,
}

/// What a number is in another run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// One of the two has no such number.
    None,
    /// The same.
    Same,
    /// Another number by so much \[its unit\], but no more than both error bars together leave open.
    Within(Amount),
    /// By so much, and that over the first one's size \[–\] where that says something.
    By(Amount, Option<f64>),
}

impl Versus {
    /// Every number that a run has, in the order of telling.
    pub fn compared(&self) -> Vec<Compared> {
        let mut numbers: Vec<&Number> = Vec::new();
        for number in self.members.iter().flat_map(|member| &member.outcome().numbers) {
            if !numbers.iter().any(|known| known.is(number)) {
                numbers.push(number);
            }
        }
        numbers.into_iter().map(|number| Compared::of(number, &self.members)).collect()
    }
}

impl Compared {
    fn of(number: &Number, members: &[Member]) -> Self {
        let found: Vec<_> = members.iter().map(|member| member.number(number)).collect();
        let told = found.iter().map(|found| {
            let (number, half) = found.as_ref()?;
            let half = half.filter(|half| *half > 0.0);
            Some(half.map_or(number.amount, |half| number.amount.with_bar(half)))
        });
        let values: Vec<Option<Amount>> = told.collect();
        let (first, others) = found.split_first().map_or((&None, &[][..]), |(first, others)| (first, others));
        let changes = others.iter().map(|other| change(first.as_ref(), other.as_ref())).collect();
        Self { number: number.clone(), values, changes }
    }
}

fn change(first: Option<&(Number, Option<f64>)>, other: Option<&(Number, Option<f64>)>) -> Change {
    let (Some((a, of_a)), Some((b, of_b))) = (first, other) else { return Change::None };
    let by = b.amount.value - a.amount.value;
    if by.abs() <= SAME * a.amount.value.abs() {
        return Change::Same;
    }
    // Runs of one mesh err alike, and are nearer to each other than to the truth: the sum is on the safe side.
    let open = of_a.zip(*of_b).map(|(a, b)| a + b);
    let mut amount = a.amount;
    amount.value = by;
    match open {
        Some(open) if by.abs() <= open => Change::Within(amount),
        _ => {
            let is_share = a.resolution == 0.0 && a.amount.unit != crate::units::Unit::Percent && a.amount.value != 0.0;
            let share = is_share.then(|| by / a.amount.value.abs());
            Change::By(open.filter(|open| *open > 0.0).map_or(amount, |open| amount.within_bar(open)), share)
        }
    }
}

impl Change {
    /// As it is told: `+3.1 kN (+8 %)`, `+1.5 kN (within the error)`.
    pub fn told(&self) -> String {
        match *self {
            Self::None => String::new(),
            Self::Same => "the same".into(),
            Self::Within(by) => format!("{change} (within the error)", change = signed(by)),
            Self::By(by, None) => signed(by),
            Self::By(by, Some(share)) => {
                let share = Amount::share(share).to(Digits::Significant(2));
                format!("{change} ({share})", change = signed(by), share = signed(share))
            }
        }
    }

    /// Whether the error bars leave open that it is the same; `None` where one of the two has no such number.
    pub fn is_within(&self) -> Option<bool> {
        match self {
            Self::None => None,
            Self::Same | Self::Within(_) => Some(true),
            Self::By(..) => Some(false),
        }
    }

    /// By how much, in the number's unit; 0 where it is the same.
    pub fn value(&self) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Same => Some(0.0),
            Self::Within(by) => Some(by.value),
            Self::By(by, _) => Some(by.value),
        }
    }
}

/// With a sign also where it is more.
fn signed(by: Amount) -> String {
    let sign = if by.value > 0.0 { String::from("+") } else { String::new() };
    joined([sign, by.into()], "")
}
