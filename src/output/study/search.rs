//! `search.png`: what was run, its lights, and what was found.

use crate::assess::Light;
use crate::message::{Form, message};
use crate::output::chart::{BLACK, Chart, Color, GREY, Look, PALE, Panel, Scale, Series, color};
use crate::study::search::{Answer, Best, Condition, Found, Goal, Named, Quest};
use crate::study::{Row, Solved, Span};
use crate::table::Axis;
use crate::units::Unit;
use crate::verification::{Number, Of};

/// Numbers that are drawn where the condition names none, as far as there are such: what tears, and what the press sees.
const USUAL: [(Of, &str); 2] = [(Of::Verdict, "thinning"), (Of::Answer, "punch_force")];

/// Heights of the panels \[px of a picture 800 wide\].
const HEIGHT: f64 = 230.0;

/// Light with its look: three shapes, for readers without colours.
fn look(light: Light) -> Look {
    match light {
        Light::Red => Look::Triangles { color: color(1) },
        Light::Amber => Look::Circles { color: color(4) },
        Light::Green | Light::Grey => Look::Dots { color: color(2) },
    }
}

/// The numbers of a search over its key; `None` where no run has any.
pub fn plot(quest: &Quest, answer: &Answer, form: Form) -> Option<Chart> {
    let named: Vec<(&Named, Option<f64>)> = match &quest.goal {
        Goal::Keep(condition) => limits(condition, &answer.base),
        Goal::Reach(target) => vec![(&target.name, answer.wanted)],
    };
    let values: Vec<f64> = (0..answer.rows.len()).map(|run| answer.value(run)).collect();
    let mut panels = Vec::new();
    let x = Key::of(&quest.span, form);
    for (number, limit) in shown(&answer.base, &named) {
        let mut panel = x.panel(&values, &answer.rows, &number, limit, panels.is_empty(), form);
        if let Some(panel) = &mut panel {
            mark(panel, &x, answer, panels.is_empty(), form);
        }
        panels.extend(panel);
    }
    let title = match &quest.goal {
        Goal::Keep(condition) => message!(
            "Search for {key}: “{condition}”",
            key = quest.span.key().to_owned(),
            condition = condition.text.clone()
        ),
        Goal::Reach(target) => message!(
            "Search for {key}: {number} as wanted",
            key = quest.span.key().to_owned(),
            number = target.name.text.clone()
        ),
    };
    let failed = answer.failed.iter().map(|(_, count)| count).sum::<usize>();
    let notes = (failed > 0).then(|| message!("{n} runs that came to nothing are not drawn.", n = failed).told(form));
    (!panels.is_empty()).then(|| Chart {
        title: title.told(form),
        legend: String::new(),
        panels,
        notes: notes.into_iter().collect(),
    })
}

/// The number that is to be best over each key, of the runs that tore none.
pub fn plot_best(
    spans: &[Span],
    name: &Named,
    condition: Option<&Condition>,
    best: &Best,
    form: Form,
) -> Option<Chart> {
    let number = name.find(&best.base).ok()?.clone();
    let mut panels = Vec::new();
    let mut at = 0;
    for span in spans {
        let x = Key::of(span, form);
        let values: Vec<f64> = best.rows.iter().map(|row| row.design.values[at].number.unwrap_or(f64::NAN)).collect();
        at += span.keys().len();
        let panel = x.panel(&values, &best.rows, &number, None, panels.is_empty(), form);
        panels.extend(panel.map(|mut panel| {
            let at = best.best.and_then(|run| {
                Some((values[run] * x.times, value(&best.rows[run], &number)? * x.factor(&number, form).1))
            });
            if let Some(at) = at {
                let label = form.tell("best");
                panel.series.push(Series::new(label, vec![at], Look::Flag));
            }
            panel
        }));
    }
    let condition = condition.map_or_else(String::new, |condition| condition.text.clone());
    let title = match condition.is_empty() {
        true => message!("Search for the best {number}", number = name.text.clone()),
        false => {
            message!("Search for the best {number}: “{condition}”", number = name.text.clone(), condition = condition)
        }
    };
    let note = message!("Each run stands in every panel; {n} of them are of the grid.", n = best.grid).told(form);
    (!panels.is_empty()).then(|| Chart { title: title.told(form), legend: String::new(), panels, notes: vec![note] })
}

