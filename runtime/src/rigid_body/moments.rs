//! Moments on a rotating body, in axes of the body, and their Taylor series.

use nalgebra::Vector3;

use super::rotation_state::RotationState;
use crate::integrate::recurrences::{Order, Product, Square};
use crate::scalar::Scalar;

/// The moment **N** about the fixed point or the centre of gravity, in axes of the body.
///
/// Closures `|t, state: &RotationState| …` implement this trait.
pub trait Moment<S: Scalar = f64> {
    /// Returns the moment at a time and a state.
    fn moment(&self, t: S, state: &RotationState<S>) -> Vector3<S>;
}

impl<S: Scalar, F: Fn(S, &RotationState<S>) -> Vector3<S>> Moment<S> for F {
    fn moment(&self, t: S, state: &RotationState<S>) -> Vector3<S> {
        self(t, state)
    }
}

/// A moment whose Taylor series is known, so that the Taylor method can integrate the motion of the body.
pub trait MomentSeries<S: Scalar = f64>: Moment<S> {
    /// The state of the recurrence for the lower orders, made of building blocks from
    /// [`recurrences`](crate::recurrences).
    type Recurrence<const HALF: usize>;

    /// Returns the recurrence before order 0.
    fn recurrence<const HALF: usize>(&self) -> Self::Recurrence<HALF>;

    /// Returns the next coefficient, given the coefficient of the state.
    fn next<const HALF: usize>(
        &self,
        recurrence: &mut Self::Recurrence<HALF>,
        order: Order<S>,
        state: &RotationState<S>,
    ) -> Vector3<S>;
}

/// The absence of a moment: a free body, or a body held at its centre of gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoMoment;

impl<S: Scalar> Moment<S> for NoMoment {
    fn moment(&self, _: S, _: &RotationState<S>) -> Vector3<S> {
        Vector3::zeros()
    }
}

/// A moment that is constant in axes of the body, such as the moment of thrusters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantMoment<S: Scalar = f64>(pub Vector3<S>);

impl<S: Scalar> Moment<S> for ConstantMoment<S> {
    fn moment(&self, _: S, _: &RotationState<S>) -> Vector3<S> {
        self.0
    }
}

/// A moment that is proportional to the angular velocity, −C **ω**, such as viscous friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damping<S: Scalar = f64>(pub nalgebra::Matrix3<S>);

impl<S: Scalar> Moment<S> for Damping<S> {
    fn moment(&self, _: S, state: &RotationState<S>) -> Vector3<S> {
        -(self.0 * state.angular_velocity)
    }
}

/// The series of moments without products, which need no memory.
macro_rules! series_without_products {
    ($($moment:ty: |$self:ident, $order:ident, $state:ident| $next:expr;)*) => {$(
        impl<S: Scalar> MomentSeries<S> for $moment {
            type Recurrence<const HALF: usize> = ();

            fn recurrence<const HALF: usize>(&self) {}

            fn next<const HALF: usize>(
                &$self,
                (): &mut (),
                $order: Order<S>,
                $state: &RotationState<S>,
            ) -> Vector3<S> {
                $next
            }
        }
    )*};
}

series_without_products! {
    NoMoment: |self, _order, _state| Vector3::zeros();
    ConstantMoment<S>: |self, order, _state| self.0.map(|component| order.constant(component));
    Damping<S>: |self, _order, state| -(self.0 * state.angular_velocity);
}

/// The moment **N** = **r** × R⁻¹**F** of a force that is constant in space and acts at a point of the body, such as
/// the weight of a top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantForce<S: Scalar = f64> {
    /// The point at which the force acts, in axes of the body, from the fixed point or the centre of gravity.
    pub point: Vector3<S>,
    /// The force in axes of space, such as (0, 0, −m g).
    pub force: Vector3<S>,
}

impl<S: Scalar> ConstantForce<S> {
    /// Returns the moment, given the products of components of the quaternion.
    fn by_products(&self, products: &Products<S>) -> Vector3<S> {
        self.point.cross(&products.to_body(&self.force))
    }
}

