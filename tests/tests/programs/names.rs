//! Every public name of the version before `docs/renamed.md` is still there, or the page says what it has become.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn text(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The names of the `pub use` of a file.
fn exported(source: &str) -> BTreeSet<String> {
    let uses = source.split("pub use ").skip(1);
    let lists = uses.map(|list| list.split(';').next().unwrap_or_default());
    let names = lists.flat_map(|list| list.split(|c: char| !c.is_alphanumeric() && c != '_'));
    names.map(str::to_owned).collect()
}

/// What stands in backquotes in the first column of the table.
fn renamed(page: &str) -> BTreeSet<String> {
    let rows = page.lines().filter(|line| line.starts_with("| "));
    let first = rows.filter_map(|row| row[2..].split(" | ").next());
    let quoted = first.flat_map(|cell| cell.split('`').skip(1).step_by(2));
    let words = quoted.flat_map(|code| code.split(|c: char| !c.is_alphanumeric() && c != '_'));
    words.map(str::to_owned).collect()
}

#[test]
fn no_name_is_lost() {
    let files = [
        "runtime/src/lib.rs",
        "lagrangian/src/lib.rs",
        "lagrangian/src/prelude.rs",
    ];
    let exported = exported(&files.map(text).concat());
    let renamed = renamed(&text("docs/renamed.md"));
    let earlier = text("tests/data/public_names.txt");
    assert_eq!(earlier.lines().count(), 136);
    let lost: Vec<&str> = earlier
        .lines()
        .filter(|name| !exported.contains(*name) && !renamed.contains(*name))
        .collect();
    assert!(lost.is_empty(), "{lost:?}");
}
