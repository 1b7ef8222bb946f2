//! Printed formulas, read by a parser that knows nothing of the printer.

use lagrangian_symbolic::{Binary, Rational, Unary};

use crate::Number as _;
use crate::bounded::Bounded;

/// Reads a line of Unicode or LaTeX and evaluates it on the way.
pub struct Reader<'a> {
    tokens: Vec<String>,
    position: usize,
    symbols: &'a dyn Fn(&str) -> Bounded,
    /// Whether a bar that comes next closes.
    bars: bool,
}

/// Takes text apart: letters with their dots and subscripts, digits, commands, other characters.
fn tokens(text: &str) -> Vec<String> {
    // LaTeX says which bar opens and which closes; Unicode does not, and its bars are not nested.
    let text = text
        .replace("\\left|", "⟦")
        .replace("\\right|", "⟧")
        .replace("\\left", "")
        .replace("\\right", "")
        .replace("\\,", " ");
    let text: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut start = 0;
    while start < text.len() {
        let joined: fn(char) -> bool = match text[start] {
            c if c.is_ascii_digit() => |c| c.is_ascii_digit() || c == '.',
            c if is_superscript(c) => is_superscript,
            '\\' => |c| c.is_ascii_alphabetic(),
            c if c.is_alphabetic() => |c| {
                (c.is_alphanumeric() && !is_superscript(c) && !is_vulgar(c))
                    || matches!(c, '\u{307}' | '\u{308}' | '_')
            },
            _ => |_| false,
        };
        let mut length = 1 + text[start + 1..].iter().take_while(|c| joined(**c)).count();
        if length > 1 && text[start + length - 1] == '_' {
            // A subscript in braces.
            length -= 1;
        }
        let token: String = text[start..start + length].iter().collect();
        if token != " " {
            tokens.push(token);
        }
        start += length;
    }
    tokens
}

const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";

fn is_superscript(c: char) -> bool {
    SUPERSCRIPTS.contains(c)
}

const VULGAR: [(&str, i64, i64); 15] = [
    ("½", 1, 2),
    ("⅓", 1, 3),
    ("⅔", 2, 3),
    ("¼", 1, 4),
    ("¾", 3, 4),
    ("⅕", 1, 5),
    ("⅖", 2, 5),
    ("⅗", 3, 5),
    ("⅘", 4, 5),
    ("⅙", 1, 6),
    ("⅚", 5, 6),
    ("⅛", 1, 8),
    ("⅜", 3, 8),
    ("⅝", 5, 8),
    ("⅞", 7, 8),
];

fn is_vulgar(c: char) -> bool {
    VULGAR.iter().any(|(text, ..)| text.starts_with(c))
}

fn function(token: &str) -> Option<Unary> {
    let names = [
        ("sin", Unary::Sin),
        ("cos", Unary::Cos),
        ("tan", Unary::Tan),
        ("arcsin", Unary::Asin),
        ("arccos", Unary::Acos),
        ("arctan", Unary::Atan),
        ("sinh", Unary::Sinh),
        ("cosh", Unary::Cosh),
        ("tanh", Unary::Tanh),
        ("sech", Unary::Sech),
        ("arsinh", Unary::Asinh),
        ("arcosh", Unary::Acosh),
        ("artanh", Unary::Atanh),
        ("exp", Unary::Exp),
        ("ln", Unary::Ln),
        ("logistic", Unary::Logistic),
        ("softplus", Unary::Softplus),
        ("log_cosh", Unary::LogCosh),
        ("abs", Unary::Abs),
        ("sgn", Unary::Signum),
    ];
    names
        .iter()
        .find(|(name, _)| *name == token)
        .map(|(_, function)| *function)
}

