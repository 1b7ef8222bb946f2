//! Removable singularities: quotients by roots that have a limit where the root is 0.
//!
//! The derivative of |v| v is |v| + v²/|v|, at rest numerically 0/0, with the limit 0. Where |v| is √S with a sum of
//! squares S, which is 0 only where each of them is, the order of vanishing of a numerator is compared with that
//! of S. A quotient that tends to 0 with S may then be computed with a divisor that is moved away from 0 by less
//! than its rounding. So may one that stays finite, if S depends on velocities: v/|v| is 0 at rest as signum is 0
//! at 0. Poles, such as that of 1/|r|, stay.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Binary, Expression, Graph, Node, Rational, Unary};

/// Factors of products: (product, base).
pub(crate) type Removable = BTreeSet<(Expression, Expression)>;

/// A lower bound of the order of vanishing of an expression; `None` if nothing is known.
type Order = Option<Rational>;

/// The products with a factor S^k, −1 < k < 0, that have a limit where S is 0, and those S.
pub(crate) fn removable(graph: &Graph, descendants: &[Expression]) -> Removable {
    let mut removable = Removable::new();
    for (base, products) in candidates(graph, descendants) {
        let at_rest = graph.contents(base).has_velocity();
        let squares = squares(graph, base);
        if squares.is_empty() {
            continue;
        }
        let orders = Orders::of(graph, base, &products, squares);
        // S itself has to vanish as its squares do.
        if orders.get(base).is_none_or(|order| order < two()) {
            continue;
        }
        let has_limit = |product: &&Expression| {
            orders
                .get(**product)
                .is_some_and(|order| !order.is_negative() && (at_rest || !order.is_zero()))
        };
        let found = products.iter().filter(has_limit);
        removable.extend(found.map(|product| (*product, base)));
    }
    removable
}

fn two() -> Rational {
    Rational::integer(2)
}

/// Whether a base with this exponent is a root in a denominator.
fn divides_by_root(exponent: &Rational) -> bool {
    exponent.is_negative() && exponent.abs() < Rational::ONE
}

/// The bases of roots in denominators, with the products whose numerators change.
fn candidates(graph: &Graph, descendants: &[Expression]) -> BTreeMap<Expression, Vec<Expression>> {
    let mut candidates: BTreeMap<Expression, Vec<Expression>> = BTreeMap::new();
    for expression in descendants {
        let Node::Product(factors) = graph.node(*expression) else {
            continue;
        };
        for (base, _) in factors.iter().filter(|(_, k)| divides_by_root(k)) {
            let mut others = factors.iter().filter(|(other, _)| other != base);
            if others.any(|(other, _)| graph.contents(*other).varies()) {
                candidates.entry(*base).or_default().push(*expression);
            }
        }
    }
    candidates
}

/// The roots of the terms of a sum of squares, as products of powers of varying factors; empty if it is none.
fn squares(graph: &Graph, sum: Expression) -> Vec<Monomial> {
    let Node::Sum(terms) = graph.node(sum) else {
        return Vec::new();
    };
    let roots = terms.iter().map(|(term, coefficient)| {
        let Node::Product(factors) = graph.node(*term) else {
            return None;
        };
        let even = factors.iter().all(|(_, exponent)| exponent.is_even());
        if coefficient.is_negative() || !even {
            return None;
        }
        let varying = factors
            .iter()
            .filter(|(base, exponent)| !exponent.is_negative() && graph.contents(*base).varies());
        let root: Monomial = varying
            .map(|(base, exponent)| (*base, exponent * &Rational::HALF))
            .collect();
        (!root.is_empty()).then_some(root)
    });
    roots.collect::<Option<_>>().unwrap_or_default()
}

/// A product of powers.
type Monomial = Vec<(Expression, Rational)>;

/// Orders of vanishing in the roots of the squares.
struct Orders {
    known: BTreeMap<Expression, Order>,
    /// The roots of squares that are products: each of their factors alone may be 0 elsewhere.
    products: Vec<Monomial>,
}

