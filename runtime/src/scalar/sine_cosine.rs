//! Sine and cosine of one or several angles, without calls and without branches.
//!
//! The argument is reduced by the nearest multiple of π/2 (W. J. Cody & W. Waite, *Software Manual for the Elementary
//! Functions*, 1980) to r + tail with |r| ≤ π/4. In this interval sin and cos are minimax polynomials, computed by the
//! exchange algorithm of Remez. The quadrant interchanges them and sets their signs by bit operations. The
//! implementation for several angles uses SIMD vectors.
//!
//! Up to [`LARGEST`] the error is less than 1 unit in the last place (measured in
//! `tests/tests/reference/sine_cosine.rs`, also at the worst cases of the reduction). Larger angles, infinities and NaN
//! are passed to the platform's library. `runtime/scripts/sine_cosine_constants.py` computes the constants.

use core::f64::consts::FRAC_2_PI;

use super::simd::SimdVector;

/// The largest reducible argument. Up to it, the number n of quarter turns is below 2¹⁶, and its products with the
/// first two parts of π/2 are exact.
const LARGEST: f64 = 100_000.0;

/// π/2 in three parts, with 37 bits in each of the first two. Their remaining error is below n · 2⁻¹²⁸, and no binary64
/// number up to [`LARGEST`] is closer to a multiple n of π/2 than n · 2⁻⁶⁶.
const HALF_PI: [f64; 3] = [
    1.570_796_326_792_333_3,
    2.563_344_151_583_955_8e-12,
    1.056_299_906_698_742_8e-23,
];

/// (sin r − r) / r³ in powers of r², to 2⁻⁶³ of sin r. An error that recurs whenever an angle returns makes an
/// integrator's energy drift: an error of 2⁻⁵⁷, far below rounding, showed in the double pendulum after 10⁴ periods.
const SINE: [f64; 7] = [
    -0.166_666_666_666_666_66,
    0.008_333_333_333_333_04,
    -0.000_198_412_698_409_592_85,
    2.755_731_907_188_010_8e-6,
    -2.505_207_028_341_333_7e-8,
    1.605_422_047_840_445_1e-10,
    -7.384_541_077_016_098e-13,
];

/// (cos r − 1 + r²/2) / r⁴ in powers of r², to 2⁻⁶⁹ of cos r.
const COSINE: [f64; 7] = [
    0.041_666_666_666_666_664,
    -0.001_388_888_888_888_838_9,
    2.480_158_730_118_081_4e-5,
    -2.755_731_906_067_963_5e-7,
    2.087_672_200_861_213_3e-9,
    -1.146_686_187_121_188_2e-11,
    4.592_695_243_340_66e-14,
];

/// 2⁵²: added to a smaller number it leaves no bits for a fraction, so that the sum is rounded to an integer in its
/// last bits.
const ROUND_TO_INTEGER: f64 = 4_503_599_627_370_496.0;

/// The sign bit alone.
const NEGATIVE_ZERO: f64 = -0.0;

/// Returns sine and cosine of an angle.
#[inline]
pub(crate) fn sine_and_cosine(x: f64) -> (f64, f64) {
    if is_reducible(x) {
        branch_free::<1, f64>(x)
    } else {
        library(x)
    }
}

/// Returns the sines and the cosines of several angles, with the results of [`sine_and_cosine`].
#[inline]
pub(crate) fn sines_and_cosines<const K: usize>(x: [f64; K]) -> ([f64; K], [f64; K]) {
    let (mut sines, mut cosines) = ([0.0; K], [0.0; K]);
    if x.iter().all(|x| is_reducible(*x)) {
        vectorized(&x, &mut sines, &mut cosines);
    } else {
        for i in 0..K {
            (sines[i], cosines[i]) = one_angle(x[i]);
        }
    }
    (sines, cosines)
}

/// Computes the angles in SIMD vectors, with the standard library.
#[cfg(feature = "std")]
#[inline]
fn vectorized<const K: usize>(x: &[f64; K], sines: &mut [f64; K], cosines: &mut [f64; K]) {
    let mut done = 0;
    while cfg!(target_feature = "avx512f") && K > done + 4 {
        block::<8, wide::f64x8, K>(done, x, sines, cosines);
        done += 8;
    }
    while K > done + 2 {
        block::<4, wide::f64x4, K>(done, x, sines, cosines);
        done += 4;
    }
    if K > done {
        block::<2, wide::f64x2, K>(done, x, sines, cosines);
    }
}

#[cfg(not(feature = "std"))]
#[inline]
fn vectorized<const K: usize>(x: &[f64; K], sines: &mut [f64; K], cosines: &mut [f64; K]) {
    for i in 0..K {
        block::<1, f64, K>(i, x, sines, cosines);
    }
}

