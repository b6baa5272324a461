//! The hash by which scenes and mesh files are known again.

use sha2::{Digest, Sha256};

/// SHA-256 of bytes or of a text in lower-case hexadecimal.
pub fn sha256(bytes: impl AsRef<[u8]>) -> String {
    Sha256::digest(bytes.as_ref()).iter().map(|byte| format!("{byte:02x}")).collect()
}
