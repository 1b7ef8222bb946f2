//! Statistics of the columns of a table.

use std::fmt;
use std::mem;

use tdigest::TDigest;

use crate::column::Column;
use crate::histogram::Histogram;
use crate::limits::{MAX_CENTROIDS, MAX_KEPT_FAILURES};
use crate::table::{FailedMember, Table};

/// Statistics of the columns of a table: mean, variance, extremes, quantiles, and the covariances of all columns.
///
/// Values that are NaN are missing: they count for no statistic of their column. Infinite values count for extremes and
/// histograms, and make the mean and the variance infinite or NaN; quantiles are of finite values. Covariances are of the rows without
/// missing values. Sums are formed chunk by chunk and merged in the order of the chunks (Chan, Golub, `LeVeque`, "Updating
/// formulae and a pairwise algorithm for computing sample variances", 1979), so that their bits do not depend on the
/// number of threads.
#[derive(Clone, Debug)]
pub struct Summary {
    columns: Vec<ColumnSummary>,
    /// The moments of the rows without missing values.
    joint: Joint,
    /// The number of members.
    members: u64,
    failures: u64,
    first_failures: Vec<FailedMember>,
}

/// Statistics of a column.
#[derive(Clone)]
pub struct ColumnSummary {
    column: Column,
    moments: Moments,
    missing: u64,
    /// The least value and the index of its member.
    min: Option<(f64, usize)>,
    max: Option<(f64, usize)>,
    digest: TDigest,
    histogram: Option<Histogram>,
}

/// The number, the mean, and the sum of squared deviations from the mean.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    count: f64,
    /// The first value: means near it keep their digits where values are far from zero.
    origin: f64,
    /// The mean, from the origin.
    mean: f64,
    squares: f64,
}

/// The number of rows, their mean, and the sums of the products of deviations from it.
#[derive(Clone, Debug)]
struct Joint {
    count: f64,
    /// The first row.
    origin: Vec<f64>,
    /// The mean, from the origin.
    mean: Vec<f64>,
    /// The lower triangle, row by row.
    products: Vec<f64>,
}

impl Summary {
    pub(crate) fn new(columns: &[Column]) -> Self {
        let count = columns.len();
        Self {
            columns: columns.iter().cloned().map(ColumnSummary::new).collect(),
            joint: Joint {
                count: 0.0,
                origin: vec![0.0; count],
                mean: vec![0.0; count],
                products: vec![0.0; count * (count + 1) / 2],
            },
            members: 0,
            failures: 0,
            first_failures: Vec::new(),
        }
    }

    /// Adds the rows of a table.
    pub(crate) fn add(&mut self, table: &Table) {
        let columns = self.columns.iter_mut().zip(table.values());
        for (column, values) in columns {
            for (value, member) in values.iter().zip(table.members()) {
                column.add(*value, *member);
            }
            let finite = values.iter().copied().filter(|value| value.is_finite());
            let mut finite: Vec<f64> = finite.collect();
            finite.sort_unstable_by(f64::total_cmp);
            column.digest = column.digest.merge_sorted(finite);
        }
        let mut row = vec![0.0; self.columns.len()];
        for place in 0..table.members().len() {
            for (value, values) in row.iter_mut().zip(table.values()) {
                *value = values[place];
            }
            self.joint.add(&row);
        }
        self.members += table.finished() as u64;
        self.failures += table.failures().len() as u64;
        let room = MAX_KEPT_FAILURES - self.first_failures.len().min(MAX_KEPT_FAILURES);
        let failures = table.failures().iter().take(room);
        self.first_failures.extend(failures.cloned());
    }

    /// Adds the statistics of the chunks behind those of this summary.
    pub(crate) fn merge(&mut self, other: Self) {
        for (column, other) in self.columns.iter_mut().zip(&other.columns) {
            column.merge(other);
        }
        self.joint.merge(&other.joint);
        self.members += other.members;
        self.failures += other.failures;
        let room = MAX_KEPT_FAILURES - self.first_failures.len().min(MAX_KEPT_FAILURES);
        self.first_failures
            .extend(other.first_failures.into_iter().take(room));
    }

