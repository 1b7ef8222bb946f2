//! Euler's equations of motion (3.5)–(3.7), with the orientation as a unit quaternion.
//!
//! \[I\] dω/dt + **ω** × \[I\] **ω** = **N** in axes of the body, which need not be principal axes; if they are, the
//! products of inertia vanish and the equations agree with the text. The quaternion follows from q̇ = ½ q ∘ (0, **ω**).

use nalgebra::Vector3;

use super::body::RigidBody;
use super::error::BodyError;
use super::inertia_tensor::{InertiaTensor, ProductsOfInertia};
use super::moments::{Moment, MomentSeries, NoMoment};
use super::rotation_state::RotationState;
use crate::integrate::recurrences::{Product, Square};
use crate::integrate::{
    ComponentName, Dynamics, Projection, Series, SeriesMemory, SingleNumber, TaylorCoefficients,
};
use crate::limits::rigid_bodies::NO_INERTIA;
use crate::linalg::Factorization;
use crate::rotation::{components, quaternion_rate};
use crate::scalar::Scalar;

/// The rotation of a rigid body about its centre of gravity or a point fixed in space, by Euler's equations
/// (3.5)–(3.7).
///
/// Every method integrates it: [`Taylor`](crate::Taylor) if the moment has a [`MomentSeries`]; an
/// [`Ensemble`](crate::Ensemble) integrates several bodies at once if the moment is a
/// [`MomentInLanes`](super::MomentInLanes).
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::{EulerEquations, RotationState};
///
/// // A tennis racket, thrown with a rotation about its middle axis.
/// let racket = EulerEquations::principal([1.0, 2.0, 2.8])?;
/// let start = RotationState::aligned(Vector3::new(1e-3, 5.0, 0.0));
/// let momentum = racket.angular_momentum_in_space(&start);
///
/// let problem = Problem::new(&racket, At::from((0.0, start)));
/// let end = problem.clone().solve(10.0, Taylor::new())?;
/// let kept = racket.angular_momentum_in_space(&end.x) - momentum;
/// assert!(kept.norm() < 1e-12 * momentum.norm());
/// // It has turned over: the middle axis points the other way.
/// let turned = problem.when(|x| x.angular_velocity.y).stop().solve(100.0, Taylor::new())?;
/// assert_eq!(turned.reason, StopReason::Condition);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct EulerEquations<S: Scalar = f64, M = NoMoment> {
    pub(super) inertia: InertiaTensor<S>,
    pub(super) factored: Factorization<S, 3>,
    pub(super) moment: M,
}

impl<S: SingleNumber> EulerEquations<S> {
    /// Creates the free rotation of a body with an inertia tensor about its centre of gravity or a fixed point, in axes
    /// of the body.
    ///
    /// # Errors
    /// [`BodyError::NoInertia`] unless all principal moments are positive.
    pub fn new(inertia: InertiaTensor<S>) -> Result<Self, BodyError> {
        check_moments(inertia.principal_axes().moments)?;
        Ok(Self {
            inertia,
            factored: Factorization::new(inertia.matrix()),
            moment: NoMoment,
        })
    }

    /// Creates the free rotation with the principal moments I₁, I₂, I₃ in any order; the axes of the body are the
    /// principal axes.
    ///
    /// # Errors
    /// [`BodyError::NoInertia`] unless all moments are positive.
    pub fn principal(moments: [S; 3]) -> Result<Self, BodyError> {
        Self::new(InertiaTensor::principal(moments))
    }

    /// Creates the free rotation of a body about its centre of gravity.
    ///
    /// # Errors
    /// [`BodyError::NoInertia`] if a principal moment is zero, as for a thin rod.
    pub fn about_center(body: &RigidBody<S>) -> Result<Self, BodyError> {
        Self::new(body.inertia())
    }

    /// Creates the free rotation of a body about one of its points, which is fixed in space.
    ///
    /// # Errors
    /// [`BodyError::NoInertia`] if a principal moment about this point is zero.
    pub fn about_fixed_point(body: &RigidBody<S>, point: &Vector3<S>) -> Result<Self, BodyError> {
        Self::new(body.inertia_about(point))
    }
}

