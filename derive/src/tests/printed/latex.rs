//! Displays of LaTeX taken apart.

use super::token::{Characters, FUNCTIONS, Name, OF_SEVERAL, Token};
use super::value::Reading;

/// The letters behind a backslash whose glyphs, as TeX sets them, are these.
const LETTERS: [(&str, char); 39] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ϵ'),
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
    ("phi", 'ϕ'),
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
    ("varepsilon", 'ε'),
    ("vartheta", 'ϑ'),
    ("varphi", 'φ'),
    ("varrho", 'ϱ'),
    ("ell", 'ℓ'),
];
const ACCENTS: [(&str, char); 3] = [("hat", '\u{302}'), ("tilde", '\u{303}'), ("bar", '\u{304}')];

/// The parts of a formula.
pub(super) fn tokens(text: &str) -> Reading<Vec<Token>> {
    let mut characters = Characters { rest: text };
    let mut tokens = Vec::new();
    let mut adjacent = false;
    while let Some(c) = characters.peek() {
        if c.is_whitespace() {
            characters.take_while(char::is_whitespace);
            adjacent = false;
            continue;
        }
        let is_space = characters.next_is("\\,");
        token(&mut characters, c, adjacent, &mut tokens)?;
        adjacent = !is_space;
    }
    Ok(tokens)
}

fn open() -> Token {
    Token::Open { adjacent: false }
}

/// A group in braces as the tokens of a bracket.
fn group(characters: &mut Characters<'_>) -> Reading<Vec<Token>> {
    if !characters.take("{") {
        return Err(format!("a brace is missing before {}", characters.rest));
    }
    let inner = tokens(characters.take_group(['{', '}'])?)?;
    Ok([vec![open()], inner, vec![Token::Close]].concat())
}

fn token(
    characters: &mut Characters<'_>,
    c: char,
    adjacent: bool,
    tokens: &mut Vec<Token>,
) -> Reading<()> {
    let after_bracket = adjacent && matches!(tokens.last(), Some(Token::Close | Token::Bar));
    if characters.take("\\frac{d}{dt}") {
        tokens.push(Token::Rate);
    } else if characters.take("\\frac") {
        let above = group(characters)?;
        let below = group(characters)?;
        tokens.push(open());
        tokens.extend(above);
        tokens.push(Token::Slash);
        tokens.extend(below);
        tokens.push(Token::Close);
    } else if characters.take("\\sqrt") {
        tokens.push(Token::Root);
        tokens.extend(group(characters)?);
    } else if characters.take("^{T}") {
        tokens.push(Token::Transposed);
    } else if characters.take("^") {
        tokens.push(Token::Caret);
        tokens.extend(group(characters)?);
    } else if c == '_' && after_bracket {
        characters.take("_");
        let axis = characters.take_while(|c| "xyz".contains(c));
        tokens.push(Token::Component("xyz".find(axis).ok_or("no axis")?));
    } else if characters.take("\\sum_") {
        tokens.push(sum(characters)?);
    } else if c.is_ascii_digit() {
        tokens.push(Token::Number(characters.number()?));
    } else if characters.take("\\,") {
    } else if let Some(token) = sign(characters, adjacent) {
        tokens.push(token);
    } else {
        tokens.push(name(characters)?);
    }
    Ok(())
}

/// Brackets and operators.
fn sign(characters: &mut Characters<'_>, adjacent: bool) -> Option<Token> {
    let signs = [
        ("\\left(", Token::Open { adjacent }),
        ("\\right)", Token::Close),
        ("\\bigl(", Token::Open { adjacent }),
        ("\\bigr)", Token::Close),
        ("(", Token::Open { adjacent }),
        (")", Token::Close),
        ("\\left|", Token::Bar),
        ("\\right|", Token::Bar),
        ("\\left[", Token::OpenSquare),
        ("\\right]", Token::CloseSquare),
        ("\\cdot", Token::Dot),
        ("\\times", Token::Cross),
        (",", Token::Comma),
        ("+", Token::Plus),
        ("-", Token::Minus),
        ("/", Token::Slash),
    ];
    let mut signs = signs.into_iter();
    let found = signs.find(|(text, _)| characters.take(text));
    found.map(|(_, token)| token)
}

