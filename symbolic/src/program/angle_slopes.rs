//! Slopes of angles, y/(x² + y²) and their derivatives, without squares that underflow or overflow.
//!
//! With a power of two s that takes the larger of |x| and |y| to about 1, y/(x² + y²) is ((s y)/((s x)² + (s y)²))·s, where every
//! value that is computed is representable if the slope is: the scaling of the complex quotient (R. L. Smith, Algorithm 116:
//! complex division, Communications of the ACM 5, 1962), by a power of two, so that no digit is rounded. s is a constant to
//! derivatives and series, of which the identity holds as well.
//!
//! In the graph a slope stays y/(x² + y²), which cancels with an r² = x² + y². Where a divisor is left, it is scaled here.

use crate::program::dag::{Dag, DagOperation, ValueId, merged};
use crate::{Binary, Expression, Graph, Node, Rational};

/// How often products divide by a squared distance at most, so that it is scaled.
const MAX_TIMES: i64 = 4;

/// What is divided by a squared distance x² + y².
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScaledSquares {
    /// s.
    scale: ValueId,
    /// x and y.
    roots: [ValueId; 2],
    /// s x and s y.
    scaled: [ValueId; 2],
    /// (s x)² + (s y)².
    sum: ValueId,
}

/// The root of a square, as powers, and the coefficient of the square.
type Square = (Vec<(Expression, Rational)>, Rational);

/// Numerator and denominator.
type Parts = (Vec<ValueId>, Vec<ValueId>);

impl Graph {
    /// Notes the divisor of slopes of an angle.
    pub(crate) fn note_squared_distance(&mut self, sum: Expression) {
        let inverse = self.power(sum, &Rational::MINUS_ONE);
        for (base, _) in self.factors(inverse) {
            if matches!(self.node(base), Node::Sum(_)) {
                self.squared_distances.insert(base);
            }
        }
    }

    /// The terms of a squared distance that has two, both of them squares: each square's root, as factors, and its
    /// coefficient.
    fn two_squares(&self, sum: Expression) -> Option<[Square; 2]> {
        let Node::Sum(terms) = self.node(sum) else {
            return None;
        };
        let [first, second] = &**terms else {
            return None;
        };
        let root = |(term, coefficient): &(Expression, Rational)| {
            let Node::Product(factors) = self.node(*term) else {
                return None;
            };
            let even = |(_, k): &(Expression, Rational)| k.is_even() && !k.is_negative();
            if coefficient.is_negative() || !factors.iter().all(even) {
                return None;
            }
            let roots = factors.iter().map(|(x, k)| (*x, k * &Rational::HALF));
            Some((roots.collect(), coefficient.clone()))
        };
        Some([root(first)?, root(second)?])
    }
}

/// How often a power divides by its base, if that is often enough to be scaled.
pub(crate) fn times_divided(exponent: &Rational) -> Option<usize> {
    let (times, below) = exponent.to_fraction()?;
    let divides = below == 1 && (-MAX_TIMES..0).contains(&times);
    divides.then(|| usize::try_from(-times).unwrap_or(0))
}

impl Dag {
    /// The scaled squares of a distance, if slopes of an angle divide by it.
    pub(crate) fn scaled_squares(
        &mut self,
        graph: &Graph,
        sum: Expression,
    ) -> Option<ScaledSquares> {
        if !graph.squared_distances.contains(&sum) {
            return None;
        }
        if let Some(known) = self.scaled.get(&sum) {
            return Some(*known);
        }
        let squares = graph.two_squares(sum)?;
        let coefficients = [0, 1].map(|i: usize| squares[i].1.clone());
        let roots = squares.map(|(factors, _)| self.root(&factors));
        let scale = self.push(
            DagOperation::Binary(Binary::Scale, roots[0], roots[1]),
            None,
        );
        let scaled = roots.map(|root| self.product(root, scale));
        let squares = scaled.map(|root| self.product(root, root));
        let terms = squares.into_iter().zip(coefficients).collect();
        let found = ScaledSquares {
            scale,
            roots,
            scaled,
            sum: self.push(DagOperation::Sum(terms), None),
        };
        self.scaled.insert(sum, found);
        Some(found)
    }

