//! A line for every key of a case, as messages propose it: the schema's first example of each. They stand in a file of their
//! own, for a program without the schema says them too.

/// `path = value`, in alphabetical order; of lists the keys of the first entry, `stages.0.trim`.
const LINES: &str = include_str!("examples.txt");

/// The line that would set the key at a dotted path: `thickness = "0.9 mm"`.
pub(super) fn example_line(path: &str) -> Option<String> {
    let key = path.rsplit('.').next()?;
    let of_first = |name| if is_index(name) { "0" } else { name };
    let path = path.split('.').map(of_first).collect::<Vec<_>>().join(".");
    let value = LINES.lines().find_map(|line| line.strip_prefix(path.as_str())?.strip_prefix(" = "))?;
    Some(format!("{key} = {value}"))
}

/// Whether a part of a path counts the entries of a list.
pub(super) fn is_index(name: &str) -> bool {
    name.parse::<usize>().is_ok()
}
