//! Verdict in one sentence, its failure modes, and the numbers of the part.

use super::filling::Filling;
use super::press::{clamp, closing, further, largest_force, load, pad};
use super::tear::{self, Tear, place, tear};
use super::{finding::labels, *};
use crate::measure::{
    self, OPENING_ANGLE, Shape, element_at, outside_diameters, part_height, stripping_force, wall_at,
};
use crate::numerics::interpolated;

/// Verdict in one sentence, and the numbers that a part is known by.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// Worst light of the verdict.
    pub light: Light,
    /// Failure, or the most important warning.
    pub sentence: String,
    /// Failure modes, the most important first; empty for a sound part.
    #[serde(skip)]
    pub failures: Vec<FailureMode>,
    /// Reason of a planned end before the full travel; else empty.
    #[serde(skip)]
    pub end: String,
    /// Numbers of the part and the press.
    pub numbers: Vec<Quantity>,
}

impl Answer {
    /// Answer from solved stages and the [findings](super::after) on them.
    pub fn of(case: &Case, stages: &[StageSolution], findings: &[Finding]) -> Self {
        let end = stages.last().map(|stage| &stage.stop);
        let end = end.filter(|stop| stop.is_complete() && stop.kind != StopKind::FullTravel);
        let failures = FailureMode::all(stages, findings);
        let tear = tear(stages);
        let edge = judgements(findings).find(|finding| finding.key == "edge").map(Finding::statement);
        let hole = edge.map_or_else(String::new, |edge| first_clause(&edge).to_owned());
        let index = stages.last().and_then(erichsen_index).map(|index| format!("IE = {} (ISO 20482)", index.amount));
        let mut sentence = [sentence(stages, findings, &failures, tear.as_ref()), index.unwrap_or(hole)];
        // The result of a test comes first.
        if is_test(stages) {
            sentence.reverse();
        }
        Self {
            light: judgements(findings).map(|finding| finding.light).max().unwrap_or(Light::Grey),
            sentence: joined(sentence, "; "),
            end: end.map_or_else(String::new, ToString::to_string),
            numbers: numbers(case, stages, tear.is_some()),
            failures,
        }
    }
}

/// True of a test that ended by the failure it looks for: the crack of a hole's edge, or the largest force on Erichsen's ball.
pub(super) fn is_test(stages: &[StageSolution]) -> bool {
    let ended = |stage: &StageSolution| stage.stop.kind == StopKind::EdgeLimit || erichsen_index(stage).is_some();
    stages.last().is_some_and(ended)
}

