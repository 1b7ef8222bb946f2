//! Equations in LaTeX, as the derive emits them, to `MathML`.
//!
//! The text consists of displays, `\begin{align*}` to `\end{align*}`, and of lines of words with formulas between dollars.

use std::error::Error;
use std::fmt;

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

use crate::markup::escaped;

const DISPLAY: [&str; 2] = ["\\begin{align*}", "\\end{align*}"];

/// A formula that cannot be converted.
#[derive(Debug)]
pub struct EquationError {
    formula: String,
    reason: String,
}

impl fmt::Display for EquationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the formula `{}` has no MathML: {}",
            self.formula, self.reason
        )
    }
}

impl Error for EquationError {}

/// Converts equations to HTML with `MathML`.
///
/// # Errors
///
/// A formula uses a command that is not known.
pub fn mathml(latex: &str) -> Result<String, EquationError> {
    let mut html = String::new();
    let mut rest = latex;
    while let Some(begin) = rest.find(DISPLAY[0]) {
        words(&mut html, &rest[..begin])?;
        let display = &rest[begin..];
        let end = display
            .find(DISPLAY[1])
            .map_or(display.len(), |end| end + DISPLAY[1].len());
        html.push_str(&formula(&display[..end], DisplayMode::Block)?);
        html.push('\n');
        rest = &display[end..];
    }
    words(&mut html, rest)?;
    Ok(html)
}

/// Adds lines of words, each a paragraph.
fn words(html: &mut String, text: &str) -> Result<(), EquationError> {
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        html.push_str("<p>");
        for (index, part) in line.split('$').enumerate() {
            if index % 2 == 1 {
                html.push_str(&formula(part, DisplayMode::Inline)?);
            } else {
                html.push_str(&escaped(&part.replace("--", "–").replace("\\_", "_")));
            }
        }
        html.push_str("</p>\n");
    }
    Ok(())
}

/// Groups the names of functions that have an exponent, `{\\cos}^{2}`: else the space before the name becomes the base.
fn grouped(latex: &str) -> String {
    const FUNCTIONS: [&str; 6] = ["sin", "cos", "tan", "sinh", "cosh", "tanh"];
    FUNCTIONS.iter().fold(latex.to_string(), |latex, name| {
        latex.replace(&format!("\\{name}^"), &format!("{{\\{name}}}^"))
    })
}

fn formula(latex: &str, display_mode: DisplayMode) -> Result<String, EquationError> {
    let failed = |reason: String| EquationError {
        formula: latex.to_string(),
        reason,
    };
    let storage = Storage::new();
    let grouped = grouped(latex);
    let events = Parser::new(&grouped, &storage)
        .collect::<Result<Vec<_>, _>>()
        .map_err(|error| failed(error.to_string()))?;
    let mut html = String::new();
    let config = RenderConfig {
        display_mode,
        ..RenderConfig::default()
    };
    let events = events.into_iter().map(Ok::<_, std::convert::Infallible>);
    push_mathml(&mut html, events, config).map_err(|error| failed(error.to_string()))?;
    Ok(html)
}
