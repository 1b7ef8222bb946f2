//! Sine and cosine of one or of several angles, without a call and without a branch.
//!
//! The angle is reduced by the nearest multiple of π/2, in the manner of Cody and Waite (Software Manual
//! for the Elementary Functions, 1980), to r + tail with |r| ≤ π/4; there sin and cos are minimax
//! polynomials, and the quadrant exchanges them and sets their signs through their bits. What several
//! angles need is the same straight line, so that the compiler turns a loop over them into vectors.
//!
//! Below [`LARGEST`] the error is less than 1 unit in the last place (measured in
//! `tests/tests/sine_cosine.rs`, beside the reduction's worst cases). Larger angles, infinities and NaN
//! go to the platform's library. `runtime/scripts/sine_cosine_constants.py` computes the constants.

use core::f64::consts::FRAC_2_PI;

/// Up to here the whole number n of quarter turns is below 2¹⁶, and its products with the first two
/// parts of π/2 are exact.
const LARGEST: f64 = 100_000.0;

/// π/2 in three parts, 37 bits in each of the first two. What they leave is below n · 2⁻¹²⁸, and no
/// binary64 number up to [`LARGEST`] is closer to a multiple n of π/2 than n · 2⁻⁶⁶.
const HALF_PI: [f64; 3] = [
    1.570_796_326_792_333_3,
    2.563_344_151_583_955_8e-12,
    1.056_299_906_698_742_8e-23,
];

/// (sin r − r) / r³ in powers of r², to 2⁻⁵⁷ of sin r.
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_3,
    0.008_333_333_333_321_84,
    -0.000_198_412_698_293_585_28,
    2.755_731_353_851_423_4e-6,
    -2.505_073_438_925_796e-8,
    1.589_543_328_945_913_3e-10,
];

/// (cos r − 1 + r²/2) / r⁴ in powers of r², to 2⁻⁶³ of cos r.
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_334_2,
    2.480_158_728_900_208e-5,
    -2.755_731_421_703_865e-7,
    2.087_570_539_594_815_5e-9,
    -1.135_874_923_225_579e-11,
];

/// Added to a number below it, 2⁵² leaves no room for a fraction: the sum is rounded to a whole number,
/// which stands in its last bits.
const NO_FRACTION: f64 = 4_503_599_627_370_496.0;

/// The bit that tells the sign of a number.
const SIGN: u64 = 1 << 63;

/// Sine and cosine of one angle.
#[inline]
pub(crate) fn sine_and_cosine(x: f64) -> (f64, f64) {
    if is_reducible(x) {
        straight(x)
    } else {
        by_library(x)
    }
}

/// The sines and the cosines of several angles, each as [`sine_and_cosine`] gives them.
///
/// A function of its own: where the results went into scalar arithmetic, the compiler would find no
/// reason to begin a vector. It finds one in their being stored side by side.
#[inline(never)]
pub(crate) fn sines_and_cosines<const K: usize>(x: [f64; K]) -> ([f64; K], [f64; K]) {
    let (mut sines, mut cosines) = ([0.0; K], [0.0; K]);
    if x.iter().fold(true, |all, x| all & is_reducible(*x)) {
        let (eights, fours) = (K - K % 8, K - K % 4);
        blocks::<8>(&x, &mut sines, &mut cosines);
        blocks::<4>(&x[eights..], &mut sines[eights..], &mut cosines[eights..]);
        blocks::<2>(&x[fours..], &mut sines[fours..], &mut cosines[fours..]);
        if let (Some(x), 1) = (x.last(), K % 2) {
            (sines[K - 1], cosines[K - 1]) = straight(*x);
        }
    } else {
        for i in 0..K {
            (sines[i], cosines[i]) = one_of_several(x[i]);
        }
    }
    (sines, cosines)
}

/// What there is of whole blocks of `WIDTH` angles. A short loop is unrolled, and becomes vectors only if
/// its length is that of vectors.
#[inline]
fn blocks<const WIDTH: usize>(x: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    let angles = x.as_chunks::<WIDTH>().0.iter();
    let sines = sines.as_chunks_mut::<WIDTH>().0.iter_mut();
    let cosines = cosines.as_chunks_mut::<WIDTH>().0.iter_mut();
    for ((x, sine), cosine) in angles.zip(sines).zip(cosines) {
        for i in 0..WIDTH {
            (sine[i], cosine[i]) = straight(x[i]);
        }
    }
}

