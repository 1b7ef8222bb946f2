//! The intermediate representation between the graph and straight-line code: a DAG of n-ary operations (Aho, Lam,
//! Sethi and Ullman, Compilers, 2nd edition 2007, section 6.1).
//!
//! Input: roots of the graph. Output: one [`DagOperation`] for each value. Where the graph has sums and products in
//! normal form, the DAG has lists that passes may regroup: [`factoring`](crate::program::passes::factoring) takes
//! common factors out of sums, [`sharing`](crate::program::passes::sharing) eliminates common subexpressions. A pass
//! changes how a value is computed, never the value.

use std::collections::BTreeMap;

use crate::limits::HIGHEST_REPEATED_POWER;
use crate::program::angle_slopes::{ScaledSquares, times_divided};
use crate::program::removable_singularities::{Removable, removable};
use crate::{Binary, Expression, ExternalFunction, Graph, Node, Pass, Rational, Symbol, Unary};

/// The index of a value in a DAG.
pub(crate) type ValueId = usize;

/// The operation that computes a value.
#[derive(Clone, Debug)]
pub(crate) enum DagOperation {
    Constant(Rational),
    Pi,
    /// The smallest positive number with all digits; 0 where numbers are exact.
    MinPositive,
    Symbol(Symbol),
    /// Σ cᵢ·xᵢ, each x once.
    Sum(Vec<(ValueId, Rational)>),
    /// The product of the first list over that of the second; factors may repeat.
    Quotient(Vec<ValueId>, Vec<ValueId>),
    /// x^k for a large integer k.
    Power(ValueId, usize),
    SquareRoot(ValueId),
    Unary(Unary, ValueId),
    Binary(Binary, ValueId, ValueId),
    Application(ExternalFunction, Vec<ValueId>),
}

/// The operations of all values of a program.
pub(crate) struct Dag {
    pub(crate) operations: Vec<DagOperation>,
    /// The expression that a value is, if it is one of the graph's.
    pub(crate) expressions: Vec<Option<Expression>>,
    /// The value of each expression, by its index. There is none for those that are not computed.
    values: Vec<ValueId>,
    /// Square roots, reciprocals and sums with the smallest positive number, by operand.
    roots: BTreeMap<ValueId, ValueId>,
    reciprocals: BTreeMap<ValueId, ValueId>,
    positive: BTreeMap<ValueId, ValueId>,
    /// The squared distances that slopes of angles divide by.
    pub(crate) scaled: BTreeMap<Expression, ScaledSquares>,
}

/// The divisors of all products.
struct Divisors {
    /// How many products divide by each power, and whether they have a limit where its base is 0.
    uses: BTreeMap<(Expression, Rational, bool), usize>,
    removable: Removable,
}

impl Dag {
    /// The DAG that computes each expression as its normal form says.
    pub(crate) fn new(graph: &Graph, roots: &[Expression]) -> Self {
        let mut dag = Self {
            operations: Vec::new(),
            expressions: Vec::new(),
            values: Vec::new(),
            roots: BTreeMap::new(),
            reciprocals: BTreeMap::new(),
            positive: BTreeMap::new(),
            scaled: BTreeMap::new(),
        };
        let descendants = graph.descendants(roots);
        let divisors = Divisors::of(graph, &descendants);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        dag.values = vec![ValueId::MAX; length];
        for expression in descendants {
            let value = match graph.node(expression) {
                Node::Opaque(inner) => dag.value(*inner),
                Node::Product(factors) => {
                    let operation = dag.quotient(graph, expression, factors, &divisors);
                    dag.push(operation, Some(expression))
                }
                node => {
                    let operation = dag.operation(node);
                    dag.push(operation, Some(expression))
                }
            };
            dag.values[expression.index()] = value;
        }
        dag
    }

    /// The value that is `expression`.
    pub(crate) fn value(&self, expression: Expression) -> ValueId {
        self.values[expression.index()]
    }

