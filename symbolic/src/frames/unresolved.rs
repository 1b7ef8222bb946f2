//! The algebra of vectors that are resolved last.
//!
//! A rotation that is applied to one changes the axes along which it will be resolved, a sum gathers terms, a time
//! derivative is one of each term, and a product of two is resolved along the axes of the frame that is turned most:
//! of the velocity of a point of a body and of an angular velocity, these are the axes of the body. What does not fit is
//! computed with the components, which are symbols until [`Geometry::resolved`] replaces them.

use std::collections::BTreeMap;

use crate::frames::factor::MatrixFactor;
use crate::frames::frame_tree::Frame;
use crate::frames::matrix::Matrix;
use crate::frames::vector_in_frames::{Term, VectorId, VectorInFrames};
use crate::{Expression, Geometry, Graph, Node, Rational, Symbol};

type Vector = [Expression; 3];

impl Geometry {
    /// The product of a matrix of three rows that has these factors with a column, from the right to the left.
    pub(crate) fn unresolved_product(
        &mut self,
        factors: &[MatrixFactor],
        column: &Matrix,
    ) -> Option<Matrix> {
        self.unresolved.as_ref()?;
        let mut product = column.clone();
        let mut rest = factors;
        while let Some(last) = rest.last() {
            if !last.is_rotation() {
                product =
                    Matrix::vector(last.apply(&mut self.graph, product.components()?).to_vec());
                rest = &rest[..rest.len() - 1];
                continue;
            }
            let others = rest.iter().rposition(|factor| !factor.is_rotation());
            let (before, rotations) = rest.split_at(others.map_or(0, |i| i + 1));
            product = self.turned(rotations, &product)?;
            rest = before;
        }
        Some(product)
    }

    /// A column turned by a product of rotations.
    fn turned(&mut self, rotations: &[MatrixFactor], column: &Matrix) -> Option<Matrix> {
        let rotations = self.resolved_factors(rotations);
        let (axes, terms) = if let Some(vector) = self.unresolved_of(column) {
            let before = self.frames.factors(vector.axes);
            let back = rotations.iter().rev().map(MatrixFactor::transpose);
            (self.merged(before.into_iter().chain(back)), vector.terms)
        } else if let Some(turned) = self.turned_rate(&rotations, column) {
            return Some(turned);
        } else {
            let components = column.components()?;
            let rotation = self.merged(rotations);
            let frame = self.frames.frame(&rotation);
            (Vec::new(), vec![Term::Fixed(frame, components)])
        };
        let axes = self.frames.frame(&axes);
        self.column_of(VectorInFrames { axes, terms })
    }

    /// Σ fᵢ xᵢ of rows or columns of three components, if one of them is a vector that is resolved last and all others are
    /// resolved along the same axes, or free of velocities. Vectors with velocities need constant factors.
    pub(crate) fn unresolved_sum(&mut self, terms: &[(&Matrix, Expression)]) -> Option<Matrix> {
        self.unresolved.as_ref()?;
        let known = terms.iter().filter_map(|(x, _)| self.unresolved_of(x));
        let known: Vec<_> = known.collect();
        let whole = known.iter().find(|vector| !vector.is_relative(&self.graph));
        let axes = whole.or(known.first())?.axes;
        let mut sum = Vec::new();
        for (x, factor) in terms {
            let vector = match self.unresolved_of(x) {
                Some(vector) => self.seen_from(vector, axes)?,
                None => along(axes, x)?,
            };
            for term in vector.terms {
                let term = self.graph.scaled_term(&term, *factor)?;
                self.graph.add_term(&mut sum, term);
            }
        }
        let column = self.column_of(VectorInFrames { axes, terms: sum })?;
        let is_row = terms.iter().any(|(x, _)| x.columns() > 1);
        Some(if is_row { column.transpose() } else { column })
    }

