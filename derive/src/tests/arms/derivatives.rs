//! The derivatives of q̈: what they cost, and that they are those of an independent computation.

use std::collections::BTreeMap;

use quote::quote;

use super::*;
use crate::plan::Method;

/// The method that differentiates q̈ of an arm.
fn linearize(links: usize) -> Method {
    derive(arm(links)).methods.linearize.unwrap()
}

/// Column by column they took 1116, 2388, 5297 and 15551 operations.
#[test]
fn derivatives_along_the_links_cost_little() {
    for (links, most) in [(3, 940), (4, 1800), (6, 3200), (10, 7700)] {
        let found = operations(&linearize(links).program);
        assert!(found <= most, "{links}: {found}");
    }
}

/// With the solution for all columns, which took 21997 and 30652 operations for 13 and 15 joints where M was factored numerically.
#[test]
fn derivatives_grow_with_the_square_of_the_number_of_links() {
    let counts = [(13, 21_600), (15, 27_200)].map(|(links, most)| {
        let count = linearize(links).count;
        let found = count.additions + count.multiplications + count.divisions;
        assert!(found <= most, "{links}: {found}");
        found
    });
    assert!(169 * counts[1] <= 225 * counts[0], "{counts:?}");
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn derivatives_along_the_links_solve_the_differentiated_equations() {
    // A coordinate that moves two links from the inertial frame, and rotors with coordinates of their own, which move no link.
    let left_out = solve_differentiated_equations(0, 1);
    assert_eq!(left_out, ["slides", "rotors", "many rotors"]);
}

/// Of a free base, a moving support, rotors and joints of every kind.
#[test]
fn some_derivatives_along_the_links_solve_the_differentiated_equations() {
    assert_eq!(solve_differentiated_equations(1, 3), ["rotors"]);
}

/// By the state along the links and by the numerical solution of M x = −∂(M q̈ − f)/∂x, at any accelerations: one mechanism of so
/// many, from one on. Those whose derivatives are not taken along the links.
fn solve_differentiated_equations(first: usize, stride: usize) -> Vec<&'static str> {
    let mut left_out = Vec::new();
    let mut all = others();
    all.push(("joints of every kind", joints_of_every_kind()));
    all.push(("limbs", limbs()));
    for (name, declaration) in all.into_iter().skip(first).step_by(stride) {
        let Derived {
            mut model,
            equations,
            ..
        } = derive(declaration);
        let solutions = Kinetics::solutions(&mut model, &equations);
        let mut symbols = model.coordinate_symbols();
        symbols.extend(model.velocity_symbols());
        symbols.push(Symbol::Time);
        let graph = &mut model.graph;
        let mut columns = None;
        for solution in &solutions {
            columns = columns.or_else(|| solution.derivatives_along_links(graph, &symbols));
        }
        let Some(columns) = columns else {
            left_out.push(name);
            continue;
        };
        let slopes = graph.jacobian(&equations.inverse_dynamics, &symbols);
        let n = equations.mass.len();
        for seed in 0..3 {
            let numbers = std::cell::RefCell::new((Numbers::new(seed), BTreeMap::new()));
            let value = |symbol: Symbol| {
                let (numbers, values) = &mut *numbers.borrow_mut();
                *values.entry(symbol).or_insert_with(|| match symbol {
                    Symbol::Parameter(_) => 1.2 + 0.7 * numbers.next(),
                    _ => 2.0 * numbers.next(),
                })
            };
            let found = graph.evaluate(&columns, value);
            let mass = graph.evaluate(&equations.mass.concat(), value);
            for (found, slopes) in found.chunks(n).zip(&slopes) {
                let slopes = graph.evaluate(slopes, value);
                for (row, slope) in mass.chunks(n).zip(slopes) {
                    let products = row.iter().zip(found).map(|(x, y)| x * y);
                    let size = products.clone().fold(slope.abs(), |sum, x| sum + x.abs());
                    let sum = products.sum::<f64>() + slope;
                    assert!(sum.abs() < 1e-9 * size.max(1.0), "{name}: {sum} of {size}");
                }
            }
        }
    }
    left_out
}

