//! The tables of a scatter, for programs.

use crate::results::csv::number;
use crate::study::scatter::{Band, Estimate, Found, Influence};

/// Each table by its name.
pub fn tables(found: &Found) -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("quantiles.csv", quantiles(found)),
        ("lights.csv", lights(found)),
        ("indices.csv", indices(found)),
        ("bands.csv", bands(found)),
    ]
}

/// Lines of CSV below a header.
fn written(header: &[&str], lines: impl IntoIterator<Item = Vec<String>>) -> Vec<u8> {
    let never = "memory does not refuse a row";
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header).expect(never);
    for line in lines {
        writer.write_record(line).expect(never);
    }
    writer.into_inner().expect(never)
}

fn of(estimate: Estimate) -> [String; 3] {
    [estimate.value, estimate.low, estimate.high].map(number)
}

fn quantiles(found: &Found) -> Vec<u8> {
    let lines = found.numbers.iter().filter_map(|spread| {
        let [q05, q50, q95] = spread.quantiles()?.map(number);
        let (mean, deviation) = spread.moments();
        let runs = spread.values.len().to_string();
        Some(vec![
            spread.header.clone(),
            runs,
            number(mean),
            number(deviation),
            q05,
            q50,
            q95,
            number(spread.number.value),
        ])
    });
    written(&["number", "runs", "mean", "standard_deviation", "q05", "q50", "q95", "case_as_it_stands"], lines)
}

fn lights(found: &Found) -> Vec<u8> {
    let lines = found.events.iter().map(|event| {
        let mut line = vec![event.key.clone(), event.light.name().to_owned(), event.hits.to_string()];
        line.push((found.runs - found.failed).to_string());
        line.extend(of(event.chance));
        line
    });
    written(&["row", "light", "runs_that_have_it", "runs", "probability", "low", "high"], lines)
}

/// Sobol indices of groups, and rank correlations of each factor; cells of what was not asked for are empty.
fn indices(found: &Found) -> Vec<u8> {
    let numbers = found.numbers.iter().map(|spread| (spread.header.clone(), &spread.influence));
    let events =
        found.events.iter().map(|event| (format!("{}_is_{}", event.key, event.light.name()), &event.influence));
    let lines = numbers.chain(events).flat_map(|(name, influence)| lines_of(found, &name, influence));
    let sobol = ["first_order", "first_order_low", "first_order_high", "total", "total_low", "total_high"];
    let header = [&["number", "of"], &sobol[..], &["rank_correlation"]].concat();
    written(&header, lines)
}

fn lines_of(found: &Found, name: &str, influence: &Influence) -> Vec<Vec<String>> {
    let nothing = || std::iter::repeat_n(String::new(), 6);
    let groups = found.groups.iter().enumerate().filter_map(|(i, group)| {
        let index = influence.indices.as_ref()?.get(i)?;
        // A group of one key has its rank correlation on the same line.
        let rank = found.factors.iter().position(|factor| factor == group).and_then(|k| influence.ranks[k]);
        let mut line = vec![name.to_owned(), group.clone()];
        line.extend(of(index.first).into_iter().chain(of(index.total)));
        line.push(rank.map_or_else(String::new, number));
        Some(line)
    });
    let groups: Vec<Vec<String>> = groups.collect();
    let is_told = |factor: &String| groups.iter().any(|line| line[1] == *factor);
    let factors = found.factors.iter().zip(&influence.ranks).filter(|(factor, _)| !is_told(factor));
    let ranks = factors.filter_map(|(factor, rank)| {
        let mut line = vec![name.to_owned(), factor.clone()];
        line.extend(nothing());
        line.push(number((*rank)?));
        Some(line)
    });
    let ranks: Vec<Vec<String>> = ranks.collect();
    groups.into_iter().chain(ranks).collect()
}

fn bands(found: &Found) -> Vec<u8> {
    let curves = [("punch_force_over_travel", &found.load), ("thickness_over_initial_distance", &found.thickness)];
    let lines = curves.into_iter().filter_map(|(name, band)| Some((name, band.as_ref()?))).flat_map(|(name, band)| {
        let Band { x, quantiles: [q05, q50, q95], runs } = band;
        (0..x.len()).map(move |i| {
            let mut line = vec![name.to_owned()];
            line.extend([x[i], q05[i], q50[i], q95[i]].map(number));
            line.push(runs[i].to_string());
            line
        })
    });
    written(&["curve", "x_mm", "q05", "q50", "q95", "runs"], lines)
}
