//! How many digits the reduced symmetric top keeps where `C_φ − C_ψ cos θ` cancels, in both forms, whatever its inertias are.
//!
//! With `u = (C_φ − C_ψ cos θ)/sin θ` the effective potential is `u²/(2 I) + C_ψ²/(2 Iₛ) + m g l cos θ`. Where u is nearly 0
//! its square is smaller than the rounding errors of the terms that u² expands to, and these count where I is small. What is held:
//! u as if each of its terms had an error of some units, with which the error of u² is quadratic, too; derivatives accordingly. The
//! reference is u in double-doubles, by `C_φ − C_ψ + 2 C_ψ sin² ½θ`.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Scalar};
use lagrangian_tests::{Figures, Random};

use crate::models::{ReducedTop, TopThroughPoles};

/// A symmetric body with a rotor along its axis, and the energy of its turning about the others.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi, chi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w) + 0.5 * j * (w.z + dot(chi)).powi(2),
    potential = weight * cos(theta),
    output(turning = 0.5 * i * (dot(phi) * sin(theta)).powi(2)),
    routhian(ReducedBodyWithRotor, half_angles),
)]
#[allow(dead_code)] // Its reduced model is what is compared.
struct BodyWithRotor {
    i: f64,
    i_s: f64,
    j: f64,
    weight: f64,
}

/// Errors are at most so many units of the last place of what is rounded.
const UNITS: f64 = 4.0 * f64::EPSILON;

/// A reduced top and where it is.
#[derive(Clone, Copy, Debug)]
struct Place {
    i: f64,
    i_s: f64,
    weight: f64,
    p_phi: f64,
    p_psi: f64,
    theta: f64,
    rate: f64,
}

/// What depends on θ: u and its first two derivatives, each with the sum of the magnitudes of its terms.
struct Root {
    values: [DoubleDouble; 3],
    sizes: [f64; 3],
}

impl Root {
    /// From `(C_φ − C_ψ)/2 cot ½θ + (C_φ + C_ψ)/2 tan ½θ`, whose terms keep their sizes near the poles.
    fn of(place: &Place) -> Self {
        let number = |x: f64| DoubleDouble::from(x);
        let [a, b] = [place.p_phi, place.p_psi].map(number);
        let (s, c) = (number(0.5) * number(place.theta)).sin_cos();
        let two = number(2.0);
        // `C_φ − C_ψ cos θ` and `C_ψ − C_φ cos θ`, from the nearer pole.
        let [first, second] = if c * c > s * s {
            [(a, b), (b, a)].map(|(x, y)| x - y + two * y * s * s)
        } else {
            [(a, b), (b, a)].map(|(x, y)| x + y - two * y * c * c)
        };
        let sine = two * s * c;
        let half = number(0.5);
        let [lesser, greater] = [half * (a - b), half * (a + b)];
        let third = half * (lesser * c / (s * s * s) + greater * s / (c * c * c));
        let [s, c, lesser, greater] = [s, c, lesser, greater].map(|x| x.to_f64().abs());
        Self {
            values: [first / sine, second / (sine * sine), third],
            sizes: [
                lesser * c / s + greater * s / c,
                0.5 * (lesser / (s * s) + greater / (c * c)),
                0.5 * (lesser * c / (s * s * s) + greater * s / (c * c * c)),
            ],
        }
    }

    /// The same with the sizes of the terms `C_φ` and `C_ψ cos θ`, which the shorter form has.
    fn direct(place: &Place) -> Self {
        let (s, c) = place.theta.sin_cos();
        let [a, b] = [place.p_phi, place.p_psi].map(f64::abs);
        let mut root = Self::of(place);
        let [first, second] = [a + b * c.abs(), b + a * c.abs()];
        let third = (first + 2.0 * c.abs() / s.abs() * second) / (s * s);
        root.sizes = [first / s.abs(), second / (s * s), third];
        root
    }

    /// uⁱ uᵏ, and its error: of the first order in each, and of the second.
    fn product(&self, i: usize, k: usize) -> (DoubleDouble, f64) {
        let [x, y] = [i, k].map(|i| self.values[i].to_f64().abs());
        let [dx, dy] = [i, k].map(|i| UNITS * self.sizes[i]);
        (
            self.values[i] * self.values[k],
            x * dy + y * dx + dx * dy + UNITS * x * y,
        )
    }
}

/// What is compared: values and the tolerances of their errors.
struct Expected {
    potential: (DoubleDouble, f64),
    energy: (DoubleDouble, f64),
    minus_routhian: (DoubleDouble, f64),
    forcing: (DoubleDouble, f64),
    slope: (DoubleDouble, f64),
    velocities: [(DoubleDouble, f64); 2],
}

