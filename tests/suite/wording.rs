//! Case files and templates in the words of a shop: diameters, thicknesses of the sheet, other names of tools and keys.

use crate::common::cup::{LAW, MINIMAL};
use stampflow::author::templates::{self, TEMPLATES};
use stampflow::case::{self, Case};

fn parsed(text: &str, overrides: &[&str]) -> Result<Case, String> {
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    case::parse(text, "case.toml", &overrides).map_err(|error| error.render(false))
}

fn read(text: &str, overrides: &[&str]) -> Case {
    parsed(text, overrides).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// The smallest cup with a piece of its text in other words.
fn cup(replaced: &[(&str, &str)]) -> String {
    replaced.iter().fold(MINIMAL.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    })
}

const ACROSS: [(&str, &str); 4] = [
    ("radius = \"55 mm\"", "diameter = \"110 mm\""),
    ("{ radius = \"30 mm\"", "{ diameter = \"60 mm\""),
    ("throat = \"31.25 mm\"", "throat_diameter = \"62.5 mm\""),
    ("inner_radius = \"32 mm\"", "inner_diameter = \"64 mm\""),
];

/// Trust: twice is exact in binary, so the models are the same to the last bit.
#[test]
fn a_round_part_is_the_same_across_as_from_its_axis() {
    let plain = read(MINIMAL, &[]);
    for (i, pair) in ACROSS.iter().enumerate() {
        assert_eq!(read(&cup(&[*pair]), &[]).model(), plain.model(), "{i}");
    }
    assert_eq!(read(&cup(&ACROSS), &[]).model(), plain.model());
    let dome = |shape: &str| cup(&[("flat = { radius = \"30 mm\", nose = \"6 mm\" }", shape)]);
    let [across, radius] = ["hemispherical = { diameter = \"60 mm\" }", "hemispherical = { radius = \"30 mm\" }"]
        .map(|s| read(&dome(s), &[]));
    assert_eq!(across.model(), radius.model());
    let beads = |key: &str| cup(&[]) + &format!("[[tools.beads]]\n{key}\nrestraining = \"20 N/mm\"\n");
    assert_eq!(
        read(&beads("diameter = \"90 mm\""), &[]).model().beads,
        read(&beads("at = \"45 mm\""), &[]).model().beads
    );
}

#[test]
fn a_diameter_beside_its_radius_is_refused_with_both_lines() {
    let both =
        parsed(&cup(&[("radius = \"55 mm\"", "radius = \"55 mm\"\ndiameter = \"110 mm\"")]), &[]).expect_err("both");
    assert!(both.contains("both `radius` (line 4) and `diameter` (line 5) are given"), "{both}");
    assert!(both.contains("case.toml:5:1") && both.contains("blank.diameter"), "{both}");
    // Another word beside a diameter is named as it was written.
    let both =
        parsed(&cup(&[("throat = \"31.25 mm\"", "throat = \"31 mm\", opening = \"62 mm\"")]), &[]).expect_err("both");
    assert!(both.contains("`throat` (line 10) and `opening` (line 10)"), "{both}");
    let bare = parsed(&cup(&[("radius = \"55 mm\"", "diameter = 110")]), &[]).expect_err("no unit");
    assert!(bare.contains("`diameter`: 110 needs a unit") && bare.contains("blank.diameter"), "{bare}");
    let typo = parsed(&cup(&[("radius = \"55 mm\"", "diamter = \"110 mm\"")]), &[]).expect_err("unknown");
    assert!(typo.contains("did you mean `diameter`?"), "{typo}");
}

#[test]
fn a_strip_has_no_diameter() {
    let strip = templates::find("hat-section").and_then(|hat| hat.fill(&[])).unwrap_or_else(|e| panic!("{e}"));
    for (table, key, instead) in [
        ("blank", "diameter", "half_length"),
        ("tools.holder", "inner_diameter", "inner_half_width"),
        ("tools.die", "opening", "throat"),
    ] {
        let error = parsed(&strip, &[&format!("{table}.{key}=80 mm")]).expect_err(key);
        assert!(
            error.contains(&format!("`{key}` is of a round part")) && error.contains(&format!("write {instead}")),
            "{error}"
        );
    }
}

