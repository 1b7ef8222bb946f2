//! The files of the site, but for those that are compiled.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;

use lagrangian_exhibits::exhibits;

use crate::equations::mathml;
use crate::figure::{drawing, style};
use crate::markup::{escaped, page};
use crate::model_page::model_page;
use crate::recording::Recording;

/// Files by their paths.
pub type Files = BTreeMap<String, Vec<u8>>;

/// The files of the page in the browser.
const PAGE: [(&str, &str); 7] = [
    ("style.css", include_str!("../page/style.css")),
    ("play.html", include_str!("../page/play.html")),
    ("play.js", include_str!("../page/play.js")),
    ("eye.js", include_str!("../page/eye.js")),
    ("painter.js", include_str!("../page/painter.js")),
    ("plots.js", include_str!("../page/plots.js")),
    ("sliders.js", include_str!("../page/sliders.js")),
];

/// Writes the gallery with the recorded motions, and the page in the browser without what is compiled to WebAssembly.
///
/// # Errors
///
/// An equation has no `MathML`.
pub fn pages(recordings: &[Recording]) -> Result<Files, Box<dyn Error>> {
    let mut files = Files::new();
    let mut cards = String::new();
    for (exhibit, recording) in exhibits().into_iter().zip(recordings) {
        let about = exhibit.about();
        let (slug, title, sentence) = (about.slug, escaped(about.title), escaped(about.sentence));
        let picture = drawing(recording, about.title, about.view, [340.0, 250.0]);
        write!(
            cards,
            "<li><a class=\"card\" href=\"models/{slug}.html\">\n{picture}<div class=\"words\"><h2>{title}</h2><p>{sentence}</p></div></a></li>\n"
        )?;
        files.insert(
            format!("models/{slug}.html"),
            model_page(exhibit, recording)?.into_bytes(),
        );
        files.insert(
            format!("equations/{slug}.html"),
            mathml(exhibit.latex())?.into_bytes(),
        );
    }
    let content = format!(
        "<h1>Ready models</h1>\n<p class=\"lead\">Each of these mechanical systems is declared by its energies in a few lines of Rust; its \
         equations of motion are derived at compile time. <a href=\"play.html\">Play with them in the browser</a>.</p>\n\
         <ul class=\"cards\">\n{cards}</ul>\n"
    );
    files.insert(
        "index.html".to_string(),
        page("", "Gallery", &content).into_bytes(),
    );
    files.insert("figures.css".to_string(), style().into_bytes());
    for (name, content) in PAGE {
        files.insert(name.to_string(), content.as_bytes().to_vec());
    }
    Ok(files)
}
