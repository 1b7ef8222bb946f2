//! Errors of the search for consistent states.

use core::fmt;

use crate::error_debug::debug_by_message;
use crate::limits::REPORTED_CONSTRAINTS;
use crate::number_format::Readable;

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
    open: [(usize, f64); REPORTED_CONSTRAINTS],
    count: usize,
}

impl OpenConstraints {
    pub(super) const fn new(names: &'static [&'static str]) -> Self {
        Self {
            names,
            open: [(0, 0.0); REPORTED_CONSTRAINTS],
            count: 0,
        }
    }

    pub(super) fn add(&mut self, constraint: usize, residual: f64) {
        if let Some(slot) = self.open.get_mut(self.count) {
            *slot = (constraint, residual);
        }
        self.count += 1;
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The names of the first six of the constraints, and the residuals that the search has left.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, f64)> + '_ {
        let open = self.open.iter().take(self.count);
        open.map(|(constraint, residual)| {
            (
                self.names.get(*constraint).copied().unwrap_or("?"),
                *residual,
            )
        })
    }

    /// How many constraints are open.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }
}

impl fmt::Display for OpenConstraints {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (name, residual)) in self.iter().enumerate() {
            let separator = if i == 0 { "" } else { ", " };
            write!(f, "{separator}{name} by {}", Readable(residual))?;
        }
        let left_out = self.count.saturating_sub(REPORTED_CONSTRAINTS);
        if left_out > 0 {
            write!(f, " and {left_out} more")?;
        }
        Ok(())
    }
}

impl fmt::Display for AssemblyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { coordinate } => write!(
                f,
                "the guess for {coordinate} or its velocity is not finite: begin at numbers"
            ),
            Self::Positions(open) => write!(
                f,
                "the mechanism is not closed, constraints stay open: {open}; begin nearer to a closed configuration, hold fewer \
                 coordinates, or change a length, if there is none"
            ),
            Self::Velocities(open) => write!(
                f,
                "no velocities meet the constraints, which stay open: {open}; hold fewer velocities, or begin away from a \
                 singular configuration"
            ),
        }
    }
}

debug_by_message!(AssemblyError);

impl core::error::Error for AssemblyError {}
