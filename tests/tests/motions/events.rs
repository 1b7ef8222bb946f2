//! Declared events: under the Taylor method no root within a step is missed, under others they are sampled.

use core::f64::consts::PI;

use lagrangian::DeclaredEvent;
use lagrangian::DoubleDouble;
use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

/// Two numbers are equal to an absolute error.
#[track_caller]
fn close(found: f64, expected: f64, error: f64) {
    assert_close("the difference", &[found - expected], &[0.0], error);
}

/// A particle that moves freely along a line, with events of all kinds of functions.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    define(near = (x - place) * (x - place - apart)),
    kinetic = 0.5 * m * dot(x).powi(2),
    event(
        pair = near,
        touch = (x - place).powi(2),
        cubic = (x - place).powi(3),
        late = t - 0.75,
        wave = sin(20.0 * x),
        nothing = none * x,
        walls = [x - 0.25, 0.875 - x],
        kink = abs(x - 0.625) - 0.125,
    ),
)]
struct Particle {
    m: f64,
    none: f64,
    place: f64,
    apart: f64,
}

const PARTICLE: Particle = Particle {
    m: 2.0,
    none: 0.0,
    place: 0.3,
    apart: 1e-7,
};

/// The times of one event.
pub(crate) fn times<X>(motion: &Solution<f64, X>, event: usize) -> Vec<f64> {
    let events = motion.events().iter();
    let events = events.filter(|occurrence| occurrence.event == event);
    events.map(|occurrence| occurrence.t).collect()
}

/// The times of one event, from x = 0 at unit velocity until t = 1, in one step.
macro_rules! alone {
    ($event:ident $(.$direction:ident())?) => {{
        let motion = Problem::new(&PARTICLE, State::new(0.0, [0.0], [1.0]))
            .on(Particle::$event)
            $(.$direction())?
            .record()
            .solve(1.0, Taylor::new())
            .unwrap();
        assert_eq!(motion.statistics.steps, 1);
        times(&motion, 0)
    }};
}

#[test]
fn names_and_indices_are_constants() {
    assert_eq!(
        Particle::EVENTS,
        [
            "pair", "touch", "cubic", "late", "wave", "nothing", "walls[0]", "walls[1]", "kink"
        ]
    );
    assert_eq!(
        (
            Particle::PAIR.index(),
            Particle::WALLS.map(DeclaredEvent::index),
            Particle::KINK.index()
        ),
        (0, [6, 7], 8)
    );
    let state = State::new(0.5, [0.5_f64], [1.0]);
    let values = PARTICLE.event_functions(&state);
    close(values[Particle::WALLS[1].index()], 0.375, 1e-15);
    close(values[Particle::LATE.index()], -0.25, 1e-15);
}

#[test]
fn close_pairs_and_tangencies_within_a_step_are_found() {
    let pair = alone!(PAIR);
    assert_eq!(pair.len(), 2, "{pair:?}");
    close(pair[0], 0.3, 1e-9);
    close(pair[1], 0.3 + 1e-7, 1e-9);
    assert_eq!(alone!(PAIR.falling()).len(), 1);
    assert_eq!(alone!(PAIR.rising()).len(), 1);

    let touch = alone!(TOUCH);
    assert_eq!(touch.len(), 1);
    close(touch[0], 0.3, 1e-8);
    // Zero is reached from above.
    assert_eq!(alone!(TOUCH.falling()).len(), 1);
    assert_eq!(alone!(TOUCH.rising()).len(), 0);

    let cubic = alone!(CUBIC.rising());
    assert_eq!(cubic.len(), 1);
    close(cubic[0], 0.3, 1e-4);
    assert_eq!(alone!(NOTHING).len(), 0);
}

/// A series does not see a corner, and that of a sine does not converge over the step of a free motion.
#[test]
fn corners_and_series_that_converge_slowly_are_no_obstacle() {
    let kink = alone!(KINK);
    assert_eq!(kink.len(), 2, "{kink:?}");
    close(kink[0], 0.5, 1e-15);
    close(kink[1], 0.75, 1e-15);
    let wave = alone!(WAVE.falling());
    assert_eq!(wave.len(), 3);
    for (n, time) in [1.0, 3.0, 5.0].into_iter().zip(wave) {
        close(time, n * PI / 20.0, 1e-15);
    }
}

