//! What a designer asks first: does it tear, where, what does the press see.

use super::error_bar::ErrorBar;
use super::nearest::Nearest;
use super::neck::torn;
use super::press::Load;
use super::{Finding, Light, judgements, thinning};
use crate::case::Case;
use crate::measure::{PartPlace, part_height, place_on_part};
use crate::message::{Amount, Digits, Message, message};
use crate::model::{Geometry, Model, Motion, Role};
use crate::solution::{StageSolution, StepRecord, Stop};
use crate::table::Unit;
use crate::units::rounded;
use serde::{Serialize, Serializer};

/// The verdict in one sentence, and the numbers that a part is known by.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// The worst of the verdict's lights but grey.
    pub light: Light,
    /// Whether it tears and where, or what else speaks against it.
    pub sentence: Message,
    /// How the last stage ended, where that is as wished but not at its full travel; else empty.
    #[serde(skip)]
    pub end: Message,
    /// In the order of telling.
    pub numbers: Vec<KeyNumber>,
}

/// One of the numbers that a part is known by.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyNumber {
    /// Name in JSON: `thinnest`.
    pub key: &'static str,
    /// Name in tables: `Thinnest`.
    pub label: &'static str,
    /// The number.
    pub amount: Amount,
    /// Where, when, and against what.
    pub about: Message,
    /// How far it can be trusted; a number with a bar has it in `amount` too.
    pub bar: ErrorBar,
}

impl KeyNumber {
    fn new(key: &'static str, label: &'static str, amount: Amount, about: Message) -> Self {
        Self { key, label, amount, about, bar: ErrorBar::Unasked }
    }

    /// With its error bar.
    pub fn with_bar(self, bar: ErrorBar) -> Self {
        let amount = if let ErrorBar::Half(half) = bar { self.amount.with_bar(half) } else { self.amount };
        Self { amount, bar, ..self }
    }
}

impl Serialize for KeyNumber {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Fields<'a> {
            key: &'a str,
            value: f64,
            #[serde(flatten)]
            bar: &'a ErrorBar,
            unit: &'a str,
            about: &'a Message,
        }
        let Self { key, amount, about, bar, .. } = self;
        Fields { key, value: rounded(amount.value), bar, unit: amount.unit.spelled(), about }.serialize(serializer)
    }
}

/// Where the sheet tears.
struct Tear<'a> {
    stage: usize,
    on: &'a StageSolution,
    /// \[mm\]; `None` of a stage without a travel.
    travel: Option<f64>,
    /// Initial distance from the axis or symmetry plane \[mm\].
    s0: Option<f64>,
}

impl Answer {
    /// From what was solved and what was [found](super::after) on it.
    pub fn of(case: &Case, stages: &[StageSolution], findings: &[Finding]) -> Self {
        let light = judgements(findings).map(|finding| finding.light).max().unwrap_or(Light::Grey);
        let end = stages.last().map(|stage| &stage.stop);
        let end = end.filter(|stop| stop.is_complete() && !matches!(stop, Stop::FullTravel));
        let tear = tear(stages);
        Self {
            light,
            sentence: sentence(stages, findings, light, tear.as_ref()),
            end: end.map_or_else(Message::default, Stop::message),
            numbers: numbers(case, stages, tear.is_some()),
        }
    }
}

