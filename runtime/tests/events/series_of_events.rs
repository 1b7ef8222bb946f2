//! How much of the series of event functions is computed.

use std::cell::RefCell;

use lagrangian::prelude::*;
use lagrangian::{
    DeclaredEvent, Dynamics, EventDynamics, Series, SeriesMemory, TaylorCoefficients,
};

/// A heavy top: none of the first three events ever occurs.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i1 * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i3 * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = m * g * l * cos(theta),
    event(
        fallen = theta - 9,
        tip = sin(theta) * cos(phi) - 2,
        near = sqrt((sin(theta) * cos(phi) - 2).powi(2) + (sin(theta) * sin(phi)).powi(2) + cos(theta).powi(2)) - 0.5,
        quarter = sin(theta) * cos(phi) - 0.2,
        spin = sin(psi) - 0.1,
    ),
)]
struct Top {
    i1: f64,
    i3: f64,
    m: f64,
    g: f64,
    l: f64,
}

const TOP: Top = Top {
    i1: 1.2,
    i3: 0.5,
    m: 1.3,
    g: 9.81,
    l: 0.4,
};

/// Dynamics that note the orders of the series that are asked of them.
struct Counted<'a, D> {
    dynamics: &'a D,
    orders: RefCell<Vec<usize>>,
}

impl<D: Dynamics<f64>> Dynamics<f64> for Counted<'_, D> {
    type State = D::State;

    fn derivative(&self, t: f64, x: &D::State) -> D::State {
        self.dynamics.derivative(t, x)
    }
}

impl<D: Series<f64>> Series<f64> for Counted<'_, D> {
    fn series<const HALF: usize>(
        &self,
        begin: (f64, &D::State),
        unit: f64,
        coefficients: &mut TaylorCoefficients<D::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        self.dynamics.series(begin, unit, coefficients, memory);
    }
}

impl<D: EventDynamics<f64>> EventDynamics<f64> for Counted<'_, D> {
    type Model = D::Model;
    type Values = D::Values;

    fn names(&self) -> &'static [&'static str] {
        self.dynamics.names()
    }

    fn event_functions(&self, t: f64, x: &D::State) -> D::Values {
        self.dynamics.event_functions(t, x)
    }

    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        t: f64,
        x: &D::State,
        unit: f64,
        motion: &TaylorCoefficients<D::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<D::Values, HALF>> {
        self.orders.borrow_mut().push(2 * HALF);
        self.dynamics.event_series(t, x, unit, motion)
    }
}

/// The number of steps, the orders of the series that were asked for, and the times of the events.
fn watched<const K: usize>(events: [DeclaredEvent<Top>; K]) -> (u64, Vec<usize>, Vec<f64>) {
    let dynamics = Counted {
        dynamics: &TOP.dynamics(),
        orders: RefCell::default(),
    };
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let problem = Problem::new(&dynamics, start).on(events).record();
    let motion = problem.solve(20.0, Taylor::new()).unwrap();
    let times = motion.events().iter().map(|event| event.t).collect();
    (motion.statistics.steps, dynamics.orders.take(), times)
}

#[test]
fn a_few_terms_exclude_events_that_are_far_away() {
    let (steps, orders, times) = watched([Top::FALLEN, Top::TIP, Top::NEAR]);
    assert!(times.is_empty());
    // One short series in each step, for all events together.
    assert_eq!(orders.len(), usize::try_from(steps).unwrap());
    assert!(orders.iter().all(|order| *order == 8), "{orders:?}");
}

/// All terms are computed where a function is near zero, and the events are the ones that samples see.
#[test]
fn all_terms_are_computed_near_an_event() {
    let (steps, orders, times) = watched([Top::QUARTER]);
    let full = orders.iter().filter(|order| **order == 28).count();
    assert!(orders.len() > usize::try_from(steps).unwrap() && full > times.len());
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let quarter = Problem::new(&TOP, start)
        .when(|x| x.q[1].sin() * x.q[0].cos() - 0.2)
        .record();
    let motion = quarter.solve(20.0, Taylor::new()).unwrap();
    assert!(times.len() > 2, "{times:?} {}", motion.events().len());
    assert_eq!(times.len(), motion.events().len());
    for (t, sampled) in times.iter().zip(motion.events()) {
        assert!((t - sampled.t).abs() < 1e-12, "{t} {}", sampled.t);
    }
}

