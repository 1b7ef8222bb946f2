//! Formulas by what their parts do, read from their tokens.

use super::token::{Name, Token};
use super::value::{Join, Reading};

/// A formula.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Formula {
    Number(f64),
    Name(Name),
    /// A function of arguments.
    Call(Name, Vec<Formula>),
    Negative(Box<Formula>),
    /// Terms, each with whether it is subtracted.
    Terms(Vec<(bool, Formula)>),
    Product(Box<Formula>, Box<Formula>, Join),
    Quotient(Box<Formula>, Box<Formula>),
    Cross(Box<Formula>, Box<Formula>),
    Power(Box<Formula>, Box<Formula>),
    Transposed(Box<Formula>),
    Bars(Box<Formula>),
    Root(Box<Formula>),
    List(Vec<Formula>),
    Rate(Box<Formula>),
    Component(Box<Formula>, usize),
    Sum {
        variable: String,
        bounds: [String; 2],
        term: Box<Formula>,
    },
    /// A variable, the index whose value it does not take, and a term.
    SumOfOthers(String, String, Box<Formula>),
    SumOfLinks(String, Box<Formula>),
}

/// Reads a formula.
pub(super) fn formula(tokens: &[Token]) -> Reading<Formula> {
    let mut parser = Parser {
        tokens,
        position: 0,
        within_bars: false,
    };
    let formula = parser.terms()?;
    match parser.peek() {
        None => Ok(formula),
        Some(token) => Err(format!("{token:?} is left over")),
    }
}

struct Parser<'a> {
    tokens: &'a [Token],
    position: usize,
    /// Whether the next bar closes.
    within_bars: bool,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.position)
    }

    fn take(&mut self, token: &Token) -> bool {
        let found = self.peek() == Some(token);
        self.position += usize::from(found);
        found
    }

    fn expect(&mut self, token: &Token) -> Reading<()> {
        if self.take(token) {
            return Ok(());
        }
        Err(format!("{token:?} is missing before {:?}", self.peek()))
    }

    fn terms(&mut self) -> Reading<Formula> {
        let negative = self.take(&Token::Minus);
        let mut terms = vec![(negative, self.term()?)];
        loop {
            let minus = match self.peek() {
                Some(Token::Plus) => false,
                Some(Token::Minus) => true,
                _ => break,
            };
            self.position += 1;
            terms.push((minus, self.term()?));
        }
        Ok(match &*terms {
            [(false, only)] => only.clone(),
            [(true, only)] => Formula::Negative(Box::new(only.clone())),
            _ => Formula::Terms(terms),
        })
    }

    /// Products with crosses between them.
    fn term(&mut self) -> Reading<Formula> {
        let mut term = self.product()?;
        while self.take(&Token::Cross) {
            term = Formula::Cross(Box::new(term), Box::new(self.product()?));
        }
        Ok(term)
    }

    /// Factors with dots between them.
    fn product(&mut self) -> Reading<Formula> {
        let mut product = self.factors()?;
        while self.take(&Token::Dot) {
            product = Formula::Product(Box::new(product), Box::new(self.factors()?), Join::Dot);
        }
        Ok(product)
    }

    /// Factors side by side and divisors, from left to right.
    fn factors(&mut self) -> Reading<Formula> {
        let mut product = self.power()?;
        loop {
            product = if self.take(&Token::Slash) {
                Formula::Quotient(Box::new(product), Box::new(self.power()?))
            } else if self.begins_factor() {
                Formula::Product(Box::new(product), Box::new(self.power()?), Join::Juxtaposed)
            } else {
                return Ok(product);
            };
        }
    }

    fn begins_factor(&self) -> bool {
        match self.peek() {
            Some(Token::Bar) => !self.within_bars,
            Some(
                Token::Number(_)
                | Token::Name(_)
                | Token::Function(_)
                | Token::Open { .. }
                | Token::OpenSquare
                | Token::Root
                | Token::Rate
                | Token::Sum { .. }
                | Token::SumOfOthers { .. }
                | Token::SumOfLinks(_),
            ) => true,
            _ => false,
        }
    }

    /// An atom with exponents and components behind it.
    fn power(&mut self) -> Reading<Formula> {
        let mut base = self.atom()?;
        loop {
            if self.take(&Token::Caret) {
                base = Formula::Power(Box::new(base), Box::new(self.atom()?));
            } else if self.take(&Token::Transposed) {
                base = Formula::Transposed(Box::new(base));
            } else if let Some(Token::Component(axis)) = self.peek() {
                let axis = *axis;
                self.position += 1;
                base = Formula::Component(Box::new(base), axis);
            } else {
                return Ok(base);
            }
        }
    }

    fn atom(&mut self) -> Reading<Formula> {
        let token = self.peek().cloned().ok_or("something is missing")?;
        self.position += 1;
        match token {
            Token::Number(number) => Ok(Formula::Number(number)),
            Token::Name(name) => match self.peek() {
                Some(Token::Open { adjacent: true }) => Ok(Formula::Call(name, self.arguments()?)),
                _ => Ok(Formula::Name(name)),
            },
            Token::Function(name) => self.function(name),
            Token::Open { .. } => {
                self.position -= 1;
                let mut list = self.arguments()?;
                Ok(match list.len() {
                    1 => list.remove(0),
                    _ => Formula::List(list),
                })
            }
            Token::OpenSquare => {
                let inner = self.unbarred()?;
                self.expect(&Token::CloseSquare)?;
                Ok(inner)
            }
            Token::Bar => {
                let before = core::mem::replace(&mut self.within_bars, true);
                let inner = self.terms()?;
                self.within_bars = before;
                self.expect(&Token::Bar)?;
                Ok(Formula::Bars(Box::new(inner)))
            }
            Token::Root => Ok(Formula::Root(Box::new(self.atom()?))),
            Token::Rate => Ok(Formula::Rate(Box::new(self.power()?))),
            Token::Sum { variable, bounds } => Ok(Formula::Sum {
                variable,
                bounds,
                term: Box::new(self.term()?),
            }),
            Token::SumOfOthers { variable, but } => {
                Ok(Formula::SumOfOthers(variable, but, Box::new(self.term()?)))
            }
            Token::SumOfLinks(variable) => {
                Ok(Formula::SumOfLinks(variable, Box::new(self.term()?)))
            }
            other => Err(format!("{other:?} begins nothing")),
        }
    }

    /// sin x, sin²x, sin(x), max(x, y).
    fn function(&mut self, name: String) -> Reading<Formula> {
        let exponent = if self.take(&Token::Caret) {
            Some(self.atom()?)
        } else {
            None
        };
        let arguments = match self.peek() {
            Some(Token::Open { .. }) => self.arguments()?,
            _ => vec![self.atom()?],
        };
        let name = Name {
            letter: name,
            ..Name::default()
        };
        let call = Formula::Call(name, arguments);
        Ok(match exponent {
            Some(exponent) => Formula::Power(Box::new(call), Box::new(exponent)),
            None => call,
        })
    }

    /// Terms in brackets, within which a bar opens.
    fn unbarred(&mut self) -> Reading<Formula> {
        let before = core::mem::replace(&mut self.within_bars, false);
        let inner = self.terms()?;
        self.within_bars = before;
        Ok(inner)
    }

    fn arguments(&mut self) -> Reading<Vec<Formula>> {
        self.position += 1;
        if self.take(&Token::Close) {
            return Ok(Vec::new());
        }
        let mut arguments = vec![self.unbarred()?];
        while self.take(&Token::Comma) {
            arguments.push(self.unbarred()?);
        }
        self.expect(&Token::Close)?;
        Ok(arguments)
    }
}
