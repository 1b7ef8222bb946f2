//! The letters in which a name is printed.

use crate::print::folding::token::MARKS;
use crate::print::notation::{Notation, subscript};

/// A name taken apart: a letter or word, and what is written below the line behind it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Spelling {
    stem: String,
    subscripts: Vec<String>,
    /// Whether its numbers are indices of a family.
    is_indexed: bool,
}

/// The Greek letters that differ from Latin ones, as names are written in Rust. LaTeX has the same
/// names behind a backslash.
const GREEK: [(&str, char); 34] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

impl Spelling {
    /// Takes a name apart: `theta_left` is θ and `left`, `x12` is x and 12, `m[0]` is m and 0.
    pub(crate) fn of(name: &str) -> Self {
        let name = name.strip_prefix("r#").unwrap_or(name);
        let mut parts = name
            .split(|c: char| !c.is_alphanumeric())
            .filter(|part| !part.is_empty());
        let Some(first) = parts.next() else {
            return Self::verbatim(name);
        };
        let stem = first.trim_end_matches(|c: char| c.is_ascii_digit());
        if stem.is_empty() {
            return Self::verbatim(name);
        }
        let number = Some(&first[stem.len()..]).filter(|digits| !digits.is_empty());
        Self {
            stem: letter(stem),
            subscripts: number.into_iter().chain(parts).map(letter).collect(),
            is_indexed: name.contains('['),
        }
    }

    /// A name that is printed as it is written.
    pub(crate) fn verbatim(name: &str) -> Self {
        Self {
            stem: name.into(),
            subscripts: Vec::new(),
            is_indexed: false,
        }
    }

    /// Whether the name is longer than a letter with numbers and letters below the line, so that it
    /// would run into its neighbours.
    pub(crate) fn is_word(&self) -> bool {
        let number = |text: &String| text.chars().all(|c| c.is_ascii_digit());
        let letter = |text: &String| text.chars().count() == 1;
        !letter(&self.stem)
            || !self
                .subscripts
                .iter()
                .all(|part| number(part) || letter(part))
    }

    /// The name with dots above it, with [marks](crate::print::folding::token::MARKS) around its indices.
    pub(crate) fn print_marked(&self, dots: usize, notation: Notation) -> String {
        if !self.is_indexed {
            return self.print(dots, notation);
        }
        let stem = Self {
            subscripts: Vec::new(),
            ..self.clone()
        };
        let mut text = stem.print(dots, notation);
        let is_number = |part: &String| part.chars().all(|c| c.is_ascii_digit());
        let mut parts = Vec::new();
        for part in &self.subscripts {
            parts.push(match notation {
                _ if is_number(part) => format!("{}{part}{}", MARKS[0], MARKS[1]),
                Notation::Unicode => format!("_{part}"),
                Notation::Latex => latex_letter(part),
            });
        }
        match notation {
            Notation::Unicode => text.push_str(&parts.concat()),
            Notation::Latex => text.extend(["_{", &parts.join(","), "}"]),
        }
        text
    }

    /// The name with dots above it.
    pub(crate) fn print(&self, dots: usize, notation: Notation) -> String {
        match notation {
            Notation::Unicode => self.unicode(dots),
            Notation::Latex => self.latex(dots),
        }
    }

    fn unicode(&self, dots: usize) -> String {
        let mut text = self.stem.clone();
        match dots {
            0 => {}
            1 => text.push('\u{307}'),
            _ => text.push('\u{308}'),
        }
        let mut previous_digits = 0;
        for part in &self.subscripts {
            let digits = part.chars().all(|c| c.is_ascii_digit());
            if digits {
                // Single digits follow one another as indices do; longer numbers are set apart.
                let apart = previous_digits > 0 && previous_digits.max(part.len()) > 1;
                text.push_str(if apart { "," } else { "" });
                text.push_str(&subscript(part));
            } else {
                text.push('_');
                text.push_str(part);
            }
            previous_digits = if digits { part.len() } else { 0 };
        }
        text
    }

    fn latex(&self, dots: usize) -> String {
        let stem = latex_letter(&self.stem);
        let mut text = match dots {
            0 => stem,
            1 => format!("\\dot{{{stem}}}"),
            _ => format!("\\ddot{{{stem}}}"),
        };
        if !self.subscripts.is_empty() {
            let parts: Vec<_> = self
                .subscripts
                .iter()
                .map(|part| latex_letter(part))
                .collect();
            text.extend(["_{", &parts.join(","), "}"]);
        }
        text
    }
}

/// The Greek letter that a word spells, or the word.
fn letter(word: &str) -> String {
    GREEK
        .iter()
        .find(|(name, _)| *name == word)
        .map_or_else(|| word.into(), |(_, letter)| letter.to_string())
}

fn latex_letter(word: &str) -> String {
    let greek = GREEK
        .iter()
        .find(|(_, letter)| word.chars().eq([*letter]))
        .map(|(name, _)| format!("\\{name}"));
    let plain = word.chars().all(|c| c.is_ascii_digit()) || word.chars().count() == 1;
    greek.unwrap_or_else(|| {
        if plain {
            word.into()
        } else {
            format!("\\mathrm{{{}}}", word.replace('_', "\\_"))
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_letters() {
        for (name, dots, unicode, latex) in [
            ("theta", 0, "θ", "\\theta"),
            ("theta", 1, "θ\u{307}", "\\dot{\\theta}"),
            ("x1", 1, "x\u{307}₁", "\\dot{x}_{1}"),
            ("x12", 2, "x\u{308}₁₂", "\\ddot{x}_{12}"),
            ("I_1", 0, "I₁", "I_{1}"),
            ("Omega", 0, "Ω", "\\Omega"),
            ("c_phi", 0, "c_φ", "c_{\\phi}"),
            (
                "alpha_left",
                1,
                "α\u{307}_left",
                "\\dot{\\alpha}_{\\mathrm{left}}",
            ),
            ("mass", 0, "mass", "\\mathrm{mass}"),
            ("arm2_x", 0, "arm₂_x", "\\mathrm{arm}_{2,x}"),
            ("angle", 1, "angle\u{307}", "\\dot{\\mathrm{angle}}"),
            ("theta[3]", 0, "θ₃", "\\theta_{3}"),
            ("m[(0, 1)]", 0, "m₀₁", "m_{0,1}"),
            ("m[10][2]", 0, "m₁₀,₂", "m_{10,2}"),
            ("r#type", 0, "type", "\\mathrm{type}"),
            ("θ", 0, "θ", "\\theta"),
            ("_0", 0, "_0", "\\mathrm{\\_0}"),
        ] {
            let spelling = Spelling::of(name);
            assert_eq!(spelling.print(dots, Notation::Unicode), unicode);
            assert_eq!(spelling.print(dots, Notation::Latex), latex);
        }
    }

    #[test]
    fn words_are_longer_than_a_letter() {
        assert!(
            ["mass", "x_left", "arm1"]
                .iter()
                .all(|name| Spelling::of(name).is_word())
        );
        assert!(
            !["m", "theta", "i1", "x_12", "c_phi", "x_a"]
                .iter()
                .any(|name| Spelling::of(name).is_word())
        );
    }
}
