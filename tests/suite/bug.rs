//! What becomes of a panic: an error that names it, while others go on.

#[allow(dead_code, reason = "the hook is the program's: tests share a process")]
#[path = "../../src/bug.rs"]
mod caught;

use caught::caught;
use rayon::prelude::*;

#[test]
fn a_panic_of_one_job_is_an_error_that_says_what_to_send_and_stops_no_other() {
    let job = |i: usize| {
        caught(&format!("case {i}"), || match i {
            2 => panic!("index {i} of nothing"),
            3 => std::panic::panic_any(i),
            4 => anyhow::bail!("no file"),
            _ => Ok(i),
        })
    };
    let ends: Vec<anyhow::Result<usize>> = (0..6).into_par_iter().map(job).collect();
    let done: Vec<usize> = ends.iter().flatten().copied().collect();
    assert_eq!(done, [0, 1, 5]);
    let all: Vec<String> = ends.iter().filter_map(|end| end.as_ref().err()).map(ToString::to_string).collect();
    assert!(all[0].starts_with("case 2 met a mistake of this program") && all[0].contains("index 2 of nothing"));
    assert!(all[0].contains("the case file and the files that it names") && all[0].contains(env!("CARGO_PKG_VERSION")));
    assert!(all[1].contains("no words") && all[2] == "no file", "{all:?}");
}
