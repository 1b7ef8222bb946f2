//! Several motions at once: a scalar of two lanes.

mod common;

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use common::{Pendulum, assert_close};
use lagrangian::prelude::*;
use num_traits::{One, Zero};

/// Two numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lanes([f64; 2]);

impl Lanes {
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $assign_trait:ident $assign:ident;)*) => {$(
        impl $trait for Lanes {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.zip(other, f64::$method)
            }
        }
        impl $assign_trait for Lanes {
            fn $assign(&mut self, other: Self) {
                *self = self.zip(other, f64::$method);
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}

impl Neg for Lanes {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(f64::neg))
    }
}

impl Zero for Lanes {
    fn zero() -> Self {
        Self([0.0; 2])
    }
    fn is_zero(&self) -> bool {
        self.0.iter().all(Zero::is_zero)
    }
}

impl One for Lanes {
    fn one() -> Self {
        Self([1.0; 2])
    }
}

macro_rules! functions {
    ($($unary:ident)*; $($binary:ident)*) => {
        $(fn $unary(self) -> Self { Self(self.0.map(<f64 as Scalar>::$unary)) })*
        $(fn $binary(self, other: Self) -> Self { self.zip(other, <f64 as Scalar>::$binary) })*
    };
}

impl Scalar for Lanes {
    fn from_f64(value: f64) -> Self {
        Self([value; 2])
    }
    fn smallest(self) -> f64 {
        // A comparison with NaN is false, and NaN is what must come out.
        let [a, b] = self.0;
        if a < b || a.is_nan() { a } else { b }
    }
    fn largest(self) -> f64 {
        let [a, b] = self.0;
        if a > b || a.is_nan() { a } else { b }
    }
    functions! {
        sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp ln sqrt abs signum;
        atan2 powf min max
    }
}

const PENDULUM: Pendulum = Pendulum {
    m: 1.0,
    g: 9.81,
    l: 1.0,
};

/// Two pendulums of different amplitudes, stepped together.
fn both() -> State<Lanes, 1> {
    State::new(Lanes::zero(), [Lanes([0.5, 2.5])], [Lanes([0.0, 1.0])])
}

#[test]
fn lanes_move_as_they_would_alone() {
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let times = [0.5, 1.0, 2.0];
    let together = method.sample(&PENDULUM.dynamics(), both(), &times).unwrap();
    for (lane, (q, v)) in [(0.5, 0.0), (2.5, 1.0)].into_iter().enumerate() {
        let initial = State::new(0.0, [q], [v]);
        let alone = method
            .sample(&PENDULUM.dynamics(), initial, &times)
            .unwrap();
        for (together, alone) in together.states().zip(alone.states()) {
            assert_close(together.q[0].0[lane], alone.q[0], 1e-10);
            assert_close(together.v[0].0[lane], alone.v[0], 1e-10);
        }
    }
}

/// The error that counts is that of the worst lane.
#[test]
fn the_step_is_that_of_the_fastest_lane() {
    let method = Dop853::new()
        .relative_tolerance(1e-10)
        .absolute_tolerance(1e-10);
    let steps = |initial: State<Lanes, 1>| {
        let driver = method.driver();
        driver
            .integrate_to(&PENDULUM.dynamics(), initial, 10.0)
            .unwrap()
            .statistics
            .steps
    };
    let slow = State::new(Lanes::zero(), [Lanes([0.5; 2])], [Lanes([0.0; 2])]);
    assert!(steps(both()) > steps(slow));
}

#[test]
fn a_lane_that_is_not_finite_is_an_error_and_lanes_have_one_time() {
    let method = Dop853::new();
    let mut initial = both();
    initial.q[0] = Lanes([0.5, f64::NAN]);
    let error = method
        .integrate_to(&PENDULUM.dynamics(), initial, 1.0)
        .unwrap_err();
    assert_eq!(error.to_string(), "the coordinate theta is NaN at t = 0");
    let mut initial = both();
    initial.t = Lanes([0.0, 1.0]);
    let error = method
        .integrate_to(&PENDULUM.dynamics(), initial, 1.0)
        .unwrap_err();
    assert!(
        matches!(error, IntegrationError::NonFiniteTime { .. }),
        "{error}"
    );
}
