//! The letters in which a name is printed.

use crate::print::index::Index;
use crate::print::notation::Notation;

/// A name taken apart: a letter or word, what is written above it, and what is written below the line behind it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Spelling {
    stem: String,
    accent: Option<Accent>,
    /// How many dots stand above it.
    pub(crate) dots: usize,
    pub(crate) indices: Vec<Index>,
}

/// What a name such as `x_hat` has above its letter. There is no dot, which is that of a velocity.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Accent {
    Hat,
    Bar,
    Tilde,
    Prime,
}

impl Accent {
    /// The accent, its name in Rust and in LaTeX, and the sign behind a letter in Unicode.
    const ALL: [(Self, &str, &str, char); 4] = [
        (Self::Hat, "hat", "\\hat", '\u{302}'),
        (Self::Bar, "bar", "\\bar", '\u{304}'),
        (Self::Tilde, "tilde", "\\tilde", '\u{303}'),
        (Self::Prime, "prime", "'", '′'),
    ];

    fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.into_iter();
        all.find(|(_, known, ..)| *known == name)
            .map(|(accent, ..)| accent)
    }

    const fn sign(self) -> char {
        Self::ALL[self as usize].3
    }

    /// The letter with the accent in LaTeX.
    fn latex(self, letter: &str) -> String {
        match self {
            Self::Prime => format!("{letter}'"),
            _ => format!("{}{{{letter}}}", Self::ALL[self as usize].2),
        }
    }
}

/// The letters that are no Latin ones: as names are written in Rust, in Unicode, and in LaTeX behind a backslash, whose
/// glyph is the one of Unicode: TeX sets `\phi` as ϕ and `\epsilon` as ϵ (unicode-math, Symbols defined by unicode-math).
const LETTERS: [(&str, char, &str); 41] = [
    ("alpha", 'α', "alpha"),
    ("beta", 'β', "beta"),
    ("gamma", 'γ', "gamma"),
    ("delta", 'δ', "delta"),
    ("epsilon", 'ε', "varepsilon"),
    ("zeta", 'ζ', "zeta"),
    ("eta", 'η', "eta"),
    ("theta", 'θ', "theta"),
    ("iota", 'ι', "iota"),
    ("kappa", 'κ', "kappa"),
    ("lambda", 'λ', "lambda"),
    ("mu", 'μ', "mu"),
    ("nu", 'ν', "nu"),
    ("xi", 'ξ', "xi"),
    ("pi", 'π', "pi"),
    ("rho", 'ρ', "rho"),
    ("sigma", 'σ', "sigma"),
    ("tau", 'τ', "tau"),
    ("upsilon", 'υ', "upsilon"),
    ("phi", 'φ', "varphi"),
    ("chi", 'χ', "chi"),
    ("psi", 'ψ', "psi"),
    ("omega", 'ω', "omega"),
    ("Gamma", 'Γ', "Gamma"),
    ("Delta", 'Δ', "Delta"),
    ("Theta", 'Θ', "Theta"),
    ("Lambda", 'Λ', "Lambda"),
    ("Xi", 'Ξ', "Xi"),
    ("Pi", 'Π', "Pi"),
    ("Sigma", 'Σ', "Sigma"),
    ("Upsilon", 'Υ', "Upsilon"),
    ("Phi", 'Φ', "Phi"),
    ("Psi", 'Ψ', "Psi"),
    ("Omega", 'Ω', "Omega"),
    ("varepsilon", 'ε', "varepsilon"),
    ("vartheta", 'ϑ', "vartheta"),
    ("varphi", 'φ', "varphi"),
    ("varrho", 'ϱ', "varrho"),
    ("ell", 'ℓ', "ell"),
    ("ϕ", 'ϕ', "phi"),
    ("ϵ", 'ϵ', "epsilon"),
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
        let mut parts: Vec<_> = number.into_iter().chain(parts).collect();
        let accent = parts.first().and_then(|part| Accent::named(part));
        if accent.is_some() {
            parts.remove(0);
        }
        let is_indexed = name.contains('[');
        let index = |part: &str| match part.parse() {
            Ok(number) if is_indexed => Index::Number(number),
            _ => Index::Word(letter(part)),
        };
        Self {
            stem: letter(stem),
            accent,
            dots: 0,
            indices: parts.into_iter().map(index).collect(),
        }
    }

    /// The same of a parameter, where `i` is a moment of inertia: books write I, which is no name of a field in Rust.
    pub(crate) fn of_parameter(name: &str) -> Self {
        let mut spelling = Self::of(name);
        if spelling.stem == "i" {
            spelling.stem = "I".into();
        }
        spelling
    }

    /// What stands on the line, without accents.
    pub(crate) fn stem(&self) -> String {
        self.stem.clone()
    }

    /// A name that is printed as it is written.
    pub(crate) fn verbatim(name: &str) -> Self {
        Self {
            stem: name.into(),
            accent: None,
            dots: 0,
            indices: Vec::new(),
        }
    }

    /// The name with dots above it.
    pub(crate) fn with_dots(self, dots: usize) -> Self {
        Self { dots, ..self }
    }

    /// The name with further indices behind it.
    pub(crate) fn with_indices(mut self, indices: impl IntoIterator<Item = Index>) -> Self {
        self.indices.extend(indices);
        self
    }

    /// Whether the name is longer than a letter with numbers and letters below the line, so that it
    /// would run into its neighbours.
    pub(crate) fn is_word(&self) -> bool {
        let has_word = self.indices.iter().any(Index::is_word);
        has_word || self.stem.chars().count() != 1
    }

    /// By how many characters the indices of a family are longer to read than they are.
    pub(crate) fn reading_of_indices(&self) -> usize {
        let is_number = |index: &&Index| matches!(index, Index::Number(_));
        2 * self.indices.iter().filter(is_number).count()
    }

    /// The name as it is read.
    pub(crate) fn print(&self, notation: Notation) -> String {
        match notation {
            Notation::Unicode => self.unicode(),
            Notation::Latex => self.latex(),
        }
    }

    fn unicode(&self) -> String {
        let mut text = self.stem.clone();
        let prime = self.accent == Some(Accent::Prime);
        let accent = self.accent.map(Accent::sign);
        text.extend(accent.filter(|_| !prime));
        // Above the last letter of a word they would belong to that letter.
        let signs = if self.stem.chars().count() == 1 {
            ['\u{307}', '\u{308}']
        } else {
            ['˙', '¨']
        };
        if let Some(last) = self.dots.checked_sub(1) {
            text.push(signs[last.min(1)]);
        }
        text.extend(accent.filter(|_| prime));
        let mut before = 0;
        for index in &self.indices {
            let lowered = index.lowered();
            // Single digits and letters follow one another; what is longer is set apart.
            let length = lowered.as_ref().map_or(0, |text| text.chars().count());
            let apart = before > 0 && length > 0 && before.max(length) > 1;
            text.push_str(if apart { "," } else { "" });
            text.push_str(&lowered.unwrap_or_else(|| index.behind_line()));
            before = length;
        }
        text
    }

    fn latex(&self) -> String {
        let mut text = latex_letter(&self.stem);
        let accent = self.accent.filter(|accent| *accent != Accent::Prime);
        if let Some(accent) = accent {
            text = accent.latex(&text);
        }
        text = match self.dots {
            0 => text,
            1 => format!("\\dot{{{text}}}"),
            _ => format!("\\ddot{{{text}}}"),
        };
        if self.accent == Some(Accent::Prime) {
            text = Accent::Prime.latex(&text);
        }
        if !self.indices.is_empty() {
            let parts: Vec<_> = self.indices.iter().map(Index::latex).collect();
            text.extend(["_{", &parts.join(","), "}"]);
        }
        text
    }
}

