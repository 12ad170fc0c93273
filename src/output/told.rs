//! Charts in the units and the decimal sign that a user wants.

use super::Chart;
use super::chart::{Panel, Scale};
use crate::message::{Form, Told};

impl Chart {
    /// Its axes and everything along them in a form; words that stand beside them are those that it was made with.
    pub fn told(self, form: Form) -> Self {
        Self { panels: self.panels.into_iter().map(|panel| panel.told(form)).collect(), ..self }
    }
}

impl Panel {
    fn told(self, form: Form) -> Self {
        let largest = |of: fn(&(f64, f64)) -> f64| {
            let values = self.series.iter().flat_map(|series| &series.points).map(of);
            values.filter(|value| value.is_finite()).fold(0.0, |largest, value| value.abs().max(largest))
        };
        let sizes = [largest(|point| point.0), largest(|point| point.1)];
        let ((x, along), (y, up)) = (self.x.told(form, sizes[0]), self.y.told(form, sizes[1]));
        let point = |point: &mut (f64, f64)| *point = (in_unit(along, point.0), in_unit(up, point.1));
        let mut series = self.series;
        series.iter_mut().flat_map(|series| &mut series.points).for_each(point);
        Self { x, y, series, scale: self.scale.told(along, up) }
    }
}

impl Scale {
    fn told(self, along: Told, up: Told) -> Self {
        let window = |x: (f64, f64), y: (f64, f64)| {
            ((in_unit(along, x.0), in_unit(along, x.1)), (in_unit(up, y.0), in_unit(up, y.1)))
        };
        match self {
            Self::Fit { height, least } => Self::Fit { height, least: up.factor * least },
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

fn in_unit(unit: Told, value: f64) -> f64 {
    value * unit.factor + unit.offset
}
