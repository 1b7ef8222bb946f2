//! A model that is put together part by part is the model written at once.

use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

/// A cart and a pendulum that hangs from it, body by body.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(p = [x + l * sin(theta), -l * cos(theta)]),
    // The cart on its spring.
    kinetic = 0.5 * cart * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    dissipation = 0.5 * c * dot(x).powi(2),
    force(x = push),
    // The pendulum in the wind.
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.y,
    dissipation = 0.5 * c * dot(theta).powi(2),
    force(x = wind, theta = wind * l * cos(theta)),
)]
#[derive(Clone)]
struct ByBodies {
    cart: f64,
    m: f64,
    l: f64,
    g: f64,
    k: f64,
    c: f64,
    push: f64,
    wind: f64,
}

/// The same in one expression each, in components.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    kinetic = 0.5 * (cart + m) * dot(x).powi(2) + m * l * cos(theta) * dot(x) * dot(theta)
        + 0.5 * m * l.powi(2) * dot(theta).powi(2),
    potential = 0.5 * k * x.powi(2) - m * g * l * cos(theta),
    dissipation = 0.5 * c * (dot(x).powi(2) + dot(theta).powi(2)),
    force(x = push + wind, theta = wind * l * cos(theta)),
)]
struct AtOnce {
    cart: f64,
    m: f64,
    l: f64,
    g: f64,
    k: f64,
    c: f64,
    push: f64,
    wind: f64,
}

#[test]
fn clauses_of_several_bodies_add_up() {
    let [cart, m, l, g, k, c, push, wind] = [2.0, 0.5, 0.75, 9.81, 3.0, 0.25, 1.5, -0.5];
    let parts = ByBodies {
        cart,
        m,
        l,
        g,
        k,
        c,
        push,
        wind,
    };
    let whole = AtOnce {
        cart,
        m,
        l,
        g,
        k,
        c,
        push,
        wind,
    };
    let state = State::new(0.0, [0.3, 0.8], [-0.4, 1.7]);
    let pairs = [
        (
            "q̈",
            parts.accelerations(&state),
            whole.accelerations(&state),
        ),
        (
            "Q",
            parts.generalized_forces(&state),
            whole.generalized_forces(&state),
        ),
        ("p", parts.momenta(&state), whole.momenta(&state)),
    ];
    for (what, parts, whole) in pairs {
        assert_close(what, parts.as_slice(), whole.as_slice(), 1e-14);
    }
    let energies = [parts.energy(&state), parts.kinetic_energy(&state)];
    assert_close(
        "energies",
        &energies,
        &[whole.energy(&state), whole.kinetic_energy(&state)],
        1e-14,
    );
}

/// Families of several indices, of several parts, and with gaps; ranges that depend on each other.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a[2], x, b[3]),
    define(
        grid[i][j] = (i + 1) * a[i] + b[j] for i in 0..2 for j in 0..3,
        triangle[i][j] = grid[i][j] - grid[i][i] for i in 0..2 for j in i + 1..3,
        even[2 * i] = b[i] for i in 0..3,
        even[1] = x,
        turned[i] = [grid[0][i], even[i]] for i in 0..=2,
        path[i] = (0..i).map(|k| [b[k], even[k]]).sum() for i in 0..3,
    ),
    kinetic = 0.5 * (0..a.len()).map(|i| dot(a[i]).powi(2)).sum() + 0.5 * dot(x).powi(2)
        + 0.5 * (0..3).map(|i| { dot(b[i]).powi(2) }).sum(),
    potential = x * (0..2).map(|i| (i + 1..3).map(|j| triangle[i][j]).sum()).sum(),
    force(a[0] = even[4], b[2 - i] = i * t for i in 0..2),
    output(
        pairs = (0..3).map(|i| (0..i).map(|j| b[i] * b[j]).sum()).sum(),
        factors = (0..3).map(|i| b[i] + 1).product(),
        none = (2..1).map(|i| b[i]).product(),
        turned = (0..3).map(|i| turned[i]).collect(),
        shadowed = (0..2).map(|x| a[x]).sum() + x,
        before = (0..3).map(|i| (0..i).map(|j| b[j]).sum()).collect(),
        corners = (0..3).map(|i| (0..i).map(|j| [b[j], x]).sum()).collect(),
        origin = path[0].norm() + path[0].x + path[2].norm_squared() + dot(dot(2 * path[0])).norm(),
        product = ([x] * [x]) + [x].transpose() * [x],
        single = [[x], [2]][1][0] + [[x, 3]][0][1],
        lines = [[[1, 2], [3, x]].row(1), [[4, 5]].row(0)],
    ),
)]
struct Families {}

#[test]
fn members_of_families_are_told_apart_by_indices() {
    let names = ["a[0]", "a[1]", "x", "b[0]", "b[1]", "b[2]"];
    assert_eq!(Families::COORDINATES, names);
    assert_eq!(
        (Families::A, Families::X, Families::B),
        ([0, 1], 2, [3, 4, 5])
    );
    let (a, x, b) = ([0.5, -1.5], 2.0, [1.0, 3.0, -0.25]);
    let state = State::new(4.0, [a[0], a[1], x, b[0], b[1], b[2]], [0.0; 6]);
    let outputs = Families {}.outputs(&state);
    let pairs = b[1] * b[0] + b[2] * (b[0] + b[1]);
    let factors = (b[0] + 1.0) * (b[1] + 1.0) * (b[2] + 1.0);
    let found = [
        outputs.pairs,
        outputs.factors,
        outputs.none,
        outputs.shadowed,
    ];
    assert_close(
        "sums",
        &found,
        &[pairs, factors, 1.0, a[0] + a[1] + x],
        1e-15,
    );
    // even[0], even[1] and even[2] are b₀, x and b₁.
    let turned = [a[0] + b[0], a[0] + b[1], a[0] + b[2], b[0], x, b[1]];
    assert_close("rows", outputs.turned.as_slice(), &turned, 1e-15);
    let before = [0.0, b[0], b[0] + b[1]];
    assert_close("before", outputs.before.as_slice(), &before, 1e-15);
    let corners = [0.0, b[0], b[0] + b[1], 0.0, x, 2.0 * x];
    assert_close("corners", outputs.corners.as_slice(), &corners, 1e-15);
    let origin = (b[0] + b[1]).powi(2) + (b[0] + x).powi(2);
    let found = [outputs.origin, outputs.product, outputs.single];
    assert_close("origin", &found, &[origin, 2.0 * x * x, 5.0], 1e-15);
    assert_close(
        "lines",
        outputs.lines.as_slice(),
        &[3.0, 4.0, x, 5.0],
        1e-15,
    );
    // V = x (b₁ − b₀ + b₂ − b₀ + b₂ − b₁), and the forces are b₂ on a₀, 0 on b₂ and t on b₁.
    let gradient = 2.0 * (b[2] - b[0]);
    let expected = [b[2], 0.0, -gradient, 2.0 * x, 4.0, -2.0 * x];
    let found = Families {}.accelerations(&state);
    assert_close("accelerations", found.as_slice(), &expected, 1e-15);
}
