//! What is asked of a search, in texts as a user writes them.

use super::{Condition, Draft, Goal, Quest, Side, Target, Template, Wanted};
use crate::study::{Span, StudyError, Subject};

/// What is asked of a search.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Asked {
    /// A key and its span; that of the template where there is none.
    pub vary: Vec<String>,
    /// The name of a [`Template`].
    pub template: Option<String>,
    /// Which end of the span is wanted.
    pub side: Option<Side>,
    /// What a run must keep to.
    pub condition: Option<String>,
    /// A number and the value that it shall have.
    pub target: Option<String>,
    /// How near the limit is to be found, in the unit of the key.
    pub tolerance: Option<String>,
}

impl Asked {
    /// What is searched for in a case, from a template and what is said besides.
    ///
    /// # Errors
    /// When something is missing or makes no sense, or the case has nothing of the kind.
    pub fn quest(&self, subject: Subject) -> Result<Quest, StudyError> {
        let draft = match &self.template {
            Some(name) => Some(Template::named(name)?.draft(&subject.case(&[])?)?),
            None => None,
        };
        let subject = match &draft {
            Some(Draft { settings, .. }) if !settings.is_empty() => subject.after(settings)?,
            _ => subject,
        };
        let vary = match (&self.vary[..], &draft) {
            ([vary], _) => vary,
            ([], Some(draft)) => &draft.vary,
            ([], None) => {
                return Err(StudyError::new("there is nothing to vary", "give --vary \"KEY=FROM..TO UNIT\", or --for"));
            }
            _ => {
                let help = "join keys that move together by &, or give --minimise or --maximise for their best";
                return Err(StudyError::new("several keys are varied", help));
            }
        };
        let mut span = Span::read(vary, &subject)?;
        if let Some(tolerance) = &self.tolerance {
            span = span.within(tolerance)?;
        }
        let goal = self.goal(draft.as_ref().map(|draft| draft.goal))?;
        let side = match (self.side, &draft) {
            (Some(side), _) => side,
            (None, Some(draft)) if draft.is_smallest => Side::Smallest,
            (None, Some(_)) => Side::Largest,
            (None, None) if matches!(goal, Goal::Reach(_)) => Side::Smallest,
            (None, None) => {
                let what = "neither the largest nor the smallest is asked for";
                return Err(StudyError::new(what, "give --largest or --smallest"));
            }
        };
        Ok(Quest { subject, span, goal, side })
    }

    fn goal(&self, wanted: Option<Wanted>) -> Result<Goal, StudyError> {
        match (&self.condition, &self.target, wanted) {
            (Some(_), Some(_), _) => {
                Err(StudyError::new("both a condition and a target are given", "give --while or --target"))
            }
            (Some(condition), ..) => Condition::read(condition).map(Goal::Keep),
            // A template knows the number.
            (_, Some(target), Some(Wanted::Number(number))) if !target.contains('=') => {
                Target::read(&format!("{number}={target}")).map(Goal::Reach)
            }
            (_, Some(target), _) => Target::read(target).map(Goal::Reach),
            (_, _, Some(Wanted::Condition(condition))) => Condition::read(condition).map(Goal::Keep),
            (_, _, Some(Wanted::Number(number))) => {
                let help = format!("give it with --target, such as \"{number}=90 deg\" or \"{number}=8 mm\"");
                Err(StudyError::new(format!("the wanted value of {number} is missing"), help))
            }
            (None, None, None) => Err(StudyError::new(
                "it is not said what a run must keep to",
                "give --while \"no red\", or --target \"NUMBER=VALUE\"",
            )),
        }
    }
}
