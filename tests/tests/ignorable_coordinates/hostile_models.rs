//! Reduced models of declarations that are made to be difficult: jumps, roots, equal, negative and vanishing parameters,
//! moving frames, two and three ignorable coordinates, inputs, outputs and events with ignorable velocities.

use lagrangian::prelude::*;
use lagrangian_tests::{Random, assert_close};

/// One ignorable angle beside a slider with jumps, corners and roots, whose input acts through the ignorable velocity.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * dot(r).powi(2) + 0.5 * (j + m * r.abs() * r.abs()) * dot(phi).powi(2),
    potential = k * (r.powi(2) + c.powi(2)).sqrt() + step * r.signum() * r.powi(2) + hard * (r - c).max(0.0).powi(2),
    dissipation = 0.5 * d * dot(r).powi(2),
    force(r = u * dot(phi) * r.abs().sqrt() - d * dot(phi).abs()),
    output(turning = dot(phi), work = u * dot(phi) * dot(r), coming = dot(dot(phi))),
    event(fast = dot(phi) - limit, corner = r - c, turning_back = dot(r) * dot(phi)),
    routhian(Slider),
)]
struct SliderOnATurntable {
    m: f64,
    j: f64,
    k: f64,
    c: f64,
    step: f64,
    hard: f64,
    d: f64,
    limit: f64,
    #[lagrangian(input)]
    u: f64,
}

/// Three ignorable coordinates with coupled inertia, one remaining; gyroscopic terms; the energies depend on time.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(a, x, b, c),
    kinetic = 0.5 * m1 * (dot(a) + sin(x) * dot(b)).powi(2)
        + 0.5 * m2 * (dot(b) - cos(x) * dot(c) + w * cos(w * t) * x).powi(2)
        + 0.5 * m3 * (dot(c) + dot(a) * x).powi(2)
        + 0.5 * m4 * (dot(x) + 0.5 * dot(b)).powi(2),
    potential = k * cos(x) + q * dot(a) * x.powi(2) - q * sin(w * t) * dot(c),
    force(x = -d * dot(x) * dot(b).powi(2)),
    output(rates = [dot(a), dot(b), dot(c)], sum = dot(dot(a)) + dot(dot(b)) * x + dot(dot(c))),
    event(stands = dot(a) - dot(c)),
    routhian(Single),
)]
struct ThreeIgnorable {
    m1: f64,
    m2: f64,
    m3: f64,
    m4: f64,
    k: f64,
    q: f64,
    d: f64,
    w: f64,
}

/// A charge on a ring that turns and is shaken, in a moving frame, with a second ignorable coordinate along its axis.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(z, s, phi),
    define(
        place = rotation_z(w * t) * [s * cos(phi), s * sin(phi), z + h * sin(w * t)],
        v = dot(place),
    ),
    kinetic = 0.5 * m * v.norm_squared(),
    potential = 0.5 * k * s.powi(2) - 0.5 * e * (place.x * v.y - place.y * v.x) + k * s.powi(4),
    output(velocity = dot(phi), climbing = dot(z)),
    event(still = dot(phi)),
    routhian(Radial),
)]
struct ChargeInAMovingFrame {
    m: f64,
    k: f64,
    e: f64,
    w: f64,
    h: f64,
}

