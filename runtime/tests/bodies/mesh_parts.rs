//! Meshes of several parts: which are solids, which cavities, and which neither; and files that hold several.
#![cfg(feature = "std")]

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{MeshError, TriangleMesh};

type V = Vector3<f64>;

const CORNER: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
const NOTHING: TriangleMesh = TriangleMesh {
    vertices: Vec::new(),
    triangles: Vec::new(),
};

/// The corner of a cube, of volume 1/6.
fn corner() -> TriangleMesh {
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
fn with(
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
fn volume(mesh: &TriangleMesh, expected: f64) {
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
                assert_eq!(triangle, first)
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

#[cfg(feature = "mesh-files")]
mod files {
    use super::*;
    use lagrangian::rigid_body::MeshFileError;
    use std::fmt::Write;
    use std::io::Cursor;

    fn solid(name: &str, shift: f64) -> String {
        let mut text = format!("solid{name}\n");
        for face in FACES {
            text += "  facet normal 0 0 0\n    outer loop\n";
            for [x, y, z] in face.map(|k| CORNER[k]) {
                writeln!(text, "      vertex {} {y} {z}", x + shift).unwrap();
            }
            text += "    endloop\n  endfacet\n";
        }
        writeln!(text, "endsolid{name}").unwrap();
        text
    }

    fn read(text: impl AsRef<[u8]>) -> Result<TriangleMesh, MeshFileError> {
        TriangleMesh::read_stl(&mut Cursor::new(text))
    }

    #[track_caller]
    fn is_corner(text: impl AsRef<[u8]>, times: f64) {
        let mesh = read(text)
            .unwrap_or_else(|error| panic!("{}", std::error::Error::source(&error).unwrap()));
        volume(&mesh, times / 6.0);
    }

    #[test]
    fn all_solids_of_a_text_are_read() {
        is_corner(solid(" a", 0.0) + &solid(" b", 10.0), 2.0);
        is_corner(
            (0..7).fold(String::new(), |all, k| all + &solid("", 3.0 * f64::from(k))),
            7.0,
        );
        // Without the last line, and without any.
        let text = solid(" a", 0.0) + &solid(" b", 10.0);
        is_corner(text.trim_end().trim_end_matches("endsolid b"), 2.0);
        is_corner(
            text.replace("endsolid a\n", "").replace("endsolid b\n", ""),
            2.0,
        );
    }

    #[test]
    fn spellings_of_text() {
        for name in [
            "",
            " ",
            " a",
            " a name of several words",
            " facet",
            " solid endsolid",
            " vertex 1 2 3",
            " Gehäuse",
        ] {
            let text = solid(name, 0.0);
            is_corner(&text, 1.0);
            is_corner(text.to_uppercase(), 1.0);
            is_corner(text.replace('\n', "\r\n"), 1.0);
            is_corner(text.replace('\n', " \t \r\n\r\n"), 1.0);
            is_corner(text.replace('\n', "\r"), 1.0);
            is_corner(format!("\u{feff}\n  {text}"), 1.0);
            is_corner(
                text.replace(" 1 ", " 1E+0 ")
                    .replace(" 0\n", " -0.000e-12\n"),
                1.0,
            );
            is_corner(text.replace(" 1 ", " +1.0 "), 1.0);
            is_corner(text.replace("normal 0 0 0", "normal nan -nan 1e39"), 1.0);
        }
        is_corner(solid(" a", 0.0).replace("\n    ", " "), 1.0);
    }

    #[test]
    fn what_is_wrong_in_a_text_is_said_with_its_line() {
        let text = solid(" a", 0.0);
        for (wrong, says) in [
            (
                text.replacen("vertex", "vertx", 1),
                "in line 4 there is `vertx` in place of `vertex`",
            ),
            (
                text.replacen("vertex 1 0 0", "vertex 1 0", 1),
                "in place of a number",
            ),
            (
                text.replacen("vertex 1 0 0", "vertex 1,0 0 0", 1),
                "`1,0` in place of a number",
            ),
            (
                text.replacen("    endloop", "      vertex 0 0 5\n    endloop", 1),
                "in line 7 there is `vertex` in place of `endloop`",
            ),
            (
                text.replace("outer loop", "loop"),
                "`loop` in place of `outer`",
            ),
            (
                text.replacen("  facet", "  color 1 0 0\n  facet", 1),
                "in line 2 there is `color` in place of `facet` or `endsolid`",
            ),
            (text.replace('\n', " "), "the text has no facet"),
            (
                text[..text.len() / 2 + 20].to_owned(),
                "the file ends in place of",
            ),
            (text.clone() + "facet", "in place of `solid`"),
            ("solidity".to_owned(), "8 bytes are no binary file"),
            (String::new(), "0 bytes are no binary file"),
            ("x".repeat(200), "a text begins with `solid`"),
        ] {
            let error = read(&wrong).unwrap_err();
            let source = std::error::Error::source(&error).unwrap().to_string();
            assert!(source.contains(says), "{source}, not {says}");
        }
        let mesh = read(text.replacen("vertex 1 0 0", "vertex 1 nan 0", 1)).unwrap();
        let error = mesh.solid().unwrap_err();
        assert!(
            matches!(error, MeshError::NotFinite { .. } | MeshError::Open { .. }),
            "{error}"
        );
    }

    fn binary(header: &[u8], mesh: &TriangleMesh) -> Vec<u8> {
        let mut bytes = header.to_vec();
        bytes.resize(80, b' ');
        bytes.extend(u32::try_from(mesh.triangles.len()).unwrap().to_le_bytes());
        for triangle in &mesh.triangles {
            bytes.extend([0xff; 12]);
            for value in triangle.iter().flat_map(|i| mesh.vertices[*i].iter()) {
                #[allow(clippy::cast_possible_truncation)] // The format has 32 bits.
                bytes.extend((*value as f32).to_le_bytes());
            }
            bytes.extend([0x0d, 0x0a]);
        }
        bytes
    }

    #[test]
    fn binary_files() {
        for header in [
            "",
            "solid",
            "solid part\nfacet normal 0 0 1",
            "SOLID X",
            "COLOR=\u{1}\u{2}",
        ] {
            let bytes = binary(header.as_bytes(), &corner());
            is_corner(&bytes, 1.0);
            is_corner(
                binary(
                    header.as_bytes(),
                    &with(&corner(), &corner(), 1.0, [4.0; 3], false),
                ),
                2.0,
            );
            // Truncated, and two files in one.
            assert!(read(&bytes[..bytes.len() - 1]).is_err());
            assert!(read([bytes.clone(), bytes.clone()].concat()).is_err());
        }
        assert_eq!(read(binary(b"none", &NOTHING)).unwrap(), NOTHING);
    }

    #[test]
    fn objects() {
        let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\n";
        let absolute = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
        let relative = "f -5 -3 -4\nf -5 -4 -2\nf -5 -2 -3\nf -4 -3 -2\n";
        let grouped = "o a\ng one\nf 1/1/1 3/1/1 2/1/1\nvn 0 0 1\ng two three\nf 1//1 2//1 4//1\ns off\nf 1 4 3\no b\nusemtl x\nf 2 3 4\n";
        for faces in [absolute, relative, grouped] {
            let texture = if faces == grouped { "vt 0 0\n" } else { "" };
            let normal = if faces == grouped { "vn 0 0 1\n" } else { "" };
            let text = format!("# comment\r\nmtllib x.mtl\n{vertices}{texture}{normal}{faces}");
            for text in [text.clone(), text.replace('\n', " \r\n")] {
                let mesh = TriangleMesh::read_obj(&mut text.as_bytes());
                volume(&mesh.unwrap(), 1.0 / 6.0);
            }
        }
        // A prism whose base is not convex: its volume is 3.
        let base = [[0, 0], [2, 0], [2, 2], [1, 1], [0, 2]];
        let mut text = String::new();
        for (z, [x, y]) in [0, 1]
            .into_iter()
            .flat_map(|z| base.map(|point| (z, point)))
        {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        text += "f 5 4 3 2 1\nf 6 7 8 9 10\n";
        for k in 0..5 {
            let next = (k + 1) % 5;
            writeln!(text, "f {} {} {} {}", k + 1, next + 1, next + 6, k + 6).unwrap();
        }
        volume(&TriangleMesh::read_obj(&mut text.as_bytes()).unwrap(), 3.0);
        for wrong in ["f 1 3 7\n", "f 1 3 0\n", "f 1 3 -9\n", "f 1 b 2\n"] {
            let text = format!("{vertices}{wrong}");
            let mesh = TriangleMesh::read_obj(&mut text.as_bytes());
            assert!(mesh.map_or(true, |mesh| mesh.solid().is_err()), "{wrong}");
        }
    }
}
