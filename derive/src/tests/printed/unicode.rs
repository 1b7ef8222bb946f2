//! Lines of Unicode taken apart.

use super::token::{Characters, FUNCTIONS, Name, OF_SEVERAL, Token};
use super::value::Reading;

/// What is above a letter besides dots.
const ACCENTS: [char; 4] = ['\u{302}', '\u{303}', '\u{304}', '′'];
/// The letters and signs below the line, and what they are on it.
const BELOW: [(char, char); 18] = [
    ('ᵢ', 'i'),
    ('ⱼ', 'j'),
    ('ₖ', 'k'),
    ('ₗ', 'l'),
    ('ₘ', 'm'),
    ('ₙ', 'n'),
    ('ₐ', 'a'),
    ('ᵣ', 'r'),
    ('ₛ', 's'),
    ('ₚ', 'p'),
    ('ₜ', 't'),
    ('ₓ', 'x'),
    ('ₑ', 'e'),
    ('ₒ', 'o'),
    ('ₕ', 'h'),
    ('ᵤ', 'u'),
    ('₊', '+'),
    ('₋', '-'),
];
/// Above it.
const ABOVE: [(char, char); 11] = [
    ('ⁱ', 'i'),
    ('ʲ', 'j'),
    ('ᵏ', 'k'),
    ('ˡ', 'l'),
    ('ᵐ', 'm'),
    ('ⁿ', 'n'),
    ('ᵃ', 'a'),
    ('ʳ', 'r'),
    ('ˢ', 's'),
    ('⁺', '+'),
    ('⁻', '-'),
];
const RAISED_DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const FRACTIONS: [(char, f64, f64); 15] = [
    ('½', 1.0, 2.0),
    ('⅓', 1.0, 3.0),
    ('⅔', 2.0, 3.0),
    ('¼', 1.0, 4.0),
    ('¾', 3.0, 4.0),
    ('⅕', 1.0, 5.0),
    ('⅖', 2.0, 5.0),
    ('⅗', 3.0, 5.0),
    ('⅘', 4.0, 5.0),
    ('⅙', 1.0, 6.0),
    ('⅚', 5.0, 6.0),
    ('⅛', 1.0, 8.0),
    ('⅜', 3.0, 8.0),
    ('⅝', 5.0, 8.0),
    ('⅞', 7.0, 8.0),
];

/// The parts of a formula.
pub(super) fn tokens(text: &str) -> Reading<Vec<Token>> {
    let mut characters = Characters { rest: text };
    let mut tokens = Vec::new();
    let mut adjacent = false;
    while let Some(c) = characters.peek() {
        if c == ' ' && !characters.next_is(" × ") {
            characters.take(" ");
            adjacent = false;
            continue;
        }
        token(&mut characters, c, adjacent, &mut tokens)?;
        adjacent = true;
    }
    Ok(tokens)
}

/// The next parts, of which the first character is known.
fn token(
    characters: &mut Characters<'_>,
    c: char,
    adjacent: bool,
    tokens: &mut Vec<Token>,
) -> Reading<()> {
    let after_bracket = adjacent
        && matches!(
            tokens.last(),
            Some(Token::Close | Token::CloseSquare | Token::Bar)
        );
    if characters.take("d/dt ") {
        tokens.push(Token::Rate);
    } else if characters.take(" × ") {
        tokens.push(Token::Cross);
    } else if let Some((_, above, below)) = FRACTIONS.iter().find(|fraction| fraction.0 == c) {
        characters.take_while(|other| other == c);
        tokens.push(Token::Number(above / below));
    } else if c == 'Σ' && is_sum(characters.rest) {
        tokens.push(sum(characters)?);
    } else if c == '_' && after_bracket {
        characters.take("_");
        let axis = characters.take_while(|c| "xyz".contains(c));
        let axis = "xyz".find(axis).ok_or("no axis")?;
        tokens.push(Token::Component(axis));
    } else if RAISED_DIGITS.contains(c) || c == '⁻' {
        let raised = characters.take_while(|c| RAISED_DIGITS.contains(c) || c == '⁻');
        let exponent: String = raised.chars().map(on_the_line).collect();
        let exponent = exponent.parse().map_err(|_| format!("exponent {raised}"))?;
        tokens.extend([Token::Caret, Token::Number(exponent)]);
    } else if c.is_ascii_digit() {
        tokens.push(Token::Number(characters.number()?));
    } else if c.is_alphabetic() && c != 'ᵀ' || c == '_' {
        tokens.push(name(characters)?);
    } else {
        characters.take(c.encode_utf8(&mut [0; 4]));
        tokens.push(match c {
            '(' => Token::Open { adjacent },
            ')' => Token::Close,
            '[' => Token::OpenSquare,
            ']' => Token::CloseSquare,
            '|' => Token::Bar,
            ',' => Token::Comma,
            '+' => Token::Plus,
            '−' => Token::Minus,
            '·' | '×' => Token::Dot,
            '/' => Token::Slash,
            '^' => Token::Caret,
            'ᵀ' => Token::Transposed,
            '√' => Token::Root,
            other => return Err(format!("what is {other:?} in {}?", characters.rest)),
        });
    }
    Ok(())
}