    /// The time derivative of a position that is resolved along inertial axes.
    pub(crate) fn unresolved_rate(&mut self, column: &Matrix) -> Option<Matrix> {
        self.unresolved.as_ref()?;
        let position = match self.unresolved_of(column) {
            Some(vector) => vector,
            None if column.shape() == (3, 1) => along(Frame::INERTIAL, column)?,
            None => return None,
        };
        if position.axes != Frame::INERTIAL {
            return None;
        }
        let mut terms = Vec::with_capacity(position.terms.len());
        for term in position.terms {
            let Term::Fixed(frame, components) = term else {
                return None;
            };
            let components = <[_; 3]>::try_from(self.resolved(&components)).ok()?;
            let moves = components
                .iter()
                .any(|x| self.graph.contents(*x).has_velocity());
            if moves {
                return None;
            }
            terms.push(Term::Rate(frame, components));
        }
        self.column_of(VectorInFrames {
            axes: Frame::INERTIAL,
            terms,
        })
    }

    /// The time derivative of a function of coordinates, time and components of positions that are resolved last along inertial
    /// axes, by the velocities of these; none if there are others.
    pub(crate) fn rate_in_frames(&mut self, x: Expression, coordinates: u32) -> Option<Expression> {
        let direction = self.graph.constant_velocity_direction(coordinates);
        let mut terms = vec![(
            self.graph.directional_derivatives(&[x], &direction)[0],
            Rational::ONE,
        )];
        for symbol in self.graph.symbols(&[x]) {
            let (Symbol::PositionComponent(i) | Symbol::VelocityComponent(i)) = symbol else {
                continue;
            };
            let (number, axis) = VectorId::of_component(i);
            let components = number.components().map(Symbol::PositionComponent);
            let components = components.map(|symbol| self.graph.symbol(symbol));
            let rate = self.unresolved_rate(&Matrix::vector(components.to_vec()))?;
            let slope = self.graph.derivative(x, symbol);
            let product = self.graph.multiply(slope, rate.elements()[axis]);
            terms.push((product, Rational::ONE));
        }
        Some(self.graph.sum(terms))
    }

    /// The angular velocity of a product of rotations, along its own axes or along inertial ones.
    pub(crate) fn unresolved_angular_velocity(
        &mut self,
        factors: &[MatrixFactor],
        is_inertial: bool,
    ) -> Option<Matrix> {
        self.unresolved.as_ref()?;
        if !factors.iter().all(MatrixFactor::is_rotation) {
            return None;
        }
        let factors = self.resolved_factors(factors);
        let factors = self.merged(factors);
        let frame = self.frames.frame(&factors);
        let axes = if is_inertial { Frame::INERTIAL } else { frame };
        let terms = vec![Term::AngularVelocity(frame, self.graph.one())];
        self.column_of(VectorInFrames { axes, terms })
    }

    /// x · y of two vectors along the same axes, one of which moves, in the frame that is turned most.
    pub(crate) fn unresolved_dot_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Expression> {
        self.unresolved.as_ref()?;
        let is_velocity = |x| self.unresolved_of(x).is_some() || self.graph.has_velocity(x);
        if !is_velocity(x) || !is_velocity(y) {
            return None;
        }
        let [first, second] = self.along_common_axes(x, y)?;
        let terms = || first.terms.iter().chain(&second.terms);
        if !terms().any(|term| term.moves(&self.graph)) {
            return None;
        }
        let frames = terms().map(Term::frame);
        let tree = &self.frames;
        let axes = frames.max_by_key(|frame| (tree.depth(*frame), *frame))?;
        let axes = self.turned_with(&first.terms, axes);
        let mut resolve = |vector: VectorInFrames| {
            let column = self.column_of(VectorInFrames { axes, ..vector })?;
            column.components()
        };
        let (a, b) = (resolve(first)?, resolve(second)?);
        Some(self.graph.sum_of_products(a.into_iter().zip(b)))
    }