#[test]
fn all_events_come_in_the_order_of_time() {
    for sign in [1.0, -1.0] {
        // Backwards from x = 1 at t = 1 the same events come in the opposite order and direction.
        let (start, end) = if sign > 0.0 { (0.0, 1.0) } else { (1.0, 0.0) };
        let motion = Problem::new(&PARTICLE, State::new(start, [start], [1.0]))
            .on(Particle::WALLS[1])
            .falling()
            .record()
            .on(Particle::WAVE)
            .record()
            .on([Particle::LATE, Particle::WALLS[0]])
            .rising()
            .record()
            .on(Particle::LATE)
            .record()
            .solve(end, Taylor::new())
            .unwrap();
        let found = motion.events();
        assert!(found.is_sorted_by(|a, b| a.t * sign <= b.t * sign));
        let waves = times(&motion, 1);
        // Zero is left at the start at x = 0, and reached at the end there.
        let (first, count) = if sign > 0.0 { (1.0, 6) } else { (6.0, 7) };
        assert_eq!(waves.len(), count);
        for (n, time) in (0_u8..).map(f64::from).zip(waves) {
            let n = first + sign * n;
            close(time, n * PI / 20.0, 1e-14);
        }
        let count = |event| times(&motion, event).len();
        let directed = usize::from(sign > 0.0);
        assert_eq!(
            [count(0), count(2), count(3), count(4)],
            [directed, directed, directed, 1]
        );
        if sign > 0.0 {
            // Two of one time, in their order.
            let late: Vec<usize> = found
                .iter()
                .filter(|occurrence| [2, 4].contains(&occurrence.event))
                .map(|occurrence| occurrence.event)
                .collect();
            assert_eq!(late, [2, 4]);
            close(times(&motion, 0)[0], 0.875, 1e-15);
            close(times(&motion, 2)[0], 0.75, 1e-15);
        }
    }
}

#[test]
fn a_start_at_a_zero_is_no_event() {
    let start = State::new(0.0, [0.25], [1.0]);
    let wall = Problem::new(&PARTICLE, start).on(Particle::WALLS[0]);
    for event in [wall.clone(), wall.clone().rising(), wall.falling()] {
        let motion = event.record().solve(1.0, Taylor::new()).unwrap();
        assert!(motion.events().is_empty());
    }
}

/// A pendulum in several parametrizations of its lowest point and its turning points.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(theta),
    define(bob = l * [sin(theta), -cos(theta)], speed = dot(bob).norm_squared()),
    kinetic = 0.5 * m * speed,
    potential = m * g * bob.y,
    event(lowest = bob.x, turning = dot(theta), top = speed - fastest.powi(2)),
)]
struct Pendulum<T: Scalar = f64> {
    m: T,
    g: T,
    l: T,
    fastest: T,
}

fn pendulum() -> Pendulum {
    Pendulum {
        m: 0.3,
        g: 9.81,
        l: 0.7,
        fastest: (2.0 * 9.81 * 0.7 * (1.0 - 2.0_f64.cos())).sqrt(),
    }
}

/// 4 K(sin ½θ₀) √(l/g), by the arithmetic-geometric mean.
fn quarter(amplitude: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    0.5 * PI / a * (0.7_f64 / 9.81).sqrt()
}

fn passes<I>(method: I, error: f64)
where
    I: Copy + for<'a> Integrator<f64, lagrangian::EquationsOfMotion<&'a Pendulum, f64, 1>>,
{
    let (pendulum, quarter) = (pendulum(), quarter(2.0));
    for sign in [1.0, -1.0] {
        let motion = Problem::new(&pendulum, State::new(0.0, [2.0], [0.0]))
            .on([Pendulum::<f64>::LOWEST, Pendulum::<f64>::TURNING])
            .record()
            .solve(sign * 40.5 * quarter, method)
            .unwrap();
        for (event, first, count) in [(0, 1.0, 20), (1, 2.0, 20)] {
            let found = times(&motion, event);
            assert_eq!(found.len(), count);
            for (n, time) in (0..).map(f64::from).zip(found) {
                close(time, sign * (first + 2.0 * n) * quarter, error);
            }
        }
    }
}

#[test]
fn every_method_finds_the_passes_of_a_pendulum() {
    passes(Taylor::new(), 1e-12);
    passes(Taylor::order_16(), 1e-9);
    passes(Dop853::new(), 1e-6);
    passes(RungeKutta::classical(1e-3), 1e-6);
}

/// The largest speed is reached and not exceeded: a tangency, which rounding of the motion moves to either side.
#[test]
fn the_greatest_speed_of_a_pendulum_is_a_tangency() {
    let (pendulum, quarter) = (pendulum(), quarter(2.0));
    let start = State::new(0.0, [2.0], [0.0]);
    let motion = |fastest| {
        let pendulum = Pendulum {
            fastest,
            ..pendulum.clone()
        };
        let problem = Problem::new(&pendulum, start).on(Pendulum::TOP);
        problem.record().solve(6.0 * quarter, Taylor::new())
    };
    let slower = motion(pendulum.fastest * (1.0 - 1e-12)).unwrap();
    assert_eq!(slower.events().len(), 6);
    for (n, occurrence) in slower.events().iter().enumerate() {
        let expected = [1.0, 1.0, 3.0, 3.0, 5.0, 5.0][n] * quarter;
        close(occurrence.t, expected, 1e-5);
    }
    let faster = motion(pendulum.fastest * (1.0 + 1e-12)).unwrap();
    assert!(faster.events().is_empty());
}