/// What speaks loudest: a tear, a run that did not end, red lights, amber ones.
fn sentence(stages: &[StageSolution], findings: &[Finding], light: Light, tear: Option<&Tear>) -> Message {
    let labels =
        |of: Light| Message::joined(judgements(findings).filter(|f| f.light == of).map(|f| f.label.into()), ", ");
    let is = |key: &str, light: Light| judgements(findings).any(|f| f.key == key && f.light == light);
    let is_red = |key: &str| is(key, Light::Red);
    if let Some(tear) = tear {
        return Message::joined([tear.sentence(stages.len()), tear.when()], ", ");
    }
    if stages.last().is_some_and(|stage| matches!(stage.stop, Stop::Interrupted { .. })) {
        return "interrupted by the user".into();
    }
    if let Some(stop) = stages.last().map(|stage| &stage.stop).filter(|stop| !stop.is_complete() && is_red("stop")) {
        return message!("not solved to its end: {why}", why = stop.kind());
    }
    // Of the thinnest place, and of a finding in percent.
    let at = || stages.last().and_then(thinnest).map_or_else(Message::default, |(_, s0)| place(stages, s0));
    let share = |key: &str| judgements(findings).find(|f| f.key == key)?.value.map(|percent| 0.01 * percent);
    let bottom = share("bottom_tearing");
    match light {
        _ if is_red("bottom_tearing") => "it tears at the bottom: the punch pulls harder than the wall can bear".into(),
        _ if is_red("localisation") || is_red("thinning") => Message::joined(["it thins too far".into(), at()], " "),
        _ if is_red("wrinkling") => "it wrinkles: the holder presses too little for this flange".into(),
        Light::Amber if bottom.is_some_and(|used| used > 1.0) => message!(
            "it may tear at the bottom: the punch needs {used} of what the wall surely carries",
            used = Amount::share(bottom.unwrap_or_default())
        ),
        Light::Red if bottom.is_some_and(|used| used > 1.0) => {
            message!("it may tear at the bottom, and not as it is: {labels}", labels = labels(Light::Red))
        }
        Light::Red => message!("it does not tear, but not as it is: {labels}", labels = labels(Light::Red)),
        Light::Amber if is("forming_limit", Light::Amber) && share("forming_limit").is_none() => message!(
            "whether it tears is not known: it thins by {thinning} {place}, and the forming limit ends before",
            thinning = Amount::share(share("thinning").unwrap_or_default()),
            place = at()
        ),
        Light::Amber if is("forming_limit", Light::Amber) => {
            Message::joined(["it comes near to tearing".into(), at()], " ")
        }
        // One that only its error bar makes amber is among the others.
        Light::Amber if is("thinning", Light::Amber) && share("thinning") > Some(thinning::CAREFUL) => {
            let thins = message!(
                "it thins by {thinning} {place}, more than the {rule} rule of thumb",
                thinning = Amount::share(share("thinning").unwrap_or_default()),
                place = at(),
                rule = Amount::given_share(thinning::CAREFUL)
            );
            let limit = match share("forming_limit") {
                Some(used) => message!("the forming limit is used to {used}", used = Amount::share(used)),
                None => "no forming limit is given".into(),
            };
            Message::joined([thins, limit], "; ")
        }
        Light::Amber => message!("it does not tear; look at {labels}", labels = labels(Light::Amber)),
        _ => "it does not tear, and nothing speaks against it".into(),
    }
}

/// Where the run saw the sheet tear, or where its forming limit was first reached.
fn tear(stages: &[StageSolution]) -> Option<Tear<'_>> {
    let ended = stages.iter().enumerate().find_map(|(stage, on)| {
        let (travel, s0) = match on.stop {
            Stop::Localised { travel, s0, .. } | Stop::Coalesced { travel, s0, .. } => (Some(travel), Some(s0)),
            Stop::LoadMaximum { travel, .. } => (Some(travel), thinnest(on).map(|(_, s0)| s0)),
            Stop::PressureMaximum { s0, .. } => (None, Some(s0)),
            _ => return None,
        };
        Some(Tear { stage, on, travel, s0 })
    });
    let limit = || {
        let nearest = Nearest::of(stages)?;
        let reached = nearest.assessment.reached?;
        let stage = stages.iter().position(|stage| std::ptr::eq(stage, nearest.stage))?;
        let travel = (nearest.stage.model.travel > 0.0).then_some(reached.travel);
        Some(Tear { stage, on: nearest.stage, travel, s0: Some(reached.s0) })
    };
    // The limit is reached before a neck ends the run, and is where the tear begins.
    limit().or(ended)
}

/// Whether and where it tears: `it tears on the dome`.
pub(super) fn whether_it_tears(stages: &[StageSolution]) -> Message {
    match (tear(stages), stages.last().and_then(torn)) {
        (Some(tear), _) => tear.sentence(stages.len()),
        (None, Some(neck)) => Message::joined(["it thins too far".into(), place(stages, neck.s0)], " "),
        (None, None) => "no tear is seen".into(),
    }
}

