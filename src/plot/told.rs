//! Charts in the units of [`DisplaySettings`](crate::units::DisplaySettings).

use super::Chart;
use super::chart::{Panel, Scale};
use crate::table::Axis;
use crate::units::DisplayUnit;

impl Chart {
    /// Converts axes, points and windows to display units.
    pub fn displayed(self) -> Self {
        Self { panels: self.panels.into_iter().map(|panel| panel.displayed()).collect(), ..self }
    }
}

impl Panel {
    fn displayed(self) -> Self {
        let largest = |axis: &Axis, of: fn(&(f64, f64)) -> f64| {
            let values =
                self.series.iter().flat_map(|series| &series.points).map(|point| axis.spacing().value(of(point)));
            values.filter(|value| value.is_finite()).fold(0.0, |largest, value| value.abs().max(largest))
        };
        let sizes = [largest(&self.x, |point| point.0), largest(&self.y, |point| point.1)];
        let ((x, along), (y, up)) = (self.x.displayed(sizes[0]), self.y.displayed(sizes[1]));
        let [along, up] = [Along { axis: &x, unit: along }, Along { axis: &y, unit: up }];
        let point = |point: &mut (f64, f64)| *point = (along.displayed(point.0), up.displayed(point.1));
        let mut series = self.series;
        series.iter_mut().flat_map(|series| &mut series.points).for_each(point);
        let scale = self.scale.displayed(along, up);
        Self { x, y, series, scale }
    }
}

impl Scale {
    fn displayed(self, along: Along, up: Along) -> Self {
        let window = |x: (f64, f64), y: (f64, f64)| {
            ((along.displayed(x.0), along.displayed(x.1)), (up.displayed(y.0), up.displayed(y.1)))
        };
        match self {
            Self::Fit { height, least } => Self::Fit { height, least: up.unit.factor * least },
            Self::Section { x, y } => {
                let (x, y) = window(x, y);
                Self::Section { x, y }
            }
            Self::Small { x, y } => {
                let (x, y) = window(x, y);
                Self::Small { x, y }
            }
            Self::Window { height, x, y } => {
                let (x, y) = window(x, y);
                Self::Window { height, x, y }
            }
            Self::Multiple { height, x, y } => {
                let (x, y) = window(x, y);
                Self::Multiple { height, x, y }
            }
            Self::Bar => Self::Bar,
        }
    }
}

/// An axis, and the unit that its values are to be told in.
#[derive(Clone, Copy)]
struct Along<'a> {
    axis: &'a Axis,
    unit: DisplayUnit,
}

impl Along<'_> {
    /// Where what is drawn at a place goes.
    fn displayed(self, place: f64) -> f64 {
        let spacing = self.axis.spacing();
        spacing.place(self.unit.convert(spacing.value(place)))
    }
}
