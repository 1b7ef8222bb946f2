//! The points of a study: what its members differ in.

use std::ops::Range;

use crate::column::Column;
use crate::error::Error;

/// The points of a study: for each index one, which tells in what this member differs from the others.
///
/// They are a range of indices, a `Vec` or a slice of anything, a [`Grid`](crate::Grid), or a
/// [`Sample`](crate::Sample). A point is found from its index alone, so that any member can be computed again.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not contain the points of a study",
    note = "write a range of indices, `0..1000`, a `Vec`, a `Grid` or a `Sample`; collect an iterator into a `Vec`"
)]
pub trait Points: Sync {
    /// The type of a point.
    type Point: Send;

    /// Returns the number of points.
    fn count(&self) -> usize;

    /// Returns the point of an index below [`count`](Self::count).
    fn point(&self, index: usize) -> Self::Point;

    /// Returns the columns that the points have in a table. By default there are none.
    fn columns(&self) -> Vec<Column> {
        Vec::new()
    }

    /// Returns the values of a point in these columns.
    fn values(&self, point: &Self::Point) -> Vec<f64> {
        let _ = point;
        Vec::new()
    }

    /// Returns a description, which tells one design from another: a study in a folder is only resumed with its own.
    fn description(&self) -> String {
        format!("{} points", self.count())
    }

    /// Returns an error if the points are invalid.
    ///
    /// # Errors
    ///
    /// None by default.
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

impl Points for Range<usize> {
    type Point = usize;

    fn count(&self) -> usize {
        self.len()
    }

    fn point(&self, index: usize) -> usize {
        self.start + index
    }

    fn description(&self) -> String {
        format!("the integers {}..{}", self.start, self.end)
    }
}

impl<T: Clone + Send + Sync> Points for Vec<T> {
    type Point = T;

    fn count(&self) -> usize {
        self.len()
    }

    fn point(&self, index: usize) -> T {
        self[index].clone()
    }
}

impl<T: Clone + Send + Sync> Points for &[T] {
    type Point = T;

    fn count(&self) -> usize {
        self.len()
    }

    fn point(&self, index: usize) -> T {
        self[index].clone()
    }
}

impl<T: Clone + Send + Sync, const N: usize> Points for [T; N] {
    type Point = T;

    fn count(&self) -> usize {
        N
    }

    fn point(&self, index: usize) -> T {
        self[index].clone()
    }
}

impl<P: Points> Points for &P {
    type Point = P::Point;

    fn count(&self) -> usize {
        (**self).count()
    }

    fn point(&self, index: usize) -> P::Point {
        (**self).point(index)
    }

    fn columns(&self) -> Vec<Column> {
        (**self).columns()
    }

    fn values(&self, point: &P::Point) -> Vec<f64> {
        (**self).values(point)
    }

    fn description(&self) -> String {
        (**self).description()
    }

    fn check(&self) -> Result<(), Error> {
        (**self).check()
    }
}
