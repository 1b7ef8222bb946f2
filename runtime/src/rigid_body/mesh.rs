//! Solids bounded by closed triangle meshes.
//!
//! The integrals of 1, **r** and **r** **r**ᵀ over a polyhedron are exact: B. Mirtich, *Fast and Accurate Computation
//! of Polyhedral Mass Properties*, J. Graphics Tools **1** (1996) 31–50; D. Eberly, *Polyhedral Mass Properties
//! (Revisited)* (2002). They are summed over the tetrahedra between each triangle and a reference point, with the
//! closed forms of F. Tonon, *Explicit Exact Formulas for the 3-D Tetrahedron Inertia Tensor in Terms of its Vertex
//! Coordinates*, J. Math. Stat. **1** (2005) 8–11. The reference point lies amid the vertices, so that a body far from
//! the origin does not lose accuracy.

mod closed;
mod error;
#[cfg(feature = "mesh-files")]
mod files;
mod parts;
#[cfg(feature = "mesh-files")]
mod stl;

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::{Matrix3, Vector3};

pub use error::MeshError;
#[cfg(feature = "mesh-files")]
pub use files::MeshFileError;

use super::solid::Solid;
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::FLAT_MESH;
use crate::scalar::Scalar;

/// A surface made of triangles.
///
/// The vertices of each triangle are in counterclockwise order when seen from outside, as in STL and OBJ files. Nothing
/// is checked before [`solid`](Self::solid), which fails if the surface is open or a part of it is inside out. Meshes
/// may have several parts and cavities; the triangles of a cavity are seen from inside the cavity. Vertices that do not
/// belong to a triangle are ignored.
///
/// ```
/// use lagrangian::rigid_body::TriangleMesh;
/// use lagrangian::nalgebra::Vector3;
///
/// // The corner of a cube.
/// let corner = TriangleMesh {
///     vertices: vec![Vector3::zeros(), Vector3::x(), Vector3::y(), Vector3::z()],
///     triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
/// };
/// let body = corner.solid()?.with_density(6.0)?;
/// assert!((body.mass() - 1.0_f64).abs() < 1e-15);
/// assert!((body.center() - Vector3::repeat(0.25)).norm() < 1e-15);
/// // ∫ xy dm about the centre of gravity: 1/20 − 1/16.
/// assert!((body.inertia().products().xy + 0.0125).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleMesh<S: Scalar = f64> {
    /// The positions of the vertices.
    pub vertices: Vec<Vector3<S>>,
    /// The indices of the vertices of each triangle.
    pub triangles: Vec<[usize; 3]>,
}

impl<S: SingleNumber> TriangleMesh<S> {
    /// Returns the solid inside the surface.
    ///
    /// # Errors
    /// [`MeshError`] if a vertex index is out of range, a coordinate is not finite, the surface is open, neighbouring
    /// triangles are oriented inconsistently, the surface or a part of it is inside out, parts overlap without being
    /// cavities, or the volume is zero. Self-intersection of the surface is not checked.
    pub fn solid(&self) -> Result<Solid<S>, MeshError> {
        self.check_vertices()?;
        let edges = self.closed_edges()?;
        let reference = self.middle();
        let relative = |corners: [Vector3<S>; 3]| {
            corners.map(|corner| (corner - reference).map(Scalar::largest))
        };
        parts::check_parts(&self.corners().map(relative).collect::<Vec<_>>(), &edges)?;
        let mut integrals = Integrals::zero();
        let mut scale = 0.0;
        for corners in self.corners() {
            let corners = corners.map(|corner| corner - reference);
            let volume = integrals.add_tetrahedron(&corners);
            scale += volume.abs().largest();
        }
        let volume = integrals.volume.largest();
        // The rounding errors of the sum; the computed volume of a flat surface consists of nothing else.
        if volume.abs() <= FLAT_MESH * S::machine_epsilon() * scale {
            return Err(MeshError::Flat { volume });
        }
        if volume < 0.0 {
            return Err(MeshError::InsideOut { volume });
        }
        let Integrals {
            volume,
            first,
            second,
        } = integrals;
        Ok(Solid::from_integrals(volume, first, &second).moved(reference))
    }

    /// Returns the mesh with all lengths multiplied by a factor, for example to convert millimetres to metres.
    #[must_use]
    pub fn scaled(&self, factor: S) -> Self {
        let vertices = self.vertices.iter().map(|vertex| vertex * factor);
        Self {
            vertices: vertices.collect(),
            triangles: self.triangles.clone(),
        }
    }

    fn check_vertices(&self) -> Result<(), MeshError> {
        for (vertex, position) in self.vertices.iter().enumerate() {
            let values = position.iter().map(|x| x.largest());
            if let Some(value) = values.into_iter().find(|x| !x.is_finite()) {
                return Err(MeshError::NotFinite { vertex, value });
            }
        }
        let vertices = self.vertices.len();
        for (triangle, indices) in self.triangles.iter().enumerate() {
            if let Some(index) = indices.iter().copied().find(|index| *index >= vertices) {
                return Err(MeshError::NoVertex {
                    triangle,
                    index,
                    vertices,
                });
            }
        }
        Ok(())
    }

    /// Returns the mean of the vertices that belong to triangles.
    fn middle(&self) -> Vector3<S> {
        let mut is_used = vec![false; self.vertices.len()];
        for index in self.triangles.as_flattened() {
            if let Some(entry) = is_used.get_mut(*index) {
                *entry = true;
            }
        }
        let mut mean = Vector3::zeros();
        let mut weight = S::zero();
        let pairs = self.vertices.iter().zip(is_used);
        for (vertex, _) in pairs.filter(|(_, is_used)| *is_used) {
            weight += S::one();
            mean += (vertex - mean).map(|component| component / weight);
        }
        mean
    }

    /// Returns the positions of the vertices of each triangle.
    fn corners(&self) -> impl Iterator<Item = [Vector3<S>; 3]> + '_ {
        self.triangles.iter().filter_map(|indices| {
            let [a, b, c] = indices.map(|index| self.vertices.get(index).copied());
            Some([a?, b?, c?])
        })
    }
}

/// The integrals of 1, **r** and **r** **r**ᵀ over a solid.
struct Integrals<S: Scalar> {
    volume: S,
    first: Vector3<S>,
    second: Matrix3<S>,
}

impl<S: Scalar> Integrals<S> {
    fn zero() -> Self {
        Self {
            volume: S::zero(),
            first: Vector3::zeros(),
            second: Matrix3::zeros(),
        }
    }

    /// Adds the integrals over the tetrahedron between a triangle and the origin, with a negative sign if the triangle
    /// is seen from inside, and returns the volume V of the tetrahedron.
    ///
    /// ∫ **r** dV = V s/4 and ∫ **r** **r**ᵀ dV = V (Σ vᵢ vᵢᵀ + s sᵀ)/20 with s = Σ vᵢ.
    fn add_tetrahedron(&mut self, corners: &[Vector3<S>; 3]) -> S {
        let [a, b, c] = corners;
        let volume = a.dot(&b.cross(c)) / S::from_f64(6.0);
        let sum = a + b + c;
        let squares = a * a.transpose() + b * b.transpose() + c * c.transpose();
        self.volume += volume;
        self.first += sum * (volume / S::from_f64(4.0));
        self.second += (squares + sum * sum.transpose()) * (volume / S::from_f64(20.0));
        volume
    }
}