#[test]
fn an_override_replaces_what_says_the_same() {
    for (set, length) in
        [("blank.diameter=100 mm", 50.0), ("blank.radius=51 mm", 51.0), ("sheet.diameter=100 mm", 50.0)]
    {
        for text in [MINIMAL.to_owned(), cup(&ACROSS)] {
            assert_eq!(read(&text, &[set]).model().blank.length, length, "{set}\n{text}");
        }
    }
    let shop = cup(&[("holder =", "binder =")]);
    let force = |set: &str| read(&shop, &[set]).model().tools[2].motion.clone();
    assert_eq!(force("tools.binder.force=20 kN"), force("tools.holder.force=20 kN"));
    assert_eq!(force("tools.blank_holder.bhf=20 kN"), force("tools.holder.force=20 kN"));
}

/// Trust: six times 1 mm is 6 mm; 1.25 t beside a sheet of 0.8 mm is 1 mm.
#[test]
fn thicknesses_of_the_sheet_are_lengths() {
    let multiples = cup(&[("nose = \"6 mm\"", "nose = \"6 t\""), ("shoulder = \"6 mm\"", "shoulder = \"6t\"")]);
    assert_eq!(read(&multiples, &[]).model(), read(MINIMAL, &[]).model());
    let thin = read(&multiples, &["blank.thickness=0.8 mm"]);
    let plain = read(MINIMAL, &["blank.thickness=0.8 mm", "tools.punch.flat.nose=4.8 mm", "tools.die.shoulder=4.8 mm"]);
    assert_eq!(thin.model().tools[0].profile.pieces().len(), plain.model().tools[0].profile.pieces().len());
    for (a, b) in thin.model().tools.iter().zip(&plain.model().tools) {
        assert!((a.profile.first() - b.profile.first()).norm() < 1e-9, "{:?}", a.role);
    }
    let itself = parsed(&cup(&[("thickness = \"1 mm\"", "thickness = \"1 t\"")]), &[]).expect_err("itself");
    assert!(itself.contains("thicknesses of the sheet, and here no sheet is known"), "{itself}");
    let none =
        parsed(&cup(&[("thickness = \"1 mm\"\n", ""), ("\"6 mm\" }, f", "\"6 t\" }, f")]), &[]).expect_err("none");
    assert!(none.contains("`thickness` is missing") || none.contains("no sheet is known"), "{none}");
    // What is for people stays as it is.
    assert_eq!(read(&cup(&[("\"Cup\"", "\"6 t\"")]), &[]).model().title, "6 t");
}

#[test]
fn words_of_shops_are_read_and_noted() {
    let shop = cup(&[
        ("[blank]", "[sheet]"),
        ("thickness =", "gauge ="),
        ("punch = {", "Stempel = {"),
        ("die = {", "matrix = {"),
        ("holder = {", "blank_holder = {"),
        ("nose =", "corner_radius ="),
        ("travel =", "stroke ="),
        ("throat = \"31.25 mm\"", "die_opening = \"62.5 mm\""),
        ("friction = 0.08 }", "mu = 0.08 }"),
    ]);
    let case = read(&shop, &[]);
    assert_eq!(case.model(), read(MINIMAL, &[]).model());
    let note = case.derived[0].to_string();
    for said in ["sheet as blank", "Stempel as punch", "matrix as die", "blank_holder as holder", "stroke as travel"] {
        assert!(note.starts_with("read ") && note.contains(said), "{said}: {note}");
    }
    let twice = parsed(&cup(&[("holder =", "binder = { force = \"1 kN\" }\nholder =")]), &[]).expect_err("twice");
    assert!(twice.contains("`binder` is another word for `holder`, and both are given"), "{twice}");
    let wrong = parsed(&cup(&[("holder = { inner_radius = \"32 mm\"", "binder = { inner_radius = \"32 kN\"")]), &[]);
    assert!(wrong.expect_err("no length").contains("tools.binder.inner_radius"));
}