fn sentence(stages: &[StageSolution], findings: &[Finding], failures: &[FailureMode], tear: Option<&Tear>) -> String {
    let row = |key: &str| judgements(findings).find(|finding| finding.key == key);
    let folds = row("fold").map_or_else(String::new, |row| first_clause(&row.text).to_owned());
    if let Some(tear) = tear.filter(|tear| fold::first(stages).is_none_or(|(i, frame)| tear.is_before(i, frame.time))) {
        return joined([tear.sentence(stages.len()), folds], "; ");
    }
    if !folds.is_empty() {
        return folds;
    }
    let is = |key: &str, light: Light| row(key).is_some_and(|finding| finding.light == light);
    let share = |key: &str| row(key)?.value().map(|percent| 0.01 * percent);
    match stages.last().map(|stage| &stage.stop) {
        Some(stop) if stop.kind == StopKind::Interrupted => return "interrupted by the user".into(),
        Some(stop) if !stop.is_complete() && is("stop", Light::Red) => {
            return format!("not solved to its end: {}", stop.kind.name());
        }
        _ => {}
    }
    let thinnest = stages.last().and_then(|stage| stage.steps.last());
    let at = thinnest.map_or_else(String::new, |step| place(stages, step.thinnest_s0));
    let [red, amber] = [Light::Red, Light::Amber].map(|light| labels(findings, light).join(", "));
    let limit_used = share("forming_limit");
    let limit_is_amber = is("forming_limit", Light::Amber);
    let pulled = share("tearing").filter(|used| is("tearing", Light::Amber) && *used > tear::TEARING[0]);
    let thinning = share("thinning").unwrap_or_default();
    let thins = format!("it thins by {} {at}", Amount::share(thinning));
    match failures.first() {
        Some(FailureMode::Tears) => joined(["it thins too far".into(), at], " "),
        Some(FailureMode::Wrinkles) if stages[0].model.tool(Role::Holder).is_none() => {
            "it wrinkles: nothing holds the flange".into()
        }
        Some(FailureMode::Wrinkles) => "it wrinkles: the holder presses too little for this flange".into(),
        Some(_) => format!("it does not tear, but is refused: {red}"),
        None if limit_is_amber && limit_used.is_none() => {
            format!("whether it tears is not known: {thins}, and the forming limit ends before")
        }
        // Decided by the number: a row that only its error bar makes amber is one of the others.
        None if limit_is_amber && limit_used > Some(forming_limit::CAREFUL) => {
            joined(["it comes near to tearing".into(), at], " ")
        }
        None if pulled.is_some() => {
            let used = Amount::share(pulled.unwrap_or_default());
            format!("it comes near to tearing: it is pulled with {used} of what it bears")
        }
        None if is("thinning", Light::Amber) && thinning > tear::CAREFUL => {
            let rule = Amount::given_share(tear::CAREFUL);
            format!("{thins}, more than the {rule} rule of thumb; no forming limit is given")
        }
        _ if is("stop", Light::Amber) => {
            joined(["it does not tear".into(), row("stop").map_or_else(String::new, Finding::statement)], "; ")
        }
        _ if !amber.is_empty() => format!("it does not tear; look at {amber}"),
        _ if is("edge", Light::Grey) => "it does not tear; whether the edge cracks is not judged".into(),
        _ if is("springback", Light::Grey) && largest_force(stages).is_some() => {
            "it does not tear; its spring-back is not judged".into()
        }
        _ if is("wall_wrinkles", Light::Grey) => "it does not tear; whether its free wall puckers is not judged".into(),
        _ => "it does not tear, and nothing speaks against it".into(),
    }
}

fn numbers(case: &Case, stages: &[StageSolution], is_torn: bool) -> Vec<Quantity> {
    let end = stages.last().and_then(|stage| stage.steps.last());
    let all = [
        end.and_then(|end| thinnest(stages, end, is_torn)),
        load(case, stages, 0.0),
        stages.last().and_then(pressure),
        closing(case, stages),
        stages.first().and_then(die_gap),
        stages.last().and_then(hole),
        stages.last().and_then(erichsen_index),
        stages.first().and_then(holder),
        stages.first().and_then(pad),
        stages.first().and_then(clamp),
        stages.last().and_then(stripping),
        further(stages),
        Some(blank(case.model())),
        stages.last().and_then(opening_angle),
        stages.last().filter(|_| !is_torn).and_then(height),
        stages.last().filter(|_| !is_torn).and_then(|stage| rim(case, stage).or_else(|| ironed(stage))),
        stages.last().filter(|_| !is_torn).and_then(step),
        draw_in(stages),
        formed(stages).last().and_then(|(_, stage)| stretched(stage)),
        ring(case, stages),
    ];
    all.into_iter().flatten().collect()
}

/// Change of thickness that a whole percent does not show \[–\].
const NOTHING: f64 = 0.005;

fn thicker(stages: &[StageSolution]) -> Option<String> {
    let elements = &stages.last()?.frames.last()?.elements;
    let most = elements.iter().max_by(|a, b| a.strain_thickness.total_cmp(&b.strain_thickness))?;
    let [thickness, more] = [Amount::thickness(most.thickness), Amount::share(most.strain_thickness.exp_m1())];
    let text = format!("thickest {thickness}, {more} thicker, {}", place(stages, most.s0));
    (most.strain_thickness > NOTHING).then_some(text)
}

