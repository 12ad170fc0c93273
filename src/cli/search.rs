//! `stampflow search`: where a condition ends, or where a number has a wanted value; the best of several keys.

mod ask;
mod best;
mod told;

pub use ask::Args;

use super::code::Code;
use super::many::asked;
use super::progress::Progress;
use super::say::{say, say_json};
use stampflow::output::study::json;
use stampflow::output::study::search::plot;
use stampflow::study::search::Found;
use stampflow::study::verify::Watch;
use std::time::Instant;

pub const HELP: &str = "\
The span is looked at in 9 places first, in N with /N behind it, for a condition may \
come and go; then the limit is divided until it is known within 0.5 % of the span, or --tolerance. A run \
that failed counts as neither. Conditions, joined by `and`: no red, no red or amber, \
no tear, ROW not red (a row of the verdict), NUMBER < VALUE UNIT (a number of \
study.csv). A number of a sheet that tore keeps none.

--for takes key, span and condition from the case; --vary, --while, --target change \
them:
  limiting-draw-ratio  the largest blank that is drawn without a tear
  greatest-height      the largest travel without a red light
  least-holder-force   the smallest force that keeps the flange flat
  smallest-radius      the smallest die shoulder without a red light
  over-bend            the travel for a wanted angle: with --target \"90 deg\"
  bead-force           the bead for a wanted draw-in: with --target \"8 mm\"

Examples:
  stampflow search cup.toml --for limiting-draw-ratio
  stampflow search cup.toml --vary \"blank.diameter=90..140 mm\" --largest \\
    --while \"no red\"
  stampflow search hat.toml --vary \"tools.holder.force=50..2000 N/mm log\" \\
    --target \"draw_in=20 mm\"
  stampflow search cup.toml --vary \"tools.die.shoulder=4..10 mm\" \\
    --vary friction=0.04..0.12 --minimise punch_force --while \"thinning < 8 %\"

Exit codes: 0 done, 1 nothing found, 2 bad input, 130 interrupted (runs are kept)";

pub fn search(args: &Args) -> anyhow::Result<Code> {
    let mut places = args.places()?;
    if let Some(wish) = args.wish().map_err(asked)? {
        return best::optimise(args, &mut places, &wish);
    }
    let quest = args.quest().map_err(asked)?;
    let count = args.many.count(&args.case, "runs");
    let start = Instant::now();
    let answer = quest.search_keeping(args.many.threads(), &count, &mut |header, line| places.keep(header, line));
    let answer = answer.map_err(asked)?;
    let seconds = start.elapsed().as_secs_f64();
    let (header, lines) = answer.table();
    places.table(header, lines)?;
    places.picture(args, plot(&quest, &answer))?;
    let bars = match answer.best.filter(|_| !count.wants_to_stop()) {
        Some(best) => {
            let solution = quest.solution(&answer.rows[best], &count).map_err(asked)?;
            args.bars.of(&solution, &Progress::new(true), true)
        }
        None => None,
    };
    let code = match answer.bracket.found {
        Found::Between(_) | Found::Everywhere(_) => Code::Done,
        Found::Interrupted => Code::Interrupted,
        Found::Nowhere | Found::Open(_) | Found::Failed => Code::Failed,
    };
    if args.many.json.json {
        say_json(&places.located(json::found(&quest, &answer, bars.as_ref()), seconds))?;
        return Ok(code);
    }
    say(told::screen(&quest, &answer, bars.as_ref()))?;
    say(told::done(answer.rows.len(), seconds, &places.dir))?;
    Ok(code)
}
