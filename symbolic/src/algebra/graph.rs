//! The shared expression graph: an append-only, hash-consed arena (hash consing: Ershov, On programming of
//! arithmetic operations, 1958; Filliâtre and Conchon, Type-safe modular hash-consing, 2006).
//!
//! Smart constructors are the only way in, so every node is in normal form:
//!
//! - a sum is Σ cᵢ·xᵢ with exact nonzero c, its x distinct and sorted, no x a number other than 1 and
//!   none a short sum; a multiple c·x is a sum of one term;
//! - a product is Π xᵢ^kᵢ with exact nonzero k, its x distinct and sorted, without a numerical factor;
//!   a power x^k is a product of one factor;
//! - children precede parents, so that every pass is a loop over indices and never a recursion.
//!
//! Equal terms are therefore equal handles. Products are never expanded. Long sums, products and numbers
//! are not merged into others, so that no chain of them grows with its square.

mod checkpoint;

use std::collections::BTreeSet;

use crate::algebra::contents::Contents;
use crate::algebra::derivative_memory::DerivativeMemory;
use crate::algebra::external_function::ExternalDeclaration;
use crate::algebra::growth::KnownScales;
use crate::algebra::hashing::mix;
use crate::algebra::interner::Interner;
use crate::algebra::node::{Expression, Node};
use crate::algebra::split::KnownSplits;
use crate::{Pass, Passes, Rational, Symbol};

/// The arena of all expressions of a model.
#[derive(Clone, Debug)]
pub struct Graph {
    nodes: Interner,
    /// The passes that are applied to expressions of this graph.
    pub passes: Passes,
    contents: Vec<Contents>,
    /// A bit for each symbol of an expression; symbols may share one.
    symbol_bits: Vec<u64>,
    /// The external functions, in the order of declaration.
    pub(crate) functions: Vec<ExternalDeclaration>,
    /// The splits of sums that have been computed.
    pub(crate) splits: KnownSplits,
    /// The sums with exponential terms that have been scaled.
    pub(crate) scales: KnownScales,
    /// The expressions whose expansion is known to have too many terms.
    pub(crate) swollen: BTreeSet<Expression>,
    /// Whether there is a hyperbolic function.
    pub(crate) has_hyperbolic: bool,
    /// Whether there is an exponential function.
    pub(crate) has_exponential: bool,
    /// The sums x² + y² that slopes of `atan2` divide by.
    pub(crate) squared_distances: BTreeSet<Expression>,
    /// Whether sums of exponentials stay as they are written, as in print.
    pub(crate) leaves_exponentials: bool,
    /// What derivatives are computed in.
    pub(crate) derivatives: DerivativeMemory,
}

impl Default for Graph {
    fn default() -> Self {
        Self::new()
    }
}

impl Graph {
    /// An arena that holds 0 and 1.
    #[must_use]
    pub fn new() -> Self {
        let mut graph = Self {
            nodes: Interner::default(),
            passes: Passes::default(),
            contents: Vec::new(),
            symbol_bits: Vec::new(),
            functions: Vec::new(),
            splits: KnownSplits::default(),
            scales: KnownScales::default(),
            swollen: BTreeSet::new(),
            has_hyperbolic: false,
            has_exponential: false,
            squared_distances: BTreeSet::new(),
            leaves_exponentials: false,
            derivatives: DerivativeMemory::default(),
        };
        graph.intern(Node::Constant(Rational::ZERO));
        graph.intern(Node::Constant(Rational::ONE));
        graph
    }

    /// The number 0.
    #[must_use]
    pub const fn zero(&self) -> Expression {
        Expression(0)
    }

    /// The number 1.
    #[must_use]
    pub const fn one(&self) -> Expression {
        Expression(1)
    }

