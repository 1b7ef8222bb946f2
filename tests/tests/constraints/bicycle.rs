//! Whipple's bicycle as a nonlinear mechanism, against the published linear equations and eigenvalues
//! (`data/bicycle.json`), and its nonlinear motions.

use lagrangian::StateTransition;
use lagrangian::analysis::{EquilibriumSearch, StateSpace, TangentError, TangentSpace, Variable};
use lagrangian::prelude::*;
use lagrangian_models::Bicycle;
use lagrangian_tests::{Figures, bicycle, list, number, relative_error};
use nalgebra::{Complex, Matrix2};
use serde_json::Value;

/// Half a unit of the last digit that is printed.
const PRINTED: f64 = 5e-15;

/// Everything that moves in straight rolling, and what has no effect.
const LEFT_OUT: [usize; 5] = [
    Bicycle::X,
    Bicycle::Y,
    Bicycle::YAW,
    Bicycle::REAR,
    Bicycle::FRONT,
];

fn benchmark() -> Bicycle {
    Bicycle::benchmark().expect("its bodies have inertia")
}

fn matrix(value: &Value) -> Matrix2<f64> {
    Matrix2::from_fn(|i, j| number(&value[i][j]))
}

/// The linear model in lean and steer, their velocities and the angular velocity of the rear wheel, with the torques on lean and
/// steer and the drive.
fn plant(model: &Bicycle, speed: f64) -> Result<StateSpace<f64, 5, 3, 5>, TangentError> {
    let straight = model.straight(speed);
    let tangent = TangentSpace::at(model, &straight)
        .without(LEFT_OUT)
        .coordinates([Bicycle::LEAN, Bicycle::STEER])
        .velocities([Bicycle::LEAN, Bicycle::STEER, Bicycle::REAR]);
    StateSpace::reduced(&tangent)
}

/// A block of the rows of lean and steer: by their angles, or by their velocities.
fn block(plant: &StateSpace<f64, 5, 3, 5>, column: usize) -> Matrix2<f64> {
    plant.a.fixed_view::<2, 2>(2, column).into_owned()
}

/// Torques accelerate by M⁻¹.
#[test]
fn the_published_matrices() {
    let (model, data) = (benchmark(), bicycle());
    let at = |speed| plant(&model, speed).expect("it rolls steadily");
    let mut figures = Figures::new();
    let still = at(0.0);
    let torques = still.b.fixed_view::<2, 2>(2, 0).into_owned();
    let mass = torques.try_inverse().expect("a mass matrix");
    let k0 = -mass * block(&still, 0) / model.g;
    let mut record = |name: &'static str, speed: &str, found: Matrix2<f64>| {
        let expected = matrix(&data[name]);
        let error = relative_error(found.as_slice(), expected.as_slice(), 1e-300);
        figures.record(name, speed, error, 1e-12);
    };
    record("m", "0", mass);
    record("k0", "0", k0);
    for speed in [0.5, 1.0, 4.0, 10.0] {
        let (plant, label) = (at(speed), format!("{speed} m/s"));
        record(
            "m",
            &label,
            plant
                .b
                .fixed_view::<2, 2>(2, 0)
                .into_owned()
                .try_inverse()
                .expect("regular"),
        );
        record("c1", &label, -mass * block(&plant, 2) / speed);
        record(
            "k2",
            &label,
            -(mass * block(&plant, 0) + k0 * model.g) / speed.powi(2),
        );
    }
    figures.finish();
}

/// The distance of an eigenvalue to the nearest that was found, and the largest distance that its printed digits and rounding
/// explain.
fn nearest(found: &[Complex<f64>], expected: Complex<f64>) -> f64 {
    let distances = found.iter().map(|x| (x - expected).norm());
    distances.fold(f64::INFINITY, f64::min)
}

/// Four eigenvalues belong to lean and steer; that of the speed is 0.
#[test]
fn the_published_eigenvalues() {
    let (model, data) = (benchmark(), bicycle());
    let mut figures = Figures::new();
    let mut record = |kind: &'static str, speed: f64, expected: Complex<f64>| {
        let poles = plant(&model, speed).expect("it rolls steadily").poles();
        let poles = poles.expect("a finite matrix");
        assert!(poles[0].norm() < 1e-13, "{poles:?}");
        let error = (nearest(&poles[1..], expected) - PRINTED).max(0.0) / expected.norm();
        figures.record(kind, &format!("{speed} m/s"), error, 1e-12);
    };
    for row in list(&data["eigenvalues"]) {
        let speed = number(&row["speed"]);
        let weave = Complex::new(number(&row["weave"][0]), number(&row["weave"][1]));
        record("weave", speed, weave);
        record("capsize", speed, number(&row["capsize"]).into());
        record("castering", speed, number(&row["castering"]).into());
    }
    for value in list(&data["at_rest"]) {
        record("at rest", 0.0, number(value).into());
        record("at rest", 0.0, (-number(value)).into());
    }
    figures.finish();
}