impl<S: Scalar> Moment<S> for ConstantForce<S> {
    fn moment(&self, _: S, state: &RotationState<S>) -> Vector3<S> {
        let [w, x, y, z]: [S; 4] = state.quaternion.into();
        self.by_products(&Products {
            squares: [w * w, x * x, y * y, z * z],
            of_w: [w * x, w * y, w * z],
            others: [y * z, z * x, x * y],
        })
    }
}

/// The products of the components of a quaternion.
struct Products<S> {
    /// w², x², y², z².
    squares: [S; 4],
    /// w x, w y, w z.
    of_w: [S; 3],
    /// y z, z x, x y.
    others: [S; 3],
}

impl<S: Scalar> Products<S> {
    /// Returns the components in axes of the body of a vector in axes of space, times the squared norm of the
    /// quaternion: (w² − **q**²) **v** + 2 **q** (**q** · **v**) − 2 w **q** × **v**.
    fn to_body(&self, vector: &Vector3<S>) -> Vector3<S> {
        let two = S::from_f64(2.0);
        let [w, x, y, z] = self.squares;
        let [wx, wy, wz] = self.of_w.map(|product| two * product);
        let [yz, zx, xy] = self.others.map(|product| two * product);
        let [a, b, c]: [S; 3] = (*vector).into();
        Vector3::new(
            (w + x - y - z) * a + (xy + wz) * b + (zx - wy) * c,
            (xy - wz) * a + (w - x + y - z) * b + (yz + wx) * c,
            (zx + wy) * a + (yz - wx) * b + (w - x - y + z) * c,
        )
    }
}

/// The series of the products of the components of a quaternion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProductSeries<S, const HALF: usize> {
    squares: [Square<S, HALF>; 4],
    of_w: [Product<S, HALF>; 3],
    others: [Product<S, HALF>; 3],
}

impl<S: Scalar, const HALF: usize> ProductSeries<S, HALF> {
    fn new() -> Self {
        Self {
            squares: [Square::new(); 4],
            of_w: [Product::new(); 3],
            others: [Product::new(); 3],
        }
    }

    fn next(&mut self, [w, x, y, z]: [S; 4]) -> Products<S> {
        let [ww, xx, yy, zz] = &mut self.squares;
        let [wx, wy, wz] = &mut self.of_w;
        let [yz, zx, xy] = &mut self.others;
        Products {
            squares: [ww.next(w), xx.next(x), yy.next(y), zz.next(z)],
            of_w: [wx.next(w, x), wy.next(w, y), wz.next(w, z)],
            others: [yz.next(y, z), zx.next(z, x), xy.next(x, y)],
        }
    }
}

impl<S: Scalar> MomentSeries<S> for ConstantForce<S> {
    type Recurrence<const HALF: usize> = ProductSeries<S, HALF>;

    fn recurrence<const HALF: usize>(&self) -> ProductSeries<S, HALF> {
        ProductSeries::new()
    }

    fn next<const HALF: usize>(
        &self,
        recurrence: &mut ProductSeries<S, HALF>,
        _: Order<S>,
        state: &RotationState<S>,
    ) -> Vector3<S> {
        self.by_products(&recurrence.next(state.quaternion.into()))
    }
}

/// The sum of two moments.
impl<S: Scalar, A: Moment<S>, B: Moment<S>> Moment<S> for (A, B) {
    fn moment(&self, t: S, state: &RotationState<S>) -> Vector3<S> {
        self.0.moment(t, state) + self.1.moment(t, state)
    }
}

impl<S: Scalar, A: MomentSeries<S>, B: MomentSeries<S>> MomentSeries<S> for (A, B) {
    type Recurrence<const HALF: usize> = (A::Recurrence<HALF>, B::Recurrence<HALF>);

    fn recurrence<const HALF: usize>(&self) -> Self::Recurrence<HALF> {
        (self.0.recurrence(), self.1.recurrence())
    }

    fn next<const HALF: usize>(
        &self,
        (first, second): &mut Self::Recurrence<HALF>,
        order: Order<S>,
        state: &RotationState<S>,
    ) -> Vector3<S> {
        self.0.next(first, order, state) + self.1.next(second, order, state)
    }
}
