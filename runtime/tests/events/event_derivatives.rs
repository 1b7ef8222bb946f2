//! Derivatives of event times, and of motions through impacts, against closed forms and differences.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Dual, EquationsOfMotion, SingleNumber};

#[track_caller]
fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= tolerance * expected.abs().max(1.0),
        "{what}: {found} is not {expected}: {error:e}"
    );
}

/// A ball above a floor that rises at a constant speed.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(y),
    kinetic = 0.5 * m * dot(y).powi(2),
    potential = m * g * y,
    event(floor = y - rise * t, graze = (y - top).powi(2), limit = y - top),
)]
struct Ball<T: Scalar> {
    m: T,
    g: T,
    rise: T,
    top: T,
}

/// Height, gravity, restitution, speed of the floor.
const BALL: [f64; 4] = [1.3, 9.81, 0.7, 0.05];

/// The times of two impacts and the state at a time behind them, in the frame of the floor, in closed form.
fn bounces<T: Scalar>([height, g, restitution, rise]: [T; 4], end: f64) -> [T; 4] {
    let number = T::from_f64;
    // Above the floor: height − rise t − ½ g t².
    let first = ((rise * rise + number(2.0) * g * height).sqrt() - rise) / g;
    let up = (g * first + rise) * restitution;
    let flight = number(2.0) * up / g;
    let again = up * restitution;
    let rest = number(end) - first - flight;
    let above = again * rest - number(0.5) * g * rest * rest;
    [
        first,
        first + flight,
        above + rise * number(end),
        again - g * rest + rise,
    ]
}

/// How the floor is watched for: as the event that the model declares, as a function, or as one of several functions.
#[derive(Clone, Copy)]
enum Floor {
    Declared,
    Function,
    Functions,
}

/// The times of two impacts and the state at a time behind them, by integration.
fn integrated<T, I>(method: I, floor: Floor, parameters: [T; 4], end: f64) -> [T; 4]
where
    T: SingleNumber,
    I: for<'a> Integrator<T, EquationsOfMotion<&'a Ball<T>, T, 1>>,
{
    let [height, g, restitution, rise] = parameters;
    let ball = Ball {
        m: T::from_f64(0.4),
        g,
        rise,
        top: height,
    };
    let zero = T::from_f64(0.0);
    let problem = Problem::new(&ball, State::new(zero, [height], [zero]));
    let above = |x: &State<T, 1>| x.q[0] - rise * x.t;
    let bounce = |x: &mut State<T, 1>| x.v[0] = rise - restitution * (x.v[0] - rise);
    let motion = match floor {
        Floor::Declared => {
            let problem = problem.on(Ball::FLOOR).falling().then(bounce);
            problem.solve(end, method)
        }
        Floor::Function => {
            let problem = problem.when(above).falling().then(bounce);
            problem.solve(end, method)
        }
        Floor::Functions => {
            let problem = problem.when(|x| [above(x), x.q[0] - height - height]);
            problem.falling().then(bounce).solve(end, method)
        }
    };
    let motion = motion.unwrap();
    let [first, second] = motion.events() else {
        panic!("{} impacts", motion.events().len());
    };
    [first.t, second.t, motion.q[0], motion.v[0]]
}

const END: f64 = 1.5;

#[test]
fn a_bouncing_ball_has_the_gradient_of_its_closed_form() {
    let parameters = Dual::variables(BALL);
    let expected = bounces(parameters, END);
    let (taylor, dop853) = (Taylor::new(), Dop853::new());
    let classical = RungeKutta::classical(1e-3);
    let (declared, function, functions) = (Floor::Declared, Floor::Function, Floor::Functions);
    macro_rules! case {
        ($name:literal, $method:expr, $floor:expr, $tolerance:literal) => {
            (
                $name,
                integrated($method, $floor, parameters, END),
                $tolerance,
            )
        };
    }
    let methods = [
        case!("Taylor", taylor, declared, 1e-12),
        case!("DOP853", dop853, declared, 1e-9),
        case!("Runge-Kutta", classical, declared, 1e-9),
        case!("Taylor, a function", taylor, function, 1e-12),
        case!("Taylor, functions", taylor, functions, 1e-12),
        case!("DOP853, a function", dop853, function, 1e-9),
        case!("Runge-Kutta, functions", classical, functions, 1e-9),
    ];
    for (name, found, tolerance) in methods {
        for (found, expected) in found.iter().zip(&expected) {
            close(name, found.value, expected.value, tolerance);
            for part in 0..4 {
                let [found, expected] = [found, expected].map(|x| x.derivative_part(part));
                close(name, found, expected, tolerance);
            }
        }
    }
}

