//! Findings: the one form of warnings, assumptions and rows of the verdict.

use crate::units::{Amount, ErrorBar, Limits, Quantity, Sense, joined};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// State of a finding against its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Light {
    /// Not judged: the case gives no limit.
    Grey,
    /// Within the limit.
    Green,
    /// Near it, or a guess that matters.
    Amber,
    /// Beyond it.
    Red,
}

impl Light {
    /// Name in text.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grey => "grey",
            Self::Green => "green",
            Self::Amber => "amber",
            Self::Red => "red",
        }
    }
}

/// Earliest time of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum When {
    /// From the case alone.
    Before,
    /// From the result.
    After,
}

/// Place of a finding in the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Row of the verdict.
    Judgement,
    /// Sentence among the warnings.
    Warning,
    /// Sentence among the notes: assumed or changed while the case was read.
    Assumption,
}

/// Row of the verdict, warning, or assumption.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Name in JSON: `thinning`.
    pub key: &'static str,
    /// Name in tables: `Thinning`.
    pub label: &'static str,
    /// State against the limit.
    pub light: Light,
    /// Number that is judged, if any.
    pub quantity: Option<Quantity>,
    /// Sentence, with `{}` in place of the number.
    pub text: String,
    /// Limit in words, with its unit.
    pub limit: String,
    /// Source of the limit.
    pub source: String,
    /// Change to make; empty for green findings.
    pub advice: String,
    /// Earliest time at which it is known.
    pub when: When,
    /// Place in the output.
    pub kind: Kind,
    /// Stage, counted from 0; `None` for the case or all stages.
    pub stage: Option<usize>,
}

impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("key", self.key)?;
        map.serialize_entry("label", self.label)?;
        map.serialize_entry("light", &self.light)?;
        map.serialize_entry("value", &self.value())?;
        if let Some(quantity) = &self.quantity {
            quantity.error.write(&mut map)?;
        }
        map.serialize_entry("unit", self.quantity.as_ref().map_or("", |quantity| quantity.amount.unit.spelled()))?;
        if let Some(limits) = self.limits() {
            map.serialize_entry("limits", &limits)?;
        }
        map.serialize_entry("found", &self.statement())?;
        map.serialize_entry("limit", &self.limit)?;
        map.serialize_entry("source", &self.source)?;
        map.serialize_entry("advice", &self.advice)?;
        map.serialize_entry("when", &self.when)?;
        map.end()
    }
}

/// Source of limits without a citation.
const DECLARED: &str = "declared rule of thumb";
/// Position of the number in [`Finding::text`].
const PLACEHOLDER: &str = "{}";

impl Finding {
    fn new(kind: Kind, key: &'static str, label: &'static str, light: Light, text: String) -> Self {
        Self {
            key,
            label,
            light,
            quantity: None,
            text,
            limit: String::new(),
            source: DECLARED.into(),
            advice: String::new(),
            when: When::After,
            kind,
            stage: None,
        }
    }

    /// Row of the verdict; green until a limit or [`Self::light`] says otherwise.
    pub(super) fn judged(key: &'static str, label: &'static str, text: impl Into<String>) -> Self {
        Self::new(Kind::Judgement, key, label, Light::Green, text.into())
    }

    /// Warning; its sentence is `text: advice`.
    pub(crate) fn warning(key: &'static str, label: &'static str, text: impl Into<String>) -> Self {
        Self::new(Kind::Warning, key, label, Light::Amber, text.into())
    }

    pub(super) fn assumed(text: impl Into<String>) -> Self {
        Self::new(Kind::Assumption, "assumed", "Assumed", Light::Grey, text.into()).limit("what the case says")
    }

    /// Sets the light that no limit gives.
    pub(super) fn light(self, light: Light) -> Self {
        Self { light, ..self }
    }

    /// Sets the number, which takes the place of `{}` in the text.
    pub(super) fn number(self, amount: Amount) -> Self {
        Self { quantity: Some(Quantity::new(self.key, self.label, amount)), ..self }
    }

    /// Sets a share and its amber limit \[–\].
    pub(super) fn share(self, share: f64, limit: f64) -> Self {
        self.number(Amount::share(share)).at_most(Amount::given_share(limit), 100.0 * limit, None)
    }

