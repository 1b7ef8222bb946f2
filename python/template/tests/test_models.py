"""What a user of the module expects of it: `pip install . pytest`, then `pytest`."""

import inspect
import os
import pickle
import signal
import threading
import time
from concurrent.futures import ProcessPoolExecutor

import mechanisms
import numpy as np
import pytest
from mechanisms import Ball, CartPole, IntegrationError, RodPendulum, Top

BALL = Ball(m=0.1, g=10.0)
CART = CartPole(cart=1.0, pole=0.1, l=0.5, g=9.81)


def test_a_motion_is_arrays():
    motion = BALL.integrate(q=[0.0, 5.0], v=[2.0, 0.0], until=0.5, samples=6)
    assert motion.reason == "completed"
    np.testing.assert_allclose(motion.t, np.linspace(0.0, 0.5, 6))
    np.testing.assert_allclose(motion.q[:, 0], 2.0 * motion.t, atol=1e-14)
    np.testing.assert_allclose(motion.q[:, 1], 5.0 - 5.0 * motion.t**2, atol=1e-14)
    np.testing.assert_allclose(motion.v[:, 1], -10.0 * motion.t, atol=1e-14)
    assert motion.end.t == 0.5


def test_a_motion_stops_at_an_event():
    motion = BALL.integrate(q=[0.0, 5.0], v=[0.0, 0.0], until=9.0, stop={"floor": "falling"})
    assert motion.reason == "event"
    assert motion.end.t == pytest.approx(1.0, abs=1e-14)
    (event,) = motion.events
    assert (event.name, event.direction) == ("floor", "falling")
    np.testing.assert_allclose(event.v, [0.0, -10.0], atol=1e-13)


def test_events_are_recorded():
    motion = BALL.integrate(q=[0.0, 0.0], v=[0.0, 10.0], until=4.0, record="floor")
    assert [(event.direction) for event in motion.events][-1] == "falling"
    assert motion.end.t == 4.0
    falling = BALL.integrate(q=[0.0, -5.0], v=[0.0, 20.0], until=4.0, record={"floor": "falling"})
    assert [event.direction for event in falling.events] == ["falling"]
    both = BALL.integrate(q=[0.0, -5.0], v=[0.0, 20.0], until=4.0, record=["floor"])
    assert [event.direction for event in both.events] == ["rising", "falling"]


@pytest.mark.parametrize("method, step", [("taylor", None), ("dop853", None), ("runge_kutta", 1e-3)])
def test_methods_agree(method, step):
    motion = CART.integrate(q=[0.0, 3.0], v=[0.0, 0.0], until=2.0, method=method, step=step)
    reference = CART.integrate(q=[0.0, 3.0], v=[0.0, 0.0], until=2.0, tolerance=1e-15)
    np.testing.assert_allclose(motion.end.q, reference.end.q, atol=1e-7)


def test_quantities_of_one_state_and_of_many():
    rng = np.random.default_rng(1)
    q, v = rng.normal(size=(2, 50, 2))
    u = rng.normal(size=(50, 1))
    accelerations = CART.accelerations(q, v, u=u)
    assert accelerations.shape == (50, 2)
    for i in range(50):
        alone = CART.replace(push=u[i, 0])
        np.testing.assert_array_equal(alone.accelerations(q[i], v[i]), accelerations[i])
        # M q̈ − f = 0, and the energy is T + V.
        forcing = alone.forcing(q[i], v[i])
        np.testing.assert_allclose(alone.mass_matrix(q[i], v[i]) @ accelerations[i], forcing, atol=1e-12)
        energy = alone.kinetic_energy(q[i], v[i]) + alone.potential_energy(q[i], v[i])
        assert alone.energy(q[i], v[i]) == pytest.approx(energy, abs=1e-13)
    assert CART.outputs(q, v)["tip"].shape == (50, 2)
    assert isinstance(CART.energy([0.0, 0.0], [0.0, 0.0]), float)
    residuals = CART.inverse_dynamics(q, v, accelerations, u=u)
    np.testing.assert_allclose(residuals, 0.0, atol=1e-12)


def test_the_linear_model_is_that_of_differences():
    q, v = np.array([0.2, 0.3]), np.array([0.1, -0.4])
    a, b = CART.linearize(q, v)
    assert a.shape == (4, 4) and b.shape == (4, 1)

    def derivative(x, u):
        return np.concatenate([x[2:], CART.accelerations(x[:2], x[2:], u=[u])])

    x, h = np.concatenate([q, v]), 1e-6
    for column in range(4):
        change = np.zeros(4)
        change[column] = h
        slope = (derivative(x + change, 0.0) - derivative(x - change, 0.0)) / (2 * h)
        np.testing.assert_allclose(a[:, column], slope, atol=1e-7)
    slope = (derivative(x, h) - derivative(x, -h)) / (2 * h)
    np.testing.assert_allclose(b[:, 0], slope, atol=1e-7)


