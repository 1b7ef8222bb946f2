//! Statistics of the columns of a table.

use std::fmt;
use std::mem;

use tdigest::TDigest;

use crate::column::Column;
use crate::histogram::Histogram;
use crate::limits::{MAX_CENTROIDS, MAX_KEPT_FAILURES};
use crate::moments::{Joint, Moments};
use crate::table::{FailedMember, Table};

/// Statistics of the columns of a table: mean, variance, extremes, quantiles, and the covariances of all columns.
///
/// Values that are NaN are missing: they count for no statistic of their column. Infinite values count for extremes and
/// histograms, and make the mean and the variance infinite or NaN; quantiles are of finite values. Covariances are of the rows without
/// missing values. Sums are formed chunk by chunk and merged pairwise, in a binary tree of the numbers of the chunks (Chan,
/// Golub, `LeVeque`, "Updating formulae and a pairwise algorithm for computing sample variances", 1979), so that their bits
/// do not depend on the number of threads.
#[derive(Clone, Debug, PartialEq)]
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
#[derive(Clone, PartialEq)]
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

impl Summary {
    pub(crate) fn new(columns: &[Column]) -> Self {
        Self {
            columns: columns.iter().cloned().map(ColumnSummary::new).collect(),
            joint: Joint::new(columns.len()),
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

    /// Appends the statistics of later members.
    pub(crate) fn merged(mut self, other: Self) -> Self {
        for (column, other) in self.columns.iter_mut().zip(other.columns) {
            column.merge(other);
        }
        self.joint.merge(&other.joint);
        self.members += other.members;
        self.failures += other.failures;
        let room = MAX_KEPT_FAILURES - self.first_failures.len().min(MAX_KEPT_FAILURES);
        self.first_failures
            .extend(other.first_failures.into_iter().take(room));
        self
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
        Some(self.joint.covariance(i, j))
    }

    /// Returns the correlation of two columns; `None` if there is no column of one of the names.
    #[must_use]
    pub fn correlation(&self, one: &str, other: &str) -> Option<f64> {
        let (i, j) = (self.place(one)?, self.place(other)?);
        Some(self.joint.correlation(i, j))
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

    fn merge(&mut self, other: Self) {
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
        self.digest = TDigest::merge_digests(vec![digest, other.digest]);
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
    pub fn count(&self) -> u64 {
        self.moments.count()
    }

    /// Returns the number of missing values.
    #[must_use]
    pub fn missing(&self) -> u64 {
        self.missing
    }

    /// Returns the mean; NaN without values.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.moments.mean()
    }

    /// Returns the variance, with n − 1 as its divisor; NaN for fewer than two values.
    #[must_use]
    pub fn variance(&self) -> f64 {
        self.moments.variance()
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