/// Steps have several zeros, and all terms are computed once for each of them and once for what follows: a search computes them
/// twice.
#[test]
fn each_zero_that_is_isolated_takes_one_series() {
    let (steps, orders, times) = watched([Top::SPIN]);
    let count = times.len();
    let full = orders.iter().filter(|order| **order == 28).count();
    let steps = usize::try_from(steps).unwrap();
    assert!(count * 10 > steps * 6, "{count} zeros in {steps} steps");
    assert!(
        full < steps + count,
        "{full} series, {count} zeros in {steps} steps"
    );
}

/// A particle without forces, along which the event function is 1 − 40 t¹¹ (1 − t).
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0,
    event(dip = 1 - 40 * x.powi(11) * (1 - x)),
)]
struct Particle {
    m: f64,
}

/// A few terms tell nothing about the others where they vanish, and the function has one value at both ends.
#[test]
fn events_of_terms_of_high_order_alone_are_found() {
    let particle = Particle { m: 1.0 };
    let start = State::new(0.0, [0.0], [1.0]);
    let problem = Problem::new(&particle, start).on(Particle::DIP).record();
    let motion = problem.solve(1.0, Taylor::new()).unwrap();
    assert_eq!(motion.events().len(), 2);
    for event in motion.events() {
        let t: f64 = event.t;
        let value = 1.0 - 40.0 * t.powi(11) * (1.0 - t);
        assert!(value.abs() < 1e-12, "{value:e}");
    }
}

/// A free particle whose event function x − level changes its sign for a while in the middle of [0, 1], which its series does
/// not represent, like the corners of an external function.
struct Interrupted<D> {
    dynamics: D,
    level: f64,
}

impl<D: Dynamics<f64>> Dynamics<f64> for Interrupted<D> {
    type State = D::State;

    fn derivative(&self, t: f64, x: &D::State) -> D::State {
        self.dynamics.derivative(t, x)
    }
}

impl<D: Series<f64>> Series<f64> for Interrupted<D> {
    fn series<const HALF: usize>(
        &self,
        begin: (f64, &D::State),
        unit: f64,
        coefficients: &mut TaylorCoefficients<D::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        self.dynamics.series(begin, unit, coefficients, memory);
    }
}

impl<D: Dynamics<f64, State = Phase<f64, 1>>> EventDynamics<f64> for Interrupted<D> {
    type Model = Self;
    type Values = [f64; 1];

    fn names(&self) -> &'static [&'static str] {
        &["interrupted"]
    }

    fn event_functions(&self, _: f64, x: &D::State) -> [f64; 1] {
        [branch(x) * (x.q[0] - self.level)]
    }

    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        _: f64,
        x: &D::State,
        _: f64,
        motion: &TaylorCoefficients<D::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<[f64; 1], HALF>> {
        let branch = branch(x);
        let mut series = TaylorCoefficients::new([branch * (x.q[0] - self.level)]);
        for (place, term) in series.higher_mut().iter_mut().zip(motion.higher()) {
            *place = [branch * term.q[0]];
        }
        Some(series)
    }
}

/// −1 on the branch in the middle.
fn branch(x: &Phase<f64, 1>) -> f64 {
    if (x.q[0] - 0.55).abs() < 0.15 {
        -1.0
    } else {
        1.0
    }
}

/// The series has no zero in the step, or one.
#[test]
fn functions_are_compared_with_their_series_in_the_middle_of_a_step() {
    let particle = Particle { m: 1.0 };
    for (level, expected) in [(2.0, &[0.4, 0.7][..]), (0.2, &[0.2, 0.4, 0.7])] {
        let dynamics = Interrupted {
            dynamics: particle.dynamics(),
            level,
        };
        let start = State::new(0.0, [0.0], [1.0]);
        let event = DeclaredEvent::<Interrupted<_>>::new(0);
        let problem = Problem::new(&dynamics, start).on(event).record();
        let motion = problem.solve(1.0, Taylor::new()).unwrap();
        let times: Vec<f64> = motion.events().iter().map(|event| event.t).collect();
        assert_eq!(times.len(), expected.len(), "{times:?}");
        for (t, expected) in times.iter().zip(expected) {
            // Jumps are located to the shortest window, 1/1024 of a step.
            assert!((t - expected).abs() < 1e-3, "{times:?}");
        }
    }
}