    /// Sets the limit in words, and the upper limits for amber and red in the unit of the number.
    pub(super) fn at_most(self, limit: impl Into<String>, amber: f64, red: impl Into<Option<f64>>) -> Self {
        self.limited(limit.into(), Limits { sense: Sense::AtMost, amber: Some(amber), red: red.into() })
    }

    /// Sets the limit in words, and the lower limits for amber and red in the unit of the number.
    pub(super) fn at_least(self, limit: impl Into<String>, amber: f64, red: impl Into<Option<f64>>) -> Self {
        self.limited(limit.into(), Limits { sense: Sense::AtLeast, amber: Some(amber), red: red.into() })
    }

    fn limited(mut self, limit: String, limits: Limits) -> Self {
        let Some(quantity) = &mut self.quantity else { return self.limit(limit) };
        let value = quantity.amount.value;
        // Also what is not a number is beyond a limit.
        let is_kept = |limit: f64| if limits.sense == Sense::AtMost { value <= limit } else { value >= limit };
        quantity.limits = Some(limits);
        self.light = match limits {
            Limits { amber: Some(amber), .. } if is_kept(amber) => Light::Green,
            Limits { red: Some(red), .. } if !is_kept(red) => Light::Red,
            _ => Light::Amber,
        };
        self.limit(limit)
    }

    /// Drops a warning whose number keeps its limit.
    pub(super) fn if_beyond(self) -> Option<Self> {
        (self.light > Light::Green).then_some(self)
    }

    pub(super) fn limit(self, limit: impl Into<String>) -> Self {
        Self { limit: limit.into(), ..self }
    }

    pub(super) fn source(self, source: impl Into<String>) -> Self {
        Self { source: source.into(), ..self }
    }

    /// Sets the change to make, unless the finding is green.
    pub(super) fn advice(mut self, advice: impl Into<String>) -> Self {
        if self.light != Light::Green {
            self.advice = advice.into();
        }
        self
    }

    /// Sentence with the number, and its error bar if there is one.
    pub fn statement(&self) -> String {
        match &self.quantity {
            Some(number) if self.text.contains(PLACEHOLDER) => {
                self.text.replacen(PLACEHOLDER, &number.amount.to_string(), 1)
            }
            Some(number) if number.error != ErrorBar::NotComputed && number.amount.bar.is_some() => {
                format!("{} ({})", self.text, number.amount)
            }
            _ => self.text.clone(),
        }
    }

    /// Number that is judged, in its unit.
    pub fn value(&self) -> Option<f64> {
        self.quantity.as_ref().map(|quantity| quantity.amount.value)
    }

    /// Limits of the number.
    pub fn limits(&self) -> Option<Limits> {
        self.quantity.as_ref()?.limits
    }

    /// Sentence, and for a warning the change to make.
    pub fn sentence(&self) -> String {
        joined([self.statement(), self.advice.clone()], ": ")
    }
}

/// Rows of the verdict.
pub fn judgements(findings: &[Finding]) -> impl Iterator<Item = &Finding> {
    findings.iter().filter(|finding| finding.kind == Kind::Judgement)
}

/// Sentences of a kind.
pub fn sentences(findings: &[Finding], kind: Kind) -> Vec<String> {
    findings.iter().filter(|finding| finding.kind == kind).map(Finding::sentence).collect()
}

/// Counts of the verdict, the worst first: `2 amber (Holder, Friction), 1 not judged (Energy), 14 green`.
pub fn headline(findings: &[Finding]) -> String {
    let part = |light: Light| {
        let labels: Vec<&str> = judgements(findings).filter(|f| f.light == light).map(|f| f.label).collect();
        match (light, labels.len()) {
            (_, 0) => String::new(),
            (Light::Green, n) => format!("{n} green"),
            (Light::Grey, n) => format!("{n} not judged ({})", labels.join(", ")),
            (_, n) => format!("{n} {} ({})", light.name(), labels.join(", ")),
        }
    };
    joined([Light::Red, Light::Amber, Light::Grey, Light::Green].map(part), ", ")
}

/// Rows of the verdict of a light, grouped by advice.
pub fn by_advice(findings: &[Finding], light: Light) -> Vec<Vec<&Finding>> {
    let mut groups: Vec<Vec<&Finding>> = Vec::new();
    for finding in judgements(findings).filter(|finding| finding.light == light) {
        match groups.iter_mut().find(|group| group[0].advice == finding.advice) {
            Some(group) => group.push(finding),
            None => groups.push(vec![finding]),
        }
    }
    groups
}
