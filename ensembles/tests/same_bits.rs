//! A member is the same to the last bit alone, among others, in any chunk and on any number of threads: its end, its
//! events and its samples.

#![allow(clippy::float_cmp)] // The same numbers.

use std::fmt::Debug;

use lagrangian::prelude::*;
use lagrangian::rigid_body::InertiaTensor;
use lagrangian_ensembles::{Axis, Grid, Members, Study};
use lagrangian_models::{CartPole, DoublePendulum, GeneralTop, SphericalPendulum, SymmetricTop};

/// The number of members of each model; all five with `--ignored` have 10⁴.
const FEW: usize = 24;
const MANY: usize = 2000;

/// A number between −1 and 1 of a member: the golden ratio and its powers, modulo 1.
fn spread(index: usize, power: i32) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let turns = (index + 1) as f64 * 0.618_033_988_749_894_9_f64.powi(power);
    2.0 * turns.fract() - 1.0
}

/// Compares every member of a study with itself alone, and on three threads in other chunks.
fn compare<M, A>(together: Study<'_, M>, alone: impl Fn(usize) -> Study<'static, A>)
where
    M: Members,
    M::State: PartialEq + Debug,
    M::Kept: PartialEq + Debug,
    A: Members<State = M::State, Kept = M::Kept, Points = Vec<usize>>,
{
    let together = together.threads(1);
    let motions = together.solve().unwrap();
    let in_threads = together.threads(3).chunk(7).solve().unwrap();
    let mut events = 0;
    for (index, (motion, other)) in motions.iter().zip(&in_threads).enumerate() {
        let alone = alone(index).solve().unwrap().remove(0);
        match (motion, other, &alone) {
            (Ok(motion), Ok(other), Ok(alone)) => {
                assert_eq!(motion.index, index);
                assert_eq!(
                    motion.solution, other.solution,
                    "member {index} on three threads"
                );
                assert_eq!(motion.solution, alone.solution, "member {index} alone");
                events += motion.events().len();
            }
            (Err(motion), Err(other), Err(alone)) => {
                for partial in [&other.partial, &alone.partial] {
                    assert_eq!(
                        motion.partial.solution(),
                        partial.solution(),
                        "member {index}"
                    );
                    assert_eq!(
                        motion.partial.to_string(),
                        partial.to_string(),
                        "member {index}"
                    );
                }
            }
            _ => panic!("member {index} fails in one case only"),
        }
    }
    assert!(events > motions.len(), "only {events} events occurred");
}

/// Compares every member of studies of problems by a method, in lanes and in twice as many.
macro_rules! compare {
    ($count:expr, $method:expr, $problem:expr) => {{
        let study = Study::new(0..$count, $problem, 3.0, $method);
        compare(study, |index| {
            Study::new(vec![index], $problem, 3.0, $method)
        });
        let study = Study::new(0..$count / 4, $problem, 3.0, $method).lanes::<8>();
        compare(study, |index| {
            Study::new(vec![index], $problem, 3.0, $method)
        });
    }};
}

fn pendulums(count: usize) {
    let problem = |index: usize| {
        let model = DoublePendulum {
            m1: 1.0,
            m2: 0.5 + 0.4 * spread(index, 3),
            l1: 1.0,
            l2: 0.7,
            g: 9.81,
        };
        let start = State::new(
            0.0,
            [2.0 * spread(index, 1), 2.0 * spread(index, 2)],
            [0.0, 0.3],
        );
        Problem::new(model, start)
            .when(|x| x.q[0])
            .record()
            .when(|x| x.q[1])
            .rising()
            .then(|x| x.v[1] *= 0.9)
            .save(Every(0.25))
    };
    compare!(count, Taylor::new(), problem);
}

fn spherical(count: usize) {
    let problem = |index: usize| {
        let model = SphericalPendulum {
            m: 1.0,
            l: 1.0 + 0.5 * spread(index, 2),
            g: 9.81,
        };
        // Every tenth starts at the pole of its coordinates, at which it fails.
        let theta = if index % 10 == 3 {
            0.0
        } else {
            1.5 + spread(index, 1)
        };
        let start = State::new(0.0, [theta, 0.0], [0.1, 1.0 + spread(index, 3)]);
        Problem::new(model, start)
            .when(|x| x.v[0])
            .record()
            .save(StepEnds)
    };
    compare!(count, Taylor::new(), problem);
}

