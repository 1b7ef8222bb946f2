//! How names are printed, as the page on declarations describes it: a reading of its own, which shares nothing with the printer.

use std::collections::{BTreeMap, BTreeSet};

use super::token::Name;

/// The letters that are written out in Rust.
const LETTERS: [(&str, &str); 39] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("varepsilon", "ε"),
    ("vartheta", "ϑ"),
    ("varphi", "φ"),
    ("varrho", "ϱ"),
    ("ell", "ℓ"),
];
const ACCENTS: [(&str, &str); 4] = [
    ("hat", "\u{302}"),
    ("bar", "\u{304}"),
    ("tilde", "\u{303}"),
    ("prime", "′"),
];

fn letter(word: &str) -> &str {
    let known = LETTERS.iter().find(|(name, _)| *name == word);
    known.map_or(word, |(_, letter)| letter)
}

/// The name `theta_left` or `r[0].x` as it is printed, unless another one would be printed alike.
fn alone(name: &str, is_parameter: bool) -> String {
    let parts = name.split(|c: char| !c.is_alphanumeric());
    let mut parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    let Some(first) = parts.first().copied() else {
        return name.to_owned();
    };
    let stem = first.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.is_empty() {
        return name.to_owned();
    }
    let number = &first[stem.len()..];
    parts.remove(0);
    if !number.is_empty() {
        parts.insert(0, number);
    }
    let mut printed = match letter(stem) {
        "i" if is_parameter => "I".to_owned(),
        stem => stem.to_owned(),
    };
    let next = parts.first().copied();
    if let Some((_, sign)) = ACCENTS.iter().find(|(name, _)| next == Some(name)) {
        printed.push_str(sign);
        parts.remove(0);
    }
    Name {
        letter: printed,
        dots: 0,
        below: parts.into_iter().map(|part| letter(part).into()).collect(),
    }
    .written(&BTreeMap::new())
}

/// What names of a page are printed as: by letters, but for those of which the page says otherwise.
pub(super) struct Spelled {
    as_written: BTreeSet<String>,
}

impl Spelled {
    /// By what a page says: `l1, l_1 and pi are printed as in the declaration, since …`.
    pub(super) fn of(page: &str) -> Self {
        let sentence = " printed as in the declaration, since ";
        let lines = page.lines().filter_map(|line| line.split_once(sentence));
        let names = lines.flat_map(|(names, _)| {
            let names = names.trim_end_matches(" is").trim_end_matches(" are");
            names.split(", ").flat_map(|names| names.split(" and "))
        });
        Self {
            as_written: names.map(str::to_owned).collect(),
        }
    }

    /// What a name is printed as.
    pub(super) fn written(&self, name: &str, is_parameter: bool) -> String {
        if self.as_written.contains(name) {
            return name.to_owned();
        }
        alone(name, is_parameter)
    }
}