    /// Two vectors along the same axes, one of which is resolved last; the other may be written out.
    pub(crate) fn along_common_axes(&self, x: &Matrix, y: &Matrix) -> Option<[VectorInFrames; 2]> {
        let [first, second] = [x, y].map(|x| self.unresolved_of(x));
        let axes = first.as_ref().or(second.as_ref())?.axes;
        let first = first.or_else(|| along(axes, x))?;
        let second = second.or_else(|| along(axes, y))?;
        (first.axes == second.axes).then_some([first, second])
    }

    /// Expressions with the components of vectors that are resolved last in terms of q and q̇.
    pub(crate) fn resolved(&mut self, roots: &[Expression]) -> Vec<Expression> {
        let mut roots = roots.to_vec();
        // A vector may contain components of those before it.
        while roots
            .iter()
            .any(|x| self.graph.contents(*x).has_component())
        {
            let mut values = BTreeMap::new();
            for symbol in self.graph.symbols(&roots) {
                if let Symbol::PositionComponent(i) | Symbol::VelocityComponent(i) = symbol
                    && let Some(value) = self.component_value(i)
                {
                    values.insert(symbol, value);
                }
            }
            if values.is_empty() {
                break;
            }
            roots = self.graph.substitute(&roots, &values);
        }
        roots
    }

    /// The value of a component.
    fn component_value(&mut self, index: u32) -> Option<Expression> {
        let vectors = self.unresolved.as_ref()?;
        let (number, axis) = VectorId::of_component(index);
        let vector = vectors.vector(number).clone();
        let axes = self.frames.factors(vector.axes);
        let mut sum = [self.graph.zero(); 3];
        for term in vector.terms {
            let value = self.term_value(&term)?;
            sum = [0, 1, 2].map(|i| self.graph.add(sum[i], value[i]));
        }
        for factor in &axes {
            sum = factor.transpose().apply(&mut self.graph, sum);
        }
        Some(sum[axis])
    }

    /// A term along inertial axes.
    fn term_value(&mut self, term: &Term) -> Option<Vector> {
        let coordinates = self.unresolved.as_ref()?.coordinates;
        let factors = self.frames.factors(term.frame());
        let vector = match term {
            Term::Fixed(_, vector) | Term::Rate(_, vector) => *vector,
            Term::AngularVelocity(_, factor) => {
                let velocity = self.angular_velocity_of_product(&factors, coordinates);
                velocity.ok()?.map(|x| self.graph.multiply(*factor, x))
            }
        };
        let value = self.graph.turned_by(&factors, vector);
        match term {
            Term::Rate(..) => {
                let rates = self.time_derivatives(&value, coordinates);
                rates.try_into().ok()
            }
            _ => Some(value),
        }
    }

    /// The vector of which a column or row has the components.
    pub(crate) fn unresolved_of(&self, column: &Matrix) -> Option<VectorInFrames> {
        let vectors = self.unresolved.as_ref()?;
        let component = |x: &Expression| match self.graph.node(*x) {
            Node::Symbol(Symbol::PositionComponent(i) | Symbol::VelocityComponent(i)) => Some(*i),
            _ => None,
        };
        let [x, y, z] = column.components()?;
        let (number, _) = VectorId::of_component(component(&x)?);
        let is_whole = [x, y, z].map(|x| component(&x)) == number.components().map(Some);
        is_whole.then(|| vectors.vector(number).clone())
    }

