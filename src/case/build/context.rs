//! What the tools of a stage are read and placed against.

use crate::case::file::{self, Section};
use crate::case::files::Folder;
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::model::{Blank, Extent, Role, Tool};

/// What tools are placed against.
pub(super) struct Sheet {
    pub extent: Extent,
    /// Radius or half-length [mm].
    pub length: f64,
    /// Thickness [mm].
    pub thickness: f64,
}

impl Sheet {
    pub fn of(blank: &Blank, extent: Extent) -> Self {
        Self { extent, length: blank.length, thickness: blank.thickness }
    }
}

/// What tools are made from.
pub(super) struct ToolContext<'a> {
    /// The tools that are new.
    pub written: &'a file::Tools,
    /// The tools that are there from the stage before.
    pub standing: &'a [Tool],
    pub sheet: Sheet,
    /// Punch travel of the whole run [mm].
    pub travel: f64,
    pub source: &'a Source<'a>,
    /// Where profile files are looked up.
    pub folder: Folder<'a>,
    /// The placed section of a tool, new or standing, of which another may be made.
    pub profile: fn(&ToolContext, Role) -> Result<Option<Profile>, CaseError>,
}

impl ToolContext<'_> {
    /// The section that is written for a tool.
    pub fn section(&self, role: Role) -> Option<&Section> {
        match role {
            Role::Punch => self.written.punch.as_ref()?.profile.as_ref(),
            Role::Die => self.written.die.as_ref()?.profile.as_ref(),
            Role::Holder => self.written.holder.as_ref()?.profile.as_ref(),
        }
    }
}