fn symmetric_tops(count: usize) {
    let problem = |index: usize| {
        let body = SymmetricBody::new(1.3, 0.4, 1.2, 0.5 + 0.1 * spread(index, 2)).unwrap();
        let start = State::new(
            0.0,
            [0.0, 0.7 + 0.3 * spread(index, 1), 0.0],
            [0.3, 0.0, 20.0],
        );
        Problem::new(SymmetricTop { body, g: 9.81 }, start)
            .when(|x| x.v[1])
            .record()
            .save([0.5, 1.0, 2.5])
    };
    compare!(count, Taylor::new(), problem);
}

/// A body with principal moments of inertia about its centre of gravity.
fn body(mass: f64, center: [f64; 3], moments: [f64; 3]) -> RigidBody {
    RigidBody::new(mass, center.into(), InertiaTensor::principal(moments)).unwrap()
}

fn general_tops(count: usize) {
    let problem = |index: usize| {
        let start = State::new(
            0.0,
            [0.0, 1.0 + 0.5 * spread(index, 1), 0.2],
            [0.3, 0.1, 15.0 + 5.0 * spread(index, 2)],
        );
        let body = body(1.3, [0.05, 0.03, 0.4], [1.2, 1.5, 0.7]);
        Problem::new(GeneralTop { body, g: 9.81 }, start)
            .when(|x| x.v[1])
            .record()
    };
    compare!(count, Dop853::new(), problem);
}

fn carts(count: usize) {
    let problem = |index: usize| {
        let pole = body(0.2, [0.0, 0.0, 0.5], [0.02, 0.02, 0.001]);
        let cart = CartPole {
            cart: 1.0 + 0.5 * spread(index, 1),
            pole,
            g: 9.81,
            push: 0.0,
        };
        let start = State::new(0.0, [0.0, 0.3 + 0.2 * spread(index, 2)], [0.0, 0.0]);
        Problem::new(cart, start)
            .when(|x| x.v[1])
            .record()
            .when(|x| x.v[0])
            .record()
            .save(Every(0.5))
    };
    compare!(count, RungeKutta::classical(0.01), problem);
}

/// Whole chunks end while a member of an earlier one goes on.
#[test]
fn slow_members_do_not_hold_up_others() {
    let problem = |index: usize| {
        let model = DoublePendulum {
            m1: 1.0,
            m2: 1.0,
            l1: 1.0,
            l2: 1.0,
            g: 9.81,
        };
        Problem::new(model, State::new(0.0, [spread(index, 1), 0.1], [0.0, 0.0]))
    };
    for (threads, chunk) in [(1, 1), (1, 3), (2, 5)] {
        let end = |index: usize| if index % 40 == 2 { 10.0 } else { 0.1 };
        let study = Study::new(0..200, problem, end, Taylor::new());
        let motions = study.threads(threads).chunk(chunk).solve().unwrap();
        assert_eq!(motions.len(), 200);
        for (index, motion) in motions.iter().enumerate() {
            let motion = motion.as_ref().unwrap();
            assert_eq!((motion.index, motion.t), (index, end(index)));
        }
    }
}

/// A member ends where its point says.
#[test]
fn ends_are_functions_of_the_points() {
    let problem = |[l, _]: [f64; 2]| {
        let model = SphericalPendulum { m: 1.0, l, g: 9.81 };
        Problem::new(model, State::new(0.0, [1.0, 0.0], [0.0, 1.0]))
    };
    let points = Grid::new([
        Axis::linear("l", 0.5, 1.5, 3),
        Axis::listed("end", [0.5, 0.25]),
    ]);
    let study = Study::new(points, problem, |[l, end]: [f64; 2]| l * end, Taylor::new());
    for motion in study.solve().unwrap() {
        let motion = motion.unwrap();
        assert_eq!(motion.t, motion.point[0] * motion.point[1]);
    }
}

#[test]
fn a_member_alone_is_itself_in_the_ensemble() {
    pendulums(FEW);
    spherical(FEW);
    symmetric_tops(FEW);
    general_tops(FEW / 4);
    carts(FEW / 4);
}

#[test]
#[ignore = "takes a minute"]
fn ten_thousand_members_alone_are_themselves_in_the_ensemble() {
    pendulums(MANY);
    spherical(MANY);
    symmetric_tops(MANY);
    general_tops(MANY);
    carts(MANY);
}
