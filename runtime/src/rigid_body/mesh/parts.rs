//! The parts of a closed mesh, and the test that each is oriented correctly.
//!
//! A part is a set of triangles that is closed by itself. If the triangles bound a solid, the winding number of the
//! whole mesh about a point is 1 inside and 0 outside, on both sides of every part: a cavity is seen from inside, and
//! lies within another part. Winding numbers are sums of solid angles: A. van Oosterom and J. Strackee, *The Solid
//! Angle of a Plane Triangle*, IEEE Trans. Biomed. Eng. **30** (1983) 125–126; A. Jacobson, L. Kavan and O.
//! Sorkine-Hornung, *Robust Inside-Outside Segmentation using Generalized Winding Numbers*, ACM Trans. Graph. **32**
//! (2013) 33.

use alloc::vec::Vec;
use core::f64::consts::PI;

use nalgebra::Vector3;

use super::closed::Edge;
use super::error::MeshError;
use crate::limits::rigid_bodies::{COINCIDENT, SAMPLED_TRIANGLES, UNCERTAIN_WINDING};

type V = Vector3<f64>;
type Corners = [V; 3];

/// The weights of the corners of a triangle that give a point inside it. The point does not lie on a line of symmetry,
/// where an edge of another triangle is likely to be.
const WEIGHTS: [f64; 3] = [
    0.381_966_011_250_105,
    0.338_261_212_717_717,
    0.279_772_776_032_178,
];

/// A part of a mesh.
struct Part {
    /// The indices of its triangles, in order.
    triangles: Vec<usize>,
    volume: f64,
    /// The least and the largest coordinates.
    bounds: [V; 2],
}

/// The winding numbers in front of a triangle and behind it.
type Sides = [f64; 2];

/// Fails unless the parts of a closed mesh bound one solid. `corners` contains the corners of all triangles, relative
/// to a point amid them.
pub(super) fn check_parts(corners: &[Corners], edges: &[Edge]) -> Result<(), MeshError> {
    let parts = parts(corners, edges);
    if parts.len() < 2 {
        return Ok(());
    }
    let sides: Vec<_> = parts
        .iter()
        .map(|part| sides(corners, &parts, part))
        .collect();
    let within = |[least, most]: [f64; 2], sides: &Option<Sides>| {
        let sides = sides.as_ref();
        sides.is_some_and(|sides| sides.iter().all(|x| (least..=most).contains(x)))
    };
    let is_negative =
        |sides: &Option<Sides>| sides.is_some_and(|sides| sides.iter().any(|x| *x < 0.0));
    if sides.iter().all(|sides| within([-1.0, 0.0], sides)) && sides.iter().any(is_negative) {
        let volume = parts.iter().map(|part| part.volume).sum();
        return Err(MeshError::InsideOut { volume });
    }
    let wrong = sides.iter().position(|sides| !within([0.0, 1.0], sides));
    let Some(index) = wrong else { return Ok(()) };
    let (part, volume) = (index, parts[index].volume);
    let triangle = parts[index].triangles.first().copied().unwrap_or(0);
    Err(if is_negative(&sides[index]) {
        MeshError::PartInsideOut {
            part,
            triangle,
            volume,
        }
    } else {
        MeshError::OverlappingPart {
            part,
            triangle,
            volume,
        }
    })
}

/// Returns the sets of triangles that are closed by themselves and have an area, in the order of their first triangles.
///
/// At each edge, a triangle that ascends is joined with one that descends. If there are several of each, they are
/// paired in their order, since files contain one part after another.
fn parts(corners: &[Corners], edges: &[Edge]) -> Vec<Part> {
    let mut sets = Sets::new(corners.len());
    for group in edges.chunk_by(|a, b| a.between == b.between) {
        let of = |ascends: bool| group.iter().filter(move |edge| edge.ascends == ascends);
        for (up, down) in of(true).zip(of(false)) {
            sets.join(up.triangle, down.triangle);
        }
    }
    let mut order: Vec<_> = (0..corners.len())
        .map(|triangle| (sets.representative(triangle), triangle))
        .collect();
    order.sort_unstable();
    let sets = order.chunk_by(|a, b| a.0 == b.0);
    let sets = sets.map(|set| set.iter().map(|(_, triangle)| *triangle).collect());
    sets.map(|triangles| Part::new(triangles, corners))
        .filter(|part| part.triangles.iter().any(|i| area(&corners[*i]) > 0.0))
        .collect()
}

