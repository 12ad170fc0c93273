//! Report of fitted laws: parameters, comparison by Akaike's criterion, chart.

use super::estimate::table;
use super::flow_curve::FlowCurve;
use super::law_fit::LawFits;
use crate::plot::Axis;
use crate::plot::chart::{Annotation, AnnotationKind, Chart, Panel, Series, Style};
use crate::plot::palette::{BLACK, GREY, color};
use crate::study::{Cell, ReportTable, StudyReport};
use crate::units::{Amount, Digits, Unit, trimmed};

const POINTS: usize = 160;
const DRAWN: usize = 120;
/// Strain that is drawn, over the end of the points \[–\].
const BEYOND: f64 = 2.0;
/// Difference of Akaike's criterion from which the best law is clearly better.
const CLEAR: f64 = 10.0;

impl LawFits {
    /// Headline, notes, tables and chart.
    pub fn report(&self) -> StudyReport {
        let best = self.best();
        let others = self.fits.iter().filter(|fit| fit.kind != best.kind);
        let next = others.map(|fit| fit.aic - best.aic).fold(f64::INFINITY, f64::min);
        let clearly = match next {
            f64::INFINITY => "",
            CLEAR.. => ", clearly better than the others",
            _ => ", but another law fits about as well",
        };
        let rms = Amount::new(best.rms, Unit::MPa, Digits::Significant(2));
        let mut notes: Vec<String> = self.tests.iter().map(FlowCurve::sentence).collect();
        for e in best.estimates.iter().filter(|e| e.bound.is_some()) {
            notes.push(format!("{} is at the end of its range: the law does not suit these points.", e.key));
        }
        for (i, j, correlation) in &best.correlated {
            let [a, b] = [i, j].map(|i| &best.estimates[*i].key);
            notes.push(format!("{a} and {b} can hardly be told apart (correlation {correlation:.2})."));
        }
        if let Some([r0, r45, r90]) = self.r_values() {
            let (mean, ears) = (0.25 * (r0 + 2.0 * r45 + r90), 0.5 * (r0 - 2.0 * r45 + r90));
            notes.push(format!("r̄ = (r0 + 2 r45 + r90)/4 = {mean:.3}, Δr = (r0 − 2 r45 + r90)/2 = {ears:.3}."));
        }
        let estimates = self.fits.iter().flat_map(|fit| fit.estimates.iter().map(|e| (fit.kind.name(), e)));
        let tables = [self.laws(), table(estimates), self.directions()];
        let tables = tables.into_iter().filter(|table| !table.rows.is_empty()).collect();
        StudyReport {
            headline: format!("{} fits best ({rms} r.m.s.){clearly}.", best.kind.label()),
            notes,
            tables,
            found: true,
            charts: vec![("fit".to_owned(), self.chart())],
        }
    }

    fn laws(&self) -> ReportTable {
        let mut table = ReportTable::new("laws", &["Law", "R²", "R.m.s.", "AIC"]);
        for fit in &self.fits {
            let rms = Amount::new(fit.rms, Unit::MPa, Digits::Significant(4));
            let [r2, aic] = [trimmed(fit.r2, 5), trimmed(fit.aic, 1)].map(Cell::from);
            table.rows.push(vec![fit.kind.label().into(), r2, rms.into(), aic]);
        }
        table
    }

    fn directions(&self) -> ReportTable {
        let mut table = ReportTable::new("directions", &["Direction", "Tests", "Stress ratio", "r", "Error of r"]);
        for d in &self.directions {
            let [r, error] =
                d.r.map_or(["–".to_owned(), "–".to_owned()], |(r, error)| [r, error].map(|x| trimmed(x, 4)));
            let cells = [trimmed(d.angle, 1), d.tests.to_string(), trimmed(d.ratio, 4), r, error];
            table.rows.push(cells.map(Cell::from).to_vec());
        }
        table
    }

    fn chart(&self) -> Chart {
        let (best, end) = (self.best(), self.end());
        let strains = || (0..=POINTS).map(|i| BEYOND * end * i as f64 / POINTS as f64);
        let laws = self.fits.iter().enumerate().map(|(i, fit)| {
            let curve = strains().map(|e| (e, fit.stress(e, None))).collect();
            Series::new(fit.kind.label(), curve, Style::curve(i))
        });
        let tests = self.tests.iter().enumerate().map(|(i, test)| {
            let style = if i == 0 { Style::Dots { color: BLACK } } else { Style::Triangles { color: color(i) } };
            Series::new(test.short_name(), thinned(test.points.iter().map(|p| (p.strain, p.stress))), style)
        });
        let flag = Annotation::new(AnnotationKind::Flag, "end of the points", (end, best.stress(end, None)));
        let points = self.fitted().flat_map(|test| &test.points);
        let misses = thinned(points.zip(&best.misses).map(|(point, miss)| (point.strain, *miss)));
        let zero = Series::silent(vec![(0.0, 0.0), (end, 0.0)], Style::Line { color: GREY, width: 1.2, dash: &[] });
        let panel = |label: &'static str, height, least| {
            let strain = Axis::named("True plastic strain", Unit::None);
            Panel::fit(strain, Axis::named(label, Unit::MPa), height, least)
        };
        let above = panel("True stress", 330.0, 10.0).with(laws.chain(tests)).annotated([flag]);
        let below = [zero, Series::silent(misses, Style::Dots { color: BLACK })];
        Chart::new(
            format!("{} fitted", best.kind.label()),
            vec![above, panel("Law less point", 210.0, 1.0).with(below)],
            Vec::new(),
        )
    }
}

fn thinned(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let all: Vec<(f64, f64)> = points.collect();
    let every = all.len().div_ceil(DRAWN).max(1);
    all.into_iter().step_by(every).collect()
}
