//! Triangle meshes: polyhedra exactly, by two formulas; curved solids with the expected convergence.
#![cfg(feature = "std")]

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{MeshError, RigidBody, Solid, TriangleMesh};
use nalgebra::Rotation3;

type V = Vector3<f64>;

/// A box, its corners at ± half of the edges.
fn cuboid(edges: V) -> TriangleMesh {
    let corner = |index: usize| {
        let side = |bit: usize| if index >> bit & 1 == 0 { -0.5 } else { 0.5 };
        edges.component_mul(&V::new(side(0), side(1), side(2)))
    };
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    TriangleMesh {
        vertices: (0..8).map(corner).collect(),
        triangles: faces
            .iter()
            .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
            .collect(),
    }
}

/// A grid on a surface with `n` meridians and `m` parallels between two poles.
fn revolved(n: usize, m: usize, point: impl Fn(f64, f64) -> V) -> TriangleMesh {
    let number = |i: usize| f64::from(u32::try_from(i).unwrap());
    let mut vertices = vec![point(0.0, 0.0), point(1.0, 0.0)];
    for i in 1..m {
        vertices.extend((0..n).map(|j| point(number(i) / number(m), number(j) / number(n))));
    }
    let at = |i: usize, j: usize| match i {
        0 => 0,
        i if i == m => 1,
        _ => 2 + (i - 1) * n + j % n,
    };
    let mut triangles = Vec::new();
    for i in 0..m {
        for j in 0..n {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            triangles.extend(
                [[a, b, c], [a, c, d]]
                    .into_iter()
                    .filter(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]),
            );
        }
    }
    TriangleMesh {
        vertices,
        triangles,
    }
}

fn sphere_point(polar: f64, turns: f64) -> V {
    let (s, c) = (std::f64::consts::PI * polar).sin_cos();
    let (y, x) = (2.0 * std::f64::consts::PI * turns).sin_cos();
    V::new(s * x, s * y, c)
}

fn changed(mesh: &TriangleMesh, rotation: &Rotation3<f64>, displacement: V) -> TriangleMesh {
    let vertices = mesh.vertices.iter().map(|r| rotation * r + displacement);
    TriangleMesh {
        vertices: vertices.collect(),
        triangles: mesh.triangles.clone(),
    }
}

#[track_caller]
fn close(found: &RigidBody, expected: &RigidBody, tolerance: f64) {
    assert_close(found.mass() / expected.mass(), 1.0, tolerance);
    let size = expected.inertia().matrix().norm();
    assert_close((found.center() - expected.center()).norm(), 0.0, tolerance);
    let error = found.inertia().matrix() - expected.inertia().matrix();
    assert_close(error.norm() / size, 0.0, tolerance);
}

#[test]
fn boxes_are_exact_wherever_they_are() {
    let expected = Solid::cuboid(0.5, 1.5, 2.5)
        .unwrap()
        .with_density(3.0)
        .unwrap();
    let mesh = cuboid(V::new(0.5, 1.5, 2.5));
    close(
        &mesh.solid().unwrap().with_density(3.0).unwrap(),
        &expected,
        4e-15,
    );
    let rotation = Rotation3::from_scaled_axis(V::new(0.3, -1.0, 2.0));
    let displacement = V::new(10.0, -20.0, 5.0);
    let body = changed(&mesh, &rotation, displacement).solid().unwrap();
    let expected = expected.turned(&rotation).moved(displacement);
    close(&body.with_density(3.0).unwrap(), &expected, 4e-14);
    let small = mesh.scaled(1e-3).solid().unwrap();
    assert_close(small.content() * 1e9, 1.875, 1e-14);
}

/// The ten integrals by the algorithm of Eberly (2002), with polynomials of the coordinates for each face.
fn eberly(mesh: &TriangleMesh) -> [f64; 10] {
    let mut integrals = [0.0; 10];
    for [a, b, c] in &mesh.triangles {
        let [p, q, r] = [a, b, c].map(|i| mesh.vertices[*i]);
        let d = (q - p).cross(&(r - p));
        let term = |k: usize| {
            let (w0, w1, w2) = (p[k], q[k], r[k]);
            let f1 = w0 + w1 + w2;
            let f2 = w0 * w0 + w1 * (w0 + w1) + w2 * f1;
            let f3 = w0 * w0 * w0 + w1 * (w0 * w0 + w1 * (w0 + w1)) + w2 * f2;
            let g = [w0, w1, w2].map(|w| f2 + w * (f1 + w));
            (f1, f2, f3, g)
        };
        let [x, y, z] = [term(0), term(1), term(2)];
        let mixed = |first: [f64; 3], k: usize| first[0] * p[k] + first[1] * q[k] + first[2] * r[k];
        let added = [
            d.x * x.0,
            d.x * x.1,
            d.y * y.1,
            d.z * z.1,
            d.x * x.2,
            d.y * y.2,
            d.z * z.2,
            d.x * mixed(x.3, 1),
            d.y * mixed(y.3, 2),
            d.z * mixed(z.3, 0),
        ];
        for (sum, term) in integrals.iter_mut().zip(added) {
            *sum += term;
        }
    }
    let factors = [6.0, 24.0, 24.0, 24.0, 60.0, 60.0, 60.0, 120.0, 120.0, 120.0];
    let mut factors = factors.into_iter();
    integrals.map(|integral| integral / factors.next().unwrap())
}