impl Expected {
    fn of(place: &Place, root: &Root) -> Self {
        let number = |x: f64| DoubleDouble::from(x);
        let [i, i_s, weight, p_psi, rate] =
            [place.i, place.i_s, place.weight, place.p_psi, place.rate].map(number);
        let (s, c) = number(place.theta).sin_cos();
        let half = number(0.5);
        let (square, error) = root.product(0, 0);
        let (slope, error_of_slope) = root.product(0, 1);
        let (of_first, error_of_first) = root.product(1, 1);
        let (of_second, error_of_second) = root.product(0, 2);
        let spin = half * p_psi * p_psi / i_s;
        let kinetic = half * i * rate * rate;
        let potential = half * square / i + spin + weight * c;
        let rounded = UNITS * (spin + kinetic).to_f64() + UNITS * place.weight.abs();
        let tolerance = 0.5 * error / place.i + rounded;
        let (u, du) = (root.values[0], UNITS * root.sizes[0]);
        let precession = u / (i * s);
        let lost = du / (place.i * place.theta.sin().abs());
        // Of θ itself, too: cos θ, from half the angle, has an error of some units of 1.
        let turned = UNITS * precession.to_f64().abs();
        let spinning = UNITS * (place.p_psi / place.i_s).abs();
        Self {
            potential: (potential, tolerance),
            energy: (potential + kinetic, tolerance),
            minus_routhian: (kinetic - potential, tolerance),
            forcing: (
                weight * s - slope / i,
                error_of_slope / place.i + UNITS * place.weight.abs() * s.to_f64().abs(),
            ),
            slope: (
                (weight * c - (of_first + of_second) / i) / i,
                ((error_of_first + error_of_second) / place.i + UNITS * place.weight.abs())
                    / place.i,
            ),
            velocities: [
                (precession, lost + turned),
                (
                    p_psi / i_s - precession * c,
                    lost * c.to_f64().abs() + turned + spinning,
                ),
            ],
        }
    }
}

const NAMES: [&str; 6] = ["V_eff", "h", "−R", "f", "q̈", "∂q̈/∂θ"];

/// Both forms have the same methods, by macro alone.
macro_rules! compare {
    ($figures:ident, $form:ident, $place:expr, $root:expr) => {{
        let (place, expected) = ($place, Expected::of($place, &$root));
        let in_half_angles = Expected::of($place, &Root::of($place));
        let Place {
            i,
            i_s,
            weight: m,
            p_phi,
            p_psi,
            ..
        } = *place;
        let (g, l) = (1.0, 1.0);
        let top = $form {
            i,
            i_s,
            m,
            g,
            l,
            p_phi,
            p_psi,
        };
        let state = State::new(0.0, [place.theta], [place.rate]);
        let at = format!("{place:?}");
        let [potential, energy, routhian, forcing, accelerations, slope] = NAMES;
        let mut record = |name, found: f64, (expected, tolerance): (DoubleDouble, f64)| {
            let error = (DoubleDouble::from(found) - expected).to_f64().abs();
            $figures.record(name, &at, error / tolerance, 1.0);
        };
        record(
            potential,
            top.effective_potential(&state),
            in_half_angles.potential,
        );
        record(energy, top.energy(&state), expected.energy);
        record(routhian, top.lagrangian(&state), expected.minus_routhian);
        record(forcing, top.forcing(&state)[0], expected.forcing);
        let (force, tolerance) = expected.forcing;
        let expected_acceleration = (force / DoubleDouble::from(i), tolerance / i);
        record(
            accelerations,
            top.accelerations(&state)[0],
            expected_acceleration,
        );
        record(
            slope,
            top.linearize(&state).position[(0, 0)],
            expected.slope,
        );
        let rates = top.ignorable_velocities(&state);
        for (name, k) in [("φ̇", 0), ("ψ̇", 1)] {
            record(name, rates[k], expected.velocities[k]);
        }
    }};
}

