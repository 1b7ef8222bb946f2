//! Random expressions on dual numbers, against their symbolic derivatives.
//!
//! How far rounding may carry either is known from the same expressions on numbers that bound their own error.

use lagrangian::{Dual, Scalar};
use lagrangian_symbolic::{Binary, Expression, Graph, Rational, Symbol, Unary};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::tree::{SYMBOLS, Tree, at, points, trees};
use lagrangian_symbolic_testing::{Number, dual, evaluate};
use proptest::prelude::*;

/// A scalar as a number of random expressions.
#[derive(Clone, Copy)]
struct On<S>(S);

impl<S: Scalar> Number for On<S> {
    fn rational(value: &Rational) -> Self {
        Self(S::from_f64(value.to_f64()))
    }

    fn pi() -> Self {
        Self(S::pi())
    }

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }

    fn multiply(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }

    fn power(self, exponent: &Rational) -> Self {
        let Self(x) = self;
        if *exponent == Rational::HALF {
            return Self(x.sqrt());
        }
        let Some(whole) = exponent.to_integer().and_then(|k| i32::try_from(k).ok()) else {
            return Self(x.powf(S::from_f64(exponent.to_f64())));
        };
        let power = (0..whole.abs()).fold(S::one(), |product, _| product * x);
        Self(if whole < 0 { S::one() / power } else { power })
    }

    fn unary(self, function: Unary) -> Self {
        let Self(x) = self;
        Self(match function {
            Unary::Sin => x.sin(),
            Unary::Cos => x.cos(),
            Unary::Tan => x.tan(),
            Unary::Asin => x.asin(),
            Unary::Acos => x.acos(),
            Unary::Atan => x.atan(),
            Unary::Sinh => x.sinh(),
            Unary::Cosh => x.cosh(),
            Unary::Tanh => x.tanh(),
            Unary::Sech => x.sech(),
            Unary::Asinh => x.asinh(),
            Unary::Acosh => x.acosh(),
            Unary::Atanh => x.atanh(),
            Unary::Exp => x.exp(),
            Unary::Ln => x.ln(),
            Unary::Logistic => x.logistic(),
            Unary::Softplus => x.softplus(),
            Unary::LogCosh => x.log_cosh(),
            Unary::Abs => x.abs(),
            Unary::Signum => x.signum(),
        })
    }

    fn binary(self, function: Binary, other: Self) -> Self {
        let (Self(x), Self(y)) = (self, other);
        Self(match function {
            Binary::Atan2 => x.atan2(y),
            Binary::Min => x.min(y),
            Binary::Max => x.max(y),
            Binary::Power => x.powf(y),
            Binary::Scale => x.common_scale(y),
        })
    }
}

/// Whether a number may be what rounding made of a derivative, given that derivative and the same by an independent way, each
/// with its bound. Nothing is said where a bound is infinite, nor outside of the domain.
fn agree(found: f64, symbolic: Bounded, independent: Option<Bounded>) -> bool {
    let (true, Some(independent)) = (symbolic.is_reliable(), independent) else {
        return true;
    };
    // Products and quotients are rounded in another order than in the independent way.
    let error = 4.0 * independent.error;
    let found = Bounded {
        value: found,
        error,
    };
    found.is_reliable() && found.agrees(symbolic)
}

fn value(graph: &Graph, root: Expression, point: &[f64; SYMBOLS.len()]) -> Bounded {
    evaluate(graph, root, |name| Bounded::exact(at(point, name)))
}

/// The last of some numbers, if all are reliable.
fn reliable<const K: usize>(numbers: [Bounded; K]) -> Option<Bounded> {
    let last = numbers.last().copied();
    last.filter(|_| numbers.iter().all(|number| number.is_reliable()))
}

/// The derivative by a symbol, on dual numbers that are not the runtime's.
fn independent(tree: &Tree, symbol: Symbol, point: &[f64; SYMBOLS.len()]) -> Option<Bounded> {
    let variable = |name| dual::Dual::variable(at(point, name), name == symbol);
    let dual::Dual { value, slope } = tree.evaluate(&variable);
    reliable([value, slope])
}

/// The second derivative.
fn independent_twice(tree: &Tree, symbol: Symbol, point: &[f64; SYMBOLS.len()]) -> Option<Bounded> {
    let variable = |name: Symbol| {
        let slope = f64::from(u8::from(name == symbol));
        dual::Dual {
            value: dual::Dual::variable(at(point, name), name == symbol),
            slope: dual::Dual::variable(slope, false),
        }
    };
    let dual::Dual { value, slope } = tree.evaluate(&variable);
    reliable([value.value, value.slope, slope.slope])
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn gradients_are_symbolic_derivatives(tree in trees(), point in points()) {
        let variables = Dual::variables(point);
        let index = |name: Symbol| SYMBOLS.iter().position(|known| *known == name).unwrap();
        let On(found) = tree.evaluate(&|name| On(variables[index(name)]));
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        for (symbol, found) in SYMBOLS.into_iter().zip(found.derivative) {
            let derivative = graph.derivative(root, symbol);
            let symbolic = value(&graph, derivative, &point);
            let independent = independent(&tree, symbol, &point);
            prop_assert!(
                agree(found, symbolic, independent),
                "{found:e} for {symbolic:?} and {independent:?}"
            );
        }
    }

    #[test]
    fn nested_derivatives_are_symbolic_second_derivatives(
        tree in trees(),
        point in points(),
        which in 0..SYMBOLS.len(),
    ) {
        let symbol = SYMBOLS[which];
        let variable = |name: Symbol| {
            let index = usize::from(name != symbol);
            On(Dual::<Dual>::variable(Dual::variable(at(&point, name), index), index))
        };
        let On(found) = tree.evaluate(&variable);
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        let first = graph.derivative(root, symbol);
        let second = graph.derivative(first, symbol);
        let symbolic = value(&graph, second, &point);
        let independent = independent_twice(&tree, symbol, &point);
        let [slope] = found.derivative;
        prop_assert!(
            agree(slope.derivative[0], symbolic, independent),
            "{slope:?} for {symbolic:?} and {independent:?}"
        );
    }
}

#[test]
fn disagreement_is_seen() {
    let exact = Bounded::exact(2.0);
    assert!(agree(2.0, exact, Some(exact)));
    assert!(!agree(2.0 + 1e-15, exact, Some(exact)));
    assert!(!agree(f64::NAN, exact, Some(exact)));
}