/// `{j=0}^{9}`, `{j \ne i}`, or `j` alone.
fn sum(characters: &mut Characters<'_>) -> Reading<Token> {
    if !characters.take("{") {
        let variable = characters.take_while(char::is_alphabetic);
        return Ok(Token::SumOfLinks(variable.to_owned()));
    }
    let below = characters.take_group(['{', '}'])?;
    if let Some((variable, but)) = below.split_once(" \\ne ") {
        return Ok(Token::SumOfOthers {
            variable: variable.to_owned(),
            but: but.to_owned(),
        });
    }
    let (variable, first) = below.split_once('=').ok_or("a sum without a lower bound")?;
    if !characters.take("^{") {
        return Err("a sum without an upper bound".into());
    }
    let last = characters.take_group(['{', '}'])?;
    let bounds = [first, last].map(|bound| bound.replace("\\m", "m"));
    Ok(Token::Sum {
        variable: variable.to_owned(),
        bounds,
    })
}

/// A name with what is above and below it, or a function.
fn name(characters: &mut Characters<'_>) -> Reading<Token> {
    let (letter, dots) = letter(characters)?;
    let mut name = Name {
        letter,
        dots,
        below: Vec::new(),
    };
    while characters.take("'") {
        name.letter.push('′');
    }
    let is_function = FUNCTIONS.contains(&&*name.letter) || OF_SEVERAL.contains(&&*name.letter);
    if is_function && dots == 0 && !characters.next_is("_") {
        return Ok(Token::Function(name.letter));
    }
    if characters.take("_") {
        let below = if characters.take("{") {
            characters.take_group(['{', '}'])?
        } else {
            let (first, rest) = characters.rest.split_at(1);
            characters.rest = rest;
            first
        };
        name.below = parts(below)?;
    }
    Ok(Token::Name(name))
}

/// A letter or word with its accents, and how many dots there are above it.
fn letter(characters: &mut Characters<'_>) -> Reading<(String, usize)> {
    if !characters.take("\\") {
        let mut rest = characters.rest.chars();
        let first = rest.next().ok_or("a letter is missing")?;
        if !first.is_alphabetic() {
            return Err(format!("what is {}?", characters.rest));
        }
        characters.rest = rest.as_str();
        return Ok((first.into(), 0));
    }
    let command = characters.take_while(|c| c.is_ascii_alphabetic());
    match command {
        "mathrm" | "operatorname" => Ok((within(characters)?.replace("\\_", "_"), 0)),
        "dot" | "ddot" => {
            let mut inner = Characters {
                rest: within(characters)?,
            };
            let (letter, _) = letter(&mut inner)?;
            Ok((letter, if command == "dot" { 1 } else { 2 }))
        }
        _ => {
            if let Some((_, accent)) = ACCENTS.iter().find(|(name, _)| *name == command) {
                let mut inner = Characters {
                    rest: within(characters)?,
                };
                let (letter, _) = letter(&mut inner)?;
                return Ok((format!("{letter}{accent}"), 0));
            }
            let greek = LETTERS.iter().find(|(name, _)| *name == command);
            Ok((greek.map_or(command.to_owned(), |(_, c)| c.to_string()), 0))
        }
    }
}

/// What stands in the braces that are next.
fn within<'a>(characters: &mut Characters<'a>) -> Reading<&'a str> {
    if !characters.take("{") {
        return Err(format!("a brace is missing before {}", characters.rest));
    }
    characters.take_group(['{', '}'])
}

/// What stands below the line, one part after the other.
fn parts(text: &str) -> Reading<Vec<String>> {
    let mut found = Vec::new();
    let (mut depth, mut start) = (0, 0);
    let ends = text.char_indices().chain([(text.len(), ',')]);
    for (position, c) in ends {
        depth += i32::from("({".contains(c)) - i32::from(")}".contains(c));
        if c == ',' && depth == 0 {
            found.extend(part(&text[start..position])?);
            start = position + 1;
        }
    }
    Ok(found)
}

fn part(text: &str) -> Reading<Vec<String>> {
    let text = text.trim();
    let is_index = |c: char| c.is_ascii_alphanumeric() || "+-".contains(c);
    if text.starts_with("\\max") || text.starts_with("\\min") {
        return Ok(vec![text.replace("\\m", "m")]);
    }
    if text.chars().all(is_index) {
        return Ok(vec![text.to_owned()]);
    }
    // The name of a coordinate below that of its momentum.
    let mut characters = Characters { rest: text };
    match name(&mut characters)? {
        Token::Name(inner) if characters.rest.is_empty() => {
            Ok([vec![inner.letter], inner.below].concat())
        }
        _ => Err(format!("what is {text} below the line?")),
    }
}
