//! A disc that rolls on a plane: its steady circle, and Appell's equations.

use std::f64::consts::{FRAC_PI_2, TAU};

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random};

use super::{TOLERANCE, compare};

/// A disc with its centre at c above the plane, in z-x-z angles; where θ = π/2 it stands upright.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(c: Vector2, phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        // From the point of contact to the centre.
        arm = radius * [-sin(phi) * cos(theta), cos(phi) * cos(theta), sin(theta)],
        center = [c.x, c.y, arm.z],
        contact = dot(center) - angular_velocity_inertial(r).cross(arm),
    ),
    body(disc = (r, center)),
    gravity = [0.0, 0.0, -g],
    nonholonomic(rolling = contact.rows(0, 2)),
    output(friction = reaction(rolling)),
)]
pub(crate) struct RollingDisc {
    pub(crate) disc: SymmetricBody,
    pub(crate) radius: f64,
    pub(crate) g: f64,
}

impl RollingDisc {
    /// A homogeneous thin disc.
    fn thin(mass: f64, radius: f64) -> Self {
        let moment = mass * radius * radius;
        let disc = SymmetricBody::new(mass, 0.0, 0.25 * moment, 0.5 * moment);
        let disc = disc.expect("a body");
        Self {
            disc,
            radius,
            g: 9.81,
        }
    }

    /// The state with these angles and rates whose point of contact is at rest.
    fn rolling(&self, c: [f64; 2], angles: [f64; 3], rates: [f64; 3]) -> State<f64, 5> {
        let ([phi, theta, psi], [precession, falling, spin]) = (angles, rates);
        let along = self.radius * (spin + precession * theta.cos());
        let across = self.radius * falling * theta.sin();
        let ((sine, cosine), q) = (phi.sin_cos(), [c[0], c[1], phi, theta, psi]);
        let v = [
            across * sine - along * cosine,
            -across * cosine - along * sine,
            precession,
            falling,
            spin,
        ];
        State::new(0.0, q, v)
    }

    /// The accelerations of the angles by Appell's equations for θ̇, ω = φ̇ sin θ and n = ψ̇ + φ̇ cos θ, with the moments A
    /// across and C about the axis:
    ///
    /// (A + m r²) θ̈ = A φ̇ ω cos θ − (C + m r²) n ω − m g r cos θ,
    /// A ω̇ = (C n − A φ̇ cos θ) θ̇,
    /// (C + m r²) ṅ = m r² ω θ̇.
    fn appell(&self, state: &State<f64, 5>) -> [f64; 3] {
        let [_, _, _, theta, _] = state.q.into();
        let [_, _, precession, falling, spin]: [f64; 5] = state.v.into();
        let (across, about) = (self.disc.transverse_moment(), self.disc.axial_moment());
        let square = self.disc.mass() * self.radius * self.radius;
        let (sine, cosine) = f64::sin_cos(theta);
        let (w, n) = (precession * sine, spin + precession * cosine);
        let weight = self.disc.mass() * self.g * self.radius;
        let falls = across * precession * w * cosine - (about + square) * n * w - weight * cosine;
        let turns = (about * n - across * precession * cosine) * falling / across;
        let spins = square * w * falling / (about + square);
        let precesses = (turns - precession * cosine * falling) / sine;
        [
            precesses,
            falls / (across + square),
            spins - precesses * cosine + precession * sine * falling,
        ]
    }
}

#[test]
fn accelerations_are_those_of_appell() {
    let mut random = Random::default();
    let mut figures = Figures::new();
    for _ in 0..100 {
        let [m, radius] = random.array(0.2, 2.0);
        let mut disc = RollingDisc::thin(m, radius);
        let transverse = random.between(0.1, 1.0) * m * radius * radius;
        let axial = random.between(0.1, 2.0) * transverse;
        disc.disc = SymmetricBody::new(m, 0.0, transverse, axial).expect("a body");
        let [phi, psi] = random.array(-3.0, 3.0);
        let angles = [phi, random.between(0.3, 2.8), psi];
        let state = disc.rolling(random.array(-1.0, 1.0), angles, random.array(-5.0, 5.0));
        let at = (0.0, TOLERANCE);
        let (_, slip) = disc.constraint_residuals(&state);
        compare(&mut figures, "slip", at, slip.as_slice(), &[0.0; 2]);
        let found: [f64; 5] = disc.accelerations(&state).into();
        compare(
            &mut figures,
            "angles",
            at,
            &found[2..],
            &disc.appell(&state),
        );
        // Friction alone accelerates the centre in the plane.
        let friction = m * nalgebra::Vector2::new(found[0], found[1]);
        let multipliers = disc.outputs(&state).friction;
        let (found, expected) = (multipliers.as_slice(), friction.as_slice());
        compare(&mut figures, "friction", at, found, expected);
    }
    figures.finish();
}

