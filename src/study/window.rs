//! Process windows: which designs over two axes are sound, where the borders run, and how far from them the case stands.
//!
//! A border lies between two designs of which one fails: where the number that makes it fail passes its limit on the way
//! between them, and of several the last; where it is no number that fails, a neck for example, half-way. On the way the
//! number, or its inverse where a third design in line is nearer to that, changes evenly: Siebel's index goes with the
//! inverse of the holder's force. Along an axis whose values stand in even ratios all this goes by their logarithms,
//! and those of the number take the place of its inverse: a power of the key is a straight line so.

use super::region::{Grid, Point, Region};
use super::results::{Found, Results};
use super::varied::Varied;
use super::zone::Zone;
use crate::units::Sense;
use std::cell::Cell;
use std::collections::BTreeMap;

/// Half the width of a name's band along an axis of names, whose neighbours stand 1 apart \[–\].
const HALF: f64 = 0.45;

/// The designs of two axes, at one value of a third where there is one.
#[derive(Debug)]
pub struct Window<'a> {
    results: &'a Results<'a>,
    /// Places of its axes in [`Results::axes`]; a study of one axis has no second.
    pub x: usize,
    /// See `x`.
    pub y: Option<usize>,
    /// The third axis, and the place of its value.
    pub at: Option<(usize, usize)>,
    bands: Vec<Band>,
}

/// Designs between which numbers change evenly: all of a window, or those of one name.
#[derive(Debug)]
struct Band {
    grid: Grid,
    /// Of each point its row.
    rows: Vec<usize>,
}

/// Where the case stands, the designs about it, and where they fail.
struct About<'a> {
    own: Point,
    grid: &'a Grid,
    zones: Vec<(Zone, Region)>,
}

/// How far it is from where the case stands to a border, along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// Place of the axis in [`Results::axes`].
    pub axis: usize,
    /// Where the case stands, in the axis's unit.
    pub from: f64,
    /// Where the border is, or where the window ends.
    pub to: f64,
    /// What is there.
    pub meets: Meets,
}

/// What is met on the way from where the case stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meets {
    /// A way to fail.
    Failure(Zone),
    /// Sound designs, from one that fails.
    Sound,
    /// The end of the window.
    End,
}

/// The windows of a study of one, two or three axes of several values; none of another.
pub fn windows<'a>(results: &'a Results<'a>) -> Vec<Window<'a>> {
    let axes = &results.axes;
    let has_names = |axis: usize| axes[axis].has_names();
    // Names go up the picture, where there is room for them.
    let upright = |[a, b]: [usize; 2]| if has_names(a) && !has_names(b) { (b, a) } else { (a, b) };
    match results.wide()[..] {
        [x] => vec![Window::new(results, x, None, None)],
        [a, b] => {
            let (x, y) = upright([a, b]);
            vec![Window::new(results, x, Some(y), None)]
        }
        [a, b, c] => {
            let third = [c, b, a].into_iter().find(|&axis| has_names(axis)).unwrap_or(c);
            let rest: Vec<usize> = [a, b, c].into_iter().filter(|&axis| axis != third).collect();
            let (x, y) = upright([rest[0], rest[1]]);
            let at = |place| Window::new(results, x, Some(y), Some((third, place)));
            rising(&axes[third]).into_iter().map(at).collect()
        }
        _ => Vec::new(),
    }
}

/// The places of an axis's values in rising order.
fn rising(axis: &Varied) -> Vec<usize> {
    let mut places: Vec<usize> = (0..axis.values.len()).collect();
    places.sort_by(|&a, &b| axis.values[a].total_cmp(&axis.values[b]));
    places
}

