//! A model under construction.

use std::cell::{RefCell, RefMut};

use super::Quantity;
use crate::{Axis, Energies, Expression, Geometry, Graph, Matrix, Model, Rational, Symbol};

/// The graph of a model, of which [`Quantity`] is a handle with operators.
#[derive(Debug)]
pub struct Draft {
    geometry: RefCell<Geometry>,
    coordinates: u32,
}

impl Draft {
    /// A model with so many coordinates.
    pub fn new(coordinates: u32) -> Self {
        Self::of(Graph::new(), coordinates)
    }

    /// A model that goes on from a graph.
    pub fn of(graph: Graph, coordinates: u32) -> Self {
        Self {
            geometry: RefCell::new(Geometry::from(graph)),
            coordinates,
        }
    }

    /// The graph, for what has no operator. It is borrowed: hold it for one statement.
    pub fn graph(&self) -> RefMut<'_, Graph> {
        RefMut::map(self.geometry.borrow_mut(), |geometry| &mut geometry.graph)
    }

    /// The graph with vectors above it. It is borrowed: hold it for one statement.
    pub fn geometry(&self) -> RefMut<'_, Geometry> {
        self.geometry.borrow_mut()
    }

    /// How many coordinates there are.
    pub fn coordinates(&self) -> u32 {
        self.coordinates
    }

    /// An expression of this graph, with operators.
    pub fn quantity(&self, expression: Expression) -> Quantity<'_> {
        Quantity {
            draft: self,
            expression,
        }
    }

    /// What is made in the graph.
    pub fn make(&self, make: impl FnOnce(&mut Graph) -> Expression) -> Quantity<'_> {
        let expression = make(&mut self.graph());
        self.quantity(expression)
    }

    pub fn symbol(&self, symbol: Symbol) -> Quantity<'_> {
        self.make(|graph| graph.symbol(symbol))
    }

    /// The coordinate of this number.
    pub fn q(&self, i: u32) -> Quantity<'_> {
        self.symbol(Symbol::Coordinate(i))
    }

    /// The velocity of the coordinate of this number.
    pub fn v(&self, i: u32) -> Quantity<'_> {
        self.symbol(Symbol::Velocity(i))
    }

    /// The parameter of this number.
    pub fn p(&self, i: u32) -> Quantity<'_> {
        self.symbol(Symbol::Parameter(i))
    }

    /// The first coordinates.
    pub fn qs<const N: usize>(&self) -> [Quantity<'_>; N] {
        numbered(|i| self.q(i))
    }

    /// The first velocities.
    pub fn vs<const N: usize>(&self) -> [Quantity<'_>; N] {
        numbered(|i| self.v(i))
    }

    /// The first parameters.
    pub fn ps<const N: usize>(&self) -> [Quantity<'_>; N] {
        numbered(|i| self.p(i))
    }

    pub fn time(&self) -> Quantity<'_> {
        self.symbol(Symbol::Time)
    }

    pub fn input(&self) -> Quantity<'_> {
        self.symbol(Symbol::Input(0))
    }

    pub fn number(&self, value: i64) -> Quantity<'_> {
        self.make(|graph| graph.integer(value))
    }

    /// The number of these digits.
    pub fn decimal(&self, digits: &str) -> Quantity<'_> {
        let value = Rational::from_decimal(digits).expect("a number");
        self.make(|graph| graph.constant(&value))
    }

    pub fn pi(&self) -> Quantity<'_> {
        self.make(Graph::pi)
    }

    pub fn zero(&self) -> Quantity<'_> {
        self.number(0)
    }

    pub fn one(&self) -> Quantity<'_> {
        self.number(1)
    }

    /// The sum as one expression, without those of its beginnings.
    pub fn sum<'d>(&'d self, terms: impl IntoIterator<Item = Quantity<'d>>) -> Quantity<'d> {
        let terms = terms.into_iter().map(|x| (x.expression, Rational::ONE));
        let terms: Vec<_> = terms.collect();
        self.make(|graph| graph.sum(terms))
    }

    /// The product as one expression, without those of its beginnings.
    pub fn product<'d>(&'d self, factors: impl IntoIterator<Item = Quantity<'d>>) -> Quantity<'d> {
        let factors = factors.into_iter().map(|x| (x.expression, Rational::ONE));
        let factors: Vec<_> = factors.collect();
        self.make(|graph| graph.product(factors))
    }

    /// The rotation about these axes, one after the other.
    pub fn rotation<const N: usize>(&self, turns: [(Axis, Quantity<'_>); N]) -> Matrix {
        let turns = turns.map(|(axis, angle)| (axis, angle.expression));
        self.geometry().rotation(&turns)
    }

    /// The model with L = T − V, to which the graph goes.
    pub fn natural<'d>(&'d self, kinetic: Quantity<'d>, potential: Quantity<'d>) -> Model {
        self.model(Energies::Natural {
            kinetic: kinetic.expression,
            potential: potential.expression,
        })
    }

    /// The model with this L, to which the graph goes.
    pub fn general<'d>(&'d self, lagrangian: Quantity<'d>) -> Model {
        self.model(Energies::General(lagrangian.expression))
    }

    fn model(&self, energies: Energies) -> Model {
        let graph = self.geometry.take().graph;
        let zero = graph.zero();
        Model {
            coordinates: self.coordinates,
            inputs: 1,
            energies,
            evaluated: None,
            dissipation: zero,
            forces: vec![zero; self.coordinates as usize],
            constraints: Vec::new(),
            outputs: Vec::new(),
            declaration: None,
            graph,
        }
    }
}

fn numbered<Q, const N: usize>(quantity: impl Fn(u32) -> Q) -> [Q; N] {
    let mut numbers = 0..;
    [(); N].map(|()| quantity(numbers.next().unwrap_or(u32::MAX)))
}
