//! Where a sample is taken: points of the unit cube, each by its index alone.

use sobol_burley::sample;

/// Independent scramblings that a sample is made of: what its intervals are estimated from. Point i belongs to
/// scrambling i mod 16, so that all are as long wherever a study stops.
pub const REPLICATES: usize = 16;

/// Most points of one scrambling.
const LONGEST: u64 = 1 << 16;

/// Most points of a sample.
pub const MOST: u64 = REPLICATES as u64 * LONGEST;

/// Most coordinates: a point and its partner, of which indices are made, share the dimensions of the sequence.
pub const COORDINATES: usize = 128;

/// Within the sequence's resolution: coordinates lie between 0 and 1, and never on either.
const HALF: f64 = 0.5 / (1u32 << 24) as f64;

/// A quasi-random sample of the unit cube: scrambled Sobol points, with partners where indices are asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampling {
    seed: u32,
    /// Points.
    points: u64,
    /// The group of each coordinate, from 0 without a gap: what is correlated is one.
    groups: Vec<usize>,
    /// Whether each point comes with its partner and what lies between them.
    with_partners: bool,
}

/// What a row of a sample is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A point.
    Point,
    /// Its partner, another point that is independent of it.
    Partner,
    /// The point with the coordinates of one group from its partner.
    Mixed(usize),
}

/// Where a row of a sample stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The scrambling, below [`REPLICATES`].
    pub replicate: usize,
    /// Its point.
    pub point: u64,
    /// What the row is of that point.
    pub part: Part,
}

impl Sampling {
    /// Of so many points, at most [`MOST`], whose coordinates, at most [`COORDINATES`], belong to these groups.
    pub fn new(seed: u32, points: u64, groups: Vec<usize>, with_partners: bool) -> Self {
        Self { seed, points, groups, with_partners }
    }

    /// How many groups there are.
    pub fn groups(&self) -> usize {
        self.groups.iter().max().map_or(0, |last| last + 1)
    }

    /// The group of each coordinate.
    pub fn group_of(&self) -> &[usize] {
        &self.groups
    }

    /// Rows of a point: itself, and where indices are asked for its partner and one a group.
    pub fn width(&self) -> usize {
        if self.with_partners { self.groups() + 2 } else { 1 }
    }

    /// Points.
    pub fn points(&self) -> u64 {
        self.points
    }

    /// Whether indices can be estimated.
    pub fn has_partners(&self) -> bool {
        self.with_partners
    }

    /// Rows of the sample.
    pub fn rows(&self) -> u64 {
        self.points * self.width() as u64
    }

    /// Where a row stands.
    pub fn place(&self, row: u64) -> Place {
        let width = self.width() as u64;
        let (point, k) = (row / width, (row % width) as usize);
        let part = match k {
            0 => Part::Point,
            1 => Part::Partner,
            k => Part::Mixed(k - 2),
        };
        Place { replicate: (point % REPLICATES as u64) as usize, point, part }
    }

    /// The coordinates of a row, each between 0 and 1.
    pub fn unit(&self, row: u64) -> Vec<f64> {
        let Place { replicate, point, part } = self.place(row);
        let seed = mixed((u64::from(self.seed) << 32) | replicate as u64);
        let index = (point / REPLICATES as u64 % LONGEST) as u32;
        let coordinate = |(i, group): (usize, &usize)| {
            let is_partners = part == Part::Partner || part == Part::Mixed(*group);
            let dimension = if is_partners { i + self.groups.len() } else { i };
            f64::from(sample(index, dimension as u32, seed)) + HALF
        };
        self.groups.iter().enumerate().map(coordinate).collect()
    }
}

/// A number that tells nothing of the one that it is made of, so that seeds that follow each other have nothing in common.
///
/// # References
/// G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA (2014) (not read: the constants
/// are those of its public reference implementation).
fn mixed(seed: u64) -> u32 {
    let mut z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 32) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: the definition of the rows.
    #[test]
    fn rows_between_a_point_and_its_partner_have_the_coordinates_of_both() {
        let sampling = Sampling::new(1, 40, vec![0, 1, 0], true);
        assert_eq!((sampling.width(), sampling.rows()), (4, 160));
        for first in (0..160).step_by(4) {
            let [a, b, ab0, ab1] = [0, 1, 2, 3].map(|k| sampling.unit(first + k));
            assert_eq!(ab0, [b[0], a[1], b[2]]);
            assert_eq!(ab1, [a[0], b[1], a[2]]);
            assert!(a.iter().zip(&b).all(|(a, b)| a != b));
            assert!(a.iter().chain(&b).all(|u| *u > 0.0 && *u < 1.0));
        }
    }

    /// Trust: of 2^k points of a scrambled Sobol sequence each of 2^k slices of a coordinate has exactly one.
    #[test]
    fn every_scrambling_fills_each_coordinate_evenly_and_differs_from_the_others() {
        let sampling = Sampling::new(7, 64 * REPLICATES as u64, vec![0, 1], false);
        let mut firsts = Vec::new();
        for replicate in 0..REPLICATES as u64 {
            let own: Vec<Vec<f64>> = (0..64).map(|i| sampling.unit(replicate + i * REPLICATES as u64)).collect();
            for coordinate in 0..2 {
                let mut slices: Vec<usize> = own.iter().map(|u| (64.0 * u[coordinate]) as usize).collect();
                slices.sort_unstable();
                assert_eq!(slices, (0..64).collect::<Vec<_>>());
            }
            firsts.push(own[0].clone());
        }
        assert!((1..firsts.len()).all(|i| !firsts[..i].contains(&firsts[i])));
    }
}
