//! Symbolic derivatives by forward accumulation over the arena (Griewank and Walther, Evaluating Derivatives,
//! 2nd edition 2008, chapter 3).
//!
//! A derivative with respect to a symbol visits only the expressions that contain it.

use std::rc::Rc;

use crate::algebra::dependence::Dependence;
use crate::algebra::hashing::Table;
use crate::algebra::index_table::PairTable;
use crate::algebra::interner::Interner;
use crate::limits::MAX_FLAT_PRODUCT_RULE;
use crate::{Direction, Expression, ExternalFunction, Graph, Node, Pass, Rational, Symbol};

impl Graph {
    /// The derivatives ∂rootᵢ/∂symbolⱼ, as one list over i for each j.
    pub fn jacobian(&mut self, roots: &[Expression], symbols: &[Symbol]) -> Vec<Vec<Expression>> {
        let mut tangents = Tangents::new(self, roots, symbols);
        (0..symbols.len())
            .map(|position| tangents.column(self, roots, position))
            .collect()
    }

    /// The derivatives ∂rootᵢ/∂symbol.
    pub fn derivatives(&mut self, roots: &[Expression], symbol: Symbol) -> Vec<Expression> {
        let direction = Direction::from([(symbol, self.one())]);
        self.directional_derivatives(roots, &direction)
    }

    /// The derivative ∂root/∂symbol.
    pub fn derivative(&mut self, root: Expression, symbol: Symbol) -> Expression {
        self.derivatives(&[root], symbol)[0]
    }

    /// The derivatives Σ ∂rootᵢ/∂s · ds over all symbols s of the direction.
    pub fn directional_derivatives(
        &mut self,
        roots: &[Expression],
        direction: &Direction,
    ) -> Vec<Expression> {
        let zero = self.zero();
        let descendants = self.descendants(roots);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut derivatives = self.derivatives.take_zeros(length, zero);
        let mut product_rule_factors = ProductRuleFactors::default();
        for expression in &descendants {
            let expression = *expression;
            derivatives[expression.index()] = match self.node(expression) {
                Node::Symbol(symbol) => direction.get(symbol).copied().unwrap_or(zero),
                _ => self.chain_rule(expression, &derivatives, &mut product_rule_factors),
            };
        }
        let results = roots.iter().map(|root| derivatives[root.index()]).collect();
        for expression in descendants {
            derivatives[expression.index()] = zero;
        }
        self.derivatives.return_zeros(derivatives);
        results
    }

    /// The derivative of what is no symbol from those of its operands.
    fn chain_rule(
        &mut self,
        expression: Expression,
        derivatives: &[Expression],
        product_rule_factors: &mut ProductRuleFactors,
    ) -> Expression {
        let zero = self.zero();
        let of = |operand: Expression| derivatives[operand.index()];
        match *self.node(expression) {
            Node::Constant(_) | Node::Pi | Node::Symbol(_) => zero,
            Node::Sum(ref terms) => {
                let changes = changes_of_terms(terms, derivatives, zero);
                self.sum(changes)
            }
            Node::Product(ref factors)
                if factors.len() > MAX_FLAT_PRODUCT_RULE && self.passes.has(Pass::Opaque) =>
            {
                self.derivative_of_pairs(expression, derivatives, product_rule_factors)
            }
            Node::Product(ref factors) => {
                let mut terms = Vec::new();
                for (position, (x, exponent)) in factors.iter().enumerate() {
                    if of(*x) != zero {
                        terms.push((position, of(*x), exponent.clone()));
                    }
                }
                self.product_rule(expression, terms, product_rule_factors)
            }
            Node::Unary(function, x) => {
                if of(x) == zero {
                    return zero;
                }
                let slope = function.derivative(self, x);
                self.multiply(slope, of(x))
            }
            Node::Opaque(x) => of(x),
            Node::Binary(function, x, y) => {
                if of(x) == zero && of(y) == zero {
                    return zero;
                }
                let [over_x, over_y] = function.derivatives(self, x, y);
                let along_x = self.multiply(over_x, of(x));
                let along_y = self.multiply(over_y, of(y));
                self.add(along_x, along_y)
            }
            Node::Application(function, ref arguments) => {
                let arguments = arguments.to_vec();
                self.derivative_of_application(function, &arguments, derivatives)
            }
        }
    }

