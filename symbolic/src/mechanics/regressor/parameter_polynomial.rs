//! Expressions as polynomials in parameters: Σ μ·c with monomials μ, products of integer powers, and coefficients c
//! that are free of them (distributed form: Geddes, Czapor and Labahn, Algorithms for Computer Algebra, 1992, section
//! 2.6).
//!
//! What may stand in a monomial is either some *unknown* parameters, in which an expression has to be a polynomial, or
//! everything that is *free of the motion*: parameters, and functions of parameters alone. Then sin(α + θ) is taken
//! apart by the addition theorem, and other functions of both stay in the coefficients.

use std::collections::{BTreeMap, BTreeSet};

use crate::limits::{HIGHEST_PARAMETER_POWER, MAX_PARAMETER_MONOMIALS};
use crate::{Expression, Graph, Node, Rational, Symbol, Unary};

/// Π xᵢ^kᵢ with integer exponents that are not 0, in the order of the xᵢ.
pub(crate) type Monomial = Vec<(Expression, i64)>;

/// Σ μ·c.
pub(crate) type ParameterPolynomial = BTreeMap<Monomial, Expression>;

/// What may stand in a monomial.
#[derive(Clone, Copy)]
pub(crate) enum Indeterminates<'a> {
    /// Some parameters.
    Unknown(&'a BTreeSet<Symbol>),
    /// Everything that does not depend on the motion.
    FreeOfMotion,
}

/// Why an expression is no polynomial.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum NoPolynomial {
    /// These unknown parameters are arguments of a function, or stand in the divisor or in a root: within this term.
    Within(BTreeSet<Symbol>, Expression),
    /// It has too many terms.
    TooLong,
}

impl Graph {
    /// The polynomials of some roots.
    pub(crate) fn parameter_polynomials(
        &mut self,
        roots: &[Expression],
        indeterminates: Indeterminates<'_>,
    ) -> Result<Vec<ParameterPolynomial>, NoPolynomial> {
        let mut expansion = Expansion {
            graph: self,
            indeterminates,
            known: BTreeMap::new(),
        };
        for part in expansion.graph.descendants(roots) {
            let polynomial = expansion.polynomial(part)?;
            if polynomial.len() > MAX_PARAMETER_MONOMIALS {
                return Err(NoPolynomial::TooLong);
            }
            expansion.known.insert(part, polynomial);
        }
        let known = expansion.known;
        let find = |root: &Expression| known.get(root).cloned().unwrap_or_default();
        Ok(roots.iter().map(find).collect())
    }

    /// The product of a monomial.
    pub(crate) fn monomial(&mut self, monomial: &Monomial) -> Expression {
        let powers = monomial.iter();
        let powers = powers.map(|(x, k)| (*x, Rational::integer(*k)));
        self.product(powers.collect::<Vec<_>>())
    }
}

/// Polynomials of subexpressions.
struct Expansion<'a> {
    graph: &'a mut Graph,
    indeterminates: Indeterminates<'a>,
    known: BTreeMap<Expression, ParameterPolynomial>,
}