    /// How many expressions the arena holds.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.nodes().len()
    }

    /// Never: 0 and 1 are always there.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.nodes().is_empty()
    }

    /// The node of `expression`.
    #[must_use]
    pub fn node(&self, expression: Expression) -> &Node {
        &self.nodes.nodes()[expression.index()]
    }

    /// All expressions with their nodes, children before parents.
    #[must_use]
    pub fn nodes(
        &self,
    ) -> impl DoubleEndedIterator<Item = (Expression, &Node)> + ExactSizeIterator {
        self.nodes
            .nodes()
            .iter()
            .enumerate()
            .map(|(index, node)| (handle(index), node))
    }

    /// Whether `expression` is the number 0.
    #[must_use]
    pub fn is_zero(&self, expression: Expression) -> bool {
        expression == self.zero()
    }

    /// The value of `expression`, if it is an exact number.
    #[must_use]
    pub fn as_constant(&self, expression: Expression) -> Option<&Rational> {
        match self.node(expression) {
            Node::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// The subexpressions of the roots, themselves included, children before parents.
    #[must_use]
    pub fn descendants(&self, roots: &[Expression]) -> Vec<Expression> {
        let mut descendants = Vec::new();
        self.visit_descendants(roots, |expression, _| {
            descendants.push(expression);
            true
        });
        descendants.reverse();
        descendants
    }

    /// Visits the subexpressions of the roots, themselves included, parents before children, as long as `visit` says
    /// to go on.
    pub(crate) fn visit_descendants(
        &self,
        roots: &[Expression],
        mut visit: impl FnMut(Expression, &Node) -> bool,
    ) {
        let length = roots.iter().map(|root| root.index() + 1).max().unwrap_or(0);
        let mut reached = vec![0_u64; length.div_ceil(64)];
        for root in roots {
            reached[root.index() / 64] |= 1 << (root.index() % 64);
        }
        // The arena may be much larger than the result, so that whole words are passed over; a plain loop is quick
        // without optimization, too.
        let nodes = self.nodes.nodes();
        let mut word = reached.len();
        while word > 0 {
            word -= 1;
            while reached[word] != 0 {
                let bit = reached[word].ilog2() as usize;
                reached[word] ^= 1 << bit;
                let expression = handle(64 * word + bit);
                let node = &nodes[expression.index()];
                if !visit(expression, node) {
                    return;
                }
                match node {
                    Node::Sum(parts) | Node::Product(parts) => {
                        for (operand, _) in parts {
                            reached[operand.index() / 64] |= 1 << (operand.index() % 64);
                        }
                    }
                    node => node.for_each_operand(|operand| {
                        reached[operand.index() / 64] |= 1 << (operand.index() % 64);
                    }),
                }
            }
        }
    }

    /// Which kinds of symbols `expression` contains, at any depth.
    #[must_use]
    pub fn contents(&self, expression: Expression) -> Contents {
        self.contents[expression.index()]
    }

    /// Whether one of `roots` contains a symbol for which `wanted` holds.
    #[must_use]
    pub fn contains(&self, roots: &[Expression], wanted: impl Fn(Symbol) -> bool) -> bool {
        self.symbols(roots).into_iter().any(wanted)
    }

    /// Whether two expressions have a symbol in common; they may be said to where there are many symbols.
    pub(crate) fn may_share_a_symbol(&self, x: Expression, y: Expression) -> bool {
        self.symbol_bits[x.index()] & self.symbol_bits[y.index()] != 0
    }

    /// The symbols that the roots contain.
    #[must_use]
    pub fn symbols(&self, roots: &[Expression]) -> BTreeSet<Symbol> {
        self.descendants(roots)
            .into_iter()
            .filter_map(|expression| match self.node(expression) {
                Node::Symbol(symbol) => Some(*symbol),
                _ => None,
            })
            .collect()
    }

    /// The index of `node` in the arena, if it is there.
    pub(crate) fn position(&self, node: &Node) -> Option<usize> {
        self.nodes.position(node)
    }

    /// The index of the sum with the opposite terms, if it is there, without making it.
    pub(crate) fn position_of_opposite(&self, terms: &[(Expression, Rational)]) -> Option<usize> {
        let mut code = 2;
        for (x, c) in terms {
            code = mix(mix(code, u64::from(x.0)), (-c).code());
        }
        self.nodes.find(code, |node| match node {
            Node::Sum(others) if others.len() == terms.len() => {
                let mut pairs = others.iter().zip(terms);
                pairs.all(|((x, c), (y, d))| x == y && *c == -d)
            }
            _ => false,
        })
    }

    /// The handle of `node`, which is in normal form.
    pub(crate) fn intern(&mut self, node: Node) -> Expression {
        let position = self.nodes.insert(node);
        if position == self.contents.len() {
            let contents = Contents::of(&self.nodes.nodes()[position], &self.contents);
            self.contents.push(contents);
            let mut bits = 0;
            match &self.nodes.nodes()[position] {
                Node::Symbol(symbol) => bits = symbol.bit(),
                node => node.for_each_operand(|x| bits |= self.symbol_bits[x.index()]),
            }
            self.symbol_bits.push(bits);
        }
        handle(position)
    }

    /// An exact number.
    pub fn constant(&mut self, value: &Rational) -> Expression {
        self.intern(Node::Constant(value.clone()))
    }

    /// An integer.
    pub fn integer(&mut self, value: i64) -> Expression {
        self.intern(Node::Constant(Rational::integer(value)))
    }

    /// The number π.
    pub fn pi(&mut self) -> Expression {
        self.intern(Node::Pi)
    }

    /// A symbol.
    pub fn symbol(&mut self, symbol: Symbol) -> Expression {
        self.intern(Node::Symbol(symbol))
    }

    /// `expression` as an opaque node, which the sums and products that contain it do not merge with: results of
    /// successive steps, as of an elimination, then grow with the number of steps and not exponentially.
    pub fn opaque(&mut self, expression: Expression) -> Expression {
        match self.node(expression) {
            Node::Sum(_) | Node::Product(_) if self.passes.has(Pass::Opaque) => {
                self.intern(Node::Opaque(expression))
            }
            _ => expression,
        }
    }

    /// What a program computes for an expression: without opaque nodes, and without the factor of a multiple.
    pub(crate) fn computed(&self, expression: Expression) -> Expression {
        let mut computed = expression;
        loop {
            computed = match self.node(computed) {
                Node::Opaque(inner) => *inner,
                Node::Sum(terms) if terms.len() == 1 => terms[0].0,
                _ => return computed,
            };
        }
    }

    /// x + y.
    pub fn add(&mut self, x: Expression, y: Expression) -> Expression {
        self.sum([(x, Rational::ONE), (y, Rational::ONE)])
    }

    /// x − y.
    pub fn subtract(&mut self, x: Expression, y: Expression) -> Expression {
        self.sum([(x, Rational::ONE), (y, Rational::MINUS_ONE)])
    }

    /// −x.
    pub fn negate(&mut self, x: Expression) -> Expression {
        self.sum([(x, Rational::MINUS_ONE)])
    }

    /// c·x.
    pub fn scale(&mut self, x: Expression, factor: &Rational) -> Expression {
        self.sum([(x, factor.clone())])
    }

    /// x + c.
    pub fn add_constant(&mut self, x: Expression, value: &Rational) -> Expression {
        let one = self.one();
        self.sum([(x, Rational::ONE), (one, value.clone())])
    }

    /// x · y.
    pub fn multiply(&mut self, x: Expression, y: Expression) -> Expression {
        self.product([(x, Rational::ONE), (y, Rational::ONE)])
    }

    /// x / y.
    pub fn divide(&mut self, x: Expression, y: Expression) -> Expression {
        self.product([(x, Rational::ONE), (y, Rational::MINUS_ONE)])
    }

    /// x to an exact power.
    pub fn power(&mut self, x: Expression, exponent: &Rational) -> Expression {
        self.product([(x, exponent.clone())])
    }

    /// x².
    pub fn square(&mut self, x: Expression) -> Expression {
        self.product([(x, Rational::integer(2))])
    }

    /// √x.
    pub fn square_root(&mut self, x: Expression) -> Expression {
        self.product([(x, Rational::HALF)])
    }
}

fn handle(index: usize) -> Expression {
    // Four billion nodes of at least forty bytes do not fit into a compiler's memory.
    Expression(u32::try_from(index).unwrap_or(u32::MAX))
}