    /// Σ ∂f/∂xᵢ dxᵢ of an external function.
    fn derivative_of_application(
        &mut self,
        function: ExternalFunction,
        arguments: &[Expression],
        derivatives: &[Expression],
    ) -> Expression {
        let mut terms = Vec::new();
        for (position, x) in arguments.iter().enumerate() {
            let change = derivatives[x.index()];
            if !self.is_zero(change) {
                let slope = self.partial_derivative(function, position, arguments);
                terms.push((self.multiply(slope, change), Rational::ONE));
            }
        }
        self.sum(terms)
    }

    /// The derivative of a long product, by that of each pair in the tree of its factors.
    fn derivative_of_pairs(
        &mut self,
        product: Expression,
        derivatives: &[Expression],
        product_rule_factors: &mut ProductRuleFactors,
    ) -> Expression {
        let mut changes: Table<Expression, Expression> = Table::default();
        let tree = product_rule_factors.tree(self, product);
        let mut change = self.zero();
        for pair in tree.iter() {
            let inner = match *self.node(*pair) {
                Node::Opaque(inner) => inner,
                _ => *pair,
            };
            let Node::Product(factors) = self.node(inner) else {
                continue;
            };
            let mut terms = Vec::new();
            for (position, (x, exponent)) in factors.iter().enumerate() {
                let known = changes.get(x).or(derivatives.get(x.index()));
                if let Some(change) = known.filter(|change| !self.is_zero(**change)) {
                    terms.push((position, *change, exponent.clone()));
                }
            }
            change = self.product_rule(inner, terms, product_rule_factors);
            changes.insert(*pair, change);
        }
        change
    }

    /// d Π xᵢ^kᵢ = Σⱼ kⱼ dxⱼ xⱼ^(kⱼ−1) Π_{i≠j} xᵢ^kᵢ, which divides by nothing; of the factors that
    /// change, with their positions, changes and exponents.
    fn product_rule(
        &mut self,
        product: Expression,
        changes: Vec<(usize, Expression, Rational)>,
        product_rule_factors: &mut ProductRuleFactors,
    ) -> Expression {
        let mut terms = Vec::with_capacity(changes.len());
        for (position, change, exponent) in changes {
            terms.push((
                product_rule_factors.times(self, product, position, change),
                exponent,
            ));
        }
        match terms.as_slice() {
            [(only, exponent)] if exponent.is_one() => *only,
            _ => self.sum(terms),
        }
    }
}

/// The derivatives of the terms of a sum, with their coefficients.
fn changes_of_terms(
    terms: &[(Expression, Rational)],
    derivatives: &[Expression],
    zero: Expression,
) -> Vec<(Expression, Rational)> {
    let mut changes: Vec<(Expression, Rational)> = Vec::new();
    for (x, c) in terms {
        let change = derivatives[x.index()];
        if change == zero {
            continue;
        }
        // Adjacent terms often have the same derivative.
        match changes.last_mut() {
            Some((last, sum)) if *last == change => *sum = &*sum + c,
            _ => changes.push((change, c.clone())),
        }
    }
    changes
}

/// The products of all factors but one in the product rule, multiplied by derivatives of the factor.
///
/// In a chain, many products differ in one factor only, such as r·x₁, r·x₂ …, and those factors often
/// change alike. Then one product r·dx is the derivative of them all, and is made once.
#[derive(Default)]
pub(crate) struct ProductRuleFactors {
    /// xⱼ^(kⱼ−1) Π_{i≠j} xᵢ^kᵢ, written as products that are no part of the graph.
    lists: Interner,
    /// The index of the list, by product and position of the factor.
    of: PairTable<usize>,
    /// A list times a derivative, once computed.
    products: PairTable<Expression>,
    /// Long products as trees of pairs, children before parents.
    trees: Table<Expression, Rc<[Expression]>>,
}

