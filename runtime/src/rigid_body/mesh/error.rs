//! The errors of triangle meshes.

use crate::error_messages::error_messages;
use crate::number_format::Readable;

/// The reason why a triangle mesh does not bound a solid.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate of a vertex is infinite or NaN.
    NotFinite {
        /// The index of the vertex.
        vertex: usize,
        /// The coordinate.
        value: f64,
    },
    /// A triangle has a vertex index that is out of range.
    NoVertex {
        /// The index of the triangle.
        triangle: usize,
        /// The index of the missing vertex.
        index: usize,
        /// The number of vertices.
        vertices: usize,
    },
    /// The surface has a boundary: an edge belongs to an odd number of triangles, such as one.
    Open {
        /// The index of a vertex at one end of the edge.
        from: usize,
        /// The index of the vertex at the other end.
        to: usize,
    },
    /// The triangles at an edge are not oriented consistently.
    InconsistentOrientation {
        /// The index of a vertex at one end of the edge.
        from: usize,
        /// The index of the vertex at the other end.
        to: usize,
    },
    /// The triangles are in clockwise order when seen from outside: the volume is negative.
    InsideOut {
        /// The volume.
        volume: f64,
    },
    /// A part is inside out, while the triangles of other parts are seen from outside, and it is not a cavity of
    /// another part.
    PartInsideOut {
        /// The index of the part, in the order of the first triangles of the parts.
        part: usize,
        /// The index of its first triangle.
        triangle: usize,
        /// Its volume.
        volume: f64,
    },
    /// A part occupies space that another part occupies, too: it lies within another part without being a cavity of it,
    /// it is given twice, or the parts intersect.
    OverlappingPart {
        /// The index of the part, in the order of the first triangles of the parts.
        part: usize,
        /// The index of its first triangle.
        triangle: usize,
        /// Its volume.
        volume: f64,
    },
    /// The surface encloses no volume, up to rounding errors.
    Flat {
        /// The volume that results from rounding errors.
        volume: f64,
    },
}

error_messages! { MeshError:
    Self::NotFinite { vertex, value } => "a coordinate of vertex {vertex} is {value}";
    Self::NoVertex { triangle, index, vertices } =>
        "triangle {triangle} has vertex {index}, but there are {vertices} vertices, from 0";
    Self::Open { from, to } =>
        "the surface is open: no second triangle is beside the edge between vertices {from} and {to}; vertices \
         at one place have to be one vertex";
    Self::InconsistentOrientation { from, to } =>
        "the triangles beside the edge between vertices {from} and {to} are seen from different sides: \
         interchange two vertices of one of them";
    Self::InsideOut { volume } =>
        "the surface is inside out, its volume is {}: vertices are in counterclockwise order seen from outside",
        Readable(volume);
    Self::PartInsideOut { part, triangle, volume } =>
        "part {part} of the surface, whose first triangle is {triangle}, is inside out, its volume is {}, and it is no \
         cavity of another part: interchange two vertices of each of its triangles",
        Readable(volume);
    Self::OverlappingPart { part, triangle, volume } =>
        "part {part} of the surface, whose first triangle is {triangle} and whose volume is {}, overlaps another part: \
         leave it out if it is there twice, join the parts if they intersect, or interchange two vertices of each of \
         its triangles if it is a cavity",
        Readable(volume);
    Self::Flat { volume } =>
        "the surface encloses no volume but {} of rounding errors",
        Readable(volume);
}
