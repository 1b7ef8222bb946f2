//! Mesh files in the spellings that are in use, and what is said of others.
#![cfg(feature = "mesh-files")]

use crate::mesh_parts::{CORNER, FACES, NOTHING, corner, volume, with};
use lagrangian::rigid_body::{MeshError, MeshFileError, TriangleMesh};
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
    let mesh =
        read(text).unwrap_or_else(|error| panic!("{}", std::error::Error::source(&error).unwrap()));
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
