//! Guards of removable singularities: 1 − signum² x, which is 1 where x is 0 and 0 elsewhere, added to an argument or to a
//! divisor that would be 0 there. In derivatives a guard is a constant.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Rational, Unary};

impl Graph {
    /// 1 − signum² x.
    pub(crate) fn guard(&mut self, x: Expression) -> Expression {
        let sign = self.unary(Unary::Signum, x);
        let sign = self.square(sign);
        let one = self.one();
        let guard = self.subtract(one, sign);
        // Opaque, so that what it is added to is not rounded beside 1.
        self.opaque(guard)
    }

    /// The sums of multiples of x and the guard of x among these expressions and what they are made of, each with the multiple
    /// alone, which is equal wherever x is not 0.
    pub(crate) fn guarded_sums(
        &mut self,
        roots: &[Expression],
    ) -> BTreeMap<Expression, Expression> {
        let parts = self.descendants(roots);
        let signs = parts.iter().filter_map(|part| match self.node(*part) {
            Node::Unary(Unary::Signum, x) => Some(*x),
            _ => None,
        });
        let guards: BTreeMap<_, _> = signs
            .collect::<Vec<_>>()
            .into_iter()
            .map(|x| (self.guard(x), x))
            .collect();
        let mut found = BTreeMap::new();
        if guards.is_empty() {
            return found;
        }
        for part in parts {
            let Node::Sum(terms) = self.node(part) else {
                continue;
            };
            let of_guards = terms.iter().filter(|(term, _)| guards.contains_key(term));
            let of_guards: Vec<_> = of_guards.cloned().collect();
            if of_guards.is_empty() || !of_guards.iter().all(|(_, number)| number.is_one()) {
                continue;
            }
            let negative = of_guards
                .iter()
                .map(|(guard, _)| (*guard, Rational::MINUS_ONE));
            let rest = self.sum(negative.chain([(part, Rational::ONE)]));
            let mut guarded = of_guards.iter().map(|(guard, _)| guards[guard]);
            if guarded.any(|x| self.is_multiple(rest, x) || self.is_exponent(rest, x)) {
                found.insert(part, rest);
            }
        }
        found
    }

    /// Whether x is y less an integer, as in the derivatives of a power.
    fn is_exponent(&mut self, x: Expression, y: Expression) -> bool {
        let difference = self.subtract(y, x);
        self.as_constant(difference)
            .is_some_and(Rational::is_integer)
    }

    /// Whether x is a number times y.
    fn is_multiple(&mut self, x: Expression, y: Expression) -> bool {
        let quotient = self.divide(x, y);
        self.as_constant(quotient).is_some()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::{Binary, Symbol};

    #[test]
    fn guards_of_powers_are_found() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        for base in [x, graph.scale(x, &Rational::integer(3)), graph.add(x, y)] {
            let power = graph.binary(Binary::Power, base, y);
            let once = graph.derivatives(&[power], Symbol::Coordinate(1))[0];
            let twice = graph.derivatives(&[once], Symbol::Coordinate(0))[0];
            let less = graph.add_constant(y, &Rational::MINUS_ONE);
            let lesser = graph.add_constant(less, &Rational::MINUS_ONE);
            for derivative in [once, twice] {
                let sums = graph.guarded_sums(&[derivative]);
                let found: BTreeSet<_> = sums.values().copied().collect();
                assert!(found.contains(&base));
                assert!(found.is_subset(&BTreeSet::from([base, less, lesser])));
                let plain = graph.replace(&[derivative], &sums)[0];
                assert!(graph.guarded_sums(&[plain]).is_empty());
                let at = |symbol| {
                    if symbol == Symbol::Coordinate(0) {
                        1.3
                    } else {
                        2.1
                    }
                };
                let values = graph.evaluate(&[derivative, plain], at);
                assert!((values[0] - values[1]).abs() < 1e-14, "{values:?}");
            }
        }
    }

    #[test]
    fn a_sum_that_only_looks_guarded_is_left() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        // 1 − signum² x beside another quantity, and with a sign.
        let guard = graph.guard(x);
        let sums = [graph.add(y, guard), graph.subtract(x, guard)];
        assert!(graph.guarded_sums(&sums).is_empty());
    }
}
