//! Light bodies that transmit the forces of heavy ones: accelerations meet the constraints to rounding errors.

use lagrangian::prelude::*;
use lagrangian::quantities::Constraints;

use crate::mechanisms::number;

/// Heavy bodies in a row on a line, held at their distances, each of which is pulled by a light hook.
macro_rules! trains {
    ($train:ident, $bodies:literal, $couplings:literal) => {
        #[derive(Clone, Debug, Lagrangian)]
        #[lagrangian(
            coordinates(x[$bodies], y[$bodies]),
            kinetic = (0..$bodies).map(|i| 0.5 * heavy * dot(x[i]).powi(2)).sum(),
            kinetic = (0..$bodies).map(|i| 0.5 * light * dot(y[i]).powi(2)).sum(),
            force(y[i] = pull[i] for i in 0..$bodies),
            constraint(
                hook[i] = 0.5 * ((y[i] - x[i]).powi(2) - l.powi(2)) for i in 0..$bodies,
                coupling[i] = 0.5 * ((x[i + 1] - x[i]).powi(2) - l.powi(2)) for i in 0..$couplings,
            ),
            taylor,
        )]
        struct $train {
            heavy: f64,
            light: f64,
            pull: [f64; $bodies],
            l: f64,
        }

        impl $train {
            /// Checks accelerations and multipliers of the bodies, which move as one.
            fn check<const N: usize, const C: usize>()
            where
                Self: Lagrangian<N, Model = Self> + Constraints<N, C>,
            {
                let pull = core::array::from_fn(|i| 3.0e5 + 0.7 * number(i));
                let (heavy, light, l) = (1.0e6, 1.0e-6, 0.7);
                let train = Self { heavy, light, pull, l };
                let mut q = [0.0; N];
                let mut place = 0.0;
                for i in 0..$bodies {
                    (q[i], q[$bodies + i]) = (place, place + l);
                    place += l;
                }
                let start = State::new(0.0, q, [0.3; N]);
                let bodies = f64::from($bodies);
                let expected = pull.iter().sum::<f64>() / (bodies * heavy + bodies * light);
                for x in &train.accelerations(&start) {
                    assert!((x / expected - 1.0).abs() < 1e-15, "{x} {expected}");
                }
                let multipliers = train.multipliers::<C>(&start);
                for i in 0..$bodies {
                    let hook = (light * expected - pull[i]) / l;
                    assert!((multipliers[i] / hook - 1.0).abs() < 1e-14);
                }
                for i in 0..$couplings {
                    let behind = (i + 1..$bodies).map(|k| (heavy + light) * expected - pull[k]);
                    let coupling = behind.sum::<f64>() / l;
                    let error = multipliers[$bodies + i] - coupling;
                    assert!(error.abs() < 1e-14 * multipliers.amax(), "{error:e}");
                }
            }
        }
    };
}

trains!(Two, 2, 1);
trains!(Six, 6, 5);

/// A slide that is driven along an arm that turns at a given rate, against a strong spring.
#[derive(Clone, Debug, Lagrangian)]
#[allow(deprecated, reason = "a drive that is declared by its velocity")]
#[lagrangian(
    coordinates(phi, r),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)) + 0.5 * j * dot(phi).powi(2),
    potential = 0.5 * k * r.powi(2),
    constraint(drive = phi - rate * t),
    nonholonomic(feed = dot(r) - speed * cos(t)),
    taylor,
)]
struct Slide {
    m: f64,
    j: f64,
    k: f64,
    rate: f64,
    speed: f64,
}

#[test]
fn two_light_hooks_keep_their_distances() {
    Two::check::<4, 3>();
}

/// As many bodies as are solved for numerically.
#[test]
fn six_light_hooks_keep_their_distances() {
    Six::check::<12, 11>();
}

#[test]
fn a_driven_slide_follows_its_drive_against_any_force() {
    let slide = Slide {
        m: 1e-4,
        j: 0.8,
        k: 1e7,
        rate: 0.9,
        speed: 0.4,
    };
    let (t, r): (f64, f64) = (0.6, 1.3);
    let rates = [slide.rate, slide.speed * t.cos()];
    let start = State::new(t, [slide.rate * t, r], rates);
    let accelerations = slide.accelerations(&start);
    let expected = -slide.speed * t.sin();
    assert!(accelerations[0].abs() < 1e-15, "{accelerations}");
    assert!(
        (accelerations[1] / expected - 1.0).abs() < 1e-15,
        "{accelerations}"
    );
    let [drive, feed] = slide.multipliers::<2>(&start).into();
    let torque = 2.0 * slide.m * r * rates[1] * slide.rate;
    let force = slide.m * (expected - r * slide.rate.powi(2)) + slide.k * r;
    assert!((drive - torque).abs() < 1e-14 * torque, "{drive} {torque}");
    assert!((feed - force).abs() < 1e-15 * force, "{feed} {force}");
}
