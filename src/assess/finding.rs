//! The one way in which the program tells a user what to know.

use super::error_bar::ErrorBar;
use crate::table::Unit;
use crate::units::{Amount, joined};
use serde::{Serialize, Serializer};

/// How a finding stands to its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Light {
    /// Not judged: the case does not hold what it would be held against.
    Grey,
    /// Within the limit.
    Green,
    /// Near it, or a guess that matters.
    Amber,
    /// Beyond it.
    Red,
}

impl Light {
    /// The word that stands for it without colours.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grey => "grey",
            Self::Green => "green",
            Self::Amber => "amber",
            Self::Red => "red",
        }
    }

    /// Green up to the first limit, amber up to the second, red beyond.
    pub(super) fn of(value: f64, limits: [f64; 2]) -> Self {
        match value {
            v if v <= limits[0] => Self::Green,
            v if v <= limits[1] => Self::Amber,
            _ => Self::Red,
        }
    }

    /// Green up to a limit, amber beyond.
    pub(super) fn within(value: f64, limit: f64) -> Self {
        Self::of(value, [limit, f64::INFINITY])
    }

    /// Amber where something is in doubt.
    pub(super) fn doubtful(doubtful: bool) -> Self {
        if doubtful { Self::Amber } else { Self::Green }
    }
}

/// When a finding can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum When {
    /// From the case alone.
    Before,
    /// From what came out.
    After,
}

/// Where a finding is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A row of the verdict, whatever its light.
    Judgement,
    /// A sentence among the warnings, made only where something is wrong.
    Warning,
    /// A sentence among the notes: what was assumed or changed while the case was read.
    Assumption,
}

/// Where a number turns amber, and where red.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limits {
    /// On which side of them a number is good.
    pub sense: Sense,
    /// Amber from here on, in the finding's unit.
    pub amber: Option<f64>,
    /// Red from here on, in the finding's unit.
    pub red: Option<f64>,
}

/// On which side of its limits a number is good.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// Not above them.
    AtMost,
    /// Not below them.
    AtLeast,
}

/// Something that a user should know.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Name in JSON: `thinning`.
    pub key: &'static str,
    /// Name in tables: `Thinning`.
    pub label: &'static str,
    /// How it stands to its limit.
    pub light: Light,
    /// The number, in `unit`; `None` where words say it.
    pub value: Option<f64>,
    /// How far the number can be trusted; what was found tells it so.
    #[serde(flatten)]
    pub bar: ErrorBar,
    /// In JSON as at the end of a header: `percent`; empty for plain numbers.
    #[serde(serialize_with = "spelled")]
    pub unit: Unit,
    /// The limits of the number, in `unit`; `None` where words say them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<Limits>,
    /// The number or the words, with the unit, and where.
    pub found: String,
    /// The limit in words, with its unit.
    pub limit: String,
    /// Where the limit comes from; a declared rule of thumb is called so.
    pub source: String,
    /// What to change; empty where all is well.
    pub advice: String,
    /// When it can be made.
    pub when: When,
    /// Where it is told.
    #[serde(skip)]
    pub kind: Kind,
    /// The stage that it is of, counted from 0; `None` of the case or of all stages.
    #[serde(skip)]
    pub stage: Option<usize>,
}

fn spelled<S: Serializer>(unit: &Unit, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(unit.spelled())
}

/// The source of what the solver should keep to.
pub(super) const ACCURACY: &str = "declared accuracy of the solver";
/// What a limit without a source that could be read is called.
const DECLARED: &str = "declared rule of thumb";

impl Finding {
    fn new(kind: Kind, key: &'static str, label: &'static str, light: Light, found: String) -> Self {
        Self {
            key,
            label,
            light,
            value: None,
            bar: ErrorBar::Unasked,
            unit: Unit::None,
            limits: None,
            found,
            limit: String::new(),
            source: DECLARED.into(),
            advice: String::new(),
            when: When::After,
            kind,
            stage: None,
        }
    }

    /// A row of the verdict.
    pub(super) fn judged(key: &'static str, label: &'static str, light: Light, found: impl Into<String>) -> Self {
        Self::new(Kind::Judgement, key, label, light, found.into())
    }

    /// A warning; with [`Self::advice`] its sentence is `found: advice`.
    pub(crate) fn warning(key: &'static str, label: &'static str, found: impl Into<String>) -> Self {
        Self::new(Kind::Warning, key, label, Light::Amber, found.into())
    }