#[test]
fn a_bouncing_ball_has_second_derivatives() {
    for moving in 0..4 {
        let mut parameters = BALL.map(Dual::<Dual>::from_f64);
        parameters[moving] = Dual::variable(Dual::variable(BALL[moving], 0), 0);
        let expected = bounces(parameters, END);
        let declared = integrated(Taylor::new(), Floor::Declared, parameters, END);
        let given = integrated(Taylor::new(), Floor::Function, parameters, END);
        let pairs = declared.iter().zip(&expected);
        for (found, expected) in pairs.chain(given.iter().zip(&expected)) {
            for part in 0..3 {
                let [found, expected] = [found, expected].map(|x| x.derivative_part(part));
                close("a derivative", found, expected, 1e-10);
            }
        }
    }
}

/// The time of an event has the digits of the scalar, which times of a stepper do not have.
#[test]
fn events_have_the_digits_of_double_doubles() {
    let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
    let parameters = BALL.map(|value| DoubleDouble::from(value) + third);
    let expected = bounces(parameters, 2.5);
    let declared = integrated(Taylor::order_40(), Floor::Declared, parameters, 2.5);
    let given = integrated(Taylor::order_40(), Floor::Function, parameters, 2.5);
    let pairs = declared.into_iter().zip(expected);
    for (found, expected) in pairs.chain(given.into_iter().zip(expected)) {
        let error = (found - expected).to_f64().abs();
        assert!(error < 1e-28, "{error:e}");
    }
    assert!((expected[0] - DoubleDouble::from(expected[0].to_f64())).to_f64() != 0.0);
}

/// Where a height is reached without being crossed, its time has no derivative.
#[test]
fn a_time_without_a_derivative_is_not_a_number_in_disguise() {
    let number = Dual::constant;
    let ball = Ball {
        m: number(0.4),
        g: number(8.0),
        rise: number(0.0),
        top: Dual::variable(1.0, 0),
    };
    let start = State::new(number(0.0), [number(0.0)], [number(4.0)]);
    let limit = Problem::new(&ball, start).on(Ball::LIMIT).stop();
    let touched = limit.solve(1.0, Taylor::new()).unwrap();
    assert_eq!(touched.events().len(), 1);
    let time = touched.events()[0].t;
    close("the apex", time.value, 0.5, 1e-7);
    let [slope] = time.derivative;
    let is_endless = slope.is_nan() || slope.abs() >= 1e100;
    assert!(is_endless, "{slope}");
}

/// A pendulum that bounces off a wall at an angle, whose restitution acts on its velocity.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    define(bob = l * [sin(theta), -cos(theta)]),
    kinetic = 0.5 * m * dot(bob).norm_squared(),
    potential = m * g * bob.y,
    event(wall = bob.x - place),
)]
struct Pendulum<T: Scalar> {
    m: T,
    l: T,
    g: T,
    place: T,
}

/// Initial angle, length, place of the wall, restitution.
const PENDULUM: [f64; 4] = [1.2, 0.9, -0.1, 0.8];

/// The times of the first three impacts, and the state at the end.
fn swings<T: SingleNumber>([theta, l, place, restitution]: [T; 4]) -> [T; 5]
where
    for<'a> Taylor: Integrator<T, lagrangian::EquationsOfMotion<&'a Pendulum<T>, T, 1>>,
{
    let number = T::from_f64;
    let pendulum = Pendulum {
        m: number(0.5),
        l,
        g: number(9.81),
        place,
    };
    let start = State::new(number(0.0), [theta], [number(0.0)]);
    let wall = Problem::new(&pendulum, start).on(Pendulum::WALL);
    let bouncing = wall.falling().then(|x| x.v[0] = -(x.v[0] * restitution));
    let motion = bouncing.solve(4.0, Taylor::new()).unwrap();
    let events = motion.events();
    assert!(events.len() >= 3);
    [
        events[0].t,
        events[1].t,
        events[2].t,
        motion.q[0],
        motion.v[0],
    ]
}

