//! `stampflow search`.

use super::code::Code;
use super::study::{StudyOptions, TableOptions, request, run};
use stampflow::study::{BaseCase, LimitSearch, SearchRequest, Side};
use std::path::PathBuf;

pub const HELP: &str = "\
The range is scanned in 9 places, in N with /N behind it; then the limit is divided \
until it is known within 0.5 % of the range, or --tolerance. Runs that fail count \
neither way. Conditions, joined by `and`: no red, no red or amber, no tear, ROW not red \
(a row of the verdict), QUANTITY < LIMIT (a number of the table). Runs in which the \
sheet tears never satisfy a condition on a quantity.

--for takes key, range and condition from the case; --vary, --while, --target change \
them:
  limiting-draw-ratio  the largest blank that is drawn without a tear
  greatest-height      the largest travel without a red light
  least-holder-force   the smallest force that keeps the flange flat
  smallest-radius      the smallest die shoulder without a red light
  over-bend            the travel for a wanted angle: with --target \"90 deg\"
  bead-force           the bead for a wanted draw-in: with --target \"8 mm\"

Examples:
  stampflow search cup.toml --for limiting-draw-ratio
  stampflow search cup.toml --vary \"blank.radius=45..70 mm\" --largest --while \"no red\"
  stampflow search hat.toml --vary \"tools.holder.force=50..2000 N/mm log\" \\
    --target \"draw_in=20 mm\"

Exit codes: 0 done, 1 nothing found, 2 bad input, 130 interrupted (runs are kept)";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// A key and its range, KEY=FROM..TO UNIT, with `log` behind it for even ratios; a key alone is searched from half to twice
    /// its value. Keys joined by & move together
    #[arg(long, value_name = "KEY=RANGE")]
    vary: Option<String>,
    /// A search with a name
    #[arg(long = "for", value_name = "SEARCH")]
    goal: Option<String>,
    /// Find the largest value at which the condition holds
    #[arg(long, conflicts_with = "smallest")]
    largest: bool,
    /// Find the smallest value
    #[arg(long)]
    smallest: bool,
    /// The condition, such as "no red" or "thinning < 20 % and punch_force <= 60 kN"
    #[arg(long = "while", value_name = "CONDITION", conflicts_with = "target")]
    condition: Option<String>,
    /// A quantity and its wanted value, such as "draw_in=8 mm"
    #[arg(long, value_name = "QUANTITY=VALUE")]
    target: Option<String>,
    /// Accuracy of the limit, in the unit of the key [default: 0.5 % of the range]
    #[arg(long, value_name = "VALUE")]
    tolerance: Option<String>,
    #[command(flatten)]
    rows: TableOptions,
    #[command(flatten)]
    options: StudyOptions,
}

pub fn search(args: &Args) -> anyhow::Result<Code> {
    let side = match (args.largest, args.smallest) {
        (true, _) => Some(Side::Largest),
        (_, true) => Some(Side::Smallest),
        _ => None,
    };
    let asked = SearchRequest {
        vary: args.vary.clone(),
        goal: args.goal.clone(),
        side,
        condition: args.condition.clone(),
        target: args.target.clone(),
        tolerance: args.tolerance.clone(),
    };
    let base = BaseCase::load(&args.case, args.options.overrides.all()).map_err(request)?;
    let mut search = LimitSearch::new(base, &asked).map_err(request)?;
    run(&mut search, (&args.case, "search", "search"), (&args.options, &args.rows, None), false, &mut |_| Ok(()))
}
