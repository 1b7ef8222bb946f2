//! Verdicts on stability as far as the place of an equilibrium is known: where the second variation vanishes, a search ends beside
//! the equilibrium, at which it has some sign.

use lagrangian::analysis::{
    EquilibriumSearch, SecondVariation, SmallOscillations, Stability, Verdict,
};
use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;

/// V = scale · (c₂ u² + c₃ u³ + c₄ u⁴ + c₅ u⁵), u = (x − a)/l.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(x),
    define(u = (x - a) / l),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = scale * (c2 * u.powi(2) + c3 * u.powi(3) + c4 * u.powi(4) + c5 * u.powi(5)),
    dissipation = 0.5 * d * dot(x).powi(2),
)]
struct Line {
    m: f64,
    scale: f64,
    a: f64,
    l: f64,
    c2: f64,
    c3: f64,
    c4: f64,
    c5: f64,
    d: f64,
}

const FLAT: Line = Line {
    m: 1.0,
    scale: 1.0,
    a: 0.0,
    l: 1.0,
    c2: 0.0,
    c3: 0.0,
    c4: 0.0,
    c5: 0.0,
    d: 0.0,
};

fn stability<M: Lagrangian<N, Model: StateJacobian<N>>, const N: usize>(
    model: &M,
    q: [f64; N],
) -> Stability {
    let oscillations = SmallOscillations::about(model, &State::new(0.0, q, [0.0; N])).unwrap();
    oscillations.stability().unwrap()
}

fn found_near<M: Lagrangian<N, Model: StateJacobian<N>>, const N: usize>(
    model: &M,
    guess: [f64; N],
) -> Stability {
    let search = EquilibriumSearch::of(model).max_iterations(1000);
    let found = search.near(&State::new(0.0, guess, [0.0; N]));
    stability(model, found.unwrap().state.q.into())
}

#[test]
fn inflections_are_undecided_from_every_guess() {
    let cubic = Line { c3: 1.0, ..FLAT };
    let (mut refused, mut found_some) = (0, 0);
    for (scale, l) in [
        (1.0, 1.0),
        (1e-8, 1.0),
        (1e8, 1.0),
        (1.0, 1e-8),
        (1.0, 1e8),
        (1e8, 1e-8),
    ] {
        for a in [0.0, 0.3, -7.0] {
            for d in [0.0, 1.0] {
                let model = Line {
                    scale,
                    l,
                    a: a * l,
                    d,
                    ..cubic.clone()
                };
                for guess in [0.0, 0.5, 50.0, -3.0] {
                    let search = EquilibriumSearch::of(&model).max_iterations(1000);
                    let guess = State::new(0.0, [a * l + guess * l], [0.0]);
                    let Ok(state) = search.near(&guess).map(|found| found.state) else {
                        refused += 1;
                        continue;
                    };
                    let Ok(oscillations) = SmallOscillations::about(&model, &state) else {
                        refused += 1;
                        continue;
                    };
                    found_some += 1;
                    let found = oscillations.stability().unwrap();
                    assert_eq!(
                        found.verdict(),
                        Verdict::Undecided,
                        "{model:?} {guess:?} {found:?}"
                    );
                    assert_eq!(
                        found.second_variation,
                        SecondVariation::PositiveSemidefinite
                    );
                }
                // Where searches with other tolerances end.
                for distance in [1e-2, 1e-4, 1e-9, -1e-6] {
                    let at = State::new(0.0, [a * l + distance * l], [0.0]);
                    if let Ok(oscillations) = SmallOscillations::about(&model, &at) {
                        let found = oscillations.stability().unwrap();
                        assert_eq!(found.verdict(), Verdict::Undecided, "{distance} {found:?}");
                    }
                }
            }
        }
    }
    assert!(refused < found_some, "{refused} {found_some}");
}

#[test]
fn higher_orders_are_undecided() {
    for model in [
        Line { c4: 1.0, ..FLAT },
        Line { c4: -1.0, ..FLAT },
        Line { c5: 1.0, ..FLAT },
        Line {
            c4: 1.0,
            c5: 1.0,
            ..FLAT
        },
    ] {
        for d in [0.0, 1.0] {
            for guess in [0.0, 0.5, 0.02, -0.3] {
                let found = found_near(&Line { d, ..model.clone() }, [guess]);
                assert_eq!(
                    found.verdict(),
                    Verdict::Undecided,
                    "{model:?} {guess:?} {found:?}"
                );
            }
        }
    }
}

