//! Elements side by side as they are strained, and their forces and matrices apart again.

use crate::element::Node;
use crate::element::kinematics::{Current, Reference};
use crate::element::section::{Blocks, Internal};
use crate::numerics::number::{Instructions, LANES, Lanes, beside, values};

/// As many elements as there are lanes, after their nodes have moved; `None` when one has collapsed.
#[inline(always)]
pub fn moved<S: Instructions>(simd: S, references: &[Reference], moves: &[Node]) -> Option<Current<Lanes<S>>> {
    let after = &moves[1..];
    Reference::beside(simd, references).moved(
        [beside!(simd, moves, [0]), beside!(simd, moves, [1]), beside!(simd, moves, [2])],
        [beside!(simd, after, [0]), beside!(simd, after, [1]), beside!(simd, after, [2])],
    )
}

/// One value of each element.
#[inline(always)]
pub fn of<S: Instructions>(simd: S, values: &[f64]) -> Lanes<S> {
    Lanes::new(simd, [values[0], values[1], values[2], values[3]])
}

/// Forces and matrices of the elements, entry by entry.
#[inline(always)]
pub fn apart<S: Instructions>(of: &Internal<Lanes<S>>) -> Internal<[f64; LANES]> {
    Internal {
        force: values(of.force),
        blocks: match of.blocks {
            Some(Blocks { own: [first, second], across }) => {
                Some(Blocks { own: [values(first), values(second)], across: values(across) })
            }
            None => None,
        },
        thickness_row: values(of.thickness_row),
        thickness: of.thickness.values(),
    }
}