    /// A new value.
    pub(crate) fn push(
        &mut self,
        operation: DagOperation,
        expression: Option<Expression>,
    ) -> ValueId {
        self.operations.push(operation);
        self.expressions.push(expression);
        self.operations.len() - 1
    }

    /// The number of uses of each value, as an operand or a root, within what the roots need.
    pub(crate) fn uses(&self, roots: &[Expression]) -> Vec<usize> {
        let mut uses = vec![0; self.operations.len()];
        let mut waiting: Vec<ValueId> = roots.iter().map(|root| self.value(*root)).collect();
        while let Some(value) = waiting.pop() {
            uses[value] += 1;
            if uses[value] == 1 {
                self.operations[value].for_each_operand(|operand| waiting.push(operand));
            }
        }
        uses
    }

    /// Dead code elimination: forgets the operations of values that the roots do not need, so that nothing is shared
    /// with them.
    pub(crate) fn eliminate_dead_values(&mut self, roots: &[Expression]) {
        let uses = self.uses(roots);
        for (operation, uses) in self.operations.iter_mut().zip(uses) {
            if uses == 0 {
                *operation = DagOperation::Constant(Rational::ZERO);
            }
        }
    }

    /// The operation of a node that is no product.
    fn operation(&self, node: &Node) -> DagOperation {
        match node {
            Node::Constant(number) => DagOperation::Constant(number.clone()),
            Node::Pi => DagOperation::Pi,
            Node::Symbol(symbol) => DagOperation::Symbol(*symbol),
            // An expression and its opaque node are one value.
            Node::Sum(terms) => DagOperation::Sum(merged(
                terms.iter().map(|(x, c)| (self.value(*x), c.clone())),
            )),
            Node::Unary(function, x) => DagOperation::Unary(*function, self.value(*x)),
            Node::Binary(function, x, y) => {
                DagOperation::Binary(*function, self.value(*x), self.value(*y))
            }
            Node::Application(function, arguments) => {
                let arguments = arguments.iter().map(|x| self.value(*x));
                DagOperation::Application(*function, arguments.collect())
            }
            // Handled by the caller.
            Node::Product(_) | Node::Opaque(_) => DagOperation::Constant(Rational::ZERO),
        }
    }

    fn quotient(
        &mut self,
        graph: &Graph,
        product: Expression,
        factors: &[(Expression, Rational)],
        divisors: &Divisors,
    ) -> DagOperation {
        let (mut numerator, mut denominator) = (Vec::new(), Vec::new());
        let mut distances = Vec::new();
        for (base, exponent) in factors {
            if let Some(times) = times_divided(exponent)
                && let Some(squares) = self.scaled_squares(graph, *base)
            {
                let shared = divisors.are_shared(*base, exponent, false);
                distances.push((squares, times, shared));
                continue;
            }
            let base_value = self.value(*base);
            if !exponent.is_negative() {
                self.push_power(&mut numerator, base_value, exponent);
                continue;
            }
            let mut powers = Vec::new();
            self.push_power(&mut powers, base_value, &-exponent);
            let removable = divisors.removable.contains(&(product, *base));
            if removable {
                powers = powers.into_iter().map(|x| self.positive(x)).collect();
            }
            if divisors.are_shared(*base, exponent, removable) {
                let reciprocals: Vec<_> = powers.into_iter().map(|x| self.reciprocal(x)).collect();
                numerator.extend(reciprocals);
            } else {
                denominator.extend(powers);
            }
        }
        numerator.sort_unstable();
        denominator.sort_unstable();
        let mut parts = (numerator, denominator);
        for (squares, times, shared) in distances {
            parts = self.over_squares(parts, squares, times, shared);
        }
        DagOperation::Quotient(parts.0, parts.1)
    }

