//! Guards of removable singularities: 1 − signum² x, which is 1 where x is 0 and 0 elsewhere, added to an argument or to a
//! divisor that would be 0 there. In derivatives a guard is a constant.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Unary};

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
            let mut of_guards = terms.iter().filter(|(term, _)| guards.contains_key(term));
            if let (Some((guard, coefficient)), None) = (of_guards.next(), of_guards.next())
                && coefficient.is_one()
            {
                let guard = *guard;
                let rest = self.subtract(part, guard);
                if self.is_multiple(rest, guards[&guard]) {
                    found.insert(part, rest);
                }
            }
        }
        found
    }

    /// Whether x is a number times y.
    fn is_multiple(&mut self, x: Expression, y: Expression) -> bool {
        let quotient = self.divide(x, y);
        self.as_constant(quotient).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Binary, Rational, Symbol};

    #[test]
    fn guards_of_powers_are_found() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|i| graph.symbol(Symbol::Coordinate(i)));
        for base in [x, graph.scale(x, &Rational::integer(3)), graph.add(x, y)] {
            let power = graph.binary(Binary::Power, base, y);
            let once = graph.derivatives(&[power], Symbol::Coordinate(1))[0];
            let twice = graph.derivatives(&[once], Symbol::Coordinate(0))[0];
            for derivative in [once, twice] {
                let sums = graph.guarded_sums(&[derivative]);
                assert_eq!(sums.values().copied().collect::<Vec<_>>(), [base]);
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
