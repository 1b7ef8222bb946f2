//! Every solid against Gauss–Legendre quadrature of its integrals, in double-doubles.

use lagrangian::DoubleDouble;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{BodyError, Solid};

type D = DoubleDouble;
type V = Vector3<D>;

fn d(value: f64) -> D {
    D::from_f64(value)
}

/// Nodes and weights on \[0, 1\]: zeros of the Legendre polynomial by Newton's method.
fn gauss_legendre(n: u32) -> Vec<(D, D)> {
    let count = f64::from(n);
    (1..=n)
        .map(|i| {
            let angle = std::f64::consts::PI * (f64::from(i) - 0.25) / (count + 0.5);
            let mut x = d(angle.cos());
            let mut slope = d(0.0);
            for _ in 0..8 {
                let (mut before, mut p) = (d(1.0), x);
                for k in 2..=n {
                    let k = f64::from(k);
                    let next = (d(2.0 * k - 1.0) * x * p - d(k - 1.0) * before) / d(k);
                    (before, p) = (p, next);
                }
                slope = d(count) * (x * p - before) / (x * x - d(1.0));
                x -= p / slope;
            }
            let weight = d(2.0) / ((d(1.0) - x * x) * slope * slope);
            (d(0.5) * (x + d(1.0)), d(0.5) * weight)
        })
        .collect()
}

fn norm(v: V) -> D {
    v.dot(&v).sqrt()
}

/// ∫ dV, ∫ **r** dV and ∫ **r** **r**ᵀ dV over the image of the unit cube, square or interval under a map: those of
/// 1, 2 or 3 variables, the others held. Its derivatives are difference quotients, exact to 18 digits.
struct Quadrature {
    content: D,
    center: V,
    /// ∫ (**r** − `r_C`)(**r** − `r_C`)ᵀ dV/V.
    second: Matrix3<D>,
}

fn integrate(dimension: usize, map: impl Fn([D; 3]) -> V) -> Quadrature {
    let nodes = [8, 20, 24].map(gauss_legendre);
    let held = vec![(d(0.0), d(1.0))];
    let axis = |k: usize| if k < dimension { &nodes[k] } else { &held };
    let h = d(1e-10);
    let (mut content, mut first, mut second) = (d(0.0), V::zeros(), Matrix3::<D>::zeros());
    for (u, wu) in axis(0) {
        for (v, wv) in axis(1) {
            for (w, ww) in axis(2) {
                let at = [*u, *v, *w];
                let derivative = |k: usize| {
                    let [mut ahead, mut behind] = [at; 2];
                    ahead[k] += h;
                    behind[k] -= h;
                    (map(ahead) - map(behind)) / (h + h)
                };
                let measure = match dimension {
                    1 => norm(derivative(0)),
                    2 => norm(derivative(0).cross(&derivative(1))),
                    _ => derivative(0)
                        .cross(&derivative(1))
                        .dot(&derivative(2))
                        .abs(),
                };
                let weight = measure * *wu * *wv * *ww;
                let r = map(at);
                content += weight;
                first += r * weight;
                second += r * r.transpose() * weight;
            }
        }
    }
    let center = first / content;
    let second = second / content - center * center.transpose();
    Quadrature {
        content,
        center,
        second,
    }
}

#[track_caller]
fn close(found: f64, expected: D, scale: D, what: &str) {
    let error = ((d(found) - expected) / scale).to_f64().abs();
    assert!(
        error < 2e-15,
        "{what}: {found} is not {}",
        expected.to_f64()
    );
}

/// Compares a solid with quadrature; its density is 3.
fn check(solid: Result<Solid, BodyError>, expected: &Quadrature) {
    let solid = solid.unwrap();
    let body = solid.with_density(3.0).unwrap();
    let mass = d(3.0) * expected.content;
    close(body.mass(), mass, mass, "mass");
    let trace = expected.second.trace();
    for k in 0..3 {
        close(body.center()[k], expected.center[k], trace.sqrt(), "centre");
        let moment = mass * (trace - expected.second[(k, k)]);
        close(body.inertia().moments()[k], moment, mass * trace, "moment");
    }
    let products = body.inertia().products();
    let of_body = [products.xy, products.xz, products.yz];
    for (product, (i, j)) in of_body.into_iter().zip([(0, 1), (0, 2), (1, 2)]) {
        close(
            product,
            mass * expected.second[(i, j)],
            mass * trace,
            "product",
        );
    }
}

