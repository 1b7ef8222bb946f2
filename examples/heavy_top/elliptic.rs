//! The elliptic integrals and functions in which a top nutates.
//!
//! Legendre's complete integrals K(m) and Π(n|m) and Jacobi's am(u|m), with the parameter m = k² in
//! [0, 1). By the arithmetic-geometric mean (Abramowitz and Stegun 16.4, 17.6) and by Carlson's
//! duplication (Numerical Algorithms 10 (1995) 13–26); good to a few units in the last place.

use std::f64::consts::FRAC_PI_2;

/// The count of steps of the arithmetic-geometric mean of 1 and √(1−m).
/// Each squares the relative difference of the means: 12 are enough for every m that differs from 1.
const MEANS: usize = 12;

/// The complete integral of the first kind, K(m) = π / (2 agm(1, √(1−m))).
pub(crate) fn complete_first(m: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    for _ in 0..MEANS {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    FRAC_PI_2 / a
}

/// The incomplete integral of the first kind F, given the sine of its amplitude in [−1, 1].
pub(crate) fn incomplete_first(sine: f64, m: f64) -> f64 {
    let square = sine * sine;
    sine * carlson_f(1.0 - square, 1.0 - m * square, 1.0)
}

/// The complete integral of the third kind Π(n|m) = ∫ dα / ((1 − n sin²α) √(1 − m sin²α)), given
/// `complement` = 1 − n > 0, which may be small or large.
pub(crate) fn complete_third(complement: f64, m: f64) -> f64 {
    if complement > 2.0 {
        // For negative n its terms cancel; with N = (m − n)/(1 − n) all are positive.
        let weight = m + complement - 1.0;
        return (complement - 1.0) * (1.0 - m) / (complement * weight)
            * complete_third((1.0 - m) / complement, m)
            + m / weight * complete_first(m);
    }
    complete_first(m) + (1.0 - complement) / 3.0 * carlson_j(1.0 - m, 1.0, complement)
}

/// Jacobi's amplitude am(u|m), by descending Landen transformations; sn and cn are its sine and cosine.
pub(crate) fn amplitude(u: f64, m: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    let mut ratios = [0.0; MEANS];
    let mut scale = 1.0;
    for ratio in &mut ratios {
        let difference = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        *ratio = difference / a;
        scale *= 2.0;
    }
    let mut amplitude = scale * a * u;
    for ratio in ratios.iter().rev() {
        amplitude = 0.5 * (amplitude + (ratio * amplitude.sin()).asin());
    }
    amplitude
}

/// Carlson's `R_F`(x, y, z): arguments not negative, at most one of them 0.
fn carlson_f(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    loop {
        let mean = (x + y + z) / 3.0;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -dx - dy;
        // The first term left out is 3/44 of the fifth order in the differences.
        if dx.abs().max(dy.abs()).max(dz.abs()) < 1e-3 {
            let e2 = dx * dy - dz * dz;
            let e3 = dx * dy * dz;
            let series = 1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0;
            return series / mean.sqrt();
        }
        let shift = duplication(x, y, z);
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
    }
}

/// Carlson's `R_J`(0, y, z, p) for positive arguments.
fn carlson_j(mut y: f64, mut z: f64, mut p: f64) -> f64 {
    let (mut x, mut sum, mut scale) = (0.0_f64, 0.0, 1.0);
    loop {
        let mean = (x + y + z + 2.0 * p) / 5.0;
        let (dx, dy, dz) = (1.0 - x / mean, 1.0 - y / mean, 1.0 - z / mean);
        let dp = -0.5 * (dx + dy + dz);
        // From x = 0 this takes seven steps and more, so that what remains weighs little in the sum
        // and a series to the second order will do.
        if dx.abs().max(dy.abs()).max(dz.abs()).max(dp.abs()) < 1e-4 {
            let e2 = dx * dy + dx * dz + dy * dz - 3.0 * dp * dp;
            return sum + scale * (1.0 - 3.0 / 14.0 * e2) / (mean * mean.sqrt());
        }
        let root = p.sqrt();
        let d = (root + x.sqrt()) * (root + y.sqrt()) * (root + z.sqrt());
        let e = (p - x) * (p - y) * (p - z) / (d * d);
        sum += 6.0 * scale / d * carlson_c(e);
        let shift = duplication(x, y, z);
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
        p = 0.25 * (p + shift);
        scale *= 0.25;
    }
}

/// Carlson's `R_C`(1, 1 + e) for e > −1.
fn carlson_c(e: f64) -> f64 {
    let root = e.abs().sqrt();
    if e > 0.0 {
        root.atan() / root
    } else if e < 0.0 {
        root.atanh() / root
    } else {
        1.0
    }
}

/// The λ of the duplication theorem.
fn duplication(x: f64, y: f64, z: f64) -> f64 {
    let (x, y, z) = (x.sqrt(), y.sqrt(), z.sqrt());
    x * y + x * z + y * z
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::{amplitude, complete_first, complete_third, incomplete_first};
    use crate::close;

    // Expected values: mpmath at 30 digits.

    #[test]
    fn first_kind() {
        for (m, expected) in [
            (0.0, FRAC_PI_2),
            (0.3, 1.713_889_448_178_791),
            (0.75, 2.156_515_647_499_643_2),
            (0.999, 4.841_132_560_550_297),
        ] {
            close(complete_first(m), expected, 4e-16);
            close(incomplete_first(1.0, m), expected, 2e-15);
        }
        close(incomplete_first(0.6, 0.3), 0.656_418_097_039_575_5, 4e-16);
        close(
            incomplete_first(-0.999, 0.75),
            -2.067_154_661_955_832_5,
            2e-15,
        );
    }

    #[test]
    fn third_kind() {
        for (n, m, expected) in [
            (0.5, 0.3, 2.461_255_352_272_422_3),
            (-2.0, 0.75, 1.139_293_797_107_275_4),
            (0.2, 0.6, 2.207_471_843_841_303_5),
            (0.99, 0.1, 16.477_578_238_044_92),
            (-5000.0, 0.3, 0.022_265_230_070_180_928),
            (0.0, 0.5, 1.854_074_677_301_371_9),
            (-0.3, 0.999, 3.934_766_841_844_367),
        ] {
            close(complete_third(1.0 - n, m) / expected, 1.0, 4e-15);
        }
    }

    #[test]
    fn sine() {
        for (u, m, expected) in [
            (0.7, 0.3, 0.632_304_776_310_864_5),
            (-1.9, 0.75, -0.991_650_867_351_617),
            (12.5, 0.2, -0.691_223_147_857_439_2),
            (3.0, 0.999, 0.995_293_128_337_884_4),
            (1.0, 0.0, 0.841_470_984_807_896_5),
        ] {
            close(amplitude(u, m).sin(), expected, 1e-14);
        }
    }

    #[test]
    fn sine_inverts_the_first_kind() {
        for m in [0.0, 0.2, 0.9] {
            for sine in [-0.9, -0.1, 0.0, 0.4, 0.99] {
                close(amplitude(incomplete_first(sine, m), m).sin(), sine, 4e-15);
            }
        }
    }
}
