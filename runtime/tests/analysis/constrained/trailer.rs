//! A vehicle on which holonomic and nonholonomic constraints act at once.

use lagrangian::analysis::{StateSpace, TangentSpace};
use lagrangian::prelude::*;

use super::{checked, same_matrix};

/// Two bodies with an axle each, joined by a hitch: a tractor and its trailer.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector2, theta, r: Vector2, phi),
    define(
        ahead = [cos(theta), sin(theta)],
        aside = [-sin(phi), cos(phi)],
        along = [cos(phi), sin(phi)],
    ),
    kinetic = 0.5 * m * dot(p + nose * ahead).norm_squared() + 0.5 * i * dot(theta).powi(2),
    kinetic = 0.5 * mass * dot(r).norm_squared() + 0.5 * j * dot(phi).powi(2),
    constraint(hitch = p - hook * ahead - r - bar * along),
    nonholonomic(
        axle = [-sin(theta), cos(theta)].dot(dot(p)),
        wheels = aside.dot(dot(r)),
    ),
)]
struct Trailer {
    m: f64,
    i: f64,
    nose: f64,
    hook: f64,
    mass: f64,
    j: f64,
    bar: f64,
}

/// The vehicle of [`Trailer`] without coordinates that its hitch determines.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector2, theta, phi),
    define(
        ahead = [cos(theta), sin(theta)],
        along = [cos(phi), sin(phi)],
        r = p - hook * ahead - bar * along,
    ),
    kinetic = 0.5 * m * dot(p + nose * ahead).norm_squared() + 0.5 * i * dot(theta).powi(2),
    kinetic = 0.5 * mass * dot(r).norm_squared() + 0.5 * j * dot(phi).powi(2),
    nonholonomic(
        axle = [-sin(theta), cos(theta)].dot(dot(p)),
        wheels = [-sin(phi), cos(phi)].dot(dot(r)),
    ),
)]
struct Hitched {
    m: f64,
    i: f64,
    nose: f64,
    hook: f64,
    mass: f64,
    j: f64,
    bar: f64,
}

const TRAILER: Trailer = Trailer {
    m: 2.0,
    i: 0.7,
    nose: 0.4,
    hook: 0.3,
    mass: 1.2,
    j: 0.5,
    bar: 1.1,
};

const HITCHED: Hitched = Hitched {
    m: 2.0,
    i: 0.7,
    nose: 0.4,
    hook: 0.3,
    mass: 1.2,
    j: 0.5,
    bar: 1.1,
};

impl Trailer {
    /// At a bend between both bodies, with a speed and a rate of turning of the tractor.
    fn turning(&self, [theta, bend]: [f64; 2], [speed, rate]: [f64; 2]) -> State<f64, 6> {
        let (sine, cosine) = theta.sin_cos();
        let length = self.hook + self.bar;
        let guess = State::new(
            0.0,
            [
                0.0,
                0.0,
                theta,
                -length * cosine,
                -length * sine,
                theta - bend,
            ],
            [speed * cosine, speed * sine, rate, 0.0, 0.0, 0.0],
        );
        let found = self
            .assemble(guess)
            .hold(COORDINATES)
            .hold_velocities(VELOCITIES);
        found.solve().expect("it can be hitched").state
    }
}

const COORDINATES: [usize; 4] = [0, 1, Trailer::THETA, Trailer::PHI];
const VELOCITIES: [usize; 2] = [0, Trailer::THETA];

#[test]
fn a_trailer_in_turns() {
    for (angles, rates) in [
        ([0.4, 0.2], [1.5, 0.7]),
        ([-0.9, -1.2], [-0.8, 0.3]),
        ([0.2, 0.0], [2.0, 0.0]),
    ] {
        let state = TRAILER.turning(angles, rates);
        let tangent = TangentSpace::at(&TRAILER, &state)
            .coordinates(COORDINATES)
            .velocities(VELOCITIES)
            .along_motion();
        let found = StateSpace::<f64, 6, 0, 6>::reduced_free(&tangent).expect("regular");
        let pick = |from: &SVector<f64, 6>| COORDINATES.map(|i| from[i]);
        let fewer = State::new(0.0, pick(&state.q), pick(&state.v));
        let tangent = TangentSpace::at(&HITCHED, &fewer)
            .coordinates([0, 1, 2, 3])
            .velocities([0, 2])
            .along_motion();
        let expected = StateSpace::<f64, 6, 0, 6>::reduced_free(&tangent).expect("regular");
        same_matrix(&found, &expected);
        checked::<_, 6, 4, 6>(&TRAILER, &state, [&[]; 2]);
        checked::<_, 4, 2, 6>(&HITCHED, &fewer, [&[]; 2]);
    }
}

/// With the hitch on the axle, the trailer does not turn the tractor. Straight on at v, the bend then decays at v/b, whatever the masses,
/// for that is how the wheels of the trailer roll. In reverse it grows: the trailer jackknifes.
#[test]
fn a_trailer_follows_and_jackknifes() {
    let vehicle = Trailer {
        hook: 0.0,
        ..TRAILER
    };
    for speed in [2.0, -0.7] {
        let state = vehicle.turning([0.0; 2], [speed, 0.0]);
        let tangent = TangentSpace::at(&vehicle, &state)
            .coordinates(COORDINATES)
            .velocities(VELOCITIES)
            .along_motion();
        let plant = StateSpace::<f64, 6, 0, 6>::reduced_free(&tangent).expect("regular");
        let poles = plant.poles().expect("finite");
        let expected = -speed / vehicle.bar;
        let distance = poles.iter().map(|pole| (pole - expected).norm());
        let distance = distance.fold(f64::INFINITY, f64::min);
        assert!(distance < 1e-12, "{poles:?}");
    }
}
