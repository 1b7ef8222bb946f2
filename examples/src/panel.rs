//! A panel of a figure: two axes and what lies between them.

use crate::axis::Axis;
use crate::svg::{Anchor, Point, Svg};

/// Two axes and what lies between them.
#[derive(Clone, Copy, Debug)]
pub struct Panel {
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
}

impl Panel {
    /// A panel between left, right, top and bottom in pixels, with the values at both ends of its axes, and as many ticks on
    /// each or so.
    #[must_use]
    pub fn new(
        [left, right, top, bottom]: [f64; 4],
        (x, y): ([f64; 2], [f64; 2]),
        ticks: [f64; 2],
    ) -> Self {
        Self {
            x: Axis::new(x, [left, right], ticks[0]),
            y: Axis::new(y, [bottom, top], ticks[1]),
        }
    }

    /// Where two values lie, in pixels.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> Point {
        [self.x.at(x), self.y.at(y)]
    }

    /// A line through points of the panel.
    pub fn curve(&self, svg: &mut Svg, class: &str, points: impl Iterator<Item = [f64; 2]>) {
        svg.curve(class, points.map(|[x, y]| self.at(x, y)));
    }

    /// A horizontal line from end to end.
    pub fn level(&self, svg: &mut Svg, class: &str, value: f64) {
        let [left, right] = self.x.pixels;
        let y = self.y.at(value);
        svg.line(class, [left, y], [right, y]);
    }

    /// Frame, grid, ticks and labels.
    pub fn draw(&self, svg: &mut Svg, heading: &str, x_label: &str, y_label: &str) {
        let ([left, right], [bottom, top]) = (self.x.pixels, self.y.pixels);
        for (value, label) in self.x.ticks() {
            let x = self.x.at(value);
            svg.line("grid", [x, top], [x, bottom]);
            svg.text("tick", Anchor::Middle, [x, bottom + 18.0], &label);
        }
        for (value, label) in self.y.ticks() {
            let y = self.y.at(value);
            svg.line("grid", [left, y], [right, y]);
            svg.text("tick", Anchor::End, [left - 8.0, y + 4.5], &label);
        }
        svg.rectangle("frame", [left, top], [right, bottom]);
        svg.text("heading", Anchor::Start, [left, top - 10.0], heading);
        svg.text(
            "label",
            Anchor::Middle,
            [0.5 * (left + right), bottom + 40.0],
            x_label,
        );
        svg.vertical_text("label", [left - 60.0, 0.5 * (top + bottom)], y_label);
    }
}

/// The least and the greatest of some values; 0 and 1 if there are none.
pub fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values
        .filter(|value| value.is_finite())
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
    if low <= high { [low, high] } else { [0.0, 1.0] }
}
