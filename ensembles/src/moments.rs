//! Moments of numbers, which are summed value by value and merged: B. P. Welford, "Note on a method for calculating corrected
//! sums of squares and products", Technometrics 4 (1962); T. F. Chan, G. H. Golub, R. J. `LeVeque`, "Updating formulae and a
//! pairwise algorithm for computing sample variances", 1979.

/// The number, the mean, and the sum of squared deviations from the mean.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Moments {
    count: f64,
    /// The first value: means near it keep their digits where values are far from zero.
    origin: f64,
    /// The mean, from the origin.
    mean: f64,
    squares: f64,
}

/// The number of rows, their mean, and the sums of the products of deviations from it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Joint {
    count: f64,
    /// The first row.
    origin: Vec<f64>,
    /// The mean, from the origin.
    mean: Vec<f64>,
    /// The lower triangle, row by row.
    products: Vec<f64>,
}

impl Moments {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // It is a count.
    pub(crate) fn count(&self) -> u64 {
        self.count as u64
    }

    pub(crate) fn mean(&self) -> f64 {
        if self.count == 0.0 {
            f64::NAN
        } else {
            self.origin + self.mean
        }
    }

    pub(crate) fn variance(&self) -> f64 {
        over_degrees_of_freedom(self.squares, self.count)
    }

    /// Adds a value (Welford, "Note on a method for calculating corrected sums of squares and products", 1962).
    pub(crate) fn add(&mut self, value: f64) {
        if self.count == 0.0 {
            self.origin = value;
        }
        self.count += 1.0;
        let value = value - self.origin;
        let deviation = value - self.mean;
        self.mean += deviation / self.count;
        self.squares += deviation * (value - self.mean);
    }

    pub(crate) fn merge(&mut self, other: &Self) {
        if other.count == 0.0 {
            return;
        }
        if self.count == 0.0 {
            *self = *other;
            return;
        }
        let count = self.count + other.count;
        let deviation = (other.origin - self.origin) + (other.mean - self.mean);
        self.mean += deviation * (other.count / count);
        self.squares += other.squares + deviation * deviation * (self.count * other.count / count);
        self.count = count;
    }
}

impl Joint {
    /// Creates the moments of no rows.
    pub(crate) fn new(columns: usize) -> Self {
        Self {
            count: 0.0,
            origin: vec![0.0; columns],
            mean: vec![0.0; columns],
            products: vec![0.0; columns * (columns + 1) / 2],
        }
    }

    pub(crate) fn covariance(&self, i: usize, j: usize) -> f64 {
        over_degrees_of_freedom(self.products[triangle(i, j)], self.count)
    }

    pub(crate) fn correlation(&self, i: usize, j: usize) -> f64 {
        let product = |i, j| self.products[triangle(i, j)];
        let correlation = product(i, j) / (product(i, i).sqrt() * product(j, j).sqrt());
        correlation.clamp(-1.0, 1.0)
    }

    pub(crate) fn add(&mut self, row: &[f64]) {
        if row.iter().any(|value| value.is_nan()) {
            return;
        }
        if self.count == 0.0 {
            self.origin.copy_from_slice(row);
        }
        self.count += 1.0;
        let row: Vec<f64> = difference(row, &self.origin);
        let before = difference(&row, &self.mean);
        for (mean, deviation) in self.mean.iter_mut().zip(&before) {
            *mean += deviation / self.count;
        }
        // The deviations from the mean without this row, times those from the mean with it.
        let behind = difference(&row, &self.mean);
        let mut products = self.products.iter_mut();
        for (i, one) in before.iter().enumerate() {
            for (other, product) in behind.iter().take(i + 1).zip(&mut products) {
                *product += one * other;
            }
        }
    }

    pub(crate) fn merge(&mut self, other: &Self) {
        if other.count == 0.0 {
            return;
        }
        if self.count == 0.0 {
            self.clone_from(other);
            return;
        }
        let count = self.count + other.count;
        let origins = difference(&other.origin, &self.origin);
        let means = difference(&other.mean, &self.mean);
        let deviations = origins
            .iter()
            .zip(means)
            .map(|(origin, mean)| origin + mean);
        let deviations: Vec<f64> = deviations.collect();
        let weight = self.count * other.count / count;
        let mut products = self.products.iter_mut().zip(&other.products);
        for (i, one) in deviations.iter().enumerate() {
            for ((product, other), two) in products.by_ref().take(i + 1).zip(&deviations) {
                *product += other + one * two * weight;
            }
        }
        for (mean, deviation) in self.mean.iter_mut().zip(&deviations) {
            *mean += deviation * (other.count / count);
        }
        self.count = count;
    }
}

fn difference(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter()
        .zip(other)
        .map(|(one, other)| one - other)
        .collect()
}

/// Returns a sum of products of deviations over n − 1; NaN for fewer than two values.
fn over_degrees_of_freedom(sum: f64, count: f64) -> f64 {
    if count < 2.0 {
        f64::NAN
    } else {
        sum / (count - 1.0)
    }
}

/// Returns the place of an element of a symmetric matrix in its lower triangle.
fn triangle(i: usize, j: usize) -> usize {
    let (row, column) = (i.max(j), i.min(j));
    row * (row + 1) / 2 + column
}