/// Where the sheet of a stage tears, initially from the axis \[mm\]: where the verdict's sentence has it, or where it is
/// too thin to be whole.
pub fn tears_at(stage: &StageSolution) -> Option<f64> {
    stage.steps.last()?;
    let tear = tear(std::slice::from_ref(stage)).and_then(|tear| tear.s0);
    tear.or_else(|| torn(stage).map(|neck| neck.s0))
}

impl Tear<'_> {
    /// `it tears in the wall, next to the punch radius, in stage 2`
    fn sentence(&self, stages: usize) -> Message {
        let place = self.s0.map_or_else(Message::default, |s0| on_part(self.on, s0));
        let stage = if stages > 1 { message!("in stage {n}", n = self.stage + 1) } else { Message::default() };
        Message::joined([Message::joined(["it tears".into(), place], " "), stage], ", ")
    }

    /// `after 18.2 of 32.0 mm of travel`
    fn when(&self) -> Message {
        let whole = self.on.model.travel;
        self.travel.map_or_else(Message::default, |travel| {
            let (reached, all) = (Amount::place(travel), Amount::place(whole));
            message!("after {travel} of {all} of travel", travel = reached, all = all)
        })
    }
}

/// The numbers that a part is known by: thinnest place, force and press, holder, blank, height, draw-in, and the
/// opening of a slit ring.
fn numbers(case: &Case, stages: &[StageSolution], is_torn: bool) -> Vec<KeyNumber> {
    let all = [
        thinnest_number(stages, is_torn),
        load(case, stages),
        holder(stages),
        Some(blank(case.model())),
        height(stages),
        draw_in(stages),
        ring(case, stages),
    ];
    all.into_iter().flatten().collect()
}

/// Thickness \[mm\] and initial distance \[mm\] of the thinnest element at the end of a stage.
fn thinnest(stage: &StageSolution) -> Option<(f64, f64)> {
    stage.steps.last().map(|step| (step.thinnest, step.thinnest_s0))
}

fn thinnest_number(stages: &[StageSolution], is_torn: bool) -> Option<KeyNumber> {
    let stage = stages.last()?;
    let (thickness, s0) = thinnest(stage)?;
    let thinning = 1.0 - thickness / stage.model.blank.thickness;
    let about = message!("{thinning} thinner", thinning = Amount::share(thinning));
    // What comes after it is another sheet.
    let after = if is_torn { "after the tear".into() } else { Message::default() };
    let about = Message::joined([about, place(stages, s0), after], ", ");
    Some(KeyNumber::new("thinnest", "Thinnest", Amount::thickness(thickness), about))
}

/// The stages that form the sheet, with their numbers.
fn formed(stages: &[StageSolution]) -> impl Iterator<Item = (usize, &StageSolution)> {
    stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none())
}

/// The step where something is largest, and the number of its stage.
fn largest(stages: &[StageSolution], value: fn(&StepRecord) -> f64) -> Option<(usize, &StepRecord)> {
    let steps = formed(stages).flat_map(|(i, stage)| stage.steps.iter().map(move |step| (i, step)));
    steps.max_by(|a, b| value(a.1).total_cmp(&value(b.1)))
}

/// The step with the largest punch force, and the number of its stage; `None` where no punch presses.
pub fn largest_force(stages: &[StageSolution]) -> Option<(usize, &StepRecord)> {
    largest(stages, |step| step.punch_force).filter(|(_, peak)| peak.punch_force > 0.0)
}

