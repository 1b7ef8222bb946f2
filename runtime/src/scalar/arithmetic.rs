//! Compound assignment operators, zero and one, defined by the other operators of a scalar.

/// Implements the compound assignment operators for a scalar, generic over `generics`, that has the other operators.
macro_rules! assigning {
    ([$($generics:tt)*] $scalar:ty) => {
        $crate::scalar::arithmetic::assigning! { [$($generics)*] $scalar: AddAssign add_assign + }
        $crate::scalar::arithmetic::assigning! { [$($generics)*] $scalar: SubAssign sub_assign - }
        $crate::scalar::arithmetic::assigning! { [$($generics)*] $scalar: MulAssign mul_assign * }
        $crate::scalar::arithmetic::assigning! { [$($generics)*] $scalar: DivAssign div_assign / }
    };
    ([$($generics:tt)*] $scalar:ty: $assigning:ident $assign:ident $operator:tt) => {
        impl<$($generics)*> core::ops::$assigning for $scalar {
            #[inline]
            fn $assign(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    };
}

/// Implements the compound assignment operators, zero and one for a scalar, generic over `generics`, that has the other
/// operators and `from_f64`.
macro_rules! arithmetic {
    ([$($generics:tt)*] $scalar:ty) => {
        $crate::scalar::arithmetic::assigning! { [$($generics)*] $scalar }

        impl<$($generics)*> num_traits::Zero for $scalar {
            #[inline]
            fn zero() -> Self {
                $crate::Scalar::from_f64(0.0)
            }

            #[inline]
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl<$($generics)*> num_traits::One for $scalar {
            #[inline]
            fn one() -> Self {
                $crate::Scalar::from_f64(1.0)
            }
        }
    };
}

pub(super) use {arithmetic, assigning};
