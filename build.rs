//! Says whether the page has been built (`web/build`), so that the program has it with it for `stampflow page`.

use std::path::Path;

fn main() {
    let dist = Path::new("web/dist");
    println!("cargo::rustc-check-cfg=cfg(page)");
    // A path that is not there would have this run, and all be built, each time.
    println!("cargo::rerun-if-changed={}", if dist.is_dir() { "web/dist" } else { "build.rs" });
    if dist.join("page.html").is_file() {
        println!("cargo::rustc-cfg=page");
    }
}