/// The largest force over all stages, or the largest gas pressure where no punch moves.
fn load(case: &Case, stages: &[StageSolution]) -> Option<KeyNumber> {
    let several = formed(stages).count() > 1;
    let stage = |i: usize| if several { message!("in stage {n}", n = i + 1) } else { Message::default() };
    let Some((i, peak)) = largest_force(stages) else {
        let (i, peak) = largest(stages, |step| step.pressure.abs()).filter(|(_, peak)| peak.pressure != 0.0)?;
        let at = message!("at a height of {height}", height = Amount::place(peak.pole_height.abs()));
        let about = Message::joined([stage(i), at], ", ");
        return Some(KeyNumber::new("pressure", "Pressure", Amount::stress(peak.pressure.abs()), about));
    };
    let unit = stages[i].model.extent().force_unit();
    let at = message!("at {travel} of travel", travel = Amount::place(peak.travel));
    let at = Message::joined([stage(i), at], ", ");
    let pressed = Load::largest(stages)?;
    let press = match case.press.force {
        Some(rating) => message!(
            "{share} of the press's {rating}",
            share = Amount::share(pressed.force() / rating),
            rating = Amount::force(rating, unit)
        ),
        None => message!("a press of at least {rating}", rating = pressed.rating()),
    };
    let with_holder = if pressed.holder() > 0.0 { "with the holder".into() } else { Message::default() };
    let press = Message::joined([press, with_holder], " ");
    let about = Message::joined([at, press], "; ");
    Some(KeyNumber::new("punch_force", "Punch force", Amount::force(peak.punch_force, unit), about))
}

/// The largest holder force, or the gap of a holder that stands.
fn holder(stages: &[StageSolution]) -> Option<KeyNumber> {
    let stage = stages.first()?;
    let holder = stage.model.tool(Role::Holder)?;
    if let Motion::Gap(gap) = holder.motion {
        let about = message!("to the die, {ratio}", ratio = Amount::thicknesses(gap / stage.model.blank.thickness));
        return Some(KeyNumber::new("holder_gap", "Holder gap", Amount::size(gap), about));
    }
    let force = stage.steps.iter().map(|step| step.holder_force).fold(0.0, f64::max);
    let amount = Amount::force(force, stage.model.extent().force_unit());
    Some(KeyNumber::new("holder_force", "Holder", amount, "at its largest".into()))
}

fn blank(model: &Model) -> KeyNumber {
    let t = Amount::size(model.blank.thickness);
    let about = match model.geometry {
        Geometry::Axisymmetric => message!("in diameter, {t} thick", t = t),
        Geometry::PlaneStrain => message!("wide, {t} thick", t = t),
    };
    let amount = Amount::new(2.0 * model.blank.length, Unit::Mm, Digits::Given(2));
    KeyNumber::new("blank", "Blank", amount, about)
}

fn height(stages: &[StageSolution]) -> Option<KeyNumber> {
    let height = part_height(stages.last()?.frames.last()?)?;
    Some(KeyNumber::new("part_height", "Height", Amount::place(height), "over all".into()))
}

fn draw_in(stages: &[StageSolution]) -> Option<KeyNumber> {
    let drawn = stages.last()?.steps.last()?.draw_in;
    Some(KeyNumber::new("draw_in", "Draw-in", Amount::place(drawn), "of the edge, on each side".into()))
}

fn ring(case: &Case, stages: &[StageSolution]) -> Option<KeyNumber> {
    let ring = case.springback.ring?;
    let about = message!(
        "when slit; a ring {height} high, cut {from} over the bottom",
        height = Amount::size(ring.height),
        from = Amount::size(ring.from)
    );
    let amount = Amount::place(ring.opening(stages)?);
    Some(KeyNumber::new("ring_opening", "Ring opening", amount, about))
}

/// A place by its name on the part, as the last stage has one, and where it is on the flat blank.
fn place(stages: &[StageSolution], s0: f64) -> Message {
    let named = stages.iter().rev().find(|stage| place_on_part(stage, s0).is_some());
    named.or(stages.last()).map_or_else(Message::default, |stage| on_part(stage, s0))
}

fn on_part(stage: &StageSolution, s0: f64) -> Message {
    let blank = match stage.model.geometry {
        Geometry::Axisymmetric => message!("{s0} from the axis on the flat blank", s0 = Amount::place(s0)),
        Geometry::PlaneStrain => message!("{s0} from the middle of the flat blank", s0 = Amount::place(s0)),
    };
    match place_on_part(stage, s0) {
        Some(PartPlace { band, next_to: None, .. }) => {
            message!("{band} ({blank})", band = band.at(), blank = blank)
        }
        Some(PartPlace { band, next_to: Some(other), .. }) => {
            message!("{band}, next to the {other} ({blank})", band = band.at(), other = other.name(), blank = blank)
        }
        None => blank,
    }
}
