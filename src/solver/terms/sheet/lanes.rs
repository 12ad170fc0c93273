//! Elements side by side, and their forces and matrices apart again.

use crate::element::kinematics::StrainDisplacement;
use crate::element::section::{Blocks, Internal, Strained};
use crate::numerics::number::{Instructions, LANES, Lanes, beside, values};

/// As many elements as there are lanes, side by side.
#[inline(always)]
pub fn beside<S: Instructions>(simd: S, of: &[Strained]) -> Strained<Lanes<S>> {
    Strained {
        strain: [
            beside!(simd, of, strain[0]),
            beside!(simd, of, strain[1]),
            beside!(simd, of, strain[2]),
            beside!(simd, of, strain[3]),
            beside!(simd, of, strain[4]),
        ],
        rows: StrainDisplacement {
            along: [beside!(simd, of, rows.along[0]), beside!(simd, of, rows.along[1])],
            across: [beside!(simd, of, rows.across[0]), beside!(simd, of, rows.across[1])],
            hoop: beside!(simd, of, rows.hoop),
            bend: beside!(simd, of, rows.bend),
            turn: beside!(simd, of, rows.turn),
            shear: beside!(simd, of, rows.shear),
            swing: beside!(simd, of, rows.swing),
        },
        volume: beside!(simd, of, volume),
        thickness: beside!(simd, of, thickness),
    }
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
