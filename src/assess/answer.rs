//! What a designer asks first: does it tear, where, what does the press see.

use super::key_number::numbers;
use super::nearest::Nearest;
use super::neck::torn;
use super::place::{on_part, place, thinnest};
use super::{Finding, Light, forming_limit, judgements, thinning};
use crate::case::Case;
use crate::solver::solution::{StageSolution, Stop};
use crate::units::{Amount, Quantity, joined};
use serde::Serialize;

/// The verdict in one sentence, and the numbers that a part is known by.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// The worst of the verdict's lights but grey.
    pub light: Light,
    /// Whether it tears and where, or what else speaks against it.
    pub sentence: String,
    /// How the last stage ended, where that is as wished but not at its full travel; else empty.
    #[serde(skip)]
    pub end: String,
    /// In the order of telling.
    pub numbers: Vec<Quantity>,
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
            end: end.map_or_else(String::new, ToString::to_string),
            numbers: numbers(case, stages, tear.is_some()),
        }
    }
}

/// What speaks loudest: a tear, a run that did not end, red lights, amber ones.
fn sentence(stages: &[StageSolution], findings: &[Finding], light: Light, tear: Option<&Tear>) -> String {
    let labels = |of: Light| joined(judgements(findings).filter(|f| f.light == of).map(|f| f.label.into()), ", ");
    let is = |key: &str, light: Light| judgements(findings).any(|f| f.key == key && f.light == light);
    let is_red = |key: &str| is(key, Light::Red);
    if let Some(tear) = tear {
        return joined([tear.sentence(stages.len()), tear.when()], ", ");
    }
    if stages.last().is_some_and(|stage| matches!(stage.stop, Stop::Interrupted { .. })) {
        return "interrupted by the user".into();
    }
    if let Some(stop) = stages.last().map(|stage| &stage.stop).filter(|stop| !stop.is_complete() && is_red("stop")) {
        return format!("not solved to its end: {why}", why = stop.kind());
    }
    // Of the thinnest place, and of a finding in percent.
    let at = || stages.last().and_then(thinnest).map_or_else(String::new, |(_, s0)| place(stages, s0));
    let share = |key: &str| judgements(findings).find(|f| f.key == key)?.value().map(|percent| 0.01 * percent);
    let bottom = share("bottom_tearing");
    match light {
        _ if is_red("bottom_tearing") => "it tears at the bottom: the punch pulls harder than the wall can bear".into(),
        _ if is_red("localisation") || is_red("thinning") => joined(["it thins too far".into(), at()], " "),
        _ if is_red("wrinkling") => "it wrinkles: the holder presses too little for this flange".into(),
        Light::Amber if bottom.is_some_and(|used| used > 1.0) => format!(
            "it may tear at the bottom: the punch needs {used} of what the wall surely carries",
            used = Amount::share(bottom.unwrap_or_default())
        ),
        Light::Red if bottom.is_some_and(|used| used > 1.0) => {
            format!("it may tear at the bottom, and not as it is: {labels}", labels = labels(Light::Red))
        }
        Light::Red => format!("it does not tear, but not as it is: {labels}", labels = labels(Light::Red)),
        Light::Amber if is("forming_limit", Light::Amber) && share("forming_limit").is_none() => format!(
            "whether it tears is not known: it thins by {thinning} {place}, and the forming limit ends before",
            thinning = Amount::share(share("thinning").unwrap_or_default()),
            place = at()
        ),
        // By the number itself: what only its error bar makes amber is among the others, here as of the thinning.
        Light::Amber if is("forming_limit", Light::Amber) && share("forming_limit") > Some(forming_limit::CAREFUL) => {
            joined(["it comes near to tearing".into(), at()], " ")
        }
        Light::Amber if is("thinning", Light::Amber) && share("thinning") > Some(thinning::CAREFUL) => {
            let thins = format!(
                "it thins by {thinning} {place}, more than the {rule} rule of thumb",
                thinning = Amount::share(share("thinning").unwrap_or_default()),
                place = at(),
                rule = Amount::given_share(thinning::CAREFUL)
            );
            let limit = match share("forming_limit") {
                Some(used) => format!("the forming limit is used to {used}", used = Amount::share(used)),
                None => "no forming limit is given".into(),
            };
            joined([thins, limit], "; ")
        }
        Light::Amber => format!("it does not tear; look at {labels}", labels = labels(Light::Amber)),
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
pub(super) fn whether_it_tears(stages: &[StageSolution]) -> String {
    match (tear(stages), stages.last().and_then(torn)) {
        (Some(tear), _) => tear.sentence(stages.len()),
        (None, Some(neck)) => joined(["it thins too far".into(), place(stages, neck.s0)], " "),
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
    fn sentence(&self, stages: usize) -> String {
        let place = self.s0.map_or_else(String::new, |s0| on_part(self.on, s0));
        let stage = if stages > 1 { format!("in stage {n}", n = self.stage + 1) } else { String::new() };
        joined([joined(["it tears".into(), place], " "), stage], ", ")
    }

    /// `after 18.2 of 32.0 mm of travel`
    fn when(&self) -> String {
        let whole = self.on.model.travel;
        self.travel.map_or_else(String::new, |travel| {
            let (reached, all) = (Amount::place(travel), Amount::place(whole));
            format!("after {reached} of {all} of travel")
        })
    }
}
