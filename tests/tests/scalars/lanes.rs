//! Eight evaluations at once, with parameters that differ from lane to lane, against each of them.

use lagrangian::Factorization;
use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;
use lagrangian_tests::assert_close;

use crate::models::{
    BentPendulum, DampedCart, DoublePendulum, Gearbox, HeavyTop, Joined, Numbered, between,
    everything, gearing, parameters, state,
};

const LANES: usize = 8;

type Lanes = lagrangian::Lanes<LANES>;

/// Numbers of which each lane has its own.
fn lanes<const P: usize>(of_lane: impl Fn(usize) -> [f64; P]) -> [Lanes; P] {
    std::array::from_fn(|i| Lanes::from_fn(|lane| of_lane(lane)[i]))
}

/// States of which each lane has its own.
fn states<const N: usize>(of_lane: impl Fn(usize) -> State<f64, N>) -> State<Lanes, N> {
    State::new(
        Lanes::from_fn(|lane| of_lane(lane).t),
        SVector::from_fn(|i, _| Lanes::from_fn(|lane| of_lane(lane).q[i])),
        SVector::from_fn(|i, _| Lanes::from_fn(|lane| of_lane(lane).v[i])),
    )
}

/// The same operations in the same order are done on each lane, and round alike.
fn assert_same<Many, One, const N: usize, const P: usize>(parameters: fn(usize) -> [f64; P])
where
    Many: Numbered<Lanes, P> + Lagrangian<N, Lanes, Model: StateJacobian<N, Lanes>>,
    One: Numbered<f64, P> + Lagrangian<N, Model: StateJacobian<N>>,
{
    let found = everything(&Many::with(lanes(parameters)), &states(state::<N>));
    for lane in 0..LANES {
        let expected = everything(&One::with(parameters(lane)), &state(lane));
        for ((quantity, found), (_, expected)) in found.iter().zip(&expected) {
            let bits = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(f64::to_bits).collect();
            let found: Vec<u64> = bits(&mut found.iter().map(|number| number.lane(lane)));
            let expected: Vec<u64> = bits(&mut expected.iter().copied());
            assert_eq!(found, expected, "{quantity} in lane {lane}");
        }
    }
}

#[test]
fn each_lane_gives_what_it_gives_alone() {
    assert_same::<HeavyTop<Lanes>, HeavyTop<f64>, _, _>(parameters);
    assert_same::<DoublePendulum<Lanes>, DoublePendulum<f64>, _, _>(parameters);
    assert_same::<BentPendulum<Lanes>, BentPendulum<f64>, _, _>(parameters);
    assert_same::<DampedCart<Lanes>, DampedCart<f64>, _, _>(parameters);
    assert_same::<Gearbox<Lanes>, Gearbox<f64>, _, _>(gearing);
}

#[test]
fn inputs_and_outputs_may_differ_from_lane_to_lane() {
    let many = DampedCart::with(lanes(parameters));
    let at = states(state::<2>);
    let inputs = lanes(|lane| [between(-1.0, 1.0, lane)]);
    let (held, driven) = (many.outputs(&at), many.with_inputs(inputs).outputs(&at));
    let jacobian = many.input_jacobian(&at);
    for lane in 0..LANES {
        let one = DampedCart::with(parameters(lane));
        let inputs = SVector::from([between(-1.0, 1.0, lane)]);
        let (alone, alone_driven) = (
            one.outputs(&state(lane)),
            one.with_inputs(inputs).outputs(&state(lane)),
        );
        assert_eq!(held.height.lane(lane).to_bits(), alone.height.to_bits());
        assert_eq!(held.felt.lane(lane).to_bits(), alone.felt.to_bits());
        assert_eq!(
            driven.felt.lane(lane).to_bits(),
            alone_driven.felt.to_bits()
        );
        let alone = one.input_jacobian(&state(lane));
        assert_eq!(jacobian[0].lane(lane).to_bits(), alone[0].to_bits());
    }
}

/// The parameters own, common, stiffness, twist of masses ((own, common), (common, own)).
fn joined(masses: [(f64, f64); LANES]) -> impl Fn(usize) -> [f64; 4] {
    move |lane| {
        let (own, common) = masses[lane];
        [own, common, 1.5, 0.5]
    }
}

/// One lane that is not positive definite takes all of them to the factorization with exchange of rows,
/// which rounds otherwise; nothing else may come of it.
#[track_caller]
fn assert_close_to_each_alone(parameters: impl Fn(usize) -> [f64; 4], compared: &[usize]) {
    let found = everything(&Joined::with(lanes(&parameters)), &states(state::<2>));
    for &lane in compared {
        let expected = everything(&Joined::with(parameters(lane)), &state(lane));
        for ((quantity, found), (_, expected)) in found.iter().zip(&expected) {
            let found: Vec<f64> = found.iter().map(|number| number.lane(lane)).collect();
            assert_close(quantity, &found, expected, 1e-14);
        }
    }
}

