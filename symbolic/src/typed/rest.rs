//! Velocities where a system is at rest.
//!
//! The velocity of a point p as a frame sees it that turns with ω is dp/dt ± ω × p, as in (1.4). It vanishes where the
//! point rests in the frame of its coordinates. As an expression at rest, ω × p does not differ from a position that is
//! a product of a given vector and p. Rates and products are therefore unknowns at rest, and a sum of them is a
//! velocity if dp/dt = ∓ ω × p makes it vanish.

use std::collections::BTreeMap;

use crate::typed::components::Components;
use crate::{Expression, Graph, Matrix, Rational, Symbol};

/// The unknowns that stand for velocities.
#[derive(Debug, Default)]
pub(crate) struct Rest {
    /// The rates of what depends on coordinates, by what they are rates of.
    rates: BTreeMap<Expression, Expression>,
    /// The components of products of a given vector and a position.
    products: BTreeMap<Symbol, Position>,
    unknowns: u32,
}

/// A position of which there is a product, and the rate of one of its components.
#[derive(Debug)]
struct Position {
    vector: Matrix,
    rate: Expression,
    /// The number of the product.
    product: u32,
}

/// Whether this depends on the motion.
fn moves(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Coordinate(_) | Symbol::QuasiVelocity(_))
}

fn is_unknown(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::QuasiVelocity(_))
}

impl Rest {
    fn unknown(&mut self) -> Symbol {
        self.unknowns += 1;
        Symbol::QuasiVelocity(self.unknowns)
    }

    fn is_rate(&self, symbol: Symbol) -> bool {
        is_unknown(symbol) && !self.products.contains_key(&symbol)
    }

    /// The rate of a value.
    pub(crate) fn rate(&mut self, graph: &mut Graph, value: &Components) -> Components {
        match value {
            Components::Scalar(x) => Components::Scalar(self.rate_of(graph, *x)),
            Components::Array(matrix) => Components::Array(matrix.map(|x| self.rate_of(graph, x))),
            Components::EmptySum => Components::EmptySum,
        }
    }

    /// The rate of an expression, linear in what depends on coordinates.
    fn rate_of(&mut self, graph: &mut Graph, expression: Expression) -> Expression {
        if !graph.contains(&[expression], moves) {
            return graph.zero();
        }
        let rates = graph.terms(expression).into_iter();
        let rates = rates.map(|(x, c)| (self.rate_of_term(graph, x), c));
        let rates: Vec<_> = rates.collect();
        graph.sum(rates)
    }

    fn rate_of_term(&mut self, graph: &mut Graph, term: Expression) -> Expression {
        if !graph.contains(&[term], moves) {
            return graph.zero();
        }
        let moving = |(x, _): &(Expression, Rational)| graph.contains(&[*x], moves);
        let factors = graph.factors(term).into_iter();
        let (moving, constant): (Vec<_>, Vec<_>) = factors.partition(moving);
        let (moving, constant) = (graph.product(moving), graph.product(constant));
        let rate = match self.rates.get(&moving) {
            Some(rate) => *rate,
            None => graph.symbol(self.unknown()),
        };
        self.rates.insert(moving, rate);
        graph.multiply(constant, rate)
    }

    /// The angular velocity of a rotation.
    pub(crate) fn angular_velocity(&mut self, graph: &mut Graph, rotation: &Matrix) -> Matrix {
        let turns = graph.contains(rotation.elements(), moves);
        let components = (0..3).map(|_| {
            if turns {
                graph.symbol(self.unknown())
            } else {
                graph.zero()
            }
        });
        Matrix::vector(components.collect())
    }

    /// The cross product of two vectors: zero where one of them is a velocity, unknown where one is given.
    pub(crate) fn cross_product(
        &mut self,
        graph: &mut Graph,
        vectors: [&Matrix; 2],
        product: &Matrix,
    ) -> Matrix {
        let zero = graph.zero();
        let contain = |what: &dyn Fn(Symbol) -> bool| {
            vectors.map(|vector| graph.contains(vector.elements(), what))
        };
        let rates = contain(&|symbol| self.is_rate(symbol));
        let products = contain(&|symbol| self.products.contains_key(&symbol));
        let moving = contain(&moves);
        if (rates[0] && !products[0]) || (rates[1] && !products[1]) {
            return product.map(|_| zero);
        }
        if products[0] || products[1] || moving[0] == moving[1] {
            return product.clone();
        }
        let position = vectors[usize::from(moving[1])];
        let number = self.unknowns;
        let mut components = position.elements().to_vec().into_iter();
        product.map(|x| {
            let component = components.next().unwrap_or(zero);
            if !graph.contains(&[x], moves) {
                return x;
            }
            let rate = self.rate_of(graph, component);
            let unknown = self.unknown();
            let position = Position {
                vector: position.clone(),
                rate,
                product: number,
            };
            self.products.insert(unknown, position);
            graph.symbol(unknown)
        })
    }