impl Part {
    fn new(triangles: Vec<usize>, corners: &[Corners]) -> Self {
        let mut bounds = [V::repeat(f64::INFINITY), V::repeat(f64::NEG_INFINITY)];
        let mut volume = 0.0;
        for triangle in &triangles {
            let [a, b, c] = &corners[*triangle];
            volume += a.dot(&b.cross(c)) / 6.0;
            for corner in [a, b, c] {
                bounds = [bounds[0].inf(corner), bounds[1].sup(corner)];
            }
        }
        Self {
            triangles,
            volume,
            bounds,
        }
    }

    /// Returns whether the part may wind about a point.
    fn may_surround(&self, point: &V) -> bool {
        let room = (self.bounds[1] - self.bounds[0]).amax() * COINCIDENT;
        (0..3).all(|k| {
            let range = self.bounds[0][k] - room..=self.bounds[1][k] + room;
            range.contains(&point[k])
        })
    }
}

fn normal([a, b, c]: &Corners) -> V {
    (b - a).cross(&(c - a))
}

fn area(corners: &Corners) -> f64 {
    0.5 * normal(corners).norm()
}

/// Returns the winding numbers on both sides of a part.
///
/// They are evaluated at a point of one of its largest triangles, the first whose point does not lie on an edge of
/// another triangle.
fn sides(corners: &[Corners], parts: &[Part], part: &Part) -> Option<Sides> {
    let mut largest: Vec<_> = part
        .triangles
        .iter()
        .map(|triangle| (area(&corners[*triangle]), &corners[*triangle]))
        .collect();
    largest.sort_by(|x, y| y.0.total_cmp(&x.0));
    let samples = largest.iter().take(SAMPLED_TRIANGLES);
    let mut found = samples.map(|(_, sample)| sides_of_triangle(corners, parts, sample));
    found.find_map(|sides| {
        let is_certain = sides
            .iter()
            .all(|x| (x - libm::round(*x)).abs() <= UNCERTAIN_WINDING);
        is_certain.then(|| sides.map(libm::round))
    })
}

fn sides_of_triangle(corners: &[Corners], parts: &[Part], sample: &Corners) -> Sides {
    let weighted = sample.iter().zip(WEIGHTS).map(|(corner, w)| corner * w);
    let point = weighted.sum();
    let front = normal(sample);
    let near = parts.iter().filter(|part| part.may_surround(&point));
    let triangles = near.flat_map(|part| part.triangles.iter());
    triangles.fold([0.0; 2], |[before, behind], triangle| {
        let other = &corners[*triangle];
        match seen(&point, other) {
            Seen::From(turns) => [before + turns, behind + turns],
            Seen::Within => {
                let half = 0.5_f64.copysign(front.dot(&normal(other)));
                [before - half, behind + half]
            }
        }
    })
}

/// The view of a triangle from a point.
enum Seen {
    /// The triangle covers this fraction of the sphere, negative if its vertices appear in counterclockwise order.
    From(f64),
    /// The point is on the triangle.
    Within,
}

fn seen(point: &V, corners: &Corners) -> Seen {
    let [a, b, c] = corners.map(|corner| corner - point);
    let lengths = [&a, &b, &c].map(V::norm);
    let product = lengths[0] * lengths[1] * lengths[2];
    let sine = a.dot(&b.cross(&c));
    let cosine = product + a.dot(&b) * lengths[2] + b.dot(&c) * lengths[0] + c.dot(&a) * lengths[1];
    if sine.abs() <= COINCIDENT * product && cosine < -COINCIDENT * product {
        return Seen::Within;
    }
    Seen::From(libm::atan2(sine, cosine) / (2.0 * PI))
}

/// Disjoint sets of indices, in which the least index represents its set: R. E. Tarjan, *Efficiency of a good but not
/// linear set union algorithm*, J. ACM **22** (1975) 215–225.
struct Sets {
    parents: Vec<usize>,
}

impl Sets {
    fn new(count: usize) -> Self {
        Self {
            parents: (0..count).collect(),
        }
    }

    fn representative(&mut self, mut index: usize) -> usize {
        while self.parents[index] != index {
            let above = self.parents[self.parents[index]];
            self.parents[index] = above;
            index = above;
        }
        index
    }

    fn join(&mut self, first: usize, second: usize) {
        let [x, y] = [first, second].map(|index| self.representative(index));
        self.parents[x.max(y)] = x.min(y);
    }
}
