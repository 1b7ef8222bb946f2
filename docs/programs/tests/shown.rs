//! What the pages show of programs, outputs and messages is what the files contain.
//!
//! A comment in front of a fenced block names the file, relative to the page, and the part of it: all of it, the part between
//! `// ANCHOR: name` and `// ANCHOR_END: name`, or lines:
//!
//! ```text
//! <!-- shown: ../programs/src/bin/watch.rs:model -->
//! <!-- shown: ../programs/output/watch.txt -->
//! <!-- shown: ../../tests/compile_errors/ui/names/unknown_coordinate.rs:3:13 -->
//! ```
//!
//! `OUTPUT=overwrite cargo test -p lagrangian-guide` writes the blocks anew.

use std::path::{Path, PathBuf};
use std::{env, fs};

/// The folder of the pages.
fn docs() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package
        .parent()
        .expect("the package is in the folder of the pages")
        .into()
}

fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder is read") {
        let path = entry.expect("the entry is read").path();
        let is_of_programs = path.ends_with("docs/programs");
        if path.is_dir() && !is_of_programs {
            pages(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "md") {
            found.push(path);
        }
    }
}

/// The part of a file that a comment names.
fn part(page: &Path, name: &str) -> String {
    let mut words = name.split(':');
    let file = page.with_file_name(words.next().unwrap_or_default());
    let text =
        fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let parts: Vec<&str> = words.collect();
    let lines: Vec<&str> = match parts.as_slice() {
        [] => text.lines().collect(),
        [anchor] => {
            let [begin, end] = ["ANCHOR", "ANCHOR_END"].map(|word| format!("// {word}: {anchor}"));
            let mut lines = text.lines().skip_while(|line| line.trim() != begin).skip(1);
            let part: Vec<_> = lines
                .by_ref()
                .take_while(|line| line.trim() != end)
                .collect();
            assert!(
                !part.is_empty(),
                "{}: there is no part {anchor}",
                file.display()
            );
            part
        }
        [first, last] => {
            let [first, last] =
                [first, last].map(|number| number.parse::<usize>().expect("a number of a line"));
            text.lines().take(last).skip(first - 1).collect()
        }
        _ => panic!("{}: {name} names no part", page.display()),
    };
    let lines = lines
        .into_iter()
        .filter(|line| !line.trim().starts_with("// ANCHOR"));
    let text = lines.collect::<Vec<_>>().join("\n");
    text.trim_end().to_owned()
}

/// The page with all blocks as the files have them, and how many there are.
fn written(page: &Path, text: &str) -> (String, usize) {
    let (mut lines, mut count) = (Vec::new(), 0);
    let mut rest = text.lines();
    while let Some(line) = rest.next() {
        lines.push(line.to_owned());
        let name = line
            .strip_prefix("<!-- shown: ")
            .and_then(|name| name.strip_suffix(" -->"));
        let Some(name) = name else { continue };
        let fence = rest.next().unwrap_or_default();
        assert!(
            fence.starts_with("```"),
            "{}: no block behind {line}",
            page.display()
        );
        lines.extend([fence.to_owned(), part(page, name), "```".to_owned()]);
        assert!(
            rest.by_ref().any(|line| line == "```"),
            "{}: {name} has no end",
            page.display()
        );
        count += 1;
    }
    (lines.join("\n") + "\n", count)
}

#[test]
fn pages_show_what_files_contain() {
    let overwrite = env::var_os("OUTPUT").is_some_and(|value| value == "overwrite");
    let mut found = Vec::new();
    pages(&docs(), &mut found);
    let mut count = 0;
    for page in found {
        let text = fs::read_to_string(&page).expect("the page is read");
        let (expected, of_page) = written(&page, &text);
        count += of_page;
        if overwrite && text != expected {
            fs::write(&page, &expected).expect("the page is written");
        } else if !overwrite {
            let page = page.display();
            assert!(
                text == expected,
                "{page} shows something else: OUTPUT=overwrite writes it"
            );
        }
    }
    assert!(count > 40, "{count} blocks are shown");
}
