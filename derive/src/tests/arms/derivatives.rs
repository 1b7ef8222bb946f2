//! The derivatives of q̈: what they cost, and that they are those of an independent computation.

use quote::quote;

use super::*;
use crate::plan::Method;

/// The method that differentiates q̈ of an arm.
fn linearize(links: usize) -> Method {
    derive(arm(links)).methods.linearize
}

/// Column by column they took 1116, 2388, 5297 and 15551 operations.
#[test]
fn derivatives_along_the_links_cost_little() {
    for (links, most) in [(3, 940), (4, 1800), (6, 3200), (10, 7700)] {
        let found = operations(&linearize(links).program);
        assert!(found <= most, "{links}: {found}");
    }
}

/// The solution for all columns aside, which the runtime does in loops.
#[test]
fn derivatives_grow_with_the_square_of_the_number_of_links() {
    let [ten, twenty] = [10, 20].map(|links| operations(&linearize(links).program));
    assert!(twenty > ten, "{ten}, {twenty}");
    assert!(10 * twenty <= 34 * ten, "{ten}, {twenty}");
}

/// Those of M q̈ − f against differences of order six of partial velocities and inertia forces.
#[test]
fn derivatives_are_those_of_partial_velocities() {
    for links in [5, 7] {
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
        let found = values(&derived, &derived.methods.linearize, value);
        let before = links * (links + 1) / 2 + links;
        let size = expected.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
        assert_eq!(found.len(), before + expected.len());
        for (x, y) in found[before..].iter().zip(expected) {
            assert!((x - y).abs() < 1e-10 * size, "{x} is not {y}");
        }
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
/// rates that depend on coordinates. Validation compares all with Lagrange's equations.
#[test]
fn joints_of_every_kind_have_derivatives() {
    let methods = derived(quote! {
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
    })
    .methods;
    let found = operations(&methods.linearize.program);
    assert!(found < 6000, "{found}");
}
