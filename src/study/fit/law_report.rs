//! Report of fitted laws: parameters, comparison by Akaike's criterion, chart.

use super::estimate::table;
use super::flow_curve::FlowCurve;
use super::law_fit::LawFits;
use crate::plot::chart::{Annotation, AnnotationKind, Chart, Panel, Series, Style};
use crate::plot::palette::{BLACK, GREY, color};
use crate::study::report::{Cell, ReportTable, StudyReport};
use crate::table::Axis;
use crate::units::{Amount, Digits, Unit, significant, trimmed};

/// Points of a drawn law, and most points of a drawn test.
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
            _ if self.fits.len() == 1 => "",
            next if next >= CLEAR => ", clearly better than the others",
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
        let mut tables = vec![self.laws(), table(&estimates.collect::<Vec<_>>())];
        tables.extend(self.directions());
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
            let texts = [trimmed(fit.r2, 5), trimmed(fit.aic, 1)].map(Cell::from);
            let [r2, aic] = texts;
            table.rows.push(vec![fit.kind.label().into(), r2, rms.into(), aic]);
        }
        table
    }

    fn directions(&self) -> Option<ReportTable> {
        let mut table = ReportTable::new("directions", &["Direction", "Tests", "Stress ratio", "r", "Error of r"]);
        for d in &self.directions {
            let text = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| trimmed(value, 4));
            let cells = [trimmed(d.angle, 1), d.tests.to_string(), trimmed(d.ratio, 4), text(d.r), text(d.r_error)];
            table.rows.push(cells.map(Cell::from).to_vec());
        }
        (!table.rows.is_empty()).then_some(table)
    }

    /// Laws and points above, misses of the best law below.
    fn chart(&self) -> Chart {
        let (best, end) = (self.best(), self.end());
        let strains: Vec<f64> = (0..=POINTS).map(|i| BEYOND * end * i as f64 / POINTS as f64).collect();
        let mut series = Vec::new();
        for (i, fit) in self.fits.iter().enumerate() {
            let curve = strains.iter().map(|e| (*e, fit.stress(*e, None))).collect();
            series.push(Series::new(fit.kind.label(), curve, Style::curve(i)));
        }
        for (i, test) in self.tests.iter().enumerate() {
            let points = thinned(test.points.iter().map(|p| (p.strain, p.stress)));
            let look = if i == 0 { Style::Dots { color: BLACK } } else { Style::Triangles { color: color(i) } };
            series.push(Series::new(test.short_name(), points, look));
        }
        let flag = Annotation::new(AnnotationKind::Flag, "end of the points", (end, best.stress(end, None)));
        let points = self.fitted().flat_map(|test| &test.points);
        let misses = thinned(points.zip(&best.misses).map(|(point, miss)| (point.strain, *miss)));
        let zero = Series::silent(vec![(0.0, 0.0), (end, 0.0)], Style::Line { color: GREY, width: 1.2, dash: &[] });
        let below = vec![zero, Series::silent(misses, Style::Dots { color: BLACK })];
        let panel = |label: &'static str, height, least| {
            let strain = Axis::named("True plastic strain", Unit::None);
            Panel::fit(strain, Axis::named(label, Unit::MPa), height, least)
        };
        let above = panel("True stress", 330.0, 10.0).with(series).annotated([flag]);
        Chart::new("", vec![above, panel("Law less point", 210.0, 1.0).with(below)], Vec::new())
    }
}

fn thinned(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let all: Vec<(f64, f64)> = points.collect();
    let every = all.len().div_ceil(DRAWN).max(1);
    all.into_iter().step_by(every).collect()
}

impl FlowCurve {
    /// Results of the test in one sentence.
    pub fn sentence(&self) -> String {
        let mut parts = Vec::new();
        if let Some(young) = self.young {
            let source = if self.is_fitted { "slope of the elastic line" } else { "E as given" };
            parts.push(format!("{source} {}", Amount::stress(significant(young, 3))));
        }
        parts.extend(self.yield_stress.map(|stress| format!("yield stress {}", Amount::stress(stress))));
        parts.push(match self.uniform {
            Some(uniform) => {
                let strength = Amount::stress(self.strength);
                format!("largest force at a plastic strain of {uniform:.3}, {strength}: cut there")
            }
            None => "the force does not fall: no cut".into(),
        });
        let first = self.points.first().map_or(0.0, |p| p.strain);
        parts.push(format!("{} points from {first:.4} to {:.3}", self.points.len(), self.end()));
        parts.extend(self.r.map(|(r, error)| format!("r {r:.3} ± {error:.3}")));
        format!("{}: {}.", self.short_name(), parts.join("; "))
    }
}
