//! Members with different parameters in the lanes of one model of plain numbers, against each of them alone, bit by bit.

use lagrangian::prelude::*;
use lagrangian::quantities::MotionSeries;
use lagrangian::{EquationsOfMotion, InLanes, Lanes, Series, TaylorCoefficients};

use crate::models::{between, state};

const LANES: usize = 4;

/// A pendulum on a cart, with an input, damping and events.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x, theta),
    kinetic = 0.5 * mass * dot(x).powi(2)
        + 0.5 * m * (dot(x).powi(2) + 2.0 * l * cos(theta) * dot(x) * dot(theta) + (l * dot(theta)).powi(2)),
    potential = -m * g * l * cos(theta),
    dissipation = 0.5 * c * dot(theta).powi(2),
    force(x = push - wall * max(x - reach, 0.0)),
    event(gap = x - reach, bottom = sin(theta)),
)]
struct Cart {
    mass: f64,
    m: f32,
    g: f64,
    l: f64,
    c: f64,
    reach: f64,
    wall: f64,
    #[lagrangian(input)]
    push: f64,
}

impl Cart {
    fn numbered(index: usize) -> Self {
        let number = |least, most, offset| between(least, most, 8 * index + offset);
        Self {
            mass: number(0.5, 3.0, 0),
            m: [0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0][index % 7],
            g: number(1.0, 20.0, 1),
            l: number(0.25, 2.0, 2),
            c: number(0.0, 0.5, 3),
            reach: number(-0.5, 1.5, 4),
            wall: number(0.5, 4.0, 5),
            push: number(-2.0, 2.0, 6),
        }
    }
}

/// Masses in a line between springs, with families of parameters, a vector and an external function.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(y[3], r: Vector3),
    function(stiffening(u) = cubed(u), derivative(u) = 3.0 * u.powi(2)),
    kinetic = (0..3).map(|i| 0.5 * m[i] * dot(y[i]).powi(2)).sum() + 0.5 * m[0] * dot(r).dot(dot(r)),
    potential = (0..2).map(|i| 0.5 * k[i] * (y[i + 1] - y[i]).powi(2)).sum() + hardness * stiffening(y[0]) * y[0]
        + 0.5 * k[0] * (r - rest).dot(r - rest) + m[1] * pull.dot(r),
    event(near = r.x - rest.x),
)]
struct Chain {
    m: [f64; 3],
    k: [f64; 2],
    hardness: f64,
    rest: Vector3<f64>,
    pull: Vector3<f64>,
}

fn cubed<S: Scalar>(u: S) -> S {
    u * u * u
}

impl Chain {
    fn numbered(index: usize) -> Self {
        let number = |least, most, offset| between(least, most, 16 * index + offset);
        Self {
            m: std::array::from_fn(|i| number(0.5, 2.0, i)),
            k: std::array::from_fn(|i| number(1.0, 9.0, 3 + i)),
            hardness: number(0.1, 0.5, 5),
            rest: Vector3::from_fn(|i, _| number(-1.0, 1.0, 6 + i)),
            pull: Vector3::from_fn(|i, _| number(-1.0, 1.0, 9 + i)),
        }
    }
}

/// The coefficients of a polynomial, order by order.
fn orders<X: Copy, const HALF: usize>(series: &TaylorCoefficients<X, HALF>) -> Vec<&X> {
    let initial = core::iter::once(series.initial());
    initial.chain(series.higher()).collect()
}

/// What the equations of a motion compute, in one lane: all that an integration evaluates.
fn evaluated<D, const N: usize>(
    equations: &D,
    (t, x): (Lanes<LANES>, &Phase<Lanes<LANES>, N>),
    lane: usize,
) -> Vec<u64>
where
    D: Series<Lanes<LANES>, State = Phase<Lanes<LANES>, N>>,
{
    let unit = Lanes([0.25; LANES]);
    let mut found = Vec::new();
    let mut add = |value: Lanes<LANES>| found.push(value.lane(lane).to_bits());
    let mut motion = TaylorCoefficients::<Phase<Lanes<LANES>, N>, 8>::new(*x);
    equations.series((t, x), unit, &mut motion, None);
    for Phase { q, v, .. } in [&equations.derivative(t, x)]
        .into_iter()
        .chain(orders(&motion))
    {
        q.iter().chain(v).for_each(|value| add(*value));
    }
    Series::branches(equations, t, x, unit, &motion, &mut |coefficients| {
        coefficients.for_each(&mut add);
    });
    found
}

