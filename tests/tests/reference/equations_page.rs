//! The page of equations names tests that exist, and has the equations in the order of the text.

use std::fs;
use std::path::{Path, PathBuf};

/// The cells of the rows whose first cell is an equation.
fn rows(page: &str) -> Vec<Vec<&str>> {
    let rows = page.lines().filter(|line| line.starts_with("| ("));
    rows.map(|line| line.split('|').map(str::trim).collect())
        .collect()
}

/// What stands in backquotes.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// A file by its path from the root of the repository, or by its name alone: then it is in the folder of a theme of the library's
/// tests.
fn file_of(root: &Path, name: &str) -> PathBuf {
    if name.contains('/') {
        return root.join(name).with_extension("rs");
    }
    let themes = fs::read_dir(root.join("runtime/tests")).unwrap();
    let files = themes.map(|theme| theme.unwrap().path().join(name).with_extension("rs"));
    let mut found: Vec<_> = files.filter(|file| file.is_file()).collect();
    let file = found.pop().unwrap_or_else(|| panic!("no file {name}.rs"));
    assert!(found.is_empty(), "{name}.rs is in several folders");
    file
}

#[test]
fn the_checks_of_equations_are_tests() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = fs::read_to_string(root.join("docs/equations.md")).unwrap();
    let rows = rows(&page);
    assert!(rows.len() > 25, "{} rows", rows.len());
    for row in &rows {
        let [_, equation, _, place, check, _] = row[..] else {
            panic!("five bars in {row:?}");
        };
        assert!(!place.is_empty() && quoted(check).count() > 0, "{equation}");
        let mut file = String::new();
        for name in quoted(check) {
            let (of_file, test) = match name.split_once("::") {
                Some((of_file, test)) => (Some(of_file), Some(test)),
                // A test in the file named before, or a file of which all tests count.
                None if file.contains(&format!("fn {name}()")) => (None, Some(name)),
                None => (Some(name), None),
            };
            if let Some(of_file) = of_file {
                let path = file_of(&root, of_file);
                file =
                    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
            }
            if let Some(test) = test {
                assert!(
                    file.contains(&format!("#[test]\nfn {test}()")),
                    "{equation}: {test}"
                );
            }
        }
    }
}

#[test]
fn equations_are_in_the_order_of_the_text() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = fs::read_to_string(root.join("docs/equations.md")).unwrap();
    let number = |row: &Vec<&str>| -> Vec<u32> {
        let first = row[1].split('–').next().unwrap_or_default();
        let digits = first.trim_matches(['(', ')']).split('.');
        digits.map(|part| part.parse().unwrap()).collect()
    };
    let numbers: Vec<_> = rows(&page).iter().map(number).collect();
    assert!(numbers.is_sorted(), "{numbers:?}");
}
