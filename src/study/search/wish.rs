//! What the best of several keys is looked for by.

use super::{Best, Condition, Keep, Named, Sense, optimise};
use crate::study::verify::Watch;
use crate::study::{Span, StudyError, Subject};

/// Keys that a best is looked for over, at most: each more than doubles the runs of the grid.
const KEYS: usize = 6;

/// The least or the most of a number over several keys.
#[derive(Clone, Debug)]
pub struct Wish {
    /// The case.
    pub subject: Subject,
    /// What is varied.
    pub spans: Vec<Span>,
    /// What is to be best.
    pub number: Named,
    /// Its least or its most.
    pub sense: Sense,
    /// What a run must keep to.
    pub condition: Option<Condition>,
}

impl Wish {
    /// Of texts as a user writes them: keys with their spans, the number, the condition.
    ///
    /// # Errors
    /// When one of them makes no sense, or there is none or too many keys.
    pub fn read(
        subject: Subject,
        vary: &[String],
        (number, sense): (&str, Sense),
        condition: Option<&str>,
    ) -> Result<Self, StudyError> {
        let number = Named::read(number)
            .ok_or_else(|| StudyError::new("no number is named to be best", "give one, such as punch_force"))?;
        let spans = vary.iter().map(|vary| Span::read(vary, &subject)).collect::<Result<Vec<_>, _>>()?;
        if !(1..=KEYS).contains(&spans.len()) {
            let what = format!("a best is looked for over 1 to {KEYS} keys");
            return Err(StudyError::new(what, "give each with --vary"));
        }
        let condition = condition.map(Condition::read).transpose()?;
        Ok(Self { subject, spans, number, sense, condition })
    }

    /// Looks for it, runs side by side on so many threads.
    ///
    /// # Errors
    /// As [`optimise`].
    pub fn search(&self, threads: usize, watch: &dyn Watch) -> Result<Best, StudyError> {
        self.search_keeping(threads, watch, &mut |_, _| {})
    }

    /// The same with someone who keeps the runs as they come.
    ///
    /// # Errors
    /// As [`search`](Self::search).
    pub fn search_keeping(&self, threads: usize, watch: &dyn Watch, keep: Keep) -> Result<Best, StudyError> {
        let Self { subject, spans, number, sense, condition } = self;
        optimise(subject, spans, (number, *sense), condition.as_ref(), threads, (watch, keep))
    }
}
