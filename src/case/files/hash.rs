//! SHA-256 hashes of texts and files.

use sha2::{Digest, Sha256};

/// SHA-256 of some bytes, one part after the other, in hex digits.
pub fn sha256(parts: impl IntoIterator<Item = impl AsRef<[u8]>>) -> String {
    let hash = parts.into_iter().fold(Sha256::new(), |hash, bytes| hash.chain_update(bytes));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
