//! Solution with everything that its outputs are made from.

use super::comparison::{CompareError, Comparison};
use super::error_bars::ErrorBars;
use super::{Pictures, StageView};
use crate::assess::{Answer, Finding, judgements};
use crate::case::Solution;
use serde_json::Value;

/// Solution with its views, comparisons and error bars.
#[derive(Clone, Debug)]
pub struct Results<'a> {
    /// The solved case.
    pub solution: &'a Solution,
    /// Views of the stages that were run.
    pub views: Vec<StageView<'a>>,
    /// References of the case beside the computed curves.
    pub comparisons: Vec<Comparison>,
    /// Error bars of a verified case.
    pub bars: Option<&'a ErrorBars>,
}

impl<'a> Results<'a> {
    /// Prepares the outputs of a solution.
    ///
    /// # Errors
    /// If a reference of the case cannot be read or does not fit.
    pub fn of(solution: &'a Solution) -> Result<Self, CompareError> {
        Ok(Self { solution, views: solution.views(), comparisons: solution.comparisons()?, bars: None })
    }

    /// Adds error bars.
    pub fn verified(mut self, bars: Option<&'a ErrorBars>) -> Self {
        bars.into_iter().for_each(|bars| bars.draw(&mut self.views, &self.solution.stages));
        Self { bars, ..self }
    }

    /// Adds the verdict on the whole case to the summary of every stage.
    pub fn answered(mut self, answer: &Answer, findings: &[Finding]) -> Self {
        let verdict = verdict(answer, findings, self.bars).ok();
        self.views.iter_mut().for_each(|view| view.verdict.clone_from(&verdict));
        self
    }

    /// Sets the formats and captions of pictures.
    pub fn with_pictures(mut self, pictures: &Pictures) -> Self {
        self.views.iter_mut().for_each(|view| view.pictures = pictures.clone());
        self
    }
}

/// Verdict as JSON: light, sentence, key numbers, findings, and the error bars' origin.
///
/// # Errors
/// Never: all of it has a form in JSON.
pub fn verdict(answer: &Answer, findings: &[Finding], bars: Option<&ErrorBars>) -> serde_json::Result<Value> {
    let mut value = serde_json::to_value(answer)?;
    value["findings"] = judgements(findings).map(serde_json::to_value).collect::<Result<_, _>>()?;
    if let Some(bars) = bars {
        value["error_bars"] = serde_json::to_value(bars)?;
    }
    Ok(value)
}
