//! Meshes of several parts: which are solids, which cavities, and which neither.
#![cfg(feature = "std")]

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{MeshError, TriangleMesh};

type V = Vector3<f64>;

pub(super) const CORNER: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
pub(super) const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
pub(super) const NOTHING: TriangleMesh = TriangleMesh {
    vertices: Vec::new(),
    triangles: Vec::new(),
};

/// The corner of a cube, of volume 1/6.
pub(super) fn corner() -> TriangleMesh {
    TriangleMesh {
        vertices: CORNER.map(V::from).to_vec(),
        triangles: FACES.to_vec(),
    }
}

/// A cube of edge 1, its lower corner at the origin.
fn cube() -> TriangleMesh {
    let bit = |index: usize, k: usize| if index >> k & 1 == 0 { 0.0 } else { 1.0 };
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    TriangleMesh {
        vertices: (0..8)
            .map(|i| V::new(bit(i, 0), bit(i, 1), bit(i, 2)))
            .collect(),
        triangles: faces
            .iter()
            .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
            .collect(),
    }
}

/// The mesh with a part added, in a size, at a place, seen from inside or not.
pub(super) fn with(
    mesh: &TriangleMesh,
    part: &TriangleMesh,
    size: f64,
    place: [f64; 3],
    flip: bool,
) -> TriangleMesh {
    let mut all = mesh.clone();
    let count = all.vertices.len();
    all.vertices
        .extend(part.vertices.iter().map(|r| size * r + V::from(place)));
    all.triangles.extend(part.triangles.iter().map(|t| {
        let [a, b, c] = t.map(|i| i + count);
        if flip { [a, c, b] } else { [a, b, c] }
    }));
    all
}

/// The mesh in which equal positions are one vertex.
fn welded(mesh: &TriangleMesh) -> TriangleMesh {
    let place = |index: usize| {
        let position = mesh.vertices[index];
        mesh.vertices
            .iter()
            .position(|other| *other == position)
            .unwrap()
    };
    TriangleMesh {
        vertices: mesh.vertices.clone(),
        triangles: mesh.triangles.iter().map(|t| t.map(place)).collect(),
    }
}

#[track_caller]
pub(super) fn volume(mesh: &TriangleMesh, expected: f64) {
    assert_close(mesh.solid().unwrap().content() / expected, 1.0, 1e-14);
}

#[test]
fn a_separate_part_that_is_inside_out_is_named() {
    for size in [0.5, 1.0, 3.0] {
        for first in [corner(), cube()] {
            for place in [[5.0, 0.0, 0.0], [-7.0, 0.1, 0.3], [0.9, 2.1, 0.0]] {
                let mesh = with(&first, &corner(), size, place, true);
                let error = mesh.solid().unwrap_err();
                let MeshError::PartInsideOut {
                    part,
                    triangle,
                    volume,
                } = error
                else {
                    panic!("{error}");
                };
                assert_eq!((part, triangle), (1, first.triangles.len()));
                assert_close(volume, -size.powi(3) / 6.0, 1e-14);
                // In the other order.
                let mesh = with(
                    &with(&NOTHING, &corner(), size, place, true),
                    &first,
                    1.0,
                    [0.0; 3],
                    false,
                );
                let error = mesh.solid().unwrap_err();
                assert!(
                    matches!(
                        error,
                        MeshError::PartInsideOut {
                            part: 0,
                            triangle: 0,
                            ..
                        }
                    ),
                    "{error}"
                );
            }
        }
    }
    let both = with(
        &with(&NOTHING, &cube(), 1.0, [0.0; 3], true),
        &cube(),
        2.0,
        [4.0, 0.0, 0.0],
        true,
    );
    let error = both.solid().unwrap_err();
    let MeshError::InsideOut { volume } = error else {
        panic!("{error}")
    };
    assert_close(volume, -9.0, 1e-14);
}

/// Shells within shells: solid, cavity, solid in the cavity, cavity in that.
#[test]
fn parts_within_parts() {
    let sizes = [8.0, 4.0, 2.0, 1.0];
    let place = |k: usize| [0.3 * f64::from(u8::try_from(k).unwrap()) + 0.5; 3];
    for depth in 1..=4 {
        for flips in 0..1 << depth {
            let mesh = (0..depth).fold(NOTHING, |mesh, k| {
                with(&mesh, &cube(), sizes[k], place(k), flips >> k & 1 == 1)
            });
            let volumes =
                (0..depth).map(|k| sizes[k].powi(3) * if flips >> k & 1 == 1 { -1.0 } else { 1.0 });
            let right = (0..depth).fold(0, |flips, k| flips | (k & 1) << k);
            if flips == right {
                volume(&mesh, volumes.sum());
            } else if flips == (1 << depth) - 1 - right {
                assert!(matches!(
                    mesh.solid().unwrap_err(),
                    MeshError::InsideOut { .. }
                ));
            } else {
                let error = mesh.solid().unwrap_err();
                assert!(
                    matches!(
                        error,
                        MeshError::PartInsideOut { .. } | MeshError::OverlappingPart { .. }
                    ),
                    "{depth} {flips:b}: {error}"
                );
            }
        }
    }
}