fn is_sum(text: &str) -> bool {
    let mut rest = text.chars().skip(1);
    rest.next()
        .is_some_and(|c| c == '_' || BELOW.iter().any(|(below, _)| *below == c))
}

/// `Σₖ₌₀ⁱ⁻¹ `, `Σ_(k=max(i,j))^(19) `, `Σ_(j≠i) ` or `Σⱼ `.
fn sum(characters: &mut Characters<'_>) -> Reading<Token> {
    characters.take("Σ");
    let [below, above] = if characters.take("_(") {
        let below = characters.take_group(['(', ')'])?.to_owned();
        if let Some((variable, but)) = below.split_once('≠') {
            return Ok(Token::SumOfOthers {
                variable: variable.to_owned(),
                but: but.to_owned(),
            });
        }
        if !characters.take("^(") {
            return Err("a sum without an upper bound".into());
        }
        [below, characters.take_group(['(', ')'])?.to_owned()]
    } else {
        let below = characters.take_while(|c| is_below(c) || c == '₌');
        let above = characters.take_while(|c| is_above(c) || RAISED_DIGITS.contains(c));
        [below, above].map(|text| text.chars().map(on_the_line).collect())
    };
    Ok(match below.split_once('=') {
        Some((variable, first)) => Token::Sum {
            variable: variable.to_owned(),
            bounds: [first.to_owned(), above],
        },
        None => Token::SumOfLinks(below),
    })
}

fn is_below(c: char) -> bool {
    ('₀'..='₉').contains(&c) || BELOW.iter().any(|(below, _)| *below == c)
}

fn is_above(c: char) -> bool {
    ABOVE.iter().any(|(above, _)| *above == c)
}

fn on_the_line(c: char) -> char {
    let raised = RAISED_DIGITS.chars().position(|raised| raised == c);
    let digit = raised.or_else(|| ('₀'..='₉').position(|lowered| lowered == c));
    let digit = digit.and_then(|digit| char::from_digit(u32::try_from(digit).ok()?, 10));
    let mut signs = BELOW.iter().chain(&ABOVE);
    let sign = signs.find(|(shifted, _)| *shifted == c);
    match (digit, sign) {
        (Some(digit), _) => digit,
        (_, Some((_, sign))) => *sign,
        _ if c == '₌' => '=',
        _ => c,
    }
}

/// A name with its dots and what is below the line, or a function.
fn name(characters: &mut Characters<'_>) -> Reading<Token> {
    let is_letter =
        |c: char| c.is_alphanumeric() && !is_below(c) && !is_above(c) && !RAISED_DIGITS.contains(c);
    let is_letter = |c: char| is_letter(c) && c != 'ᵀ';
    let begins_below = characters.take_while(|c| c == '_').to_owned();
    let mut name = Name {
        letter: begins_below + characters.take_while(is_letter),
        ..Name::default()
    };
    loop {
        match characters.peek() {
            Some(c) if ACCENTS.contains(&c) => {
                characters.take(c.encode_utf8(&mut [0; 4]));
                name.letter.push(c);
            }
            Some(c @ ('\u{307}' | '˙' | '\u{308}' | '¨')) => {
                characters.take(c.encode_utf8(&mut [0; 4]));
                name.dots = if matches!(c, '\u{307}' | '˙') { 1 } else { 2 };
            }
            _ => break,
        }
    }
    let is_function = FUNCTIONS.contains(&&*name.letter) || OF_SEVERAL.contains(&&*name.letter);
    if is_function && name.dots == 0 && !characters.next_is("_") {
        return Ok(Token::Function(name.letter));
    }
    loop {
        if characters.take("_(") {
            name.below
                .push(characters.take_group(['(', ')'])?.to_owned());
        } else if characters.take("_") {
            let word = characters.take_while(is_letter);
            let mut word = word.to_owned();
            if ["max", "min"].contains(&&*word) && characters.take("(") {
                word = format!("{word}({})", characters.take_group(['(', ')'])?);
            }
            name.below.push(word);
        } else if characters.peek().is_some_and(is_below) {
            let below = characters.take_while(is_below);
            name.below.extend(indices_below(below));
        } else if characters
            .rest
            .strip_prefix(',')
            .is_some_and(|rest| rest.starts_with(is_below))
        {
            characters.take(",");
        } else {
            return Ok(Token::Name(name));
        }
    }
}

/// Indices one behind the other: numbers, and variables with what is added to them.
fn indices_below(text: &str) -> Vec<String> {
    let mut indices: Vec<String> = Vec::new();
    let mut continues = false;
    for c in text.chars().map(on_the_line) {
        let is_digit = c.is_ascii_digit();
        match indices.last_mut() {
            Some(last) if continues || matches!(c, '+' | '-') => last.push(c),
            Some(last) if is_digit && last.ends_with(|c: char| c.is_ascii_digit()) => last.push(c),
            _ => indices.push(c.into()),
        }
        continues = matches!(c, '+' | '-');
    }
    indices
}