#[inline]
fn is_reducible(x: f64) -> bool {
    x.abs() <= LARGEST
}

/// What is left of an angle by a whole number of quarter turns.
struct Reduced {
    r: f64,
    /// What r was rounded off by.
    tail: f64,
    /// The last two bits count the quarter turns.
    quarters: u64,
}

/// Without a branch, for angles up to [`LARGEST`].
#[inline]
fn straight(x: f64) -> (f64, f64) {
    // The sine of the magnitude, so that −0 keeps its sign.
    let Reduced { r, tail, quarters } = reduced(x.abs());
    let (sine, cosine) = (sine(r, tail).to_bits(), cosine(r, tail).to_bits());
    // All bits or none. Of the quarters 1 and 3 the sine is the cosine of r. In this form, unlike that
    // of a selection or an exchange, the compiler sees what is alike in several angles.
    let odd = 0_u64.wrapping_sub(quarters & 1);
    let exchanged = (
        (sine & !odd) | (cosine & odd),
        (cosine & !odd) | (sine & odd),
    );
    let sign = x.to_bits() & SIGN;
    // Of the quarters 0, 1, 2, 3 the sine is negative in 2 and 3, the cosine in 1 and 2.
    let below = (quarters << 62) & SIGN;
    let left = (quarters.wrapping_add(1) << 62) & SIGN;
    (
        f64::from_bits(exchanged.0 ^ below ^ sign),
        f64::from_bits(exchanged.1 ^ left),
    )
}

/// For 0 ≤ x up to [`LARGEST`].
#[inline]
fn reduced(x: f64) -> Reduced {
    let rounded = multiply_add(x, FRAC_2_PI, NO_FRACTION);
    let n = rounded - NO_FRACTION;
    // This difference is exact, and so is the product in the next: what that rounds off is found again.
    let first = multiply_add(-n, HALF_PI[0], x);
    let second = multiply_add(-n, HALF_PI[1], first);
    let lost = multiply_add(-n, HALF_PI[1], first - second);
    let third = multiply_add(n, HALF_PI[2], -lost);
    let r = second - third;
    Reduced {
        r,
        tail: (second - r) - third,
        quarters: rounded.to_bits(),
    }
}

/// sin (r + tail) for |r| ≤ π/4.
#[inline]
fn sine(r: f64, tail: f64) -> f64 {
    let z = r * r;
    let cubic = r * z * polynomial(&SINE, z);
    r + (cubic + tail * (1.0 - 0.5 * z))
}

/// cos (r + tail) for |r| ≤ π/4.
#[inline]
fn cosine(r: f64, tail: f64) -> f64 {
    let z = r * r;
    let half = 0.5 * z;
    let most = 1.0 - half;
    let quartic = z * z * polynomial(&COSINE, z);
    most + (((1.0 - most) - half) + (quartic - r * tail))
}

/// In pairs, which depend less on each other than Horner's products do.
#[inline]
fn polynomial(c: &[f64; 6], z: f64) -> f64 {
    let low = multiply_add(c[1], z, c[0]);
    let middle = multiply_add(c[3], z, c[2]);
    let high = multiply_add(c[5], z, c[4]);
    let square = z * z;
    multiply_add(multiply_add(high, square, middle), square, low)
}

/// Fused only where the target has the instruction; it is a call elsewhere.
#[inline]
fn multiply_add(x: f64, y: f64, z: f64) -> f64 {
    #[cfg(all(target_feature = "fma", feature = "std"))]
    return x.mul_add(y, z);
    #[cfg(not(all(target_feature = "fma", feature = "std")))]
    return x * y + z;
}

#[cold]
#[inline(never)]
fn by_library(x: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    return x.sin_cos();
    #[cfg(not(feature = "std"))]
    return libm::sincos(x);
}

#[cold]
#[inline(never)]
fn one_of_several(x: f64) -> (f64, f64) {
    sine_and_cosine(x)
}
