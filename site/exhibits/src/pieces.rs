//! Shapes cut into flat pieces.

use std::f64::consts::{PI, TAU};

use lagrangian::prelude::*;

use crate::picture::Painter;
use crate::scene::{Form, Scene, Shape, Tone};

/// A shape in the axes of space.
struct Placed<'a> {
    painter: &'a mut Painter,
    origin: Vector3<f64>,
    axes: Matrix3<f64>,
    tone: Tone,
}

/// Adds a shape of a body at this origin, along these axes.
pub(crate) fn shape(
    painter: &mut Painter,
    shape: &Shape,
    origin: &Vector3<f64>,
    axes: &Matrix3<f64>,
) {
    let origin = origin + axes * shape.center;
    let mut placed = Placed {
        painter,
        origin,
        axes: axes * shape.turn,
        tone: shape.tone,
    };
    match shape.form {
        Form::Ball(radius) => placed.painter.ball(&origin, radius, shape.tone),
        Form::Cuboid(half) => placed.cuboid(half),
        Form::Ellipsoid(semi) => placed.ellipsoid(semi),
        Form::Cylinder(radius, half) => placed.cylinder(radius, half),
        Form::Ring(radius, thickness) => placed.ring(radius, thickness),
        Form::Bar(a, b, width) => {
            let ends = [a, b].map(|p| placed.point(p));
            bar(placed.painter, &ends, width, shape.tone);
        }
    }
}

/// Adds a straight bar in short pieces, each at its own distance.
pub(crate) fn bar(painter: &mut Painter, ends: &[Vector3<f64>; 2], width: f64, tone: Tone) {
    const PIECES: u32 = 8;
    let [a, b] = ends;
    let at = |index: u32| a + (b - a) * (f64::from(index) / f64::from(PIECES));
    for index in 0..PIECES {
        painter.line(&[at(index), at(index + 1)], width, tone, 0.8);
    }
}

/// Adds the grid of the ground about the focus of a scene.
pub(crate) fn grid(painter: &mut Painter, scene: &Scene, height: f64) {
    const HALF: i32 = 6;
    let width = 2.0 * scene.radius / f64::from(HALF);
    let unit = 10_f64.powf(width.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|k| k * unit)
        .find(|step| *step >= 0.7 * width)
        .unwrap_or(width);
    let middle = [scene.focus.x, scene.focus.y].map(|x| (x / step).round() * step);
    let [reach, thin] = [f64::from(HALF) * step, 0.004 * scene.radius];
    for index in -HALF..=HALF {
        let across = f64::from(index) * step;
        let light = 1.0 - 0.75 * f64::from(index.abs()) / f64::from(HALF);
        let [x, y] = middle;
        let lines = [
            [[x + across, y - reach], [x + across, y + reach]],
            [[x - reach, y + across], [x + reach, y + across]],
        ];
        for [a, b] in lines {
            // Behind the eye a line has no end: it is drawn in pieces.
            for part in 0..12 {
                let at = |k: i32| {
                    let share = f64::from(k) / 12.0;
                    Vector3::new(
                        a[0] + share * (b[0] - a[0]),
                        a[1] + share * (b[1] - a[1]),
                        height,
                    )
                };
                let along = 1.0 - (f64::from(part) - 5.5).abs() / 6.5;
                painter.line(&[at(part), at(part + 1)], thin, Tone::Ground, light * along);
            }
        }
    }
}

impl Placed<'_> {
    fn point(&self, [x, y, z]: [f64; 3]) -> Vector3<f64> {
        self.origin + self.axes * Vector3::new(x, y, z)
    }

    fn face(&mut self, corners: &[[f64; 3]], normal: [f64; 3], tone: Tone) {
        let corners: Vec<_> = corners.iter().map(|p| self.point(*p)).collect();
        let normal = (self.axes * Vector3::from(normal)).normalize();
        self.painter.face(&corners, &normal, tone);
    }

    fn cuboid(&mut self, half: [f64; 3]) {
        for axis in 0..3 {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            for side in [-1.0, 1.0] {
                let corner = |a: f64, b: f64| {
                    let mut corner = [0.0; 3];
                    (corner[axis], corner[u], corner[v]) =
                        (side * half[axis], a * half[u], b * half[v]);
                    corner
                };
                let mut normal = [0.0; 3];
                normal[axis] = side;
                let corners = [
                    corner(-1.0, -1.0),
                    corner(1.0, -1.0),
                    corner(1.0, 1.0),
                    corner(-1.0, 1.0),
                ];
                self.face(&corners, normal, self.tone);
            }
        }
    }

    /// An ellipsoid with eight fields, which show how it turns.
    fn ellipsoid(&mut self, semi: [f64; 3]) {
        const ROUND: u32 = 24;
        const UP: u32 = 12;
        let direction = |i: u32, j: u32| {
            let (sp, cp) = (TAU * f64::from(i) / f64::from(ROUND)).sin_cos();
            let (st, ct) = (PI * f64::from(j) / f64::from(UP)).sin_cos();
            [st * cp, st * sp, ct]
        };
        let on = |d: [f64; 3]| [d[0] * semi[0], d[1] * semi[1], d[2] * semi[2]];
        for i in 0..ROUND {
            for j in 0..UP {
                let is_marked = (i / (ROUND / 4) + j / (UP / 2)).is_multiple_of(2);
                let tone = if is_marked {
                    self.tone
                } else {
                    marked(self.tone)
                };
                let corners =
                    [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)].map(|(i, j)| direction(i, j));
                let middle: [f64; 3] =
                    std::array::from_fn(|k| corners.iter().map(|c| c[k]).sum::<f64>() / semi[k]);
                self.face(&corners.map(on), middle, tone);
            }
        }
    }

    /// A cylinder whose ends have four fields.
    fn cylinder(&mut self, radius: f64, half: f64) {
        const ROUND: u32 = 32;
        let at = |i: u32| {
            let (s, c) = (TAU * f64::from(i) / f64::from(ROUND)).sin_cos();
            [radius * c, radius * s]
        };
        for i in 0..ROUND {
            let ([a, b], [c, d]) = (at(i), at(i + 1));
            self.face(
                &[[a, b, -half], [c, d, -half], [c, d, half], [a, b, half]],
                [a + c, b + d, 0.0],
                self.tone,
            );
            let tone = if (i / (ROUND / 4)).is_multiple_of(2) {
                self.tone
            } else {
                marked(self.tone)
            };
            for side in [-half, half] {
                self.face(
                    &[[0.0, 0.0, side], [a, b, side], [c, d, side]],
                    [0.0, 0.0, side.signum()],
                    tone,
                );
            }
        }
    }

    fn ring(&mut self, radius: f64, thickness: f64) {
        const ROUND: u32 = 48;
        let at = |i: u32| {
            let (s, c) = (TAU * f64::from(i) / f64::from(ROUND)).sin_cos();
            [radius * c, radius * s, 0.0]
        };
        for i in 0..ROUND {
            let ends = [at(i), at(i + 1)].map(|p| self.point(p));
            let outwards = (0.5 * (ends[0] + ends[1]) - self.origin).normalize();
            let light = self.painter.view.light(&outwards);
            self.painter.line(&ends, thickness, self.tone, light);
        }
    }
}

/// The colour of the other fields of a shape.
fn marked(tone: Tone) -> Tone {
    match tone {
        Tone::First => Tone::Second,
        Tone::Second => Tone::Frame,
        _ => Tone::Fixed,
    }
}
