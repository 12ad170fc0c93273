//! A step taken apart, for people.

use super::super::say::Shown;
use super::super::table::{Cell, table, width, wrapped};
use stampflow::case::Case;
use stampflow::message::{Amount, Form, Message, message};
use stampflow::model::Iteration;
use stampflow::plot::log_plot::{Curve, log_plot};
use stampflow::solver::Start;
use stampflow::solver::trace::{Attempt, Iterated, Pass, Rate, Trace, Way};

/// Rows of a table that are shown at its beginning and at its end, where it has more of them.
const SHOWN: [usize; 2] = [12, 6];

/// Where the step is, its iterations, their norms drawn, and how fast they converge.
pub fn screen(case: &Case, trace: &Trace, form: Form) -> Shown {
    let Trace { before, record, dt, .. } = trace;
    let name =
        case.stage_label(trace.asked.stage - 1).map_or(case.name.clone(), |stage| format!("{} {stage}", case.name));
    let head = message!(
        "{case}, step {step}: from {from} to {to} of travel, in {dt}",
        case = name,
        step = record.step,
        from = Amount::thickness(before.travel),
        to = Amount::thickness(record.travel),
        dt = Amount::time(*dt)
    );
    let body = match trace.ways.as_slice() {
        [way] => taken_apart(way, form) + plot(trace, form) + wrapped(&form.tell(converges(way))),
        ways => side_by_side(ways, form) + plot(trace, form) + summed_up(ways, form),
    };
    wrapped(&form.tell(head)) + body
}

/// Every try of a way, and each pass of it as a table.
fn taken_apart(way: &Way, form: Form) -> Shown {
    let mut shown = Shown::default();
    for attempt in &way.attempts {
        for (i, pass) in attempt.passes.iter().enumerate() {
            let from = if i == 0 { start(attempt) } else { "From there".into() };
            let told = message!("{from}, with the {matrix}", from = from, matrix = matrix(pass.matrix));
            shown = shown + wrapped(&format!("\n{}\n\n", form.tell(told))) + rows(pass, i, form);
        }
    }
    shown
}

/// Where a try begins.
fn start(attempt: &Attempt) -> Message {
    match attempt.start {
        Start::Predictor => "From the predictor, the velocities of the step before".into(),
        Start::Secant => "From rest".into(),
        Start::Softened | Start::SoftenedInSteps => "From rest, with a larger cut-off".into(),
    }
}

fn matrix(matrix: Iteration) -> Message {
    match matrix {
        Iteration::PrimalDual => "primal-dual Newton matrix",
        Iteration::Newton => "Newton matrix",
        Iteration::Secant => "secant matrix",
    }
    .into()
}

/// Rows that are shown of so many.
fn is_shown(i: usize, all: usize) -> bool {
    all <= SHOWN[0] + SHOWN[1] + 1 || i < SHOWN[0] || i + SHOWN[1] >= all
}

fn rows(pass: &Pass, i: usize, form: Form) -> Shown {
    let headers = ["iteration", "velocity", "taken", "residual", "largest at", "cut off", "contact", "sticking"];
    let headers = headers.map(|header| form.tell(header));
    let all = pass.iterated.len();
    let row = |(at, iterated): (usize, &Iterated)| match at == SHOWN[0] && !is_shown(at, all) {
        true => Some(["…", "", "", "", "", "", "", ""].map(Cell::plain)),
        false => is_shown(at, all).then(|| cells(iterated, pass, i == 0, form).map(Cell::plain)),
    };
    table(Some(headers.each_ref().map(String::as_str)), pass.iterated.iter().enumerate().filter_map(row).collect())
}

fn cells(iterated: &Iterated, pass: &Pass, is_first: bool, form: Form) -> [String; 8] {
    let given = |amount: Option<Amount>| amount.map_or("–".to_owned(), |amount| form.tell(amount));
    let number = if is_first && iterated.iteration == 0 { form.tell("start") } else { iterated.iteration.to_string() };
    [
        number,
        given(iterated.velocity_norm.map(norm)),
        given(iterated.share.map(Amount::ratio)),
        form.tell(norm(iterated.residual_norm)),
        form.tell(Amount::place(iterated.nodes[iterated.worst_node][0])),
        given(pass.cutoff.map(|_| Amount::count(iterated.cut_off()))),
        iterated.touching.len().to_string(),
        iterated.sticking().to_string(),
    ]
}

fn norm(value: f64) -> Amount {
    Amount::norm(value)
}

