//! What stands behind a drawing's case that is refused: nobody has seen its file.

use super::draft::Draft;
use crate::case::{self, Case, CaseError};
use crate::model::Role;

impl Draft<'_> {
    /// The case that the text from [`toml`](Self::toml) is; `None` without a punch, which it waits for.
    ///
    /// # Errors
    /// When no die is drawn, or it cannot be solved; the message names the drawing and what of it, or which option, is to be changed.
    pub fn case(&self, text: &str, drawing: &str) -> Result<Option<Case>, CaseError> {
        if !self.has(Role::Die) {
            let what = format!("no die in {drawing}: nothing would draw the sheet over the punch");
            return Err(CaseError::bare(what, "name its layer with --layer NAME=die".to_owned()));
        }
        if !self.has(Role::Punch) {
            return Ok(None);
        }
        case::parse(text, drawing, &[]).map(Some).map_err(|error| {
            let help = [error.remedy().map(str::to_owned), self.place(&error)].into_iter().flatten();
            let what = format!("the case made from {drawing} is refused, and no file is written: {error}");
            CaseError::bare(what, help.chain(self.doubts()).collect::<Vec<_>>().join("; "))
        })
    }

    /// The option or the tool of the drawing that makes the key of an error.
    fn place(&self, error: &CaseError) -> Option<String> {
        let option = match error.key() {
            "tools.punch.travel" => "--travel",
            "blank.thickness" => "--thickness",
            "blank.radius" | "blank.half_length" => "--blank-radius",
            key => {
                let of = |role: Role| key.split('.').take(2).eq(["tools", role.name()]);
                let (_, _, made_of) = self.tools.iter().find(|(role, ..)| of(*role))?;
                return Some(format!("it is drawn in {made_of}, r is x from the axis"));
            }
        };
        Some(format!("set it with {option}"))
    }
}
