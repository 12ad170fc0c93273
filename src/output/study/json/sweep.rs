//! What a sweep has found, for programs.

use crate::study::{Distance, Meets, Results, Said};
use crate::units::rounded;
use serde_json::{Value, json};

/// How many designs are sound and why others fail, the extremes of the number that decides first, and how far the case is from
/// the borders: numbers in the solver's units; and the same as sentences.
pub fn sweep(results: &Results, said: &Said) -> Value {
    let Said { designs, sound, amber, fails, extremes, distances } = said;
    let fails: serde_json::Map<_, _> =
        fails.iter().map(|(zone, count)| (zone.key().to_owned(), json!(count))).collect();
    let extremes = extremes.map(|[place, least, most]| {
        let row = |row: usize| json!({ "index": row, "value": rounded(results.rows[row].numbers[place]) });
        json!({ "number": results.column(place), "least": row(least), "most": row(most) })
    });
    let keys: Vec<&str> = results.plan.axes().iter().map(|axis| axis[0].key.as_str()).collect();
    let distance = |distance: &Distance| {
        let Distance { axis, from, to, meets } = distance;
        let meets = match meets {
            Meets::Failure(zone) => zone.key(),
            Meets::Sound => "sound",
            Meets::End => "end",
        };
        json!({ "key": keys[*axis], "unit": results.axes[*axis].unit.spelled(), "from": rounded(*from),
                "to": rounded(*to), "meets": meets })
    };
    let sentences = said.sentences(results);
    json!({
        "designs": designs,
        "sound": sound,
        "amber": amber,
        "fails": fails,
        "extremes": extremes,
        "distances": distances.iter().map(distance).collect::<Vec<_>>(),
        "told": sentences.iter().map(|sentence| sentence.to_string()).collect::<Vec<_>>(),
    })
}
