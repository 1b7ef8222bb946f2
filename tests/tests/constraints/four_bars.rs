//! Four-bar linkages of equal lengths, which are flat twice in a turn.
//!
//! This is the benchmark A02, "N-four-bar", of the `IFToMM` library of computational benchmark problems. As long as all cranks are
//! parallel, the linkages move as one pendulum. `bench/models/linkages.rs` moves more of them.

#![allow(dead_code, reason = "not all constants of the models are used")]

use lagrangian::prelude::*;

/// Linkages of uniform rods in Cartesian coordinates: cranks about the points (i l, 0), whose ends couplers connect.
macro_rules! four_bars {
    ($name:ident, $cranks:literal, $couplers:literal) => {
        #[derive(Clone, Lagrangian)]
        #[lagrangian(
            coordinates(x[$cranks], y[$cranks]),
            kinetic = (0..$cranks).map(|i| m / 6.0 * (dot(x[i]).powi(2) + dot(y[i]).powi(2))).sum()
                + (0..$couplers).map(|i| m / 6.0 * (dot(x[i]).powi(2) + dot(y[i]).powi(2)
                    + dot(x[i + 1]).powi(2) + dot(y[i + 1]).powi(2)
                    + dot(x[i]) * dot(x[i + 1]) + dot(y[i]) * dot(y[i + 1]))).sum(),
            potential = m * g * ((0..$cranks).map(|i| y[i] / 2.0).sum()
                + (0..$couplers).map(|i| (y[i] + y[i + 1]) / 2.0).sum()),
            constraint(
                crank[i] = (x[i] - i * l).powi(2) + y[i].powi(2) - l.powi(2) for i in 0..$cranks,
                coupler[i] = (x[i + 1] - x[i]).powi(2) + (y[i + 1] - y[i]).powi(2) - coupler.powi(2)
                    for i in 0..$couplers,
            ),
            taylor,
        )]
        pub(crate) struct $name {
            pub(crate) m: f64,
            pub(crate) g: f64,
            pub(crate) l: f64,
            pub(crate) coupler: f64,
        }

        impl $name {
            pub(crate) const NEW: Self = Self {
                m: 1.0,
                g: 9.81,
                l: 1.0,
                coupler: 1.0,
            };
        }
    };
}

/// The linkages by the angles of each rod against the one before: the couplers are a chain, from whose joints all cranks but the
/// first one hang. The third number is one less than that of the couplers.
macro_rules! chained_four_bars {
    ($name:ident, $couplers:literal, $others:literal) => {
        #[derive(Clone, Lagrangian)]
        #[lagrangian(
            coordinates(first, a[$couplers], b[$couplers]),
            define(
                r = rotation_z(first),
                k[0] = r * rotation_z(b[0]),
                k[i + 1] = k[i] * rotation_z(b[i + 1]) for i in 0..$others,
                p[0] = r * [l, 0.0, 0.0],
                p[i + 1] = p[i] + k[i] * [coupler, 0.0, 0.0] for i in 0..$couplers,
                h[i] = k[i] * rotation_z(a[i]) for i in 0..$couplers,
                foot[i] = p[i + 1] + h[i] * [l, 0.0, 0.0] for i in 0..$couplers,
                middle[i] = p[i] + k[i] * [coupler / 2.0, 0.0, 0.0] for i in 0..$couplers,
                half[i] = p[i + 1] + h[i] * [l / 2.0, 0.0, 0.0] for i in 0..$couplers,
            ),
            kinetic = m * l.powi(2) / 6.0 * dot(first).powi(2) + (0..$couplers).map(|i| 0.5 * m * (
                dot(middle[i]).norm_squared() + coupler.powi(2) / 12.0 * angular_velocity(k[i]).norm_squared()
                + dot(half[i]).norm_squared() + l.powi(2) / 12.0 * angular_velocity(h[i]).norm_squared()
            )).sum(),
            potential = m * g * ((p[0] / 2.0).y + (0..$couplers).map(|i| middle[i].y + half[i].y).sum()),
            constraint(
                x[i] = foot[i].x - (i + 1) * coupler for i in 0..$couplers,
                y[i] = foot[i].y for i in 0..$couplers,
            ),
            taylor,
        )]
        pub(crate) struct $name {
            pub(crate) m: f64,
            pub(crate) g: f64,
            pub(crate) l: f64,
            pub(crate) coupler: f64,
        }

        impl $name {
            pub(crate) const NEW: Self = Self {
                m: 1.0,
                g: 9.81,
                l: 1.0,
                coupler: 1.0,
            };
        }
    };
}

four_bars!(OneFourBar, 2, 1);
four_bars!(TwoFourBars, 3, 2);
four_bars!(SixFourBars, 7, 6);
chained_four_bars!(FourChained, 4, 3);

/// The linkages as one pendulum, by the angle from the upright.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * inertia * dot(theta).powi(2),
    potential = weight * cos(theta),
    taylor,
)]
struct Pendulum {
    inertia: f64,
    weight: f64,
}

/// Returns the end of the first crank of some linkages after a time, which begin upright at this velocity.
pub(crate) fn expected(linkages: f64, velocity: f64, time: f64) -> f64 {
    let pendulum = Pendulum {
        inertia: (linkages + 1.0) / 3.0 + linkages,
        weight: 9.81 * (1.5 * linkages + 0.5),
    };
    let start = State::new(0.0, [0.0], [velocity]);
    let end = Problem::new(&pendulum, start).solve(time, Taylor::new());
    end.unwrap().q[0].sin()
}

/// Returns the upright state of `K` cranks at this velocity.
pub(crate) fn upright<const K: usize, const N: usize>(velocity: f64) -> State<f64, N> {
    let mut state = State::new(0.0, [0.0; N], [0.0; N]);
    for i in 0..K {
        state.q[i] = f64::from(u32::try_from(i).unwrap());
        state.q[K + i] = 1.0;
        state.v[i] = velocity;
    }
    state
}

/// Returns the state of chained linkages with all cranks at this angle from the upright, which turn at this rate.
pub(crate) fn chained<const N: usize>(angle: f64, rate: f64) -> State<f64, N> {
    let quarter = core::f64::consts::FRAC_PI_2;
    let mut state = State::new(0.0, [0.0; N], [0.0; N]);
    for i in 0..=N / 2 {
        state.q[i] = if i == 0 {
            quarter - angle
        } else {
            -quarter - angle
        };
        state.v[i] = -rate;
    }
    state.q[N / 2 + 1] = angle - quarter;
    state.v[N / 2 + 1] = rate;
    state
}