impl Orders {
    fn of(
        graph: &Graph,
        base: Expression,
        products: &[Expression],
        squares: Vec<Monomial>,
    ) -> Self {
        let is_single = |root: &Monomial| root.len() == 1 && root[0].1.is_one();
        let (single, composite): (Vec<_>, Vec<_>) = squares.into_iter().partition(is_single);
        let single: BTreeSet<Expression> = single.into_iter().flatten().map(|(x, _)| x).collect();
        let roots = [products, &[base]].concat();
        let mut orders = Self {
            known: BTreeMap::new(),
            products: composite,
        };
        for expression in graph.descendants(&roots) {
            let order = if single.contains(&expression) {
                Some(Rational::ONE)
            } else {
                orders.of_node(graph.node(expression))
            };
            orders.known.insert(expression, order);
        }
        orders
    }

    fn get(&self, expression: Expression) -> Order {
        self.known.get(&expression).cloned().flatten()
    }

    /// Divides a product by the roots that are products as often as possible, and returns how often.
    fn divided_out(&self, factors: &mut Monomial) -> Rational {
        let mut total = Rational::ZERO;
        for product in &self.products {
            let times = product.iter().map(|(base, power)| {
                let factor = factors.iter().find(|(other, _)| other == base);
                let quotient = factor.and_then(|(_, k)| Some(k * &power.reciprocal()?));
                let fraction = quotient.and_then(|quotient| quotient.to_fraction());
                fraction.map_or(0, |(above, below)| above.div_euclid(below).max(0))
            });
            let times = Rational::integer(times.min().unwrap_or(0));
            for (base, power) in product {
                for (_, k) in factors.iter_mut().filter(|(other, _)| other == base) {
                    *k = &*k - &(&times * power);
                }
            }
            total = &total + &times;
        }
        total
    }

    fn of_node(&self, node: &Node) -> Order {
        match node {
            Node::Constant(_) | Node::Pi | Node::Symbol(_) | Node::Application(..) => {
                Some(Rational::ZERO)
            }
            Node::Sum(terms) => self.least(terms.iter().map(|(x, _)| *x)),
            Node::Product(factors) => self.of_product(factors),
            Node::Opaque(x) => self.get(*x),
            Node::Unary(function, x) => match function {
                Unary::Sin
                | Unary::Tan
                | Unary::Asin
                | Unary::Atan
                | Unary::Sinh
                | Unary::Tanh
                | Unary::Asinh
                | Unary::Atanh
                | Unary::Abs => self.get(*x),
                Unary::Cos
                | Unary::Acos
                | Unary::Cosh
                | Unary::Sech
                | Unary::Acosh
                | Unary::Exp
                | Unary::Ln
                | Unary::Logistic
                | Unary::Softplus
                | Unary::LogCosh
                | Unary::Signum => Some(Rational::ZERO),
            },
            Node::Binary(Binary::Min | Binary::Max, x, y) => self.least([*x, *y].into_iter()),
            Node::Binary(Binary::Atan2 | Binary::Power | Binary::Scale, ..) => Some(Rational::ZERO),
        }
    }

    /// The order of a sum.
    fn least(&self, mut terms: impl Iterator<Item = Expression>) -> Order {
        let first = terms.next().and_then(|x| self.get(x))?;
        terms.try_fold(first, |least, x| {
            let order = self.get(x)?;
            Some(if order < least { order } else { least })
        })
    }

