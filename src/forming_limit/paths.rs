//! The way that each element takes through the plane of strains.

/// The mid-surface strains at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// Time \[s\] and punch travel \[mm\].
    pub time: f64,
    pub travel: f64,
    /// Logarithmic membrane strains of every element, from the axis outward: meridional, hoop \[–\].
    pub strains: Vec<[f64; 2]>,
}

/// The strains of a run after every accepted step, the first instant being its start.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paths {
    /// Initial distance of the elements' middles from the axis \[mm\].
    pub s0: Vec<f64>,
    pub instants: Vec<Instant>,
}

impl Paths {
    /// The path of an element: minor and major strain at every instant \[–\].
    ///
    /// The direction that is the major one at the end is the major one throughout, so that a path does not fold over
    /// where the two change places.
    pub fn of(&self, element: usize) -> Vec<[f64; 2]> {
        let hoop_is_major = self.hoop_is_major(element);
        let ordered =
            |[meridional, hoop]: [f64; 2]| if hoop_is_major { [meridional, hoop] } else { [hoop, meridional] };
        self.instants.iter().map(|instant| ordered(instant.strains[element])).collect()
    }

    /// Whether the hoop strain of an element is the larger one in the end.
    pub fn hoop_is_major(&self, element: usize) -> bool {
        self.instants.last().is_some_and(|last| last.strains[element][1] > last.strains[element][0])
    }
}