    /// Returns the statistics of a column, `None` if there is no column of this name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&ColumnSummary> {
        self.columns.get(self.place(name)?)
    }

    /// Returns the statistics of all columns.
    #[must_use]
    pub fn columns(&self) -> &[ColumnSummary] {
        &self.columns
    }

    /// Returns the covariance of two columns, with n − 1 as its divisor; `None` if there is no column of one of the
    /// names.
    #[must_use]
    pub fn covariance(&self, one: &str, other: &str) -> Option<f64> {
        let (i, j) = (self.place(one)?, self.place(other)?);
        Some(over_degrees_of_freedom(
            self.joint.products[triangle(i, j)],
            self.joint.count,
        ))
    }

    /// Returns the correlation of two columns; `None` if there is no column of one of the names.
    #[must_use]
    pub fn correlation(&self, one: &str, other: &str) -> Option<f64> {
        let (i, j) = (self.place(one)?, self.place(other)?);
        let product = |i, j| self.joint.products[triangle(i, j)];
        let correlation = product(i, j) / (product(i, i).sqrt() * product(j, j).sqrt());
        Some(correlation.clamp(-1.0, 1.0))
    }

    /// Returns the number of members, including those that failed.
    #[must_use]
    pub fn members(&self) -> u64 {
        self.members
    }

    /// Returns the number of members that failed.
    #[must_use]
    pub fn failures(&self) -> u64 {
        self.failures
    }

    /// Returns the first members that failed, at most one hundred.
    #[must_use]
    pub fn first_failures(&self) -> &[FailedMember] {
        &self.first_failures
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.columns
            .iter()
            .position(|column| column.column.name == name)
    }
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

impl ColumnSummary {
    fn new(column: Column) -> Self {
        Self {
            moments: Moments::default(),
            missing: 0,
            min: None,
            max: None,
            digest: TDigest::new_with_size(MAX_CENTROIDS),
            histogram: column.bins.map(Histogram::new),
            column,
        }
    }

    fn add(&mut self, value: f64, member: usize) {
        if value.is_nan() {
            self.missing += 1;
            return;
        }
        self.moments.add(value);
        if self.min.is_none_or(|(min, _)| value < min) {
            self.min = Some((value, member));
        }
        if self.max.is_none_or(|(max, _)| value > max) {
            self.max = Some((value, member));
        }
        if let Some(histogram) = &mut self.histogram {
            histogram.add(value);
        }
    }

    fn merge(&mut self, other: &Self) {
        self.moments.merge(&other.moments);
        self.missing += other.missing;
        if let Some(min) = other.min
            && self.min.is_none_or(|(value, _)| min.0 < value)
        {
            self.min = Some(min);
        }
        if let Some(max) = other.max
            && self.max.is_none_or(|(value, _)| max.0 > value)
        {
            self.max = Some(max);
        }
        let digest = mem::replace(&mut self.digest, TDigest::new_with_size(MAX_CENTROIDS));
        self.digest = TDigest::merge_digests(vec![digest, other.digest.clone()]);
        if let (Some(histogram), Some(other)) = (&mut self.histogram, &other.histogram) {
            histogram.merge(other);
        }
    }

