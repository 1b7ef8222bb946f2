//! Operations of the accelerations and multipliers of loops in a row.

use lagrangian_symbolic::{Kinetics, Program, Symbol};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::plan::Methods;
use crate::tests::derived::derive;

/// Four-bar linkages in a row, in Cartesian coordinates: cranks about fixed points, whose ends couplers connect.
fn linkages(count: usize) -> Methods {
    let (couplers, cranks) = (count, count + 1);
    let [couplers, cranks] = [couplers, cranks].map(Literal::usize_unsuffixed);
    methods(quote! {
        #[lagrangian(
            coordinates(x[#cranks], y[#cranks]),
            kinetic = (0..#cranks).map(|i| m / 6.0 * (dot(x[i]).powi(2) + dot(y[i]).powi(2))).sum()
                + (0..#couplers).map(|i| m / 6.0 * (dot(x[i]).powi(2) + dot(y[i]).powi(2)
                    + dot(x[i + 1]).powi(2) + dot(y[i + 1]).powi(2)
                    + dot(x[i]) * dot(x[i + 1]) + dot(y[i]) * dot(y[i + 1]))).sum(),
            potential = m * g * (0..#cranks).map(|i| y[i]).sum(),
            constraint(
                crank[i] = (x[i] - i * l).powi(2) + y[i].powi(2) - l.powi(2) for i in 0..#cranks,
                coupler[i] = (x[i + 1] - x[i]).powi(2) + (y[i + 1] - y[i]).powi(2) - d.powi(2) for i in 0..#couplers,
            ),
        )]
        struct Linkages { m: f64, g: f64, l: f64, d: f64 }
    })
}

fn methods(declaration: TokenStream) -> Methods {
    derive(declaration).methods
}

#[test]
fn operations_of_linkages_in_a_row_grow_linearly() {
    let counts = [4, 8, 16].map(|count| linkages(count).accelerations.count.total());
    assert_eq!(counts[2] - counts[1], 2 * (counts[1] - counts[0]));
    let prepared = [8, 16].map(|count| linkages(count).prepare.count.total());
    assert!(prepared[1] <= 2 * prepared[0]);
}

/// Such linkages by the angles of each rod against the one before: the couplers are a chain, from whose joints the other cranks
/// hang.
fn chained(count: usize) -> Methods {
    let (couplers, behind) = (count, count - 1);
    let [couplers, behind] = [couplers, behind].map(Literal::usize_unsuffixed);
    methods(quote! {
        #[lagrangian(
            coordinates(first, a[#couplers], b[#couplers]),
            define(
                r = rotation_z(first),
                k[0] = r * rotation_z(b[0]),
                k[i + 1] = k[i] * rotation_z(b[i + 1]) for i in 0..#behind,
                p[0] = r * [l, 0.0, 0.0],
                p[i + 1] = p[i] + k[i] * [d, 0.0, 0.0] for i in 0..#couplers,
                h[i] = k[i] * rotation_z(a[i]) for i in 0..#couplers,
                foot[i] = p[i + 1] + h[i] * [l, 0.0, 0.0] for i in 0..#couplers,
            ),
            kinetic = 0.5 * m * dot(p[0] / 2.0).norm_squared() + m * l.powi(2) / 24.0 * dot(first).powi(2)
                + (0..#couplers).map(|i| 0.5 * m * dot(p[i] + k[i] * [d / 2.0, 0.0, 0.0]).norm_squared()
                    + m * d.powi(2) / 24.0 * angular_velocity(k[i]).norm_squared()
                    + 0.5 * m * dot(p[i + 1] + h[i] * [l / 2.0, 0.0, 0.0]).norm_squared()
                    + m * l.powi(2) / 24.0 * angular_velocity(h[i]).norm_squared()).sum(),
            potential = m * g * ((p[0] / 2.0).y
                + (0..#couplers).map(|i| (p[i] + k[i] * [d / 2.0, 0.0, 0.0]).y
                    + (p[i + 1] + h[i] * [l / 2.0, 0.0, 0.0]).y).sum()),
            constraint(
                x[i] = foot[i].x - (i + 1) * d for i in 0..#couplers,
                y[i] = foot[i].y for i in 0..#couplers,
            ),
        )]
        struct Chained { m: f64, g: f64, l: f64, d: f64 }
    })
}

#[test]
fn operations_of_linkages_in_relative_angles_grow_linearly() {
    let counts = [4, 8, 16].map(|count| chained(count).accelerations.count.total());
    assert!(100 * (counts[2] - counts[1]) <= 202 * (counts[1] - counts[0]));
}

/// A platform in a plane on legs of two angles each, whose ends hold it: the loops meet in it.
#[test]
fn operations_of_legs_below_a_platform_grow_linearly() {
    let counts = [8, 16, 32].map(|legs| {
        let legs = Literal::usize_unsuffixed(legs);
        let methods = methods(quote! {
            #[lagrangian(
                coordinates(x, y, phi, a[#legs], s[#legs]),
                kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)) + 0.5 * j * dot(phi).powi(2),
                kinetic = (0..#legs).map(|k| 0.5 * n * (dot(s[k]).powi(2) + s[k].powi(2) * dot(a[k]).powi(2))).sum(),
                potential = m * g * y,
                constraint(
                    joint[k] = [s[k] * cos(a[k]) + b[k] - x - c[k] * cos(phi), s[k] * sin(a[k]) - y - c[k] * sin(phi)]
                        for k in 0..#legs,
                ),
            )]
            struct Platform { m: f64, j: f64, n: f64, g: f64, b: [f64; #legs], c: [f64; #legs] }
        });
        methods.accelerations.count.total()
    });
    // Parts of a sum are shared in some legs and not in others.
    assert!(100 * (counts[2] - counts[1]) <= 202 * (counts[1] - counts[0]));
}

/// Each constraint restricts all coordinates, and M is full.
#[test]
fn what_is_coupled_throughout_is_left_to_the_numerical_factorization() {
    let methods = methods(quote! {
        #[lagrangian(
            coordinates(q[10]),
            kinetic = 0.5 * m * ((0..10).map(|i| dot(q[i])).sum().powi(2) + (0..10).map(|i| dot(q[i]).powi(2)).sum()),
            potential = 0.0,
            constraint(sum[k] = (0..10).map(|i| sin((k + 1) * q[i])).sum() - c for k in 0..4),
        )]
        struct Coupled { m: f64, c: f64 }
    });
    assert!(methods.accelerations.outputs.pivots().is_none());
}

