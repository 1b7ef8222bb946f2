//! Names in C.

use std::collections::BTreeSet;
use std::fmt::Write as _;

/// The keywords of C99 and of C++, which may include the header, and the words that some compilers add.
const KEYWORDS: [&str; 85] = [
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "class",
    "compl",
    "const",
    "const_cast",
    "constexpr",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "far",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "mutable",
    "namespace",
    "near",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "union",
    "unsigned",
    "using",
    "typeid",
    "typename",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
];

/// Greek letters by their names.
const GREEK: [(char, &str); 49] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ϵ', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('ς', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Α', "Alpha"),
    ('Β', "Beta"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Ε', "Epsilon"),
    ('Ζ', "Zeta"),
    ('Η', "Eta"),
    ('Θ', "Theta"),
    ('Ι', "Iota"),
    ('Κ', "Kappa"),
    ('Λ', "Lambda"),
    ('Μ', "Mu"),
    ('Ν', "Nu"),
    ('Ξ', "Xi"),
    ('Π', "Pi"),
    ('Ρ', "Rho"),
    ('Σ', "Sigma"),
    ('Τ', "Tau"),
    ('Φ', "Phi"),
    ('Χ', "Chi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
];

/// The name in letters that C99 has: Greek ones by their names, others by their code points.
fn in_ascii(name: &str) -> String {
    let mut written = String::new();
    for letter in name.chars() {
        let greek = GREEK.iter().find(|(greek, _)| *greek == letter);
        match greek {
            _ if letter.is_ascii() => written.push(letter),
            Some((_, name)) => written.push_str(name),
            // Writing to a `String` does not fail.
            None => {
                let _ = write!(written, "u{:04x}", u32::from(letter));
            }
        }
    }
    written
}

/// The name of a type as a prefix of functions: `CartPole` is `cart_pole`, `Arm6R` is `arm6_r`.
pub(super) fn snake_case(name: &str) -> String {
    let mut written = String::new();
    let mut before = '_';
    let name = in_ascii(name);
    let mut letters = name.chars().peekable();
    while let Some(letter) = letters.next() {
        let begins = letters.peek().is_some_and(char::is_ascii_lowercase);
        let ends = before.is_ascii_lowercase() || before.is_ascii_digit();
        if letter.is_ascii_uppercase() && before != '_' && (ends || begins) {
            written.push('_');
        }
        written.push(letter.to_ascii_lowercase());
        before = letter;
    }
    without_keyword(written)
}

fn without_keyword(mut name: String) -> String {
    if KEYWORDS.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// Names of one namespace, each of which is given once.
#[derive(Default)]
pub(super) struct Namespace(BTreeSet<String>);

impl Namespace {
    /// A name that is no keyword, and that nothing else has.
    pub(super) fn name(&mut self, name: &str) -> String {
        let mut name = without_keyword(in_ascii(name));
        while !self.0.insert(name.clone()) {
            name.push('_');
        }
        name
    }
}

#[cfg(test)]
mod tests {
    use super::{Namespace, snake_case};

    #[test]
    fn types_are_written_like_functions() {
        let pairs = [
            ("Bead", "bead"),
            ("CartPole", "cart_pole"),
            ("IIWAArm", "iiwa_arm"),
            ("Arm6R", "arm6_r"),
            ("Double", "double_"),
            ("Θ", "theta"),
        ];
        for (written, expected) in pairs {
            assert_eq!(snake_case(written), expected);
        }
    }

    #[test]
    fn names_are_distinct_and_no_keywords() {
        let mut names = Namespace::default();
        assert_eq!(names.name("int"), "int_");
        assert_eq!(names.name("θ"), "theta");
        assert_eq!(names.name("theta"), "theta_");
        assert_eq!(names.name("長"), "u9577");
    }
}
