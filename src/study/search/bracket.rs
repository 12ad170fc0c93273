//! Where a sign changes: the mathematics of a search, which knows nothing of cases.
//!
//! ```text
//! 1  look      trials evenly over the span: the condition may come and go, and where is not known before
//! 2  choose    the edge, or the crossing, that is asked for
//! 3  section   k trials at once divide the bracket by k + 1, as many as run side by side; of a smooth number two of them
//!              close about where the secant crosses
//! 4  look      beside the limit again: where the answer changes back, the limit is as wide as that
//! ```
//!
//! A trial that failed is neither on one side nor on the other: others are tried beside it.

use std::ops::RangeInclusive;

/// Which of several edges or crossings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The one at the smallest value.
    Smallest,
    /// The one at the largest.
    Largest,
}

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The last value, on that side, with a sign above 0: beyond it a condition holds no more.
    Edge(Side),
    /// Where a number crosses 0.
    Crossing(Side),
}

/// How a span is gone through.
pub struct Line<'a> {
    /// Value at a share of the way, from 0 to 1.
    pub at: &'a dyn Fn(f64) -> f64,
    /// Share of the way at a value.
    pub share: &'a dyn Fn(f64) -> f64,
    /// How near a limit is to be found at a value.
    pub tolerance: &'a dyn Fn(f64) -> f64,
    /// Places to look at first.
    pub places: usize,
    /// Trials that are made at once.
    pub at_once: usize,
}

/// A trial: its value, and what came of it; `None` where it failed.
pub type Trial = (f64, Option<f64>);

/// What a search has found.
#[derive(Clone, Debug, PartialEq)]
pub enum Found {
    /// The sign changes between these two, the first of which is on the inner side.
    Between([f64; 2]),
    /// The condition holds up to the end of the span, at this value.
    Everywhere(f64),
    /// Every trial is on the wrong side, or a number crosses nowhere.
    Nowhere,
    /// Beyond this value, where it holds, every trial failed.
    Open(f64),
    /// No trial came to anything.
    Failed,
    /// It was ended before.
    Interrupted,
}

/// A search that has come to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Bracket {
    /// What was found.
    pub found: Found,
    /// All trials, by their values.
    pub trials: Vec<Trial>,
    /// Where the condition holds, as the first look has it: first and last value of each stretch.
    pub stretches: Vec<RangeInclusive<f64>>,
    /// Where it comes and goes about the limit that was found.
    pub mixed: Option<RangeInclusive<f64>>,
}

/// So often a limit is divided anew, where a look beside it has changed it.
const LOOKS: usize = 3;
/// So many rounds at most.
const ROUNDS: usize = 40;
/// So many rounds in a row may bring nothing nearer.
const PATIENCE: usize = 3;
/// Places beside a limit that are looked at last, in widths of its bracket.
const BESIDE: [f64; 2] = [1.0, 3.0];
/// How far from where a secant crosses two trials close about it, over the bracket \[–\].
const CLOSE: f64 = 0.05;

/// A step is looked at among trials as far from it, in its own widths.
const STEP_BESIDE: f64 = 4.0;
/// A step has more than this share of the change there \[–\]; a straight line has a ninth, or a fifth at an end of the span.
const STEP_SHARE: f64 = 0.6;

/// Makes trials at values; `None` once it is to end.
pub type Ask<'a> = dyn FnMut(&[f64]) -> Option<Vec<Option<f64>>> + 'a;

/// Looks for an edge or a crossing.
pub fn bracket(line: &Line, aim: Aim, ask: &mut Ask) -> Bracket {
    let mut search = Search { line, aim, trials: Vec::new() };
    let (found, stretches) = search.run(ask);
    let mixed = if let Found::Between([inner, outer]) = found { search.mixed(inner, outer) } else { None };
    Bracket { found, trials: search.trials, stretches, mixed }
}

impl Bracket {
    /// What the number is before and behind a step across 0, of several the one nearest to a value: most of its change among the
    /// trials beside stands in one place.
    pub fn jump(&self, at: f64) -> Option<[f64; 2]> {
        let told: Vec<(f64, f64)> = self.trials.iter().filter_map(|(x, number)| Some((*x, (*number)?))).collect();
        let is_change = |pair: &&[(f64, f64)]| (pair[0].1 >= 0.0) != (pair[1].1 >= 0.0);
        let off = |pair: &[(f64, f64)]| (pair[0].0 - at).abs().min((pair[1].0 - at).abs());
        let pair = told.windows(2).filter(is_change).min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let ((from, before), (to, behind)) = (pair[0], pair[1]);
        let far = STEP_BESIDE * (to - from);
        let low = told.iter().rev().find(|(x, _)| *x <= from - far).or(told.first())?.0;
        let high = told.iter().find(|(x, _)| *x >= to + far).or(told.last())?.0;
        let numbers = || told.iter().filter(|(x, _)| (low..=high).contains(x)).map(|(_, number)| *number);
        let change = numbers().fold(f64::NEG_INFINITY, f64::max) - numbers().fold(f64::INFINITY, f64::min);
        let is_narrow = (to - from) * STEP_BESIDE <= high - low;
        (is_narrow && (behind - before).abs() > STEP_SHARE * change).then_some([before, behind])
    }
}

