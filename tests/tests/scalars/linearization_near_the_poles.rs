//! The derivatives of the accelerations of tops near the poles of their Euler angles, against those in double-doubles.

use lagrangian::DoubleDouble;
use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;
use lagrangian_tests::{Figures, Random};

/// Through the mass matrix, whose condition grows as 1/sin² θ, there would be no digits left.
const TOLERANCE: f64 = 2e-13;

/// The symmetric top (4.7) with gravity.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = m * g * l * cos(theta),
)]
struct SymmetricTop {
    i: f64,
    i_s: f64,
    m: f64,
    g: f64,
    l: f64,
}

/// The general top (4.5) with gravity.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * l * cos(theta),
)]
struct GeneralTop {
    i1: f64,
    i2: f64,
    i3: f64,
    m: f64,
    g: f64,
    l: f64,
}

/// The largest error of a block in relation to its largest entry.
fn error(found: &SMatrix<f64, 3, 3>, exact: &SMatrix<DoubleDouble, 3, 3>) -> f64 {
    let sizes = exact.iter().map(|x| x.to_f64().abs());
    let largest = sizes.fold(0.0, f64::max);
    let pairs = found.iter().zip(exact.iter());
    let errors = pairs.map(|(found, exact)| (DoubleDouble::from(*found) - *exact).to_f64().abs());
    errors.fold(0.0, f64::max) / largest
}

/// At random angles and velocities, ever nearer to the pole, where entries grow as 1/sin² θ.
fn compare<M>(top: &M, names: [&'static str; 2], figures: &mut Figures)
where
    M: Lagrangian<3, Model: StateJacobian<3>>
        + Lagrangian<3, DoubleDouble, Model: StateJacobian<3, DoubleDouble>>,
{
    let mut random = Random::default();
    for theta in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
        for _ in 0..20 {
            let [phi, psi, precession, nutation, spin] = random.array(-1.0, 1.0);
            let (q, v) = ([phi, theta, psi], [precession, nutation, 10.0 * spin]);
            let fine = State::new(
                DoubleDouble::from(0.0),
                q.map(DoubleDouble::from),
                v.map(DoubleDouble::from),
            );
            let exact = Lagrangian::<3, DoubleDouble>::linearize(top, &fine);
            let found = Lagrangian::<3>::linearize(top, &State::new(0.0, q, v));
            let at = format!("θ = {theta:e}");
            let errors = [
                error(&found.position, &exact.position),
                error(&found.velocity, &exact.velocity),
            ];
            for (name, error) in names.into_iter().zip(errors) {
                figures.record(name, &at, error, TOLERANCE);
            }
        }
    }
}

#[test]
fn derivatives_near_the_poles() {
    let mut figures = Figures::new();
    let (m, g, l) = (1.3, 9.81, 0.4);
    let symmetric = SymmetricTop {
        i: 1.2,
        i_s: 0.5,
        m,
        g,
        l,
    };
    let top = |i1, i2, i3| GeneralTop {
        i1,
        i2,
        i3,
        m,
        g,
        l,
    };
    compare(
        &symmetric,
        ["symmetric, ∂q̈/∂q", "symmetric, ∂q̈/∂q̇"],
        &mut figures,
    );
    let equal = top(1.2, 1.2, 0.5);
    compare(&equal, ["I₁ = I₂, ∂q̈/∂q", "I₁ = I₂, ∂q̈/∂q̇"], &mut figures);
    let general = top(1.2, 0.9, 0.5);
    compare(&general, ["general, ∂q̈/∂q", "general, ∂q̈/∂q̇"], &mut figures);
    figures.finish();
}
