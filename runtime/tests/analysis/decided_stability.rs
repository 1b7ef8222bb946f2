//! Verdicts on stability that are decided: apart for what is not coupled, by forces of higher order, and for random potentials with
//! known signs.

use lagrangian::analysis::{
    EquilibriumSearch, LinearStability, SecondVariation, SmallOscillations, Stability, Verdict,
};
use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;

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

/// Two oscillators that are not coupled, the first with damping.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * dot(x).powi(2) + 0.5 * dot(y).powi(2),
    potential = 0.5 * k * x.powi(2) + 0.5 * l * y.powi(2) + c * y.powi(3),
    dissipation = 0.5 * d * dot(x).powi(2),
)]
struct Two {
    m: f64,
    k: f64,
    l: f64,
    c: f64,
    d: f64,
}

#[test]
fn what_is_not_coupled_is_decided_apart() {
    let stiff = [
        (1e-6, 1e6),
        (1e-8, 1e8),
        (1.0, 1e16),
        (1e-16, 1.0),
        (1e16, 1.0),
        (1.0, 1e-30),
        (1e30, 1e30),
    ];
    for (m, k) in stiff {
        for d in [0.0, 0.1] {
            for l in [1.0, 1e-12, 1e12] {
                let at_rest = |l: f64, c: f64| stability(&Two { m, k, l, c, d }, [0.0; 2]);
                let found = at_rest(l, 0.0);
                assert_eq!(
                    found.verdict(),
                    Verdict::Stable,
                    "{m} {k} {l} {d} {found:?}"
                );
                assert_eq!(found.second_variation, SecondVariation::PositiveDefinite);
                assert_eq!(at_rest(-l, 0.0).verdict(), Verdict::Unstable);
                assert_eq!(at_rest(0.0, 1.0).verdict(), Verdict::Undecided);
                let beside = stability(
                    &Two {
                        m,
                        k,
                        l: 0.0,
                        c: 1.0,
                        d,
                    },
                    [0.0, 1e-13],
                );
                assert_eq!(beside.verdict(), Verdict::Undecided, "{m} {k} {beside:?}");
            }
        }
    }
}

/// Forces of higher order that give energy, take it, or do either.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    force(x = c * dot(x).powi(3) + b * x * dot(x) + f + s * x - e * dot(x)),
)]
struct Pumped {
    c: f64,
    b: f64,
    f: f64,
    s: f64,
    e: f64,
}

#[test]
fn forces_of_higher_order_count() {
    let none = |c: f64, b: f64| Pumped {
        c,
        b,
        f: 0.0,
        s: 0.0,
        e: 0.0,
    };
    for (model, verdict) in [
        (none(0.0, 0.0), Verdict::Stable),
        (none(-1.0, 0.0), Verdict::Stable),
        (none(1.0, 0.0), Verdict::Undecided),
        (none(0.0, 1.0), Verdict::Undecided),
        (none(0.0, -1.0), Verdict::Undecided),
        (
            Pumped {
                f: 0.5,
                s: 0.5,
                ..none(0.0, 0.0)
            },
            Verdict::Stable,
        ),
        (
            Pumped {
                s: 2.0,
                ..none(0.0, 0.0)
            },
            Verdict::Unstable,
        ),
        (
            Pumped {
                e: 0.1,
                ..none(1.0, 1.0)
            },
            Verdict::AsymptoticallyStable,
        ),
        (
            Pumped {
                e: -0.1,
                ..none(0.0, 0.0)
            },
            Verdict::Unstable,
        ),
    ] {
        for guess in [0.0, 0.01] {
            let found = found_near(&model, [guess]);
            assert_eq!(found.verdict(), verdict, "{found:?}");
        }
    }
}

/// A damping that vanishes at the equilibrium and changes its sign there.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.25 * (x - 1).powi(4) + 0.5 * y.powi(2),
    force(y = -(x - 1) * dot(y)),
)]
struct Changing;

#[test]
fn damping_beside_an_equilibrium() {
    for guess in [[1.0, 0.0], [1.3, 0.1], [0.8, 0.0]] {
        let found = found_near(&Changing, guess);
        assert_eq!(found.verdict(), Verdict::Undecided, "{guess:?} {found:?}");
        assert_eq!(found.linear, LinearStability::Neutral);
    }
}

