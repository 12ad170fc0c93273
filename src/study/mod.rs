//! Studies: one case, run with many settings.
//!
//! ```text
//! Subject       the case, read once; a design is it with overrides
//! Vary          a key and its values: tools.die.shoulder=4..10 mm/7
//! Designs       every design of a study by its index; Plan: every combination of what is varied
//! side_by_side  many runs on all cores, handed on in order
//! run           designs on all cores → rows, in order
//! Row           a design, its numbers and lights, how it ended
//! Columns       its line in study.csv
//! Journal       study.csv on its way; goes on after any end
//! Times         study_times.csv beside it
//! Shard         a part of a study that runs by itself; merge puts them together
//! Results       a study read back from its table; Varied: an axis as a designer names it
//! Zone          a way to fail; Window: where designs are sound, its borders, and how far the case is from them
//! Swing         what a number is moved by, one key at a time
//! Said          what a study found, in sentences
//! Readings      what was measured: columns of a file, or those that a program holds
//! Span          a stretch of a key's values, or of several that move together
//! search        where a condition ends, or a number has a value; the best of several keys
//! file          a study as TOML
//! scatter       designs that are drawn by chance, and what can be said of them
//! fit           laws and keys from measurements
//! versus        several runs, and what was measured, side by side
//! ```

mod bars;
mod deciding;
mod error;
pub mod file;
pub mod fit;
mod hash;
mod journal;
mod plan;
mod readings;
mod region;
mod results;
mod row;
mod run;
mod said;
pub mod scatter;
pub mod search;
mod shards;
mod side_by_side;
mod span;
mod subject;
mod swing;
mod times;
mod varied;
mod vary;
pub mod verify;
pub mod versus;
mod window;
mod zone;

pub use bars::Bars;
pub use error::StudyError;
pub use journal::{Begun, Earlier, Journal, csv};
pub use plan::{Design, Designs, How, Plan};
pub use readings::Readings;
pub use region::{Grid, Point, Region};
pub use results::{Found, Results};
pub use row::{Columns, Judged, Row, Solved};
pub use run::{base, one, run};
pub use said::{Said, designs};
pub use shards::{Shard, merge};
pub use side_by_side::side_by_side;
pub use span::Span;
pub use subject::Subject;
pub use swing::{End, Swing, swings};
pub use times::Times;
pub use varied::Varied;
pub use vary::{Value, Vary};
pub use window::{Distance, Meets, Window, windows};
pub use zone::Zone;
