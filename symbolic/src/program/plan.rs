//! How the values of a program are made from each other, while that can still be changed.
//!
//! Comes in: roots of the graph. Goes out: one [`Recipe`] for each value. Where the graph has sums and
//! products in normal form, a plan has lists that passes may regroup: [`factoring`](crate::program::factoring)
//! takes common factors out of sums, [`sharing`](crate::program::sharing) makes one value of what several lists
//! have in common. What a value is does not change, only how it is computed.

use std::collections::BTreeMap;

use crate::program::removable::{Removable, removable};
use crate::{Binary, Expression, Function, Graph, Node, Pass, Rational, Symbol, Unary};

/// A value of a plan.
pub(crate) type Value = usize;

/// How a value is made.
#[derive(Clone, Debug)]
pub(crate) enum Recipe {
    Constant(Rational),
    Pi,
    /// The smallest positive number with all digits; 0 where numbers are exact.
    MinPositive,
    Symbol(Symbol),
    /// Σ cᵢ·xᵢ, each x once.
    Sum(Vec<(Value, Rational)>),
    /// The product of the first list over that of the second; factors may repeat.
    Quotient(Vec<Value>, Vec<Value>),
    /// x^k for a large whole k.
    Power(Value, usize),
    SquareRoot(Value),
    Unary(Unary, Value),
    Binary(Binary, Value, Value),
    Application(Function, Vec<Value>),
}

/// Whole powers up to this one are written as repeated factors, of which parts can be shared.
const LARGEST_REPEATED: usize = 8;

/// The recipes of all values that a program computes.
pub(crate) struct Plan {
    pub(crate) recipes: Vec<Recipe>,
    /// The expression that a value is, if it is one of the graph's.
    pub(crate) expressions: Vec<Option<Expression>>,
    /// The value of each expression, by its index. There is none for those that are not computed.
    values: Vec<Value>,
    /// Values that are made of others but stand for no expression, by what they are.
    roots: BTreeMap<Value, Value>,
    reciprocals: BTreeMap<Value, Value>,
    positive: BTreeMap<Value, Value>,
}

/// How a product divides.
struct Divisors {
    /// How many products divide by each power, and whether they have a limit where it is 0.
    uses: BTreeMap<(Expression, Rational, bool), usize>,
    removable: Removable,
}

impl Plan {
    /// The plan that computes each expression as its normal form says.
    pub(crate) fn new(graph: &Graph, roots: &[Expression]) -> Self {
        let mut plan = Self {
            recipes: Vec::new(),
            expressions: Vec::new(),
            values: Vec::new(),
            roots: BTreeMap::new(),
            reciprocals: BTreeMap::new(),
            positive: BTreeMap::new(),
        };
        let descendants = graph.descendants(roots);
        let divisors = Divisors::of(graph, &descendants);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        plan.values = vec![Value::MAX; length];
        for expression in descendants {
            let value = match graph.node(expression) {
                Node::Whole(inner) => plan.value(*inner),
                Node::Product(factors) => {
                    let recipe = plan.quotient(expression, factors, &divisors);
                    plan.push(recipe, Some(expression))
                }
                node => {
                    let recipe = plan.recipe(node);
                    plan.push(recipe, Some(expression))
                }
            };
            plan.values[expression.index()] = value;
        }
        plan
    }

    /// The value that is `expression`.
    pub(crate) fn value(&self, expression: Expression) -> Value {
        self.values[expression.index()]
    }

    /// A new value.
    pub(crate) fn push(&mut self, recipe: Recipe, expression: Option<Expression>) -> Value {
        self.recipes.push(recipe);
        self.expressions.push(expression);
        self.recipes.len() - 1
    }

    /// How often each value is an operand or a root of what the roots are made of.
    pub(crate) fn uses(&self, roots: &[Expression]) -> Vec<usize> {
        let mut uses = vec![0; self.recipes.len()];
        let mut waiting: Vec<Value> = roots.iter().map(|root| self.value(*root)).collect();
        while let Some(value) = waiting.pop() {
            uses[value] += 1;
            if uses[value] == 1 {
                self.recipes[value].for_each_operand(|operand| waiting.push(operand));
            }
        }
        uses
    }

