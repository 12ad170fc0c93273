//! Conversion of charts to the units of [`DisplaySettings`](crate::units::DisplaySettings).

use super::chart::{Chart, Panel, Scale, bounds};
use crate::plot::Axis;
use crate::units::DisplayUnit;

impl Chart {
    /// Chart in display units; converted once only.
    pub fn displayed(self) -> Self {
        Self { panels: self.panels.into_iter().map(Panel::displayed).collect(), ..self }
    }
}

impl Panel {
    fn displayed(mut self) -> Self {
        let largest = |axis: &Axis, coordinate: fn(&(f64, f64)) -> f64| {
            let points = self.series.iter().flat_map(|series| &series.points);
            bounds(points.map(|point| axis.spacing.value(coordinate(point)).abs())).1.max(0.0)
        };
        let sizes = [largest(&self.x, |point| point.0), largest(&self.y, |point| point.1)];
        let ((x, x_unit), (y, y_unit)) = (self.x.displayed(sizes[0]), self.y.displayed(sizes[1]));
        let along = |v: &mut f64| *v = convert(&x, x_unit, *v);
        let up = |v: &mut f64| *v = convert(&y, y_unit, *v);
        let mut point = |(a, b): &mut (f64, f64)| {
            along(a);
            up(b);
        };
        self.series.iter_mut().flat_map(|series| &mut series.points).for_each(&mut point);
        self.annotations.iter_mut().map(|annotation| &mut annotation.at).for_each(point);
        match &mut self.scale {
            Scale::Fit { least, .. } => *least *= y_unit.map_or(1.0, |unit| unit.factor),
            Scale::Section { x, y } | Scale::Window { x, y, .. } => {
                [&mut x.0, &mut x.1].into_iter().for_each(along);
                [&mut y.0, &mut y.1].into_iter().for_each(up);
            }
            Scale::Bar => {}
        }
        Self { x, y, ..self }
    }
}

/// Converts a coordinate along an axis, which is a logarithm on a logarithmic one.
fn convert(axis: &Axis, unit: Option<DisplayUnit>, place: f64) -> f64 {
    unit.map_or(place, |unit| axis.spacing.place(unit.convert(axis.spacing.value(place))))
}
