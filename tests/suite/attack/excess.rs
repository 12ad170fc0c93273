//! Nests as deep, and lists as long, as nobody writes in a case file.

use crate::common::prelude::*;

fn many(entry: &str, times: usize) -> String {
    vec![entry; times].join(", ")
}

/// One of them, to stand at the end of a case file.
pub fn excess(rng: &mut Rng) -> String {
    let branch = "{ up_to = 0.1, initial = \"1 MPa\", k = \"1 MPa\", n = 0.1 }";
    match rng.usize(..16) {
        0 => "[output]\nframes = [[[[[[[[[[[[[[]]]]]]]]]]]]]]".to_owned(),
        1 => format!("deep = {}{}", "[".repeat(100_000), "]".repeat(100_000)),
        2 => format!("deep = {}1{}", "{ a = ".repeat(50_000), " }".repeat(50_000)),
        3 => format!("[{}a]", "a.".repeat(50_000)),
        4 => format!("[output]\nframes = [{}]", many("\"1 mm\"", 1_001)),
        5 => format!("[output]\nframes = [{}]", many("\"1 mm\"", 60_000)),
        6 => format!("[output]\nframes = [{}]", many("\"1e-300 mm\"", 900)),
        7 => format!("notes = [{}]", many("\"declared: a\"", 60_000)),
        8 => "[blank]\nelements = 2000\nlayers = 101".to_owned(),
        9 => "[solver]\nmax_step = 1e-6\nfirst_step = 1e-6\nmin_step = 1e-12".to_owned(),
        10 => "[output]\ncount = 1000".to_owned(),
        11 => "# comment\n".repeat(80_000),
        12 => "\n".repeat(500_000),
        13 => "[[compare]]\n".repeat(2_000),
        14 => {
            let points = many("[0, \"1 MPa\"]", 50_000);
            format!("[material.hardening.table]\nextrapolation = \"hold\"\npoints = [{points}]")
        }
        _ => format!("[material.hardening.piecewise_power]\nbranches = [{}]", many(branch, 5_000)),
    }
}