fn thinnest(stages: &[StageSolution], end: &StepRecord, is_torn: bool) -> Option<Quantity> {
    let thinning = (1.0 - end.thinnest / stages.last()?.model.blank.unformed_thickness(end.thinnest_s0)).max(0.0);
    // What comes after it is another sheet.
    let thicker = || thicker(stages).filter(|_| thinning < NOTHING).unwrap_or_default();
    let after = if is_torn { "after the tear".into() } else { thicker() };
    let thinner = Amount::share((1e4 * thinning).round() / 1e4);
    let at = if thinner.value > 0.0 { place(stages, end.thinnest_s0) } else { String::new() };
    let about = [format!("{thinner} thinner"), at, after];
    Some(Quantity::new("thinnest", "Thinnest", Amount::thickness(end.thinnest)).at(joined(about, ", ")))
}

fn die_gap(stage: &StageSolution) -> Option<Quantity> {
    let filling = Filling::of(stage)?;
    let about = format!("to the die, {}", filling.about(std::slice::from_ref(stage)));
    Some(Quantity::new("die_gap", "Gap", Amount::thickness(filling.gap)).at(about))
}

/// Clear diameter of the hole at the end, and the thickness of its edge beside t₀ (d₀/d)^(1/(1 + r̄)), that of simple tension.
fn hole(stage: &StageSolution) -> Option<Quantity> {
    let (blank, hole) = (&stage.model.blank, stage.steps.last()?.hole);
    if blank.is_open() {
        return end(stage);
    }
    let (edge, node) = (stage.frames.last()?.elements.first()?, stage.frames.last()?.nodes.first()?);
    let share = 1.0 / (1.0 + stage.model.material.yield_criterion.ratio());
    let tension = blank.thickness * (blank.hole / node.r).powf(share);
    let [edge, tension] = [edge.thickness, tension].map(Amount::thickness);
    let about = format!("clear in diameter, its edge {edge} thick, {tension} in simple tension");
    (hole > 0.0).then(|| Quantity::new("hole", "Hole", Amount::place(hole)).at(about))
}

/// Travel of Erichsen's ball, Ø 20 mm, at its largest force (ISO 20482).
fn erichsen_index(stage: &StageSolution) -> Option<Quantity> {
    let is_ball = (extent(stage.model.tool(Role::Punch)?).1 - 10.0).abs() < 1e-6;
    let is_test = is_ball && stage.stop.kind == StopKind::LoadMaximum;
    let (_, peak, _) = largest_force(std::slice::from_ref(stage)).filter(|_| is_test)?;
    let index = Quantity::new("erichsen_index", "Erichsen index", Amount::place(peak.travel));
    Some(index.at("IE, travel at the largest force, the end of the test (ISO 20482)"))
}

/// Pressure beside the force that feeds a tube.
fn pressure(stage: &StageSolution) -> Option<Quantity> {
    let pressure = Amount::stress(super::largest(stage, |step| step.pressure));
    let is_fed = stage.model.blank.edge == Edge::Fed && !stage.model.gas.is_empty();
    is_fed.then(|| Quantity::new("pressure", "Pressure", pressure).at("at its largest"))
}

fn end(stage: &StageSolution) -> Option<Quantity> {
    let (frame, blank) = (stage.frames.last()?, &stage.model.blank);
    let (end, widest) = (outside_diameters(frame).last()?, outside_diameters(frame).fold(0.0, f64::max));
    let about = format!("outside in diameter, its edge {} thick", Amount::thickness(frame.nodes.last()?.thickness));
    // Half a percent is worth a word, declared.
    let is_wider = widest > 1.005 * end.max(2.0 * blank.reach() + blank.thickness);
    let wider = if is_wider { format!("Ø {} where the tube is widest", Amount::place(widest)) } else { String::new() };
    Some(Quantity::new("end", "End", Amount::place(end)).at(joined([about, wider], "; ")))
}