    /// The order of Π xᵢ^kᵢ. In a denominator it is known only of roots of quadratic forms, which vanish no
    /// faster.
    fn of_product(&self, factors: &[(Expression, Rational)]) -> Order {
        let mut factors = factors.to_vec();
        let mut sum = self.divided_out(&mut factors);
        for (base, exponent) in &factors {
            let order = self.get(*base)?;
            let quadratic = divides_by_root(exponent) && order == two();
            if exponent.is_negative() && !quadratic && !order.is_zero() {
                return None;
            }
            sum = &sum + &(exponent * &order);
        }
        Some(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;

    /// Whether Π xᵢ^kᵢ · S^k has a limit where S is 0, for S = x² + y² of velocities or of coordinates and z
    /// of the same kind.
    fn has_limit(of: fn(u32) -> Symbol, powers: [i64; 3], k: &Rational) -> bool {
        let mut graph = Graph::new();
        let letters = [0, 1, 2].map(|i| graph.symbol(of(i)));
        let [x, y, _] = letters.map(|x| graph.square(x));
        let sum = graph.add(x, y);
        let factors = letters.into_iter().zip(powers.map(Rational::integer));
        let product = graph.product(factors.chain([(sum, k.clone())]));
        let descendants = graph.descendants(&[product]);
        removable(&graph, &descendants).contains(&(product, sum))
    }

    #[test]
    fn what_vanishes_as_fast_as_the_root_has_a_limit() {
        let minus_half = -&Rational::HALF;
        for (powers, at_rest, in_place) in [
            ([2, 0, 0], true, true),
            ([1, 1, 0], true, true),
            ([2, 0, 1], true, true),
            // A unit vector is 0 at rest, and has no value where a place is that of another.
            ([1, 0, 0], true, false),
            ([1, 0, 1], true, false),
            ([0, 0, 0], false, false),
            ([1, -1, 0], false, false),
            ([0, 0, 2], false, false),
        ] {
            let found = has_limit(Symbol::Velocity, powers, &minus_half);
            assert_eq!(found, at_rest, "{powers:?}");
            let found = has_limit(Symbol::Coordinate, powers, &minus_half);
            assert_eq!(found, in_place, "{powers:?}");
        }
        // x/|r|³ is infinite; x |r|^(−½) is 0, and |r|^½ x has no divisor.
        let powers = [(-3, 2, false), (-1, 4, true), (1, 4, false)];
        for (numerator, denominator, expected) in powers {
            let k = Rational::new(numerator, denominator).unwrap();
            let found = has_limit(Symbol::Coordinate, [1, 0, 0], &k);
            assert_eq!(found, expected, "{k}");
        }
    }

    #[test]
    fn a_product_vanishes_where_one_of_its_factors_does() {
        // S = u² + (v sin q)², as of a velocity in spherical coordinates.
        let mut graph = Graph::new();
        let [q, u, v] = [
            Symbol::Coordinate(0),
            Symbol::Velocity(0),
            Symbol::Velocity(1),
        ]
        .map(|symbol| graph.symbol(symbol));
        let sine = graph.unary(Unary::Sin, q);
        let across = graph.multiply(v, sine);
        let (u2, across2) = (graph.square(u), graph.square(across));
        let sum = graph.add(u2, across2);
        let mut is_removable = |numerator: &[Expression], sum: Expression| {
            let factors = numerator.iter().map(|x| (*x, Rational::ONE));
            let product = graph.product(factors.chain([(sum, -&Rational::HALF)]));
            let descendants = graph.descendants(&[product]);
            !removable(&graph, &descendants).is_empty()
        };
        assert!(is_removable(&[u, u], sum));
        assert!(is_removable(&[v, sine, v, sine, q], sum));
        // v alone is not 0 where sin q is.
        assert!(!is_removable(&[v, v], sum));
        assert!(!is_removable(&[sine, sine], sum));
        assert!(!is_removable(&[q], sum));
    }

    #[test]
    fn a_form_that_vanishes_in_motion_is_no_sum_of_squares() {
        // u² − v² and u² − 2 u v + v² vanish where u = v.
        let mut graph = Graph::new();
        let [u, v] = [0, 1].map(|i| graph.symbol(Symbol::Velocity(i)));
        let (u2, v2, mixed) = (graph.square(u), graph.square(v), graph.multiply(u, v));
        let forms = [
            [(u2, 1), (v2, -1)].to_vec(),
            [(u2, 1), (mixed, -2), (v2, 1)].to_vec(),
        ];
        for form in forms {
            let terms = form.into_iter().map(|(x, c)| (x, Rational::integer(c)));
            let sum = graph.sum(terms);
            let factors = [(u, Rational::integer(2)), (sum, -&Rational::HALF)];
            let quotient = graph.product(factors);
            let descendants = graph.descendants(&[quotient]);
            assert!(removable(&graph, &descendants).is_empty());
        }
    }
}