/// The numbers that a condition limits, with their limits.
fn limits<'a>(condition: &'a Condition, base: &Solved) -> Vec<(&'a Named, Option<f64>)> {
    condition
        .numbers()
        .map(|(name, limit)| (name, name.find(base).and_then(|number| name.limit(number, limit)).ok()))
        .collect()
}

/// What is drawn: numbers that are named, else the usual ones.
fn shown(base: &Solved, named: &[(&Named, Option<f64>)]) -> Vec<(Number, Option<f64>)> {
    let own: Vec<_> = named.iter().filter_map(|(name, limit)| Some((name.find(base).ok()?.clone(), *limit))).collect();
    if !own.is_empty() {
        return own;
    }
    let usual = USUAL.iter().filter_map(|(of, key)| base.outcome.numbers.iter().find(|n| n.of == *of && n.key == *key));
    usual.map(|number| (number.clone(), None)).collect()
}

fn value(row: &Row, number: &Number) -> Option<f64> {
    row.result.as_ref().ok()?.outcome.value(number)
}

/// The axis of what is varied.
struct Key {
    axis: Axis,
    /// What its values are multiplied by to be drawn.
    times: f64,
}

impl Key {
    fn of(span: &Span, form: Form) -> Self {
        let (unit, times) = span.solver_unit().unwrap_or((Unit::None, 1.0));
        let (axis, told) = Axis::named(span.key().to_owned(), unit).told(form, span.ends()[1] * times);
        Self { axis, times: times * told.factor }
    }

    /// A number's axis, and what its values are multiplied by.
    fn factor(&self, number: &Number, form: Form) -> (Axis, f64) {
        let (axis, told) = Axis::named(form.tell(number.label), number.amount.unit).told(form, number.amount.value);
        (axis, told.factor)
    }

    /// A number of all runs over the key, by their lights.
    fn panel(
        &self,
        values: &[f64],
        rows: &[Row],
        number: &Number,
        limit: Option<f64>,
        is_first: bool,
        form: Form,
    ) -> Option<Panel> {
        let (y, factor) = self.factor(number, form);
        let points = |light: Light| -> Vec<(f64, f64)> {
            let is = |row: &Row| {
                row.result.as_ref().is_ok_and(|solved| {
                    (if solved.light == Light::Grey { Light::Green } else { solved.light }) == light
                })
            };
            let of = rows.iter().zip(values).filter(|(row, _)| is(row));
            of.filter_map(|(row, x)| Some((x * self.times, value(row, number)? * factor))).collect()
        };
        let mut series = Vec::new();
        if let Some(limit) = limit {
            let ends =
                values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [x.min(low), x.max(high)]);
            let line = ends.map(|x| (x * self.times, limit * factor)).to_vec();
            series.push(Series { label: is_first.then(|| form.tell("limit")), points: line, look: dashed(GREY) });
        }
        for light in [Light::Green, Light::Amber, Light::Red] {
            let points = points(light);
            if !points.is_empty() {
                series.push(Series { label: is_first.then(|| form.tell(light.name())), points, look: look(light) });
            }
        }
        let is_empty = series.iter().all(|series| matches!(series.look, Look::Line { .. }));
        (!is_empty).then(|| Panel { x: self.axis.clone(), y, series, scale: Scale::Fit { height: HEIGHT, least: 0.0 } })
    }
}

fn dashed(color: Color) -> Look {
    Look::Line { color, width: 1.6, dash: &[6.0, 4.0] }
}

/// The bracket of what was found, over the height of a panel; in the first with its name.
fn mark(panel: &mut Panel, x: &Key, answer: &Answer, is_first: bool, form: Form) {
    let Found::Between([inner, outer]) = answer.bracket.found else { return };
    let [_, (low, high)] = panel.ranges();
    let [a, b] = [inner, outer].map(|value| value * x.times);
    let outline = vec![(a, low), (a, high), (b, high), (b, low)];
    panel.series.insert(0, Series::silent(outline, Look::Area { fill: PALE, edge: None }));
    let best = answer.best.map_or(inner, |run| answer.value(run)) * x.times;
    let line = Look::Line { color: BLACK, width: 1.6, dash: &[] };
    let label = is_first.then(|| form.tell("found"));
    panel.series.push(Series { label, points: vec![(best, low), (best, high)], look: line });
}