    /// The column of the components of a vector.
    pub(crate) fn column_of(&mut self, vector: VectorInFrames) -> Option<Matrix> {
        let mut vector = self.with_known_velocities(vector);
        let zero = self.graph.zero();
        vector.terms.retain(|term| match term {
            Term::Fixed(_, components) => *components != [zero; 3],
            Term::Rate(frame, components) => {
                let is_constant = components.iter().all(|x| !self.graph.contents(*x).varies());
                !(is_constant && *frame == Frame::INERTIAL)
            }
            Term::AngularVelocity(frame, factor) => *factor != zero && *frame != Frame::INERTIAL,
        });
        vector.terms.sort();
        match vector.terms.as_slice() {
            [] => return Some(Matrix::vector(vec![zero; 3])),
            [Term::Fixed(frame, components)] if *frame == vector.axes => {
                return Some(Matrix::vector(components.to_vec()));
            }
            _ => {}
        }
        let moves = vector.terms.iter().any(|term| term.moves(&self.graph));
        let number = self.unresolved.as_mut()?.number(vector);
        let symbol = if moves {
            Symbol::VelocityComponent
        } else {
            Symbol::PositionComponent
        };
        let components = number.components().map(|i| self.graph.symbol(symbol(i)));
        Some(Matrix::vector(components.to_vec()))
    }

    /// Factors whose angles and elements are functions of q, with rotations that were written out recognized.
    pub(crate) fn resolved_factors(&mut self, factors: &[MatrixFactor]) -> Vec<MatrixFactor> {
        let mut found = Vec::with_capacity(factors.len());
        for factor in factors {
            match *factor {
                MatrixFactor::Elementary(mut rotation) => {
                    rotation.angle = self.resolved(&[rotation.angle])[0];
                    found.push(MatrixFactor::Elementary(rotation));
                }
                MatrixFactor::Rotation(elements) => {
                    let values = self.resolved(&elements);
                    found.extend(
                        self.graph
                            .recognized_factors(values.try_into().unwrap_or(elements)),
                    );
                }
                general @ MatrixFactor::General(_) => found.push(general),
            }
        }
        found
    }
}

impl Graph {
    /// The product of factors with a vector, from the right to the left.
    pub(crate) fn turned_by(&mut self, factors: &[MatrixFactor], vector: Vector) -> Vector {
        let factors = factors.iter().rev();
        factors.fold(vector, |vector, factor| factor.apply(self, vector))
    }

    /// A multiple of a term; of one with velocities, by a constant.
    pub(crate) fn scaled_term(&mut self, term: &Term, factor: Expression) -> Option<Term> {
        if !matches!(term, Term::Fixed(..)) && self.contents(factor).varies() {
            return None;
        }
        let mut scaled = |x: Expression| self.multiply(factor, x);
        Some(match *term {
            Term::Fixed(frame, vector) => Term::Fixed(frame, vector.map(scaled)),
            Term::Rate(frame, vector) => Term::Rate(frame, vector.map(scaled)),
            Term::AngularVelocity(frame, known) => Term::AngularVelocity(frame, scaled(known)),
        })
    }

    /// Adds a term to others, of which one may be of the same kind and frame.
    pub(crate) fn add_term(&mut self, terms: &mut Vec<Term>, term: Term) {
        let mut add = |x: &Vector, y: &Vector| [0, 1, 2].map(|i| self.add(x[i], y[i]));
        for known in terms.iter_mut() {
            let sum = match (&*known, &term) {
                (Term::Fixed(f, x), Term::Fixed(g, y)) if f == g => Term::Fixed(*f, add(x, y)),
                (Term::Rate(f, x), Term::Rate(g, y)) if f == g => Term::Rate(*f, add(x, y)),
                (Term::AngularVelocity(f, x), Term::AngularVelocity(g, y)) if f == g => {
                    Term::AngularVelocity(*f, self.add(*x, *y))
                }
                _ => continue,
            };
            *known = sum;
            return;
        }
        terms.push(term);
    }
}

/// A column of three rows that was written out, as a vector along these axes.
pub(crate) fn along(axes: Frame, column: &Matrix) -> Option<VectorInFrames> {
    let terms = vec![Term::Fixed(axes, column.components()?)];
    Some(VectorInFrames { axes, terms })
}

#[cfg(test)]
mod tests;
