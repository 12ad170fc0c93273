//! Report of fitted laws: parameters, comparison by Akaike's criterion, chart, and `[material]` of a case.

use super::{Estimate, law::Direction, law::LawFit, law::LawFits, law::MEANS, table};
use crate::plot::chart::{Annotation, Chart, Panel, Series, Style, thinned};
use crate::plot::{Axis, palette::BLACK, palette::color};
use crate::study::{Cell, ReportTable, StudyReport};
use crate::units::{Amount, Digits, Unit, joined, rounded, significant, trimmed};

const POINTS: usize = 160;
/// Strain that is drawn, over the end of the points \[–\].
const BEYOND: f64 = 2.0;
const CLEAR: f64 = 10.0;

impl LawFits {
    /// Headline, notes, tables and chart.
    pub fn report(&self) -> StudyReport {
        let best = self.best();
        let others = self.fits.iter().filter(|fit| fit.kind != best.kind).map(|fit| fit.aic - best.aic);
        let clearly = match others.fold(f64::INFINITY, f64::min) {
            f64::INFINITY => "",
            CLEAR.. => ", clearly better than the others",
            _ => ", but another law fits about as well",
        };
        let rms = |rms: f64, digits| Amount::new(rms, Unit::MPa, Digits::Significant(digits));
        let mut notes: Vec<String> = self.tests.iter().map(|test| test.sentence.clone()).collect();
        let long = "The search begins with means of the rows. Parameters, errors and misfits are of all rows.";
        notes.extend((self.fitted().map(|test| test.points.len()).sum::<usize>() > MEANS).then(|| long.to_owned()));
        let poor = "is at the end of its range: the law does not suit these points.";
        notes.extend(best.estimates.iter().filter(|e| e.bound.is_some()).map(|e| format!("{} {poor}", e.key)));
        if let Some([r0, r45, r90]) = self.r_values() {
            let (mean, ears) = (0.25 * (r0 + 2.0 * r45 + r90), 0.5 * (r0 - 2.0 * r45 + r90));
            notes.push(format!("r̄ = (r0 + 2 r45 + r90)/4 = {mean:.3}, Δr = (r0 − 2 r45 + r90)/2 = {ears:.3}."));
        }
        let law = |fit: &LawFit| [fit.kind.label().into(), rms(fit.rms, 4).into(), trimmed(fit.aic, 1).into()];
        let laws = ReportTable::new("laws", &["Law", "R.m.s.", "AIC"], self.fits.iter().map(law));
        let estimates = self.fits.iter().flat_map(|fit| fit.estimates.iter().map(|e| (fit.kind.name(), e)));
        let direction = |d: &Direction| {
            let [r, error] = [d.r.map(|r| r.0), d.r.map(|r| r.1)].map(|x| x.map_or("–".into(), |x| trimmed(x, 4)));
            [trimmed(d.angle, 1), d.tests.to_string(), trimmed(d.ratio, 4), r, error].map(Cell::from)
        };
        let columns = ["Direction", "Tests", "Stress ratio", "r", "Error of r"];
        let directions = ReportTable::new("directions", &columns, self.directions.iter().map(direction));
        let tables = [laws, table(estimates), directions].into_iter().filter(|table| !table.rows.is_empty());
        let headline = format!("{} fits best ({} r.m.s.){clearly}.", best.kind.label(), rms(best.rms, 2));
        let charts = vec![("fit".to_owned(), self.chart())];
        StudyReport { headline, notes, tables: tables.collect(), found: true, charts }
    }

    fn chart(&self) -> Chart {
        let (best, end) = (self.best(), self.end());
        let laws = self.fits.iter().enumerate().map(|(i, fit)| {
            let strains = (0..=POINTS).map(|i| BEYOND * end * i as f64 / POINTS as f64);
            Series::new(fit.kind.label(), strains.map(|e| (e, fit.stress(e, None))).collect(), Style::curve(i))
        });
        let tests = self.tests.iter().enumerate().map(|(i, test)| {
            let style = if i == 0 { Style::Dots { color: BLACK } } else { Style::Triangles { color: color(i) } };
            Series::new(test.name.as_str(), thinned(test.points.iter().map(|p| (p.strain, p.stress)).collect()), style)
        });
        let flag = Annotation::flag("end of the points", (end, best.stress(end, None)));
        let strain = Axis::named("True plastic strain", Unit::None);
        let panel = Panel::fit(strain, Axis::named("True stress", Unit::MPa), 330.0, 10.0);
        let panel = panel.with(laws.chain(tests)).annotated([flag]);
        Chart::new(format!("{} fitted", best.kind.label()), vec![panel], Vec::new())
    }
}

/// Poisson's ratio, which a tension test without a width does not give \[–\].
const POISSON: f64 = 0.3;
/// Moduli of metals; another slope is that of the machine \[MPa\].
const METALS: std::ops::RangeInclusive<f64> = 40_000.0..=240_000.0;

/// Material table of a law: range, elastic line, rate law and r-values.
pub fn material_text(fits: &LawFits, law: &LawFit) -> String {
    let files = joined(fits.tests.iter().map(|test| test.name.clone()), ", ");
    let (label, end) = (law.kind.label(), trimmed(rounded(fits.end()), 4));
    let source = format!("fitted by stampflow to {files}: {label} up to a plastic strain of {end}");
    let mut text = format!("[material]\nsource = {source:?}\n");
    if let Some(young) = fits.fitted().find_map(|test| test.young.filter(|young| METALS.contains(young))) {
        let young = trimmed(1e-3 * young, 1);
        text += &format!("young = \"{young} GPa\"\npoisson = {POISSON}                       # declared\n");
    }
    text += &format!("fitted_up_to = {end}\n");
    if let Some(r) = fits.r_values() {
        let [r0, r45, r90] = r.map(|r| trimmed(r, 3));
        text += &format!("anisotropy = {{ r0 = {r0}, r45 = {r45}, r90 = {r90} }}\n");
    } else if let Some((r, _)) = fits.directions.iter().find_map(|d| d.r) {
        text += &format!("anisotropy = {}                   # of one direction\n", trimmed(r, 3));
    }
    text += &format!("\n[material.hardening.{}]\n", law.kind.name().replace('-', "_"));
    for e in law.estimates.iter().filter(|e| !e.key.starts_with("rate.")) {
        let error = e.error.map_or_else(String::new, |error| format!("    # ± {}", significant(error, 2)));
        text += &format!("{} = {}{error}\n", e.key, quoted(e));
    }
    if let Some((rate, e)) = law.rate.zip(law.estimate("rate.exponent")) {
        let (exponent, reference) = (quoted(e), rate.reference);
        text += &format!("\n[material.rate.power]\nexponent = {exponent}\nreference = \"{reference} /s\"\n");
    }
    text
}

fn quoted(estimate: &Estimate) -> String {
    let (value, unit) = (estimate.written(), &estimate.unit);
    if unit.is_empty() { value } else { format!("\"{value} {unit}\"") }
}
