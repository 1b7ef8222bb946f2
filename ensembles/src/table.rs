//! Tables of numbers of the members.

use std::fmt;

use crate::column::{Bins, Column};
use crate::error::Error;
use crate::summary::Summary;

/// The names of the columns that each table has besides.
pub(crate) const MEMBER: &str = "member";
pub(crate) const ERROR: &str = "error";

/// Numbers of the members of a study, in the order of their indices.
///
/// The first columns are the parameters of the points, if these have names. Missing values are NaN. A member that failed
/// has one row with its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    columns: Vec<Column>,
    /// The index of the member of each row.
    members: Vec<usize>,
    /// The values of each column.
    values: Vec<Vec<f64>>,
    failures: Vec<FailedMember>,
    /// The number of members that have ended.
    finished: usize,
    metadata: Vec<(String, String)>,
}

/// A member that failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FailedMember {
    /// The index of the member.
    pub index: usize,
    /// The parameters of the member, if they have names, the error, and until when the motion is known.
    pub message: String,
}

impl fmt::Display for FailedMember {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Table {
    pub(crate) fn new(columns: Vec<Column>) -> Self {
        Self {
            values: columns.iter().map(|_| Vec::new()).collect(),
            columns,
            members: Vec::new(),
            failures: Vec::new(),
            finished: 0,
            metadata: Vec::new(),
        }
    }

    pub(crate) fn with_metadata(mut self, metadata: Vec<(String, String)>) -> Self {
        self.metadata = metadata;
        self
    }

    /// Adds a row; values that it does not have are missing.
    pub(crate) fn add_row(&mut self, member: usize, row: impl IntoIterator<Item = f64>) {
        let mut row = row.into_iter();
        self.members.push(member);
        for values in &mut self.values {
            values.push(row.next().unwrap_or(f64::NAN));
        }
    }

    /// Adds the message of a member that failed.
    pub(crate) fn add_failure(&mut self, index: usize, message: String) {
        self.failures.push(FailedMember { index, message });
    }

    /// Counts members that have ended.
    pub(crate) fn count(&mut self, members: usize) {
        self.finished += members;
    }

    /// Adds the rows of members with greater indices.
    pub(crate) fn append(&mut self, other: Self) {
        self.members.extend(other.members);
        for (values, others) in self.values.iter_mut().zip(other.values) {
            values.extend(others);
        }
        self.failures.extend(other.failures);
        self.finished += other.finished;
    }

    /// Returns the columns.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Returns the values of a column, `None` if there is no column of this name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let place = self.columns.iter().position(|column| column.name == name)?;
        self.values.get(place).map(Vec::as_slice)
    }

    /// Returns the index of the member of each row.
    #[must_use]
    pub fn members(&self) -> &[usize] {
        &self.members
    }

    /// Returns the members that failed.
    #[must_use]
    pub fn failures(&self) -> &[FailedMember] {
        &self.failures
    }

    /// Returns the number of members that have ended: all, unless the study was cancelled.
    #[must_use]
    pub fn finished(&self) -> usize {
        self.finished
    }

    pub(crate) fn values(&self) -> &[Vec<f64>] {
        &self.values
    }

    #[cfg(feature = "parquet")]
    pub(crate) fn metadata(&self) -> &[(String, String)] {
        &self.metadata
    }

    /// Returns the message of the failed member of a row, if it is one.
    #[cfg(any(feature = "csv", feature = "parquet"))]
    pub(crate) fn messages(&self) -> impl Iterator<Item = Option<&str>> {
        let mut failures = self.failures.iter().peekable();
        self.members.iter().map(move |member| {
            let failure = failures.next_if(|failure| failure.index == *member);
            failure.map(|failure| failure.message.as_str())
        })
    }

    /// Returns the statistics of the columns.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let mut summary = Summary::new(&self.columns);
        summary.add(self);
        summary
    }
}

/// Returns an error if columns cannot be told apart or have histograms without bins.
pub(crate) fn check(columns: &[Column]) -> Result<(), Error> {
    for (place, Column { name, bins, .. }) in columns.iter().enumerate() {
        let is_repeated = columns[..place].iter().any(|column| column.name == *name);
        if name.is_empty() {
            return Err(Error::Columns("each column needs a name".to_owned()));
        }
        if is_repeated {
            let text = format!(
                "two columns are called `{name}`; parameters of the points are columns, too"
            );
            return Err(Error::Columns(text));
        }
        if [MEMBER, ERROR].contains(&name.as_str()) {
            let text = format!(
                "a column cannot be called `{name}`: every table already has a column of this name"
            );
            return Err(Error::Columns(text));
        }
        if let Some(Bins { low, high, count }) = bins
            && !(low < high && (high - low).is_finite() && *count > 0)
        {
            let text = format!(
                "the histogram of `{name}` needs finite bounds, the lower one first, and at least one bin"
            );
            return Err(Error::Columns(text));
        }
    }
    Ok(())
}
