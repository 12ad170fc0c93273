//! Strain path of each element.

/// The mid-surface strains at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// Time \[s\].
    pub time: f64,
    /// Punch travel \[mm\].
    pub travel: f64,
    /// Logarithmic membrane strains of every element, from the axis outward: meridional without ironing, hoop \[–\].
    pub strains: Vec<[f64; 2]>,
}

/// The strains of a run, the first instant being its start and the last one its end.
///
/// At most [`Paths::MOST`] instants are kept: beyond as many steps every second one, every fourth, and so on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paths {
    /// Initial distance of the elements' middles from the axis \[mm\].
    pub s0: Vec<f64>,
    /// Initial distance from the axis \[mm\] up to which a sheet is the edge of its hole, and whether that has a limit.
    pub edge: (f64, bool),
    /// The kept instants, rising in time.
    pub instants: Vec<Instant>,
    /// Number of halvings of [`Self::stride`], and of instants so far.
    halvings: u32,
    given: usize,
}

impl Paths {
    /// Instants that are held at most; 16 bytes each for an element.
    pub const MOST: usize = 2000;

    /// Paths without an instant, of elements at these initial distances from the axis \[mm\].
    pub fn starting(s0: Vec<f64>) -> Self {
        Self { s0, ..Self::default() }
    }

    /// Adds the instant after a step: it is the end until another one follows.
    pub fn record(&mut self, instant: Instant) {
        if self.given > 0 && !(self.given - 1).is_multiple_of(self.stride()) {
            self.instants.pop();
        }
        if self.instants.len() == Self::MOST {
            self.halvings += 1;
            let mut number = 0..;
            self.instants.retain(|_| number.next().is_some_and(|i| i % 2 == 0));
        }
        self.instants.push(instant);
        self.given += 1;
    }

    /// Drops all but the first `count` instants that were recorded, of which `last` is the end.
    pub fn truncate(&mut self, count: usize, last: Instant) {
        if !self.s0.is_empty() && count < self.given {
            self.instants.truncate((count - 1).div_ceil(self.stride()));
            self.instants.push(last);
            self.given = count;
        }
    }

    /// Every how many steps an instant is kept; the last one always is.
    pub fn stride(&self) -> usize {
        1 << self.halvings
    }

    /// Paths with instants of even distances, at most so many apart from the last one.
    pub fn thinned(&self, most: usize) -> Self {
        let (every, end) = (self.instants.len().div_ceil(most).max(1), self.instants.len().saturating_sub(1));
        let (mut thinned, mut number) = (self.clone(), 0..);
        thinned.instants.retain(|_| number.next().is_some_and(|i| i % every == 0 || i == end));
        thinned
    }

    /// The path of an element: minor and major strain at every instant, with the major direction of the end \[–\].
    pub fn of(&self, element: usize) -> Vec<[f64; 2]> {
        let hoop_is_major = self.hoop_is_major(element);
        let sorted = |[meridional, hoop]: [f64; 2]| if hoop_is_major { [meridional, hoop] } else { [hoop, meridional] };
        self.instants.iter().map(|instant| sorted(instant.strains[element])).collect()
    }

    /// Whether the hoop strain of an element is the larger one in the end.
    pub fn hoop_is_major(&self, element: usize) -> bool {
        self.instants.last().is_some_and(|last| last.strains[element][1] > last.strains[element][0])
    }

    /// Whether an element is judged as the edge of a hole: within a thickness, over which the shell smears the force of a punch
    /// on the edge; where the edge has a limit, wherever the hoop strain is the only stretch, as in the test of that limit.
    pub fn is_of_edge(&self, element: usize) -> bool {
        let is_flange = |last: &Instant| last.strains[element][0] < 0.0 && self.hoop_is_major(element);
        self.s0[element] < self.edge.0 || (self.edge.1 && self.instants.last().is_some_and(is_flange))
    }
}
