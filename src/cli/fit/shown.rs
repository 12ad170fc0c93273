//! Fitted numbers in files and on the screen.

use stampflow::numerics::profile::End;
use stampflow::study::fit::Estimate;
use std::fmt::Write;

/// A row of `fit.csv` for each number.
pub fn csv<'a>(estimates: impl Iterator<Item = (&'a str, &'a Estimate)>) -> String {
    let mut text = String::from("of,parameter,unit,value,standard_error,low_95,high_95,at_bound\n");
    let plain = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for (of, e) in estimates {
        let [low, high] = e.ends.map(at);
        let (key, unit, pushed) = (&e.key, &e.unit, if e.pushed.is_some() { "yes" } else { "" });
        let _ =
            writeln!(text, "{of},{key},{unit},{},{},{},{},{pushed}", e.value, plain(e.error), plain(low), plain(high));
    }
    text
}

fn at(end: End) -> Option<f64> {
    match end {
        End::At(value) => Some(value),
        End::Open | End::Unknown => None,
    }
}

/// Value with its unit, standard error and interval, as a table has them.
pub fn cells(e: &Estimate) -> [String; 3] {
    let e = e.clone().displayed();
    let interval = e.interval().unwrap_or_else(|| "–".to_owned());
    [
        format!("{} {}", e.told(), e.unit).trim_end().to_owned(),
        e.told_error().unwrap_or_else(|| "–".to_owned()),
        interval,
    ]
}