#[test]
fn parts_that_touch() {
    // At a face, an edge and a corner; with vertices of their own and with common ones.
    for place in [
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 1.0, 1.0],
        [0.25, 0.25, 1.0],
    ] {
        for size in [1.0, 0.5, 2.0] {
            let mesh = with(&cube(), &cube(), size, place, false);
            let turned = with(&cube(), &cube(), size, place, true);
            for (mesh, turned) in [
                (mesh.clone(), turned.clone()),
                (welded(&mesh), welded(&turned)),
            ] {
                volume(&mesh, 1.0 + size * size * size);
                let error = turned.solid().unwrap_err();
                assert!(
                    matches!(
                        error,
                        MeshError::PartInsideOut { part: 1, .. } | MeshError::Flat { .. }
                    ),
                    "{place:?} {size}: {error}"
                );
            }
        }
    }
    // A cavity that touches the surface.
    let notch = with(&cube(), &cube(), 0.5, [0.25, 0.25, 0.5], true);
    volume(&notch, 0.875);
    volume(
        &with(&cube(), &corner(), 0.5, [0.0; 3], true),
        1.0 - 0.125 / 6.0,
    );
}

#[test]
fn parts_that_are_there_twice() {
    for mesh in [cube(), corner()] {
        let twice = with(&mesh, &mesh, 1.0, [0.0; 3], false);
        for twice in [twice.clone(), welded(&twice)] {
            let error = twice.solid().unwrap_err();
            assert!(
                matches!(error, MeshError::OverlappingPart { .. }),
                "{error}"
            );
        }
        // One cancels the other.
        let none = with(&mesh, &mesh, 1.0, [0.0; 3], true);
        let error = none.solid().unwrap_err();
        assert!(matches!(error, MeshError::Flat { .. }), "{error}");
    }
    let within = with(&cube(), &cube(), 0.25, [0.2, 0.3, 0.4], false);
    let error = within.solid().unwrap_err();
    assert!(
        matches!(error, MeshError::OverlappingPart { .. }),
        "{error}"
    );
}

/// Many balls in random order, some hollow: any one of them turned is found.
#[test]
fn many_parts() {
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        f64::from(u32::try_from(seed >> 40).unwrap()) / f64::from(1 << 24)
    };
    for round in 0..20 {
        let count = 30;
        let turned = if round % 2 == 0 { None } else { Some(round) };
        let (mut mesh, mut expected) = (NOTHING, 0.0);
        let mut first = 0;
        for k in 0..count {
            let place = [3.0 * f64::from(k), 5.0 * random(), 5.0 * random()];
            let size = 0.5 + random();
            if turned == Some(k) {
                first = mesh.triangles.len();
            }
            mesh = with(&mesh, &cube(), size, place, turned == Some(k));
            expected += size.powi(3);
            if k % 3 == 0 && turned != Some(k) {
                let [x, y, z] = place.map(|x| x + 0.3 * size);
                mesh = with(&mesh, &corner(), 0.4 * size, [x, y, z], true);
                expected -= (0.4 * size).powi(3) / 6.0;
            }
        }
        match (turned, mesh.solid()) {
            (None, found) => assert_close(found.unwrap().content() / expected, 1.0, 1e-13),
            (Some(_), Err(MeshError::PartInsideOut { triangle, .. })) => {
                assert_eq!(triangle, first);
            }
            (Some(_), other) => panic!("{other:?}"),
        }
    }
}

#[test]
fn vertices_that_no_triangle_has_do_not_matter() {
    let expected = corner().solid().unwrap();
    for far in [1e3, 1e4, 1e5, 1e10, 1e150] {
        let mut mesh = corner();
        mesh.vertices.push(V::new(far, -far, 0.0));
        assert_eq!(mesh.solid().unwrap(), expected);
    }
}

#[test]
fn triangles_without_an_area() {
    let mut mesh = cube();
    mesh.triangles.push([0, 0, 1]);
    mesh.triangles.push([1, 1, 1]);
    volume(&mesh, 1.0);
    // An edge is divided on one side, and a triangle closes the gap.
    let mut mesh = corner();
    mesh.vertices.push(V::new(0.5, 0.0, 0.0));
    mesh.triangles[0] = [0, 2, 4];
    mesh.triangles.extend([[4, 2, 1], [0, 4, 1]]);
    volume(&mesh, 1.0 / 6.0);
}