#[test]
fn small_second_derivatives_are_decided() {
    for c2 in [1.0, 1e-4, 1e-8, 1e-10] {
        for c3 in [0.0, 1.0, -1.0] {
            for scale in [1.0, 1e-8, 1e8] {
                let model = Line {
                    scale,
                    c2,
                    c3,
                    ..FLAT
                };
                let found = found_near(&model, [0.1 * c2]);
                assert_eq!(found.verdict(), Verdict::Stable, "{model:?} {found:?}");
                let damped = Line {
                    d: (scale * c2).sqrt(),
                    ..model.clone()
                };
                let found = found_near(&damped, [0.1 * c2]);
                assert_eq!(
                    found.verdict(),
                    Verdict::AsymptoticallyStable,
                    "{model:?} {found:?}"
                );
                let maximum = Line { c2: -c2, ..model };
                let found = found_near(&maximum, [0.1 * c2]);
                assert_eq!(found.verdict(), Verdict::Unstable, "{maximum:?} {found:?}");
            }
        }
    }
}

/// V = x³ − 3x² + 3x about 1: its terms cancel, so that forces are rounding near the inflection.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = x.powi(3) - b * x.powi(2) + b * x,
)]
struct Expanded {
    b: f64,
}

#[test]
fn forces_that_are_rounding_decide_nothing() {
    for distance in [0.0, 1e-9, 3e-9, 1e-8, -1e-8, 4e-8, 1e-7, -1e-7] {
        let at = State::new(0.0, [1.0 + distance], [0.0]);
        if let Ok(oscillations) = SmallOscillations::about(&Expanded { b: 3.0 }, &at) {
            let found = oscillations.stability().unwrap();
            assert_eq!(found.verdict(), Verdict::Undecided, "{distance} {found:?}");
        }
    }
    for guess in [1.5, 0.2, 1.0 + 1e-4] {
        let search = EquilibriumSearch::of(&Expanded { b: 3.0 });
        if let Ok(found) = search.near(&State::new(0.0, [guess], [0.0])) {
            let found = stability(&Expanded { b: 3.0 }, found.state.q.into());
            assert_eq!(found.verdict(), Verdict::Undecided, "{guess} {found:?}");
        }
    }
}

/// A monkey saddle, turned and stretched; with k a minimum.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(u = c * x + s * y, w = c * y - s * x),
    kinetic = 0.5 * (dot(x).powi(2) + m * dot(y).powi(2)) + b * dot(x) * dot(y),
    potential = u.powi(3) - 3 * u * w.powi(2) + 0.5 * k * (x.powi(2) + y.powi(2)),
)]
struct Monkey {
    c: f64,
    s: f64,
    m: f64,
    b: f64,
    k: f64,
}

#[test]
fn monkey_saddles() {
    for angle in [0.0_f64, 0.3, 1.0, 2.5] {
        let (s, c) = angle.sin_cos();
        for (m, b) in [(1.0, 0.0), (1e4, 0.0), (2.0, 0.5)] {
            for guess in [[0.0, 0.0], [0.5, 0.2], [0.01, -0.3], [1.0, 0.0]] {
                let found = found_near(&Monkey { c, s, m, b, k: 0.0 }, guess);
                assert_eq!(
                    found.verdict(),
                    Verdict::Undecided,
                    "{angle} {m} {guess:?} {found:?}"
                );
            }
            let found = found_near(
                &Monkey {
                    c,
                    s,
                    m,
                    b,
                    k: 1e-3,
                },
                [1e-4, 2e-5],
            );
            assert_eq!(found.verdict(), Verdict::Stable, "{angle} {m} {found:?}");
        }
    }
}

/// Degenerate along a coupled direction, definite across it.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = g * (x + y).powi(3) + h * (x + y).powi(4) + 0.5 * k * (x - y).powi(2),
    dissipation = 0.5 * d * dot(x).powi(2),
)]
struct Valley {
    g: f64,
    h: f64,
    k: f64,
    d: f64,
}

#[test]
fn valleys() {
    for k in [1.0, 1e-6, 1e6] {
        for d in [0.0, 0.1] {
            for (g, h) in [(1.0, 0.0), (-2.0, 1.0), (0.0, 1.0), (0.0, -1.0), (0.0, 0.0)] {
                for guess in [[0.0, 0.0], [0.2, 0.1], [-0.01, 0.3]] {
                    let found = found_near(&Valley { g, h, k, d }, guess);
                    assert_eq!(
                        found.verdict(),
                        Verdict::Undecided,
                        "{g} {h} {k} {d} {found:?}"
                    );
                }
            }
        }
    }
}
