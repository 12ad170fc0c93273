//! The reader against that of the TOML crate.

use super::*;
use crate::case::CaseFile;
use serde::Deserialize;

type Read = Result<String, (String, Option<Span>)>;

/// What a text says by this reader, and by that of the TOML crate.
fn by_both(text: &str) -> [Read; 2] {
    let table = DeTable::parse(text).expect("TOML");
    let own = read::<CaseFile>(table.get_ref());
    let theirs = CaseFile::deserialize(toml::de::Deserializer::from(table.clone()));
    [
        own.map(|file| format!("{file:?}")).map_err(|error| (error.message().to_owned(), error.span())),
        theirs.map(|file| format!("{file:?}")).map_err(|error| (error.message().to_owned(), error.span())),
    ]
}

/// Trust: the deserializer of the TOML crate.
#[test]
fn every_shipped_case_is_read_as_by_the_toml_crate() {
    let mut count = 0;
    for entry in std::fs::read_dir("cases").expect("the cases") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let [own, theirs] = by_both(&std::fs::read_to_string(&path).expect("text"));
            assert_eq!(own, theirs, "{}", path.display());
            count += 1;
        }
    }
    assert!(count > 15, "only {count} cases");
}

/// Trust: the same; message and place.
#[test]
fn what_is_wrong_is_said_as_by_the_toml_crate() {
    let base = "title = \"A\"\ngeometry = \"axisymmetric\"\n";
    for wrong in [
        "",
        "[blank]\nradius = [1]\nthickness = \"1 mm\"\n",
        "[blank]\nradius = \"1 mm\"\nthickness = \"1 mm\"\nelements = 1.5\n",
        "[blank]\nradius = \"1 mm\"\nthickness = \"1 mm\"\nelements = -1\n",
        "[blank]\nradius = \"1 mm\"\nthickness = \"1 furlong\"\n",
        "[blank]\nradius = \"1 mm\"\nthickness = \"1 mm\"\nwidht = 1\n",
        "[solver]\niteration = \"newtn\"\n",
        "[solver]\nmax_step = true\n",
        "blank = 3\n",
        "notes = [\"a\", 2]\n",
    ] {
        let [own, theirs] = by_both(&format!("{base}{wrong}"));
        assert!(own.is_err(), "{wrong:?} is accepted");
        assert_eq!(own, theirs, "{wrong:?}");
    }
}

/// By the TOML crate its values would be the fields in their order.
#[test]
fn an_array_is_no_table() {
    let text = "title = \"A\"\ngeometry = \"axisymmetric\"\nblank = [\"60 mm\", \"1 mm\"]\n";
    let [own, _] = by_both(text);
    let (message, span) = own.expect_err("refused");
    assert_eq!(message, "invalid type: sequence, expected struct Blank");
    assert_eq!(&text[span.expect("its place")], "[\"60 mm\", \"1 mm\"]");
}