def test_feedback_balances_the_pole():
    def law(t, q, v):
        return 1.0 * q[0] + 30.0 * q[1] + 2.0 * v[0] + 6.0 * v[1]

    motion = CART.integrate(q=[0.0, 0.1], v=[0.0, 0.0], until=20.0, feedback=law)
    np.testing.assert_allclose(motion.end.q, 0.0, atol=1e-3)
    held = CART.integrate(q=[0.0, 0.1], v=[0.0, 0.0], until=20.0, feedback=law, period=0.01)
    np.testing.assert_allclose(held.end.q, 0.0, atol=1e-3)
    assert held.end.q[0] != motion.end.q[0]


def test_members_of_an_ensemble_are_single_motions():
    lengths = np.linspace(0.3, 0.8, 20)
    starts = np.column_stack([np.zeros(20), np.linspace(2.0, 3.0, 20)])
    motions = CART.ensemble(
        q=starts, v=[0.0, 0.0], until=3.0, parameters={"l": lengths}, samples=7
    )
    assert motions.q.shape == (20, 7, 2) and len(motions) == 20 and not motions.errors
    for i in (0, 7, 19):
        alone = CART.replace(l=lengths[i]).integrate(q=starts[i], v=[0.0, 0.0], until=3.0, samples=7)
        np.testing.assert_allclose(motions.q[i], alone.q, atol=1e-11)
    one = CART.ensemble(
        q=starts, v=[0.0, 0.0], until=3.0, parameters={"l": lengths}, samples=7, threads=1
    )
    np.testing.assert_array_equal(one.q, motions.q)


def test_members_stop_at_events():
    heights = np.array([1.25, 5.0, 20.0])
    starts = np.column_stack([np.zeros(3), heights])
    motions = BALL.ensemble(q=starts, v=[0.0, 0.0], until=9.0, samples=10, stop="floor")
    np.testing.assert_allclose(motions.end_t, np.sqrt(heights / 5.0), atol=1e-13)
    # What lies behind the end is missing.
    assert np.isnan(motions.q[0, 1:, 0]).all() and not np.isnan(motions.q[:, 0]).any()
    assert [event.name for event in motions.events[1]] == ["floor"]


def test_bodies_are_tuples():
    top = Top(body=(0.5, 0.04, 4e-4, 3e-4), g=9.81)
    start = dict(q=[0.0, 0.6, 0.0], v=[0.0, 0.0, 200.0])
    motion = top.integrate(**start, until=1.0, samples=11)
    energies = top.energy(motion.q, motion.v)
    np.testing.assert_allclose(energies, energies[0], rtol=1e-13)
    momenta = top.momenta(motion.q, motion.v)
    np.testing.assert_allclose(momenta[:, [0, 2]], momenta[0, [0, 2]] * np.ones((11, 1)), atol=1e-14)
    with pytest.raises(ValueError, match="body is a body: write .*axial moment"):
        Top(body=1.0, g=9.81)
    with pytest.raises(ValueError, match="the mass"):
        Top(body=(-0.5, 0.04, 4e-4, 3e-4), g=9.81)


def test_constraints_hold():
    rod = RodPendulum(m=2.0, l=1.0, g=9.81)
    q, v = rod.assemble([0.9, -0.9], [0.5, 0.5])
    assert np.hypot(*q) == pytest.approx(1.0, abs=1e-14)
    motion = rod.integrate(q, v, until=10.0, samples=101)
    np.testing.assert_allclose(np.hypot(*motion.q.T), 1.0, atol=1e-12)
    # At the lowest point the rod carries the weight and the centripetal force.
    (tension,) = rod.multipliers([0.0, -1.0], [3.0, 0.0])
    assert tension == pytest.approx(-2.0 * (9.81 + 9.0))
    with pytest.raises(ValueError, match="RodPendulum has constraints"):
        rod.linearize(q, v)
    with pytest.raises(IntegrationError, match="rod"):
        rod.integrate([2.0, 0.0], [0.0, 0.0], until=1.0)


