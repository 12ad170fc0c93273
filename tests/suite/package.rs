//! What the package says of itself: the Rust it needs, its features, what is in it.

use crate::common::prelude::*;

/// What the code itself asks of Rust: 1.89 brought `File::try_lock`.
const CODE: (u32, u32) = (1, 89);

fn output(program: &str, args: &[&str]) -> String {
    let done = Command::new(program).args(args).output().unwrap_or_else(|e| panic!("{program}: {e}"));
    assert!(done.status.success(), "{program} {args:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).expect("text")
}

/// The first two numbers of "1.89.0".
fn version(text: &str) -> (u32, u32) {
    let mut numbers = text.split('.').map(|n| n.parse().unwrap_or_else(|_| panic!("{text}: no version")));
    (numbers.next().expect("a number"), numbers.next().unwrap_or(0))
}

/// Trust: what each dependency of the resolved graph declares for this machine, and no more than the largest of it, so that
/// the number is neither too low nor a mere habit.
#[test]
fn the_declared_rust_version_is_what_code_and_dependencies_need() {
    let host = output("rustc", &["-vV"]);
    let host = host.lines().find_map(|line| line.strip_prefix("host: ")).expect("a host");
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    let args = ["metadata", "--format-version", "1", "--offline", "--locked", "--filter-platform", host];
    let text = output(env!("CARGO"), &[&args[..], &["--manifest-path", manifest]].concat());
    let metadata: Value = serde_json::from_str(&text).expect("JSON");
    let (mut declared, mut needed) = (None, (CODE, "the code"));
    for package in metadata["packages"].as_array().expect("packages") {
        let Some(rust) = package["rust_version"].as_str().map(version) else { continue };
        let name = package["name"].as_str().expect("a name");
        if name == env!("CARGO_PKG_NAME") {
            declared = Some(rust);
        } else if rust > needed.0 {
            needed = (rust, name);
        }
    }
    assert_eq!(declared, Some(needed.0), "rust-version in Cargo.toml, and what {} needs", needed.1);
}

/// Trust: what a build, docs.rs and the licences ask for; and names of what none of them does.
#[test]
fn the_package_holds_what_building_needs_and_no_more() {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    let list = output(env!("CARGO"), &["package", "--list", "--allow-dirty", "--offline", "--manifest-path", manifest]);
    let files: BTreeSet<&str> = list.lines().collect();
    let roots: BTreeSet<&str> = files.iter().map(|file| file.split('/').next().expect("a name")).collect();
    let known = ".cargo_vcs_info.json CHANGELOG.md CITATION.cff Cargo.lock Cargo.toml Cargo.toml.orig LICENSE-APACHE \
                 LICENSE-MIT README.md assets cases examples reference_data src";
    let own = "assets/DejaVuSans-LICENSE.txt assets/DejaVuSans-subset.ttf cases/quickstart.toml src/lib.rs src/main.rs";
    assert!(own.split(' ').all(|file| files.contains(file)), "{files:?}");
    assert_eq!(roots, known.split(' ').filter(|name| !name.starts_with('.') || roots.contains(name)).collect());
    let read = ".rs .toml .csv .dxf .ttf .txt .md .cff .lock .json .css .js .orig -MIT -APACHE";
    for file in &files {
        assert!(!file.ends_with("/tests.rs"), "{file} is a test");
        assert!(read.split(' ').any(|ending| file.ends_with(ending)), "{file}: neither source nor data");
    }
}
