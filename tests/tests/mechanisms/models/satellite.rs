//! Satellites: reaction wheels turn one, the gradient of gravity holds another.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, assert_close, motions, relative_error};
use nalgebra::{Matrix3, SMatrix, Vector3};

/// Yaw, pitch and roll; three wheels about the axes of the body, which motors turn.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(yaw, pitch, roll, chi[3]),
    define(
        r = rotation_zyx(yaw, pitch, roll),
        w = angular_velocity(r),
        spin = (0..3).map(|i| dot(chi[i])).collect(),
    ),
    kinetic = 0.5 * w.dot(inertia * w) + 0.5 * wheel * (w + spin).norm_squared(),
    force(chi[i] = torque[i] for i in 0..3),
    output(
        rate = dot(w),
        spin_rate = dot(spin),
        momentum = r * (inertia * w + wheel * (w + spin)),
        power = torque.dot(spin),
    ),
)]
struct Satellite {
    /// With the wheels, but for their inertia about their axes.
    inertia: Matrix3<f64>,
    wheel: f64,
    #[lagrangian(input)]
    torque: Vector3<f64>,
}

fn satellite() -> Satellite {
    Satellite {
        inertia: Matrix3::new(10.0, -0.4, 0.3, -0.4, 14.0, 0.2, 0.3, 0.2, 12.0),
        wheel: 0.2,
        torque: Vector3::zeros(),
    }
}

fn angular_velocity(state: &State<f64, 6>) -> Vector3<f64> {
    let ((sp, cp), (sr, cr)) = (state.q[1].sin_cos(), state.q[2].sin_cos());
    let [yaw, pitch, roll] = [state.v[0], state.v[1], state.v[2]];
    Vector3::new(
        roll - yaw * sp,
        yaw * sr * cp + pitch * cr,
        yaw * cr * cp - pitch * sr,
    )
}

/// I ω̇ + ω × H = −τ for the body, and J (ω̇ + χ̈) = τ for the wheels, where H is the momentum of all.
#[test]
fn wheels_turn_it_as_newton_and_euler_say() {
    let model = satellite();
    let (inertia, wheel) = (model.inertia, model.wheel);
    let mut figures = Figures::new();
    let mut random = Random::default();
    for _ in 0..200 {
        let mut state: State<f64, 6> = random.state();
        state.v.fixed_rows_mut::<3>(3).scale_mut(50.0);
        let torque = Vector3::from(random.array(-1.0, 1.0));
        let w = angular_velocity(&state);
        let spin: Vector3<f64> = state.v.fixed_rows::<3>(3).into();
        let momentum = inertia * w + wheel * (w + spin);
        let inverse = inertia.try_inverse().expect("a body has an inertia");
        let rate = inverse * (-torque - w.cross(&momentum));
        let outputs = model.with_inputs(torque).outputs(&state);
        let error = relative_error(outputs.rate.as_slice(), rate.as_slice(), 1.0);
        let pole = state.q[1].cos().powi(2);
        let at = format!("{state:?}");
        figures.record("rate of ω", &at, error, 1e-14 / pole);
        let spin_rate = torque / wheel - rate;
        let error = relative_error(outputs.spin_rate.as_slice(), spin_rate.as_slice(), 1.0);
        figures.record("rates of the wheels", &at, error, 1e-14 / pole);
        figures.record(
            "power",
            &at,
            (outputs.power - torque.dot(&spin)).abs(),
            1e-12,
        );
    }
    figures.finish();
}

/// What wheels do within does not change the momentum of the whole.
#[test]
fn the_momentum_in_inertial_axes_is_kept() -> Result<(), IntegrationError> {
    let model = satellite();
    let start = State::new(
        0.0,
        [0.1, 0.2, -0.3, 0.0, 0.0, 0.0],
        [0.05, 0.08, 0.1, 30.0, -20.0, 10.0],
    );
    let law = |state: &State<f64, 6>| {
        let t = state.t;
        Vector3::new(0.3 * t.sin(), 0.2 * (2.0 * t).cos(), -0.1)
    };
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let turned = Problem::new(&model, start).feedback(law);
    let end = turned.solve(10.0, method)?.last;
    let [at_first, at_last] = [start, end].map(|state| model.outputs(&state).momentum);
    assert_close("momentum", at_last.as_slice(), at_first.as_slice(), 1e-12);
    assert!(
        (end.v - start.v).norm() > 5.0,
        "the wheels have turned at another speed"
    );
    Ok(())
}

