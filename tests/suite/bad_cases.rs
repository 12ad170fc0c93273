//! Case files with something wrong in them: the error must name the key, the place and a remedy.
//!
//! `tests/bad_cases/cases.txt` has one row per case, `NAME | key | line:column | beginning of the remedy`, and below it what is
//! changed in `base/cup.toml`, as in a diff: `- ` takes a line out, `+ ` puts one in, `  ` names a line to go on from. A case
//! without changes stands whole in `NAME.toml`.

use crate::common::prelude::*;

/// Base with its changes; panics on a change that names no line after the last one.
fn patched(base: &str, patch: &[&str]) -> String {
    let mut rest = base.lines();
    let mut text = String::new();
    for change in patch {
        let (kind, line) = change.split_at_checked(2).unwrap_or((change, ""));
        let kind = kind.trim_end();
        if kind != "+" {
            text.extend(rest.by_ref().take_while(|next| *next != line).map(|next| format!("{next}\n")));
        }
        if kind != "-" {
            text += &format!("{line}\n");
        }
    }
    rest.fold(text, |text, line| text + line + "\n")
}

#[test]
fn broken_cases_name_key_place_and_remedy() {
    let base = fs::read_to_string("tests/bad_cases/base/cup.toml").expect("the base");
    assert!(case::parse(&base, "cup.toml", &[]).is_ok(), "the base itself is right");
    let table = fs::read_to_string("tests/bad_cases/cases.txt").expect("the table");
    let lines: Vec<&str> = table.lines().collect();
    let is_change = |line: &&str| line.is_empty() || line.starts_with(['+', '-', ' ']);
    let mut wrong = Vec::new();
    let rows: Vec<usize> = (0..lines.len()).filter(|i| !is_change(&lines[*i])).collect();
    assert!(rows.len() >= 230, "only {} broken cases", rows.len());
    for row in &rows {
        let cells: Vec<&str> = lines[*row].split(" | ").collect();
        let [name, key, place, remedy] = cells[..] else { panic!("{}", lines[*row]) };
        let patch: Vec<&str> = lines[row + 1..].iter().take_while(|line| is_change(line)).copied().collect();
        let path = format!("tests/bad_cases/{name}.toml");
        let answer = match patch.is_empty() {
            true => case::load(&path, &[]),
            false => case::parse(&patched(&base, &patch), &path, &[]),
        };
        let Err(error) = answer else {
            wrong.push(format!("{name} is accepted"));
            continue;
        };
        let found_place = error.position().map_or("-".into(), |(line, column)| format!("{line}:{column}"));
        let found_remedy = error.remedy().unwrap_or("");
        if error.key() != key || found_place != place || remedy.is_empty() || !found_remedy.starts_with(remedy) {
            wrong.push(format!("{name} | {} | {found_place} | {found_remedy}\n{}", error.key(), error.render(false)));
        }
    }
    assert!(wrong.is_empty(), "{} of {}\n{}", wrong.len(), rows.len(), wrong.join("\n"));
    let whole = rows.iter().filter(|row| lines.get(*row + 1).is_none_or(|line| !is_change(line))).count();
    assert_eq!(files("tests/bad_cases", "toml").len(), whole, "a case without its row");
}

#[test]
fn an_error_is_drawn_with_its_line_a_caret_and_the_remedy() {
    let text = "title = \"Cup\"\n[blank]\nthicknes = \"1 mm\"\n";
    let shown = case::parse(text, "cup.toml", &[]).expect_err("broken").render(false);
    let expected = "  × unknown key `thicknes` in [blank]\n   ╭─[cup.toml:3:1]\n 2 │ [blank]\n 3 │ thicknes = \"1 mm\"\n   \
                    · ────┬───\n   ·     ╰── blank.thicknes\n   ╰────\n  help: did you mean `thickness`? known keys: ";
    assert!(shown.starts_with(expected), "{shown}");
}