impl Expansion<'_> {
    /// The polynomial of an expression, from those of its operands.
    fn polynomial(&mut self, part: Expression) -> Result<ParameterPolynomial, NoPolynomial> {
        let node = self.graph.node(part).clone();
        let mut is_coefficient = !matches!(node, Node::Symbol(_) | Node::Pi);
        node.for_each_operand(|x| is_coefficient &= self.is_free(x));
        if is_coefficient && self.varies_or_is_number(part) {
            return Ok(ParameterPolynomial::from([(Monomial::new(), part)]));
        }
        match node {
            Node::Sum(terms) => Ok(self.sum(&terms)),
            Node::Product(factors) => self.product(&factors),
            Node::Opaque(x) => Ok(self.known.get(&x).cloned().unwrap_or_default()),
            Node::Unary(function @ (Unary::Sin | Unary::Cos), x) if self.is_split(x) => {
                Ok(self.addition_theorem(function, x))
            }
            _ => self.indivisible(part),
        }
    }

    /// Whether no monomial of an expression contains an indeterminate.
    fn is_free(&self, x: Expression) -> bool {
        let polynomial = self.known.get(&x);
        polynomial.is_none_or(|polynomial| polynomial.keys().all(Vec::is_empty))
    }

    /// Whether an expression whose operands are free of indeterminates is so, too.
    fn varies_or_is_number(&self, part: Expression) -> bool {
        match self.indeterminates {
            Indeterminates::Unknown(_) => true,
            Indeterminates::FreeOfMotion => {
                self.graph.contents(part).varies() || self.graph.as_constant(part).is_some()
            }
        }
    }

    /// An expression as one indeterminate, or as a coefficient.
    fn indivisible(&mut self, part: Expression) -> Result<ParameterPolynomial, NoPolynomial> {
        let one = self.graph.one();
        let single = ParameterPolynomial::from([(vec![(part, 1)], one)]);
        let coefficient = ParameterPolynomial::from([(Monomial::new(), part)]);
        match self.indeterminates {
            Indeterminates::Unknown(unknown) => {
                if let Node::Symbol(symbol) = self.graph.node(part) {
                    let is_unknown = unknown.contains(symbol);
                    return Ok(if is_unknown { single } else { coefficient });
                }
                let mut within = self.graph.symbols(&[part]);
                within.retain(|symbol| unknown.contains(symbol));
                if within.is_empty() {
                    Ok(coefficient)
                } else {
                    Err(NoPolynomial::Within(within, part))
                }
            }
            Indeterminates::FreeOfMotion => {
                let varies = self.graph.contents(part).varies();
                Ok(if varies { coefficient } else { single })
            }
        }
    }

    /// Σ cᵢ·xᵢ.
    fn sum(&mut self, terms: &[(Expression, Rational)]) -> ParameterPolynomial {
        let mut coefficients: BTreeMap<Monomial, Vec<(Expression, Rational)>> = BTreeMap::new();
        for (x, c) in terms {
            for (monomial, coefficient) in self.known.get(x).into_iter().flatten() {
                let sum = coefficients.entry(monomial.clone()).or_default();
                sum.push((*coefficient, c.clone()));
            }
        }
        self.collected(coefficients)
    }

    fn collected(
        &mut self,
        coefficients: BTreeMap<Monomial, Vec<(Expression, Rational)>>,
    ) -> ParameterPolynomial {
        let mut polynomial = ParameterPolynomial::new();
        for (monomial, terms) in coefficients {
            let sum = self.graph.sum(terms);
            if !self.graph.is_zero(sum) {
                polynomial.insert(monomial, sum);
            }
        }
        polynomial
    }

    /// Π xᵢ^kᵢ.
    fn product(
        &mut self,
        factors: &[(Expression, Rational)],
    ) -> Result<ParameterPolynomial, NoPolynomial> {
        let one = self.graph.one();
        let mut product = ParameterPolynomial::from([(Monomial::new(), one)]);
        for (x, k) in factors {
            let power = self.power(*x, k)?;
            product = self.multiply(&product, &power)?;
        }
        Ok(product)
    }

    /// x^k.
    fn power(&mut self, x: Expression, k: &Rational) -> Result<ParameterPolynomial, NoPolynomial> {
        let base = self.known.get(&x).cloned().unwrap_or_default();
        if self.is_free(x) {
            let power = self.graph.power(x, k);
            return Ok(ParameterPolynomial::from([(Monomial::new(), power)]));
        }
        let exponent = k
            .to_integer()
            .filter(|k| k.abs() <= HIGHEST_PARAMETER_POWER);
        match (exponent, base.iter().next()) {
            (Some(exponent), Some((monomial, coefficient))) if base.len() == 1 => {
                let monomial = monomial.iter().map(|(x, k)| (*x, k * exponent)).collect();
                let coefficient = self.graph.power(*coefficient, k);
                Ok(ParameterPolynomial::from([(monomial, coefficient)]))
            }
            (Some(exponent @ 1..), _) => {
                let mut power = base.clone();
                for _ in 1..exponent {
                    power = self.multiply(&power, &base)?;
                }
                Ok(power)
            }
            _ => {
                let power = self.graph.power(x, k);
                self.indivisible(power)
            }
        }
    }

    fn multiply(
        &mut self,
        left: &ParameterPolynomial,
        right: &ParameterPolynomial,
    ) -> Result<ParameterPolynomial, NoPolynomial> {
        if left.len() * right.len() > 4 * MAX_PARAMETER_MONOMIALS {
            return Err(NoPolynomial::TooLong);
        }
        let mut coefficients: BTreeMap<Monomial, Vec<(Expression, Rational)>> = BTreeMap::new();
        for (first, x) in left {
            for (second, y) in right {
                let sum = coefficients.entry(product_of(first, second)).or_default();
                sum.push((self.graph.multiply(*x, *y), Rational::ONE));
            }
        }
        Ok(self.collected(coefficients))
    }

    /// Whether an argument is a sum of terms with and without the motion, which are told apart.
    fn is_split(&self, x: Expression) -> bool {
        let Node::Sum(terms) = self.graph.node(x) else {
            return false;
        };
        let varies = |(x, _): &(Expression, Rational)| self.graph.contents(*x).varies();
        let splits = matches!(self.indeterminates, Indeterminates::FreeOfMotion);
        splits && terms.iter().any(varies) && !terms.iter().all(varies)
    }

    /// sin(a + b) or cos(a + b), where a is free of the motion and b is not.
    fn addition_theorem(&mut self, function: Unary, x: Expression) -> ParameterPolynomial {
        let Node::Sum(terms) = self.graph.node(x).clone() else {
            return ParameterPolynomial::new();
        };
        let varies = |(x, _): &(Expression, Rational)| self.graph.contents(*x).varies();
        let (moving, free): (Vec<_>, Vec<_>) = terms.iter().cloned().partition(varies);
        let [a, b] = [free, moving].map(|terms| self.graph.sum(terms));
        let [sin_a, cos_a] = [Unary::Sin, Unary::Cos].map(|f| self.graph.unary(f, a));
        let [sin_b, cos_b] = [Unary::Sin, Unary::Cos].map(|f| self.graph.unary(f, b));
        let (with_sin_a, with_cos_a) = match function {
            Unary::Sin => (cos_b, sin_b),
            _ => (self.graph.negate(sin_b), cos_b),
        };
        let mut polynomial = ParameterPolynomial::new();
        for (of_a, of_b) in [(sin_a, with_sin_a), (cos_a, with_cos_a)] {
            if let Some(number) = self.graph.as_constant(of_a).cloned() {
                let term = self.graph.scale(of_b, &number);
                polynomial.insert(Monomial::new(), term);
            } else {
                polynomial.insert(vec![(of_a, 1)], of_b);
            }
        }
        polynomial
    }
}

/// The product of two monomials.
fn product_of(left: &Monomial, right: &Monomial) -> Monomial {
    let mut powers: BTreeMap<Expression, i64> = left.iter().copied().collect();
    for (x, k) in right {
        *powers.entry(*x).or_insert(0) += k;
    }
    powers.into_iter().filter(|(_, k)| *k != 0).collect()
}