/// One wheel about the second axis, with friction.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(psi, theta, phi, chi),
    define(w = angular_velocity_zyx(psi, theta, phi)),
    kinetic = 0.5 * w.dot(diagonal([i1, i2 - wheel, i3]) * w) + 0.5 * wheel * (w.y + dot(chi)).powi(2),
    force(chi = torque - friction * dot(chi)),
)]
pub(super) struct OneWheel {
    i1: f64,
    i2: f64,
    i3: f64,
    wheel: f64,
    friction: f64,
    #[lagrangian(input)]
    torque: f64,
}

#[test]
fn with_one_wheel_it_moves_as_the_references() {
    let mut figures = Figures::new();
    for motion in motions("satellite_reaction_wheel_321") {
        let [i1, i2, i3, wheel, friction] = motion.parameters(["i1", "i2", "i3", "jw", "bw"]);
        let model = OneWheel {
            i1,
            i2,
            i3,
            wheel,
            friction,
            torque: 0.0,
        };
        let [k0, frequency] = motion.parameters(["k0", "w"]);
        let law = |state: &State<f64, 4>| k0 * (frequency * state.t).sin();
        let start = State::new(0.0, [0.0; 4], [0.0; 4]);
        let controlled = Problem::new(&model, start).feedback(law);
        motion.compare("one wheel", controlled.dynamics(), 1e-10, &mut figures);
    }
    figures.finish();
}

/// On a circular orbit of rate n, its angles from the axes of the orbit: the first points away from the
/// Earth, the second along the track, the third is normal to the orbit.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    define(
        attitude = rotation_zyx(a, b, c),
        w = angular_velocity(rotation_z(n * t) * attitude),
        radial = attitude.transpose() * [1.0, 0.0, 0.0],
    ),
    kinetic = 0.5 * w.dot(diagonal(inertia) * w),
    potential = 1.5 * n.powi(2) * radial.dot(diagonal(inertia) * radial),
)]
struct InOrbit {
    inertia: Vector3<f64>,
    n: f64,
}

/// In the plane of the orbit ω² = 3 n² (I2 − I1) / I3; out of it, with kʀ = (I3 − I1) / I2 and
/// kʏ = (I3 − I2) / I1, ω⁴ − (1 + 3 kʀ + kʀ kʏ) n² ω² + 4 kʀ kʏ n⁴ = 0.
#[test]
fn the_gradient_of_gravity_makes_it_librate() {
    let model = InOrbit {
        inertia: Vector3::new(4.0, 10.0, 11.0),
        n: 1.1e-3,
    };
    let [i1, i2, i3] = model.inertia.into();
    let (kr, ky) = ((i3 - i1) / i2, (i3 - i2) / i1);
    let half = 0.5 * (1.0 + 3.0 * kr + kr * ky);
    let root = (half.powi(2) - 4.0 * kr * ky).sqrt();
    let mut expected =
        [3.0 * (i2 - i1) / i3, half - root, half + root].map(|square| model.n * square.sqrt());
    expected.sort_by(f64::total_cmp);

    for t in [0.0, 700.0, 2000.0] {
        let state = State::new(t, [0.0; 3], [0.0; 3]);
        let accelerations = model.accelerations(&state) / model.n.powi(2);
        assert_close("equilibrium", accelerations.as_slice(), &[0.0; 3], 1e-14);
        let linearization = model.linearize(&state);
        let mut system = SMatrix::<f64, 6, 6>::zeros();
        system.fixed_view_mut::<3, 3>(0, 3).fill_with_identity();
        system
            .fixed_view_mut::<3, 3>(3, 0)
            .copy_from(&linearization.position);
        system
            .fixed_view_mut::<3, 3>(3, 3)
            .copy_from(&linearization.velocity);
        let eigenvalues = system.complex_eigenvalues();
        let mut found: Vec<f64> = eigenvalues
            .iter()
            .map(|value| value.im)
            .filter(|im| *im > 0.0)
            .collect();
        found.sort_by(f64::total_cmp);
        let found: Vec<f64> = found.iter().map(|frequency| frequency / model.n).collect();
        assert_close(
            "frequencies",
            &found,
            &expected.map(|frequency| frequency / model.n),
            1e-12,
        );
    }
}
