//! Pictures of scenes: what is painted in the plane, from the back to the front.
//!
//! Surfaces are cut into flat pieces that are painted by their distance (painter's algorithm: M. E. Newell, R. G. Newell &
//! T. L. Sancha, A solution to the hidden surface problem, 1972), those that face away not at all.

use lagrangian::prelude::*;

use crate::camera::{Camera, View};
use crate::palette::SHADES;
use crate::pieces;
use crate::scene::{Scene, Tone};

/// What is painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A filled polygon.
    Polygon,
    /// An open line with round ends.
    Line,
    /// A disc with a highlight: its first point is the centre, and the width is its radius.
    Ball,
}

/// One thing to paint.
#[derive(Clone, Debug)]
pub struct Piece {
    /// What it is.
    pub kind: Kind,
    /// Its colour, an index of the palette.
    pub tone: usize,
    /// Its brightness.
    pub shade: usize,
    /// The width of a line, the radius of a ball.
    pub width: f64,
    /// Its points in the picture.
    pub points: Vec<[f64; 2]>,
    depth: f64,
}

/// The pieces of a picture, from the back to the front.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    /// The pieces in the order in which they are painted.
    pub pieces: Vec<Piece>,
}

impl Picture {
    /// Paints a scene, with the paths that its traced points have taken.
    #[must_use]
    pub fn of(scene: &Scene, trails: &[Vec<Vector3<f64>>], camera: &Camera) -> Self {
        let view = camera.view(scene.focus, scene.radius);
        let mut picture = Painter {
            view,
            pieces: Vec::new(),
            behind: 0.0,
        };
        if let Some(height) = scene.ground {
            picture.behind = 1e6 * scene.radius;
            pieces::grid(&mut picture, scene, height);
            picture.behind = 0.0;
        }
        for trail in trails {
            picture.trail(trail, 0.012 * scene.radius);
        }
        for shape in &scene.fixtures {
            pieces::shape(&mut picture, shape, &Vector3::zeros(), &Matrix3::identity());
        }
        for line in &scene.lines {
            pieces::bar(&mut picture, &line.ends, line.width, line.tone);
        }
        for body in &scene.bodies {
            for shape in &body.shapes {
                pieces::shape(&mut picture, shape, &body.origin, &body.axes);
            }
        }
        let mut pieces = picture.pieces;
        pieces.sort_by(|a, b| b.depth.total_cmp(&a.depth));
        Self { pieces }
    }

    /// The picture as numbers: kind, colour, brightness, width, the number of points, and the points, piece by piece.
    #[must_use]
    pub fn numbers(&self) -> Vec<f32> {
        let mut numbers = Vec::new();
        for piece in &self.pieces {
            let head = [piece.kind as usize, piece.tone, piece.shade];
            #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
            // Small numbers, and pixels.
            {
                numbers.extend(head.map(|number| number as f32));
                numbers.push(piece.width as f32);
                numbers.push(piece.points.len() as f32);
                numbers.extend(piece.points.iter().flatten().map(|x| *x as f32));
            }
        }
        numbers
    }
}

/// A picture to which pieces are added.
pub(crate) struct Painter {
    pub(crate) view: View,
    pieces: Vec<Piece>,
    /// Added to the distances of all pieces.
    behind: f64,
}

impl Painter {
    /// Adds a flat piece with this normal, if it faces the eye.
    pub(crate) fn face(&mut self, corners: &[Vector3<f64>], normal: &Vector3<f64>, tone: Tone) {
        let Some(first) = corners.first() else { return };
        if normal.dot(&self.view.towards_eye(first)) > 0.0 {
            let light = self.view.light(normal);
            self.polygon(corners, tone, light);
        }
    }

    /// Adds a filled polygon of this brightness.
    pub(crate) fn polygon(&mut self, corners: &[Vector3<f64>], tone: Tone, light: f64) {
        let Some(seen) = corners
            .iter()
            .map(|p| self.view.point(p))
            .collect::<Option<Vec<_>>>()
        else {
            return;
        };
        #[allow(clippy::cast_precision_loss)] // A few corners.
        let depth = seen.iter().map(|p| p.depth).sum::<f64>() / seen.len() as f64;
        self.add(
            Kind::Polygon,
            (tone, light),
            0.0,
            (seen.iter().map(|p| p.at).collect(), depth),
        );
    }

    /// Adds a straight line of this width in space.
    pub(crate) fn line(&mut self, ends: &[Vector3<f64>; 2], width: f64, tone: Tone, light: f64) {
        if let [Some(a), Some(b)] = ends.each_ref().map(|p| self.view.point(p)) {
            let (depth, scale) = (0.5 * (a.depth + b.depth), 0.5 * (a.scale + b.scale));
            self.add(
                Kind::Line,
                (tone, light),
                (width * scale).max(0.8),
                (vec![a.at, b.at], depth),
            );
        }
    }

    /// Adds a ball.
    pub(crate) fn ball(&mut self, center: &Vector3<f64>, radius: f64, tone: Tone) {
        if let Some(seen) = self.view.point(center) {
            // In front of a rod that ends in it.
            let depth = seen.depth - 0.5 * radius;
            self.add(
                Kind::Ball,
                (tone, 1.0),
                (radius * seen.scale).max(1.5),
                (vec![seen.at], depth),
            );
        }
    }

    /// Adds a path that fades.
    fn trail(&mut self, points: &[Vector3<f64>], width: f64) {
        for (index, pair) in points.windows(2).enumerate() {
            #[allow(clippy::cast_precision_loss)] // Some hundreds.
            let age = index as f64 / points.len() as f64;
            if let [a, b] = pair {
                self.line(&[*a, *b], width, Tone::Trail, 0.15 + 0.85 * age);
            }
        }
    }

    fn add(
        &mut self,
        kind: Kind,
        (tone, light): (Tone, f64),
        width: f64,
        (points, depth): (Vec<[f64; 2]>, f64),
    ) {
        #[allow(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss
        )] // Below 12.
        let shade = (light.clamp(0.0, 1.0) * (SHADES - 1) as f64).round() as usize;
        let depth = depth + self.behind;
        if depth.is_finite() && width.is_finite() && points.iter().flatten().all(|x| x.is_finite())
        {
            self.pieces.push(Piece {
                kind,
                tone: tone as usize,
                shade,
                width,
                points,
                depth,
            });
        }
    }
}
