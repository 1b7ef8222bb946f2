//! Closed loops whose angles are eliminated with inverse functions, as a user writes them: against positions on
//! dual numbers of second order, and beside the same loop eliminated by roots.

use lagrangian::prelude::*;
use lagrangian::{Dual, OperationCount};
use lagrangian_tests::{Figures, Random, relative_error};

/// A number with its first and second derivative.
type Twice = Dual<Dual>;

/// A slider-crank mechanism: the rod's angle is that at which the slider stays on the line.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(
        phi = asin(r * sin(theta) / l),
        x = r * cos(theta) + l * cos(phi),
        center = [r * cos(theta) + 0.5 * l * cos(phi), 0.5 * l * sin(phi)],
    ),
    kinetic = 0.5 * (i * dot(theta).powi(2) + j * dot(phi).powi(2) + m * dot(center).norm_squared() + slider * dot(x).powi(2)),
    potential = g * m * center.y + 0.5 * k * x.powi(2),
)]
struct SliderCrank {
    r: f64,
    l: f64,
    i: f64,
    j: f64,
    m: f64,
    slider: f64,
    g: f64,
    k: f64,
}

/// The same with the rod's sine and cosine, and its rate from that of the sine.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(
        s = r * sin(theta) / l,
        c = ((1.0 - s) * (1.0 + s)).sqrt(),
        x = r * cos(theta) + l * c,
        center = [r * cos(theta) + 0.5 * l * c, 0.5 * l * s],
    ),
    kinetic = 0.5 * (i * dot(theta).powi(2) + j * (dot(s) / c).powi(2) + m * dot(center).norm_squared() + slider * dot(x).powi(2)),
    potential = g * m * center.y + 0.5 * k * x.powi(2),
)]
struct ByRoots {
    r: f64,
    l: f64,
    i: f64,
    j: f64,
    m: f64,
    slider: f64,
    g: f64,
    k: f64,
}

/// A four-bar linkage: the diagonal d from the crank's end to the rocker's pivot gives the angles of two triangles, by the
/// law of cosines.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(
        d = (a.powi(2) + f.powi(2) - 2.0 * a * f * cos(theta)).sqrt(),
        beta = asin(a * sin(theta) / d),
        gamma = acos((c.powi(2) + d.powi(2) - b.powi(2)) / (2.0 * c * d)),
        rocker = beta + gamma,
        end = [f - c * cos(rocker), c * sin(rocker)],
        height = c * (sin(gamma) * cos(beta) - cos(gamma) * sin(beta)),
    ),
    kinetic = 0.5 * (i * dot(theta).powi(2) + j * dot(rocker).powi(2) + m * dot(end).norm_squared()),
    potential = g * m * height,
)]
struct FourBar {
    a: f64,
    b: f64,
    c: f64,
    f: f64,
    i: f64,
    j: f64,
    m: f64,
    g: f64,
}

/// q̈ of a mechanism of one coordinate, of which T = ½ Σ m ṗ²: −(½ M′ q̇² + V′)/M, with M = Σ m p′² and ½ M′ = Σ m p′ p″.
fn acceleration(rate: f64, points: &[(f64, Twice)], potential: Twice) -> f64 {
    let slope = |x: &Twice| x.derivative[0].value;
    let bend = |x: &Twice| x.derivative[0].derivative[0];
    let mass: f64 = points.iter().map(|(m, p)| m * slope(p) * slope(p)).sum();
    let half_slope: f64 = points.iter().map(|(m, p)| m * slope(p) * bend(p)).sum();
    -(half_slope * rate * rate + slope(&potential)) / mass
}

/// The variable of the derivatives.
fn variable(theta: f64) -> Twice {
    Dual::variable(Dual::variable(theta, 0), 0)
}

#[test]
fn a_slider_crank_moves_as_its_positions_on_dual_numbers_say() {
    let (r, l, i, j, m, slider, g, k) = (0.1, 0.35, 0.02, 0.01, 0.8, 0.5, 9.81, 40.0);
    let declared = SliderCrank {
        r,
        l,
        i,
        j,
        m,
        slider,
        g,
        k,
    };
    let by_roots = ByRoots {
        r,
        l,
        i,
        j,
        m,
        slider,
        g,
        k,
    };
    let mut figures = Figures::new();
    let mut random = Random::default();
    for _ in 0..200 {
        let state: State<f64, 1> = random.state();
        let theta = variable(state.q[0]);
        let phi = (theta.sin() * r / l).asin();
        let x = theta.cos() * r + phi.cos() * l;
        let center = [
            theta.cos() * r + phi.cos() * (0.5 * l),
            phi.sin() * (0.5 * l),
        ];
        let points = [
            (i, theta),
            (j, phi),
            (m, center[0]),
            (m, center[1]),
            (slider, x),
        ];
        let potential = center[1] * (g * m) + x * x * (0.5 * k);
        let expected = acceleration(state.v[0], &points, potential);
        for (what, found) in [
            ("asin", declared.accelerations(&state)[0]),
            ("roots", by_roots.accelerations(&state)[0]),
        ] {
            figures.record(
                what,
                "slider-crank",
                relative_error(&[found], &[expected], 1.0),
                1e-13,
            );
        }
    }
    figures.finish();
}

#[test]
fn a_four_bar_linkage_moves_as_its_positions_on_dual_numbers_say() {
    let (a, b, c, f, i, j, m, g) = (0.1, 0.32, 0.28, 0.3, 0.02, 0.03, 0.8, 9.81);
    let declared = FourBar {
        a,
        b,
        c,
        f,
        i,
        j,
        m,
        g,
    };
    let mut figures = Figures::new();
    let mut random = Random::default();
    for _ in 0..200 {
        let state: State<f64, 1> = random.state();
        let theta = variable(state.q[0]);
        let d = (-theta.cos() * (2.0 * a * f) + (a * a + f * f)).sqrt();
        let beta = (theta.sin() * a / d).asin();
        let gamma = ((d * d + (c * c - b * b)) / (d * (2.0 * c))).acos();
        let rocker = beta + gamma;
        let end = [-rocker.cos() * c + f, rocker.sin() * c];
        let points = [(i, theta), (j, rocker), (m, end[0]), (m, end[1])];
        let potential = (gamma - beta).sin() * (c * m * g);
        let expected = acceleration(state.v[0], &points, potential);
        let found = declared.accelerations(&state)[0];
        figures.record(
            "q",
            "four-bar",
            relative_error(&[found], &[expected], 1.0),
            1e-13,
        );
    }
    figures.finish();
}

/// In additions, as the derivation reckons them.
fn cost(count: OperationCount) -> usize {
    count.total() + 4 * count.divisions + 6 * count.square_roots + 11 * count.sines_and_cosines
}

/// No sine is taken of an arc sine.
#[test]
fn a_loop_by_arc_sines_costs_what_it_costs_by_roots() {
    let [declared, by_roots] =
        [SliderCrank::OPERATIONS, ByRoots::OPERATIONS].map(|count| count.accelerations);
    assert_eq!(declared.sines_and_cosines, by_roots.sines_and_cosines);
    // Of the crank's angle alone.
    let four_bar = FourBar::OPERATIONS.accelerations;
    assert_eq!((four_bar.sines_and_cosines, four_bar.functions), (1, 0));
    assert!(
        10 * cost(declared) <= 11 * cost(by_roots),
        "{declared:?}, {by_roots:?}"
    );
}