impl<'a> Window<'a> {
    fn new(results: &'a Results<'a>, x: usize, y: Option<usize>, at: Option<(usize, usize)>) -> Self {
        // An axis that is not there has one value.
        let ranges = |axis: Option<usize>| -> Vec<(Vec<f64>, Vec<usize>)> {
            let Some(axis) = axis else { return vec![(vec![-HALF, HALF], vec![0, 0])] };
            let places = rising(&results.axes[axis]);
            let values: Vec<f64> =
                results.axes[axis].values.iter().map(|v| results.axes[axis].spacing.place(*v)).collect();
            match results.axes[axis].has_names() {
                true => places.iter().map(|&i| (vec![values[i] - HALF, values[i] + HALF], vec![i, i])).collect(),
                false => vec![(places.iter().map(|&i| values[i]).collect(), places)],
            }
        };
        let counts: Vec<usize> = results.axes.iter().map(|axis| axis.values.len()).collect();
        let row = |i: usize, j: usize| {
            let place = |axis: usize| match axis {
                axis if axis == x => i,
                axis if Some(axis) == y => j,
                axis => at.filter(|(third, _)| *third == axis).map_or(0, |(_, place)| place),
            };
            (0..counts.len()).fold(0, |row, axis| row * counts[axis] + place(axis))
        };
        let mut bands = Vec::new();
        for (up, js) in ranges(y) {
            for (along, is) in ranges(Some(x)) {
                let rows = js.iter().flat_map(|&j| is.iter().map(move |&i| (i, j))).map(|(i, j)| row(i, j)).collect();
                bands.push(Band { grid: Grid { x: along, y: up.clone() }, rows });
            }
        }
        Self { results, x, y, at, bands }
    }

