//! Angular velocities of rotation matrices.
//!
//! In the axes that a rotation A turns, ω = vee(Aᵀ Ȧ), where vee takes the matrix of ω × to ω. That of a
//! product is ω(AB) = Bᵀ ω(A) + ω(B), so that one factor after the other is enough: an elementary
//! rotation adds the rate of its angle along its axis, a constant one adds nothing. Other matrices add
//! the sum of vee(Aᵀ ∂A/∂q) q̇ over what they depend on, each coefficient reduced as far as it goes.

use crate::geometry::axis::Axis;
use crate::geometry::factor::{Factor, Turn};
use crate::geometry::matrix::Matrix;
use crate::geometry::rotation::NoRotation;
use crate::{Direction, Expression, Graph, Rational, Symbol};

type Vector = [Expression; 3];

impl Graph {
    /// ω = vee(Aᵀ Ȧ), a column: the angular velocity along the axes of the body, where A takes their
    /// components to those along inertial axes.
    ///
    /// Constant factors that contain parameters are trusted to be rotations.
    ///
    /// # Errors
    ///
    /// If the matrix is no rotation.
    pub fn angular_velocity(
        &mut self,
        rotation: &Matrix,
        coordinates: u32,
    ) -> Result<Matrix, NoRotation> {
        let factors = self.matrix_factors(rotation).ok_or(NoRotation::Shape)?;
        if let Ok(velocity) = self.composed(&factors, coordinates) {
            return Ok(Matrix::vector(velocity.to_vec()));
        }
        // A product may be a rotation though its factors are none.
        let elements = rotation.elements().try_into();
        let whole = Factor::Written(elements.map_err(|_| NoRotation::Shape)?);
        let velocity = self.composed(&[whole], coordinates)?;
        Ok(Matrix::vector(velocity.to_vec()))
    }

    /// ω = vee(Ȧ Aᵀ), a column: the same angular velocity along the inertial axes.
    ///
    /// # Errors
    ///
    /// If the matrix is no rotation.
    pub fn angular_velocity_inertial(
        &mut self,
        rotation: &Matrix,
        coordinates: u32,
    ) -> Result<Matrix, NoRotation> {
        // Seen from the body, it is the inertial frame that turns, the other way.
        let opposite = self.angular_velocity(&rotation.transpose(), coordinates)?;
        let velocity = opposite.elements().iter().map(|x| self.negate(*x));
        let velocity = Matrix::vector(velocity.collect());
        // It is the one along the axes of the body, turned.
        let body = self.angular_velocity(rotation, coordinates)?;
        let factors = self.matrix_factors(rotation).ok_or(NoRotation::Shape)?;
        let parts = self.parts_turned(&factors, &body);
        Ok(velocity.made_of(parts))
    }

    /// The angular velocity of a product of factors.
    pub(crate) fn composed(
        &mut self,
        factors: &[Factor],
        coordinates: u32,
    ) -> Result<Vector, NoRotation> {
        let mut velocity = [self.zero(); 3];
        for factor in factors {
            let own = self.of_factor(*factor, coordinates)?;
            let turned = factor.transpose().apply(self, velocity);
            velocity = core::array::from_fn(|i| self.add(turned[i], own[i]));
        }
        Ok(velocity)
    }

    /// The angular velocity of one factor.
    fn of_factor(&mut self, factor: Factor, coordinates: u32) -> Result<Vector, NoRotation> {
        match factor {
            Factor::Turn(turn) => Ok(self.of_turn(turn, coordinates)),
            Factor::Rotation(elements) => Ok(self.of_elements(&elements, coordinates)),
            Factor::Written(elements) => {
                self.verify_rotation(&elements)?;
                Ok(self.of_elements(&elements, coordinates))
            }
        }
    }

    /// The rate of the angle along the axis.
    fn of_turn(&mut self, turn: Turn, coordinates: u32) -> Vector {
        let [axis, ..] = turn.axis.cycle();
        let rate = self.time_derivatives(&[turn.angle], coordinates)[0];
        let mut velocity = [self.zero(); 3];
        velocity[axis] = self.scale(rate, &turn.sign());
        velocity
    }

    /// Σ vee(Aᵀ ∂A/∂s) ṡ over all symbols s that vary.
    fn of_elements(&mut self, elements: &[Expression; 9], coordinates: u32) -> Vector {
        let mut terms: [Vec<(Expression, Rational)>; 3] = Default::default();
        for symbol in self.symbols(elements) {
            let variable = self.symbol(symbol);
            let rate = self.time_derivatives(&[variable], coordinates)[0];
            if self.is_zero(rate) {
                continue;
            }
            let coefficients = self.partial(elements, symbol);
            for (terms, coefficient) in terms.iter_mut().zip(coefficients) {
                terms.push((self.multiply(coefficient, rate), Rational::ONE));
            }
        }
        terms.map(|terms| self.sum(terms))
    }

    /// vee(Aᵀ ∂A/∂s).
    fn partial(&mut self, elements: &[Expression; 9], symbol: Symbol) -> Vector {
        let direction = Direction::from([(symbol, self.one())]);
        let slopes = self.directional_derivatives(elements, &direction);
        Axis::ALL.map(|axis| {
            let [_, j, k] = axis.cycle();
            let pairs = (0..3).map(|i| (elements[3 * k + i], slopes[3 * j + i]));
            let component = self.sum_of_products(pairs);
            self.reduced(component)
        })
    }
}
