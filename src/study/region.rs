//! Regions over a grid of points, and their borders between the points: marching squares.
//!
//! Every cell of four points gives the polygon of its part inside: its corners that are inside, and on each side with one
//! corner in and one out the place of the border. Sides of neighbouring polygons that are one the other's way back cancel;
//! what is left is the outline, counterclockwise, of holes clockwise. What of it crosses a cell is the border.

use std::collections::HashMap;

/// A point of the plane.
pub type Point = (f64, f64);

/// Values of x and y that points stand at, in rising order; point `i + j·columns` is at `x[i]`, `y[j]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// At least two.
    pub x: Vec<f64>,
    /// At least two.
    pub y: Vec<f64>,
}

/// A part of the plane of a grid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    /// Closed lines around it; holes run the other way round.
    pub outlines: Vec<Vec<Point>>,
    /// Lines between it and what is outside, without the edges of the grid; the inside lies to the left.
    pub borders: Vec<Vec<Point>>,
}

type Key = (u64, u64);

fn key(point: Point) -> Key {
    // Both zeros are one place.
    ((point.0 + 0.0).to_bits(), (point.1 + 0.0).to_bits())
}

impl Grid {
    /// Where a point stands.
    pub fn at(&self, point: usize) -> Point {
        (self.x[point % self.x.len()], self.y[point / self.x.len()])
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.x.len() * self.y.len()
    }

    /// Whether it has no points.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A third point in line with two neighbours, the first with the lower number, and its place as a share of the way from
    /// the first to the second: behind the second where that is wanted and there is one, else before the first.
    pub fn third(&self, a: usize, b: usize, is_behind: bool) -> Option<(usize, f64)> {
        let (columns, step) = (self.x.len(), b - a);
        let is_across = step == columns;
        let place = |point: usize| if is_across { self.at(point).1 } else { self.at(point).0 };
        let is_in_line = |point: &usize| *point < self.len() && (is_across || point / columns == a / columns);
        let (behind, before) = (Some(b + step).filter(is_in_line), a.checked_sub(step).filter(is_in_line));
        let third = if is_behind { behind.or(before) } else { before.or(behind) }?;
        let share = (place(third) - place(a)) / (place(b) - place(a));
        share.is_finite().then_some((third, share))
    }

    /// The part of the grid that is inside: `is_inside` of a point is `None` where it is unknown, which leaves out the cells
    /// around it; `share` is where on the way from the first point to the second, one in and one out, the border is
    /// \[–\].
    pub fn region(&self, is_inside: impl Fn(usize) -> Option<bool>, share: impl Fn(usize, usize) -> f64) -> Region {
        let columns = self.x.len();
        let mut edges: HashMap<(Key, Key), (Point, Point, bool)> = HashMap::new();
        for j in 0..self.y.len().saturating_sub(1) {
            for i in 0..columns - 1 {
                let first = i + j * columns;
                let corners = [first, first + 1, first + columns + 1, first + columns];
                let Some(inside) = corners.iter().map(|&c| is_inside(c)).collect::<Option<Vec<bool>>>() else {
                    continue;
                };
                let mut polygon: Vec<(Point, bool)> = Vec::with_capacity(6);
                for k in 0..4 {
                    let (a, b) = (corners[k], corners[(k + 1) % 4]);
                    if inside[k] {
                        polygon.push((self.at(a), false));
                    }
                    if inside[k] != inside[(k + 1) % 4] {
                        polygon.push((self.between(a, b, &share), true));
                    }
                }
                for (n, &(from, leaves)) in polygon.iter().enumerate() {
                    let (to, enters) = polygon[(n + 1) % polygon.len()];
                    let crosses = leaves && enters;
                    if key(from) == key(to) || edges.remove(&(key(to), key(from))).is_some() {
                        continue;
                    }
                    edges.insert((key(from), key(to)), (from, to, crosses));
                }
            }
        }
        let mut all: Vec<(Point, Point, bool)> = edges.into_values().collect();
        // In an order that no hash decides.
        let order = |a: Point, b: Point| a.1.total_cmp(&b.1).then(a.0.total_cmp(&b.0));
        all.sort_by(|a, b| order(a.0, b.0).then(order(a.1, b.1)));
        let borders = all.iter().filter(|edge| edge.2).map(|&(from, to, _)| (from, to)).collect();
        Region { outlines: chains(all.iter().map(|&(from, to, _)| (from, to)).collect()), borders: chains(borders) }
    }

    /// The place of the border on a side; the same from either end.
    fn between(&self, a: usize, b: usize, share: &impl Fn(usize, usize) -> f64) -> Point {
        let (a, b) = (a.min(b), a.max(b));
        let (p, q, share) = (self.at(a), self.at(b), share(a, b).clamp(0.0, 1.0));
        (p.0 + share * (q.0 - p.0), p.1 + share * (q.1 - p.1))
    }
}

/// Directed edges in lines, each as long as can be; of a closed one the first point comes again at its end.
fn chains(edges: Vec<(Point, Point)>) -> Vec<Vec<Point>> {
    let mut next: HashMap<Key, Vec<usize>> = HashMap::new();
    let mut arrivals: HashMap<Key, usize> = HashMap::new();
    for (i, (from, to)) in edges.iter().enumerate().rev() {
        next.entry(key(*from)).or_default().push(i);
        *arrivals.entry(key(*to)).or_default() += 1;
    }
    let mut is_used = vec![false; edges.len()];
    let begins = (0..edges.len()).filter(|&i| !arrivals.contains_key(&key(edges[i].0)));
    let starts: Vec<usize> = begins.chain(0..edges.len()).collect();
    let mut lines = Vec::new();
    for start in starts {
        if is_used[start] {
            continue;
        }
        let mut line = vec![edges[start].0];
        let mut edge = start;
        loop {
            is_used[edge] = true;
            let to = edges[edge].1;
            line.push(to);
            if key(to) == key(line[0]) {
                break;
            }
            let free = next.get(&key(to)).and_then(|all| all.iter().rev().find(|&&i| !is_used[i]));
            match free {
                Some(&i) => edge = i,
                None => break,
            }
        }
        lines.push(line);
    }
    lines
}