def test_parameters_and_help():
    assert CART.l == 0.5 and CART.push == 0.0
    assert CART.replace(l=0.7).parameters["l"] == 0.7
    assert repr(BALL) == "Ball(m=0.1, g=10.0)"
    assert Ball.COORDINATES == ("x", "y") and CartPole.INPUTS == ("push",)
    assert list(inspect.signature(CartPole).parameters) == list(CartPole.PARAMETERS)
    assert "The mass of the cart in kg." in CartPole.__doc__
    assert "motor pushes" in CartPole.__doc__ and "d/dt" in CartPole.__doc__
    assert "\\frac" in CartPole.LATEX
    assert mechanisms.__doc__.startswith("Mechanical systems")
    copy = pickle.loads(pickle.dumps(CART))
    assert type(copy) is CartPole and copy.parameters == CART.parameters


def refuses(exception, words, function, *args, **named):
    with pytest.raises(exception, match=words):
        function(*args, **named)


def test_mistakes_have_names():
    refuses(TypeError, "CartPole needs the parameter pole: The mass at the tip", CartPole, cart=1.0)
    refuses(TypeError, "Ball has no parameter mass: its parameters are m, g", Ball, mass=1.0)
    refuses(ValueError, "m contains NaN", Ball, m=float("nan"), g=10.0)
    refuses(ValueError, r"m has the shape \(2,\), but \(\) is needed", Ball, m=[1.0, 2.0], g=10.0)
    refuses(ValueError, "g is not an array of numbers: its elements are", Ball, m=1.0, g="heavy")
    refuses(ValueError, r"q has the shape \(3,\), but Ball has the coordinates x, y", BALL.energy, [0.0] * 3, [0.0] * 3)
    refuses(ValueError, r"v has the shape \(3,\), but \(2,\) is needed", BALL.energy, [0.0] * 2, [0.0] * 3)
    refuses(ValueError, "q contains NaN", BALL.energy, [np.nan, 0.0], [0.0, 0.0])
    refuses(ValueError, "Ball has no inputs", BALL.accelerations, [0.0] * 2, [0.0] * 2, u=[1.0])
    refuses(ValueError, r"u has the shape \(2,\), but CartPole has the inputs push", CART.accelerations, [0.0] * 2, [0.0] * 2, u=[1.0, 2.0])
    start = dict(q=[0.0, 5.0], v=[0.0, 0.0], until=1.0)
    refuses(ValueError, "stop: Ball has no event flor; its events are floor", BALL.integrate, **start, stop="flor")
    refuses(ValueError, "direction of floor", BALL.integrate, **start, record={"floor": "down"})
    refuses(ValueError, "method euler is not known", BALL.integrate, **start, method="euler")
    refuses(ValueError, "runge_kutta has a fixed step", BALL.integrate, **start, method="runge_kutta")
    refuses(ValueError, "no inputs that a feedback could set", BALL.integrate, **start, feedback=lambda t, q, v: 0.0)
    refuses(ValueError, "RodPendulum has no Taylor series", RodPendulum(m=1.0, l=1.0, g=1.0).integrate, [1.0, 0.0], [0.0, 0.0], 1.0, method="taylor")
    refuses(ValueError, "a function of Python has no Taylor series", CART.integrate, **start, method="taylor", feedback=lambda t, q, v: 0.0)
    refuses(ValueError, "until is NaN", BALL.integrate, [0.0, 5.0], [0.0, 0.0], until=float("nan"))
    refuses(ValueError, "q is a list of states", BALL.integrate, [[0.0, 5.0]], [[0.0, 0.0]], until=1.0)
    refuses(ValueError, "more than one member", BALL.ensemble, **start)
    refuses(ValueError, "q has 2 members, but m has 3", BALL.ensemble, [[0.0, 5.0]] * 2, [0.0, 0.0], 1.0, parameters={"m": [1.0, 2.0, 3.0]})
    refuses(TypeError, "Model is the base class", mechanisms.Model)
    refuses(AttributeError, "no attribute 'height'", getattr, BALL, "height")
    refuses(TypeError, "Ball takes its parameters by keyword: m, g", Ball, 1.0, 2.0)
    refuses(ValueError, "its elements are", Ball, m="2", g=1.0)
    refuses(ValueError, "its elements are complex", BALL.energy, [1j, 0.0], [0.0, 0.0])
    refuses(ValueError, "some elements are masked", BALL.energy, np.ma.array([1.0, 2.0], mask=[True, False]), [0.0, 0.0])
    refuses(ValueError, "it is None", CART.integrate, [0.0, 0.1], [0.0, 0.0], 1.0, feedback=lambda t, q, v: None)
    refuses(ValueError, "samples is a number from 2", BALL.integrate, **start, samples=10**12)
    refuses(ValueError, "2 comes after 0.5", BALL.ensemble, [[0.0, 5.0]] * 2, [0.0, 0.0], 1.0, samples=[0.5, 2.0])
    refuses(ValueError, "0.2 comes after 0.5", BALL.integrate, **start, samples=[0.5, 0.2])
    refuses(ValueError, "tolerance is positive, not -1", BALL.ensemble, [[0.0, 5.0]] * 2, [0.0, 0.0], 1.0, tolerance=-1.0)
    refuses(ValueError, "parameters: m is an array with a value for each member", BALL.ensemble, **start, parameters={"m": 3.0})
    refuses(ValueError, "parameters: Ball has no parameter mass; its parameters are m, g", BALL.ensemble, **start, parameters={"mass": [3.0]})
    refuses(ValueError, "stop is the name of an event", BALL.integrate, **start, stop=True)