/// V = ½ uᵀ K u + cubic and quartic terms, u = q − a, with K = Lᵀ D L.
#[derive(Lagrangian, Debug)]
#[lagrangian(
    coordinates(x, y, z),
    define(u = x - a1, v = y - a2, w = z - a3,
        r = u + l1 * v + l2 * w, s = v + l3 * w),
    kinetic = 0.5 * (m1 * dot(x).powi(2) + m2 * dot(y).powi(2) + m3 * dot(z).powi(2)) + b * dot(x) * dot(z),
    potential = 0.5 * (d1 * r.powi(2) + d2 * s.powi(2) + d3 * w.powi(2))
        + c1 * r.powi(3) + c2 * s.powi(3) + c3 * w.powi(3) + c4 * u * v * w,
    dissipation = 0.5 * e * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
)]
#[allow(missing_docs)]
struct Random {
    a1: f64,
    a2: f64,
    a3: f64,
    l1: f64,
    l2: f64,
    l3: f64,
    m1: f64,
    m2: f64,
    m3: f64,
    b: f64,
    d1: f64,
    d2: f64,
    d3: f64,
    c1: f64,
    c2: f64,
    c3: f64,
    c4: f64,
    e: f64,
}

/// By Sylvester's law of inertia the signs of D are those of K, for each L that is triangular with ones.
#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn random_potentials_with_known_signs() {
    decide(700, 50);
}

#[test]
fn some_random_potentials_with_known_signs() {
    decide(100, 4);
}

/// Chooses among numbers, by a linear congruential generator.
fn picker(mut seed: u64) -> impl FnMut(&[f64]) -> f64 {
    move |choices| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        choices[usize::try_from((seed >> 33) % choices.len() as u64).unwrap()]
    }
}

/// The verdict on a potential with these principal curvatures, with damping or without, and its number.
fn expected(curvatures: [f64; 3], damping: f64) -> (usize, Verdict) {
    if curvatures.iter().any(|x| *x < 0.0) {
        (0, Verdict::Unstable)
    } else if curvatures.contains(&0.0) {
        (1, Verdict::Undecided)
    } else if damping > 0.0 {
        (2, Verdict::AsymptoticallyStable)
    } else {
        (3, Verdict::Stable)
    }
}

/// Decides the stability of so many equilibria, of which there are more than the least number of each kind.
fn decide(count: i32, least: i32) {
    let mut pick = picker(5);
    let mut counts = [0; 4];
    for _ in 0..count {
        let unit = pick(&[1.0, 1e-8, 1e8]);
        let kind = pick(&[0.0, 1.0, 2.0]);
        let sizes = [1.0, 2.0, 0.5, 10.0, 0.1];
        let mut d = [pick(&sizes), pick(&sizes), pick(&sizes)];
        let index = |x: f64| if x > 1.5 { 2 } else { usize::from(x > 0.5) };
        let (first, second) = (index(pick(&[0.0, 1.0, 2.0])), index(pick(&[0.0, 1.0, 2.0])));
        if kind > 0.5 {
            d[first] = if kind > 1.5 { 0.0 } else { -d[first] };
            d[second] = d[second].min(pick(&[1.0, 0.0, 5.0]));
        }
        let mut small = || pick(&[-2.0, -1.0, 0.0, 1.0, 2.0]);
        let model = Random {
            a1: small(),
            a2: small(),
            a3: 0.37 * small(),
            l1: small(),
            l2: small(),
            l3: small(),
            m1: 3.0,
            m2: 1.0,
            m3: 2.0,
            b: 0.5 * small(),
            d1: unit * d[0],
            d2: unit * d[1],
            d3: unit * d[2],
            c1: unit * 0.2 * small(),
            c2: unit * 0.2 * small(),
            c3: unit * 0.2 * small(),
            c4: 0.0,
            e: 0.3 * (small() + 2.0) * unit.sqrt(),
        };
        let place = [model.a1, model.a2, model.a3];
        let guess = [place[0] + 2e-3, place[1] - 1e-3, place[2] + 1e-3];
        let Ok(found) = EquilibriumSearch::of(&model).near(&State::new(0.0, guess, [0.0; 3]))
        else {
            continue;
        };
        let distance = (found.state.q - Vector3::from(place)).norm();
        let stability = stability(&model, found.state.q.into());
        let (kind, verdict) = expected(d, model.e);
        counts[kind] += 1;
        assert!(distance < 1e-2, "{model:?} {found:?}");
        assert_eq!(
            stability.verdict(),
            verdict,
            "{model:?} {distance:e} {stability:?}"
        );
    }
    assert!(
        counts.iter().sum::<i32>() > count / 7 * 5 && counts.iter().all(|of_one| *of_one > least),
        "{counts:?}"
    );
}
