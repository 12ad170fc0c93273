//! `search.png`: what was run, its lights, and what was found.

use crate::assess::Light;
use crate::plot::chart::{BLACK, Chart, GREY, Look, PALE, Panel, Scale, Series, color};
use crate::study::search::{Answer, Best, Condition, Found, Goal, Named, Quest, Said};
use crate::study::verify::{Number, Of};
use crate::study::{Row, Solved, Span};
use crate::table::Axis;
use crate::units::Unit;

/// Numbers that are drawn where the condition names none, as far as there are such: what tears, and what the press sees.
const USUAL: [(Of, &str); 2] = [(Of::Verdict, "thinning"), (Of::Answer, "punch_force")];

/// Heights of the panels \[px of a picture 800 wide\].
const HEIGHT: f64 = 230.0;
/// Room beside the span, over it \[–\].
const MARGIN: f64 = 0.02;

/// What a run is drawn as: where it keeps the condition by its light, else apart from all lights.
#[derive(Clone, Copy, PartialEq)]
enum Mark {
    Kept(Light),
    NotKept,
}

impl Mark {
    const ALL: [Self; 4] = [Self::Kept(Light::Green), Self::Kept(Light::Amber), Self::Kept(Light::Red), Self::NotKept];

    /// Of a run that came to something; `is_kept` where there is a condition.
    fn of(row: &Row, is_kept: Option<bool>) -> Option<Self> {
        let light = row.result.as_ref().ok()?.light;
        let light = if light == Light::Grey { Light::Green } else { light };
        Some(if is_kept == Some(false) { Self::NotKept } else { Self::Kept(light) })
    }

    fn look(self) -> Look {
        match self {
            Self::Kept(Light::Red) => Look::Dots { color: color(1) },
            Self::Kept(Light::Amber) => Look::Circles { color: color(4) },
            Self::Kept(_) => Look::Dots { color: color(2) },
            Self::NotKept => Look::Triangles { color: color(1) },
        }
    }

    fn label(self, has_condition: bool) -> String {
        match self {
            Self::Kept(light) if has_condition => format!("holds, {light}", light = light.name()),
            Self::Kept(light) => light.name().into(),
            Self::NotKept => "does not hold".into(),
        }
    }
}

/// The numbers of a search over its key; `None` where no run has any.
pub fn plot(quest: &Quest, answer: &Answer) -> Option<Chart> {
    let (condition, named) = match &quest.goal {
        Goal::Keep(condition) => (Some(condition), limits(condition, &answer.base)),
        Goal::Reach(target) => (None, vec![(&target.name, answer.wanted)]),
    };
    let key = Key::of(&quest.span, 0, &answer.rows, condition);
    let mut panels = Vec::new();
    for (number, limit) in shown(&answer.base, &named) {
        let is_first = panels.is_empty();
        let label = is_first.then(|| String::from(if condition.is_some() { "limit" } else { "wanted" }));
        let level = limit.map(|limit| key.level(&number, limit, label));
        if let Some(mut panel) = key.panel(&number, level, is_first) {
            key.mark(&mut panel, quest, answer, &number, is_first);
            panels.push(panel);
        }
    }
    let varied = String::from(quest.span.label());
    let title = match &quest.goal {
        Goal::Keep(condition) => {
            format!("Search for {varied}: “{condition}”", condition = condition.text)
        }
        Goal::Reach(target) => {
            format!("Search for {varied}: {number} as wanted", number = target.name.text)
        }
    };
    let failed = answer.failed.iter().map(|(_, count)| count).sum::<usize>();
    let note = (failed > 0).then(|| format!("{failed} of the runs came to nothing and are not drawn."));
    chart(&title, panels, note)
}

/// The number that is to be best over each key.
pub fn plot_best(spans: &[Span], name: &Named, condition: Option<&Condition>, best: &Best) -> Option<Chart> {
    let number = name.find(&best.base).ok()?;
    let (mut panels, mut column) = (Vec::new(), 0);
    for span in spans {
        let key = Key::of(span, column, &best.rows, condition);
        column += span.keys().len();
        if let Some(mut panel) = key.panel(number, None, panels.is_empty()) {
            if let Some(at) = best.best.and_then(|run| key.place(&best.rows[run], number)) {
                panel.series.push(Series::new(String::from("best"), vec![at], Look::Flag));
            }
            panels.push(panel);
        }
    }
    let name = name.text.clone();
    let title = match condition {
        None => format!("Search for the best {name}"),
        Some(condition) => {
            format!("Search for the best {name}: “{condition}”", condition = condition.text)
        }
    };
    let note = format!("Each run stands in every panel; {n} of them are of the grid.", n = best.grid);
    chart(&title, panels, Some(note))
}

fn chart(title: &str, panels: Vec<Panel>, note: Option<String>) -> Option<Chart> {
    let chart = Chart { title: title.to_string(), legend: String::new(), panels, notes: note.into_iter().collect() };
    (!chart.panels.is_empty()).then_some(chart)
}