    /// Appends the factors of x^k for k > 0.
    pub(crate) fn push_power(
        &mut self,
        factors: &mut Vec<ValueId>,
        x: ValueId,
        exponent: &Rational,
    ) {
        let (numerator, denominator) = exponent.to_fraction().unwrap_or((0, 0));
        match (usize::try_from(numerator).unwrap_or(0), denominator) {
            (k, 1) if k <= HIGHEST_REPEATED_POWER => factors.extend((0..k).map(|_| x)),
            (k, 1) => {
                let power = self.push(DagOperation::Power(x, k), None);
                factors.push(power);
            }
            (_, 2) => {
                self.push_power(factors, x, &Rational::integer(numerator / 2));
                let root = self.square_root(x);
                factors.push(root);
            }
            _ => {
                let exponent = self.push(DagOperation::Constant(exponent.clone()), None);
                let power = self.push(DagOperation::Binary(Binary::Power, x, exponent), None);
                factors.push(power);
            }
        }
    }

    fn square_root(&mut self, x: ValueId) -> ValueId {
        if let Some(root) = self.roots.get(&x) {
            return *root;
        }
        let root = self.push(DagOperation::SquareRoot(x), None);
        self.roots.insert(x, root);
        root
    }

    /// A nonnegative value, moved away from 0.
    fn positive(&mut self, x: ValueId) -> ValueId {
        if let Some(positive) = self.positive.get(&x) {
            return *positive;
        }
        let least = self.push(DagOperation::MinPositive, None);
        let terms = [x, least].map(|value| (value, Rational::ONE));
        let positive = self.push(DagOperation::Sum(terms.to_vec()), None);
        self.positive.insert(x, positive);
        positive
    }

    pub(crate) fn reciprocal(&mut self, x: ValueId) -> ValueId {
        if let Some(reciprocal) = self.reciprocals.get(&x) {
            return *reciprocal;
        }
        let reciprocal = self.push(DagOperation::Quotient(Vec::new(), vec![x]), None);
        self.reciprocals.insert(x, reciprocal);
        reciprocal
    }
}

impl DagOperation {
    /// Calls `visit` with each operand, as often as it is one.
    pub(crate) fn for_each_operand(&self, mut visit: impl FnMut(ValueId)) {
        match self {
            Self::Constant(_) | Self::Pi | Self::MinPositive | Self::Symbol(_) => {}
            Self::Sum(terms) => terms.iter().for_each(|(x, _)| visit(*x)),
            Self::Quotient(numerator, denominator) => {
                numerator.iter().chain(denominator).for_each(|x| visit(*x));
            }
            Self::Power(x, _) | Self::SquareRoot(x) | Self::Unary(_, x) => visit(*x),
            Self::Binary(_, x, y) => {
                visit(*x);
                visit(*y);
            }
            Self::Application(_, arguments) => arguments.iter().for_each(|x| visit(*x)),
        }
    }
}

/// Terms with equal values added up.
pub(crate) fn merged(
    terms: impl IntoIterator<Item = (ValueId, Rational)>,
) -> Vec<(ValueId, Rational)> {
    let mut terms: Vec<_> = terms.into_iter().collect();
    terms.sort_by_key(|(x, _)| *x);
    let mut sums: Vec<(ValueId, Rational)> = Vec::with_capacity(terms.len());
    for (x, c) in terms {
        match sums.last_mut() {
            Some((last, sum)) if *last == x => *sum = &*sum + &c,
            _ => sums.push((x, c)),
        }
    }
    sums.retain(|(_, c)| !c.is_zero());
    sums
}

impl Divisors {
    fn of(graph: &Graph, descendants: &[Expression]) -> Self {
        let removable = removable(graph, descendants);
        let mut uses = BTreeMap::new();
        if graph.passes.has(Pass::Reciprocals) {
            for product in descendants {
                if let Node::Product(factors) = graph.node(*product) {
                    for (x, k) in factors.iter().filter(|(_, k)| k.is_negative()) {
                        let has_limit = removable.contains(&(*product, *x));
                        *uses.entry((*x, k.clone(), has_limit)).or_default() += 1;
                    }
                }
            }
        }
        Self { uses, removable }
    }

    /// Whether several products divide by a power.
    fn are_shared(&self, base: Expression, exponent: &Rational, removable: bool) -> bool {
        let uses = self.uses.get(&(base, exponent.clone(), removable));
        uses.is_some_and(|uses| *uses > 1)
    }
}
