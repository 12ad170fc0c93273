//! A case that is compared with others.

use crate::case::Case;
use crate::model::{Extent, Geometry};
use crate::study::StudyError;

/// A case that is compared with others.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// What is run.
    pub case: Case,
    /// The overrides that it has besides those of all; none of a case as it stands.
    pub own: Vec<String>,
}

impl Candidate {
    /// The overrides of a variant: `friction=0.12; tools.die.shoulder=5 mm`.
    ///
    /// # Errors
    /// When one of them gives no key a value.
    pub fn overrides(text: &str) -> Result<Vec<String>, StudyError> {
        let all: Vec<String> =
            text.split(';').map(str::trim).filter(|one| !one.is_empty()).map(str::to_owned).collect();
        let is_setting = |one: &String| one.split_once('=').is_some_and(|(k, v)| !k.trim().is_empty() && !v.is_empty());
        match all.iter().all(is_setting) && !all.is_empty() {
            true => Ok(all),
            false => {
                let help = "write KEY=VALUE, several joined by semicolons: \"friction=0.12; tools.die.shoulder=5 mm\"";
                Err(StudyError::new(format!("the variant `{}` gives no key a value", text.trim()), help))
            }
        }
    }

    /// The name of its file, and what it has of its own.
    pub(super) fn spelled(&self) -> String {
        match self.own.is_empty() {
            true => self.case.name.clone(),
            false => format!("{}, {}", self.case.name, self.own.join(", ")),
        }
    }

    /// What its sections stand for.
    pub(super) fn extent(&self) -> Extent {
        self.case.model().extent()
    }

    /// Largest travel of its stages \[mm\]; 0 where no punch moves.
    pub(super) fn travel(&self) -> f64 {
        self.case.stages.iter().map(|stage| stage.model.travel).fold(0.0, f64::max)
    }
}

/// No case is there twice, and the forces of all are of one kind.
pub(super) fn check(candidates: &[Candidate]) -> Result<(), StudyError> {
    for (i, one) in candidates.iter().enumerate() {
        let is_same = |other: &&Candidate| (&other.case.path, &other.case.text) == (&one.case.path, &one.case.text);
        if candidates[..i].iter().any(|other| is_same(&other)) {
            let help = "leave one out, or change something in it with --also";
            return Err(StudyError::new(format!("{} is there twice", one.spelled()), help));
        }
        let first = &candidates[0];
        let kind = |candidate: &Candidate| {
            let extent = candidate.extent();
            let geometry = match extent.geometry() {
                Geometry::Axisymmetric => "axisymmetric",
                Geometry::PlaneStrain => "plane strain",
            };
            format!("{geometry}, its forces are in {}", extent.force_unit().symbol())
        };
        if kind(one) != kind(first) {
            let [a, b] = [first, one].map(|candidate| format!("{} is {}", candidate.spelled(), kind(candidate)));
            let help = "compare sections of one kind; `depth` in [blank] makes forces of a strip those of the part";
            return Err(StudyError::new(format!("they have no force in common: {a}; {b}"), help));
        }
    }
    Ok(())
}
