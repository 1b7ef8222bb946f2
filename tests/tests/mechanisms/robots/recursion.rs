//! Inverse dynamics of a tree of links in inertial axes: velocities and accelerations link by link, and then the power of all
//! forces and moments behind each joint at its unit rate.

use lagrangian::quantities::StateJacobian;
use lagrangian::{Lagrangian, State};
use lagrangian_tests::relative_error;
use nalgebra::{Matrix3, Rotation3, SVector, Unit, Vector3};

/// How a joint moves its link, along the axes of the link.
#[derive(Clone, Copy)]
pub(super) enum Motion {
    Turn(Vector3<f64>),
    Slide(Vector3<f64>),
}

/// A link, with the joint before it. All vectors are along the axes of the link, but for its place.
#[derive(Clone, Copy)]
pub(super) struct Link {
    /// The link before, by its index.
    pub(super) parent: Option<usize>,
    /// The origin in the link before, along its axes.
    pub(super) place: Vector3<f64>,
    /// The axes in those of the link before, where the coordinate is 0.
    pub(super) axes: Rotation3<f64>,
    pub(super) motion: Motion,
    pub(super) mass: f64,
    pub(super) center: Vector3<f64>,
    /// About the centre of mass.
    pub(super) inertia: Matrix3<f64>,
    /// The inertia of the motor, seen through its gear.
    pub(super) rotor: f64,
}

impl Link {
    /// A link without mass.
    pub(super) fn massless(parent: Option<usize>, place: Vector3<f64>, motion: Motion) -> Self {
        Self {
            parent,
            place,
            axes: Rotation3::identity(),
            motion,
            mass: 0.0,
            center: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            rotor: 0.0,
        }
    }
}

/// What is known of a link in inertial axes.
struct Moving {
    axes: Rotation3<f64>,
    origin: Vector3<f64>,
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    turning: Vector3<f64>,
    turning_acceleration: Vector3<f64>,
    /// The axis of the joint.
    direction: Vector3<f64>,
}

impl Moving {
    fn next(before: Option<&Self>, link: &Link, [q, v, a]: [f64; 3]) -> Self {
        let still = Self {
            axes: Rotation3::identity(),
            origin: Vector3::zeros(),
            velocity: Vector3::zeros(),
            acceleration: Vector3::zeros(),
            turning: Vector3::zeros(),
            turning_acceleration: Vector3::zeros(),
            direction: Vector3::zeros(),
        };
        let before = before.unwrap_or(&still);
        let (w, alpha) = (before.turning, before.turning_acceleration);
        let fixed = before.axes * link.axes;
        let mut arm = before.axes * link.place;
        match link.motion {
            Motion::Turn(axis) => {
                let direction = fixed * axis;
                let rotation = Rotation3::from_axis_angle(&Unit::new_normalize(axis), q);
                Self {
                    axes: fixed * rotation,
                    origin: before.origin + arm,
                    velocity: before.velocity + w.cross(&arm),
                    acceleration: before.acceleration + alpha.cross(&arm) + w.cross(&w.cross(&arm)),
                    turning: w + direction * v,
                    turning_acceleration: alpha + direction * a + w.cross(&direction) * v,
                    direction,
                }
            }
            Motion::Slide(axis) => {
                let direction = fixed * axis;
                arm += direction * q;
                Self {
                    axes: fixed,
                    origin: before.origin + arm,
                    velocity: before.velocity + w.cross(&arm) + direction * v,
                    acceleration: before.acceleration
                        + alpha.cross(&arm)
                        + w.cross(&w.cross(&arm))
                        + 2.0 * w.cross(&direction) * v
                        + direction * a,
                    turning: w,
                    turning_acceleration: alpha,
                    direction,
                }
            }
        }
    }
}

