//! Several numbers beside each other as a scalar of derived models.

use std::array;
use std::ops::{Add, Div, Mul, Neg, Sub};

use lagrangian::Scalar;

use crate::arithmetic::arithmetic;

/// How many numbers there are.
pub const LANES: usize = 8;

/// Eight numbers of `f64`, on which everything is done one by one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes(pub [f64; LANES]);

impl Lanes {
    /// The numbers of the lanes, which are counted from 0.
    #[must_use]
    pub fn from_fn(number: impl FnMut(usize) -> f64) -> Self {
        Self(array::from_fn(number))
    }

    /// The number of one lane.
    #[must_use]
    pub fn lane(self, lane: usize) -> f64 {
        self.0[lane]
    }

    fn both(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        Self::from_fn(|lane| function(self.0[lane], other.0[lane]))
    }

    /// The lane that `other` keeps against all others; NaN if one of them is.
    fn extreme(self, keep: impl Fn(f64, f64) -> f64) -> f64 {
        let Self([first, others @ ..]) = self;
        others.into_iter().fold(first, |kept, lane| {
            if kept.is_nan() || lane.is_nan() {
                f64::NAN
            } else {
                keep(kept, lane)
            }
        })
    }
}

macro_rules! operators {
    ($($operator:ident $function:ident)*) => {$(
        impl $operator for Lanes {
            type Output = Self;

            fn $function(self, other: Self) -> Self {
                self.both(other, $operator::$function)
            }
        }
    )*};
}

operators! { Add add Sub sub Mul mul Div div }

impl Neg for Lanes {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

arithmetic!(Lanes);

macro_rules! lane_by_lane {
    ($($unary:ident)*; $($binary:ident)*) => {
        $(
            fn $unary(self) -> Self {
                Self(self.0.map(Scalar::$unary))
            }
        )*
        $(
            fn $binary(self, other: Self) -> Self {
                self.both(other, Scalar::$binary)
            }
        )*
    };
}

impl Scalar for Lanes {
    lane_by_lane! {
        sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp ln sqrt abs signum;
        atan2 powf min max
    }

    fn from_f64(value: f64) -> Self {
        Self([value; LANES])
    }

    fn smallest(self) -> f64 {
        self.extreme(f64::min)
    }

    fn largest(self) -> f64 {
        self.extreme(f64::max)
    }

    fn machine_epsilon() -> f64 {
        f64::machine_epsilon()
    }

    fn mul_add(self, factor: Self, summand: Self) -> Self {
        Self::from_fn(|lane| Scalar::mul_add(self.0[lane], factor.0[lane], summand.0[lane]))
    }

    fn sin_cos(self) -> (Self, Self) {
        let pairs = self.0.map(Scalar::sin_cos);
        (
            Self(pairs.map(|pair| pair.0)),
            Self(pairs.map(|pair| pair.1)),
        )
    }
}
