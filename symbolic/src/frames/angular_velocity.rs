//! Angular velocities of rotation matrices (Murray, Li and Sastry, A Mathematical Introduction to Robotic
//! Manipulation, 1994, section 2.4).
//!
//! In the body frame of a rotation A, ω = vee(Aᵀ Ȧ), where vee takes the matrix of ω × to ω. That of a
//! product is ω(AB) = Bᵀ ω(A) + ω(B), which is applied factor by factor: an elementary rotation adds the rate of
//! its angle along its axis, a constant one adds nothing. Other matrices add the sum of vee(Aᵀ ∂A/∂q) q̇ over
//! the symbols they depend on, each coefficient reduced.

use crate::frames::axis::Axis;
use crate::frames::factor::{ElementaryRotation, MatrixFactor};
use crate::frames::matrix::Matrix;
use crate::frames::rotation::NoRotation;
use crate::{Direction, Expression, Geometry, Graph, Rational, Symbol};

type Vector = [Expression; 3];

impl Geometry {
    /// ω = vee(Aᵀ Ȧ), a column: the angular velocity resolved in the body frame, where A takes components in the
    /// body frame to components in the inertial frame.
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
        if let Some(velocity) = self.unresolved_angular_velocity(&factors, false) {
            return Ok(velocity);
        }
        if let Ok(velocity) = self.angular_velocity_of_product(&factors, coordinates) {
            return Ok(Matrix::vector(velocity.to_vec()));
        }
        // A product may be a rotation though its factors are none.
        let elements = rotation.elements().try_into();
        let product = MatrixFactor::General(elements.map_err(|_| NoRotation::Shape)?);
        let velocity = self.angular_velocity_of_product(&[product], coordinates)?;
        Ok(Matrix::vector(velocity.to_vec()))
    }

    /// ω = vee(Ȧ Aᵀ), a column: the same angular velocity resolved in the inertial frame.
    ///
    /// # Errors
    ///
    /// If the matrix is no rotation.
    pub fn angular_velocity_inertial(
        &mut self,
        rotation: &Matrix,
        coordinates: u32,
    ) -> Result<Matrix, NoRotation> {
        let factors = self.matrix_factors(rotation).ok_or(NoRotation::Shape)?;
        if let Some(velocity) = self.unresolved_angular_velocity(&factors, true) {
            return Ok(velocity);
        }
        // In the body frame, the inertial frame rotates with the opposite angular velocity.
        let opposite = self.angular_velocity(&rotation.transpose(), coordinates)?;
        let velocity = opposite.map(|x| self.graph.negate(x));
        // Known as the one in the body frame, rotated.
        let body = self.angular_velocity(rotation, coordinates)?;
        let parts = self.rotated_parts(&factors, &body);
        Ok(self.with_parts(velocity, parts))
    }

    /// The [angular velocity](Graph::angular_velocity_of_product) of a product of factors, which may contain components of
    /// vectors that are resolved last.
    pub(crate) fn angular_velocity_of_product(
        &mut self,
        factors: &[MatrixFactor],
        coordinates: u32,
    ) -> Result<Vector, NoRotation> {
        if self.unresolved.is_some() {
            let factors = self.resolved_factors(factors);
            return self
                .graph
                .angular_velocity_of_product(&factors, coordinates);
        }
        self.graph.angular_velocity_of_product(factors, coordinates)
    }
}

impl Graph {
    /// The angular velocity of a product of factors.
    pub(crate) fn angular_velocity_of_product(
        &mut self,
        factors: &[MatrixFactor],
        coordinates: u32,
    ) -> Result<Vector, NoRotation> {
        let mut velocity = [self.zero(); 3];
        for factor in factors {
            let own = self.of_factor(*factor, coordinates)?;
            let rotated = factor.transpose().apply(self, velocity);
            velocity = core::array::from_fn(|i| self.add(rotated[i], own[i]));
        }
        Ok(velocity)
    }

    /// The angular velocity of one factor.
    fn of_factor(&mut self, factor: MatrixFactor, coordinates: u32) -> Result<Vector, NoRotation> {
        match factor {
            MatrixFactor::Elementary(rotation) => Ok(self.of_elementary(rotation, coordinates)),
            MatrixFactor::Rotation(elements) => Ok(self.of_elements(&elements, coordinates)),
            MatrixFactor::General(elements) => {
                self.verify_rotation(&elements)?;
                Ok(self.of_elements(&elements, coordinates))
            }
        }
    }

    /// The rate of the angle along the axis.
    fn of_elementary(&mut self, rotation: ElementaryRotation, coordinates: u32) -> Vector {
        let [axis, ..] = rotation.axis.cycle();
        let rate = self.time_derivatives(&[rotation.angle], coordinates)[0];
        let mut velocity = [self.zero(); 3];
        velocity[axis] = self.scale(rate, &rotation.sign());
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
    pub(crate) fn partial(&mut self, elements: &[Expression; 9], symbol: Symbol) -> Vector {
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