    /// Forgets how values are made that the roots are no longer made of, so that nothing is shared with
    /// them.
    pub(crate) fn forget_unused(&mut self, roots: &[Expression]) {
        let uses = self.uses(roots);
        for (recipe, uses) in self.recipes.iter_mut().zip(uses) {
            if uses == 0 {
                *recipe = Recipe::Constant(Rational::ZERO);
            }
        }
    }

    /// How a node is made that is no product.
    fn recipe(&self, node: &Node) -> Recipe {
        match node {
            Node::Constant(number) => Recipe::Constant(number.clone()),
            Node::Pi => Recipe::Pi,
            Node::Symbol(symbol) => Recipe::Symbol(*symbol),
            // An expression and the same kept whole are one value.
            Node::Sum(terms) => Recipe::Sum(merged(
                terms.iter().map(|(x, c)| (self.value(*x), c.clone())),
            )),
            Node::Unary(function, x) => Recipe::Unary(*function, self.value(*x)),
            Node::Binary(function, x, y) => {
                Recipe::Binary(*function, self.value(*x), self.value(*y))
            }
            Node::Application(function, arguments) => {
                let arguments = arguments.iter().map(|x| self.value(*x));
                Recipe::Application(*function, arguments.collect())
            }
            // Those have been made otherwise.
            Node::Product(_) | Node::Whole(_) => Recipe::Constant(Rational::ZERO),
        }
    }

    fn quotient(
        &mut self,
        product: Expression,
        factors: &[(Expression, Rational)],
        divisors: &Divisors,
    ) -> Recipe {
        let (mut numerator, mut denominator) = (Vec::new(), Vec::new());
        for (base, exponent) in factors {
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
        Recipe::Quotient(numerator, denominator)
    }

    /// Appends the factors of x^k for k > 0.
    fn push_power(&mut self, factors: &mut Vec<Value>, x: Value, exponent: &Rational) {
        let (numerator, denominator) = exponent.to_fraction().unwrap_or((0, 0));
        match (usize::try_from(numerator).unwrap_or(0), denominator) {
            (k, 1) if k <= LARGEST_REPEATED => factors.extend((0..k).map(|_| x)),
            (k, 1) => {
                let power = self.push(Recipe::Power(x, k), None);
                factors.push(power);
            }
            (_, 2) => {
                self.push_power(factors, x, &Rational::integer(numerator / 2));
                let root = self.square_root(x);
                factors.push(root);
            }
            _ => {
                let exponent = self.push(Recipe::Constant(exponent.clone()), None);
                let power = self.push(Recipe::Binary(Binary::Power, x, exponent), None);
                factors.push(power);
            }
        }
    }

    fn square_root(&mut self, x: Value) -> Value {
        if let Some(root) = self.roots.get(&x) {
            return *root;
        }
        let root = self.push(Recipe::SquareRoot(x), None);
        self.roots.insert(x, root);
        root
    }

    /// What is not negative, moved away from 0.
    fn positive(&mut self, x: Value) -> Value {
        if let Some(positive) = self.positive.get(&x) {
            return *positive;
        }
        let least = self.push(Recipe::MinPositive, None);
        let terms = [x, least].map(|value| (value, Rational::ONE));
        let positive = self.push(Recipe::Sum(terms.to_vec()), None);
        self.positive.insert(x, positive);
        positive
    }

    fn reciprocal(&mut self, x: Value) -> Value {
        if let Some(reciprocal) = self.reciprocals.get(&x) {
            return *reciprocal;
        }
        let reciprocal = self.push(Recipe::Quotient(Vec::new(), vec![x]), None);
        self.reciprocals.insert(x, reciprocal);
        reciprocal
    }
}

impl Recipe {
    /// Calls `visit` with each operand, as often as it is one.
    pub(crate) fn for_each_operand(&self, mut visit: impl FnMut(Value)) {
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
pub(crate) fn merged(terms: impl IntoIterator<Item = (Value, Rational)>) -> Vec<(Value, Rational)> {
    let mut sums: BTreeMap<Value, Rational> = BTreeMap::new();
    for (x, c) in terms {
        let sum = sums.entry(x).or_insert(Rational::ZERO);
        *sum = &*sum + &c;
    }
    sums.into_iter().filter(|(_, c)| !c.is_zero()).collect()
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
