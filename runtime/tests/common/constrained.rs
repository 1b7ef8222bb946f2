//! Systems whose equations hold on a manifold: pendulums in Cartesian coordinates, and a body with a unit quaternion.
#![allow(dead_code, unreachable_pub)] // Every binary has a copy of it, and none uses all.

use lagrangian::elliptic::Modulus;
use lagrangian::prelude::*;
use lagrangian::problem::Projection;
use lagrangian::recurrences::{Product, Quotient, Square};
use lagrangian::rigid_body::{EulerEquations, RotationState};
use lagrangian::{BranchVisitor, Series, SeriesMemory, TaylorCoefficients};
use nalgebra::SVector;

/// A mass on a rod about the origin, as equations of index 1 in (x, y, ẋ, ẏ): ẍ = λ x, ÿ = λ y − g, with the multiplier λ from the
/// second derivative of x² + y² = l².
#[derive(Clone, Copy, Debug)]
pub struct Rod {
    pub length: f64,
    pub gravity: f64,
    /// A force −f sgn x, which has a jump.
    pub friction: f64,
    /// Whether it projects.
    pub projects: bool,
}

/// A rod of length 2 that projects.
pub const ROD: Rod = Rod {
    length: 2.0,
    gravity: 9.81,
    friction: 0.0,
    projects: true,
};

/// The angle from which the pendulum is released.
pub const RELEASE: f64 = 1.2;

impl Rod {
    pub fn drifting(self) -> Self {
        Self {
            projects: false,
            ..self
        }
    }

    /// Released at rest from an angle.
    pub fn released(&self, angle: f64) -> At<f64, SVector<f64, 4>> {
        let (sine, cosine) = angle.sin_cos();
        let position = [self.length * sine, -self.length * cosine];
        At::from((0.0, SVector::from([position[0], position[1], 0.0, 0.0])))
    }

    fn modulus(angle: f64) -> (Modulus<f64>, f64) {
        let (k, cosine) = (0.5 * angle).sin_cos();
        (Modulus::new(k * k, cosine * cosine), k)
    }

    /// Half the period of the pendulum released from an angle.
    pub fn half_period(&self, angle: f64) -> f64 {
        2.0 * Self::modulus(angle).0.complete_first() * (self.length / self.gravity).sqrt()
    }

    /// The position of the pendulum released from an angle: sin ½θ = k sn(K + t √(g/l)), k = sin ½α.
    pub fn closed_form(&self, angle: f64, t: f64) -> [f64; 2] {
        let (modulus, k) = Self::modulus(angle);
        let argument = modulus.complete_first() + t * (self.gravity / self.length).sqrt();
        let (sn, _, dn) = modulus.jacobi(argument);
        let half_sine = k * sn;
        [
            2.0 * self.length * half_sine * dn,
            self.length * (2.0 * half_sine * half_sine - 1.0),
        ]
    }

    pub fn energy(&self, x: &SVector<f64, 4>) -> f64 {
        0.5 * (x[2] * x[2] + x[3] * x[3]) + self.gravity * x[1] + self.friction * x[0].abs()
    }

    /// The residuals of position and velocity, over l and √(g l).
    pub fn residuals(&self, x: &SVector<f64, 4>) -> [f64; 2] {
        let l = self.length;
        let position = (x[0] * x[0] + x[1] * x[1] - l * l) / (2.0 * l * l);
        let velocity = (x[0] * x[2] + x[1] * x[3]) / (l * (self.gravity * l).sqrt());
        [position.abs(), velocity.abs()]
    }
}

impl<S: Scalar> Dynamics<S> for Rod {
    type State = SVector<S, 4>;

    fn derivative(&self, _: S, x: &Self::State) -> Self::State {
        let [gravity, friction] = [self.gravity, self.friction].map(S::from_f64);
        let force = -friction * x[0].signum();
        let rate = x[2] * x[2] + x[3] * x[3] - gravity * x[1] + force * x[0];
        let multiplier = -rate / (x[0] * x[0] + x[1] * x[1]);
        SVector::from([
            x[2],
            x[3],
            multiplier * x[0] + force,
            multiplier * x[1] - gravity,
        ])
    }

    /// Newton's method with the gradient at the beginning, in three sweeps, then the velocity.
    fn project(&self, _: S, x: &Self::State) -> Option<Projection<S, Self::State>> {
        if !self.projects {
            return None;
        }
        let square = S::from_f64(self.length * self.length);
        let residual = |x: S, y: S| (x * x + y * y - square) * S::from_f64(0.5);
        let gradient = [x[0], x[1]];
        let size = x[0] * x[0] + x[1] * x[1];
        let mut position = gradient;
        for _ in 0..3 {
            let multiplier = residual(position[0], position[1]) / size;
            position[0] -= multiplier * gradient[0];
            position[1] -= multiplier * gradient[1];
        }
        let [p, q] = position;
        let along = (p * x[2] + q * x[3]) / (p * p + q * q);
        let state = SVector::from([p, q, x[2] - along * p, x[3] - along * q]);
        let allowed = square * S::from_f64(1e-12);
        Some(Projection::new(state).checked(1, residual(p, q), allowed))
    }

    fn constraint_name(&self, index: usize) -> &'static str {
        ["nothing", "the length of the rod"][index]
    }
}

impl<S: Scalar> Series<S> for Rod {
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        let gravity = S::from_f64(self.gravity);
        let force = -S::from_f64(self.friction) * x[0].signum();
        let mut squares = [Square::<S, HALF>::new(); 4];
        let mut quotient = Quotient::<S, HALF>::new();
        let mut products = [Product::<S, HALF>::new(); 2];
        let mut is_first = true;
        coefficients.solve(t, x, unit, |_, x| {
            let [a, b, c, d] = &mut squares;
            let rate = c.next(x[2]) + d.next(x[3]) - gravity * x[1] + force * x[0];
            let multiplier = -quotient.next(rate, a.next(x[0]) + b.next(x[1]));
            let [first, second] = &mut products;
            let constant = if core::mem::take(&mut is_first) {
                S::one()
            } else {
                S::zero()
            };
            SVector::from([
                x[2],
                x[3],
                first.next(multiplier, x[0]) + force * constant,
                second.next(multiplier, x[1]) - gravity * constant,
            ])
        });
    }

    fn branches<const HALF: usize>(
        &self,
        _: S,
        x: &Self::State,
        _: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        if self.friction != 0.0 {
            let higher = motion.higher().iter().map(|term| term[0]);
            visit(&mut core::iter::once(x[0]).chain(higher));
        }
    }
}

crate::alike_in_lanes!(Rod);

/// The free rotation of a body, with a quaternion that is kept at unit length if it projects.
#[derive(Clone, Copy, Debug)]
pub struct UnitQuaternion<S: Scalar = f64> {
    pub body: EulerEquations<S>,
    pub projects: bool,
}

impl<S: Scalar> Dynamics<S> for UnitQuaternion<S> {
    type State = RotationState<S>;

    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        self.body.derivative(t, x)
    }

    fn project(&self, _: S, x: &Self::State) -> Option<Projection<S, Self::State>> {
        let q = x.quaternion;
        let norm = q.iter().fold(S::zero(), |sum, q| sum + *q * *q).sqrt();
        let state = RotationState {
            quaternion: q.map(|q| q / norm),
            ..*x
        };
        self.projects.then(|| Projection::new(state))
    }
}

impl<S: Scalar> Series<S> for UnitQuaternion<S> {
    fn series<const HALF: usize>(
        &self,
        begin: (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        self.body.series(begin, unit, coefficients, memory);
    }
}