fn holder(stage: &StageSolution) -> Option<Quantity> {
    let model = &stage.model;
    if let Motion::Gap(gap) = model.tool(Role::Holder)?.motion {
        let about = format!("to the die, {}", Amount::thicknesses(gap / model.blank.thickness));
        return Some(Quantity::new("holder_gap", "Holder gap", Amount::size(gap)).at(about));
    }
    let force = Amount::force(super::largest(stage, |step| step.holder_force), model.extent().force_unit());
    let closing = Amount::force(estimate::closing_of_beads(model), force.unit).to(Digits::Significant(3));
    let beside = if closing.value > 0.0 { format!("; {closing} more keep the beads closed") } else { String::new() };
    let force = Quantity::new("holder_force", "Holder", force.to(Digits::Significant(3)));
    Some(force.at(format!("at its largest{beside}")))
}

fn stripping(stage: &StageSolution) -> Option<Quantity> {
    let force = stripping_force(stage).filter(|force| *force > 0.0 && stage.stop.kind == StopKind::LeftDie)?;
    let force = Amount::force(force, stage.model.extent().force_unit());
    let about = "to pull the punch out, if its wall keeps the pressure of the last step (declared)";
    Some(Quantity::new("stripping_force", "Stripping", force).at(about))
}

fn blank(model: &Model) -> Quantity {
    let across = worded(model.geometry, "in diameter", "wide");
    if model.blank.meridian.is_some() {
        let [length, thick] = [model.blank.length, model.blank.thickness].map(Amount::size);
        let half = if model.is_half_tube() { ", one half of the tube" } else { "" };
        let about = format!("{across} outside, {length} along the sheet, {thick} thick{half}");
        let outside = 2.0 * model.blank.reach() + model.blank.thickness;
        return Quantity::new("blank", "Blank", Amount::size(outside)).at(about);
    }
    let amount = Amount::new(2.0 * model.blank.length, Unit::Mm, Digits::Given(2));
    let hole = Some(model.blank.hole).filter(|_| model.blank.has_hole());
    let hole = hole.map_or_else(String::new, |hole| format!("hole {}", Amount::set(2.0 * hole)));
    let thick = format!("{} thick", Amount::size(model.blank.thickness));
    Quantity::new("blank", "Blank", amount).at(joined([across.to_owned(), hole, thick], ", "))
}

fn opening_angle(stage: &StageSolution) -> Option<Quantity> {
    let is_bend = stage.model.geometry == Geometry::PlaneStrain && step(stage).is_none();
    let [before, after] = stage.released().filter(|_| is_bend)?;
    let angle = |frame| (OPENING_ANGLE.of)(&Shape::of(frame)).map(Amount::angle);
    let opening = Quantity::new(OPENING_ANGLE.key, OPENING_ANGLE.label, angle(after)?);
    Some(opening.at(format!("sprung back{}", under_load(angle(before)))))
}

fn height(stage: &StageSolution) -> Option<Quantity> {
    let before = stage.released().and_then(|[before, _]| part_height(before)).map(Amount::place);
    let height = Quantity::new("part_height", "Height", Amount::place(part_height(stage.frames.last()?)?));
    let half = if stage.model.is_half_tube() { ", of one half" } else { "" };
    Some(height.at(format!("over all{half}{}", under_load(before))))
}

/// Depth between the ends of a punch's inner and outer flat, where the sheet lies at the same distances from the symmetry plane.
fn step(stage: &StageSolution) -> Option<Quantity> {
    let [before, after] = stage.released().filter(|_| stage.model.geometry == Geometry::PlaneStrain)?;
    let pieces = stage.model.tool(Role::Punch)?.profile.pieces();
    let [inner, .., outer] = pieces else { return None };
    let is_level = |piece: &Piece| matches!(piece, Piece::Segment(line) if line.from.y == line.to.y);
    let of_punch = inner.last().y - outer.first().y;
    let depth = |frame: &Frame| {
        let middle: Vec<_> = frame.nodes.iter().map(|node| (node.r, node.z)).collect();
        Amount::thickness(interpolated(&middle, inner.last().x) - interpolated(&middle, outer.first().x))
    };
    let about = format!("sprung back, {} under load, {} of the punch", depth(before), Amount::thickness(of_punch));
    let is_wall = |piece: &Piece| matches!(piece, Piece::Segment(line) if (line.from.x - line.to.x).abs() < 1e-6);
    let is_stepped = is_level(inner) && is_level(outer) && of_punch > 0.0 && !pieces.iter().any(is_wall);
    is_stepped.then(|| Quantity::new("step", "Step", depth(after)).at(about))
}

