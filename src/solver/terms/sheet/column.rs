//! The thickness points of several elements side by side, by the law of their metal.

use crate::element::section::{Answer, Column};
use crate::material::PointLaw;
use crate::material::flow::{Quadratic, Rows, Triple};
use crate::numerics::number::{Instructions, Lanes};

/// Points of several elements.
pub struct Together<'a, S> {
    pub law: &'a Quadratic<'a>,
    pub rows: Rows<'a, S>,
}

impl<S: Instructions> Column<Lanes<S>> for Together<'_, S> {
    #[inline(always)]
    fn respond(&mut self, i: usize, strain: Triple<Lanes<S>>, spread: Option<[Lanes<S>; 2]>) -> Answer<Lanes<S>> {
        let (point, mut iterate) = (self.rows.point(i), self.rows.iterate(i));
        let Some(spread) = spread else {
            let update = self.law.respond(&point, &mut iterate, strain);
            self.rows.take(i, &iterate, &update);
            return Answer::Point(update);
        };
        let across = self.law.across(&point, &mut iterate, strain, spread);
        self.rows.take(i, &iterate, &across.update);
        Answer::Part(across)
    }
}
