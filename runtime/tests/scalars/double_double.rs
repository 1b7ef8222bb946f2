//! Models and integrations in double-double arithmetic.

use lagrangian::DoubleDouble;
use lagrangian::prelude::*;

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
struct Top<T: Scalar> {
    i1: T,
    i2: T,
    i3: T,
    m: T,
    g: T,
    l: T,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = 0.5 * x.powi(2))]
struct Oscillator;

fn read(digits: &str) -> DoubleDouble {
    digits.parse().expect("a number")
}

fn top() -> (Top<DoubleDouble>, State<DoubleDouble, 3>) {
    let [i1, i2, i3, m, g, l] = ["1.2", "1.1", "0.5", "1.3", "9.81", "0.4"].map(read);
    let start = State::new(
        read("0"),
        ["0.1", "0.5", "0.7"].map(read),
        ["0.3", "-0.2", "20"].map(read),
    );
    let top = Top {
        i1,
        i2,
        i3,
        m,
        g,
        l,
    };
    (top, start)
}

#[track_caller]
fn assert_close(found: DoubleDouble, expected: &str, tolerance: f64) {
    let expected = read(expected);
    let error = ((found - expected) / expected).to_f64().abs();
    assert!(error <= tolerance, "{found} is not {expected}: {error:e}");
}

/// The expected numbers are of 50 digits: mpmath, with 150 digits, by Lagrange's equations from
/// differences of L.
#[test]
fn a_top_has_all_digits() {
    let (top, start) = top();
    let kinetic = "102.6836354820963674953119278404374071244169065765";
    assert_close(top.kinetic_energy(&start), kinetic, 1e-30);
    let potential = "4.4767241647151692994523756091786558207397804794962";
    assert_close(top.potential_energy(&start), potential, 1e-30);
    let energy = "107.16035964681153679476430344961606294515668705599";
    assert_close(top.energy(&start), energy, 1e-30);
    let accelerations = [
        "-3.9314647710396272465971347886889122460168324412263",
        "0.58822638705122369699089162102629809048185320222141",
        "3.4185382958046515883428603938439248324281592413899",
    ];
    for (found, expected) in top.accelerations(&start).iter().zip(accelerations) {
        assert_close(*found, expected, 1e-29);
    }
}

/// In `f64` the energy of the top is conserved to some 1e-16, which hides the error of the method.
#[test]
fn a_motion_is_free_of_rounding_errors_of_f64() -> Result<(), IntegrationError> {
    let (top, start) = top();
    let method = Dop853::new()
        .relative_tolerance(1e-18)
        .absolute_tolerance(1e-18);
    let end = Problem::new(&top, start).solve(0.25, method)?;
    let before = top.energy(&start);
    let drift = ((top.energy(&end) - before) / before).to_f64().abs();
    assert!(drift < 1e-19, "{drift:e}");
    Ok(())
}

/// The remaining error is that of the coefficients of the method, which are rounded to `f64`.
#[test]
fn a_motion_has_the_digits_of_the_methods_coefficients() -> Result<(), IntegrationError> {
    let start = State::new(read("0"), [read("1")], [read("0")]);
    for tolerance in [1e-16, 1e-18, 1e-20] {
        let method = Dop853::new()
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance);
        let end = Problem::new(&Oscillator, start).solve(4.0, method)?;
        let error = (end.q[0] - read("4").cos()).to_f64().abs();
        assert!((1e-17..1e-15).contains(&error), "{tolerance:e}: {error:e}");
    }
    Ok(())
}