    /// What was assumed while a case was read.
    pub(super) fn assumed(found: impl Into<String>) -> Self {
        let limit = "what the case says".into();
        Self { limit, ..Self::new(Kind::Assumption, "assumed", "Assumed", Light::Grey, found.into()) }
    }

    /// With its number and the limit that it is held against.
    pub(super) fn against(self, value: impl Into<Option<f64>>, unit: Unit, limit: impl Into<String>) -> Self {
        Self { value: value.into(), unit, ..self }.limit(limit)
    }

    /// With a share and its limit, both \[–\], told in percent.
    pub(super) fn share(self, share: f64, limit: f64) -> Self {
        self.against(100.0 * share, Unit::Percent, Amount::given_share(limit)).at_most(100.0 * limit, None)
    }

    /// With the numbers, in its unit, above which it turns amber and red.
    pub(super) fn at_most(self, amber: impl Into<Option<f64>>, red: impl Into<Option<f64>>) -> Self {
        Self { limits: Some(Limits { sense: Sense::AtMost, amber: amber.into(), red: red.into() }), ..self }
    }

    /// With the numbers, in its unit, below which it turns amber and red.
    pub(super) fn at_least(self, amber: impl Into<Option<f64>>, red: impl Into<Option<f64>>) -> Self {
        Self { limits: Some(Limits { sense: Sense::AtLeast, amber: amber.into(), red: red.into() }), ..self }
    }

    /// With its limit, a declared rule of thumb until a source is given.
    pub(super) fn limit(mut self, limit: impl Into<String>) -> Self {
        self.limit = limit.into();
        self
    }

    /// With the source of its limit.
    pub(super) fn source(mut self, source: impl Into<String>) -> Self {
        self.source = source.into();
        self
    }

    /// With what to change, unless all is well.
    pub(super) fn advice(mut self, advice: impl Into<String>) -> Self {
        if self.light != Light::Green {
            self.advice = advice.into();
        }
        self
    }

    /// As one sentence: what was found, and of a warning what to change.
    pub fn sentence(&self) -> String {
        joined([self.found.clone(), self.advice.clone()], ": ")
    }
}

/// The rows of the verdict.
pub fn judgements(findings: &[Finding]) -> impl Iterator<Item = &Finding> {
    findings.iter().filter(|finding| finding.kind == Kind::Judgement)
}

/// The sentences of a kind.
pub fn sentences(findings: &[Finding], kind: Kind) -> Vec<String> {
    findings.iter().filter(|finding| finding.kind == kind).map(Finding::sentence).collect()
}

/// One sentence on the verdict, the worst first: `2 amber (Holder, Friction), 1 not judged (Energy), 14 green`.
pub fn headline(findings: &[Finding]) -> String {
    let of = |light: Light| judgements(findings).filter(move |f| f.light == light);
    let named = |light: Light| (of(light).count(), joined(of(light).map(|f| f.label.into()), ", "));
    let parts =
        [Light::Red, Light::Amber, Light::Grey, Light::Green].into_iter().map(|light| match (light, named(light)) {
            (_, (0, _)) => String::new(),
            (Light::Red, (n, labels)) => format!("{n} red ({labels})"),
            (Light::Amber, (n, labels)) => format!("{n} amber ({labels})"),
            (Light::Grey, (n, labels)) => format!("{n} not judged ({labels})"),
            (Light::Green, (n, _)) => format!("{n} green"),
        });
    joined(parts, ", ")
}

/// The verdict's rows of a light, those with one advice together, where the first of them stands.
pub fn by_advice(findings: &[Finding], is: impl Fn(Light) -> bool) -> Vec<Vec<&Finding>> {
    let mut groups: Vec<Vec<&Finding>> = Vec::new();
    for finding in judgements(findings).filter(|f| is(f.light)) {
        match groups.iter_mut().find(|group| group[0].advice == finding.advice) {
            Some(group) => group.push(finding),
            None => groups.push(vec![finding]),
        }
    }
    groups
}

/// The advice of the verdict's rows of a light, rows of one advice together: their labels, and what to change.
pub fn advice(findings: &[Finding], is: impl Fn(Light) -> bool) -> Vec<(String, &str)> {
    let groups = by_advice(findings, is).into_iter().filter(|group| !group[0].advice.is_empty());
    let labels = |group: &[&Finding]| joined(group.iter().map(|finding| finding.label.into()), ", ");
    groups.map(|group| (labels(&group), group[0].advice.as_str())).collect()
}