def test_models_are_values():
    ball = Ball(m=0.1, g=10.0)
    assert ball == BALL and hash(ball) == hash(BALL) and ball != Ball(m=0.2, g=10.0)
    assert {"m", "g"} <= set(dir(ball)) and Ball.m.__doc__ == "The mass in kg."
    refuses(AttributeError, "no setter", setattr, ball, "g", 1.62)
    refuses(AttributeError, "no attribute", setattr, ball, "gravity", 1.62)
    motion = ball.integrate([0.0, 5.0], [0.0, 0.0], 1.0)
    assert motion.q is motion.q
    refuses(ValueError, "read-only", motion.q.__setitem__, 0, 0.0)


def fall(height):
    return BALL.integrate([0.0, height], [0.0, 0.0], 9.0, samples=4, stop="floor")


def break_down(_):
    CART.integrate([0.0, 0.1], [0.0, 0.0], 1.0, feedback=lambda t, q, v: np.inf)


def test_motions_and_errors_leave_a_process():
    with ProcessPoolExecutor(2) as pool:
        for height, motion in zip([1.25, 5.0], pool.map(fall, [1.25, 5.0])):
            here = fall(height)
            np.testing.assert_array_equal(motion.q, here.q)
            np.testing.assert_array_equal(motion.t, here.t)
            assert motion.end.t == here.end.t and motion.reason == "event"
            assert repr(motion.events) == repr(here.events)
        with pytest.raises(IntegrationError, match="velocity of x is inf at t = 0"):
            list(pool.map(break_down, [0]))
    motions = BALL.ensemble([[0.0, 5.0], [0.0, 6.0]], [0.0, 0.0], 1.0, samples=3, record="floor")
    again = pickle.loads(pickle.dumps(motions))
    np.testing.assert_array_equal(again.q, motions.q)
    np.testing.assert_array_equal(again.end_v, motions.end_v)


def test_an_ensemble_is_interrupted():
    def interrupt():
        time.sleep(0.3)
        os.kill(os.getpid(), signal.SIGINT)

    # Programs in the background may be started with interrupts ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    thread = threading.Thread(target=interrupt)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            # To its end it would take hours.
            CART.ensemble(np.tile([0.0, 2.5], (4000, 1)), [0.0, 0.0], until=1e6)
    finally:
        thread.join()
        signal.signal(signal.SIGINT, before)


def test_an_exception_of_the_feedback_is_raised():
    calls = []

    def broken(t, q, v):
        calls.append(t)
        raise KeyError("gain")

    refuses(KeyError, "gain", CART.integrate, [0.0, 0.1], [0.0, 0.0], 1.0, feedback=broken)
    assert len(calls) == 1
    refuses(ValueError, "the value of the feedback has the shape", CART.integrate, [0.0, 0.1], [0.0, 0.0], 1.0, feedback=lambda t, q, v: [1.0, 2.0])


def test_an_error_keeps_the_motion():
    def breaks_down(t, q, v):
        return np.inf if t > 0.5 else 0.0

    with pytest.raises(IntegrationError, match="the coordinate x is NaN at t = 0.5") as caught:
        CART.integrate(q=[0.0, 3.0], v=[0.0, 0.0], until=1.0, samples=11, feedback=breaks_down)
    motion = caught.value.motion
    assert motion.reason == "error" and 0.4 < motion.end.t <= 0.5
    assert len(motion.t) >= 5
    with pytest.raises(IntegrationError, match="theta"):
        Top(body=(0.5, 0.04, 4e-4, 3e-4), g=9.81).integrate([0.0] * 3, [0.0, 0.0, 9.0], until=1.0)