/// Inertias of all ratios, and constants that cancel: `C_φ` with `C_ψ cos θ`, `C_ψ` with `C_φ cos θ`, each with the other; or not.
fn place(random: &mut Random, theta: f64) -> Place {
    let power = |random: &mut Random, low, high| 10.0_f64.powf(random.between(low, high));
    let i_s = power(random, -1.0, 1.0);
    let i = i_s * power(random, -8.0, 3.0);
    let mut p_psi = random.between(-4.0, 4.0);
    let off = match random.between(0.0, 4.0) {
        x if x < 1.0 => 0.0,
        x if x < 2.0 => f64::EPSILON * random.between(-4.0, 4.0),
        _ => power(random, -16.0, 0.0),
    };
    let near = 1.0 + off;
    let p_phi = match random.between(0.0, 6.0) {
        x if x < 2.0 => p_psi * theta.cos() * near,
        x if x < 3.0 => {
            let p_phi = p_psi;
            p_psi = p_phi * theta.cos() * near;
            p_phi
        }
        x if x < 4.0 => p_psi * near,
        x if x < 5.0 => -p_psi * near,
        _ => random.between(-4.0, 4.0),
    };
    Place {
        i,
        i_s,
        weight: random.between(-3.0, 3.0),
        p_phi,
        p_psi,
        theta,
        rate: random.between(-2.0, 2.0),
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn half_angles_keep_digits_where_the_constants_cancel() {
    half_angles_keep_digits(20_000);
}

#[test]
fn half_angles_keep_digits_at_some_places_where_the_constants_cancel() {
    half_angles_keep_digits(4_000);
}

fn half_angles_keep_digits(places: u32) {
    let mut random = Random::default();
    let mut figures = Figures::new();
    for k in 0..places {
        let from_pole = 10.0_f64.powf(random.between(-12.0, 0.0));
        let theta = match k % 4 {
            0 => from_pole,
            1 => core::f64::consts::PI - from_pole,
            2 => core::f64::consts::FRAC_PI_2 + from_pole * random.between(-1.0, 1.0),
            _ => random.between(-3.0, 3.0),
        };
        let place = place(&mut random, theta);
        compare!(figures, TopThroughPoles, &place, Root::of(&place));
    }
    figures.finish();
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn the_shorter_form_keeps_digits_where_the_constants_cancel() {
    the_shorter_form_keeps_digits(20_000);
}

#[test]
fn the_shorter_form_keeps_digits_at_some_places_where_the_constants_cancel() {
    the_shorter_form_keeps_digits(4_000);
}

/// Away from the poles the shorter form does, too; its effective potential is in half angles.
fn the_shorter_form_keeps_digits(places: u32) {
    let mut random = Random::default();
    let mut figures = Figures::new();
    for _ in 0..places {
        let theta = random.between(0.1, 3.0);
        let place = place(&mut random, theta);
        compare!(figures, ReducedTop, &place, Root::direct(&place));
    }
    figures.finish();
}

/// Of three ignorable coordinates, with an output that is a square; the effective potential is
/// `u²/(2 I) + (C_ψ − C_χ)²/(2 Iₛ) + C_χ²/(2 J) + m g l cos θ`.
#[test]
fn squares_of_several_constants_keep_their_digits() {
    let mut random = Random::default();
    let mut figures = Figures::new();
    let number = |x: f64| DoubleDouble::from(x);
    for _ in 0..5_000 {
        let theta = random.between(-3.0, 3.0);
        let place = place(&mut random, theta);
        let [j, p_chi] = [random.between(0.1, 10.0), random.between(-4.0, 4.0)];
        let body = ReducedBodyWithRotor {
            i: place.i,
            i_s: place.i_s,
            j,
            weight: place.weight,
            p_phi: place.p_phi,
            p_psi: place.p_psi,
            p_chi,
        };
        let state = State::new(0.0, [theta], [place.rate]);
        let (square, error) = Root::of(&place).product(0, 0);
        let half = number(0.5);
        let turning = half * square / number(place.i);
        let lost = 0.5 * error / place.i;
        let relative = number(place.p_psi) - number(p_chi);
        let spin = half * relative * relative / number(place.i_s);
        let spin = spin + half * number(p_chi) * number(p_chi) / number(j);
        let kinetic = half * number(place.i) * number(place.rate) * number(place.rate);
        let potential = turning + spin + number(place.weight) * number(theta).cos();
        let tolerance = lost + UNITS * ((spin + kinetic).to_f64() + place.weight.abs());
        for (name, found, expected, tolerance) in [
            (
                "V_eff",
                body.effective_potential(&state),
                potential,
                tolerance,
            ),
            ("h", body.energy(&state), potential + kinetic, tolerance),
            (
                "−R",
                body.lagrangian(&state),
                kinetic - potential,
                tolerance,
            ),
            ("output", body.outputs(&state).turning, turning, lost),
        ] {
            let error = (number(found) - expected).to_f64().abs();
            figures.record(name, &format!("{place:?}"), error / tolerance, 1.0);
        }
    }
    figures.finish();
}
