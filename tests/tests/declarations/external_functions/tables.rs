//! A table that is a field, with derivatives of every order.

use lagrangian::DerivativeError;
use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

use super::{TOLERANCE, computed};

/// Values and slopes at equidistant points, with a cubic between each two.
struct Table {
    step: f64,
    values: Vec<[f64; 2]>,
}

impl Table {
    /// The table of a function and its slope from 0 on.
    fn of(step: f64, count: usize, function: impl Fn(f64) -> [f64; 2]) -> Self {
        let points = (0..count).scan(-step, |x, _| {
            *x += step;
            Some(*x)
        });
        Self {
            step,
            values: points.map(function).collect(),
        }
    }

    /// The cubic's derivative of some order at `x`.
    fn derivative(&self, order: usize, x: f64) -> f64 {
        let (mut piece, mut from) = (0, 0.0);
        while x > from + self.step && piece + 2 < self.values.len() {
            from += self.step;
            piece += 1;
        }
        let [[a, b], [c, d]] = [self.values[piece], self.values[piece + 1]];
        let (h, s) = (self.step, (x - from) / self.step);
        let (b, d) = (b * h, d * h);
        let coefficients = [a, b, 3.0 * (c - a) - 2.0 * b - d, 2.0 * (a - c) + b + d];
        match order {
            0 => coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c),
            1 => (coefficients[1] + s * (2.0 * coefficients[2] + 3.0 * s * coefficients[3])) / h,
            _ => (2.0 * coefficients[2] + 6.0 * s * coefficients[3]) / (h * h),
        }
    }
}

/// A bead on a wire whose height is a table.
#[derive(Lagrangian)]
#[lagrangian(
    scalar = f64,
    coordinates(x, y),
    function(height(x) = self.height.derivative(0, x), derivative(x) = rise(x)),
    function(rise(x) = self.height.derivative(1, x), derivative(x) = bend(x)),
    function(bend(x) = self.height.derivative(2, x), derivative(x) = 6.0 * cubic),
    define(z = height(x + y)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
)]
struct Bead {
    m: f64,
    g: f64,
    cubic: f64,
    #[lagrangian(skip)]
    height: Table,
}

/// The same on the curve of which the table is made, a cubic.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(z = cubic * (x + y).powi(3) - (x + y)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
)]
struct ElementaryBead {
    m: f64,
    g: f64,
    cubic: f64,
}

#[test]
fn a_table_is_a_field() {
    let (m, g, cubic) = (2.0, 9.81, 0.25);
    let curve = |x: f64| [cubic * x.powi(3) - x, 3.0 * cubic * x * x - 1.0];
    let bead = Bead {
        m,
        g,
        cubic,
        height: Table::of(0.5, 12, curve),
    };
    let elementary = ElementaryBead { m, g, cubic };
    let states = [
        [0.3, 0.4, 0.7, -0.2],
        [1.1, 1.9, 2.5, 1.6],
        [0.0, 0.0, 1.0, 1.0],
    ];
    let accelerations = SVector::from([0.3, -1.2]);
    for [x, y, u, v] in states {
        let state = State::new(0.0, [x, y], [u, v]);
        let found = computed(&bead, &state, &accelerations);
        let expected = computed(&elementary, &state, &accelerations);
        assert_close("bead", &found, &expected, TOLERANCE);
    }
    // A cubic bends evenly, and a table whose pieces do not is found out.
    for function in ["height", "rise", "bend"] {
        assert_eq!(bead.check_derivatives(function, [0.0..=5.5]), Ok(()));
    }
    let sine = Bead {
        height: Table::of(0.5, 12, |x| [x.sin(), x.cos()]),
        ..bead
    };
    assert_eq!(sine.check_derivatives("height", [0.0..=5.5]), Ok(()));
    assert_eq!(sine.check_derivatives("rise", [0.0..=5.5]), Ok(()));
    let bends = sine.check_derivatives("bend", [0.0..=5.5]);
    assert!(
        matches!(
            bends,
            Err(DerivativeError::Wrong {
                function: "bend",
                ..
            })
        ),
        "{bends:?}"
    );
}
