//! What tells inputs apart.

use crate::case::files::sha256;

/// Hex digits of a hash that tell inputs apart.
const DIGITS: usize = 16;

/// SHA-256 of some bytes, as many of its hex digits as tell inputs apart.
pub(super) fn short_hash(all: impl IntoIterator<Item = impl AsRef<[u8]>>) -> String {
    sha256(all)[..DIGITS].to_owned()
}
