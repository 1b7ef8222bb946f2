//! The eigenvalues of a first-order linear system.

use nalgebra::Complex;

/// Up to 2 `N` eigenvalues of a first-order linear system; dereferences to a slice of them.
///
/// They are ordered by ascending magnitude; of a conjugate pair, the eigenvalue above the real axis comes first.
#[derive(Clone, Copy, PartialEq)]
pub struct Spectrum<const N: usize> {
    values: [[Complex<f64>; N]; 2],
    count: usize,
}

impl<const N: usize> Spectrum<N> {
    pub(super) fn new(values: [[Complex<f64>; N]; 2], count: usize) -> Self {
        let mut spectrum = Self { values, count };
        sort(&mut spectrum.values.as_flattened_mut()[..count]);
        spectrum
    }

    /// Returns the largest magnitude; 0 if there are no eigenvalues.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.iter().fold(0.0, |most, x| modulus(*x).max(most))
    }

    /// Returns the largest real part, the rate at which perturbations grow; −∞ if there are no eigenvalues.
    #[must_use]
    pub fn abscissa(&self) -> f64 {
        self.iter()
            .fold(f64::NEG_INFINITY, |most, x| x.re.max(most))
    }
}

/// Formats the slice of eigenvalues.
impl<const N: usize> core::fmt::Debug for Spectrum<N> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

impl<const N: usize> core::ops::Deref for Spectrum<N> {
    type Target = [Complex<f64>];

    fn deref(&self) -> &[Complex<f64>] {
        &self.values.as_flattened()[..self.count]
    }
}

/// Returns the magnitude of a complex number.
pub(super) fn modulus(x: Complex<f64>) -> f64 {
    libm::hypot(x.re, x.im)
}

/// Sorts by ascending magnitude; at equal magnitudes by real parts, then by descending imaginary parts.
pub(super) fn sort(values: &mut [Complex<f64>]) {
    values.sort_unstable_by(|x, y| {
        let magnitudes = modulus(*x).total_cmp(&modulus(*y));
        let reals = magnitudes.then(x.re.total_cmp(&y.re));
        reals.then(y.im.total_cmp(&x.im))
    });
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::Spectrum;

    #[test]
    fn eigenvalues_alone_are_shown() {
        let [zero, one] = [0.0, 1.0].map(|re| Complex { re, im: 0.0 });
        let spectrum = Spectrum::new([[one, zero], [zero, zero]], 1);
        assert_eq!(format!("{spectrum:?}"), format!("{:?}", [one]));
    }
}