    /// Its range along x and along y, in [places](crate::table::Spacing::place) of the axes, as all its points are.
    pub fn ranges(&self) -> [(f64, f64); 2] {
        let ends = |values: fn(&Grid) -> &Vec<f64>| {
            let all = || self.bands.iter().flat_map(move |band| values(&band.grid).iter().copied());
            (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
        };
        [ends(|grid| &grid.x), ends(|grid| &grid.y)]
    }

    /// Every design with its place.
    pub fn points(&self) -> impl Iterator<Item = (Point, &'a Found)> + '_ {
        self.bands.iter().flat_map(move |band| {
            band.rows.iter().enumerate().map(move |(i, &row)| (band.grid.at(i), &self.results.rows[row]))
        })
    }

    /// Where designs fail in one way; and whether each place of the border was found by a number and its limit.
    pub fn zone(&self, zone: Zone) -> (Vec<Region>, bool) {
        let by_numbers = Cell::new(true);
        let regions = self.bands.iter().map(|band| {
            let found = |point: usize| &self.results.rows[band.rows[point]];
            band.grid.region(
                |point| Some(found(point).fails.contains(&zone)),
                |a, b| {
                    let (share, by_number) = self.border(band, zone, [a, b]);
                    by_numbers.set(by_numbers.get() && by_number);
                    share
                },
            )
        });
        (regions.collect(), by_numbers.get())
    }

    /// Where between two neighbours in a band the border of a zone is, and whether that is by a number.
    fn border(&self, band: &Band, zone: Zone, [a, b]: [usize; 2]) -> (f64, bool) {
        let found = |point: usize| &self.results.rows[band.rows[point]];
        let third = band.grid.third(a, b, found(a).fails.contains(&zone));
        let is_upright = band.grid.at(a).0 == band.grid.at(b).0;
        let axis = self.y.filter(|_| is_upright).unwrap_or(self.x);
        let curved = if self.results.axes[axis].spacing.is_logarithmic() { f64::ln } else { f64::recip };
        self.results.border(zone, [found(a), found(b)], third.map(|(point, at)| (found(point), at)), curved)
    }

    /// Lines along which a number has a value, between designs that `is_counted`.
    pub fn isolines(&self, place: usize, level: f64, is_counted: impl Fn(&Found) -> bool) -> Vec<Vec<Point>> {
        let lines = self.bands.iter().flat_map(|band| {
            let number = |point: usize| self.results.rows[band.rows[point]].numbers[place];
            let counted = |point: usize| is_counted(&self.results.rows[band.rows[point]]);
            let is_above = |point: usize| (number(point).is_finite() && counted(point)).then(|| number(point) >= level);
            band.grid.region(is_above, |a, b| (level - number(a)) / (number(b) - number(a))).borders
        });
        lines.collect()
    }

    /// Where the case stands, where that is inside of the window.
    pub fn own(&self) -> Option<Point> {
        let axes = &self.results.axes;
        let own = |axis: usize| axes[axis].own.map(|own| axes[axis].spacing.place(own));
        let own = (own(self.x)?, self.y.map_or(Some(0.0), own)?);
        let [x, y] = self.ranges();
        let is_inside = |v: f64, (low, high): (f64, f64)| (low..=high).contains(&v);
        let is_at = (0..axes.len()).filter(|axis| *axis != self.x && Some(*axis) != self.y).all(|axis| {
            let place = self.at.filter(|(third, _)| *third == axis).map_or(0, |(_, place)| place);
            let value = axes[axis].values[place];
            axes[axis].own.is_some_and(|own| (own - value).abs() <= 1e-9 * value.abs())
        });
        (is_at && is_inside(own.0, x) && is_inside(own.1, y)).then_some(own)
    }

    /// Where the case stands, among the designs about it, and the zones there.
    fn about(&self) -> Option<About<'_>> {
        let own = self.own()?;
        let is_within = |values: &[f64], v: f64| values[0] <= v && v <= values[values.len() - 1];
        let is_in = |band: &Band| is_within(&band.grid.x, own.0) && is_within(&band.grid.y, own.1);
        let band = self.bands.iter().position(is_in)?;
        let zones = Zone::ALL.into_iter().map(|zone| (zone, self.zone(zone).0.swap_remove(band)));
        Some(About { own, grid: &self.bands[band].grid, zones: zones.collect() })
    }

    /// Whether the designs stand too far apart about the case: what its own run says is not what they say of its place.
    pub fn is_coarse(&self) -> bool {
        self.about().is_some_and(|About { own, zones, .. }| {
            zones.iter().any(|(zone, region)| region.contains(own) != self.results.base.fails.contains(zone))
        })
    }

    /// How far it is from where the case stands to the nearest border each way along each axis of numbers; nothing where
    /// the window [is coarse](Self::is_coarse) there.
    pub fn distances(&self) -> Vec<Distance> {
        let Some(About { own, grid, zones }) = self.about().filter(|_| !self.is_coarse()) else { return Vec::new() };
        let axes = [(Some(self.x), own, &grid.x, &grid.y, false), (self.y, (own.1, own.0), &grid.y, &grid.x, true)];
        let mut distances = Vec::new();
        for (axis, (from, across), along, beside, is_turned) in axes {
            let Some(axis) = axis.filter(|axis| !self.results.axes[*axis].has_names()) else { continue };
            let is_top = across == beside[beside.len() - 1];
            let mut borders: Vec<(f64, Zone)> = Vec::new();
            for (zone, region) in &zones {
                let turned;
                let region = if is_turned {
                    turned = region.turned();
                    &turned
                } else {
                    region
                };
                borders.extend(region.crossings(across, is_top).into_iter().map(|at| (at, *zone)));
            }
            for (sign, end) in [(-1.0, along[0]), (1.0, along[along.len() - 1])] {
                let mut ahead: Vec<(f64, Zone)> =
                    borders.iter().copied().filter(|(at, _)| sign * (at - from) > 0.0).collect();
                ahead.sort_by(|a, b| (sign * a.0).total_cmp(&(sign * b.0)).then(a.1.cmp(&b.1)));
                let (to, meets) = self.met(&ahead).unwrap_or((end, Meets::End));
                let [from, to] = [from, to].map(|place| self.results.axes[axis].spacing.value(place));
                distances.push(Distance { axis, from, to, meets });
            }
        }
        distances
    }

    /// The first border ahead that the case cares for: into a failure of one that is sound, or out of all failures.
    fn met(&self, ahead: &[(f64, Zone)]) -> Option<(f64, Meets)> {
        let fails = &self.results.base.fails;
        if fails.is_empty() {
            return ahead.first().map(|(at, zone)| (*at, Meets::Failure(*zone)));
        }
        let mut inside: BTreeMap<Zone, bool> = fails.iter().map(|zone| (*zone, true)).collect();
        for (at, zone) in ahead {
            let is_inside = inside.entry(*zone).or_default();
            *is_inside = !*is_inside;
            if inside.values().all(|is_inside| !is_inside) {
                return Some((*at, Meets::Sound));
            }
        }
        None
    }
}

impl Results<'_> {
    /// Where between two designs, of which one fails in a way, the border is, as a share of the way from the first \[–\]; and
    /// whether that is by a number and its limit. A third design in line, at a share of the way that is below 0 or above 1,
    /// says whether a number or its `curved` changes evenly.
    fn border(
        &self,
        zone: Zone,
        [a, b]: [&Found; 2],
        third: Option<(&Found, f64)>,
        curved: fn(f64) -> f64,
    ) -> (f64, bool) {
        let is_first = a.fails.contains(&zone);
        let (failed, other) = if is_first { (a, b) } else { (b, a) };
        let third = third.map(|(found, at)| (found, if is_first { at } else { 1.0 - at }));
        let rows = failed.red.iter().filter(|row| Zone::of_row(row) == zone);
        let shares = rows.map(|row| {
            let by_number = self.limit(row).and_then(|(place, red, sense)| {
                let [from, to] = [failed, other].map(|found| found.numbers[place]);
                let beyond = |value: f64| match sense {
                    Sense::AtMost => value - red,
                    Sense::AtLeast => red - value,
                };
                let is_between = beyond(from) >= 0.0 && beyond(to) <= 0.0 && from != to;
                let third = third.map(|(found, at)| (found.numbers[place], at));
                is_between.then(|| way([from, to], red, third, curved))
            });
            by_number.map_or((0.5, false), |share| (share, true))
        });
        // The last of them to be left.
        let (share, by_number) = shares.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.5, false));
        (if is_first { share } else { 1.0 - share }, by_number)
    }
}