/// A body without support with three limbs, of which the last two begin at the end of one link; springs between them.
fn limbs() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(x: Vector3, a[3], q[6], s),
            define(
                r[0] = rotation_zyx(a[0], a[1], a[2]),
                r[1] = r[0] * rotation_y(q[0]),
                r[2] = r[1] * rotation_x(q[1]),
                r[3] = r[2] * rotation_y(q[2]),
                r[4] = r[2] * rotation_z(q[3]) * rotation_x(0.5 * q[4]),
                r[5] = r[0] * rotation_z(q[5]),
                p[0] = x,
                p[1] = x + r[0] * link[0],
                p[2] = p[1] + r[1] * (link[1] + [0.0, s, 0.2 * q[4]]),
                p[3] = p[2] + r[2] * link[2],
                p[4] = p[2] + r[2] * link[3],
                p[5] = x + r[0] * link[4],
                c[i] = p[i] + r[i] * center[i] for i in 0..6,
                w[i] = angular_velocity(r[i]) for i in 0..6,
            ),
            kinetic = (0..6).map(|i| {
                0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
            }).sum(),
            potential = (0..6).map(|i| m[i] * g * c[i].z).sum()
                + 0.5 * k * (q[2] - q[3]).powi(2) * (2.0 + q[5]),
            dissipation = 0.5 * damping * (dot(q[1]) - dot(q[5])).powi(2),
        )]
        struct Limbs {
            m: [f64; 6],
            link: [Vector3<f64>; 5],
            center: [Vector3<f64>; 6],
            inertia: [Matrix3<f64>; 6],
            g: f64,
            k: f64,
            damping: f64,
        }
    }
}

/// Those of M q̈ − f against differences of order six of partial velocities and inertia forces.
#[test]
fn derivatives_are_those_of_partial_velocities() {
    for links in [5, 7, 13] {
        let derived = derived(arm(links));
        let mut numbers = Numbers::new(links as u64);
        let arm = Arm::new(links, &mut numbers);
        let parameters = arm.parameters();
        let mut state =
            |size: f64| -> Vec<f64> { (0..links).map(|_| size * numbers.next()).collect() };
        let [q, v, a] = [3.0, 1.0, 1.0].map(&mut state);
        let value = |symbol| match symbol {
            Symbol::Coordinate(i) => q[i as usize],
            Symbol::Velocity(i) => v[i as usize],
            Symbol::Acceleration(i) => a[i as usize],
            Symbol::Parameter(i) => parameters[i as usize],
            Symbol::Variation(i) => f64::from(u8::from(i == 1 || i as usize == 2 * links - 1)),
            _ => f64::NAN,
        };
        let residual = |q: &[f64], v: &[f64]| -> Vec<f64> {
            let (mass, bias) = arm.equations(q, v);
            let products = |i: usize| (0..links).map(|j| mass[i][j] * a[j]).sum::<f64>();
            (0..links).map(|i| bias[i] + products(i)).collect()
        };
        let mut expected = Vec::new();
        for symbol in 0..2 * links {
            expected.extend(difference(links, |step| {
                let mut state = [q.clone(), v.clone()];
                state[symbol / links][symbol % links] += step;
                residual(&state[0], &state[1])
            }));
        }
        // The derivatives by the time, on which nothing depends.
        expected.extend(vec![0.0; links]);
        let method = derived.methods.linearize.as_ref().unwrap();
        assert_eq!(method.outputs.is_along_variation(), links > 12);
        let found = values(&derived, method, value);
        if method.outputs.is_along_variation() {
            let (mass, _) = arm.equations(&q, &v);
            let solved = expected.chunks(links).flat_map(|slopes| {
                let right = slopes.iter().map(|slope| -slope);
                solve(mass.clone(), right.collect())
            });
            let pivots = method.outputs.pivots().unwrap();
            let (found, along) = found[pivots + links..].split_at(expected.len());
            assert_close(found, &solved.collect::<Vec<_>>());
            // Along the second coordinate and the last velocity.
            assert_eq!(along.len(), links);
            let columns = expected[links..]
                .iter()
                .zip(&expected[links * (2 * links - 1)..]);
            let sums: Vec<_> = columns.take(links).map(|(x, y)| x + y).collect();
            assert_close(along, &sums);
        } else {
            assert_close(&found[links * (links + 1) / 2 + links..], &expected);
        }
    }
}

#[track_caller]
fn assert_close(found: &[f64], expected: &[f64]) {
    let size = expected.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() < 1e-9 * size, "{x} is not {y}");
    }
}