impl ProductRuleFactors {
    /// dxⱼ xⱼ^(kⱼ−1) Π_{i≠j} xᵢ^kᵢ.
    fn times(
        &mut self,
        graph: &mut Graph,
        product: Expression,
        position: usize,
        change: Expression,
    ) -> Expression {
        let list = match self.of.get(product.index(), position) {
            Some(list) => list,
            None => self.enter(graph, product, position),
        };
        if let Some(known) = self.products.get(list, change.index()) {
            return known;
        }
        let Node::Product(factors) = &self.lists.nodes()[list] else {
            return graph.zero();
        };
        // What comes last is the factor itself; the others are in normal form already.
        let others = factors.len() - 1;
        let (base, exponent) = &factors[others];
        let mut pending = Vec::with_capacity(4);
        if !exponent.is_zero() {
            pending.push((*base, exponent.clone()));
        }
        pending.push((change, Rational::ONE));
        let mut settled = Vec::with_capacity(others + 4);
        settled.extend_from_slice(&factors[..others]);
        let value = graph.multiply_factors(settled, pending);
        self.products.insert(list, change.index(), value);
        value
    }

    /// A long product as a tree of pairs, children before parents; itself the last.
    fn tree(&mut self, graph: &mut Graph, product: Expression) -> Rc<[Expression]> {
        if let Some(tree) = self.trees.get(&product) {
            return Rc::clone(tree);
        }
        let tree: Rc<[Expression]> = graph.tree_of_pairs(product).into();
        self.trees.insert(product, Rc::clone(&tree));
        tree
    }

    fn enter(&mut self, graph: &Graph, product: Expression, position: usize) -> usize {
        let mut factors = Vec::new();
        if let Node::Product(all) = graph.node(product) {
            factors.reserve_exact(all.len());
            factors.extend_from_slice(&all[..position]);
            factors.extend_from_slice(&all[position + 1..]);
            let (base, exponent) = &all[position];
            let exponent = exponent - &Rational::ONE;
            let base = if exponent.is_zero() {
                graph.one()
            } else {
                *base
            };
            factors.push((base, exponent));
        }
        let list = self.lists.insert(Node::Product(factors.into()));
        self.of.insert(product.index(), position, list);
        list
    }
}

/// The columns of a Jacobian, one symbol after the other.
pub(crate) struct Tangents {
    symbols: Vec<Symbol>,
    dependence: Dependence,
    /// By expression, with respect to the current symbol; between two columns all 0.
    derivatives: Vec<Expression>,
    product_rule_factors: ProductRuleFactors,
}

impl Tangents {
    /// Prepares to differentiate `roots` with respect to each of `symbols`.
    pub(crate) fn new(graph: &Graph, roots: &[Expression], symbols: &[Symbol]) -> Self {
        let length = roots.iter().map(|root| root.index() + 1).max().unwrap_or(0);
        Self {
            symbols: symbols.to_vec(),
            dependence: Dependence::of(graph, roots, symbols),
            derivatives: vec![graph.zero(); length],
            product_rule_factors: ProductRuleFactors::default(),
        }
    }

    /// The derivatives of all roots with respect to the symbol at `position`.
    pub(crate) fn column(
        &mut self,
        graph: &mut Graph,
        roots: &[Expression],
        position: usize,
    ) -> Vec<Expression> {
        let dependents = self.dependence.on(position).to_vec();
        self.forward(graph, &dependents, roots, position)
    }

    /// The derivatives of some of the roots with respect to the symbol at `position`.
    pub(crate) fn part_of_column(
        &mut self,
        graph: &mut Graph,
        roots: &[Expression],
        position: usize,
    ) -> Vec<Expression> {
        let dependents = self.dependence.within(graph, roots, position);
        self.forward(graph, &dependents, roots, position)
    }

    /// The derivatives of `roots`, where all that contains the symbol stands among `dependents`.
    fn forward(
        &mut self,
        graph: &mut Graph,
        dependents: &[Expression],
        roots: &[Expression],
        position: usize,
    ) -> Vec<Expression> {
        let symbol = self.symbols[position];
        let derivatives = &mut self.derivatives;
        for expression in dependents {
            derivatives[expression.index()] = match graph.node(*expression) {
                Node::Symbol(found) if *found == symbol => graph.one(),
                _ => graph.chain_rule(*expression, derivatives, &mut self.product_rule_factors),
            };
        }
        let results = roots.iter().map(|root| derivatives[root.index()]).collect();
        for expression in dependents {
            derivatives[expression.index()] = graph.zero();
        }
        results
    }
}