/// Two eigenvalues meet where weave begins, and their mean is what is printed: each by itself is off by the root of the rounding
/// errors. Weave becomes stable where its real part vanishes, and capsize unstable where it does itself.
#[test]
fn the_published_speeds() {
    let (model, data) = (benchmark(), bicycle());
    let poles = |speed: &Value| {
        let poles = plant(&model, number(speed))
            .expect("it rolls steadily")
            .poles();
        poles.expect("a finite matrix")
    };
    let double = number(&data["double_root"]["eigenvalue"]);
    let mut positive: Vec<_> = poles(&data["double_root"]["speed"]).to_vec();
    positive.retain(|x| x.re > 1.0);
    assert_eq!(positive.len(), 2);
    let mean = 0.5 * (positive[0] + positive[1]);
    assert!((mean - double).norm() < 1e-12 * double, "{mean}");
    assert!((positive[0] - positive[1]).norm() < 1e-6);

    let weave = Complex::new(0.0, number(&data["weave_frequency"]));
    assert!(nearest(&poles(&data["weave_speed"]), weave) < 1e-12 * weave.norm());
    // Beside that of the speed.
    let at_capsize = poles(&data["capsize_speed"]);
    assert!(at_capsize[1].norm() < 1e-13 && at_capsize[2].norm() > 1.0);
}

/// The manoeuvres of the `IFToMM` benchmark: rolling straight on with a roll rate. The kinetic and the potential energy change;
/// their sum does not.
#[test]
fn nonlinear_motions_keep_their_energy() {
    let model = benchmark();
    for (speed, rate) in [(4.0, 0.05), (4.6, 0.5), (8.0, 0.05)] {
        let mut start = model.straight(speed);
        start.v[Bicycle::LEAN] = rate;
        let independent = [Bicycle::LEAN, Bicycle::STEER, Bicycle::REAR];
        let start = model.assemble(start).hold_velocities(independent).solve();
        let start = start.expect("it rolls").state;
        let motion = Problem::new(&model, start)
            .save(Every(0.1))
            .solve(5.0, Taylor::new());
        let motion = motion.expect("a regular motion");
        let energy = model.energy(&start);
        let kinetic = |x: &State<f64, 8>| model.kinetic_energy(x);
        let mut exchanged = 0.0_f64;
        for sample in motion.samples() {
            let error = (model.energy(sample) / energy - 1.0).abs();
            assert!(error < 1e-12, "{error:e} at {} of {speed} m/s", sample.t);
            exchanged = exchanged.max((kinetic(sample) - kinetic(&start)).abs());
            let (gaps, slips) = model.constraint_residuals(sample);
            assert!(gaps.amax() < 1e-12 && slips.amax() < 1e-11);
        }
        assert!(exchanged > 1e-3, "{exchanged}");
        println!(
            "{speed} m/s: {exchanged:.3} J exchanged, {:?}",
            motion.last.q
        );
    }
}

/// At 2 m/s weave is unstable. Steering holds the nonlinear bicycle upright.
#[test]
fn a_regulator_steers() {
    let model = benchmark();
    let straight = model.straight(2.0);
    let tangent = TangentSpace::at(&model, &straight)
        .without(LEFT_OUT)
        .coordinates([Bicycle::LEAN, Bicycle::STEER])
        .velocities([Bicycle::LEAN, Bicycle::STEER, Bicycle::REAR]);
    let plant = StateSpace::<f64, 5, 3, 5>::reduced(&tangent).expect("it rolls steadily");
    let q = nalgebra::SMatrix::<f64, 5, 5>::identity();
    // The rider does not lean.
    let r = nalgebra::Matrix3::from_diagonal(&[1e9, 1e-2, 1e-2].into());
    let regulator = plant.regulator(&q, &r).expect("steering reaches all modes");
    assert!(plant.poles().expect("finite").abscissa() > 2.0);
    assert!(regulator.poles.abscissa() < -0.3, "{:?}", regulator.poles);
    let mut tilted = straight;
    tilted.q[Bicycle::LEAN] = 0.05;
    let held = [Bicycle::LEAN, Bicycle::STEER];
    let tilted = model
        .assemble(tilted)
        .hold(held)
        .solve()
        .expect("it stands")
        .state;
    let motion = Problem::new(&model, tilted)
        .feedback(|state: &State<f64, 8>| regulator.input(state))
        .solve(10.0, Dop853::new());
    let end = motion.expect("it does not fall").last;
    for i in held {
        assert!(end.q[i].abs() < 1e-3 && end.v[i].abs() < 1e-3, "{end:?}");
    }
}

