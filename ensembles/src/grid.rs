//! Grids of parameters.

use crate::column::Column;
use crate::error::Error;
use crate::points::Points;

/// A grid: all combinations of the values of its axes. The last axis changes fastest.
///
/// ```
/// use lagrangian_ensembles::{Axis, Grid, Points};
///
/// let grid = Grid::new([
///     Axis::linear("length", 1.0, 2.0, 3).unit("m"),
///     Axis::logarithmic("damping", 0.01, 1.0, 3),
/// ]);
/// assert_eq!(grid.count(), 9);
/// assert_eq!(grid.point(5), [1.5, 1.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Grid<const D: usize> {
    axes: [Axis; D],
}

/// An axis of a [`Grid`].
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    column: Column,
    spacing: Spacing,
}

#[derive(Clone, Debug, PartialEq)]
enum Spacing {
    Linear(f64, f64, usize),
    Logarithmic(f64, f64, usize),
    Listed(Vec<f64>),
}

impl<const D: usize> Grid<D> {
    /// Creates the grid of these axes.
    #[must_use]
    pub fn new(axes: [Axis; D]) -> Self {
        Self { axes }
    }
}

impl Axis {
    /// Creates an axis with `count` values at equal distances from `first` to `last`, both included.
    pub fn linear(name: impl Into<String>, first: f64, last: f64, count: usize) -> Self {
        Self::of(name, Spacing::Linear(first, last, count))
    }

    /// Creates an axis with `count` values in equal ratios from `first` to `last`, both included. Both are positive.
    pub fn logarithmic(name: impl Into<String>, first: f64, last: f64, count: usize) -> Self {
        Self::of(name, Spacing::Logarithmic(first, last, count))
    }

    /// Creates an axis with these values.
    pub fn listed(name: impl Into<String>, values: impl Into<Vec<f64>>) -> Self {
        Self::of(name, Spacing::Listed(values.into()))
    }

    fn of(name: impl Into<String>, spacing: Spacing) -> Self {
        Self {
            column: Column::new(name),
            spacing,
        }
    }

    /// Sets the unit, as text.
    #[must_use]
    pub fn unit(mut self, unit: impl Into<String>) -> Self {
        self.column = self.column.unit(unit);
        self
    }

    /// Returns the number of values.
    #[must_use]
    pub fn count(&self) -> usize {
        match &self.spacing {
            Spacing::Linear(_, _, count) | Spacing::Logarithmic(_, _, count) => *count,
            Spacing::Listed(values) => values.len(),
        }
    }

    /// Returns the value of an index below [`count`](Self::count).
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // Nobody has 2⁵³ values on an axis.
    pub fn value(&self, index: usize) -> f64 {
        let part = |count: usize| index as f64 / (count.max(2) - 1) as f64;
        match &self.spacing {
            Spacing::Linear(first, last, count) => {
                let part = part(*count);
                first * (1.0 - part) + last * part
            }
            Spacing::Logarithmic(first, _, _) if index == 0 => *first,
            Spacing::Logarithmic(_, last, count) if index + 1 == *count => *last,
            // Not by the platform, whose last digits differ.
            Spacing::Logarithmic(first, last, count) => {
                first * libm::pow(last / first, part(*count))
            }
            Spacing::Listed(values) => values[index],
        }
    }

    fn check(&self) -> Result<(), Error> {
        let is_wrong = match &self.spacing {
            Spacing::Linear(first, last, _) => !(first.is_finite() && last.is_finite()),
            Spacing::Logarithmic(first, last, _) => {
                let is_positive = |value: f64| value.is_finite() && value > 0.0;
                !(is_positive(*first) && is_positive(*last))
            }
            Spacing::Listed(_) => false,
        };
        if is_wrong {
            let name = &self.column.name;
            let text = format!(
                "the ends of the axis `{name}` have to be finite, on a logarithmic axis also positive"
            );
            return Err(Error::Points(text));
        }
        Ok(())
    }
}

impl<const D: usize> Points for Grid<D> {
    type Point = [f64; D];

    fn count(&self) -> usize {
        let counts = self.axes.iter().map(Axis::count);
        counts.fold(1, usize::saturating_mul)
    }

    fn point(&self, index: usize) -> [f64; D] {
        let mut rest = index;
        let mut point = [0.0; D];
        for (value, axis) in point.iter_mut().zip(&self.axes).rev() {
            *value = axis.value(rest % axis.count());
            rest /= axis.count();
        }
        point
    }

    fn columns(&self) -> Vec<Column> {
        self.axes.iter().map(|axis| axis.column.clone()).collect()
    }

    fn values(&self, point: &[f64; D]) -> Vec<f64> {
        point.to_vec()
    }

    fn description(&self) -> String {
        let axes = self.axes.iter();
        let axes: Vec<String> = axes
            .map(|axis| format!("{} {:?}", axis.column.name, axis.spacing))
            .collect();
        format!("grid: {}", axes.join(", "))
    }

    fn check(&self) -> Result<(), Error> {
        self.axes.iter().try_for_each(Axis::check)?;
        let mut counts = self.axes.iter().map(Axis::count);
        let count = counts.try_fold(1_usize, usize::checked_mul);
        let too_many = || Error::Points("the grid has more points than can be counted".to_owned());
        count.map(|_| ()).ok_or_else(too_many)
    }
}