/// Returns an error unless three ascending principal moments are positive.
pub(super) fn check_moments<S: SingleNumber>(moments: [S; 3]) -> Result<(), BodyError> {
    let moments = moments.map(Scalar::largest);
    let least = NO_INERTIA * S::machine_epsilon() * moments[2];
    if moments.iter().all(|moment| *moment > least) {
        return Ok(());
    }
    Err(BodyError::NoInertia { moments })
}

impl<S: Scalar, M> EulerEquations<S, M> {
    /// Returns the body under a moment about the point of reference, in axes of the body.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// use lagrangian::rigid_body::{EulerEquations, RotationState};
    ///
    /// let ball = EulerEquations::principal([2.0; 3])?;
    /// let driven = ball.with_moment(|t: f64, _: &RotationState| Vector3::new(t.sin(), 0.0, 0.0));
    /// let start = RotationState::aligned(Vector3::zeros());
    /// let end = Problem::new(&driven, At::from((0.0, start))).solve(3.0, Dop853::new())?;
    /// assert!((end.angular_velocity.x - 0.5 * (1.0 - 3.0_f64.cos())).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_moment<N: Moment<S>>(self, moment: N) -> EulerEquations<S, N> {
        EulerEquations {
            inertia: self.inertia,
            factored: self.factored,
            moment,
        }
    }

    /// Converts the body to another scalar, such as one with a lane for each motion, with a moment on this scalar.
    #[must_use]
    pub fn map<T: Scalar, N>(
        &self,
        convert: impl FnMut(S) -> T,
        moment: impl FnOnce(&M) -> N,
    ) -> EulerEquations<T, N> {
        let inertia = self.inertia.map(convert);
        EulerEquations {
            inertia,
            factored: Factorization::new(inertia.matrix()),
            moment: moment(&self.moment),
        }
    }

    /// Returns the inertia tensor about the point of reference.
    #[must_use]
    pub fn inertia(&self) -> InertiaTensor<S> {
        self.inertia
    }

    /// Returns the kinetic energy ½ **ω**ᵀ\[I\]**ω** of the rotation (4.2).
    #[must_use]
    pub fn kinetic_energy(&self, state: &RotationState<S>) -> S {
        let omega = state.angular_velocity;
        S::from_f64(0.5) * omega.dot(&self.angular_momentum(state))
    }

    /// Returns the angular momentum \[I\] **ω** in axes of the body (3.2).
    #[must_use]
    pub fn angular_momentum(&self, state: &RotationState<S>) -> Vector3<S> {
        self.inertia * state.angular_velocity
    }

    /// Returns the angular momentum in axes of space, which is constant if there is no moment.
    #[must_use]
    pub fn angular_momentum_in_space(&self, state: &RotationState<S>) -> Vector3<S> {
        state.to_space(&self.angular_momentum(state))
    }

    /// Returns the angular acceleration under a moment, given the products of components of **ω**.
    fn acceleration(&self, moment: Vector3<S>, products: &VelocityProducts<S>) -> Vector3<S> {
        self.factored
            .solve(&(moment - products.gyroscopic(&self.inertia)))
    }
}

/// The products of the components of the angular velocity.
struct VelocityProducts<S> {
    /// ω₂ω₃, ω₃ω₁, ω₁ω₂.
    mixed: [S; 3],
    /// ω₂² − ω₃², ω₃² − ω₁², ω₁² − ω₂².
    differences: [S; 3],
}

impl<S: Scalar> VelocityProducts<S> {
    fn of(omega: &Vector3<S>) -> Self {
        let [x, y, z]: [S; 3] = (*omega).into();
        Self {
            mixed: [y * z, z * x, x * y],
            differences: [(y - z) * (y + z), (z - x) * (z + x), (x - y) * (x + y)],
        }
    }

    /// Returns **ω** × \[I\] **ω**: without products of inertia, (I₃ − I₂) ω₂ω₃ and so on.
    fn gyroscopic(&self, inertia: &InertiaTensor<S>) -> Vector3<S> {
        let [a, b, c] = inertia.moments();
        let ProductsOfInertia { xy, xz, yz } = inertia.products();
        let [of_yz, of_zx, of_xy] = self.mixed;
        let [first, second, third] = self.differences;
        Vector3::new(
            (c - b) * of_yz - yz * first - xz * of_xy + xy * of_zx,
            (a - c) * of_zx - xz * second - xy * of_yz + yz * of_xy,
            (b - a) * of_xy - xy * third - yz * of_zx + xz * of_yz,
        )
    }
}