/// Two arms in space on a cart, whose tips a rod connects.
fn arms() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(s, q[3], u[3]),
            define(
                base = [s, 0.2 * s, 0.0],
                r[0] = rotation_z(q[0]),
                r[1] = r[0] * rotation_y(q[1]),
                r[2] = r[1] * rotation_y(q[2]),
                elbow = base + r[1] * [l, 0.1, 0.0],
                plate = elbow + r[2] * [l, 0.0, -0.2],
                f[0] = rotation_x(0.3) * rotation_z(u[0]),
                f[1] = f[0] * rotation_x(u[1]),
                f[2] = f[1] * rotation_z(u[2]),
                knee = base + [0.0, 1.5, 0.0] + f[1] * [0.2, l, 0.1],
                tip = knee + f[2] * [0.0, l, 0.3],
                w[i] = angular_velocity(r[i]) for i in 0..3,
                o[i] = angular_velocity(f[i]) for i in 0..3,
            ),
            kinetic = 0.5 * cart * dot(base).norm_squared()
                + (0..3).map(|i| 0.5 * j * (w[i].x.powi(2) + 2.0 * w[i].y.powi(2) + 1.5 * w[i].z.powi(2))
                    + 0.5 * j * o[i].norm_squared()).sum()
                + 0.5 * m * (dot(elbow).norm_squared() + dot(plate).norm_squared()
                    + dot(knee).norm_squared() + dot(tip).norm_squared()),
            potential = m * g * (elbow.z + plate.z + knee.z + tip.z),
            constraint(
                rod = (plate - tip).norm_squared() - length.powi(2),
                rail = tip.z + 0.1 * t - 0.4,
                coupled = q[0] - 0.5 * u[0],
            ),
            nonholonomic(
                along = cos(q[1]) * dot(plate).x - dot(tip).x + 0.3 * dot(s),
                turning = o[2].z - 0.2 * w[2].x,
            ),
        )]
        struct Arms { cart: f64, m: f64, j: f64, g: f64, l: f64, length: f64 }
    }
}

