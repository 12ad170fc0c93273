//! Error bars held against a truth that is eight times finer in each direction.

use stampflow::assess::error_bars::{ErrorBars, Number, Origin};
use stampflow::forming_limit::{Kind, Sheet, Swift};
use stampflow::study::verify::{Direction, Outcome, verify};
use stampflow::{Stage, case, case::Case, model::Beginning, model::Model};

/// How many times finer the truth is \[–\].
const TRUTH: f64 = 8.0;

/// A die with its bars and its truth.
pub struct Checked {
    pub full: ErrorBars,
    /// The run as it is, and all finer ones.
    pub outcomes: Vec<Outcome>,
    /// What is eight times finer, a run for each direction.
    pub finest: Vec<Outcome>,
}

/// A case of one stage with a model.
pub fn case_of(mut model: Model) -> Case {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/quickstart.toml");
    let sheet = Sheet { material: &model.material, thickness: model.blank.thickness, temperature: 293.15 };
    model.forming_limit = Kind::Swift(Swift { n: None }).curve(&sheet).ok();
    let stage = Stage { name: "draw".into(), model, begin: Beginning::default() };
    Case { stages: vec![stage], ..case::load(path, &[]).expect("a shipped case") }
}

pub fn check(case: Case) -> Checked {
    let solution = case.solve(&mut ());
    let stages = &solution.case.stages;
    let finest = Direction::ALL.iter().filter_map(|direction| {
        let case = Case { stages: direction.refined(stages, TRUTH)?, ..solution.case.clone() };
        Some(Outcome::of(&case.solve(&mut ()), Some((*direction, TRUTH))))
    });
    let finest = finest.collect();
    let full = verify(&solution, &());
    Checked { full: full.bars, outcomes: full.outcomes, finest }
}

/// Bars over the last digit that a run prints of the number, with its label.
pub fn last_digits(case: Case) -> Vec<(&'static str, String, f64)> {
    let verified = verify(&case.solve(&mut ()), &());
    let computed = verified.outcomes[0].numbers.iter().filter(|number| number.origin != Origin::Verdict);
    let units = computed.filter_map(|number| {
        let amount = number.quantity.amount;
        let (text, unit) = amount.parts();
        let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let last = 0.1_f64.powi(decimals as i32) * amount.value / text.parse::<f64>().ok().filter(|x| *x != 0.0)?;
        let half = verified.bars.number(number.origin, number.quantity.key)?.half().filter(|half| *half > 0.0)?;
        Some((number.quantity.label, format!("{text} {unit}"), half / last))
    });
    units.collect()
}

impl Checked {
    /// The run as it is, and the deviations of all finer runs from it summed; `None` where one ended otherwise.
    pub fn truth(&self, number: &Number) -> Option<f64> {
        let own = number.quantity.amount.value;
        let base = &self.outcomes[0];
        let deviations = self.finest.iter().map(|run| {
            let value = run.value(number).filter(|_| run.end.is_like(&base.end));
            value.map(|value| value - own)
        });
        Some(own + deviations.sum::<Option<f64>>()?)
    }

    /// Numbers that are shown and have a truth, with it.
    pub fn with_truth(&self) -> impl Iterator<Item = (&Number, f64)> {
        let shown = |number: &&Number| number.origin != Origin::Verdict || number.quantity.key == "forming_limit";
        self.full.numbers.iter().filter(shown).filter_map(|number| Some((number, self.truth(number)?)))
    }
}
