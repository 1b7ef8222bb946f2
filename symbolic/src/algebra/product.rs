//! The normal form of products and of exact powers, Π xᵢ^kᵢ.
//!
//! The rules keep the semantics of real numbers: what is rewritten is equal wherever the original has
//! a value. (√x)² = x and x/x = 1 extend the domain; √(x²y²) = |x| |y|; (xy)^k = x^k y^k only for integer k;
//! (−8)^⅓ has no value and stays as it is.

use crate::algebra::split::Split;
use crate::algebra::sum::{ascends, combine};
use crate::limits::{MAX_MERGED_PRODUCT_LENGTH, MAX_PRODUCT_LENGTH};
use crate::{Expression, Graph, Node, Pass, Rational, Unary};

/// Π xᵢ^kᵢ, as pairs (xᵢ, kᵢ).
type Factors = Vec<(Expression, Rational)>;

/// c·Π xᵢ^kᵢ.
type Distributed = (Rational, Factors);

/// A product of few factors, and the tree of pairs below them, children before parents.
#[derive(Default)]
struct Paired {
    factors: Factors,
    pairs: Vec<Expression>,
}

impl Graph {
    /// Π xᵢ^kᵢ of pairs (xᵢ, kᵢ).
    pub fn product(
        &mut self,
        factors: impl IntoIterator<Item = (Expression, Rational)>,
    ) -> Expression {
        self.multiply_factors(Vec::new(), factors.into_iter().collect())
    }

    /// The product of `settled` factors, which are in normal form, and of `pending` ones, whose bases may be
    /// products or sums with a common factor.
    pub(crate) fn multiply_factors(
        &mut self,
        mut settled: Factors,
        mut pending: Factors,
    ) -> Expression {
        let mut coefficient = Rational::ONE;
        while !pending.is_empty() {
            while let Some((base, exponent)) = pending.pop() {
                // What divides by one of the factors cancels it, before either is taken apart: a factor that vanishes somewhere
                // is no divisor in what is left.
                if !self.is_zero(base)
                    && let Some(rest) = cancel(&mut settled, base, &exponent)
                {
                    if !rest.is_zero() {
                        pending.push((base, rest));
                    }
                    continue;
                }
                match self.node(base) {
                    // The factors of a product are already in normal form.
                    Node::Product(inner)
                        if exponent.is_one() && inner.len() <= MAX_MERGED_PRODUCT_LENGTH =>
                    {
                        settled.extend(inner.iter().cloned());
                        continue;
                    }
                    _ => {}
                }
                if let Some((number, parts)) = self.distribute(base, &exponent) {
                    coefficient = &coefficient * &number;
                    pending.extend(parts);
                } else {
                    settled.push((base, exponent));
                }
            }
            // Where equal bases meet, the exponent may become one that distributes: |x|·|x| = x².
            pending = take_equal_bases(&mut settled);
            if pending.is_empty() {
                pending = self.take_hyperbolic(&mut settled);
            }
            if pending.is_empty() {
                pending = self.take_exponential(&mut settled);
            }
        }
        if let Some((zero, _)) = settled.iter().find(|(base, _)| self.is_zero(*base)) {
            // What divides by zero has no value, 0/0 no more than 1/0, which stands for them all.
            return self.intern_product(vec![(*zero, Rational::MINUS_ONE)]);
        }
        let product = self.intern_product(settled);
        if coefficient.is_one() {
            return product;
        }
        self.scale(product, &coefficient)
    }

