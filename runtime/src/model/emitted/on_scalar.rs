//! The fields of a struct with a type parameter for its scalar, converted to equal values on another scalar: in every lane, or as
//! constants on dual numbers.

use core::marker::PhantomData;

use nalgebra::SMatrix;

use crate::scalar::{Dual, Lanes, Scalar};

/// A field that uses the type parameter: the number itself, a vector or matrix of it, or an array of these.
pub trait OnScalar<W> {
    /// The type of the field in the struct on the other scalar.
    type OnScalar;

    /// Returns this value.
    fn on_scalar(&self) -> Self::OnScalar;
}

impl<const L: usize> OnScalar<Lanes<L>> for f64 {
    type OnScalar = Lanes<L>;

    fn on_scalar(&self) -> Lanes<L> {
        Lanes::from_f64(*self)
    }
}

impl<S: Scalar> OnScalar<Dual<S, 1>> for S {
    type OnScalar = Dual<S, 1>;

    fn on_scalar(&self) -> Dual<S, 1> {
        Dual::constant(*self)
    }
}

impl<S, W, const R: usize, const C: usize> OnScalar<W> for SMatrix<S, R, C>
where
    S: Scalar + OnScalar<W, OnScalar = W>,
    W: Scalar,
{
    type OnScalar = SMatrix<W, R, C>;

    fn on_scalar(&self) -> Self::OnScalar {
        self.map(|x| x.on_scalar())
    }
}

impl<P: OnScalar<W>, W, const K: usize> OnScalar<W> for [P; K] {
    type OnScalar = [P::OnScalar; K];

    fn on_scalar(&self) -> Self::OnScalar {
        core::array::from_fn(|i| self[i].on_scalar())
    }
}

impl<S, W> OnScalar<W> for PhantomData<S> {
    type OnScalar = PhantomData<W>;

    fn on_scalar(&self) -> Self::OnScalar {
        PhantomData
    }
}

/// A field that does not use the type parameter, and is copied to a struct on another scalar.
pub trait Kept<W> {
    /// Returns a copy.
    #[must_use]
    fn kept(&self) -> Self;
}

impl<P: Clone, W> Kept<W> for P {
    fn kept(&self) -> Self {
        self.clone()
    }
}