/// The point at a distance from the z axis, at an angle in whole turns, and a height.
fn cylindrical(distance: D, turns: D, z: D) -> V {
    let (s, c) = (d(2.0) * D::pi() * turns).sin_cos();
    V::new(distance * c, distance * s, z)
}

/// The point of a sphere of radius 1, scaled: the polar angle in half turns, the azimuth in turns.
fn spherical(distance: D, polar: D, turns: D) -> V {
    let (s, c) = (D::pi() * polar).sin_cos();
    cylindrical(distance * s, turns, distance * c)
}

#[test]
fn prisms_and_bodies_of_revolution() {
    let half = d(0.5);
    let cuboid = integrate(3, |[u, v, w]| {
        V::new(
            d(0.7) * (u - half),
            d(1.3) * (v - half),
            d(2.1) * (w - half),
        )
    });
    check(Solid::cuboid(0.7, 1.3, 2.1), &cuboid);
    let cylinder = integrate(3, |[u, v, w]| {
        cylindrical(d(0.6) * u, w, d(1.7) * (v - half))
    });
    check(Solid::cylinder(0.6, 1.7), &cylinder);
    let tube = integrate(3, |[u, v, w]| {
        cylindrical(d(0.4) + (d(0.6) - d(0.4)) * u, w, d(1.7) * (v - half))
    });
    check(Solid::tube(0.4, 0.6, 1.7), &tube);
    let cone = integrate(3, |[u, v, w]| {
        cylindrical(d(0.6) * u * (d(1.0) - v), w, d(1.7) * v)
    });
    check(Solid::cone(0.6, 1.7), &cone);
    let torus = integrate(3, |[u, v, w]| {
        let (s, c) = (d(2.0) * D::pi() * v).sin_cos();
        cylindrical(d(1.1) + d(0.4) * u * c, w, d(0.4) * u * s)
    });
    check(Solid::torus(1.1, 0.4), &torus);
}

#[test]
fn spheres() {
    let sphere = integrate(3, |[u, v, w]| spherical(d(0.8) * u, v, w));
    check(Solid::sphere(0.8), &sphere);
    let ellipsoid = integrate(3, |[u, v, w]| {
        spherical(u, v, w).component_mul(&V::new(d(0.5), d(0.9), d(1.4)))
    });
    check(Solid::ellipsoid(0.5, 0.9, 1.4), &ellipsoid);
    let hollow = integrate(3, |[u, v, w]| {
        spherical(d(0.5) + (d(0.8) - d(0.5)) * u, v, w)
    });
    check(Solid::hollow_sphere(0.5, 0.8), &hollow);
    let shell = integrate(2, |[u, v, _]| {
        // The polar angle has fewer nodes than the azimuth: the cosine of it is the variable.
        let z = d(2.0) * u - d(1.0);
        let distance = (d(1.0) - z * z).sqrt();
        cylindrical(distance, v, z) * d(0.8)
    });
    check(Solid::spherical_shell(0.8), &shell);
}

#[test]
fn capsules_are_cylinders_between_hemispheres() {
    let (r, l) = (d(0.3), d(1.9));
    let middle = integrate(3, |[u, v, w]| cylindrical(r * u, w, l * (v - d(0.5))));
    let cap = |sign: f64| {
        integrate(3, move |[u, v, w]| {
            let mut point = spherical(r * u, d(0.5) * v, w);
            point.z = d(sign) * (d(0.5) * l + point.z);
            point
        })
    };
    let parts = [middle, cap(1.0), cap(-1.0)];
    let content = parts.iter().fold(d(0.0), |sum, part| sum + part.content);
    let second = parts.iter().fold(Matrix3::zeros(), |sum, part| {
        sum + (part.second + part.center * part.center.transpose()) * (part.content / content)
    });
    let whole = Quadrature {
        content,
        center: V::zeros(),
        second,
    };
    check(Solid::capsule(0.3, 1.9), &whole);
}