#[test]
fn an_irregular_polyhedron_by_the_algorithm_of_eberly() {
    // Every radius of the sphere is changed: nothing is symmetric.
    let mut mesh = revolved(9, 7, sphere_point);
    for (vertex, i) in mesh.vertices.iter_mut().zip(1_u32..) {
        *vertex *= 1.0 + 0.5 * (f64::from(i) * 0.618_033_988_749_894_9).fract();
    }
    let mesh = changed(&mesh, &Rotation3::identity(), V::new(0.3, -0.2, 0.7));
    let body = mesh.solid().unwrap().with_density(1.0).unwrap();
    let [volume, x, y, z, xx, yy, zz, xy, yz, zx] = eberly(&mesh);
    assert_close(body.mass(), volume, 1e-13);
    for (found, expected) in body.center().iter().zip([x, y, z]) {
        assert_close(*found, expected / volume, 1e-13);
    }
    let about = body.inertia_about(&V::zeros());
    for (found, expected) in about.moments().into_iter().zip([yy + zz, xx + zz, xx + yy]) {
        assert_close(found, expected, 1e-12);
    }
    let products = about.products();
    let found = [products.xy, products.yz, products.xz];
    for (found, expected) in found.into_iter().zip([xy, yz, zx]) {
        assert_close(found, expected, 1e-12);
    }
}

/// Halved triangles have a quarter of the error: slopes of the logarithm between grids.
fn converges(name: &str, exact: &Solid, point: impl Fn(f64, f64) -> V + Copy) {
    let exact = exact.with_density(2.0).unwrap();
    let error = |n: usize| {
        let body = revolved(2 * n, n, point)
            .solid()
            .unwrap()
            .with_density(2.0)
            .unwrap();
        let moment = |k: usize| body.inertia().moments()[k] / exact.inertia().moments()[k] - 1.0;
        [body.mass() / exact.mass() - 1.0, moment(0), moment(2)]
    };
    let [coarse, fine] = [error(24), error(48)];
    for k in 0..3 {
        assert!(coarse[k] < 0.0, "{name}: inscribed");
        assert_close((coarse[k] / fine[k]).log2(), 2.0, 0.01);
    }
}

#[test]
fn curved_solids_converge_with_the_square_of_the_edges() {
    converges("sphere", &Solid::sphere(1.0).unwrap(), sphere_point);
    let axes = V::new(0.5, 1.0, 2.0);
    let ellipsoid = Solid::ellipsoid(0.5, 1.0, 2.0).unwrap();
    converges("ellipsoid", &ellipsoid, |u, v| {
        sphere_point(u, v).component_mul(&axes)
    });
    // From the centre of one base over its edge to the centre of the other one; the edges are grid lines.
    let cylinder = |u: f64, v: f64| {
        let distance = (3.0 * u).min(1.0).min(3.0 - 3.0 * u);
        let height = (3.0 * (0.5 - u)).clamp(-0.5, 0.5);
        let around = sphere_point(0.5, v);
        V::new(distance * around.x, distance * around.y, 2.0 * height)
    };
    converges("cylinder", &Solid::cylinder(1.0, 2.0).unwrap(), cylinder);
}

#[test]
fn cavities_and_several_parts() {
    let outer = cuboid(V::repeat(2.0));
    let inner = cuboid(V::repeat(1.0));
    let count = outer.vertices.len();
    let with = |flip: bool, displacement: V| {
        let mut mesh = outer.clone();
        mesh.vertices
            .extend(inner.vertices.iter().map(|r| r + displacement));
        mesh.triangles.extend(inner.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|i| i + count);
            if flip { [a, c, b] } else { [a, b, c] }
        }));
        mesh.solid().unwrap().with_density(1.0).unwrap()
    };
    let cube = |edge: f64| {
        Solid::cuboid(edge, edge, edge)
            .unwrap()
            .with_density(1.0)
            .unwrap()
    };
    let displacement = V::new(0.3, 0.2, -0.4);
    let hollow = cube(2.0).minus(&cube(1.0).moved(displacement)).unwrap();
    close(&with(true, displacement), &hollow, 1e-14);
    let displacement = V::new(3.0, 0.2, -0.4);
    let both = cube(2.0).plus(&cube(1.0).moved(displacement));
    close(&with(false, displacement), &both, 1e-14);
}

