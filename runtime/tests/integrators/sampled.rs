//! Controllers that are sampled: at the start and at multiples of the period, with what they hold and remember in the state.

use crate::common::in_lanes;
use lagrangian::nalgebra::SVector;
use lagrangian::prelude::*;
use lagrangian::{Series, SeriesMemory, TaylorCoefficients};

/// A mass of 1 on rails, with an event at a gate.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    force(x = push),
    event(gate = x - 0.5, pushed = push - 0.25),
)]
struct Cart {
    #[lagrangian(input)]
    push: f64,
}

const CART: Cart = Cart { push: 0.0 };

fn start() -> State<f64, 1> {
    State::new(0.25, [1.0], [0.0])
}

/// The difference equation of a mass whose acceleration is constant in each period, under a law of the state and of a sum.
fn expected(period: f64, samplings: u32) -> [f64; 4] {
    let [mut x, mut v, mut push, mut sum] = [1.0, 0.0, 0.0, 0.0];
    for _ in 0..samplings {
        sum += x;
        push = -2.0 * x - 2.5 * v - 0.01 * sum;
        x += period * (v + 0.5 * period * push);
        v += period * push;
    }
    [x, v, push, sum]
}

/// The law of `expected`.
macro_rules! sampled {
    ($period:expr) => {
        Problem::new(&CART, start()).sampled_feedback($period, [0.0], |x, sum| {
            sum[0] += x.q[0];
            -2.0 * x.q[0] - 2.5 * x.v[0] - 0.01 * sum[0]
        })
    };
}

fn check(found: &[f64; 4], expected: &[f64; 4], error: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert!(
            (found - expected).abs() < error,
            "{found} in place of {expected}"
        );
    }
}

/// Under each method the motion is the difference equation's, within a period the parabola.
#[test]
fn sampled_motions_follow_the_difference_equation() {
    for period in [0.1, 0.3] {
        // The controller is not evaluated at the end.
        let end = 0.25 + 20.0 * period;
        macro_rules! under {
            ($method:expr, $error:expr) => {
                let found = sampled!(period).solve(end, $method).unwrap();
                let numbers = [found.q[0], found.v[0], found.z.inputs[0], found.z.memory[0]];
                check(&numbers, &expected(period, 20), $error);
                assert!((found.z.samplings - 20.0).abs() < 0.5);
            };
        }
        under!(Taylor::new(), 1e-13);
        under!(Dop853::new(), 1e-12);
        under!(RungeKutta::classical(0.01), 1e-12);
    }
}

/// Samples have the inputs of their time; at a sampling those that are held from then on, but for the end.
#[test]
fn samples_have_what_is_held() {
    let motion = sampled!(0.1)
        .save(Every(0.05))
        .solve(1.25, Taylor::new())
        .unwrap();
    assert_eq!(motion.samples().len(), 21);
    for (k, state) in (0..).zip(motion.samples()) {
        // Samples at samplings are taken as a step ends, before the controller is evaluated, except at the start.
        let samplings = if k == 0 { 1 } else { u32::div_ceil(k, 2) };
        let [.., push, sum] = expected(0.1, samplings);
        assert!((state.z.inputs[0] - push).abs() < 1e-13, "{k}");
        assert!((state.z.memory[0] - sum).abs() < 1e-13, "{k}");
    }
}

/// A motion in parts, and from a checkpoint, is the whole motion to the last bit: at a sampling, and between two.
#[test]
fn what_is_held_goes_through_a_checkpoint() {
    for (part, method) in [(0.55, Dop853::new()), (0.6, Dop853::new())] {
        let whole = sampled!(0.1).solve(1.25, method).unwrap();
        let mut first = sampled!(0.1).start(method).unwrap();
        first.advance(part).unwrap();
        let stored = first.checkpoint();
        let end = first.advance(1.25).unwrap();
        let mut resumed = sampled!(0.1).resume(stored, method).unwrap();
        assert_eq!(resumed.advance(1.25).unwrap().last, end.last);
        check(
            &[end.q[0], end.v[0], end.z.inputs[0], end.z.memory[0]],
            &[whole.q[0], whole.v[0], whole.z.inputs[0], whole.z.memory[0]],
            1e-12,
        );
    }
}