    /// base^exponent distributed over the factors of the base, unless it is in normal form already.
    fn distribute(&mut self, base: Expression, exponent: &Rational) -> Option<Distributed> {
        if exponent.is_zero() {
            return Some((Rational::ONE, Vec::new()));
        }
        if let Some(factors) = self.distribute_over_exponentials(base, exponent) {
            return Some((Rational::ONE, factors));
        }
        match self.node(base) {
            Node::Constant(value) => Some((exact_power(value, exponent)?, Vec::new())),
            Node::Product(inner) if exponent.is_integer() => {
                if inner.len() > MAX_MERGED_PRODUCT_LENGTH {
                    return None;
                }
                // (Π x^j)^k = Π x^(jk).
                let parts = inner.iter().map(|(x, j)| Some((*x, short(j * exponent)?)));
                Some((Rational::ONE, parts.collect::<Option<_>>()?))
            }
            Node::Product(_) if self.is_even_product(base) => {
                // (Π x^j)^k = Π |x|^(jk) for even j.
                let Node::Product(inner) = self.node(base) else {
                    return None;
                };
                let inner = inner.clone();
                let parts = inner.iter().map(|(x, j)| {
                    let exponent = short(j * exponent)?;
                    Some((self.unary(Unary::Abs, *x), exponent))
                });
                Some((Rational::ONE, parts.collect::<Option<_>>()?))
            }
            Node::Product(inner) => {
                // Where x^j has a value with a real power, it is not negative, and neither is x:
                // (x^j)^k = x^(jk).
                let [(x, j)] = &**inner else { return None };
                Some((Rational::ONE, vec![(*x, short(j * exponent)?)]))
            }
            Node::Sum(_) if exponent.is_integer() => self.distribute_over_split(base, exponent),
            Node::Sum(terms) => {
                // (c·Π x^j)^k = c^k·(Π x^j)^k for even j and c > 0.
                let [(product, number)] = &**terms else {
                    return None;
                };
                let (product, number) = (*product, number.clone());
                if number.is_negative() || number.is_long() || !self.is_even_product(product) {
                    return None;
                }
                let number = self.constant(&number);
                let parts = [number, product].map(|x| (x, exponent.clone()));
                Some((Rational::ONE, parts.to_vec()))
            }
            // A root of what is too large for a number.
            Node::Unary(Unary::Exp, u) if !exponent.is_integer() => {
                let power = self.scale(*u, exponent);
                Some((
                    Rational::ONE,
                    vec![(self.unary(Unary::Exp, power), Rational::ONE)],
                ))
            }
            Node::Unary(Unary::Logistic, u) if !exponent.is_integer() => {
                let u = *u;
                let opposite = self.negate(u);
                let logarithm = self.unary(Unary::Softplus, opposite);
                let power = self.scale(logarithm, &-exponent);
                Some((
                    Rational::ONE,
                    vec![(self.unary(Unary::Exp, power), Rational::ONE)],
                ))
            }
            Node::Unary(Unary::Abs, x) if exponent.is_even() => {
                Some((Rational::ONE, vec![(*x, exponent.clone())]))
            }
            _ => None,
        }
    }

    /// (c·Π x^j·y)^k = c^k·Π x^(jk)·y^k for a sum that is c·Π x^j·y, and an integer k.
    fn distribute_over_split(
        &mut self,
        base: Expression,
        exponent: &Rational,
    ) -> Option<Distributed> {
        let Split {
            number,
            common,
            rest,
        } = self.split(base)?;
        if number.is_long() {
            return None;
        }
        let power = number.power(exponent.to_integer()?)?;
        let common = common
            .into_iter()
            .map(|(x, j)| Some((x, short(&j * exponent)?)));
        let mut parts = common.collect::<Option<Factors>>()?;
        if parts.len() > MAX_MERGED_PRODUCT_LENGTH {
            parts = vec![(self.intern_product(parts), Rational::ONE)];
        }
        parts.push((rest, exponent.clone()));
        Some((power, parts))
    }

    /// Whether an expression is a product of even powers.
    fn is_even_product(&self, expression: Expression) -> bool {
        match self.node(expression) {
            Node::Product(factors) => {
                factors.len() <= MAX_MERGED_PRODUCT_LENGTH
                    && factors.iter().all(|(_, k)| k.is_even())
            }
            _ => false,
        }
    }

    fn intern_product(&mut self, mut factors: Factors) -> Expression {
        if factors.len() > MAX_PRODUCT_LENGTH && self.passes.has(Pass::Opaque) {
            factors = self.paired(factors).factors;
        }
        match factors.as_slice() {
            [] => self.one(),
            [(x, k)] if k.is_one() => *x,
            _ => self.intern(Node::Product(factors.into())),
        }
    }

