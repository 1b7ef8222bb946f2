//! A drawing in SVG.
//!
//! Only what the figure needs: lines, circles and text, in pixels from the upper left corner. How they
//! look is written once, as style classes at the head of the file.

use std::fmt::Write;

/// A point in pixels.
pub type Point = [f64; 2];

/// Colours that stay apart for the colour-blind, by Okabe and Ito: blue for what was integrated and
/// vermilion for the closed form; green and purple for more curves beside the first.
const STYLE: &str = "\
text { font-family: Helvetica, Arial, 'DejaVu Sans', sans-serif; font-size: 14px; fill: #222 }
.title { font-size: 20px; font-weight: bold }
.heading { font-size: 15px; font-weight: bold }
.tick { font-size: 13px }
.frame { fill: none; stroke: #222; stroke-width: 1 }
.grid { stroke: #ddd; stroke-width: 1 }
.zero { stroke: #888; stroke-width: 1 }
.curve { fill: none; stroke: #0072b2; stroke-width: 1.6; stroke-linejoin: round }
.second { fill: none; stroke: #009e73; stroke-width: 1.6; stroke-linejoin: round }
.third { fill: none; stroke: #cc79a7; stroke-width: 1.6; stroke-linejoin: round }
.outline { fill: #f3f3f3; stroke: #222; stroke-width: 1.2; stroke-linejoin: round }
.limit { fill: none; stroke: #d55e00; stroke-width: 1.4; stroke-dasharray: 7 5 }
.horizon { fill: none; stroke: #888; stroke-width: 1.2; stroke-dasharray: 2 4 }
.start { fill: #fff; stroke: #222; stroke-width: 1.6 }
";

/// The most points of a curve, or about as many; more would only make the file larger.
const MAX_POINTS: usize = 20_000;

/// A drawing, to which shapes are added from back to front.
#[derive(Debug)]
pub struct Svg {
    text: String,
}

/// Which end of a text stands at its point.
#[derive(Clone, Copy, Debug)]
pub enum Anchor {
    /// Its beginning.
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

impl Svg {
    /// An empty drawing on a white ground.
    #[must_use]
    pub fn new(width: f64, height: f64) -> Self {
        let mut svg = Self {
            text: String::new(),
        };
        svg.push(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\">\n<style>\n{STYLE}</style>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
        ));
        svg
    }

    /// A drawing with a title and a line under it in its upper left corner.
    #[must_use]
    pub fn titled(width: f64, height: f64, title: &str, subtitle: &str) -> Self {
        let mut svg = Self::new(width, height);
        svg.text("title", Anchor::Start, [24.0, 36.0], title);
        svg.text("subtitle", Anchor::Start, [24.0, 62.0], subtitle);
        svg
    }

    /// The finished file.
    #[must_use]
    pub fn finish(mut self) -> String {
        self.push(format_args!("</svg>"));
        self.text
    }

    /// A straight line.
    pub fn line(&mut self, class: &str, [x1, y1]: Point, [x2, y2]: Point) {
        self.push(format_args!(
            "<line class=\"{class}\" x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\"/>"
        ));
    }

    /// A line through points, or through each second or third of very many. Points that are not finite are left out, for no
    /// viewer takes them.
    pub fn curve(&mut self, class: &str, points: impl Iterator<Item = Point>) {
        let points: Vec<Point> = points.collect();
        let every = points.len().div_ceil(MAX_POINTS).max(1);
        let mut path = String::new();
        let shown = points.iter().step_by(every);
        for [x, y] in shown.filter(|point| point.iter().all(|x| x.is_finite())) {
            let _ = write!(path, " {x:.2},{y:.2}");
        }
        self.push(format_args!(
            "<polyline class=\"{class}\" points=\"{}\"/>",
            path.trim_start()
        ));
    }

    /// A rectangle with two given corners.
    pub fn rectangle(&mut self, class: &str, [left, top]: Point, [right, bottom]: Point) {
        let (width, height) = (right - left, bottom - top);
        self.push(format_args!(
            "<rect class=\"{class}\" x=\"{left:.2}\" y=\"{top:.2}\" width=\"{width:.2}\" \
             height=\"{height:.2}\"/>"
        ));
    }

    /// A circle.
    pub fn circle(&mut self, class: &str, [x, y]: Point, radius: f64) {
        self.push(format_args!(
            "<circle class=\"{class}\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\"/>"
        ));
    }

    /// An entry of a legend: a short line at the height of a text, and the text behind it.
    pub fn entry(&mut self, class: &str, [x, y]: Point, text: &str) {
        self.line(class, [x, y - 5.0], [x + 30.0, y - 5.0]);
        self.text("tick", Anchor::Start, [x + 36.0, y], text);
    }

    /// A horizontal text.
    pub fn text(&mut self, class: &str, anchor: Anchor, [x, y]: Point, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        self.push(format_args!(
            "<text class=\"{class}\" text-anchor=\"{anchor}\" x=\"{x:.2}\" y=\"{y:.2}\">{text}</text>"
        ));
    }

    /// A text that is centred at a point and runs upwards.
    pub fn vertical_text(&mut self, class: &str, [x, y]: Point, text: &str) {
        self.push(format_args!(
            "<text class=\"{class}\" text-anchor=\"middle\" \
             transform=\"translate({x:.2},{y:.2}) rotate(-90)\">{text}</text>"
        ));
    }

    /// Adds a line to the file.
    fn push(&mut self, line: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        let _ = writeln!(self.text, "{line}");
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_POINTS, Svg};

    /// The number of points in the file of a curve through some.
    fn drawn(points: impl Iterator<Item = f64>) -> usize {
        let mut svg = Svg::new(100.0, 100.0);
        svg.curve("curve", points.map(|x| [x, 0.0]));
        svg.finish().matches(",0.00").count()
    }

    #[test]
    fn a_curve_through_very_many_points_is_thinned() {
        let points = |count: usize| drawn(std::iter::repeat_n(1.0, count));
        assert_eq!(points(0), 0);
        assert_eq!(points(MAX_POINTS), MAX_POINTS);
        assert_eq!(points(MAX_POINTS + 1), MAX_POINTS / 2 + 1);
    }

    #[test]
    fn points_without_a_place_are_left_out() {
        assert_eq!(drawn([1.0, f64::NAN, 2.0, f64::INFINITY].into_iter()), 2);
    }
}
