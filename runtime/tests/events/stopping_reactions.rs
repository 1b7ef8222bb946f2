//! Where an integration stops at an event, the reactions to it take place all the same, and a run goes on from behind them.

use core::ops::ControlFlow;

use lagrangian::EquationsOfMotion;
use lagrangian::prelude::*;

/// A stone that falls from a height of 5 for 1 s, and is then thrown up again at 10.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = g * x,
    event(floor = x),
)]
struct Stone {
    g: f64,
}

const STONE: Stone = Stone { g: 10.0 };

fn start() -> State<f64, 1> {
    State::new(0.0, [5.0], [0.0])
}

/// Where it is half a second after the throw.
const RISEN: f64 = 3.75;

/// Runs a problem that stops on the floor, and on from there.
macro_rules! bounces {
    ($method:expr, $tolerance:expr, $problem:expr) => {{
        let mut run = $problem.start($method).unwrap();
        let floor = run.advance(3.0).unwrap();
        assert!((floor.t - 1.0).abs() < $tolerance, "{}", floor.t);
        assert!((floor.v[0] - 10.0).abs() < $tolerance, "{}", floor.v[0]);
        assert_eq!(run.state(), floor.last);
        let risen = run.advance(1.5).unwrap();
        assert_eq!(risen.events().len(), 0);
        assert!(
            (risen.q[0] - RISEN).abs() < 10.0 * $tolerance,
            "{}",
            risen.q[0]
        );
        floor
    }};
}

fn reactions_take_place<I>(method: I, tolerance: f64)
where
    I: Copy + for<'a> Integrator<f64, EquationsOfMotion<&'a Stone, f64, 1>>,
    I: Integrator<f64, EquationsOfMotion<Stone, f64, 1>>,
{
    let falling = || Problem::new(&STONE, start()).on(Stone::FLOOR).falling();
    // The reaction stops.
    let stops = falling().then(|x| {
        x.v[0] = -x.v[0];
        ControlFlow::Break(())
    });
    let end = bounces!(method, tolerance, stops);
    assert_eq!(end.reason, StopReason::Condition);
    // An observer stops at the event.
    let observed = falling().then(|x| x.v[0] = -x.v[0]).each_step(|progress| {
        if progress.kind == ObservationKind::Event(0) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    let end = bounces!(method, tolerance, observed);
    assert_eq!(end.reason, StopReason::Observer);
    assert!(end.met.contains(0));
    // Another event stops there.
    let both = falling().then(|x| x.v[0] = -x.v[0]);
    let end = bounces!(method, tolerance, both.when(|x| x.q[0]).stop());
    assert_eq!(end.reason, StopReason::Condition);
    assert!(end.met.contains(1));
    // The stone flies straight up once it is a bird.
    let owned = Problem::new(STONE.clone().into_dynamics(), start());
    let bird = owned.on(Stone::FLOOR).falling().then_with(|x, stone| {
        x.v[0] = RISEN / 0.5;
        stone.change(|stone| stone.g = 0.0);
        ControlFlow::Break(())
    });
    let mut run = bird.start(method).unwrap();
    run.advance(3.0).unwrap();
    let risen = run.advance(1.5).unwrap();
    assert!(
        (risen.q[0] - RISEN).abs() < 10.0 * tolerance,
        "{}",
        risen.q[0]
    );
}

#[test]
fn reactions_take_place_where_an_integration_stops() {
    reactions_take_place(Taylor::new(), 1e-13);
    reactions_take_place(Dop853::new(), 1e-8);
    reactions_take_place(RungeKutta::classical(0.1), 1e-12);
    // The event is at the end of a step.
    reactions_take_place(RungeKutta::classical(0.125), 1e-12);
}