/// The letter that a word spells, or the word.
fn letter(word: &str) -> String {
    LETTERS
        .iter()
        .find(|(name, ..)| *name == word)
        .map_or_else(|| word.into(), |(_, letter, _)| letter.to_string())
}

/// A letter or a word in LaTeX.
pub(crate) fn latex_letter(word: &str) -> String {
    let greek = LETTERS
        .iter()
        .find(|(_, letter, _)| word.chars().eq([*letter]))
        .map(|(.., latex)| format!("\\{latex}"));
    let index = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-');
    let mut neighbours = word.chars().zip(word.chars().skip(1));
    let is_name = neighbours.any(|(c, next)| c.is_alphabetic() && next.is_ascii_digit());
    let letters = word.chars().filter(|c| !index(*c)).count();
    let plain = !word.contains('_') && letters <= 1 && !is_name;
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
            ("c_phi", 0, "c_φ", "c_{\\varphi}"),
            ("varepsilon", 1, "ε\u{307}", "\\dot{\\varepsilon}"),
            ("ϕ_1", 0, "ϕ₁", "\\phi_{1}"),
            (
                "alpha_left",
                1,
                "α\u{307}_left",
                "\\dot{\\alpha}_{\\mathrm{left}}",
            ),
            ("mass", 0, "mass", "\\mathrm{mass}"),
            ("arm2_x", 0, "arm₂_x", "\\mathrm{arm}_{2,x}"),
            ("angle", 1, "angle˙", "\\dot{\\mathrm{angle}}"),
            ("theta[3]", 0, "θ₃", "\\theta_{3}"),
            ("m[(0, 1)]", 0, "m₀₁", "m_{0,1}"),
            ("m[10][2]", 0, "m₁₀,₂", "m_{10,2}"),
            ("r#type", 0, "type", "\\mathrm{type}"),
            ("θ", 0, "θ", "\\theta"),
            ("_0", 0, "_0", "\\mathrm{\\_0}"),
            ("x_hat", 0, "x\u{302}", "\\hat{x}"),
            ("theta_bar_1", 0, "θ\u{304}₁", "\\bar{\\theta}_{1}"),
            ("x_tilde", 1, "x\u{303}\u{307}", "\\dot{\\tilde{x}}"),
            ("l_prime", 0, "l′", "l'"),
            ("x1_prime", 0, "x₁_prime", "x_{1,\\mathrm{prime}}"),
            ("q_prime", 1, "q\u{307}′", "\\dot{q}'"),
            ("x_dot", 0, "x_dot", "x_{\\mathrm{dot}}"),
            ("vartheta", 2, "ϑ\u{308}", "\\ddot{\\vartheta}"),
            ("ell_0", 0, "ℓ₀", "\\ell_{0}"),
            ("mu_k", 0, "μ_k", "\\mu_{k}"),
            ("Delta_l", 0, "Δ_l", "\\Delta_{l}"),
        ] {
            let spelling = Spelling::of(name).with_dots(dots);
            assert_eq!(spelling.print(Notation::Unicode), unicode);
            assert_eq!(spelling.print(Notation::Latex), latex);
        }
    }

    #[test]
    fn moments_of_inertia_are_capitals() {
        for (name, unicode) in [
            ("i", "I"),
            ("i1", "I₁"),
            ("i_1", "I₁"),
            ("i_s", "I_s"),
            ("i_xx", "I_xx"),
            ("i[2]", "I₂"),
            ("I_s", "I_s"),
            ("inertia", "inertia"),
            ("input", "input"),
            ("j1", "j₁"),
        ] {
            let printed = Spelling::of_parameter(name).print(Notation::Unicode);
            assert_eq!(printed, unicode);
        }
        assert_eq!(Spelling::of("i1").print(Notation::Unicode), "i₁");
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