/// Returns **ω** × \[I\] **ω**.
pub(super) fn gyroscopic<S: Scalar>(inertia: &InertiaTensor<S>, omega: &Vector3<S>) -> Vector3<S> {
    VelocityProducts::of(omega).gyroscopic(inertia)
}

impl<S: Scalar, M: Moment<S>> Dynamics<S> for EulerEquations<S, M> {
    type State = RotationState<S>;

    fn derivative(&self, t: S, x: &RotationState<S>) -> RotationState<S> {
        let moment = self.moment.moment(t, x);
        let products = VelocityProducts::of(&x.angular_velocity);
        let quaternion = quaternion_rate(&x.quaternion.into(), &x.angular_velocity);
        RotationState {
            quaternion: quaternion.into(),
            angular_velocity: self.acceleration(moment, &products),
        }
    }

    /// Divides the quaternion by its norm.
    fn project(&self, _: S, x: &RotationState<S>) -> Option<Projection<S, RotationState<S>>> {
        Some(Projection::new(RotationState {
            quaternion: components(&x.orientation()).into(),
            angular_velocity: x.angular_velocity,
        }))
    }

    fn constraint_name(&self, _: usize) -> &'static str {
        "the norm of the quaternion"
    }

    fn component_name(&self, index: usize) -> ComponentName {
        let names = ["w", "x", "y", "z", "ω₁", "ω₂", "ω₃"];
        let name = names.get(index).copied();
        name.map_or(ComponentName::Index(index), ComponentName::Coordinate)
    }
}

/// The series of the products that occur in the equations.
struct Recurrence<S, const HALF: usize> {
    mixed: [Product<S, HALF>; 3],
    squares: [Square<S, HALF>; 3],
    /// The products of the components of the quaternion and the components of **ω**.
    rates: [[Product<S, HALF>; 3]; 4],
}

impl<S: Scalar, const HALF: usize> Recurrence<S, HALF> {
    fn new() -> Self {
        Self {
            mixed: [Product::new(); 3],
            squares: [Square::new(); 3],
            rates: [[Product::new(); 3]; 4],
        }
    }

    fn velocity_products(&mut self, omega: &Vector3<S>) -> VelocityProducts<S> {
        let [x, y, z]: [S; 3] = (*omega).into();
        let [yz, zx, xy] = &mut self.mixed;
        let mixed = [yz.next(y, z), zx.next(z, x), xy.next(x, y)];
        let [of_x, of_y, of_z] = &mut self.squares;
        let [xx, yy, zz] = [of_x.next(x), of_y.next(y), of_z.next(z)];
        VelocityProducts {
            mixed,
            differences: [yy - zz, zz - xx, xx - yy],
        }
    }

    /// Returns ½ q ∘ (0, **ω**).
    fn quaternion_rate(&mut self, quaternion: &[S; 4], omega: &Vector3<S>) -> [S; 4] {
        let half = S::from_f64(0.5);
        let omega: [S; 3] = (omega * half).into();
        let mut products = [[S::zero(); 3]; 4];
        let rows = products.iter_mut().zip(&mut self.rates).zip(quaternion);
        for ((row, series), component) in rows {
            for ((product, series), omega) in row.iter_mut().zip(series).zip(omega) {
                *product = series.next(*component, omega);
            }
        }
        let [[w1, w2, w3], [x1, x2, x3], [y1, y2, y3], [z1, z2, z3]] = products;
        [-x1 - y2 - z3, w1 + y3 - z2, w2 + z1 - x3, w3 + x2 - y1]
    }
}

impl<S: Scalar, M: MomentSeries<S>> Series<S> for EulerEquations<S, M> {
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &RotationState<S>),
        unit: S,
        coefficients: &mut TaylorCoefficients<RotationState<S>, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        let mut recurrence = Recurrence::<S, HALF>::new();
        let mut of_moment = self.moment.recurrence::<HALF>();
        coefficients.solve(t, x, unit, |order, x| {
            let moment = self.moment.next(&mut of_moment, order, x);
            let products = recurrence.velocity_products(&x.angular_velocity);
            let quaternion = recurrence.quaternion_rate(&x.quaternion.into(), &x.angular_velocity);
            RotationState {
                quaternion: quaternion.into(),
                angular_velocity: self.acceleration(moment, &products),
            }
        });
    }
}
