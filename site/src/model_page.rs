//! The page of one model.

use std::error::Error;
use std::fmt::Write as _;

use lagrangian_exhibits::{About, Exhibit, Group};

use crate::equations::mathml;
use crate::figure::drawing;
use crate::markup::{escaped, page};
use crate::plot::plot;
use crate::recording::Recording;
use crate::source::read;

/// Writes the page of a model.
pub(crate) fn model_page(
    exhibit: &dyn Exhibit,
    recording: &Recording,
) -> Result<String, Box<dyn Error>> {
    let about = exhibit.about();
    let source = read(about.source);
    let equations = mathml(exhibit.latex())?;
    let (title, sentence, slug) = (escaped(about.title), escaped(about.sentence), about.slug);
    let content = format!(
        "<h1>{title}</h1>\n<p class=\"lead\">{sentence}</p>\n<p><a class=\"button primary\" href=\"../play.html#{slug}\">Play with it</a></p>\n\
         <div class=\"model\">\n<figure class=\"card drawing\">\n{}</figure>\n<section class=\"card\" aria-labelledby=\"motion\">\n\
         <h2 id=\"motion\">Motion</h2>\n<figure>{}</figure>\n<p>{}</p>\n</section>\n\
         <section class=\"card\" aria-labelledby=\"words\">\n<h2 id=\"words\">The model</h2>\n{}</section>\n\
         <section class=\"card\" aria-labelledby=\"values\">\n<h2 id=\"values\">Values</h2>\n{}</section>\n\
         <section class=\"card wide\" aria-labelledby=\"equations\">\n<h2 id=\"equations\">Equations</h2>\n\
         <div class=\"equations\" tabindex=\"0\" role=\"group\" aria-labelledby=\"equations\">\n{equations}</div>\n</section>\n\
         <section class=\"card wide\" aria-labelledby=\"declaration\">\n<h2 id=\"declaration\">Declaration</h2>\n\
         <pre tabindex=\"0\"><code>{}</code></pre>\n</section>\n</div>\n",
        drawing(recording, about.title, about.view, [560.0, 460.0]),
        plot(about, recording),
        facts(exhibit, recording),
        source.words,
        values(about),
        escaped(&source.declaration),
    );
    Ok(page("../", about.title, &content))
}

/// What the integration took and how exact it is.
fn facts(exhibit: &dyn Exhibit, recording: &Recording) -> String {
    let balance = if exhibit.is_driven() {
        "energy, less the work of what drives it,"
    } else {
        "energy"
    };
    let error = if recording.energy_error == 0.0 {
        "0".to_string()
    } else {
        format!("{:.0e}", recording.energy_error).replace('-', "−")
    };
    format!(
        "<code>Taylor</code> takes {} steps. At the end the {balance} differs from that at the start by {error} of the largest \
         kinetic energy.",
        recording.steps
    )
}

/// The values with which the exhibit opens.
fn values(about: &About) -> String {
    let mut rows = String::new();
    for quantity in about.quantities {
        let value = match (quantity.is_switch(), quantity.value > 0.5) {
            (true, true) => "on".to_string(),
            (true, false) => "off".to_string(),
            _ => format!("{} {}", quantity.value, quantity.unit).replace('-', "−"),
        };
        let group = match quantity.group {
            Group::Parameter => "parameter",
            Group::Start => "start",
            Group::Control => "control",
        };
        let _ = writeln!(
            rows,
            "<tr><th scope=\"row\">{}</th><td>{group}</td><td>{}</td></tr>",
            escaped(quantity.name),
            escaped(value.trim())
        );
    }
    format!("<table>\n<tbody>\n{rows}</tbody>\n</table>\n")
}