/// Events of the motion, and of an input that jumps.
#[test]
fn events_occur_under_held_inputs() {
    let motion = sampled!(0.1).on([Cart::GATE, Cart::PUSHED]).record();
    let motion = motion.solve(6.25, Taylor::new()).unwrap();
    let gates = motion.events().iter().filter(|event| event.event == 0);
    assert!(gates.clone().count() > 0);
    for gate in gates {
        assert!((gate.x.q[0] - 0.5).abs() < 1e-13);
    }
    let jumps: Vec<f64> = motion
        .events()
        .iter()
        .filter(|event| event.event == 1)
        .map(|event| event.t)
        .collect();
    let crossings = (1..60_u32).filter(|k| {
        let [before, behind] = [*k, k + 1].map(|samplings| expected(0.1, samplings)[2] > 0.25);
        before != behind
    });
    let crossings = crossings.map(|k| 0.25 + 0.1 * f64::from(k));
    let crossings: Vec<f64> = crossings.collect();
    assert_eq!(jumps.len(), crossings.len(), "{jumps:?} {crossings:?}");
    for (jump, crossing) in jumps.iter().zip(crossings) {
        assert!((jump - crossing).abs() < 1e-12);
    }
}

#[test]
fn a_period_is_a_positive_number() {
    for period in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let refused = sampled!(period)
            .solve(1.0, Dop853::new())
            .unwrap_err()
            .error();
        assert!(
            matches!(refused, IntegrationError::InvalidPeriod { .. }),
            "{refused}"
        );
        let backwards = sampled!(period).solve(-1.0, Taylor::new());
        let backwards = backwards.unwrap_err().error();
        assert_eq!(backwards.to_string(), refused.to_string());
        assert!(
            refused.to_string().contains(&format!("is {period}")),
            "{refused}"
        );
    }
    let too_short = sampled!(1e-300).solve(1.0, Dop853::new());
    let refused = too_short.unwrap_err().error();
    assert!(
        matches!(refused, IntegrationError::InvalidUpdate { .. }),
        "{refused}"
    );
}

/// ẋ = u, whose sign changes once a second: x, u and how often it has changed.
struct Zigzag;

impl<S: Scalar> Dynamics<S> for Zigzag {
    type State = SVector<S, 3>;

    fn derivative(&self, _: S, x: &Self::State) -> Self::State {
        SVector::from([x[1], S::zero(), S::zero()])
    }

    fn next_update(&self, x: &Self::State) -> Option<f64> {
        Some(1.0 + x[2].smallest())
    }

    fn update(&self, _: S, x: &mut Self::State) {
        x[1] = -x[1];
        x[2] += S::one();
    }
}

impl<S: Scalar> Series<S> for Zigzag {
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        coefficients.higher_mut().fill(SVector::zeros());
        coefficients.higher_mut()[0] = self.derivative(t, x) * unit;
    }
}

crate::alike_in_lanes!(Zigzag);

/// Dynamics that are written by hand, by value, by reference and with sizes; in lanes they are refused.
#[test]
fn hand_written_dynamics_are_updated() {
    let start = || At::from((0.0, SVector::from([0.0, 1.0, 0.0])));
    let check = |end: &At<f64, SVector<f64, 3>>| {
        assert!(
            (end[0] - 0.5).abs() < 1e-12 && (end[2] - 3.0).abs() < 0.5,
            "{end:?}"
        );
    };
    check(
        &Problem::new(Zigzag, start())
            .solve(3.5, Dop853::new())
            .unwrap(),
    );
    check(
        &Problem::new(&Zigzag, start())
            .solve(3.5, Taylor::new())
            .unwrap(),
    );
    let sized = Zigzag.with_sizes(SVector::from([2.0, 1.0, 1.0]));
    check(
        &Problem::new(sized, start())
            .solve(3.5, Dop853::new())
            .unwrap(),
    );
    for found in in_lanes::<2, _, _>(Taylor::new(), &Zigzag, [(start(), 3.5); 3]) {
        check(&found.unwrap());
    }
}