/// Excess of a wall over its gap that is worth a word \[mm\]: declared, two of the last digit.
const PRESSED: f64 = 0.02;

fn rim(case: &Case, stage: &StageSolution) -> Option<Quantity> {
    let height = case.finished.height.filter(|_| case.finished.flange_diameter.is_none())?;
    let [r, _, thickness] = wall_at(stage.frames.last()?, height)?;
    let outside = format!("thick where it is trimmed, {} outside", Amount::place(2.0 * r + thickness));
    Some(Quantity::new("rim", "Rim", Amount::thickness(thickness)).at(outside + &pressed(stage, thickness)))
}

fn ironed(stage: &StageSolution) -> Option<Quantity> {
    let most = stage.steps.iter().max_by(|a, b| a.ironing.total_cmp(&b.ironing))?;
    let is_narrow = estimate::clearance(&stage.model, stage.model.travel)? < stage.model.blank.thickness;
    let frame = stage.frames.last().filter(|_| is_narrow && most.ironing > tools::IRONED)?;
    let wall = frame.elements[element_at(frame, most.ironing_s0)?].thickness;
    let about = format!("thick where it is ironed most{}", pressed(stage, wall));
    Some(Quantity::new("wall", "Wall", Amount::thickness(wall)).at(about))
}

/// Excess of a wall over the gap that it goes through \[mm\], by which the penalty of contact lets it into the tools.
fn pressed(stage: &StageSolution, wall: f64) -> String {
    let gap = estimate::clearance(&stage.model, stage.model.travel).filter(|gap| wall - gap > PRESSED);
    let Some(gap) = gap else { return String::new() };
    let [gap, by] = [gap, wall - gap].map(Amount::thickness);
    format!(", {by} more than the gap of {gap}: pressed into the tools (penalty)")
}

fn under_load(before: Option<Amount>) -> String {
    before.map_or_else(String::new, |before| format!(", {before} under load"))
}

fn draw_in(stages: &[StageSolution]) -> Option<Quantity> {
    let (_, stage) = formed(stages).last().filter(|(_, stage)| stage.stop.kind != StopKind::LeftDie)?;
    Some(&stage.model.blank).filter(|blank| blank.meridian.is_none() && blank.edge == Edge::Free)?;
    let load = if stages.last()?.model.release.is_some() { ", under load" } else { "" };
    let draw_in = Amount::draw_in(stage.steps.last()?.draw_in);
    let spreads = || format!("the edge spreads by {}", draw_in.with_value(-draw_in.value));
    let about = if draw_in.value < 0.0 { spreads() } else { "of the edge".into() };
    Some(Quantity::new("draw_in", "Draw-in", draw_in).at(format!("{about}, on each side{load}")))
}

fn stretched(stage: &StageSolution) -> Option<Quantity> {
    let stretch = Quantity::new("stretch", "Stretch", Amount::share(measure::stretch(stage)?));
    Some(stretch.at("of the strip's middle between the clamps, under load"))
}

fn ring(case: &Case, stages: &[StageSolution]) -> Option<Quantity> {
    let ring = case.springback.ring?;
    let [height, from] = [ring.height, ring.from].map(Amount::size);
    let about = format!("when slit; a ring {height} high, cut {from} over the bottom");
    Some(Quantity::new("ring_opening", "Ring opening", Amount::opening(ring.opening(stages)?)).at(about))
}