    /// The value of a product of positive powers.
    fn root(&mut self, factors: &[(Expression, Rational)]) -> ValueId {
        let mut values = Vec::new();
        for (base, exponent) in factors {
            let base = self.value(*base);
            self.push_power(&mut values, base, exponent);
        }
        match *values {
            [single] => single,
            _ => self.push(DagOperation::Quotient(values, Vec::new()), None),
        }
    }

    fn product(&mut self, x: ValueId, y: ValueId) -> ValueId {
        self.push(DagOperation::Quotient(vec![x, y], Vec::new()), None)
    }

    /// A quotient over the power of a squared distance, as one over the power of the scaled squares, times the square of that
    /// power of the scale. As far as the numerator is homogeneous in x and y, s x and s y take their places; by each s that is
    /// left is multiplied alone, as s² may not be a number.
    pub(crate) fn over_squares(
        &mut self,
        (numerator, mut denominator): Parts,
        squares: ScaledSquares,
        times: usize,
        shared: bool,
    ) -> Parts {
        let mut left = 2 * times;
        let mut scaled = Vec::with_capacity(numerator.len());
        for factor in numerator {
            let degree = self.degree(factor, squares).min(left);
            left -= degree;
            scaled.push(self.with_scaled(factor, degree, squares));
        }
        if shared {
            let reciprocal = self.reciprocal(squares.sum);
            scaled.extend((0..times).map(|_| reciprocal));
        } else {
            denominator.extend((0..times).map(|_| squares.sum));
        }
        for n in 0..left {
            if n > 0 {
                let inner = self.push(DagOperation::Quotient(scaled, denominator), None);
                (scaled, denominator) = (vec![inner], Vec::new());
            }
            scaled.push(squares.scale);
        }
        scaled.sort_unstable();
        denominator.sort_unstable();
        (scaled, denominator)
    }

    /// How many factors x or y each term of a value has, as far as it is seen.
    fn degree(&self, value: ValueId, squares: ScaledSquares) -> usize {
        let of_term = |term: ValueId| match &self.operations[term] {
            _ if squares.roots.contains(&term) => 1,
            DagOperation::Quotient(above, _) => {
                let roots = above.iter().filter(|x| squares.roots.contains(x));
                roots.count()
            }
            _ => 0,
        };
        match &self.operations[value] {
            DagOperation::Sum(terms) if !squares.roots.contains(&value) => {
                let degrees = terms.iter().map(|(term, _)| of_term(*term));
                degrees.min().unwrap_or(0)
            }
            _ => of_term(value),
        }
    }

    /// A value with s x and s y in place of so many factors x and y.
    fn with_scaled(&mut self, value: ValueId, degree: usize, squares: ScaledSquares) -> ValueId {
        if degree == 0 {
            return value;
        }
        let scaled = |x: ValueId| {
            let position = squares.roots.iter().position(|root| *root == x);
            position.map(|position| squares.scaled[position])
        };
        if let Some(root) = scaled(value) {
            return root;
        }
        let operation = match self.operations[value].clone() {
            DagOperation::Sum(terms) => {
                let terms = terms.into_iter();
                let terms = terms.map(|(x, c)| (self.with_scaled(x, degree, squares), c));
                DagOperation::Sum(merged(terms.collect::<Vec<_>>()))
            }
            DagOperation::Quotient(mut above, below) => {
                let mut left = degree;
                for x in &mut above {
                    if let Some(root) = scaled(*x).filter(|_| left > 0) {
                        left -= 1;
                        *x = root;
                    }
                }
                above.sort_unstable();
                DagOperation::Quotient(above, below)
            }
            other => other,
        };
        self.push(operation, None)
    }
}
