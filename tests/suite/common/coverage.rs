//! Error bars held against a truth that is eight times finer in each direction.

use stampflow::Stage;
use stampflow::assess::error_bars::{ErrorBars, Number, Origin};
use stampflow::case::{self, Case};
use stampflow::forming_limit::{Kind, Sheet, Swift};
use stampflow::model::{Beginning, Model};
use stampflow::study::verify::{Direction, Outcome, quick, verify};

/// How many times finer the truth is \[–\].
const TRUTH: f64 = 8.0;

/// A die with its bars and its truth.
pub struct Checked {
    pub full: ErrorBars,
    pub quick: ErrorBars,
    /// The run as it is, and all finer ones and the coarser one.
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
    let (full, quick) = (verify(&solution, &()), quick(&solution, &()));
    let outcomes = [full.outcomes, quick.outcomes[1..].to_vec()].concat();
    Checked { full: full.bars, quick: quick.bars, outcomes, finest }
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

    /// Numbers of a verification that are shown and have a truth, with it.
    pub fn with_truth<'a>(&'a self, of: &'a ErrorBars) -> impl Iterator<Item = (&'a Number, f64)> {
        let shown = |number: &&Number| number.origin != Origin::Verdict || number.quantity.key == "forming_limit";
        of.numbers.iter().filter(shown).filter_map(|number| Some((number, self.truth(number)?)))
    }
}