/// Members in lanes, which are set again and again, evaluate to what each does alone.
fn assert_same<M, const N: usize>(member: impl Fn(usize) -> M)
where
    M: Lagrangian<N, f64> + Lagrangian<N, Lanes<LANES>, Model: MotionSeries<N, Lanes<LANES>>>,
    EquationsOfMotion<M, f64, N>: InLanes<LANES, States = Phase<Lanes<LANES>, N>>,
{
    let plain = |index| Lagrangian::<N, f64>::into_dynamics(member(index));
    let mut parameters = plain(1000).parameters();
    for round in 0..50 {
        let members: [usize; LANES] = core::array::from_fn(|lane| LANES * round + lane);
        for (lane, index) in members.into_iter().enumerate() {
            plain(index).set_lane(&mut parameters, lane);
        }
        plain(0).set_lane(&mut parameters, LANES);
        let states = members.map(state::<N>);
        let (t, x) = (
            Lanes(states.map(|state| state.t)),
            Phase::<Lanes<LANES>, N>::new(
                SVector::from_fn(|i, _| Lanes(states.map(|state| state.q[i]))),
                SVector::from_fn(|i, _| Lanes(states.map(|state| state.v[i]))),
            ),
        );
        // Whichever member lends its model.
        let lender = plain(7);
        let equations = lender.together(&parameters);
        for (lane, (index, state)) in members.into_iter().zip(states).enumerate() {
            // All lanes have the parameters of its fields.
            let alone = Lagrangian::<N, Lanes<LANES>>::into_dynamics(member(index));
            let expected = evaluated(&alone, (t, &x), lane);
            assert_eq!(evaluated(&equations, (t, &x), lane), expected, "{index}");
            // On plain numbers, too.
            let plain = Lagrangian::<N, f64>::accelerations(&member(index), &state);
            for (found, plain) in equations.derivative(t, &x).v.iter().zip(&plain) {
                assert_eq!(found.lane(lane).to_bits(), plain.to_bits());
            }
        }
    }
}

#[test]
fn members_compute_in_lanes_what_they_compute_alone() {
    assert_same::<Cart, 2>(Cart::numbered);
    assert_same::<Chain, 6>(Chain::numbered);
}

#[test]
fn an_ensemble_of_members_has_the_motions_of_each_alone() {
    let problem = |index: usize| {
        let State { x, .. } = state::<2>(index);
        Problem::new(Cart::numbered(index), State::new(0.0, x.q, x.v))
    };
    let end = |index| between(0.5, 4.0, index);
    let found = Ensemble::new((0..30).map(problem)).solve(end, Taylor::new());
    assert_eq!(found.len(), 30);
    for (index, found) in found.into_iter().enumerate() {
        let found = found.expect("it is regular");
        let alone = Ensemble::new([problem(index)]).lanes::<2>();
        let alone = alone.solve(end(index), Taylor::new()).remove(0);
        assert_eq!(found.last, alone.expect("it is regular").last);
        let plain = problem(index).solve(end(index), Taylor::new());
        let plain = plain.expect("it is regular");
        assert!((found.q - plain.q).norm() < 1e-10 && (found.v - plain.v).norm() < 1e-10);
    }
}

#[test]
fn an_ensemble_without_members_reports_nothing() {
    let none = (0..0).map(|index| {
        let start = State::new(0.0, [0.0; 2], [0.0; 2]);
        Problem::new(Cart::numbered(index), start)
    });
    Ensemble::new(none).solve_each(1.0, Taylor::new(), |_, _| {
        unreachable!("there is no motion")
    });
}
