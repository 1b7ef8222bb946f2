//! Errors of the search for consistent states.

use core::fmt;

use crate::error_messages::error_messages;
use crate::limits::REPORTED_CONSTRAINTS;
use crate::number_format::write_values;

/// The error for constraints that cannot be met.
#[derive(Clone, Copy, PartialEq)]
pub enum AssemblyError {
    /// A coordinate or velocity of the guess is not finite.
    NotFinite {
        /// The name of the coordinate.
        coordinate: &'static str,
    },
    /// No coordinates near the guess meet these constraints.
    Positions(OpenConstraints),
    /// No velocities meet these constraints.
    Velocities(OpenConstraints),
}

/// Constraints that stay open, and their residuals.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OpenConstraints {
    names: &'static [&'static str],
    /// In 32 bits, so that errors stay short.
    indices: [u32; REPORTED_CONSTRAINTS],
    residuals: [f64; REPORTED_CONSTRAINTS],
    count: u32,
}

impl OpenConstraints {
    pub(super) const fn new(names: &'static [&'static str]) -> Self {
        Self {
            names,
            indices: [0; REPORTED_CONSTRAINTS],
            residuals: [0.0; REPORTED_CONSTRAINTS],
            count: 0,
        }
    }

    pub(super) fn add(&mut self, constraint: usize, residual: f64) {
        let count = self.count();
        if let (Some(index), Some(slot)) =
            (self.indices.get_mut(count), self.residuals.get_mut(count))
        {
            *index = u32::try_from(constraint).unwrap_or(u32::MAX);
            *slot = residual;
        }
        self.count += 1;
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The names of the first six of the constraints, and the residuals that the search has left.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, f64)> + '_ {
        let open = self.indices.iter().zip(&self.residuals);
        open.take(self.count()).map(|(index, residual)| {
            let name = usize::try_from(*index).ok();
            let name = name.and_then(|index| self.names.get(index));
            (name.copied().unwrap_or("?"), *residual)
        })
    }

    /// How many constraints are open.
    #[must_use]
    pub fn count(&self) -> usize {
        usize::try_from(self.count).unwrap_or(usize::MAX)
    }
}

impl fmt::Display for OpenConstraints {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let left_out = self.count().saturating_sub(REPORTED_CONSTRAINTS);
        write_values(f, "by", self.iter(), left_out)
    }
}

error_messages! { AssemblyError:
    Self::NotFinite { coordinate } =>
        "the guess for {coordinate} or its velocity is not finite: begin at numbers";
    Self::Positions(open) =>
        "the mechanism is not closed, constraints stay open: {open}; begin nearer to a closed configuration, hold fewer \
         coordinates, or change a length, if there is none";
    Self::Velocities(open) =>
        "no velocities meet the constraints, which stay open: {open}; hold fewer velocities, or begin away from a \
         singular configuration";
}
