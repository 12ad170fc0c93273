//! `stampflow page`: the page with the solver in it, as one file.

use super::code::{BadPath, BadRequest, Code};
use super::options::Json;
use super::place;
use super::say::{say, say_json};
use serde_json::json;
use stampflow::output::write;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
The page opens from the disk in any browser of today and asks nothing of any server: cases \
and drawings stay on the machine.

Examples:
  stampflow page
  stampflow page -o press-shop.html

Exit codes: 0 done, 2 this program was built without the page, or FILE cannot be written";

/// The page that was built before the program was.
#[cfg(page)]
const PAGE: Option<&[u8]> = Some(include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/web/dist/page.html")));
#[cfg(not(page))]
const PAGE: Option<&[u8]> = None;

/// What a page of any version of the program has in its head, and how far in that is looked for \[bytes\].
const TITLE: &str = "<title>stampflow</title>";
const HEAD: u64 = 4096;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// The file to write
    #[arg(long, short, alias = "output", value_name = "FILE.html", default_value = "page.html")]
    out: PathBuf,
    #[command(flatten)]
    json: Json,
}

pub fn page(args: &Args) -> anyhow::Result<Code> {
    let Some(page) = PAGE else {
        let what = "this program was built without the page; in the folder of its source `web/build` builds the page, and \
                    `cargo install --path .` the program with it";
        return Err(BadRequest(what.to_owned()).into());
    };
    let path = &args.out;
    place::file(path, &[], "--out")?;
    if path.symlink_metadata().is_ok() && !is_page(path) {
        let what = format!("{} is there already and no page of ours", path.display());
        return Err(BadPath { what, help: "choose another place with --out".to_owned(), path: path.clone() }.into());
    }
    write(path, page)?;
    match args.json.json {
        true => say_json(&json!({ "file": path, "bytes": page.len() })),
        false => say(format!("{}: {:.1} MB, opens in a browser", path.display(), 1e-6 * page.len() as f64)),
    }
}

fn is_page(path: &Path) -> bool {
    let mut head = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    path.is_file() && read.is_ok() && String::from_utf8_lossy(&head).contains(TITLE)
}
