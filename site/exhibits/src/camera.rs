//! Where a scene is seen from: perspective about a focus.

use lagrangian::prelude::*;

/// An eye that looks at a focus.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// The azimuth of the eye in rad: at 0 it looks along y, with x to the right.
    pub azimuth: f64,
    /// The height of the eye over the horizon in rad.
    pub height: f64,
    /// How much closer than usual it looks.
    pub zoom: f64,
    /// The width and the height of the picture.
    pub size: [f64; 2],
}

/// The distance of the eye from the focus, in radii of what is seen.
const DISTANCE: f64 = 4.2;

/// A camera in front of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    focus: Vector3<f64>,
    /// To the right, away from the eye, and upwards.
    axes: [Vector3<f64>; 3],
    distance: f64,
    scale: f64,
    middle: [f64; 2],
}

/// A point of the picture, with its distance from the eye.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    pub(crate) at: [f64; 2],
    pub(crate) depth: f64,
    /// The length in the picture of a unit of length there.
    pub(crate) scale: f64,
}

impl Camera {
    pub(crate) fn view(&self, focus: Vector3<f64>, radius: f64) -> View {
        let ((sa, ca), (sh, ch)) = (self.azimuth.sin_cos(), self.height.sin_cos());
        let right = Vector3::new(ca, sa, 0.0);
        let away = Vector3::new(-sa * ch, ca * ch, -sh);
        let up = right.cross(&away);
        let distance = DISTANCE * radius;
        let half = 0.5 * self.size[0].min(self.size[1]);
        View {
            focus,
            axes: [right, away, up],
            distance,
            scale: 0.94 * self.zoom * half * (DISTANCE * DISTANCE - 1.0).sqrt(),
            middle: self.size.map(|length| 0.5 * length),
        }
    }
}

impl View {
    /// Where a point is seen; `None` behind the eye.
    pub(crate) fn point(&self, p: &Vector3<f64>) -> Option<Seen> {
        let [right, away, up] = &self.axes;
        let from = p - self.focus;
        let depth = self.distance + from.dot(away);
        let scale = self.scale / depth;
        (depth > 0.05 * self.distance).then(|| Seen {
            at: [
                self.middle[0] + scale * from.dot(right),
                self.middle[1] - scale * from.dot(up),
            ],
            depth,
            scale,
        })
    }

    /// The vector from a point to the eye.
    pub(crate) fn towards_eye(&self, p: &Vector3<f64>) -> Vector3<f64> {
        self.focus - self.distance * self.axes[1] - p
    }

    /// How bright a surface with this normal is, between 0 and 1: the light comes from above the eye's left.
    pub(crate) fn light(&self, normal: &Vector3<f64>) -> f64 {
        let [right, away, up] = &self.axes;
        let source = (-0.45 * right - 0.62 * away + 0.64 * up).normalize();
        0.25 + 0.75 * (0.5 + 0.5 * normal.dot(&source))
    }
}
