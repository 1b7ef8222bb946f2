//! Expressions as a user writes them: trees that nothing has been done to.

use lagrangian_symbolic::{Binary, Expression, Graph, Rational, Symbol, Unary};
use proptest::prelude::*;

use crate::{Number, external};

/// A tree of operations.
#[derive(Clone, Debug)]
pub enum Tree {
    Number(i64, i64),
    Pi,
    Symbol(Symbol),
    Add(Box<Tree>, Box<Tree>),
    Subtract(Box<Tree>, Box<Tree>),
    Negate(Box<Tree>),
    Multiply(Box<Tree>, Box<Tree>),
    Divide(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, i64, i64),
    Opaque(Box<Tree>),
    Unary(Unary, Box<Tree>),
    Binary(Binary, Box<Tree>, Box<Tree>),
    /// An external function, by its number.
    Application(usize, Vec<Tree>),
}

/// The symbols in random trees.
pub const SYMBOLS: [Symbol; 6] = [
    Symbol::Coordinate(0),
    Symbol::Coordinate(1),
    Symbol::Velocity(0),
    Symbol::Acceleration(1),
    Symbol::Parameter(0),
    Symbol::Parameter(1),
];

/// Trees of a few dozen operations at most, rich in coincidences: few symbols and small numbers.
pub fn trees() -> impl Strategy<Value = Tree> {
    let number = prop_oneof![
        4 => (-4_i64..=4).prop_map(|n| Tree::Number(n, 1)),
        1 => (-9_i64..=9, 1_i64..=9).prop_map(|(n, d)| Tree::Number(n, d)),
        1 => (0_i64..2000).prop_map(|n| Tree::Number(n, 1000)),
    ];
    let leaf = prop_oneof![
        6 => prop::sample::select(&SYMBOLS).prop_map(Tree::Symbol),
        3 => number,
        1 => Just(Tree::Pi),
    ];
    leaf.prop_recursive(6, 40, 2, |inner| {
        let pair = || {
            (
                inner.clone().prop_map(Box::new),
                inner.clone().prop_map(Box::new),
            )
        };
        let one = || inner.clone().prop_map(Box::new);
        prop_oneof![
            3 => pair().prop_map(|(x, y)| Tree::Add(x, y)),
            2 => pair().prop_map(|(x, y)| Tree::Subtract(x, y)),
            1 => one().prop_map(Tree::Negate),
            4 => pair().prop_map(|(x, y)| Tree::Multiply(x, y)),
            2 => pair().prop_map(|(x, y)| Tree::Divide(x, y)),
            2 => (one(), -3_i64..=4).prop_map(|(x, n)| Tree::Power(x, n, 1)),
            2 => (one(), -3_i64..=4, 2_i64..=3).prop_map(|(x, n, d)| Tree::Power(x, n, d)),
            4 => (prop::sample::select(&Unary::ALL), one()).prop_map(|(f, x)| Tree::Unary(f, x)),
            1 => (prop::sample::select(&Binary::ALL), pair())
                .prop_map(|(f, (x, y))| Tree::Binary(f, x, y)),
        ]
    })
}

/// Trees such as mechanics writes: sums and products of a few coordinates and parameters, and of sines and
/// cosines of one angle, in which most rules find something to do.
pub fn formulas() -> impl Strategy<Value = Tree> {
    let symbol = |name| Tree::Symbol(name);
    let angle = symbol(SYMBOLS[0]);
    let of_angle = |function| Tree::Unary(function, Box::new(angle.clone()));
    let leaf = prop_oneof![
        3 => prop::sample::select(&SYMBOLS[1..]).prop_map(symbol),
        2 => prop::sample::select(vec![of_angle(Unary::Sin), of_angle(Unary::Cos)]),
        1 => (-3_i64..=3, 1_i64..=2).prop_map(|(n, d)| Tree::Number(n, d)),
    ];
    leaf.prop_recursive(7, 60, 2, |inner| {
        let pair = || {
            (
                inner.clone().prop_map(Box::new),
                inner.clone().prop_map(Box::new),
            )
        };
        let one = || inner.clone().prop_map(Box::new);
        prop_oneof![
            5 => pair().prop_map(|(x, y)| Tree::Add(x, y)),
            3 => pair().prop_map(|(x, y)| Tree::Subtract(x, y)),
            6 => pair().prop_map(|(x, y)| Tree::Multiply(x, y)),
            1 => pair().prop_map(|(x, y)| Tree::Divide(x, y)),
            2 => one().prop_map(|x| Tree::Power(x, 2, 1)),
            2 => one().prop_map(Tree::Opaque),
        ]
    })
}

