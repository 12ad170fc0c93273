//! Says whether the page has been built (`web/build`), so that the program has it with it for `stampflow page`; the library
//! alone, which is in the page, does not ask.

use std::path::Path;

fn main() {
    let dist = Path::new("web/dist");
    println!("cargo::rustc-check-cfg=cfg(page)");
    // A path that is not there would have this run, and all be built, each time.
    let has_verbs = std::env::var_os("CARGO_FEATURE_CLI").is_some();
    println!("cargo::rerun-if-changed={}", if has_verbs && dist.is_dir() { "web/dist" } else { "build.rs" });
    if has_verbs && dist.join("page.html").is_file() {
        println!("cargo::rustc-cfg=page");
    }
}