/// Computes the angles from `start` on, up to the width of a vector.
#[inline]
fn block<const WIDTH: usize, V: SimdVector<WIDTH>, const K: usize>(
    start: usize,
    x: &[f64; K],
    sines: &mut [f64; K],
    cosines: &mut [f64; K],
) {
    let angle = |lane: usize| {
        if start + lane < K {
            x[start + lane]
        } else {
            0.0
        }
    };
    let (sine, cosine) = branch_free(V::from_fn(angle));
    let (sine, cosine) = (sine.to_array(), cosine.to_array());
    for lane in 0..WIDTH {
        if start + lane < K {
            (sines[start + lane], cosines[start + lane]) = (sine[lane], cosine[lane]);
        }
    }
}

#[inline]
fn is_reducible(x: f64) -> bool {
    x.abs() <= LARGEST
}

/// Computes sine and cosine without a branch, for angles up to [`LARGEST`].
#[inline]
fn branch_free<const WIDTH: usize, V: SimdVector<WIDTH>>(x: V) -> (V, V) {
    let negative = V::splat(NEGATIVE_ZERO).to_bits();
    // The sine is computed from the magnitude, so that −0 keeps its sign.
    let sign = x.to_bits() & negative;
    let Reduced { r, tail, quadrant } = reduced(V::from_bits(x.to_bits() ^ sign));
    let (sine, cosine) = (sine(r, tail).to_bits(), cosine(r, tail).to_bits());
    // In odd quadrants the sine is the cosine of r. The sine is negative in quadrants 2 and 3, the cosine in 1 and 2.
    let exchange = (sine ^ cosine) & V::repeat_lowest(quadrant);
    let sine_sign = quadrant << 62;
    let cosine_sign = sine_sign ^ (quadrant << 63);
    (
        V::from_bits(sine ^ exchange ^ ((sine_sign & negative) ^ sign)),
        V::from_bits(cosine ^ exchange ^ (cosine_sign & negative)),
    )
}

/// A reduced argument r + tail, and the number of quarter turns that were subtracted.
struct Reduced<V, B> {
    r: V,
    /// Less than 2⁻¹⁰ of r, and less than 2⁻⁵³.
    tail: V,
    /// The quadrant, in the last two bits.
    quadrant: B,
}

/// Reduces an angle 0 ≤ x up to [`LARGEST`].
#[inline]
fn reduced<const WIDTH: usize, V: SimdVector<WIDTH>>(x: V) -> Reduced<V, V::Bits> {
    let rounded = x.mul_add(V::splat(FRAC_2_PI), V::splat(ROUND_TO_INTEGER));
    let minus_n = V::splat(ROUND_TO_INTEGER) - rounded;
    let [first, second, third] = HALF_PI;
    // The first sum is exact, and so is the product in the second sum, whose rounding error is recovered.
    let most = minus_n.mul_add(V::splat(first), x);
    let r = minus_n.mul_add(V::splat(second), most);
    let lost = minus_n.mul_add(V::splat(second), most - r);
    Reduced {
        r,
        tail: minus_n.mul_add(V::splat(third), lost),
        quadrant: rounded.to_bits(),
    }
}

/// Returns sin (r + tail) for |r| ≤ π/4.
#[inline]
fn sine<const WIDTH: usize, V: SimdVector<WIDTH>>(r: V, tail: V) -> V {
    let z = r * r;
    let curvature = z.mul_add(V::splat(1.0 / 24.0), V::splat(-0.5));
    let slope = z.mul_add(curvature, V::splat(1.0));
    r + (r * z).mul_add(polynomial(SINE, z), tail * slope)
}

/// Returns cos (r + tail) for |r| ≤ π/4.
#[inline]
fn cosine<const WIDTH: usize, V: SimdVector<WIDTH>>(r: V, tail: V) -> V {
    let z = r * r;
    let half = V::splat(0.5) * z;
    let most = V::splat(1.0) - half;
    let lost = (V::splat(1.0) - most) - half;
    let slope = z.mul_add(V::splat(-1.0 / 6.0), V::splat(1.0));
    most + (z * z).mul_add(polynomial(COSINE, z), lost - r * tail * slope)
}

/// Evaluates a polynomial by Estrin's scheme, whose operations depend less on each other than in Horner's scheme.
#[inline]
fn polynomial<const WIDTH: usize, V: SimdVector<WIDTH>>(c: [f64; 7], z: V) -> V {
    let pair = |even: f64, odd: f64| V::splat(odd).mul_add(z, V::splat(even));
    let [low, middle, high] = [pair(c[0], c[1]), pair(c[2], c[3]), pair(c[4], c[5])];
    let square = z * z;
    let high = square.mul_add(V::splat(c[6]), high);
    (square * square).mul_add(high, square.mul_add(middle, low))
}

#[cold]
#[inline(never)]
fn library(x: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    return x.sin_cos();
    #[cfg(not(feature = "std"))]
    return libm::sincos(x);
}

/// Not inlined: an array whose address is passed to a call is not kept in registers.
#[cold]
#[inline(never)]
fn one_angle(x: f64) -> (f64, f64) {
    sine_and_cosine(x)
}
