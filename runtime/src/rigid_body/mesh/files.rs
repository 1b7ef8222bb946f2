//! Triangle meshes from files: STL is parsed here, OBJ by the crate `tobj`.

use core::fmt;
use std::collections::HashMap;
use std::io::{BufRead, Read};
use std::path::Path;
use std::vec::Vec;

use nalgebra::Vector3;

use super::{TriangleMesh, stl};
use crate::error_debug::debug_by_message;

/// The reason why a mesh could not be read from a file.
#[non_exhaustive]
pub enum MeshFileError {
    /// An STL file could not be read.
    Stl(std::io::Error),
    /// An OBJ file could not be read.
    Obj(tobj::LoadError),
}

impl fmt::Display for MeshFileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stl(_) => f.write_str("the STL file could not be read"),
            Self::Obj(_) => f.write_str("the OBJ file could not be read"),
        }
    }
}

debug_by_message!(MeshFileError);

impl core::error::Error for MeshFileError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Stl(error) => Some(error),
            Self::Obj(error) => Some(error),
        }
    }
}

impl TriangleMesh<f64> {
    /// Reads the mesh of an STL file, text or binary, with all its solids.
    ///
    /// Vertices with equal coordinates are merged. Normals, names and colours are ignored, and keywords may be in upper
    /// case. The format does not specify a unit; [`scaled`](Self::scaled) converts lengths.
    ///
    /// # Errors
    /// [`MeshFileError::Stl`] if the file cannot be read; the source of the error states the line, or why the file is
    /// not a binary file.
    ///
    /// ```
    /// use lagrangian::rigid_body::TriangleMesh;
    /// use std::io::Cursor;
    ///
    /// let text = "solid corner\n\
    ///     facet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nendloop\nendfacet\nendsolid\n";
    /// let mesh = TriangleMesh::read_stl(&mut Cursor::new(text))?;
    /// assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (3, 1));
    /// // One triangle bounds nothing.
    /// assert!(mesh.solid().is_err());
    /// # Ok::<(), lagrangian::rigid_body::MeshFileError>(())
    /// ```
    pub fn read_stl<R: Read>(reader: &mut R) -> Result<Self, MeshFileError> {
        let mut bytes = Vec::new();
        reader.read_to_end(&mut bytes).map_err(MeshFileError::Stl)?;
        let facets = stl::facets(&bytes).map_err(MeshFileError::Stl)?;
        let positions = facets.as_flattened().iter();
        let positions: Vec<_> = positions.map(|vertex| vertex.map(f64::from)).collect();
        let triangles = (0..facets.len()).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        Ok(Self::welded(&positions, triangles))
    }

    /// Reads the mesh of an OBJ file with all its objects; polygons are divided into triangles.
    ///
    /// Vertices with equal coordinates are merged. Materials, texture coordinates and normals are ignored.
    ///
    /// # Errors
    /// [`MeshFileError::Obj`] if the file cannot be read.
    ///
    /// ```
    /// use lagrangian::rigid_body::TriangleMesh;
    ///
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    /// let mesh = TriangleMesh::read_obj(&mut text.as_bytes())?;
    /// assert!((mesh.solid()?.content() - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn read_obj<R: BufRead>(reader: &mut R) -> Result<Self, MeshFileError> {
        let options = tobj::LoadOptions {
            triangulate: true,
            ignore_points: true,
            ignore_lines: true,
            ..tobj::LoadOptions::default()
        };
        let no_materials = |_: &Path| Ok((Vec::new(), HashMap::default()));
        let (models, _) =
            tobj::load_obj_buf(reader, &options, no_materials).map_err(MeshFileError::Obj)?;
        let mut positions = Vec::new();
        let mut triangles = Vec::new();
        for model in &models {
            let first = positions.len();
            let (points, _) = model.mesh.positions.as_chunks::<3>();
            positions.extend_from_slice(points);
            let (corners, _) = model.mesh.indices.as_chunks::<3>();
            // An index that does not fit is out of range, which `solid` reports.
            let index = |index: u32| usize::try_from(index).unwrap_or(usize::MAX);
            triangles.extend(
                corners
                    .iter()
                    .map(|corners| corners.map(|corner| index(corner).saturating_add(first))),
            );
        }
        Ok(Self::welded(&positions, triangles))
    }

    /// Returns the mesh in which equal positions are one vertex.
    fn welded(positions: &[[f64; 3]], triangles: impl IntoIterator<Item = [usize; 3]>) -> Self {
        let mut vertices = Vec::new();
        let mut known = HashMap::new();
        let mut places = Vec::new();
        for position in positions {
            // −0 is 0.
            let bits = position.map(|x| (x + 0.0).to_bits());
            let place = *known.entry(bits).or_insert_with(|| {
                vertices.push(Vector3::from(*position));
                vertices.len() - 1
            });
            places.push(place);
        }
        let place = |index: usize| places.get(index).copied().unwrap_or(usize::MAX);
        let triangles = triangles.into_iter().map(|corners| corners.map(place));
        Self {
            vertices,
            triangles: triangles.collect(),
        }
    }
}
