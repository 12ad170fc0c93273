//! Case files with something wrong in them, and the message that each must give.
//!
//! `tests/bad_cases/NAME.txt` is what is changed in `base/cup.toml`, a line `---`, and the message. A change is written as in a
//! diff: `- ` takes a line out, `+ ` puts one in, `  ` names a line to go on from; the rest stays.
//!
//! ```text
//!   [tools.die]
//! + bumper = "1 mm"
//! - shoulder = "6 mm"
//! ---
//!   × ...
//! ```
//!
//! Where little of the cup would be left, the case stands whole in `NAME.toml`, and its message alone in `NAME.txt`.
//! `UPDATE=1 cargo test --test suite bad_cases::` writes the messages anew: look at the difference before you keep it.

use crate::common::files::files;
use stampflow::case;
use std::fs;

const END: &str = "---\n";

/// The base with its changes; what names a line that is not there, or not after the last one, is wrong.
fn patched(base: &str, patch: &str) -> Result<String, String> {
    let mut rest = base.lines();
    let mut text = String::new();
    for change in patch.lines() {
        let (kind, line) = change.split_at_checked(2).unwrap_or((change, ""));
        if kind.trim_end() != "+" {
            loop {
                let next = rest.next().ok_or(format!("no line {line:?} here in the base"))?;
                if next == line {
                    break;
                }
                text += &format!("{next}\n");
            }
        }
        match kind.trim_end() {
            "+" | "" => text += &format!("{line}\n"),
            "-" => {}
            _ => return Err(format!("{change:?} begins with neither \"+ \" nor \"- \" nor two spaces")),
        }
    }
    Ok(rest.fold(text, |text, line| text + line + "\n"))
}

#[test]
fn broken_cases_give_the_expected_messages() {
    let base = fs::read_to_string("tests/bad_cases/base/cup.toml").expect("the base");
    assert!(case::parse(&base, "cup.toml", &[]).is_ok(), "the base itself is right");
    let update = std::env::var_os("UPDATE").is_some();
    let (mut wrong, mut whole) = (Vec::new(), 0);
    let expectations = files("tests/bad_cases", "txt");
    assert!(expectations.len() >= 200, "only {} broken cases", expectations.len());
    for path in &expectations {
        let (name, stored) = (path.with_extension("toml"), fs::read_to_string(path).expect("readable"));
        let (patch, expected, answer) = if name.exists() {
            whole += 1;
            ("", stored.as_str(), case::load(&name, &[]))
        } else {
            let at = stored.find(END).unwrap_or_else(|| panic!("{}: no line ---", path.display())) + END.len();
            let (patch, expected) = stored.split_at(at);
            let text = patched(&base, &patch[..at - END.len()]).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            (patch, expected, case::parse(&text, &name.to_string_lossy(), &[]))
        };
        let found = answer.map_or_else(|error| error.render(false), |_| "this case is accepted\n".to_owned());
        if update {
            fs::write(path, format!("{patch}{found}")).unwrap();
        }
        if found != expected || found == "this case is accepted\n" {
            wrong.push(format!("{}\nfound:\n{found}expected:\n{expected}", path.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert_eq!(files("tests/bad_cases", "toml").len(), whole, "a case without its message");
}