/// A derivative at 0 by central differences of order six.
fn difference(rows: usize, value: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let step = 5e-3;
    let mut sum = vec![0.0; rows];
    for (i, weight) in [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)] {
        let [ahead, behind] = [value(i * step), value(-i * step)];
        for (sum, (x, y)) in sum.iter_mut().zip(ahead.iter().zip(behind)) {
            *sum += weight * (x - y) / (60.0 * step);
        }
    }
    sum
}

/// A screw, a slide along a curve, a turn about two axes by a product of coordinates and another one, and one that the time drives: directions of
/// rates that depend on coordinates.
fn joints_of_every_kind() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(a, b, c, d, e),
            define(
                r[0] = rotation_z(a),
                r[1] = r[0] * [
                    [cos(a * b), -sin(a * b) * cos(c), sin(a * b) * sin(c)],
                    [sin(a * b), cos(a * b) * cos(c), -cos(a * b) * sin(c)],
                    [0.0, sin(c), cos(c)],
                ],
                r[2] = r[1] * rotation_y(d + drive * t),
                r[3] = r[2] * rotation_z(sin(e)),
                p[0] = [0.0, 0.0, pitch * a],
                p[1] = p[0] + r[0] * [b.powi(2), sin(b), offset],
                p[2] = p[1] + r[1] * [c * d, length, 0.0],
                p[3] = p[2] + r[2] * [length, e, cos(e)],
                x[i] = p[i] + r[i] * center[i] for i in 0..4,
                w[i] = angular_velocity(r[i]) for i in 0..4,
            ),
            kinetic = (0..4).map(|i| {
                0.5 * m[i] * dot(x[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
            }).sum(),
            potential = (0..4).map(|i| m[i] * g * x[i].z).sum(),
        )]
        struct Joints {
            m: [f64; 4],
            center: [Vector3<f64>; 4],
            inertia: [Matrix3<f64>; 4],
            pitch: f64,
            offset: f64,
            length: f64,
            drive: f64,
            g: f64,
        }
    }
}

/// Validation compares all with Lagrange's equations.
#[test]
fn joints_of_every_kind_have_derivatives() {
    let methods = derived(joints_of_every_kind()).methods;
    let found = operations(&methods.linearize.as_ref().unwrap().program);
    assert!(found < 6000, "{found}");
}

/// Equal point masses on equal rods, at relative angles. Their equations are solved divided by m l², and so are the derivatives.
fn planar_chain(links: usize) -> TokenStream {
    let number = proc_macro2::Literal::usize_unsuffixed;
    let define = |i: usize| {
        let (turned, end, angle) = (
            quote::format_ident!("r{}", i),
            quote::format_ident!("p{}", i),
            number(i),
        );
        match i.checked_sub(1) {
            None => quote!(#turned = rotation_z(q[0]), #end = #turned * [0.0, -l, 0.0]),
            Some(before) => {
                let (turned_before, end_before) = (
                    quote::format_ident!("r{}", before),
                    quote::format_ident!("p{}", before),
                );
                quote! {
                    #turned = #turned_before * rotation_z(q[#angle]),
                    #end = #end_before + #turned * [0.0, -l, 0.0]
                }
            }
        }
    };
    let definitions = (0..links).map(define);
    let ends: Vec<_> = (0..links).map(|i| quote::format_ident!("p{}", i)).collect();
    let count = number(links);
    quote! {
        #[lagrangian(
            coordinates(q[#count]),
            define(#(#definitions),*),
            kinetic = #(0.5 * m * dot(#ends).norm_squared())+*,
            potential = #(m * g * #ends.y)+*,
        )]
        struct Chain { m: f64, l: f64, g: f64 }
    }
}

/// With derivatives in another unit than M, validation replaced all methods by plain ones: 547 to 1583 operations for the
/// accelerations of five to eight links.
#[test]
fn derivatives_have_the_unit_of_the_equations() {
    for links in 3..=8 {
        let Derived {
            mut model,
            mut equations,
            mut methods,
            validator,
            shapes,
            requested,
        } = derive(planar_chain(links));
        let of_methods = (&*shapes, &requested);
        let disagreements = methods.validate(&validator, &mut model, &mut equations, of_methods);
        assert!(disagreements.is_empty(), "{links}: {disagreements:?}");
        let found = operations(&methods.accelerations.program);
        assert!(found <= 70 * (links - 1), "{links}: {found}");
    }
}