impl Reader<'_> {
    /// The value of a formula whose symbols have these values.
    ///
    /// # Panics
    ///
    /// Where it is no formula.
    pub fn read(text: &str, symbols: &dyn Fn(&str) -> Bounded) -> Bounded {
        let mut reader = Reader {
            tokens: tokens(text),
            position: 0,
            symbols,
            bars: false,
        };
        let value = reader.sum();
        assert_eq!(
            reader.position,
            reader.tokens.len(),
            "read only in part: {text}"
        );
        value
    }

    fn peek(&self) -> &str {
        self.tokens.get(self.position).map_or("", String::as_str)
    }

    fn take(&mut self) -> String {
        self.position += 1;
        self.tokens[self.position - 1].clone()
    }

    fn accept(&mut self, token: &str) -> bool {
        let accepted = self.peek() == token;
        self.position += usize::from(accepted);
        accepted
    }

    fn expect(&mut self, token: &str) {
        assert!(
            self.accept(token),
            "no {token} in {:?}",
            &self.tokens[self.position..]
        );
    }

    fn within(&mut self, open: &str, close: &str) -> Bounded {
        self.expect(open);
        let bars = core::mem::take(&mut self.bars);
        let value = self.sum();
        self.bars = bars;
        self.expect(close);
        value
    }

    fn sum(&mut self) -> Bounded {
        let minus = Bounded::rational(&Rational::MINUS_ONE);
        let mut negative = self.accept("−") || self.accept("-");
        let mut sum: Option<Bounded> = None;
        loop {
            let term = self.term();
            let term = if negative { minus.multiply(term) } else { term };
            sum = Some(sum.map_or(term, |sum| sum.add(term)));
            negative = self.accept("−") || self.accept("-");
            if !negative && !self.accept("+") {
                return sum.unwrap();
            }
        }
    }

    fn term(&mut self) -> Bounded {
        let mut product = self.factor();
        loop {
            if self.accept("/") {
                let below = self.factor();
                return product.multiply(below.power(&Rational::MINUS_ONE));
            }
            let explicit = ["·", "×", "\\cdot", "\\times"]
                .iter()
                .any(|dot| self.accept(dot));
            let closing = ["", ")", "}", "⟧", "+", "−", "-", ","].contains(&self.peek());
            if !explicit && (closing || (self.bars && self.peek() == "|")) {
                return product;
            }
            product = product.multiply(self.factor());
        }
    }

    /// A base with its exponent.
    fn factor(&mut self) -> Bounded {
        let base = self.base();
        match self.exponent() {
            Some(exponent) => base.power(&exponent),
            None if self.accept("^") => {
                let exponent = if self.peek() == "{" {
                    self.within("{", "}")
                } else {
                    self.base()
                };
                base.binary(Binary::Power, exponent)
            }
            None => base,
        }
    }

    /// A numerical exponent, if one follows.
    fn exponent(&mut self) -> Option<Rational> {
        if self.peek().starts_with(is_superscript) {
            let digit = |c| match SUPERSCRIPTS.chars().position(|digit| digit == c).unwrap() {
                10 => "-".to_string(),
                digit => digit.to_string(),
            };
            let digits: String = self.take().chars().map(digit).collect();
            return Some(Rational::integer(digits.parse().unwrap()));
        }
        let rest: Vec<_> = self.tokens[self.position..]
            .iter()
            .map(String::as_str)
            .collect();
        let number = |text: &str| Rational::from_decimal(text);
        let (value, length) = match rest.as_slice() {
            ["^", "(", n, "/", d, ")", ..] | ["^", "{", n, "/", d, "}", ..] => {
                (&number(n)? * &number(d)?.reciprocal()?, 6)
            }
            ["^", "{", "-", n, "}", ..] => (-&number(n)?, 5),
            ["^", "{", n, "}", ..] => (number(n)?, 4),
            ["^", n, ..] => (number(n)?, 2),
            _ => return None,
        };
        self.position += length;
        Some(value)
    }

    fn base(&mut self) -> Bounded {
        match self.peek() {
            "(" => return self.within("(", ")"),
            "⟦" => return self.within("⟦", "⟧").unary(Unary::Abs),
            "|" => {
                self.take();
                self.bars = true;
                let value = self.sum();
                self.bars = false;
                self.expect("|");
                return value.unary(Unary::Abs);
            }
            _ => {}
        }
        let token = self.take();
        let name = token.trim_start_matches('\\');
        if name == "operatorname" {
            self.expect("{");
            let name = self.take();
            self.expect("}");
            return self.call(&name).unwrap();
        }
        if let Some(value) = self.call(name) {
            return value;
        }
        match name {
            "π" | "pi" => Bounded::pi(),
            "√" => self.base().power(&Rational::HALF),
            "sqrt" => self.within("{", "}").power(&Rational::HALF),
            "frac" => {
                let above = self.within("{", "}");
                above.multiply(self.within("{", "}").power(&Rational::MINUS_ONE))
            }
            "dot" | "ddot" => {
                self.expect("{");
                let letter = self.take();
                self.expect("}");
                let subscript = self.subscript();
                (self.symbols)(&format!("{name} {letter}{subscript}"))
            }
            _ => {
                if let Some((_, n, d)) = VULGAR.iter().find(|(text, ..)| *text == name) {
                    return Bounded::rational(&Rational::new(*n, *d).unwrap());
                }
                if let Some(number) = Rational::from_decimal(name) {
                    return Bounded::rational(&number);
                }
                let subscript = self.subscript();
                (self.symbols)(&format!("{token}{subscript}"))
            }
        }
    }

    fn subscript(&mut self) -> String {
        if !self.accept("_") {
            return String::new();
        }
        self.expect("{");
        let digits = self.take();
        self.expect("}");
        format!("_{digits}")
    }

    fn call(&mut self, name: &str) -> Option<Bounded> {
        if let Some(binary) = Binary::ALL
            .into_iter()
            .find(|function| function.name() == name)
        {
            self.expect("(");
            let x = self.sum();
            self.expect(",");
            let y = self.sum();
            self.expect(")");
            return Some(x.binary(binary, y));
        }
        let function = function(name)?;
        // An exponent may stand before the argument, which is one letter or stands in parentheses.
        let exponent = self.exponent();
        let argument = self.base();
        let value = argument.unary(function);
        Some(exponent.map_or(value, |exponent| value.power(&exponent)))
    }
}