/// The last pass of every way, iteration beside iteration.
fn side_by_side(ways: &[Way], form: Form) -> Shown {
    let all = ways.iter().map(|way| way.iterations().len()).max().unwrap_or(0);
    let mut headers = [const { String::new() }; 7];
    let mut second = headers.clone();
    headers[0] = form.tell("iteration");
    for (i, way) in ways.iter().enumerate() {
        headers[2 * i + 1] = form.tell(short(way.matrix));
        second[2 * i + 1] = form.tell("velocity");
        second[2 * i + 2] = form.tell("residual");
    }
    let row = |at: usize| {
        let mut row = [const { String::new() }; 7];
        if !is_shown(at, all) {
            row[0] = "…".to_owned();
            return row;
        }
        row[0] = at.to_string();
        for (i, way) in ways.iter().enumerate() {
            let Some(iterated) = way.iterations().get(at) else { continue };
            row[2 * i + 1] = iterated.velocity_norm.map_or("–".to_owned(), |value| form.tell(norm(value)));
            row[2 * i + 2] = form.tell(norm(iterated.residual_norm));
        }
        row
    };
    let numbered = (0..all).filter(|at| is_shown(*at, all) || *at == SHOWN[0]).map(row);
    let rows = std::iter::once(second).chain(numbered).map(|row| row.map(Cell::plain)).collect();
    Shown::from("\n") + table(Some(headers.each_ref().map(String::as_str)), rows)
}

fn short(matrix: Iteration) -> &'static str {
    match matrix {
        Iteration::PrimalDual => "primal-dual",
        Iteration::Newton => "Newton",
        Iteration::Secant => "secant",
    }
}

/// Of one way its two norms, of several their velocity norms, over the iterations of the last pass.
fn plot(trace: &Trace, form: Form) -> Shown {
    let residual = |way: &Way| way.iterations().iter().map(|i| (i.iteration, i.residual_norm)).collect();
    let velocity =
        |way: &Way| way.iterations().iter().filter_map(|i| Some((i.iteration, i.velocity_norm?))).collect::<Vec<_>>();
    let (curves, legend) = match trace.ways.as_slice() {
        [way] => (
            vec![Curve { mark: 'v', points: velocity(way) }, Curve { mark: 'r', points: residual(way) }],
            message!(
                "v velocity norm, r residual norm, dots: tolerance {tolerance}",
                tolerance = norm(trace.tolerance())
            ),
        ),
        ways => {
            let mark = |way: &Way| match way.matrix {
                Iteration::PrimalDual => 'p',
                Iteration::Newton => 'n',
                Iteration::Secant => 's',
            };
            let curves = ways.iter().map(|way| Curve { mark: mark(way), points: velocity(way) }).collect();
            let tolerance = norm(trace.tolerance());
            (
                curves,
                message!(
                    "Velocity norm: p primal-dual, n Newton, s secant, dots: tolerance {tolerance}",
                    tolerance = tolerance
                ),
            )
        }
    };
    let drawn = log_plot(&curves, trace.tolerance(), &form.tell("iteration"), width());
    Shown::from("\n") + wrapped(&form.tell(legend)) + Shown::from(format!("\n{drawn}\n"))
}

/// How many tries and iterations a way takes, and how fast it is at its end.
fn converges(way: &Way) -> Message {
    let n = way.count();
    let took = match (way.converged, way.attempts.len()) {
        (true, 1) => message!("In equilibrium after {n} iterations.", n = n),
        (true, tries) => message!("In equilibrium at try {tries}, after {n} iterations in all.", tries = tries, n = n),
        (false, tries) => message!(
            "No equilibrium in {tries} tries, {n} iterations in all: the run would halve the step.",
            tries = tries,
            n = n
        ),
    };
    let too_few = "Too few whole increments that fall to say how fast it converges: --tolerance 1e-11 goes on.";
    Message::joined([took, way.rate().map_or(too_few.into(), fast)], " ")
}

fn fast(rate: Rate) -> Message {
    let left = Amount::share(rate.left);
    match rate.order {
        Some(order) if rate.is_faster_than_linear() => message!(
            "At the end it converges with order {order}: the last iteration leaves {left} of the error.",
            order = Amount::ratio(order),
            left = left
        ),
        Some(_) => {
            message!("At the end it converges linearly: each iteration leaves {left} of the error.", left = left)
        }
        None => message!(
            "Too few iterations show an order of convergence: the last leaves {left} of the error.",
            left = left
        ),
    }
}

fn summed_up(ways: &[Way], form: Form) -> Shown {
    let lines = ways.iter().map(|way| {
        let [method, how] = [short(way.matrix).into(), converges(way)].map(|message: Message| form.tell(message));
        [Cell::plain(method), Cell::plain(how)]
    });
    table(None, lines.collect())
}