/// Compares the reduced model with the full one at random states, and along a short motion.
macro_rules! assert_reduced {
    ($model:expr, $n:literal, $remaining:expr, $ignorable:expr, |$x:ident| $values:expr) => {{
        let model = $model;
        let mut random = Random::default();
        for _ in 0..40 {
            let state: State<f64, $n> = random.state();
            let (reduced, start) = model.reduce(&state);
            let all = model.accelerations(&state);
            let expected = $remaining.map(|i: usize| all[i]);
            assert_close(
                "q̈",
                reduced.accelerations(&start).as_slice(),
                &expected,
                1e-9,
            );
            let rates = $ignorable.map(|i: usize| state.v[i]);
            let found = reduced.ignorable_velocities(&start);
            assert_close("u", found.as_slice(), &rates, 1e-10);
            let (energy, expected) = (reduced.energy(&start), model.energy(&state));
            let momenta = model.momenta(&state);
            // h of the reduced model is that of the full one.
            assert_close("h", &[energy], &[expected], 1e-9);
            assert_close(
                "p",
                reduced.constants().as_slice(),
                &$ignorable.map(|i: usize| momenta[i]),
                1e-13,
            );
            let $x = reduced.outputs(&start);
            let found = $values;
            let $x = model.outputs(&state);
            assert_close("outputs", &found, &$values, 1e-8);
            let (found, expected) = (
                reduced.event_functions(&start),
                model.event_functions(&state),
            );
            assert_close("events", &found, &expected, 1e-9);
        }
        let start = State::new(0.1, [0.4; $n], [0.3; $n]);
        let (reduced, reduced_start) = model.reduce(&start);
        let method = Dop853::new()
            .relative_tolerance(1e-12)
            .absolute_tolerance(1e-12);
        let equations = reduced.reconstruction();
        let places = $ignorable.map(|_| 0.4);
        let there = At::from((reduced_start, places));
        let end = Problem::new(&equations, there).solve(1.5, method).unwrap();
        let found = equations.full_state(&end);
        let expected = Problem::new(&model, start).solve(1.5, method).unwrap();
        assert_close("q", found.q.as_slice(), expected.q.as_slice(), 1e-8);
        assert_close("q̇", found.v.as_slice(), expected.v.as_slice(), 1e-7);
    }};
}

#[test]
fn jumps_and_roots_are_reduced() {
    let regular = SliderOnATurntable {
        m: 1.2,
        j: 0.4,
        k: 3.0,
        c: 0.5,
        step: 0.7,
        hard: 20.0,
        d: 0.2,
        limit: 1.0,
        u: 0.8,
    };
    let variants = [
        regular.clone(),
        // Equal, vanishing and negative parameters.
        SliderOnATurntable {
            m: 0.4,
            j: 0.4,
            k: 0.4,
            ..regular
        },
        SliderOnATurntable {
            c: 0.0,
            step: 0.0,
            d: 0.0,
            ..regular
        },
        SliderOnATurntable {
            k: -2.0,
            step: -1.0,
            hard: -0.5,
            u: -3.0,
            ..regular
        },
        // A moment of inertia far from the other sizes.
        SliderOnATurntable {
            j: 1e6,
            m: 1e-3,
            ..regular
        },
    ];
    for model in variants {
        assert_reduced!(model, 2, [0], [1], |x| [x.turning, x.work, x.coming]);
    }
}

#[test]
fn three_ignorable_coordinates_are_eliminated_at_once() {
    let regular = ThreeIgnorable {
        m1: 1.1,
        m2: 0.7,
        m3: 0.9,
        m4: 1.4,
        k: 2.0,
        q: 0.3,
        d: 0.1,
        w: 1.7,
    };
    let variants = [
        regular.clone(),
        ThreeIgnorable {
            m1: 1.0,
            m2: 1.0,
            m3: 1.0,
            m4: 1.0,
            ..regular
        },
        ThreeIgnorable {
            q: 0.0,
            d: 0.0,
            w: 0.0,
            ..regular
        },
        ThreeIgnorable {
            k: -3.0,
            q: -1.0,
            w: -2.0,
            ..regular
        },
    ];
    for model in variants {
        assert_reduced!(model, 4, [1], [0, 2, 3], |x| [
            x.rates[0], x.rates[1], x.rates[2], x.sum
        ]);
    }
}

#[test]
fn models_in_moving_frames_are_reduced() {
    let regular = ChargeInAMovingFrame {
        m: 1.3,
        k: 0.9,
        e: 0.6,
        w: 2.1,
        h: 0.4,
    };
    let variants = [
        regular.clone(),
        ChargeInAMovingFrame {
            e: -0.6,
            w: -2.1,
            ..regular
        },
        ChargeInAMovingFrame {
            e: 0.0,
            h: 0.0,
            ..regular
        },
        ChargeInAMovingFrame {
            m: 0.9,
            k: 0.9,
            e: 0.9,
            w: 0.9,
            h: 0.9,
        },
    ];
    for model in variants {
        assert_reduced!(model, 3, [1], [0, 2], |x| [x.velocity, x.climbing]);
    }
}