/// Numbers between −1 and 1.
fn number(seed: u32) -> f64 {
    (12.9898 * (f64::from(seed) + 1.0)).sin()
}

/// Compares what solvers find where they are stable, and the residuals of the constraints, at some states of a declaration.
fn compare_solvers(declaration: TokenStream, parameters: &[f64], allowed: f64) {
    let mut derived = derive(declaration);
    let constraints = derived.equations.constraints.clone();
    let solutions = Kinetics::solutions(&mut derived.model, &derived.equations);
    let links = solutions
        .iter()
        .find(|solution| solution.method() == "articulated links");
    let graph = &derived.model.graph;
    let programs = links
        .into_iter()
        .chain(&solutions)
        .map(|solution| Program::schedule(graph, &[&*solution.pivots, &solution.accelerations]));
    let programs: Vec<_> = programs.collect();
    assert!(programs.len() > solutions.len(), "no articulated links");
    let rows = Program::schedule(
        graph,
        &[&*constraints.jacobian.concat(), &constraints.rates],
    );
    let coordinates = derived.model.coordinates as usize;
    let mut compared = 0;
    for seed in 0..40 {
        let value = |symbol| match symbol {
            Symbol::Coordinate(i) => number(100 * seed + i),
            Symbol::Velocity(i) => number(100 * seed + 50 + i),
            Symbol::Parameter(i) => parameters[i as usize],
            Symbol::Time => number(seed),
            _ => f64::NAN,
        };
        let stable = programs.iter().filter_map(|program| {
            let mut found = program.evaluate(value);
            let is_stable = found[0].iter().all(|pivot| *pivot > 0.0);
            is_stable.then(|| found.swap_remove(1))
        });
        let stable: Vec<_> = stable.collect();
        // The links are there twice.
        let [first, others @ ..] = stable.as_slice() else {
            continue;
        };
        if !others.contains(first) {
            continue;
        }
        compared += others.len();
        let size = first.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (x, y) in others.iter().flat_map(|other| first.iter().zip(other)) {
            assert!((x - y).abs() < allowed * size, "{x} is not {y} of {size}");
        }
        let rows = rows.evaluate(value);
        for (row, rate) in rows[0].chunks(coordinates).zip(&rows[1]) {
            let terms: Vec<_> = row.iter().zip(first).map(|(x, y)| x * y).collect();
            let size = terms.iter().fold(rate.abs(), |size, x| size + x.abs());
            let residual = terms.iter().sum::<f64>() + rate;
            assert!(residual.abs() < 2e-15 * size, "{residual:e} of {size:e}");
        }
    }
    assert!(compared > 40, "{compared}");
}

#[test]
fn arms_in_space_are_solved_along_their_links() {
    compare_solvers(arms(), &[2.0, 1.5, 0.3, 9.81, 0.8, 1.1], 1e-12);
}

/// The links are lighter than the cart by twelve orders of magnitude.
#[test]
fn accelerations_of_light_links_meet_the_constraints() {
    compare_solvers(arms(), &[1e6, 1e-6, 1e-6, 9.81, 0.8, 1.1], 1e-8);
}
