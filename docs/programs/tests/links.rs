//! Links, images and includes of the pages lead to files of the repository, anchors to headings, and the book contains
//! every page.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::{Component, Path, PathBuf};
use std::{env, fs};

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

/// The root of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .expect("the package is two folders below the root")
        .into()
}

/// What a page refers to, and what others may refer to.
#[derive(Debug, Default)]
struct Page {
    /// The targets of links and images.
    links: Vec<String>,
    /// The targets of `{{#include …}}`, in code, too.
    includes: Vec<String>,
    /// The anchors of headings, as mdBook and GitHub make them.
    anchors: BTreeSet<String>,
}

impl Page {
    fn read(path: &Path) -> Self {
        let text =
            fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        Self::parse(&text)
    }

    fn parse(text: &str) -> Self {
        let mut page = Self::default();
        let mut heading: Option<String> = None;
        let mut count: HashMap<String, usize> = HashMap::new();
        for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
            match event {
                Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                    page.links.push(dest_url.into_string());
                }
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => {
                    let anchor = anchor(&heading.take().unwrap_or_default());
                    let seen = count.entry(anchor.clone()).or_default();
                    page.anchors.insert(match *seen {
                        0 => anchor,
                        n => format!("{anchor}-{n}"),
                    });
                    *seen += 1;
                }
                Event::Text(text) | Event::Code(text) => {
                    page.includes.extend(includes(&text));
                    if let Some(heading) = &mut heading {
                        heading.push_str(&text);
                    }
                }
                _ => {}
            }
        }
        page
    }
}

/// The anchor of a heading: lower case, without punctuation, with hyphens for spaces.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter_map(|c| match c {
        ' ' => Some('-'),
        '-' | '_' => Some(c),
        _ => c.is_alphanumeric().then_some(c),
    });
    kept.collect::<String>().to_lowercase()
}

/// The arguments of `{{#include …}}` in a text.
fn includes(text: &str) -> impl Iterator<Item = String> {
    let parts = text.split("{{#include ").skip(1);
    parts.filter_map(|part| Some(part.split_once("}}")?.0.trim().to_owned()))
}

/// All Markdown files whose links are checked, relative to the root.
fn pages() -> Vec<PathBuf> {
    let root = root();
    let mut pages = vec![];
    for name in [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
    ] {
        pages.push(root.join(name));
    }
    let folders = entries(&root)
        .into_iter()
        .map(|path| path.join("README.md"));
    pages.extend(folders.filter(|path| path.is_file()));
    pages.extend(markdown(&root.join("docs")));
    pages
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("folders are read");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("folders are read").path())
        .collect();
    paths.sort();
    paths
}

/// The Markdown files in a folder and its folders.
fn markdown(folder: &Path) -> Vec<PathBuf> {
    let mut found = vec![];
    for path in entries(folder) {
        if path.is_dir() {
            found.extend(markdown(&path));
        } else if path.extension().is_some_and(|ending| ending == "md") {
            found.push(path);
        }
    }
    found
}

/// The path without `.` and `..`, so that one file has one path.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                plain.pop();
            }
            Component::CurDir => {}
            part => plain.push(part),
        }
    }
    plain
}

/// What is wrong with a link of a page, if something is.
fn check_link(from: &Path, link: &str, all: &mut BTreeMap<PathBuf, Page>) -> Option<String> {
    if link.contains("://") || link.starts_with("mailto:") {
        return None;
    }
    let (path, fragment) = link.split_once('#').unwrap_or((link, ""));
    let folder = from.parent().expect("a file is in a folder");
    let target = if path.is_empty() {
        from.to_owned()
    } else {
        plain(&folder.join(path))
    };
    if !target.starts_with(root()) {
        return Some("leads out of the repository".to_owned());
    }
    if !target.exists() {
        return Some("leads to no file".to_owned());
    }
    if fragment.is_empty() || target.extension().is_none_or(|ending| ending != "md") {
        return None;
    }
    let page = all
        .entry(target.clone())
        .or_insert_with(|| Page::read(&target));
    (!page.anchors.contains(fragment)).then(|| "leads to no heading".to_owned())
}

/// What is wrong with an include of a page, if something is: `FILE`, `FILE:LINES` or `FILE:ANCHOR`.
fn check_include(from: &Path, include: &str) -> Option<String> {
    let (path, part) = include.split_once(':').unwrap_or((include, ""));
    let folder = from.parent().expect("a file is in a folder");
    let Ok(text) = fs::read_to_string(folder.join(path)) else {
        return Some("includes no file".to_owned());
    };
    let is_anchor = part.starts_with(|c: char| c.is_alphabetic());
    let has = |mark: &str| {
        text.lines()
            .any(|line| line.trim().ends_with(&format!("{mark}: {part}")))
    };
    (is_anchor && !(has("ANCHOR") && has("ANCHOR_END")))
        .then(|| "includes no anchor of this name".to_owned())
}

#[test]
fn links_and_includes_lead_to_files_and_headings() {
    let paths = pages();
    let mut all: BTreeMap<_, _> = BTreeMap::new();
    let mut wrong = vec![];
    for path in &paths {
        let page = Page::read(path);
        let links = page.links.iter();
        let found = links.filter_map(|link| Some((link, check_link(path, link, &mut all)?)));
        let mut found: Vec<_> = found.collect();
        let parts = page.includes.iter();
        found.extend(parts.filter_map(|part| Some((part, check_include(path, part)?))));
        let path = path.strip_prefix(root()).unwrap_or(path);
        wrong.extend(
            found
                .iter()
                .map(|(link, error)| format!("{}: {link} {error}", path.display())),
        );
    }
    assert!(paths.len() > 15, "the pages are found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_book_contains_every_page() {
    let docs = root().join("docs");
    let summary = docs.join("SUMMARY.md");
    let links = Page::read(&summary).links;
    let listed: BTreeSet<_> = links.iter().map(|link| docs.join(link)).collect();
    let mut found: BTreeSet<_> = markdown(&docs).into_iter().collect();
    found.remove(&summary);
    let missing: Vec<_> = found.difference(&listed).collect();
    assert!(missing.is_empty(), "not in SUMMARY.md: {missing:?}");
    assert_eq!(listed.len(), links.len(), "a page is listed twice");
}

#[test]
fn anchors_are_those_of_the_renderers() {
    let page = Page::parse("# The `taylor` clause, (4.6)\n\n## One_two\n\n## One_two\n");
    let expected = ["the-taylor-clause-46", "one_two", "one_two-1"];
    assert_eq!(page.anchors, expected.map(str::to_owned).into());
}
