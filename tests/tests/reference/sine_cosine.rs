//! Sine and cosine of `f64` against values of 60 digits and more, one by one and several at once.

use std::{f64::consts::FRAC_PI_4, fs, path::Path};

use lagrangian::{DoubleDouble, Scalar};
use lagrangian_tests::Figures;

/// In units in the last place. So much is kept at these angles by the library too, where it takes over;
/// of 6381956970095103 · 2⁷⁹⁷, the number nearest to a multiple of π/2, a widespread one is 8 units off.
const TOLERANCE: f64 = 1.0;

/// An angle with its sine and cosine, each the sum of two numbers.
struct Reference {
    x: f64,
    sine: [f64; 2],
    cosine: [f64; 2],
}

fn references() -> Vec<Reference> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/sine_cosine.txt");
    let text =
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(reference).collect()
}

fn reference(line: &str) -> Reference {
    let numbers: Vec<f64> = line
        .split(' ')
        .map(|bits| u64::from_str_radix(bits, 16).expect("bits, hexadecimal"))
        .map(f64::from_bits)
        .collect();
    let [x, sine, sine_rest, cosine, cosine_rest] = numbers[..] else {
        panic!("five numbers are expected: {line}")
    };
    Reference {
        x,
        sine: [sine, sine_rest],
        cosine: [cosine, cosine_rest],
    }
}

/// The distance to high + low in units in the last place of high.
fn error(found: f64, [high, low]: [f64; 2]) -> f64 {
    let unit = high.abs().next_up() - high.abs();
    ((found - high) / unit - low / unit).abs()
}

#[test]
fn sine_and_cosine_are_within_one_unit_in_the_last_place() {
    let mut figures = Figures::new();
    for Reference { x, sine, cosine } in references() {
        let at = format!("{x:e}");
        let (found_sine, found_cosine) = Scalar::sin_cos(x);
        let reduced = x.abs() <= 1e5;
        let names = ["sine, reduced", "cosine, reduced"];
        let beyond = ["sine, beyond", "cosine, beyond"];
        let [sine_name, cosine_name] = if reduced { names } else { beyond };
        figures.record(sine_name, &at, error(found_sine, sine), TOLERANCE);
        figures.record(cosine_name, &at, error(found_cosine, cosine), TOLERANCE);
    }
    figures.finish();
}

#[test]
fn the_sine_of_a_tiny_angle_is_the_angle() {
    for x in [0.0, 5e-324, 1.5e-323, 1e-310, f64::MIN_POSITIVE, 1e-100] {
        for x in [x, -x] {
            let (sine, cosine) = Scalar::sin_cos(x);
            assert_eq!(
                (sine.to_bits(), cosine.to_bits()),
                (x.to_bits(), 1.0_f64.to_bits())
            );
        }
    }
}

#[test]
fn what_is_no_angle_has_no_sine() {
    for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let (sine, cosine) = Scalar::sin_cos(x);
        assert!(sine.is_nan() && cosine.is_nan(), "{x}: {sine}, {cosine}");
        let (sines, cosines) = f64::sines_and_cosines([0.5, x]);
        assert!(sines[1].is_nan() && cosines[1].is_nan());
        assert_eq!((sines[0], cosines[0]), Scalar::sin_cos(0.5));
    }
}

#[test]
fn one_alone_is_one_of_the_pair() {
    for Reference { x, .. } in references() {
        assert_eq!(
            (Scalar::sin(x), Scalar::cos(x)),
            Scalar::sin_cos(x),
            "{x:e}"
        );
    }
}

#[test]
fn several_at_once_are_as_one_by_one() {
    let angles: Vec<f64> = references().iter().map(|reference| reference.x).collect();
    compare::<1>(&angles);
    compare::<2>(&angles);
    compare::<3>(&angles);
    compare::<5>(&angles);
    compare::<7>(&angles);
    compare::<8>(&angles);
    compare::<15>(&angles);
    compare::<20>(&angles);
}

fn compare<const K: usize>(angles: &[f64]) {
    for several in angles.as_chunks::<K>().0 {
        let (sines, cosines) = f64::sines_and_cosines(*several);
        for (i, x) in several.iter().enumerate() {
            let (sine, cosine) = Scalar::sin_cos(*x);
            let bits = (sines[i].to_bits(), cosines[i].to_bits());
            assert_eq!(
                bits,
                (sine.to_bits(), cosine.to_bits()),
                "{x:e}, {i} of {K}"
            );
        }
    }
}

#[test]
fn no_angle_has_no_sine() {
    let (sines, cosines) = f64::sines_and_cosines([]);
    assert!(sines.is_empty() && cosines.is_empty());
}

/// Angles about each of these, at distances of up to 2⁻²¹.
const NEIGHBOURS: i32 = 1 << 16;

/// The mean error of the sine and of the cosine of angles about `center`, in units in the last place. Reference values are those
/// at the center in double-double, and from there by the addition theorems and Taylor's series.
fn mean_errors(center: f64) -> [f64; 2] {
    let (sine, cosine) = DoubleDouble::from(center).sin_cos();
    let mut sums = [0.0; 2];
    for i in -NEIGHBOURS / 2..NEIGHBOURS / 2 {
        let distance = f64::from(i) * f64::exp2(-36.0);
        let square = distance * distance;
        // 1 − cos and sin − distance of it, to 2⁻⁸⁰ and less.
        let [versine, less] = [0.5 * square, -square * distance / 6.0];
        let change = |of: DoubleDouble, other: DoubleDouble| {
            other * DoubleDouble::from(distance) + other * DoubleDouble::from(less)
                - of * DoubleDouble::from(versine)
        };
        let exact = [sine + change(sine, cosine), cosine + change(cosine, -sine)];
        let (sine, cosine) = Scalar::sin_cos(center + distance);
        for (sum, (found, exact)) in sums.iter_mut().zip([sine, cosine].into_iter().zip(exact)) {
            let unit = found.abs().next_up() - found.abs();
            *sum += (DoubleDouble::from(found) - exact).to_f64() / unit;
        }
    }
    sums.map(|sum| sum / f64::from(NEIGHBOURS))
}

/// Rounding errors have the mean 0, as of 2¹⁶ it scatters by 0.0012 units; the approximation must not show beside.
///
/// Beyond π/4 the sine is the cosine of the reduced angle, and the cosine its sine; to that the remainder of the reduction is
/// added, which is the same for all neighbours and so rounded alike where products are not fused.
#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn errors_have_no_bias() {
    average_errors(1);
}

#[test]
fn some_errors_have_no_bias() {
    average_errors(9);
}

/// Averages errors around every sixty-fourth of so many.
fn average_errors(stride: usize) {
    let mut figures = Figures::new();
    for sixty_fourths in (1..=64).step_by(stride) {
        // With few bits, so that angles are exact.
        let center = f64::from(sixty_fourths) / 64.0;
        let [sine, cosine] = mean_errors(center);
        let at = format!("{center}");
        figures.record("sine, mean", &at, sine.abs(), 0.01);
        if center < FRAC_PI_4 {
            figures.record("cosine, mean", &at, cosine.abs(), 0.01);
        }
    }
    figures.finish();
}