#[test]
fn every_radius_of_a_round_template_may_be_a_diameter() {
    let mut tried = 0;
    for template in TEMPLATES {
        for choice in template.options() {
            let round = choice.key.ends_with("-radius") || choice.key == "opening";
            assert_eq!(choice.diameter.is_some(), round, "{} --{}", template.name, choice.key);
            let Some(diameter) = choice.diameter else { continue };
            let [across, radius] = [(diameter, "84 mm"), (choice.key, "42 mm")].map(|given| template.fill(&[given]));
            assert_eq!(across.expect("a case"), radius.expect("a case"), "{} --{diameter}", template.name);
            let both = template.fill(&[(choice.key, "42 mm"), (diameter, "84 mm")]).expect_err("both").to_string();
            assert!(both.contains(&format!("--{} and --{diameter} are both given", choice.key)), "{both}");
            tried += 1;
        }
    }
    assert!(tried >= 7, "{tried}");
    let cup = templates::find("cup").unwrap_or_else(|e| panic!("{e}"));
    let given = |nose: &'static str| [("thickness", "0.8 mm"), ("nose", nose), ("trim", "5 %")];
    assert_eq!(cup.fill(&given("5 t")).expect("a case"), cup.fill(&given("4 mm")).expect("a case"));
}

/// Trust: the hardening and r̄ of another material, to the last bit.
#[test]
fn another_sheet_takes_the_place_of_all_of_the_material() {
    let own = cup(&[(
        LAW,
        "[material]\nsource = \"a coil\"\nanisotropy = 1.6\nyoung = \"210 GPa\"\npoisson = 0.3\n[material.hardening]\nswift = { k = \"520 MPa\", n = 0.22, offset = 0.005 }\n",
    )]);
    let named = read(&cup(&[(LAW, "[material]\nname = \"aa6016-t4\"\n")]), &[]);
    let replaced = read(&own, &["material=\"aa6016-t4\""]);
    assert_eq!(replaced.model().material, named.model().material);
    assert_eq!(replaced.sources.material, named.sources.material);
    let besides = read(&own, &["material=aa6016-t4", "material.anisotropy=0.7"]);
    assert_eq!(besides.model().material.hardening, named.model().material.hardening);
    assert_eq!(besides.model().material.yield_criterion.ratio(), 0.7);
    // How metal answers is not of the sheet.
    let elastic = own.replace("poisson = 0.3", "poisson = 0.3\nmode = \"elasto_viscoplastic\"");
    assert_eq!(read(&elastic, &["material=DC04"]).model().mode, stampflow::model::Mode::ElastoViscoplastic);

    let warned = |text: &str, set: &[&str]| {
        let warnings = stampflow::assess::check::report(&read(text, set)).warnings;
        warnings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    assert!(!warned(&own, &["material=aa6016-t4"]).contains("two sheets"));
    let law = cup(&[(
        LAW,
        "[material]\nsource = \"a coil\"\n[material.hardening]\nswift = { k = \"520 MPa\", n = 0.22, offset = 0.005 }\n",
    )]);
    let mixed = warned(&law, &["material.name=aa6016-t4"]);
    assert!(
        mixed.contains("the hardening of this case goes with r̄ = 0.363 of aa6016-t4: numbers of two sheets"),
        "{mixed}"
    );
    let mixed = warned(&own, &["material=ap04xr", "material.anisotropy=1.4"]);
    assert!(mixed.contains("the hardening of ap04xr goes with r̄ = 1.4 of this case"), "{mixed}");
    // 1 mm of a sheet of 0.67 to 0.712 mm.
    assert!(
        mixed
            .replace('\u{a0}', " ")
            .contains("of ap04xr are of sheet of 0.67 mm to 0.712 mm; this blank is 1 mm thick"),
        "{mixed}"
    );
    assert!(!warned(&own, &["material=ap04xr", "blank.thickness=0.7 mm"]).contains("thick"));
}