    /// Returns the name of the column.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.column.name
    }

    /// Returns the unit of the column.
    #[must_use]
    pub fn unit(&self) -> &str {
        &self.column.unit
    }

    /// Returns the number of values that are not missing.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // It is a count.
    pub fn count(&self) -> u64 {
        self.moments.count as u64
    }

    /// Returns the number of missing values.
    #[must_use]
    pub fn missing(&self) -> u64 {
        self.missing
    }

    /// Returns the mean; NaN without values.
    #[must_use]
    pub fn mean(&self) -> f64 {
        match self.moments.count {
            0.0 => f64::NAN,
            _ => self.moments.origin + self.moments.mean,
        }
    }

    /// Returns the variance, with n − 1 as its divisor; NaN for fewer than two values.
    #[must_use]
    pub fn variance(&self) -> f64 {
        over_degrees_of_freedom(self.moments.squares, self.moments.count)
    }

    /// Returns the standard deviation; NaN for fewer than two values.
    #[must_use]
    pub fn standard_deviation(&self) -> f64 {
        self.variance().sqrt()
    }

    /// Returns the least value and the index of its first member; `None` without values.
    #[must_use]
    pub fn min(&self) -> Option<(f64, usize)> {
        self.min
    }

    /// Returns the greatest value and the index of its first member; `None` without values.
    #[must_use]
    pub fn max(&self) -> Option<(f64, usize)> {
        self.max
    }

    /// Returns the value below which a part `probability` of the finite values lies; `None` without values, or if
    /// `probability` is not between 0 and 1. It is estimated by a digest (Dunning, Ertl, "Computing extremely accurate
    /// quantiles using t-digests", 2019): the part that lies below typically differs from `probability` by less than 10⁻³, and
    /// near 0 and 1 by much less. There is no bound: where the chunks differ much, the difference may reach 10⁻².
    #[must_use]
    pub fn quantile(&self, probability: f64) -> Option<f64> {
        let is_probability = (0.0..=1.0).contains(&probability);
        is_probability
            .then(|| self.digest.estimate_quantile(probability))
            .flatten()
    }

    /// Returns the histogram; `None` if the column has none ([`Column::histogram`]).
    #[must_use]
    pub fn histogram(&self) -> Option<&Histogram> {
        self.histogram.as_ref()
    }
}

impl Moments {
    /// Adds a value (Welford, "Note on a method for calculating corrected sums of squares and products", 1962).
    fn add(&mut self, value: f64) {
        if self.count == 0.0 {
            self.origin = value;
        }
        self.count += 1.0;
        let value = value - self.origin;
        let deviation = value - self.mean;
        self.mean += deviation / self.count;
        self.squares += deviation * (value - self.mean);
    }

    fn merge(&mut self, other: &Self) {
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
    fn add(&mut self, row: &[f64]) {
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

    fn merge(&mut self, other: &Self) {
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

/// A table of the statistics.
impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} members", self.members)?;
        if self.failures > 0 {
            write!(
                f,
                ", {} failed, the first: {}",
                self.failures, self.first_failures[0]
            )?;
        }
        let name = |column: &ColumnSummary| match column.unit() {
            "" => column.name().to_owned(),
            unit => format!("{} [{unit}]", column.name()),
        };
        let widths = self
            .columns
            .iter()
            .map(|column| name(column).chars().count());
        let width = widths.max().unwrap_or(0);
        write!(
            f,
            "\n{:width$}  {:>8}  {:>12}  {:>12}  {:>12}  {:>12}  {:>12}",
            "", "values", "mean", "std. dev.", "min", "median", "max"
        )?;
        for column in &self.columns {
            let number = |value: Option<f64>| {
                value.map_or_else(|| "–".to_owned(), |value| format!("{value:.5e}"))
            };
            write!(
                f,
                "\n{:width$}  {:>8}  {:>12}  {:>12}  {:>12}  {:>12}  {:>12}",
                name(column),
                column.count(),
                number(Some(column.mean())),
                number(Some(column.standard_deviation())),
                number(column.min().map(|(value, _)| value)),
                number(column.quantile(0.5)),
                number(column.max().map(|(value, _)| value)),
            )?;
        }
        Ok(())
    }
}

impl fmt::Debug for ColumnSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ColumnSummary")
            .field("column", &self.column)
            .field("count", &self.count())
            .field("missing", &self.missing)
            .field("mean", &self.mean())
            .field("variance", &self.variance())
            .field("min", &self.min)
            .field("max", &self.max)
            .finish_non_exhaustive()
    }
}