/// Where a number is `at` on the way from one value to another \[–\]; it changes evenly, or its `curved` does (of numbers above
/// 0), whichever a third value in line is nearer to.
fn way([from, to]: [f64; 2], at: f64, third: Option<(f64, f64)>, curved: fn(f64) -> f64) -> f64 {
    let share = |of: fn(f64) -> f64| (of(from) - of(at)) / (of(from) - of(to));
    let miss = |of: fn(f64) -> f64, (value, place): (f64, f64)| {
        let span = (of(value) - of(from)).abs().max((of(value) - of(to)).abs());
        (of(value) - of(from) - place * (of(to) - of(from))).abs() / span
    };
    let can_curve = |(value, _): &(f64, f64)| [from, to, at, *value].iter().all(|v| v.is_finite() && *v > 0.0);
    let is_curved = third.filter(can_curve).is_some_and(|third| miss(curved, third) < miss(f64::from, third));
    share(if is_curved { curved } else { f64::from })
}

/// Of a study of one axis.
impl Window<'_> {
    /// The stretches of the axis where designs fail in one way.
    pub fn zone_spans(&self, zone: Zone) -> Vec<(f64, f64)> {
        self.zone(zone).0.iter().flat_map(spans).collect()
    }

    /// The stretches of the axis where sound designs are of a kind, as far as those that fail, and half-way to those of
    /// another kind.
    pub fn spans(&self, is: impl Fn(&Found) -> bool) -> Vec<(f64, f64)> {
        let regions = self.bands.iter().map(|band| {
            let found = |point: usize| &self.results.rows[band.rows[point]];
            let border = |a: usize, b: usize| match (found(a).worst(), found(b).worst()) {
                (Some(zone), None) | (None, Some(zone)) => self.border(band, zone, [a, b]).0,
                _ => 0.5,
            };
            band.grid.region(|point| Some(found(point).is_sound() && is(found(point))), border)
        });
        regions.collect::<Vec<_>>().iter().flat_map(spans).collect()
    }
}

/// Each outline of a region from its least x to its largest.
fn spans(region: &Region) -> impl Iterator<Item = (f64, f64)> + '_ {
    region.outlines.iter().map(|line| {
        line.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p.0), high.max(p.0)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by hand. Between forces of 1 and 4 a force of 2 is half-way by ratios, with 1/4 a way before them; 2.5 is half-way
    /// by steps, with 7 a way behind.
    #[test]
    fn what_goes_with_the_inverse_of_a_force_is_found_by_even_steps_and_by_even_ratios() {
        let index = |force: f64| 4.0 / force;
        let by_ratios = way([index(1.0), index(4.0)], index(2.0), Some((index(0.25), -1.0)), f64::ln);
        assert!((by_ratios - 0.5).abs() < 1e-12, "{by_ratios}");
        let by_steps = way([index(1.0), index(4.0)], index(2.5), Some((index(7.0), 2.0)), f64::recip);
        assert!((by_steps - 0.5).abs() < 1e-12, "{by_steps}");
        assert_eq!(way([4.0, 2.0], 3.0, None, f64::ln), 0.5);
    }
}