struct Search<'a> {
    line: &'a Line<'a>,
    aim: Aim,
    /// By their values.
    trials: Vec<Trial>,
}

impl Search<'_> {
    fn run(&mut self, ask: &mut Ask) -> (Found, Vec<RangeInclusive<f64>>) {
        let places = self.line.places.max(3);
        let even = |n: usize| (0..n).map(|i| i as f64 / (n - 1) as f64).collect::<Vec<_>>();
        if !self.tried(&even(places), ask) {
            return (Found::Interrupted, self.stretches());
        }
        // A stretch that lies between the first places.
        if self.chosen().is_none() && !self.tried(&even(2 * places - 1), ask) {
            return (Found::Interrupted, self.stretches());
        }
        let stretches = self.stretches();
        let Some([inner, outer]) = self.chosen() else { return (self.without(), stretches) };
        for looks in (0..LOOKS).rev() {
            let Some([low, high]) = self.section([inner, outer], ask) else { return (Found::Interrupted, stretches) };
            if looks > 0 && !self.tried(&self.beside([inner, outer], [low, high]), ask) {
                return (Found::Interrupted, stretches);
            }
            if looks == 0 || self.first_change([inner, outer]) == Some([low, high]) {
                return (Found::Between([low, high]), stretches);
            }
        }
        (Found::Failed, stretches)
    }

    /// Shares of the way beside what a bracket has come to, within its first ends.
    fn beside(&self, ends: [f64; 2], bracket: [f64; 2]) -> Vec<f64> {
        let ([from, to], [low, high]) = (ends.map(|x| self.way(x)), bracket.map(|x| self.way(x)));
        let ways = BESIDE.iter().flat_map(|times| [low - times * (high - low), high + times * (high - low)]);
        ways.filter(|way| (way - from) * (to - way) > 0.0).collect()
    }

    /// Divides a bracket until it is narrow enough, or nothing brings it nearer.
    fn section(&mut self, ends: [f64; 2], ask: &mut Ask) -> Option<[f64; 2]> {
        let (mut bracket, mut idle) = (self.first_change(ends)?, 0);
        for _ in 0..ROUNDS {
            let [inner, outer] = bracket;
            if (outer - inner).abs() <= (self.line.tolerance)(inner) * (1.0 + 1e-9) || idle == PATIENCE {
                break;
            }
            let [from, to] = [inner, outer].map(|x| self.way(x));
            let count = self.line.at_once.max(1) + idle;
            let mut ways: Vec<f64> = (1..=count).map(|i| from + (to - from) * i as f64 / (count + 1) as f64).collect();
            if let (Aim::Crossing(_), Some(secant), true) = (self.aim, self.secant(bracket), idle == 0) {
                let close = (CLOSE * (to - from)).abs();
                let about = [secant - close, secant + close].map(|way| way.clamp(from.min(to), from.max(to)));
                ways.splice(..ways.len().min(2), about);
            }
            if !self.tried(&ways, ask) {
                return None;
            }
            let nearer = self.first_change(ends)?;
            idle = if nearer == bracket { idle + 1 } else { 0 };
            bracket = nearer;
        }
        Some(bracket)
    }

    /// Share of the way at which the number between two trials crosses 0, were it straight.
    fn secant(&self, [inner, outer]: [f64; 2]) -> Option<f64> {
        let [a, b] = [self.value(inner)?, self.value(outer)?];
        let [from, to] = [inner, outer].map(|x| self.way(x));
        Some(from + (to - from) * a / (a - b)).filter(|way| way.is_finite())
    }

    /// Makes trials at shares of the way where there are none yet.
    fn tried(&mut self, ways: &[f64], ask: &mut Ask) -> bool {
        let mut values: Vec<f64> = Vec::new();
        for x in ways.iter().map(|way| (self.line.at)(*way)) {
            if !values.contains(&x) && !self.trials.iter().any(|(known, _)| *known == x) {
                values.push(x);
            }
        }
        if values.is_empty() {
            return true;
        }
        let Some(said) = ask(&values) else { return false };
        self.trials.extend(values.into_iter().zip(said));
        self.trials.sort_by(|a, b| a.0.total_cmp(&b.0));
        true
    }

    /// The bracket to divide, its inner side first: the last edge or crossing on the side that is asked for.
    fn chosen(&self) -> Option<[f64; 2]> {
        let decided = self.outward();
        let is_change = |pair: &&[Trial]| match self.aim {
            Aim::Edge(_) => pair[0].1 >= Some(0.0) && pair[1].1 < Some(0.0),
            Aim::Crossing(_) => (pair[0].1 >= Some(0.0)) != (pair[1].1 >= Some(0.0)),
        };
        // An edge inside, where the condition comes again beyond and holds to the end, is none.
        let ends_inside = decided.last().is_some_and(|last| last.1 < Some(0.0)) || matches!(self.aim, Aim::Crossing(_));
        let last = decided.windows(2).rfind(is_change).filter(|_| ends_inside)?;
        Some([last[0].0, last[1].0])
    }

    /// What there is to say without a bracket.
    fn without(&self) -> Found {
        let decided = self.outward();
        let end = match self.side() {
            Side::Largest => self.trials.last(),
            Side::Smallest => self.trials.first(),
        };
        match (decided.last(), end, self.aim) {
            (None, ..) => Found::Failed,
            (Some(last), Some(end), Aim::Edge(_)) if last.1 >= Some(0.0) => {
                if end.0 == last.0 {
                    Found::Everywhere(last.0)
                } else {
                    Found::Open(last.0)
                }
            }
            _ => Found::Nowhere,
        }
    }

    /// The first change of the sign between two values, going outward from the inner one.
    fn first_change(&self, [inner, outer]: [f64; 2]) -> Option<[f64; 2]> {
        let inside: Vec<Trial> = self.within(inner, outer);
        let pair = inside.windows(2).find(|pair| (pair[0].1 >= Some(0.0)) != (pair[1].1 >= Some(0.0)))?;
        Some([pair[0].0, pair[1].0])
    }

    /// Where the sign changes more than once beside a bracket: from the last trial before the first change to the first after
    /// the last one, as far as the first look had no place between.
    fn mixed(&self, inner: f64, outer: f64) -> Option<RangeInclusive<f64>> {
        let scan = 1.0 / (self.line.places.max(3) - 1) as f64;
        let is_near = |trial: &Trial| {
            let way = self.way(trial.0);
            (way - self.way(inner)).abs() < scan && (way - self.way(outer)).abs() < scan
        };
        let near: Vec<Trial> = self.outward().into_iter().filter(is_near).collect();
        let changes = |pair: &&[Trial]| (pair[0].1 >= Some(0.0)) != (pair[1].1 >= Some(0.0));
        let pairs: Vec<_> = near.windows(2).filter(changes).collect();
        let (first, last) = (pairs.first()?[0].0, pairs.last()?[1].0);
        (pairs.len() > 1).then(|| first.min(last)..=first.max(last))
    }

    /// First and last value of each stretch on which the condition holds; failed trials part nothing.
    fn stretches(&self) -> Vec<RangeInclusive<f64>> {
        let decided: Vec<&Trial> = self.trials.iter().filter(|trial| trial.1.is_some()).collect();
        let of_one = decided.chunk_by(|a, b| (a.1 >= Some(0.0)) == (b.1 >= Some(0.0)));
        let held = of_one.filter(|stretch| stretch[0].1 >= Some(0.0));
        held.map(|stretch| stretch[0].0..=stretch[stretch.len() - 1].0).collect()
    }

    /// Trials that came to something, from the inner side to the outer one.
    fn outward(&self) -> Vec<Trial> {
        let mut decided: Vec<Trial> = self.trials.iter().copied().filter(|trial| trial.1.is_some()).collect();
        if self.side() == Side::Smallest {
            decided.reverse();
        }
        decided
    }

    fn within(&self, inner: f64, outer: f64) -> Vec<Trial> {
        self.outward().into_iter().filter(|(x, _)| (x - inner) * (outer - x) >= 0.0).collect()
    }

    fn side(&self) -> Side {
        let (Aim::Edge(side) | Aim::Crossing(side)) = self.aim;
        side
    }

    fn value(&self, x: f64) -> Option<f64> {
        self.trials.iter().find(|trial| trial.0 == x)?.1
    }

    fn way(&self, x: f64) -> f64 {
        (self.line.share)(x)
    }
}