    /// The same product of at most four factors, each a balanced tree of opaque products of two:
    /// above the fraction bar and below, one of what depends on parameters alone and one of the rest.
    ///
    /// A derivative of the tree is as long as the tree, of whatever order; that of n factors side by side has
    /// n² of them, and the second one n³. (Baur and Strassen, The complexity of partial
    /// derivatives, 1983.)
    fn paired(&mut self, factors: Factors) -> Paired {
        let mut kinds: [Factors; 4] = Default::default();
        for (x, k) in factors {
            let kind = 2 * usize::from(self.contents(x).varies()) + usize::from(k.is_negative());
            kinds[kind].push((x, k));
        }
        let mut paired = Paired::default();
        for mut kind in kinds {
            while kind.len() > 1 {
                kind = kind.chunks(2).map(|pair| self.pair(pair)).collect();
                paired.pairs.extend(kind.iter().map(|(pair, _)| *pair));
                // A pair may have been a factor already.
                combine(&mut kind);
            }
            paired.factors.extend(kind);
        }
        combine(&mut paired.factors);
        paired
    }

    /// A long product as a tree: pairs of factors, children before parents, and last the same product of
    /// these.
    pub(crate) fn tree_of_pairs(&mut self, product: Expression) -> Vec<Expression> {
        let factors = self.factors(product);
        let Paired { mut pairs, factors } = self.paired(factors);
        pairs.push(self.intern_product(factors));
        pairs
    }

    /// Two factors of one kind as one.
    fn pair(&mut self, pair: &[(Expression, Rational)]) -> (Expression, Rational) {
        let [(_, first), _] = pair else {
            return pair[0].clone();
        };
        let (sign, powers) = if first.is_negative() {
            let opposite = pair.iter().map(|(x, k)| (*x, -k));
            (Rational::MINUS_ONE, opposite.collect::<Box<[_]>>())
        } else {
            (Rational::ONE, pair.into())
        };
        let product = self.intern(Node::Product(powers));
        (self.opaque(product), sign)
    }
}

/// Takes the factor with this base out of the others, if its exponent has the other sign; what is left of both exponents.
fn cancel(factors: &mut Factors, base: Expression, exponent: &Rational) -> Option<Rational> {
    let cancels = |(other, power): &(Expression, Rational)| {
        *other == base && power.is_negative() != exponent.is_negative()
    };
    let position = factors.iter().position(cancels)?;
    let (_, power) = factors.remove(position);
    Some(&power + exponent)
}

/// Sorts the factors, and removes those with equal bases, which are returned as one power each.
fn take_equal_bases(factors: &mut Vec<(Expression, Rational)>) -> Vec<(Expression, Rational)> {
    if ascends(factors) {
        return Vec::new();
    }
    factors.sort_by_key(|(base, _)| *base);
    if ascends(factors) {
        return Vec::new();
    }
    let (mut single, mut merged) = (Vec::new(), Vec::new());
    for group in factors.chunk_by(|a, b| a.0 == b.0) {
        if let [factor] = group {
            single.push(factor.clone());
        } else {
            let exponent = group.iter().fold(Rational::ZERO, |sum, (_, k)| &sum + k);
            merged.push((group[0].0, exponent));
        }
    }
    *factors = single;
    merged
}

/// value^exponent, if it is rational: an integer power, or an exact root of a positive number.
fn exact_power(value: &Rational, exponent: &Rational) -> Option<Rational> {
    if value.is_one() {
        return Some(Rational::ONE);
    }
    if value.is_long() {
        return None;
    }
    let (numerator, denominator) = exponent.to_fraction()?;
    if denominator == 1 {
        return value.power(numerator);
    }
    if value.is_zero() {
        return (numerator > 0).then_some(Rational::ZERO);
    }
    value.root(denominator)?.power(numerator)
}

/// An exponent, unless it has grown beyond machine integers.
fn short(exponent: Rational) -> Option<Rational> {
    exponent.to_fraction().is_some().then_some(exponent)
}
