//! What of a scalar's arithmetic follows from its operations.

/// Implements the assigning operators, zero and one for a scalar that has the others and `from_f64`.
macro_rules! arithmetic {
    ($scalar:ty) => {
        $crate::arithmetic::arithmetic! { $scalar:
            AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /
        }

        impl num_traits::Zero for $scalar {
            fn zero() -> Self {
                lagrangian::Scalar::from_f64(0.0)
            }

            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl num_traits::One for $scalar {
            fn one() -> Self {
                lagrangian::Scalar::from_f64(1.0)
            }
        }
    };
    ($scalar:ty: $($assigning:ident $assign:ident $operator:tt),*) => {$(
        impl std::ops::$assigning for $scalar {
            fn $assign(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

pub(crate) use arithmetic;
