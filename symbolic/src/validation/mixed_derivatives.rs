//! Mixed derivatives of external functions, which do not depend on their order.
//!
//! The values of external functions are unknown, and validation takes others in their place. Programs take ∂²f/∂x∂y
//! where Lagrange's equations take ∂²f/∂y∂x, so that the two must be equal, as they are for every twice continuously
//! differentiable function (Schwarz, 1873). Where the declared derivatives do not say so by themselves, they are
//! equations between functions, and solved for one of them.

use std::collections::{BTreeMap, BTreeSet};

use crate::limits::HIGHEST_EXTERNAL_DERIVATIVE;
use crate::validation::tape::StandIns;
use crate::{Expression, ExternalFunction, Graph, Node, Rational, Symbol};

/// What stands for external functions such that their mixed derivatives are equal.
pub(crate) struct MixedDerivatives {
    /// The graph of the model, in which derivatives that no program applies are declared as other expressions.
    pub(crate) graph: Graph,
    pub(crate) stand_ins: StandIns,
    /// Whether all mixed derivatives are equal.
    pub(crate) are_equal: bool,
}

impl MixedDerivatives {
    /// The functions that `roots` apply.
    pub(crate) fn of(graph: &Graph, roots: &[Expression]) -> Self {
        let mut found = Self {
            graph: graph.clone(),
            stand_ins: StandIns::default(),
            are_equal: true,
        };
        let mut known = BTreeSet::new();
        let mut open = applied(graph, roots);
        for _ in 0..HIGHEST_EXTERNAL_DERIVATIVE {
            let mut next = Vec::new();
            for function in open {
                if known.insert(function) {
                    next.extend(found.compare_mixed(function));
                }
            }
            open = next;
        }
        found
    }

    /// Makes ∂²f/∂x∂y and ∂²f/∂y∂x equal for all arguments, and returns the functions in the first derivatives.
    fn compare_mixed(&mut self, function: ExternalFunction) -> Vec<ExternalFunction> {
        let arguments = self.arguments(function);
        let slopes: Vec<_> = (0..arguments.len())
            .map(|i| self.graph.partial_derivative(function, i, &arguments))
            .collect();
        for (i, slope) in slopes.iter().enumerate() {
            for (j, other) in slopes.iter().enumerate().skip(i + 1) {
                let mixed = [(*slope, j), (*other, i)].map(|(x, by)| self.derivative(x, by));
                self.equate(mixed, 0);
            }
        }
        applied(&self.graph, &slopes)
    }

    fn arguments(&mut self, function: ExternalFunction) -> Vec<Expression> {
        let count = self.graph.function_arguments(function).len();
        let symbols = (0..).map(Symbol::Argument).take(count);
        symbols.map(|symbol| self.graph.symbol(symbol)).collect()
    }

    fn derivative(&mut self, expression: Expression, argument: usize) -> Expression {
        let argument = u32::try_from(argument).unwrap_or(u32::MAX);
        let columns = self
            .graph
            .jacobian(&[expression], &[Symbol::Argument(argument)]);
        columns[0][0]
    }

    /// Chooses functions such that two expressions in the arguments are equal.
    fn equate(&mut self, pair: [Expression; 2], order: usize) {
        let pair = self.represented(pair);
        let difference = self.graph.subtract(pair[0], pair[1]);
        if self.graph.is_zero(difference) || self.graph.vanishes(&[difference]) {
            return;
        }
        if self.declares(pair[0], pair[1]) || self.declares(pair[1], pair[0]) {
            return;
        }
        let Some([kept, replaced]) = self.functions_that_are_equal(difference) else {
            self.are_equal = false;
            return;
        };
        self.stand_ins.replace(replaced, kept);
        if order < HIGHEST_EXTERNAL_DERIVATIVE {
            let arguments = self.arguments(kept);
            for i in 0..arguments.len() {
                let of = |function| self.graph.partial_derivative(function, i, &arguments);
                let slopes = [kept, replaced].map(of);
                self.equate(slopes, order + 1);
            }
        }
    }

    /// Declares the derivative that `unknown` is, of which no program applies the function, as an expression without it.
    fn declares(&mut self, unknown: Expression, value: Expression) -> bool {
        let Node::Application(derivative, arguments) = self.graph.node(unknown).clone() else {
            return false;
        };
        let Some((function, argument)) = self.graph.undeclared(derivative) else {
            return false;
        };
        let is_of_arguments = self.arguments(derivative) == *arguments;
        let is_declared = self.graph.declared_derivative(function, argument).is_some();
        if is_declared || !is_of_arguments || applied(&self.graph, &[value]).contains(&derivative) {
            return false;
        }
        self.graph.declare_derivative(function, argument, value);
        true
    }

    /// The functions f and g where the difference is c h (f − g) with the same arguments of both.
    fn functions_that_are_equal(&self, difference: Expression) -> Option<[ExternalFunction; 2]> {
        let Node::Sum(terms) = self.graph.node(difference) else {
            return None;
        };
        let [(first, weight), (second, other)] = &terms[..] else {
            return None;
        };
        if !(weight + other).is_zero() {
            return None;
        }
        let [first, second] = [first, second].map(|term| self.factors(*term));
        let [own, others] = [(&first, &second), (&second, &first)].map(|(of, without)| {
            let own = of.iter().filter(|(x, k)| without.get(*x) != Some(*k));
            own.map(|(x, k)| (*x, k.clone())).collect::<Vec<_>>()
        });
        let ([(f, k)], [(g, l)]) = (&own[..], &others[..]) else {
            return None;
        };
        match (self.graph.node(*f), self.graph.node(*g)) {
            (Node::Application(f, of_f), Node::Application(g, of_g)) if of_f == of_g && k == l => {
                Some([(*f).min(*g), (*f).max(*g)])
            }
            _ => None,
        }
    }

    fn factors(&self, term: Expression) -> BTreeMap<Expression, Rational> {
        match self.graph.node(term) {
            Node::Product(factors) => factors.iter().cloned().collect(),
            _ => BTreeMap::from([(term, Rational::ONE)]),
        }
    }

    /// Expressions with the functions that stand for those in them.
    fn represented(&mut self, pair: [Expression; 2]) -> [Expression; 2] {
        let mut values = BTreeMap::new();
        for expression in self.graph.descendants(&pair) {
            if let Node::Application(function, arguments) = self.graph.node(expression).clone() {
                let stand_in = self.stand_ins.of(function);
                if stand_in != function {
                    let value = self.graph.apply(stand_in, &arguments);
                    values.insert(expression, value);
                }
            }
        }
        let values = values.into_iter().collect();
        let replaced = self.graph.replace(&pair, &values);
        [replaced[0], replaced[1]]
    }
}

/// The external functions that expressions apply.
fn applied(graph: &Graph, roots: &[Expression]) -> Vec<ExternalFunction> {
    let mut functions = BTreeSet::new();
    for part in graph.descendants(roots) {
        if let Node::Application(function, _) = graph.node(part) {
            functions.insert(*function);
        }
    }
    functions.into_iter().collect()
}
