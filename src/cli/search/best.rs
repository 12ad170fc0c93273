//! The best of several keys: `--minimise`, `--maximise`.

use super::super::code::Code;
use super::super::many::asked;
use super::super::progress::Progress;
use super::super::say::{say, say_json};
use super::super::table::wrapped;
use super::ask::{Args, Places};
use super::told;
use stampflow::output::study::json;
use stampflow::output::study::search::plot_best;
use stampflow::study::Subject;
use stampflow::study::search::{Condition, Named, Wish};
use std::time::Instant;

pub fn optimise(args: &Args, places: &mut Places, wish: &Wish) -> anyhow::Result<Code> {
    let count = args.many.count(&args.case, "runs");
    let start = Instant::now();
    let mut keep = |header: &[String], line: &[String]| places.keep(header, line);
    let found = wish.search_keeping(args.many.threads(), &count, &mut keep).map_err(asked)?;
    let seconds = start.elapsed().as_secs_f64();
    places.table(&found.table.0, &found.table.1)?;
    let Wish { subject, spans, number, condition, .. } = wish;
    places.picture(args, plot_best(spans, number, condition.as_ref(), &found))?;
    let solution = match found.best.filter(|_| !found.interrupted) {
        Some(best) => {
            let case = subject.case(&found.rows[best].design.settings)?;
            Subject::solution(case, &count).ok()
        }
        None => None,
    };
    let bars = solution.and_then(|solution| args.bars.of(&solution, &Progress::new(true), true));
    let code = match found.best {
        _ if found.interrupted => Code::Interrupted,
        Some(_) => Code::Done,
        None => Code::Failed,
    };
    if args.many.json.json {
        say_json(&places.located(json::best(wish, &found, bars.as_ref()), seconds))?;
        return Ok(code);
    }
    say(wrapped(&format!("{}.", wish.sentence(&found).to_string())))?;
    for said in found.sentences() {
        say(wrapped(&format!("- {}", said.to_string())))?;
    }
    if let Some(best) = found.best {
        let runs = [(String::from("best"), &found.rows[best])];
        let limits = condition.iter().flat_map(Condition::numbers).map(|(name, _)| name);
        let named: Vec<&Named> = limits.chain([number]).collect();
        say("\n")?;
        say(told::side_by_side("", &runs, &named, bars.as_ref()))?;
    }
    say(told::done(found.rows.len(), seconds, &places.dir))?;
    Ok(code)
}