/// Differences with an error of the fourth order of the step.
fn differences<const N: usize, const R: usize>(
    at: [f64; N],
    moving: usize,
    function: impl Fn([f64; N]) -> [f64; R],
) -> [f64; R] {
    let step = 1e-3;
    let there = |parts: f64| {
        let mut moved = at;
        moved[moving] += parts * step;
        function(moved)
    };
    let [one, two, back, far_back] = [1.0, 2.0, -1.0, -2.0].map(there);
    core::array::from_fn(|i| (8.0 * (one[i] - back[i]) - (two[i] - far_back[i])) / (12.0 * step))
}

#[test]
fn a_bouncing_pendulum_has_the_gradient_of_differences() {
    for moving in 0..4 {
        let mut parameters: [Dual; 4] = PENDULUM.map(Dual::constant);
        parameters[moving] = Dual::variable(PENDULUM[moving], 0);
        let found = swings(parameters);
        let expected = differences(PENDULUM, moving, swings);
        assert!(expected.iter().any(|expected| expected.abs() > 0.1));
        for (found, expected) in found.iter().zip(expected) {
            close("a derivative", found.derivative[0], expected, 1e-7);
        }
    }
}

/// Newton's cradle: two balls fall on three, so that impacts follow each other within the small gaps.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta[5]),
    kinetic = (0..5).map(|i| 0.5 * m[i] * (l * dot(theta[i])).powi(2)).sum(),
    potential = (0..5).map(|i| -m[i] * g * l * cos(theta[i])).sum(),
    event(contact = (0..4).map(|i| theta[i + 1] - theta[i] + gap).collect()),
)]
struct Cradle<T: Scalar> {
    m: [T; 5],
    l: T,
    g: T,
    gap: T,
}

/// First angles of two balls, mass of the last ball, gap, length.
const CRADLE: [f64; 5] = [-0.5, -0.45, 0.12, 0.01, 0.25];

/// The number of impacts, the time of the last, and the state at the end.
fn impacts<T: SingleNumber>([first, second, mass, gap, l]: [T; 5]) -> (usize, [T; 11])
where
    for<'a> Taylor: Integrator<T, lagrangian::EquationsOfMotion<&'a Cradle<T>, T, 5>>,
{
    let number = T::from_f64;
    let mut m = [number(0.1); 5];
    m[4] = mass;
    let cradle = Cradle {
        m,
        l,
        g: number(9.81),
        gap,
    };
    let zero = number(0.0);
    let start = State::new(zero, [first, second, zero, zero, zero], [zero; 5]);
    let collide = |i: usize| {
        move |x: &mut State<T, 5>| {
            let (u, v) = (x.v[i], x.v[i + 1]);
            let sum = m[i] + m[i + 1];
            let mean = (m[i] * u + m[i + 1] * v) / sum;
            x.v[i] = mean + mean - u;
            x.v[i + 1] = mean + mean - v;
        }
    };
    macro_rules! cradle {
        ($($i:literal)*) => {
            Problem::new(&cradle, start)
                $(.on(Cradle::CONTACT[$i]).falling().then(collide($i)))*
        };
    }
    let motion = cradle!(0 1 2 3).solve(0.9, Taylor::new()).unwrap();
    let mut found = [zero; 11];
    found[0] = motion.events()[motion.events().len() - 1].t;
    for i in 0..5 {
        found[1 + i] = motion.q[i];
        found[6 + i] = motion.v[i];
    }
    (motion.events().len(), found)
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn newtons_cradle_has_the_gradient_of_differences() {
    compare_with_differences(1);
}

#[test]
fn newtons_cradle_has_some_derivatives_of_differences() {
    compare_with_differences(3);
}

/// Along one parameter of so many.
fn compare_with_differences(stride: usize) {
    for moving in (0..5).step_by(stride) {
        let mut parameters: [Dual; 5] = CRADLE.map(Dual::constant);
        parameters[moving] = Dual::variable(CRADLE[moving], 0);
        let (count, found) = impacts(parameters);
        assert!(count >= 4, "{count} impacts");
        let step = 1e-5;
        let there = |parts: f64| {
            let mut moved = CRADLE;
            moved[moving] += parts * step;
            let (other, found) = impacts(moved);
            assert_eq!(other, count);
            found
        };
        let [one, two, back, far_back] = [1.0, 2.0, -1.0, -2.0].map(there);
        for i in 0..11 {
            let expected = (8.0 * (one[i] - back[i]) - (two[i] - far_back[i])) / (12.0 * step);
            close("a derivative", found[i].derivative[0], expected, 1e-6);
        }
    }
}