impl Region {
    /// All outlines as one polygon: bridges there and back join them, so that holes stay holes.
    pub fn polygon(&self) -> Vec<Point> {
        let Some(anchor) = self.outlines.first().and_then(|line| line.first()).copied() else { return Vec::new() };
        self.outlines.iter().flat_map(|line| line.iter().copied().chain([anchor])).collect()
    }

    /// Where its border meets the line along x at a height y, of two heights that the line lies between.
    pub fn crossings(&self, y: f64, is_top: bool) -> Vec<f64> {
        let segments = self.borders.iter().flat_map(|line| line.windows(2));
        // Each end belongs to one of the two segments that meet there.
        let is_below = |p: Point| if is_top { p.1 < y } else { p.1 <= y };
        let crossed = segments.filter(|pair| is_below(pair[0]) != is_below(pair[1]));
        crossed.map(|pair| pair[0].0 + (pair[1].0 - pair[0].0) * (y - pair[0].1) / (pair[1].1 - pair[0].1)).collect()
    }

    /// Whether a point is inside.
    pub fn contains(&self, (x, y): Point) -> bool {
        let segments = self.outlines.iter().flat_map(|line| line.windows(2));
        let crossed = segments
            .filter(|pair| (pair[0].1 <= y) != (pair[1].1 <= y))
            .filter(|pair| x < pair[0].0 + (pair[1].0 - pair[0].0) * (y - pair[0].1) / (pair[1].1 - pair[0].1));
        crossed.count() % 2 == 1
    }

    /// The same with x and y exchanged.
    #[must_use]
    pub fn turned(&self) -> Self {
        let turned = |lines: &[Vec<Point>]| lines.iter().map(|l| l.iter().map(|p| (p.1, p.0)).collect()).collect();
        Self { outlines: turned(&self.outlines), borders: turned(&self.borders) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[Point]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        0.5 * polygon.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>()
    }

    fn even(count: usize) -> Vec<f64> {
        (0..count).map(|i| i as f64).collect()
    }

    /// Where a plane f passes 0 on the way from a to b.
    fn share(grid: &Grid, f: impl Fn(Point) -> f64) -> impl Fn(usize, usize) -> f64 {
        move |a, b| {
            let (a, b) = (f(grid.at(a)), f(grid.at(b)));
            a / (a - b)
        }
    }

    /// Trust: the half plane x + 2y < 6.5 of a rectangle of 6 by 4, by hand: of its outline, the border is one straight line,
    /// and linear interpolation gives it exactly.
    #[test]
    fn a_half_plane_has_its_area_and_its_border() {
        let grid = Grid { x: even(7), y: even(5) };
        let f = |p: Point| 6.5 - p.0 - 2.0 * p.1;
        let region = grid.region(|i| Some(f(grid.at(i)) > 0.0), share(&grid, f));
        assert_eq!((region.outlines.len(), region.borders.len()), (1, 1));
        // A trapezium of heights 3.25 at x = 0 and 0.25 at x = 6.
        assert!((area(&region.polygon()) - 10.5).abs() < 1e-12, "{}", area(&region.polygon()));
        assert!(region.borders[0].iter().all(|p| f(*p).abs() < 1e-12));
        assert_eq!(region.crossings(1.25, false), [4.0]);
        assert_eq!(region.turned().crossings(0.5, false), [3.0]);
        assert!(region.crossings(4.0, true).is_empty());
        // On a row of points, and along the uppermost one.
        assert_eq!(region.crossings(2.0, false), [2.5]);
        let all = grid.region(|i| Some(grid.at(i).0 < 3.0), |_, _| 0.5);
        assert_eq!([all.crossings(4.0, true), all.crossings(0.0, false)], [[2.5], [2.5]]);
    }

    /// Trust: a square ring by hand, 5 by 5 less 2 by 2 of the point in the middle, whose corners are cut at half-way.
    #[test]
    fn a_hole_is_no_part_of_the_polygon() {
        let grid = Grid { x: even(6), y: even(6) };
        let is_hole = |p: Point| (2.0..=3.0).contains(&p.0) && (2.0..=3.0).contains(&p.1);
        let region = grid.region(|i| Some(!is_hole(grid.at(i))), |_, _| 0.5);
        assert_eq!((region.outlines.len(), region.borders.len()), (2, 1));
        // The hole is 2 by 2 with four corners of 0.5 · 0.5 · 0.5 cut off.
        assert!((area(&region.polygon()) - (25.0 - 4.0 + 0.5)).abs() < 1e-12, "{}", area(&region.polygon()));
        assert_eq!(region.crossings(2.5, false).len(), 2);
    }

    /// Trust: a point that is unknown takes the four cells around it with it.
    #[test]
    fn what_is_unknown_is_left_out() {
        let grid = Grid { x: even(4), y: even(4) };
        let region = grid.region(|i| (i != 5).then_some(true), |_, _| 0.5);
        assert!((area(&region.polygon()) - 5.0).abs() < 1e-12);
        assert!(region.borders.is_empty());
    }
}
