//! What tells inputs apart.

use sha2::{Digest, Sha256};

/// Hex digits of a hash that tell inputs apart.
const DIGITS: usize = 16;

/// SHA-256 of some bytes, as many of its hex digits as tell inputs apart.
pub(super) fn short_hash(all: impl IntoIterator<Item = impl AsRef<[u8]>>) -> String {
    let hash = all.into_iter().fold(Sha256::new(), |hash, bytes| hash.chain_update(bytes));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect::<String>()[..DIGITS].to_owned()
}