    /// Whether a component of a vector depends on coordinates while nothing moves in the frame of the coordinates, nor
    /// in one that turns.
    pub(crate) fn depends_on_position(
        &self,
        graph: &mut Graph,
        components: &[Expression],
        component: usize,
    ) -> bool {
        let Some(expression) = components.get(component).copied() else {
            return true;
        };
        let unknowns = graph.symbols(&[expression]).into_iter();
        let unknowns: Vec<_> = unknowns.filter(|symbol| is_unknown(*symbol)).collect();
        // What is of first degree in the unknowns; their products vanish with each of them.
        let slopes: Vec<_> = unknowns
            .iter()
            .map(|symbol| graph.derivative(expression, *symbol))
            .collect();
        let slopes = graph.at_zero(&slopes, &unknowns);
        let constant = graph.at_zero(&[expression], &unknowns)[0];
        let terms: Vec<_> = slopes
            .into_iter()
            .zip(&unknowns)
            .map(|(slope, symbol)| {
                let unknown = graph.symbol(*symbol);
                (graph.multiply(slope, unknown), Rational::ONE)
            })
            .collect();
        let linear = graph.sum(terms);
        graph.contains(&[constant], moves)
            || [Rational::ONE, Rational::MINUS_ONE].iter().all(|sign| {
                let rest = self.at_rest(graph, (linear, components), sign);
                graph.contains(&[rest], moves)
            })
    }

    /// A linear expression where dp/dt = −s ω × p for each product in it, and all other rates are zero.
    fn at_rest(
        &self,
        graph: &mut Graph,
        (linear, components): (Expression, &[Expression]),
        sign: &Rational,
    ) -> Expression {
        let contained = graph.symbols(&[linear]);
        let mut equations: Vec<(&Position, Expression)> = Vec::new();
        for (symbol, position) in &self.products {
            if !contained.contains(symbol) {
                continue;
            }
            let product = graph.symbol(*symbol);
            let mut known = equations.iter_mut();
            match known
                .find(|(other, _)| other.vector == position.vector && other.rate == position.rate)
            {
                Some((_, sum)) => *sum = graph.add(*sum, product),
                None => equations.push((position, product)),
            }
        }
        let mut rates: Vec<Expression> = equations.iter().map(|(of, _)| of.rate).collect();
        rates.push(linear);
        for (number, (_, product)) in equations.iter().enumerate() {
            let mut symbols = graph.symbols(&[rates[number]]).into_iter();
            let Some(symbol) = symbols.find(|symbol| self.is_rate(*symbol)) else {
                continue;
            };
            // c ṙ + … + s ω × p = 0.
            let slope = graph.derivative(rates[number], symbol);
            let others = graph.at_zero(&[rates[number]], &[symbol])[0];
            let product = graph.scale(*product, sign);
            let sum = graph.add(others, product);
            let quotient = graph.divide(sum, slope);
            let value = BTreeMap::from([(symbol, graph.negate(quotient))]);
            rates = graph.substitute(&rates, &value);
        }
        let linear = rates[equations.len()];
        let others = graph.symbols(&[linear]).into_iter();
        let others = others.filter(|symbol| {
            self.is_rate(*symbol) || self.moves_elsewhere(graph, *symbol, components)
        });
        let others: Vec<_> = others.collect();
        graph.at_zero(&[linear], &others)[0]
    }

    /// Whether the position of a product does not move along this component, but does along another one to which its rate
    /// is added.
    fn moves_elsewhere(&self, graph: &Graph, product: Symbol, components: &[Expression]) -> bool {
        let Some(still) = self.products.get(&product) else {
            return false;
        };
        graph.is_zero(still.rate)
            && components.iter().any(|component| {
                let contained = graph.symbols(&[*component]);
                let mut products = contained.iter().filter_map(|x| self.products.get(x));
                products.any(|other| {
                    other.product == still.product
                        && !graph.is_zero(other.rate)
                        && graph.symbols(&[other.rate]).is_subset(&contained)
                })
            })
    }
}
