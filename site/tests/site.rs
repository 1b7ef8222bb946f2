//! The site is complete, its links lead somewhere, and it is written the same twice.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use lagrangian_exhibits::exhibits;
use lagrangian_site::{Files, Recording, mathml, pages, recordings};

static RECORDINGS: LazyLock<Vec<Recording>> = LazyLock::new(recorded);
static PAGES: LazyLock<Files> = LazyLock::new(|| written(&RECORDINGS));

fn recorded() -> Vec<Recording> {
    recordings().expect("all motions are integrated")
}

fn written(recordings: &[Recording]) -> Files {
    pages(recordings).expect("the site is written")
}

/// What is compiled, and not in the files of the test.
const COMPILED: [&str; 2] = ["browser.js", "browser_bg.wasm"];

fn text(name: &str) -> &'static str {
    let content = PAGES
        .get(name)
        .unwrap_or_else(|| panic!("{name} is missing"));
    std::str::from_utf8(content).expect("text")
}

#[test]
fn each_model_has_its_page_and_its_card() {
    for exhibit in exhibits() {
        let slug = exhibit.about().slug;
        let page = text(&format!("models/{slug}.html"));
        for part in ["<svg", "<math", "#[derive(Lagrangian", "Values"] {
            assert!(page.contains(part), "{slug} has no {part}");
        }
        assert!(text("index.html").contains(&format!("href=\"models/{slug}.html\"")));
        assert!(text(&format!("equations/{slug}.html")).contains("<math"));
    }
}

/// The exhibits are all models of the crate.
#[test]
fn no_model_is_left_out() {
    let library = include_str!("../../models/src/lib.rs");
    let models = library
        .lines()
        .filter(|line| line.starts_with("pub use "))
        .count();
    assert_eq!(models, exhibits().len());
}

#[test]
fn all_equations_have_mathml() {
    for exhibit in exhibits() {
        let html = mathml(exhibit.latex())
            .unwrap_or_else(|error| panic!("{}: {error}", exhibit.about().slug));
        assert!(
            !html.contains("<msup><mspace") && !html.contains("merror") && !html.contains('\\'),
            "{}",
            exhibit.about().slug
        );
    }
    assert!(mathml("\\begin{align*}\nx &= \\unknown\n\\end{align*}").is_err());
}

#[test]
fn links_lead_to_files_of_the_site() {
    let known: BTreeSet<&str> = PAGES.keys().map(String::as_str).chain(COMPILED).collect();
    let mut count = 0;
    for name in PAGES.keys().filter(|name| !name.starts_with("equations/")) {
        let page = text(name);
        let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
        for start in ["href=\"", "src=\"", "from \"./"] {
            for link in page.split(start).skip(1) {
                let link = link.split(['"', '#']).next().unwrap_or_default();
                if link.is_empty() || link.starts_with("data:") {
                    continue;
                }
                let path = link.strip_prefix("../").map_or_else(
                    || {
                        if folder.is_empty() {
                            link.to_string()
                        } else {
                            format!("{folder}/{link}")
                        }
                    },
                    str::to_string,
                );
                assert!(known.contains(path.as_str()), "{name} links to {link}");
                count += 1;
            }
        }
        assert!(
            !page.contains("https://") && !page.contains("http://"),
            "{name} needs a network"
        );
    }
    assert!(count > 100);
}

#[test]
fn the_site_is_written_the_same_twice() {
    assert!(written(&recorded()) == *PAGES);
}

#[test]
fn energy_is_kept() {
    for (exhibit, recording) in exhibits().into_iter().zip(RECORDINGS.iter()) {
        assert!(
            recording.energy_error < 1e-10,
            "{}: {:e}",
            exhibit.about().slug,
            recording.energy_error
        );
    }
}
