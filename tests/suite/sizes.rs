//! Sizes that hardly fit a stamping are doubted by `check` and by `new`, by one set of rules.

use crate::common::files::files;
use stampflow::assess::SIZE_CHECKS;
use stampflow::case;

/// What is shipped has the sizes of stampings.
#[test]
fn no_shipped_case_is_doubted() {
    let cases = files("cases", "toml");
    assert!(cases.len() > 10);
    for path in cases {
        let case = case::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
        let doubts: Vec<_> = SIZE_CHECKS.iter().filter_map(|check| check(case.model())).collect();
        assert!(doubts.is_empty(), "{}: {doubts:?}", path.display());
    }
}