/// The generalized forces that a motion takes, under gravity along −z.
fn inverse_dynamics<const N: usize>(
    links: &[Link; N],
    state: &State<f64, N>,
    accelerations: &SVector<f64, N>,
    gravity: f64,
) -> SVector<f64, N> {
    let mut all: Vec<Moving> = Vec::new();
    for (i, link) in links.iter().enumerate() {
        let before = link.parent.map(|parent| &all[parent]);
        let motion = [state.q[i], state.v[i], accelerations[i]];
        all.push(Moving::next(before, link, motion));
    }
    let loads = links.iter().zip(&all).map(|(link, moving)| {
        let arm = moving.axes * link.center;
        let (w, alpha) = (moving.turning, moving.turning_acceleration);
        let acceleration = moving.acceleration + alpha.cross(&arm) + w.cross(&w.cross(&arm));
        let inertia = moving.axes * link.inertia * moving.axes.inverse();
        let force = link.mass * (acceleration + Vector3::z() * gravity);
        let moment = inertia * alpha + w.cross(&(inertia * w));
        (moving.origin + arm, force, moment)
    });
    let loads: Vec<_> = loads.collect();
    SVector::from_fn(|i, _| {
        let joint = &all[i];
        let is_behind = |j: usize| {
            let mut link = Some(j);
            while let Some(k) = link.filter(|k| *k != i) {
                link = links[k].parent;
            }
            link.is_some()
        };
        let behind = (i..N).filter(|j| is_behind(*j));
        let powers = behind.map(|j| {
            let (point, force, moment) = loads[j];
            match links[i].motion {
                Motion::Turn(_) => {
                    let arm = point - joint.origin;
                    joint.direction.dot(&(moment + arm.cross(&force)))
                }
                Motion::Slide(_) => joint.direction.dot(&force),
            }
        });
        powers.sum::<f64>() + links[i].rotor * accelerations[i]
    })
}

/// Compares forces and accelerations of a model without generalized forces with those of its links.
pub(super) fn assert_moves_as<M, const N: usize>(
    model: &M,
    links: &[Link; N],
    gravity: f64,
    states: &[State<f64, N>],
) where
    M: Lagrangian<N, Model: StateJacobian<N>>,
{
    for state in states {
        let wanted = SVector::from_fn(|i, _| state.v[(i + 1) % N] - 0.5 * state.q[i]);
        let expected = inverse_dynamics(links, state, &wanted, gravity);
        let found = model.inverse_dynamics(state, &wanted);
        let error = relative_error(found.as_slice(), expected.as_slice(), 1e-3);
        assert!(error < 1e-11, "forces: {error:e}");
        // The accelerations need no forces; their sizes are those of the parts.
        let accelerations = model.accelerations(state);
        let forces = inverse_dynamics(links, state, &accelerations, gravity);
        let parts = inverse_dynamics(links, state, &SVector::zeros(), gravity);
        let error = forces.amax() / parts.amax();
        assert!(error < 1e-11, "accelerations: {error:e}");
        assert_solves_system(model, state, parts.amax());
    }
    assert_linearizes(model, &states[0]);
}

/// Compares the derivatives of the accelerations with differences of order six.
fn assert_linearizes<M, const N: usize>(model: &M, state: &State<f64, N>)
where
    M: Lagrangian<N, Model: StateJacobian<N>>,
{
    const STEP: f64 = 2e-3;
    let found = model.linearize(state);
    let difference = |change: &dyn Fn(&mut State<f64, N>, f64)| {
        let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
        let terms = weights.into_iter().map(|(steps, weight)| {
            let [ahead, behind] = [steps, -steps].map(|steps| {
                let mut state = *state;
                change(&mut state, steps * STEP);
                model.accelerations(&state)
            });
            (ahead - behind) * (weight / (60.0 * STEP))
        });
        terms.sum::<SVector<f64, N>>()
    };
    for i in 0..N {
        let expected = [
            difference(&|state, step| state.q[i] += step),
            difference(&|state, step| state.v[i] += step),
        ];
        let found = [found.position.column(i), found.velocity.column(i)];
        for (found, expected) in found.into_iter().zip(expected) {
            let error = (found - expected).norm() / (1.0 + expected.norm());
            assert!(error < 1e-7, "column {i}: {error:e}");
        }
    }
}

/// Compares the accelerations with those by a numerical factorization of M: to what the condition of M leaves of the digits of forces whose parts have a size.
fn assert_solves_system<M, const N: usize>(model: &M, state: &State<f64, N>, size: f64)
where
    M: Lagrangian<N>,
{
    let (mass, forcing) = (model.mass_matrix(state), model.forcing(state));
    let inverse = nalgebra::DMatrix::from_column_slice(N, N, mass.as_slice())
        .try_inverse()
        .unwrap();
    let inverse = nalgebra::SMatrix::<f64, N, N>::from_column_slice(inverse.as_slice());
    let found = model.accelerations(state);
    let expected = inverse * forcing;
    // |δx| ≤ |M⁻¹| (|δf| + |δM| |x|), each with some tens of rounding errors.
    let rounded = 64.0 * f64::EPSILON;
    let bound = inverse.norm() * rounded * (size + mass.norm() * found.norm());
    let error = (found - expected).norm();
    assert!(error < bound, "{error:e} exceeds {bound:e}");
}
