//! The figure: one panel for each model, error across and CPU time up, both logarithmic.
//!
//! Text and lines of the axes follow the reader's colour scheme; the colours of the curves are legible on white and on
//! black. Curves differ in marks, too.

use std::fmt::Write as _;

use crate::model::Model;

use super::Panel;
use super::curve::{Curve, Point};

const PANEL: f64 = 330.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 58.0;
const TOP: f64 = 62.0;
const GAP: f64 = 44.0;
const BOTTOM: f64 = 50.0;

/// A curve of the figure: the beginning of the names it gathers, its colour, its mark and its width.
struct Style {
    name: &'static str,
    colour: &'static str,
    /// Around the origin.
    mark: &'static str,
    width: f64,
}

const STYLES: [Style; 5] = [
    Style {
        name: "Taylor",
        colour: "#2f81f7",
        mark: r#"<circle r="4"/>"#,
        width: 2.5,
    },
    Style {
        name: "Dop853",
        colour: "#2da44e",
        mark: r#"<rect x="-3.5" y="-3.5" width="7" height="7"/>"#,
        width: 2.5,
    },
    Style {
        name: "heyoka",
        colour: "#e5730b",
        mark: r#"<path d="M0-5L4.6 3.4H-4.6Z"/>"#,
        width: 1.5,
    },
    Style {
        name: "ode_solvers",
        colour: "#bf5af2",
        mark: r#"<path d="M0-5L4.5 0L0 5L-4.5 0Z"/>"#,
        width: 1.5,
    },
    Style {
        name: "differential-equations",
        colour: "#8b8f96",
        mark: r#"<path d="M0 5L4.6-3.4H-4.6Z"/>"#,
        width: 1.5,
    },
];