#[test]
fn events_are_found_on_other_scalars() {
    let number = |x: f64| DoubleDouble::from(x);
    let precise = Pendulum {
        m: number(0.3),
        g: number(9.81),
        l: number(0.7),
        fastest: number(100.0),
    };
    let start = State::new(number(0.0), [number(2.0)], [number(0.0)]);
    let lowest = Problem::new(&precise, start).on(Pendulum::LOWEST);
    let end = lowest.falling().stop().solve(10.0, Taylor::order_40());
    let end = end.unwrap();
    close(end.t.to_f64(), quarter(2.0), 1e-15);
    assert!(end.q[0].to_f64().abs() < 1e-15);

    let coarse = Pendulum::<f32> {
        m: 0.3,
        g: 9.81,
        l: 0.7,
        fastest: 100.0,
    };
    let start = State::new(0.0_f32, [2.0], [0.0]);
    let lowest = Problem::new(&coarse, start).on(Pendulum::LOWEST);
    let end = lowest.falling().stop().solve(10.0, Taylor::order_12());
    close(f64::from(end.unwrap().t), quarter(2.0), 1e-5);
}

/// A ball on a floor at any height: flights are followed until they are as short as the resolution of time.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(y),
    kinetic = 0.5 * m * dot(y).powi(2),
    potential = m * g * y,
    event(floor = y - height),
)]
struct Ball {
    m: f64,
    g: f64,
    height: f64,
}

#[test]
fn a_ball_bounces_until_it_is_at_rest() {
    for height in [0.0, 0.1, 100.1, -1e4] {
        for (is_falling, restitution) in [(true, 0.5), (false, 0.5), (true, 0.9), (true, 0.1)] {
            let ball = Ball {
                m: 0.2,
                g: 9.81,
                height,
            };
            let start = State::new(0.0, [height + 1.0], [0.0]);
            let floor = Problem::new(&ball, start).on(Ball::FLOOR);
            let floor = if is_falling { floor.falling() } else { floor };
            let motion = floor
                .then(|ball| ball.v[0] *= -restitution)
                .solve(100.0, Taylor::new())
                .unwrap();
            assert_eq!(motion.reason, StopReason::Zeno, "{height} {restitution}");
            let fall = (2.0 / ball.g).sqrt();
            let rest = fall * (1.0 + 2.0 * restitution / (1.0 - restitution));
            // The height from which it falls is rounded.
            let rounding = 4.0 * f64::EPSILON * (height.abs() + 1.0);
            close(motion.t, rest, 1e-8 + rounding * 10.0);
            close(motion.q[0], height, 100.0 * rounding);
            let (mut expected, mut flight) = (fall, 2.0 * fall);
            for time in times(&motion, 0).into_iter().take(20) {
                close(time, expected, 1e-13 + 10.0 * rounding);
                flight *= restitution;
                expected += flight;
            }
        }
    }
}

/// Ball and floor both change: the floor sinks with each bounce, which the event function sees.
#[test]
fn a_reaction_changes_the_model_and_its_events() {
    let ball = Ball {
        m: 0.2,
        g: 9.81,
        height: 0.0,
    };
    let start = State::new(0.0, [1.0], [0.0]);
    let mut run = Problem::new(ball, start)
        .on(Ball::FLOOR)
        .falling()
        .then_with(|x, ball| {
            x.v[0] = 0.0;
            ball.change(|ball| ball.height -= 1.0);
        })
        .start(Taylor::new())
        .unwrap();
    let motion = run.advance(2.0).unwrap();
    let fall = (2.0 / 9.81_f64).sqrt();
    for (n, time) in (1..).map(f64::from).zip(times(&motion, 0)) {
        close(time, n * fall, 1e-14);
    }
    assert_eq!(motion.events().len(), 4);
    close(run.dynamics().model().height, -4.0, 1e-15);
}

/// Roots at the end of a step and behind the middle of the next one.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    event(twice = (t - first) * (t - second)),
)]
struct Twice {
    first: f64,
    second: f64,
}

#[test]
fn roots_after_one_at_the_end_of_a_step_are_found() {
    for second in [100.06, 100.09, 100.12] {
        let model = Twice {
            first: 100.0 - 1e-12,
            second,
        };
        let motion = Problem::new(&model, State::new(99.0, [0.0], [1.0]))
            .on(Twice::TWICE)
            .record()
            .solve(101.0, Taylor::new().max_step(0.125))
            .unwrap();
        let found = times(&motion, 0);
        assert_eq!(found.len(), 2, "{second}: {found:?}");
        close(found[0], 100.0, 2e-12);
        close(found[1], second, 1e-12);
    }
}
