//! Findings: the one form of warnings, assumptions and rows of the verdict.

use super::*;

named! {
    /// State of a finding against its limit.
    #[derive(PartialOrd, Ord, Serialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Light;
    /// Name in text.
    fn name;
    Grey: "grey", "Not judged: the case gives no limit.";
    Green: "green", "Within the limit.";
    Amber: "amber", "Near it, or a guess that matters.";
    Red: "red", "Beyond it.";
}

/// Earliest time of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
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

const PLACEHOLDER: &str = "{}";

impl Finding {
    fn new(kind: Kind, light: Light, key: &'static str, label: &'static str, text: impl Into<String>) -> Self {
        let (text, source) = (text.into(), "declared rule of thumb".into());
        let (quantity, limit, advice) = Default::default();
        Self { key, label, light, quantity, text, limit, source, advice, when: When::After, kind, stage: None }
    }

    pub(super) fn judged(key: &'static str, label: &'static str, text: impl Into<String>) -> Self {
        Self::new(Kind::Judgement, Light::Green, key, label, text)
    }

    pub(crate) fn warning(key: &'static str, label: &'static str, text: impl Into<String>) -> Self {
        Self::new(Kind::Warning, Light::Amber, key, label, text)
    }

    pub(super) fn assumed(text: impl Into<String>) -> Self {
        Self::new(Kind::Assumption, Light::Grey, "assumed", "Assumed", text).limit("what the case says")
    }

    pub(super) fn light(self, light: Light) -> Self {
        Self { light, ..self }
    }

    pub(super) fn number(self, amount: Amount) -> Self {
        Self { quantity: Some(Quantity::new(self.key, self.label, amount)), ..self }
    }

    pub(super) fn at_most(self, amber: f64, red: impl Into<Option<f64>>) -> Self {
        self.limited(Sense::AtMost, amber, red.into())
    }

    pub(super) fn at_least(self, amber: f64, red: impl Into<Option<f64>>) -> Self {
        self.limited(Sense::AtLeast, amber, red.into())
    }

    fn limited(mut self, sense: Sense, amber: f64, red: Option<f64>) -> Self {
        let Some(quantity) = &mut self.quantity else { return self };
        quantity.limits = Some(Limits { sense, amber: Some(amber), red });
        let (amount, is_upper) = (quantity.amount, sense == Sense::AtMost);
        let text = |limit: f64| amount.with_value(limit).to(Digits::Given(2));
        let [most, beyond] = if is_upper { ["at most", "red above"] } else { ["at least", "red below"] };
        let red_text = red.filter(|r| *r != amber).map_or_else(String::new, |red| format!("{beyond} {}", text(red)));
        // Also what is not a number is beyond a limit.
        let is_kept = |limit: f64| if is_upper { amount.value <= limit } else { amount.value >= limit };
        self.light = match red {
            _ if is_kept(amber) => Light::Green,
            Some(red) if !is_kept(red) => Light::Red,
            _ => Light::Amber,
        };
        self.limit(joined([format!("{} {most}", text(amber)), red_text], ", "))
    }

    /// Green without limits of its number.
    pub(super) fn passed(mut self, limit: &str) -> Self {
        self.quantity.iter_mut().for_each(|number| number.limits = None);
        self.light(Light::Green).limit(limit)
    }

    pub(super) fn if_beyond(self) -> Option<Self> {
        (self.light > Light::Green).then_some(self)
    }

    pub(super) fn limit(self, limit: impl Into<String>) -> Self {
        Self { limit: limit.into(), ..self }
    }

    pub(super) fn source(self, source: impl Into<String>) -> Self {
        Self { source: source.into(), ..self }
    }

    pub(super) fn advice(self, advice: impl Into<String>) -> Self {
        if self.light == Light::Green { self } else { Self { advice: advice.into(), ..self } }
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

    /// Label, first clause, and limit of a green row.
    pub fn brief(&self) -> [String; 3] {
        let limit = first_clause(&self.limit).split(", red").next().unwrap_or_default();
        [self.label.into(), first_clause(&self.statement()).into(), limit.into()]
    }

    /// Limit with its source; of a grey row what to give.
    pub fn sourced_limit(&self) -> String {
        let is_open = self.light == Light::Grey && !self.advice.is_empty();
        if is_open { self.advice.clone() } else { format!("{} ({})", self.limit, self.source) }
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

/// First clause of a text, up to a semicolon.
pub fn first_clause(text: &str) -> &str {
    text.split("; ").next().unwrap_or(text)
}

/// Rows of the verdict.
pub fn judgements(findings: &[Finding]) -> impl Iterator<Item = &Finding> {
    findings.iter().filter(|finding| finding.kind == Kind::Judgement)
}

pub(super) fn labels(findings: &[Finding], light: Light) -> Vec<&'static str> {
    judgements(findings).filter(|finding| finding.light == light).map(|finding| finding.label).collect()
}

/// Sentences of a kind.
pub fn sentences(findings: &[Finding], kind: Kind) -> Vec<String> {
    findings.iter().filter(|finding| finding.kind == kind).map(Finding::sentence).collect()
}

/// Counts of the verdict, the worst first: `2 amber (Holder, Friction), 1 not judged (Energy), 14 green`.
pub fn headline(findings: &[Finding]) -> String {
    let part = |light: Light| {
        let labels = labels(findings, light);
        match (light, labels.len()) {
            (_, 0) => String::new(),
            (Light::Green, n) => format!("{n} green"),
            (Light::Grey, n) => format!("{n} not judged ({})", labels.join(", ")),
            (_, n) => format!("{n} {} ({})", light.name(), labels.join(", ")),
        }
    };
    joined([Light::Red, Light::Amber, Light::Grey, Light::Green].map(part), ", ")
}

/// Rows that are not judged, with the key to give: `Press force, Energy ([press]), Hardening law (fitted_up_to)`.
pub fn unchecked(findings: &[Finding]) -> String {
    let group = |group: Vec<&Finding>| {
        let labels = joined(group.iter().map(|finding| finding.label), ", ");
        let key = group[0].advice.split('`').nth(1);
        key.map_or(labels.clone(), |key| format!("{labels} ({key})"))
    };
    joined(by_advice(findings, Light::Grey).into_iter().map(group), ", ")
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