const ALL: [usize; LANES] = [0, 1, 2, 3, 4, 5, 6, 7];

const DEFINITE: (f64, f64) = (2.0, 0.5);
const INDEFINITE: (f64, f64) = (0.5, 2.0);
/// ẋẏ.
const EXCHANGED: (f64, f64) = (0.0, 1.5);
const DIAGONAL: (f64, f64) = (1.5, 0.0);
const SINGULAR: (f64, f64) = (1.0, 1.0);
const NOTHING: (f64, f64) = (0.0, 0.0);

#[test]
fn one_lane_may_be_indefinite() {
    for odd in ALL {
        let mut masses = [DEFINITE; LANES];
        masses[odd] = INDEFINITE;
        assert_close_to_each_alone(joined(masses), &ALL);
        masses[odd] = EXCHANGED;
        assert_close_to_each_alone(joined(masses), &ALL);
    }
}

#[test]
fn no_exchange_of_rows_need_suit_all_lanes() {
    let mut masses = [DIAGONAL; LANES];
    masses[5] = EXCHANGED;
    assert_close_to_each_alone(joined(masses), &ALL);
    masses[2] = INDEFINITE;
    masses[3] = DEFINITE;
    assert_close_to_each_alone(joined(masses), &ALL);
}

#[test]
fn one_lane_may_be_singular() {
    for singular in [SINGULAR, NOTHING, (f64::NAN, 0.5), (0.5, f64::NAN)] {
        let mut masses = [
            DEFINITE, INDEFINITE, EXCHANGED, DIAGONAL, DEFINITE, INDEFINITE, EXCHANGED, DIAGONAL,
        ];
        masses[6] = singular;
        let found = Joined::with(lanes(joined(masses))).accelerations(&states(state::<2>));
        assert!(
            found.iter().any(|number| !number.lane(6).is_finite()),
            "{found:?}"
        );
        assert_close_to_each_alone(joined(masses), &[0, 1, 2, 3, 4, 5, 7]);
    }
}

/// Each lane's relative pivots are its own, and those of the lane 3 alone say that it is singular.
fn assert_blamed<Many, One, const N: usize, const P: usize>(
    parameters: impl Fn(usize) -> [f64; P],
    at: impl Fn(usize) -> State<f64, N>,
) where
    Many: Numbered<Lanes, P> + Lagrangian<N, Lanes, Model: StateJacobian<N, Lanes>>,
    One: Numbered<f64, P> + Lagrangian<N, Model: StateJacobian<N>>,
{
    let found = Many::with(lanes(&parameters)).relative_pivots(&states(&at));
    for lane in 0..LANES {
        let expected = One::with(parameters(lane)).relative_pivots(&at(lane));
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(found.lane(lane).to_bits(), expected.to_bits());
        }
        let regular = found.iter().all(|pivot| pivot.lane(lane) > 0.0);
        assert_eq!(regular, lane != 3, "{found:?}");
    }
}

#[test]
fn a_singular_lane_is_the_only_one_to_blame() {
    let mut masses = [DEFINITE; LANES];
    masses[3] = SINGULAR;
    assert_blamed::<Joined<Lanes>, Joined<f64>, 2, 4>(joined(masses), state);
    let at_the_pole = |lane| {
        let mut state = state::<3>(lane);
        if lane == 3 {
            state.q[HeavyTop::<f64>::THETA] = 0.0;
        }
        state
    };
    assert_blamed::<HeavyTop<Lanes>, HeavyTop<f64>, 3, 6>(parameters, at_the_pole);
}

/// Rotors of which one in one lane has no inertia and turns alone.
#[test]
fn a_row_of_zeros_is_the_only_one_to_blame() {
    let masses = SMatrix::<Lanes, 4, 4>::from_fn(|i, j| {
        let entry = |lane| match (i.max(j), i.min(j)) {
            (2, _) | (3, 2) if lane == 5 => 0.0,
            (1, 0) => 3.0,
            (i, j) if i == j => 2.0,
            _ => 0.25,
        };
        Lanes::from_fn(entry)
    });
    let factors = Factorization::new(masses);
    let (pivots, right) = (
        factors.relative_pivots(),
        SVector::from([Lanes::from_fn(|_| 1.0); 4]),
    );
    let solution = factors.solve(&right);
    for lane in 0..LANES {
        for (i, pivot) in pivots.iter().enumerate() {
            let blamed = pivot.lane(lane) == 0.0;
            assert_eq!(blamed, lane == 5 && i == 2, "{pivots:?}");
        }
        let finite = solution.iter().all(|entry| entry.lane(lane).is_finite());
        assert_eq!(finite, lane != 5);
    }
}
