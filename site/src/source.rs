//! The source text of a model: what its documentation says, and its declaration.

use std::fmt::Write as _;

use crate::markup::escaped;

/// The parts of the file of a model.
#[derive(Clone, Debug)]
pub struct Source {
    /// The documentation of the struct in HTML, without its example.
    pub words: String,
    /// The declaration: from its attribute to the end of the struct.
    pub declaration: String,
}

/// Reads the file of a model.
#[must_use]
pub fn read(text: &str) -> Source {
    let lines = text.lines().filter_map(|line| line.strip_prefix("///"));
    let (mut paragraphs, mut paragraph, mut is_code) = (Vec::new(), String::new(), false);
    for line in lines.map(str::trim) {
        if line.starts_with("```") {
            is_code = !is_code;
        } else if line.is_empty() {
            paragraphs.push(std::mem::take(&mut paragraph));
        } else if !is_code {
            paragraph.push_str(line);
            paragraph.push(' ');
        }
    }
    paragraphs.push(paragraph);
    let mut words = String::new();
    for paragraph in paragraphs.iter().map(|paragraph| paragraph.trim()) {
        if !paragraph.is_empty() {
            let _ = writeln!(words, "<p>{}</p>", spans(paragraph));
        }
    }
    let begin = text.find("#[derive(Lagrangian").unwrap_or_default();
    let declaration = &text[begin..];
    let end = declaration
        .find("\n}\n")
        .map_or(declaration.len(), |end| end + 2);
    Source {
        words,
        declaration: declaration[..end].to_string(),
    }
}

/// Markdown of words in HTML: code, emphasis, and escaped brackets.
fn spans(text: &str) -> String {
    let mut html = String::new();
    for (index, part) in text.split('`').enumerate() {
        let part = escaped(part);
        if index % 2 == 1 {
            let _ = write!(html, "<code>{part}</code>");
        } else {
            let part = part
                .replace("\\[", "[")
                .replace("\\]", "]")
                .replace("**", "");
            for (index, part) in part.split('*').enumerate() {
                let _ = if index % 2 == 1 {
                    write!(html, "<em>{part}</em>")
                } else {
                    write!(html, "{part}")
                };
            }
        }
    }
    html
}