#[test]
fn lines_and_surfaces() {
    let half = d(0.5);
    let rod = integrate(1, |[u, ..]| V::new(d(0.0), d(0.0), d(1.9) * (u - half)));
    check(Solid::rod(1.9), &rod);
    let disc = integrate(2, |[u, v, _]| cylindrical(d(0.8) * u, v, d(0.0)));
    check(Solid::disc(0.8), &disc);
    let plate = integrate(2, |[u, v, _]| {
        V::new(d(0.8) * (u - half), d(1.3) * (v - half), d(0.0))
    });
    check(Solid::plate(0.8, 1.3), &plate);
}

#[test]
fn thin_shells_lose_no_digits() {
    // Of the difference of the cubes four digits are left in f64.
    let inner = 0.9_f64;
    let outer = inner + 1e-12;
    let thickness = outer - inner;
    let shell = Solid::hollow_sphere(inner, outer).unwrap();
    let thin = Solid::spherical_shell(inner).unwrap();
    assert!((shell.content() / (thin.content() * thickness) - 1.0).abs() < 2e-12);
    let tube = Solid::tube(inner, outer, 2.0).unwrap();
    let sheet = 4.0 * std::f64::consts::PI * inner * thickness;
    assert!((tube.content() / sheet - 1.0).abs() < 2e-12);
    let [shell, thin] = [shell, thin].map(|solid| solid.with_mass(1.0).unwrap());
    assert!((shell.inertia().moments()[0] / thin.inertia().moments()[0] - 1.0).abs() < 3e-12);
}

#[test]
fn solids_on_other_scalars() {
    let single = Solid::capsule(0.3_f32, 1.9)
        .unwrap()
        .with_mass(2.0)
        .unwrap();
    let double = Solid::capsule(0.3, 1.9).unwrap().with_mass(2.0).unwrap();
    let precise = Solid::capsule(d(3.0) / d(10.0), d(19.0) / d(10.0)).unwrap();
    let precise = precise.with_mass(d(2.0)).unwrap();
    for k in 0..3 {
        let expected = precise.inertia().moments()[k].to_f64();
        let of_double = double.inertia().moments()[k];
        let of_single = f64::from(single.inertia().moments()[k]);
        assert!((of_double / expected - 1.0).abs() < 1e-15);
        assert!((of_single / expected - 1.0).abs() < 1e-6);
    }
    // 4/3 is no f64: with that of f64, the volume of a sphere would have sixteen digits.
    let sphere = Solid::sphere(d(1.0)).unwrap().content();
    let expected: D = "4.188790204786390984616857844372671".parse().unwrap();
    assert!((sphere - expected).to_f64().abs() < 1e-30);
}

#[test]
fn sizes_that_no_solid_has() {
    let radius = BodyError::NotPositive {
        quantity: "the radius of the cone",
        value: -0.5,
    };
    assert_eq!(Solid::cone(-0.5, 1.0), Err(radius));
    assert_eq!(
        Solid::plate(1.0, 0.0),
        Err(BodyError::NotPositive {
            quantity: "an edge of the plate",
            value: 0.0
        })
    );
    let tube = Solid::tube(0.6, 0.6, 1.0).unwrap_err();
    let text = "the inner radius is 0.6, but has to be less than the outer radius, 0.6";
    assert_eq!(tube.to_string(), text);
    let torus = Solid::torus(0.2, 0.3).unwrap_err();
    assert!(
        torus.to_string().starts_with("the minor radius is 0.3"),
        "{torus}"
    );
    let sphere = Solid::sphere(f64::INFINITY).unwrap_err();
    assert_eq!(sphere.to_string(), "the radius of the sphere is inf");
    assert!(Solid::rod(f64::NAN).is_err());
    let rod = Solid::rod(2.0).unwrap();
    assert_eq!(
        rod.with_density(-1.0),
        Err(BodyError::NotPositive {
            quantity: "the density",
            value: -1.0
        })
    );
    assert!(rod.with_mass(0.0).is_err());
}
