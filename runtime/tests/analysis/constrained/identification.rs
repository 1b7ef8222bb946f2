//! Parameters of mechanisms from measured motions: the reactions of constraints do no work along tangents.

use lagrangian::analysis::TangentSpace;
use lagrangian::identification::{Identification, IdentificationError};
use lagrangian::prelude::*;

/// A four-bar linkage, whose inertia, moment of mass, load and friction are unknown, and a motor at its crank.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    coordinates(crank, coupler, rocker),
    define(
        pin = [cos(crank), sin(crank)],
        arm = [2.5 * cos(coupler), 2.5 * sin(coupler)],
        end = [3.0 + 2.0 * cos(rocker), 2.0 * sin(rocker)],
    ),
    kinetic = 0.5 * (inertia * dot(crank).powi(2) + 0.6 * dot(rocker).powi(2)),
    kinetic = 0.5 * load * dot(end).norm_squared() + 0.05 * dot(coupler).powi(2),
    potential = load * g * end.y + moment * g * sin(crank),
    dissipation = 0.5 * friction * dot(rocker).powi(2),
    force(crank = torque),
    constraint(joint = pin + arm - end),
    regressor(inertia, moment, load, friction),
)]
struct Linkage {
    inertia: f64,
    moment: f64,
    load: f64,
    friction: f64,
    g: f64,
    #[lagrangian(input)]
    torque: f64,
}

const REAL: Linkage = Linkage {
    inertia: 0.35,
    moment: 0.8,
    load: 1.3,
    friction: 0.4,
    g: 9.81,
    torque: 0.0,
};

/// What is known of the linkage.
const KNOWN: Linkage = Linkage {
    inertia: 0.0,
    moment: 0.0,
    load: 0.0,
    friction: 0.0,
    ..REAL
};

/// Numbers with mean 0 and variance 1: sums of twelve equally distributed ones.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let sum = (0..12).fold(0.0, |sum, _| {
            // The generator MMIX of D. E. Knuth, The Art of Computer Programming 2, 3.3.4.
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            sum + f64::from(u32::try_from(self.0 >> 32).unwrap_or_default()) / 4_294_967_296.0
        });
        sum - 6.0
    }
}

/// Adds a turn of the crank under a motor, with torques that are measured with errors of this standard deviation.
fn measured(identification: &mut Identification<4>, deviation: f64) {
    let mut noise = Noise(7);
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [3.0, 0.0, 0.0]);
    let held = [Linkage::CRANK];
    let start = REAL
        .assemble(guess)
        .hold(held)
        .hold_velocities(held)
        .solve();
    let torque = |t: f64| 4.0 * (1.7 * t).sin() + 3.0 * (4.1 * t).cos();
    let motion = Problem::new(&REAL, start.expect("it closes").state)
        .feedback(|x: &State<f64, 3>| torque(x.t))
        .save(Every(0.02))
        .solve(8.0, Dop853::new())
        .expect("a regular motion");
    for state in motion.samples() {
        let accelerations = REAL.with_inputs(torque(state.t)).accelerations(state);
        let basis = TangentSpace::at(&REAL, state)
            .along_motion()
            .basis::<2>()
            .expect("regular");
        let reading = torque(state.t) + deviation * noise.next();
        let known = KNOWN.with_inputs(reading);
        identification.add_along(
            &known,
            (state, &accelerations),
            &Vector3::zeros(),
            &basis.virtual_displacements(),
        );
    }
}

#[test]
fn a_linkage_is_identified() {
    let mut identification = Identification::new(Linkage::BASE_PARAMETERS);
    measured(&mut identification, 0.0);
    let exact = identification.solve().expect("a rich motion");
    assert!(
        (exact.parameters - REAL.base_parameters()).amax() < 1e-11,
        "{exact:?}"
    );

    let mut identification = Identification::new(Linkage::BASE_PARAMETERS);
    measured(&mut identification, 0.2);
    let found = identification.solve().expect("a rich motion");
    let deviations = found.standard_deviations();
    let errors = found.parameters - REAL.base_parameters();
    for (error, deviation) in errors.iter().zip(deviations.iter()) {
        assert!(
            error.abs() < 3.0 * deviation && *deviation < 0.05,
            "{errors} {deviations}"
        );
    }
    assert!(errors.amax() > 1e-4);
}

/// At rest, neither inertia nor friction is seen.
#[test]
fn what_is_not_excited_is_named() {
    let mut identification = Identification::new(Linkage::BASE_PARAMETERS);
    for angle in [0.2, 0.9, 1.7, 2.4, 3.0, 4.0, 5.0] {
        let guess = State::new(0.0, [angle, 0.2, 1.5], [0.0; 3]);
        let state = REAL
            .assemble(guess)
            .hold([Linkage::CRANK])
            .solve()
            .expect("it closes")
            .state;
        let basis = TangentSpace::at(&REAL, &state)
            .along_motion()
            .basis::<2>()
            .expect("regular");
        let still = Vector3::zeros();
        let known = KNOWN.with_inputs(REAL.moment * REAL.g * angle.cos());
        identification.add_along(
            &known,
            (&state, &still),
            &still,
            &basis.virtual_displacements(),
        );
    }
    let error = identification.solve().expect_err("nothing moves");
    assert!(
        matches!(error, IdentificationError::PoorExcitation { .. }),
        "{error}"
    );
}
