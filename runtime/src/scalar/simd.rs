//! SIMD vectors of `f64`, with one or several numbers.
//!
//! Every lane rounds like a single number, so that its results do not depend on the width. With the standard library,
//! the vectors are types of the crate `wide`, which use the vector registers of the processor.

use core::ops::{Add, BitAnd, BitXor, Div, Mul, Neg, Shl, Sub};

/// A vector of `WIDTH` numbers.
pub(crate) trait SimdVector<const WIDTH: usize>:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The bit patterns of the lanes.
    type Bits: Copy
        + BitAnd<Output = Self::Bits>
        + BitXor<Output = Self::Bits>
        + Shl<u64, Output = Self::Bits>;

    /// Returns the vector of the values of a function at the lanes 0, 1, ….
    fn from_fn(number: impl Fn(usize) -> f64) -> Self;
    fn from_array(numbers: [f64; WIDTH]) -> Self;
    fn to_array(self) -> [f64; WIDTH];
    fn from_bits(bits: Self::Bits) -> Self;
    fn to_bits(self) -> Self::Bits;

    /// Returns the absolute values.
    fn abs(self) -> Self;

    /// Repeats the lowest bit of every lane over all bits, which gives a bit mask.
    fn repeat_lowest(bits: Self::Bits) -> Self::Bits;

    /// Returns `self · factor + summand`, fused only if the target has the instruction; elsewhere it would be a call.
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
    fn from_array([number]: [f64; 1]) -> Self {
        number
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
    fn abs(self) -> Self {
        self.abs()
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
                // No loop: loading a vector from an array that was just stored would stall.
                Self::new([$(number($lane)),*])
            }

            #[inline(always)]
            fn from_array(numbers: [f64; $width]) -> Self {
                Self::new(numbers)
            }

            #[inline(always)]
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

            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline]
            fn repeat_lowest(bits: Self::Bits) -> Self::Bits {
                wide::$bits::splat(0) - (bits & wide::$bits::splat(1))
            }

            #[inline(always)]
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
#[cfg(feature = "std")]
vector! { 8, f64x8, u64x8, 0 1 2 3 4 5 6 7 }

/// An operation on the lanes of `OPERANDS` vectors.
pub(crate) trait LaneOperation<const OPERANDS: usize> {
    fn apply<const WIDTH: usize, V: SimdVector<WIDTH>>(operands: [V; OPERANDS]) -> V;
}

/// Returns the results of an operation in all lanes, in vectors of eight or four if these divide the number of lanes.
/// The vectors are explicit, since the compiler vectorizes some loops over the lanes, but not all: the general top
/// takes 1.5 times as long in loops.
#[inline(always)]
#[allow(clippy::inline_always)] // An operation is one instruction.
pub(crate) fn in_vectors<
    Operation: LaneOperation<OPERANDS>,
    const OPERANDS: usize,
    const LANES: usize,
>(
    operands: [&[f64; LANES]; OPERANDS],
) -> [f64; LANES] {
    #[cfg(feature = "std")]
    if LANES.is_multiple_of(8) {
        return in_vectors_of::<8, wide::f64x8, Operation, OPERANDS, LANES>(operands);
    } else if LANES.is_multiple_of(4) {
        return in_vectors_of::<4, wide::f64x4, Operation, OPERANDS, LANES>(operands);
    }
    in_vectors_of::<1, f64, Operation, OPERANDS, LANES>(operands)
}

#[inline(always)]
#[allow(clippy::inline_always)] // An operation is one instruction.
fn in_vectors_of<
    const WIDTH: usize,
    V: SimdVector<WIDTH>,
    Operation: LaneOperation<OPERANDS>,
    const OPERANDS: usize,
    const LANES: usize,
>(
    operands: [&[f64; LANES]; OPERANDS],
) -> [f64; LANES] {
    let mut results = [0.0; LANES];
    for (index, results) in results.as_chunks_mut::<WIDTH>().0.iter_mut().enumerate() {
        let operand = |i: usize| V::from_array(operands[i].as_chunks::<WIDTH>().0[index]);
        let operands = core::array::from_fn(operand);
        *results = Operation::apply(operands).to_array();
    }
    results
}