/// A turn to the right that a torque to the right holds: "Precise steady turning conditions" of D. L. Peterson,
/// <http://biosport.ucdavis.edu/blog/precise-steady-turning-conditions> (2011), to 16 digits by equations of his own. His pitch is that of
/// the axis of steering. The eigenvalues that are printed there are not those of the nonlinear motion, with which the linear model is
/// compared here.
#[test]
fn a_published_steady_turn() {
    let model = benchmark();
    let mut guess = model.straight(5.0);
    guess.q[Bicycle::YAW] = 0.8;
    guess.q[Bicycle::LEAN] = 0.087_266_462_599_716_47;
    guess.q[Bicycle::STEER] = 0.024_993_114_888_518_4;
    let found = EquilibriumSearch::constrained_trim(&model)
        .unknown(&[
            Variable::Coordinate(Bicycle::PITCH),
            Variable::Velocity(Bicycle::FRONT),
            Variable::Input(Bicycle::STEER_TORQUE),
        ])
        .near(&guess)
        .expect("a turn");
    let turn = found.state;
    let (mut figures, at) = (Figures::new(), "6 m/s");
    let pitch = turn.q[Bicycle::PITCH] + model.tilt;
    figures.record("pitch", at, (pitch - 0.313_989_918_050_926_1).abs(), 1e-14);
    let wheel = turn.v[Bicycle::FRONT] / -17.278_954_702_278_79;
    figures.record("rate of the front wheel", at, (wheel - 1.0).abs(), 1e-13);
    // It is the difference of moments of some N m.
    let torque = found.inputs[Bicycle::STEER_TORQUE] - 0.002_386_180_613_544_564;
    figures.record("torque in N m", at, torque.abs(), 1e-13);
    let ridden = Bicycle {
        steer_torque: found.inputs[Bicycle::STEER_TORQUE],
        ..model
    };
    let tangent = TangentSpace::at(&ridden, &turn).without(LEFT_OUT);
    // Motions nearby, as they are integrated, leave it like the exponential of the linear model.
    let basis = tangent.basis::<5>().expect("it is steady");
    let plant = StateSpace::<f64, 5, 0, 5>::reduced_free(&tangent).expect("it is steady");
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let flow = StateTransition::<8, 16>::over(&method, &ridden.dynamics(), &turn, 1.0);
    let flow = flow.expect("it does not fall");
    let expected = plant.discretized(1.0).a;
    for (j, column) in (0..5).map(|j| (j, [basis.q.column(j), basis.v.column(j)])) {
        let [q, v] = [&flow.q, &flow.v].map(|rows| {
            rows.fixed_columns::<8>(0) * column[0] + rows.fixed_columns::<8>(8) * column[1]
        });
        for (i, variable) in basis.variables.iter().enumerate() {
            let found = match *variable {
                Variable::Coordinate(i) => q[i],
                Variable::Velocity(i) => v[i],
                Variable::Input(_) => f64::NAN,
            };
            let error = (found - expected[(i, j)]).abs() / expected.amax();
            figures.record("motion nearby", at, error, 1e-9);
        }
    }
    figures.finish();
}

/// What moves has to be left out, and what acts cannot be.
#[test]
fn what_is_wrong_is_named() {
    let model = benchmark();
    let straight = model.straight(5.0);
    let tangent = || TangentSpace::at(&model, &straight);
    let all = tangent().basis::<10>();
    assert!(
        matches!(all, Err(TangentError::Moving { name: "x", .. })),
        "{all:?}"
    );
    let steered = LEFT_OUT.into_iter().chain([Bicycle::STEER]);
    let acting = tangent().without(steered).basis::<4>();
    assert!(
        matches!(
            acting,
            Err(TangentError::Acts {
                coordinate: "steer",
                ..
            })
        ),
        "{acting:?}"
    );
    let falling = tangent().along_motion().basis::<10>();
    assert!(falling.is_ok(), "{falling:?}");
}
