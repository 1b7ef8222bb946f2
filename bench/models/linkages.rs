//! Four-bar linkages of equal lengths through their singular configurations: the benchmark A02, "N-four-bar", of the `IFToMM` library
//! of computational benchmark problems. As long as all cranks are parallel, the linkages move as one pendulum.
//!
//! The tests declare one and two of them (`tests/tests/constraints/singular.rs`).

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
                coupler[i] = (x[i + 1] - x[i]).powi(2) + (y[i + 1] - y[i]).powi(2) - l.powi(2)
                    for i in 0..$couplers,
            ),
            taylor,
        )]
        struct $name {
            m: f64,
            g: f64,
            l: f64,
        }

        impl $name {
            /// Prints the greatest error of the first crank's end over ten seconds, by lengths of the first step, at a tolerance.
            fn measure(tolerance: f64, first_steps: u32) -> Result<(), IntegrationError> {
                let linkages = Self { m: 1.0, g: 9.81, l: 1.0 };
                let mut start = State::new(0.0, [0.0; 2 * $cranks], [0.0; 2 * $cranks]);
                for i in 0..$cranks {
                    start.q[i] = i as f64;
                    start.q[$cranks + i] = 1.0;
                    start.v[i] = 1.0;
                }
                let together = Together {
                    inertia: ($cranks as f64) / 3.0 + $couplers as f64,
                    weight: 9.81 * (1.5 * $couplers as f64 + 0.5),
                };
                let upright = State::new(0.0, [0.0], [1.0]);
                let expected = Problem::new(&together, upright).solve(END, Taylor::new())?.q[0].sin();
                let taylor = Taylor::new().relative_tolerance(tolerance).pass_singular_configurations();
                let (mut worst, mut steps): (f64, _) = (0.0, 0);
                for i in 0..first_steps {
                    let mut motion = Problem::new(&linkages, start).start(taylor)?;
                    motion.advance(0.01 + 0.003 * f64::from(i))?;
                    let end = motion.advance(END)?;
                    worst = worst.max((end.q[0] - expected).abs());
                    steps = steps.max(end.statistics.steps);
                }
                println!("{} {tolerance:e} {worst:e} {steps}", $couplers);
                Ok(())
            }
        }
    };
}

four_bars!(OneFourBar, 2, 1);
four_bars!(TwoFourBars, 3, 2);
four_bars!(FortyFourBars, 41, 40);

/// The linkages as one pendulum, by the angle from the upright.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * inertia * dot(theta).powi(2),
    potential = weight * cos(theta),
    taylor,
)]
struct Together {
    inertia: f64,
    weight: f64,
}

const END: f64 = 10.0;

fn main() -> Result<(), IntegrationError> {
    let first_steps = std::env::args().nth(1).and_then(|count| count.parse().ok());
    let first_steps = first_steps.unwrap_or(20);
    for tolerance in [1e-11, 1e-12, 1e-13, 1e-14] {
        OneFourBar::measure(tolerance, first_steps)?;
        TwoFourBars::measure(tolerance, first_steps)?;
        FortyFourBars::measure(tolerance, first_steps)?;
    }
    Ok(())
}