const HEAD: &str = r#"<style>
text { font: 12px system-ui, "Helvetica Neue", Arial, sans-serif; fill: #24292f }
.title { font-size: 14px; font-weight: 600 }
.grid { stroke: #d0d7de; stroke-width: 1 }
.frame { stroke: #57606a; stroke-width: 1; fill: none }
@media (prefers-color-scheme: dark) {
text { fill: #e6edf3 }
.grid { stroke: #30363d }
.frame { stroke: #8b949e }
}
</style>
"#;

/// An axis of powers of ten.
#[derive(Clone, Copy)]
struct Axis {
    /// The exponents at both ends, and where those are.
    exponents: [f64; 2],
    ends: [f64; 2],
}

impl Axis {
    fn at(self, value: f64) -> f64 {
        let ([from, to], [first, last]) = (self.exponents, self.ends);
        first + (value.log10() - from) / (to - from) * (last - first)
    }

    /// The whole exponents on it, every so many.
    #[allow(clippy::cast_possible_truncation)] // Small whole numbers.
    fn ticks(self, every: usize) -> impl Iterator<Item = i32> {
        let [from, to] = self.exponents;
        (from.min(to).ceil() as i32..=from.max(to).floor() as i32).step_by(every)
    }
}

/// The whole figure.
pub(super) fn svg(panels: &[Panel]) -> String {
    let curves: Vec<Vec<(&Style, Vec<Point>)>> = panels.iter().map(gathered).collect();
    let points = || curves.iter().flatten().flat_map(|(_, points)| points);
    let seconds = range(points().map(|point| point.seconds * 1e3), 0.5);
    let errors = range(points().map(|point| point.error.max(1e-16)), 1.0);
    #[allow(clippy::cast_precision_loss)] // Some panels.
    let count = panels.len() as f64;
    let width = LEFT + count * PANEL + (count - 1.0) * GAP + 26.0;
    let height = TOP + HEIGHT + BOTTOM;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\">\n\
         <title>CPU time of integrators to t = 1000 against the error reached</title>\n{HEAD}"
    );
    legend(&mut svg);
    let mut left = LEFT;
    for (panel, curves) in panels.iter().zip(&curves) {
        let across = Axis {
            exponents: [errors[1], errors[0]],
            ends: [left, left + PANEL],
        };
        let up = Axis {
            exponents: seconds,
            ends: [TOP + HEIGHT, TOP],
        };
        frame(&mut svg, title(panel.model), across, up, left == LEFT);
        for (style, points) in curves {
            draw(&mut svg, style, points, across, up);
        }
        left += PANEL + GAP;
    }
    svg + "</svg>\n"
}

fn title(model: Model) -> &'static str {
    match model {
        Model::SymmetricTop => "Symmetric heavy top",
        Model::GeneralTop => "General heavy top",
        Model::Pendulum(2) => "Double pendulum",
        _ => "",
    }
}

/// The curves of a panel by what they show: of our orders the best at each error, of settings the fastest one.
fn gathered(panel: &Panel) -> Vec<(&'static Style, Vec<Point>)> {
    let curve = |style: &'static Style| {
        let named = |curve: &&Curve| curve.name.starts_with(style.name);
        let same = panel.curves.iter().filter(named);
        let points = if style.name == "Taylor" {
            same.flat_map(|curve| curve.points.clone()).collect()
        } else {
            let together = |curve: &&Curve| curve.points.iter().map(|point| point.seconds).sum();
            let fastest = same.min_by(|a, b| f64::total_cmp(&together(a), &together(b)));
            fastest.map_or_else(Vec::new, |curve| curve.points.clone())
        };
        let all = Curve {
            name: style.name,
            points,
        };
        (style, all.efficient())
    };
    let curves = STYLES.iter().map(curve);
    curves.filter(|(_, points)| !points.is_empty()).collect()
}

/// The exponents between which all values are, in steps.
fn range(values: impl Iterator<Item = f64>, step: f64) -> [f64; 2] {
    let logarithms = values.map(f64::log10);
    let [low, high] = logarithms.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    });
    [(low / step).floor() * step, (high / step).ceil() * step]
}

fn legend(svg: &mut String) {
    let mut x = LEFT;
    for style in &STYLES {
        let (colour, mark, name) = (style.colour, style.mark, style.name);
        let _ = writeln!(
            svg,
            "<g transform=\"translate({x} 20)\"><path d=\"M0 0H26\" stroke=\"{colour}\" stroke-width=\"{}\"/>\
             <g transform=\"translate(13 0)\" fill=\"{colour}\">{mark}</g><text x=\"33\" y=\"4\">{name}</text></g>",
            style.width
        );
        #[allow(clippy::cast_precision_loss)] // A short name.
        let length = name.len() as f64;
        x += 68.0 + 7.0 * length;
    }
}

/// Title, grid, numbers; what is up is said at the first panel alone.
fn frame(svg: &mut String, title: &str, across: Axis, up: Axis, first: bool) {
    let ([left, right], [bottom, top]) = (across.ends, up.ends);
    let middle = f64::midpoint(left, right);
    let _ = writeln!(
        svg,
        "<text class=\"title\" x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">{title}</text>",
        top - 10.0
    );
    for exponent in across.ticks(2) {
        let x = across.at(10_f64.powi(exponent));
        let _ = writeln!(
            svg,
            "<path class=\"grid\" d=\"M{x:.1} {bottom}V{top}\"/>\
             <text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">10{}</text>",
            bottom + 17.0,
            superscript(exponent)
        );
    }
    for exponent in up.ticks(1) {
        let y = up.at(10_f64.powi(exponent));
        let _ = writeln!(
            svg,
            "<path class=\"grid\" d=\"M{left} {y:.1}H{right}\"/>\
             <text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">10{}</text>",
            left - 6.0,
            y + 4.0,
            superscript(exponent)
        );
    }
    let _ = writeln!(
        svg,
        "<path class=\"frame\" d=\"M{left} {bottom}H{right}V{top}H{left}Z\"/>\
         <text x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">error at t = 1000</text>",
        bottom + 36.0
    );
    if first {
        let middle = f64::midpoint(bottom, top);
        let _ = writeln!(
            svg,
            "<text transform=\"translate(14 {middle}) rotate(-90)\" text-anchor=\"middle\">CPU time, ms</text>"
        );
    }
}

fn draw(svg: &mut String, style: &Style, points: &[Point], across: Axis, up: Axis) {
    let places = points.iter().map(|point| {
        let (x, y) = (
            across.at(point.error.max(1e-16)),
            up.at(point.seconds * 1e3),
        );
        (x, y, point.tolerance)
    });
    let (mut line, mut marks) = (String::new(), String::new());
    for (x, y, tolerance) in places {
        let step = if line.is_empty() { 'M' } else { 'L' };
        let _ = write!(line, "{step}{x:.1} {y:.1}");
        let _ = write!(
            marks,
            "<g transform=\"translate({x:.1} {y:.1})\"><title>{}, tolerance {tolerance:.0e}</title>{}</g>",
            style.name, style.mark
        );
    }
    let (colour, width) = (style.colour, style.width);
    let _ = writeln!(
        svg,
        "<path d=\"{line}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>\n<g fill=\"{colour}\">{marks}</g>"
    );
}

/// A number as an exponent.
fn superscript(number: i32) -> String {
    let digits = number.to_string();
    let raised = digits.chars().map(|digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => digit
            .to_digit(10)
            .and_then(|digit| char::from_u32(0x2070 + digit))
            .unwrap_or(digit),
    });
    raised.collect()
}