/// The numbers that a condition limits, with their limits.
fn limits<'a>(condition: &'a Condition, base: &Solved) -> Vec<(&'a Named, Option<f64>)> {
    let of = |name: &Named, limit| name.find(base).and_then(|number| name.limit(number, limit)).ok();
    condition.numbers().map(|(name, limit)| (name, of(name, limit))).collect()
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

/// What is varied, and the runs over it.
struct Key<'a> {
    axis: Axis,
    /// What its values are multiplied by to be told.
    times: f64,
    /// Ends of the span, where they are drawn.
    ends: [f64; 2],
    /// Its place among the values of a design.
    column: usize,
    runs: Vec<(Mark, &'a Row)>,
    has_condition: bool,
}

impl<'a> Key<'a> {
    fn of(span: &Span, column: usize, rows: &'a [Row], condition: Option<&Condition>) -> Self {
        let (unit, times) = span.solver_unit().unwrap_or((Unit::None, 1.0));
        let (axis, told) = Axis::named(span.label(), unit).displayed(span.ends()[1] * times);
        let is_kept = |row: &Row| condition.map(|condition| condition.judge(row) == Said::Holds);
        let runs = rows.iter().filter_map(|row| Some((Mark::of(row, is_kept(row))?, row))).collect();
        let times = times * told.factor;
        let axis = axis.spaced(span.spacing());
        let ends = span.ends().map(|end| span.spacing().place(end * times));
        Self { axis, times, ends, column, runs, has_condition: condition.is_some() }
    }

    /// Where a value of the key is drawn.
    fn along(&self, value: f64) -> f64 {
        self.axis.spacing().place(value * self.times)
    }

    /// A number's axis, and what its values are multiplied by.
    fn scale(&self, number: &Number) -> (Axis, f64) {
        let label = String::from(number.label);
        let (axis, told) = Axis::named(label, number.amount.unit).displayed(number.amount.value);
        (axis, told.factor)
    }

    /// Where a run is drawn.
    fn place(&self, row: &Row, number: &Number) -> Option<(f64, f64)> {
        let x = self.along(row.design.values[self.column].number?);
        Some((x, row.result.as_ref().ok()?.outcome.value(number)? * self.scale(number).1))
    }

    /// A number of all runs, over a level of it.
    fn panel(&self, number: &Number, level: Option<Series>, is_first: bool) -> Option<Panel> {
        let series = Mark::ALL.into_iter().filter_map(|mark| {
            let own = self.runs.iter().filter(|(of, _)| *of == mark);
            let points: Vec<_> = own.filter_map(|(_, row)| self.place(row, number)).collect();
            let label = is_first.then(|| mark.label(self.has_condition).to_string());
            (!points.is_empty()).then(|| Series { label, points, look: mark.look() })
        });
        let runs: Vec<Series> = series.collect();
        if runs.is_empty() {
            return None;
        }
        let series = level.into_iter().chain(runs).collect();
        let scale = Scale::Fit { height: HEIGHT, least: 0.0 };
        let mut panel = Panel { x: self.axis.clone(), y: self.scale(number).0, series, scale };
        // The span that was looked through, and no zero far from it.
        let [low, high] = self.ends;
        let margin = MARGIN * (high - low);
        panel.scale = Scale::Window { height: HEIGHT, x: (low - margin, high + margin), y: panel.ranges()[1] };
        Some(panel)
    }

    /// A value of a number, over all runs.
    fn level(&self, number: &Number, value: f64, label: Option<String>) -> Series {
        let points = self.ends.map(|x| (x, value * self.scale(number).1)).to_vec();
        Series { label, points, look: Look::Line { color: GREY, width: 1.6, dash: &[6.0, 4.0] } }
    }

    /// What was found: the bracket over the height of a panel, and in the first the value.
    fn mark(&self, panel: &mut Panel, quest: &Quest, answer: &Answer, number: &Number, is_first: bool) {
        let Found::Between([inner, outer]) = answer.bracket.found else { return };
        let [_, (low, high)] = panel.ranges();
        let [a, b] = [inner, outer].map(|value| self.along(value));
        let outline = vec![(a, low), (a, high), (b, high), (b, low)];
        panel.series.insert(0, Series::silent(outline, Look::Area { fill: PALE, edge: None }));
        let Some(run) = answer.best else { return };
        let x = answer.value(run);
        match self.place(&answer.rows[run], number).filter(|_| is_first) {
            Some(at) => panel.series.push(Series::new(quest.span.told(x).to_string(), vec![at], Look::Flag)),
            None => {
                let line = Look::Line { color: BLACK, width: 1.2, dash: &[] };
                panel.series.push(Series::silent(vec![(self.along(x), low), (self.along(x), high)], line));
            }
        }
    }
}
