//! Error bars held against a truth that is eight times finer in each direction.

use stampflow::Stage;
use stampflow::case::{self, Case};
use stampflow::forming_limit::{Kind, Sheet, Swift};
use stampflow::model::{Beginning, Model};
use stampflow::verification::{Direction, Number, Origin, Outcome, Verification, quick, verify};

/// How many times finer the truth is \[–\].
const TRUTH: f64 = 8.0;

/// A die with its bars and its truth.
pub struct Checked {
    pub full: Verification,
    pub quick: Verification,
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
    Checked { full: verify(&solution, &()), quick: quick(&solution, &()), finest }
}

impl Checked {
    /// The run as it is, and the deviations of all finer runs from it summed; `None` where one ended otherwise.
    pub fn truth(&self, number: &Number) -> Option<f64> {
        let own = number.quantity.value();
        let base = &self.full.outcomes[0];
        let deviations = self.finest.iter().map(|run| {
            let value = run.value(number).filter(|_| run.end.is_like(&base.end));
            value.map(|value| value - own)
        });
        Some(own + deviations.sum::<Option<f64>>()?)
    }
}

/// How often the truth lies inside the bars of a number, and how long these are.
#[derive(Default)]
pub struct Row {
    pub name: String,
    pub without: usize,
    pub inside: usize,
    /// Bar over true error, of each die that has both.
    pub ratios: Vec<f64>,
}

/// Of all numbers, by `verify` and by the quick estimate.
pub struct Tally {
    pub full: Vec<Row>,
    pub quick: Vec<Row>,
}

impl Tally {
    pub fn of(checked: &[Checked]) -> Self {
        let rows = |of: fn(&Checked) -> &Verification| {
            let mut rows: Vec<Row> = Vec::new();
            for (one, number) in checked.iter().flat_map(|one| of(one).numbers.iter().map(move |number| (one, number)))
            {
                let shown = number.origin != Origin::Verdict || number.quantity.key == "forming_limit";
                let Some(truth) = one.truth(number).filter(|_| shown) else { continue };
                let label = number.quantity.label;
                let i = rows.iter().position(|row| row.name == label).unwrap_or_else(|| {
                    rows.push(Row { name: label.to_owned(), ..Row::default() });
                    rows.len() - 1
                });
                let error = (truth - number.quantity.value()).abs();
                match number.half() {
                    None => rows[i].without += 1,
                    Some(half) => {
                        rows[i].inside += usize::from(error <= half);
                        // What nothing moves has no bar, and needs none.
                        rows[i].ratios.push(if half == error { 1.0 } else { half / error });
                    }
                }
            }
            rows.iter_mut().for_each(|row| row.ratios.sort_by(f64::total_cmp));
            rows
        };
        Self { full: rows(|one| &one.full), quick: rows(|one| &one.quick) }
    }
}
