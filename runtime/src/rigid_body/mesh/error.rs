//! What no solid is bounded by.

use core::fmt;

use crate::error_debug::debug_by_message;
use crate::number_format::Readable;

/// Why a triangle mesh does not bound a solid.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate of a vertex is infinite or not a number.
    NotFinite {
        /// The index of the vertex.
        vertex: usize,
        /// The coordinate.
        value: f64,
    },
    /// A triangle has an index beyond the vertices.
    NoVertex {
        /// The index of the triangle.
        triangle: usize,
        /// The index of the vertex that is missing.
        index: usize,
        /// How many vertices there are.
        vertices: usize,
    },
    /// The surface has a boundary: an edge belongs to one triangle, or to another odd number.
    Open {
        /// The index of a vertex at one end of the edge.
        from: usize,
        /// That at the other end.
        to: usize,
    },
    /// The triangles beside an edge are not seen from the same side.
    InconsistentOrientation {
        /// The index of a vertex at one end of the edge.
        from: usize,
        /// That at the other end.
        to: usize,
    },
    /// The triangles are in clockwise order seen from outside: the volume is negative.
    InsideOut {
        /// The volume.
        volume: f64,
    },
    /// A part is inside out: the triangles of others are seen from outside, and it is a cavity in none of them.
    PartInsideOut {
        /// The index of the part, in the order of the first triangles of the parts.
        part: usize,
        /// The index of its first triangle.
        triangle: usize,
        /// Its volume.
        volume: f64,
    },
    /// A part occupies space that another one occupies, too: it is within another part and no cavity of it, it is given twice, or
    /// the parts intersect.
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
        /// What rounding leaves.
        volume: f64,
    },
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { vertex, value } => {
                write!(f, "a coordinate of vertex {vertex} is {value}")
            }
            Self::NoVertex {
                triangle,
                index,
                vertices,
            } => write!(
                f,
                "triangle {triangle} has vertex {index}, but there are {vertices} vertices, from 0"
            ),
            Self::Open { from, to } => write!(
                f,
                "the surface is open: no second triangle is beside the edge between vertices {from} and {to}; vertices \
                 at one place have to be one vertex"
            ),
            Self::InconsistentOrientation { from, to } => write!(
                f,
                "the triangles beside the edge between vertices {from} and {to} are seen from different sides: \
                 interchange two vertices of one of them"
            ),
            Self::InsideOut { volume } => write!(
                f,
                "the surface is inside out, its volume is {}: vertices are in counterclockwise order seen from outside",
                Readable(volume)
            ),
            Self::PartInsideOut {
                part,
                triangle,
                volume,
            } => write!(
                f,
                "part {part} of the surface, whose first triangle is {triangle}, is inside out, its volume is {}, and it is no \
                 cavity of another part: interchange two vertices of each of its triangles",
                Readable(volume)
            ),
            Self::OverlappingPart {
                part,
                triangle,
                volume,
            } => write!(
                f,
                "part {part} of the surface, whose first triangle is {triangle} and whose volume is {}, overlaps another part: \
                 leave it out if it is there twice, join the parts if they intersect, or interchange two vertices of each of \
                 its triangles if it is a cavity",
                Readable(volume)
            ),
            Self::Flat { volume } => write!(
                f,
                "the surface encloses no volume but {} of rounding errors",
                Readable(volume)
            ),
        }
    }
}

debug_by_message!(MeshError);

impl core::error::Error for MeshError {}