/// Three sums Σⱼ cᵢⱼ xⱼ, multiplied, and Σᵢⱼ rᵢ cᵢⱼ fᵢ xⱼ written term by term: the same sums, to be found again.
pub fn distributed() -> impl Strategy<Value = [Tree; 2]> {
    let numbers = prop::array::uniform3(prop::array::uniform3(-2_i64..=2));
    let ratios = prop::array::uniform3(-2_i64..=3);
    let orders = Just([0, 1, 2]).prop_shuffle();
    (numbers, ratios, orders, any::<[bool; 3]>()).prop_map(|(numbers, ratios, order, whole)| {
        let boxed = |symbol| Box::new(Tree::Symbol(symbol));
        let add = |x, y| Tree::Add(Box::new(x), Box::new(y));
        let times = |c, x| Tree::Multiply(Box::new(Tree::Number(c, 1)), Box::new(x));
        let sums = [0, 1, 2].map(|i| {
            let terms = [0, 1, 2].map(|j| times(numbers[i][j], Tree::Symbol(SYMBOLS[j])));
            let sum = terms.into_iter().reduce(add).unwrap();
            if whole[i] {
                Tree::Opaque(Box::new(sum))
            } else {
                sum
            }
        });
        let terms = order.into_iter().flat_map(|i| {
            let [first, second, third] = [0, 1, 2].map(|j| {
                let product = Tree::Multiply(boxed(SYMBOLS[3 + i]), boxed(SYMBOLS[j]));
                times(ratios[i] * numbers[i][j], product)
            });
            [first, second, third, times(ratios[i], sums[i].clone())]
        });
        let expanded = terms.reduce(add).unwrap();
        let multiply = |x, y| Tree::Multiply(Box::new(x), Box::new(y));
        [sums.into_iter().reduce(multiply).unwrap(), expanded]
    })
}

/// Trees in which external functions are applied to trees, and to what they are applied to.
pub fn applications() -> impl Strategy<Value = Tree> {
    (trees(), trees(), trees(), 0..external::COUNT).prop_map(|(x, y, z, last)| {
        let boxed = Box::new;
        let inner = Tree::Application(external::WAVE, vec![x]);
        let product = Tree::Multiply(boxed(inner.clone()), boxed(z));
        let arguments = [inner, product].into_iter().take(external::arity(last));
        let outer = Tree::Application(last, arguments.collect());
        Tree::Add(boxed(outer), boxed(y))
    })
}

/// A value for each of the symbols.
pub fn points() -> impl Strategy<Value = [f64; SYMBOLS.len()]> {
    let coordinate = prop_oneof![4 => -2.0..2.0_f64, 1 => 0.1..0.9_f64];
    prop::array::uniform6(coordinate)
}

/// The value of `symbol` at a point.
pub fn at(point: &[f64; SYMBOLS.len()], symbol: Symbol) -> f64 {
    let index = SYMBOLS.iter().position(|known| *known == symbol).unwrap();
    point[index]
}

fn fraction(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap()
}

impl Tree {
    /// The tree in normal form.
    pub fn build(&self, graph: &mut Graph) -> Expression {
        let mut pair = |x: &Self, y: &Self| (x.build(graph), y.build(graph));
        match self {
            Self::Number(n, d) => graph.constant(&fraction(*n, *d)),
            Self::Pi => graph.pi(),
            Self::Symbol(symbol) => graph.symbol(*symbol),
            Self::Add(x, y) => {
                let (x, y) = pair(x, y);
                graph.add(x, y)
            }
            Self::Subtract(x, y) => {
                let (x, y) = pair(x, y);
                graph.subtract(x, y)
            }
            Self::Negate(x) => {
                let x = x.build(graph);
                graph.negate(x)
            }
            Self::Multiply(x, y) => {
                let (x, y) = pair(x, y);
                graph.multiply(x, y)
            }
            Self::Divide(x, y) => {
                let (x, y) = pair(x, y);
                graph.divide(x, y)
            }
            Self::Power(x, n, d) => {
                let x = x.build(graph);
                graph.power(x, &fraction(*n, *d))
            }
            Self::Opaque(x) => {
                let x = x.build(graph);
                graph.opaque(x)
            }
            Self::Unary(function, x) => {
                let x = x.build(graph);
                graph.unary(*function, x)
            }
            Self::Binary(function, x, y) => {
                let (x, y) = pair(x, y);
                graph.binary(*function, x, y)
            }
            Self::Application(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|x| x.build(graph)).collect();
                let function = external::functions(graph)[*function];
                graph.apply(function, &arguments)
            }
        }
    }

    /// The value of the tree as it stands.
    pub fn evaluate<N: Number>(&self, symbol: &impl Fn(Symbol) -> N) -> N {
        let of = |x: &Self| x.evaluate(symbol);
        let minus = N::rational(&Rational::MINUS_ONE);
        match self {
            Self::Number(n, d) => N::rational(&fraction(*n, *d)),
            Self::Pi => N::pi(),
            Self::Symbol(name) => symbol(*name),
            Self::Add(x, y) => of(x).add(of(y)),
            Self::Subtract(x, y) => of(x).add(minus.multiply(of(y))),
            Self::Negate(x) => minus.multiply(of(x)),
            Self::Multiply(x, y) => of(x).multiply(of(y)),
            Self::Divide(x, y) => of(x).multiply(of(y).power(&Rational::MINUS_ONE)),
            Self::Power(x, n, d) => of(x).power(&fraction(*n, *d)),
            Self::Opaque(x) => of(x),
            Self::Unary(function, x) => of(x).unary(*function),
            Self::Binary(function, x, y) => of(x).binary(*function, of(y)),
            Self::Application(function, arguments) => {
                let arguments: Vec<N> = arguments.iter().map(of).collect();
                external::value_of(*function, &arguments)
            }
        }
    }
}