/// A steady circle: the rates of precession and of spin, the inclination θ, and the distance of the centre from the axis.
///
/// C. Le Saux, R. I. Leine & C. Glocker, *Dynamics of a rolling disk in the presence of dry friction*, J. Nonlinear Sci.
/// **15** (2005) 27–61: γ̇² = 4 (g/r) sin β / ((6 − 5 ρ sin β) ρ cos β) and α̇ = −ρ γ̇, where ρ is r over the radius of the
/// circle of the point of contact.
struct Circle {
    precession: f64,
    spin: f64,
    theta: f64,
    distance: f64,
}

impl Circle {
    fn of(disc: &RollingDisc, radius: f64, inclination: f64) -> Self {
        let ratio = disc.radius / radius;
        let (sine, cosine) = inclination.sin_cos();
        let square = 4.0 * disc.g / disc.radius * sine;
        let spin = (square / ((6.0 - 5.0 * ratio * sine) * ratio * cosine)).sqrt();
        Self {
            precession: -ratio * spin,
            spin,
            theta: FRAC_PI_2 - inclination,
            // The disc leans inwards.
            distance: radius - disc.radius * sine,
        }
    }

    fn start(&self, disc: &RollingDisc) -> State<f64, 5> {
        let rates = [self.precession, 0.0, self.spin];
        disc.rolling([0.0, -self.distance], [0.0, self.theta, 0.0], rates)
    }

    fn end(&self, turns: f64) -> f64 {
        turns * TAU / self.precession.abs()
    }

    fn compare(&self, disc: &RollingDisc, states: &[State<f64, 5>]) {
        let mut figures = Figures::new();
        let pull = -disc.disc.mass() * self.precession * self.precession;
        for state in states {
            let at = (state.t, TOLERANCE);
            let [phi, psi] = [self.precession, self.spin].map(|rate| rate * state.t);
            let c = [self.distance * phi.sin(), -self.distance * phi.cos()];
            let [x, y, found @ ..]: [f64; 5] = state.q.into();
            compare(&mut figures, "center", at, &[x, y], &c);
            let expected = [phi, self.theta, psi];
            compare(&mut figures, "angles", at, &found, &expected);
            let found = disc.outputs(state).friction;
            let expected = c.map(|x| pull * x);
            compare(&mut figures, "friction", at, found.as_slice(), &expected);
        }
        figures.finish();
    }
}

/// Their disc and their circle, with an inclination of 5°.
fn experiment() -> (RollingDisc, Circle) {
    let disc = RollingDisc::thin(0.3048, 0.05);
    let circle = Circle::of(&disc, 0.5, 5.0_f64.to_radians());
    (disc, circle)
}

#[test]
fn ten_turns_by_dormand_and_prince() {
    let (disc, circle) = experiment();
    let method = Dop853::new()
        .relative_tolerance(1e-14)
        .absolute_tolerance(1e-14);
    let end = circle.end(10.0);
    let problem = Problem::new(&disc, circle.start(&disc)).save(Every(end / 100.0));
    let motion = problem.solve(end, method).expect("a motion");
    circle.compare(&disc, motion.samples());
}

#[test]
fn ten_turns_by_taylor() {
    let (disc, circle) = experiment();
    let end = circle.end(10.0);
    let problem = Problem::new(&disc, circle.start(&disc)).save(Every(end / 100.0));
    let motion = problem.solve(end, Taylor::new()).expect("a motion");
    circle.compare(&disc, motion.samples());
    // The disc spins ten times as fast as it precesses. If the sine of its spin is left in the equations, there are three times as
    // many steps.
    let steps = motion.statistics.steps;
    assert!(steps < 100, "{steps} steps");
}
