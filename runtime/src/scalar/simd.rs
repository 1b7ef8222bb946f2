//! SIMD vectors of `f64`, of one number or of several.
//!
//! Every lane rounds as a single number does, so that its results do not depend on the width. With the standard
//! library the vectors are those of the crate `wide`, which use the vector registers of the processor.

use core::ops::{Add, BitAnd, BitXor, Mul, Shl, Sub};

/// A vector of `WIDTH` numbers.
pub(crate) trait SimdVector<const WIDTH: usize>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// The bit patterns of the lanes.
    type Bits: Copy
        + BitAnd<Output = Self::Bits>
        + BitXor<Output = Self::Bits>
        + Shl<u64, Output = Self::Bits>;

    /// The vector of the values of a function at the lanes 0, 1, ….
    fn from_fn(number: impl Fn(usize) -> f64) -> Self;
    fn to_array(self) -> [f64; WIDTH];
    fn from_bits(bits: Self::Bits) -> Self;
    fn to_bits(self) -> Self::Bits;

    /// In every lane, the lowest bit repeated over all bits: a bit mask.
    fn repeat_lowest(bits: Self::Bits) -> Self::Bits;

    /// `self · factor + summand`, fused only where the target has the instruction; it is a call elsewhere.
    fn mul_add(self, factor: Self, summand: Self) -> Self;

    #[inline]
    fn splat(number: f64) -> Self {
        Self::from_fn(|_| number)
    }
}

impl SimdVector<1> for f64 {
    type Bits = u64;

    #[inline]
    fn from_fn(number: impl Fn(usize) -> f64) -> Self {
        number(0)
    }

    #[inline]
    fn to_array(self) -> [f64; 1] {
        [self]
    }

    #[inline]
    fn from_bits(bits: u64) -> Self {
        Self::from_bits(bits)
    }

    #[inline]
    fn to_bits(self) -> u64 {
        self.to_bits()
    }

    #[inline]
    fn repeat_lowest(bits: u64) -> u64 {
        0_u64.wrapping_sub(bits & 1)
    }

    #[inline]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        #[cfg(all(target_feature = "fma", feature = "std"))]
        return self.mul_add(factor, summand);
        #[cfg(not(all(target_feature = "fma", feature = "std")))]
        return self * factor + summand;
    }
}

#[cfg(feature = "std")]
macro_rules! vector {
    ($width:literal, $numbers:ident, $bits:ident, $($lane:literal)*) => {
        impl SimdVector<$width> for wide::$numbers {
            type Bits = wide::$bits;

            #[inline]
            fn from_fn(number: impl Fn(usize) -> f64) -> Self {
                // No loop: a vector that is loaded from an array which was just stored to stalls.
                Self::new([$(number($lane)),*])
            }

            #[inline]
            fn to_array(self) -> [f64; $width] {
                self.to_array()
            }

            #[inline]
            fn from_bits(bits: Self::Bits) -> Self {
                wide::bytemuck::cast(bits)
            }

            #[inline]
            fn to_bits(self) -> Self::Bits {
                wide::bytemuck::cast(self)
            }

            #[inline]
            fn repeat_lowest(bits: Self::Bits) -> Self::Bits {
                wide::$bits::splat(0) - (bits & wide::$bits::splat(1))
            }

            #[inline]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                #[cfg(target_feature = "fma")]
                return self.mul_add(factor, summand);
                #[cfg(not(target_feature = "fma"))]
                return self * factor + summand;
            }
        }
    };
}

#[cfg(feature = "std")]
vector! { 2, f64x2, u64x2, 0 1 }
#[cfg(feature = "std")]
vector! { 4, f64x4, u64x4, 0 1 2 3 }