#[test]
fn surfaces_that_bound_no_solid() {
    let cube = cuboid(V::repeat(1.0));
    let with = |change: &dyn Fn(&mut TriangleMesh)| {
        let mut mesh = cube.clone();
        change(&mut mesh);
        mesh.solid().unwrap_err()
    };
    let open = with(&|mesh| {
        mesh.triangles.pop();
    });
    assert_eq!(open, MeshError::Open { from: 1, to: 5 });
    let turned = with(&|mesh| mesh.triangles[0].swap(0, 1));
    assert!(
        matches!(turned, MeshError::InconsistentOrientation { .. }),
        "{turned}"
    );
    let inside_out = with(&|mesh| mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1)));
    let MeshError::InsideOut { volume } = inside_out else {
        panic!("{inside_out}");
    };
    assert_close(volume, -1.0, 1e-15);
    let missing = with(&|mesh| mesh.triangles[3][2] = 8);
    assert_eq!(
        missing,
        MeshError::NoVertex {
            triangle: 3,
            index: 8,
            vertices: 8
        }
    );
    let odd = with(&|mesh| mesh.vertices[6].y = f64::NAN);
    assert!(
        matches!(odd, MeshError::NotFinite { vertex: 6, .. }),
        "{odd}"
    );
    let flat = with(&|mesh| mesh.vertices.iter_mut().for_each(|r| r.z = 0.1));
    assert!(matches!(flat, MeshError::Flat { .. }), "{flat}");
    let none = with(&|mesh| mesh.triangles.clear());
    assert!(matches!(none, MeshError::Flat { .. }), "{none}");
}

#[cfg(feature = "mesh-files")]
mod files {
    use std::fmt::Write;
    use std::io::Cursor;

    use super::{V, close, cuboid};
    use lagrangian::rigid_body::{MeshFileError, Solid, TriangleMesh};

    /// Both formats of STL, written here: text, and 84 bytes with 50 for each triangle.
    fn stl(mesh: &TriangleMesh) -> (String, Vec<u8>) {
        let mut text = String::from("solid box\n");
        let mut bytes = vec![0_u8; 80];
        bytes.extend(u32::try_from(mesh.triangles.len()).unwrap().to_le_bytes());
        for triangle in &mesh.triangles {
            text += "facet normal 0 0 0\nouter loop\n";
            bytes.extend([0; 12]);
            for index in triangle {
                let [x, y, z]: [f64; 3] = mesh.vertices[*index].into();
                writeln!(text, "vertex {x} {y} {z}").unwrap();
                for value in [x, y, z] {
                    #[allow(clippy::cast_possible_truncation)] // The format has 32 bits.
                    bytes.extend((value as f32).to_le_bytes());
                }
            }
            text += "endloop\nendfacet\n";
            bytes.extend([0; 2]);
        }
        (text + "endsolid box\n", bytes)
    }

    #[test]
    fn boxes_from_files() {
        let mesh = cuboid(V::new(0.5, 1.5, 2.5));
        let expected = Solid::cuboid(0.5, 1.5, 2.5)
            .unwrap()
            .with_density(2.0)
            .unwrap();
        let (text, bytes) = stl(&mesh);
        let mut obj = String::new();
        for r in &mesh.vertices {
            writeln!(obj, "v {} {} {}", r.x, r.y, r.z).unwrap();
        }
        // Two objects, quadrilaterals, and −0.
        obj +=
            "o lower\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\no upper\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        let read = [
            TriangleMesh::read_stl(&mut Cursor::new(text)).unwrap(),
            TriangleMesh::read_stl(&mut Cursor::new(bytes)).unwrap(),
            TriangleMesh::read_obj(&mut obj.as_bytes()).unwrap(),
        ];
        for found in read {
            assert_eq!((found.vertices.len(), found.triangles.len()), (8, 12));
            close(
                &found.solid().unwrap().with_density(2.0).unwrap(),
                &expected,
                1e-14,
            );
        }
    }

    #[test]
    fn what_is_no_file() {
        let error = TriangleMesh::read_obj(&mut "v 1 x 0\nf 1 2 3\n".as_bytes()).unwrap_err();
        assert!(matches!(error, MeshFileError::Obj(_)), "{error}");
        let error =
            TriangleMesh::read_stl(&mut Cursor::new("solid\nfacet normal 0 0\n")).unwrap_err();
        assert!(matches!(error, MeshFileError::Stl(_)), "{error}");
        let error = TriangleMesh::read_obj(&mut "v 0 0 0\nf 1 2 3\n".as_bytes());
        assert!(error.is_err());
    }
}
