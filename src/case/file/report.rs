//! What stands in the title block of a report.

use serde::Deserialize;

/// The title block of a report: as it is written, and only what is given is shown.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct TitleBlock {
    /// Name of the part.
    #[schemars(example = &"Bearing cup")]
    pub part: Option<String>,
    /// Number of the part or of its drawing.
    #[schemars(example = &"4711-02")]
    pub number: Option<String>,
    /// Revision of the part or of its drawing.
    #[schemars(example = &"C")]
    pub revision: Option<String>,
    /// Who answers for the report.
    #[schemars(example = &"A. Ito")]
    pub author: Option<String>,
    /// For whom the author works.
    #[schemars(example = &"Ito Tools Ltd")]
    pub company: Option<String>,
    /// Day of the report; the program looks at no clock.
    #[schemars(example = &"2026-11-22")]
    pub date: Option<String>,
}

impl TitleBlock {
    /// Names and values of what is given, in the order of a drawing's title block.
    pub fn entries(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let all = [
            ("Part", &self.part),
            ("Number", &self.number),
            ("Revision", &self.revision),
            ("Author", &self.author),
            ("Company", &self.company),
            ("Date", &self.date),
        ];
        all.into_iter().filter_map(|(name, value)| Some((name, value.as_deref()?.trim())).filter(|e| !e.1.is_empty()))
    }

    /// What `other` gives, and the rest of this one.
    pub fn replaced_by(self, other: Self) -> Self {
        Self {
            part: other.part.or(self.part),
            number: other.number.or(self.number),
            revision: other.revision.or(self.revision),
            author: other.author.or(self.author),
            company: other.company.or(self.company),
            date: other.date.or(self.date),
        }
    }
}
