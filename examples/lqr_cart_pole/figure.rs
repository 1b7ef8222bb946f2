//! The figure: how the cart and its pole move, and angle, position and force over time.

use std::fmt::Write;

use crate::model::Point;

/// A motion and what it is called.
pub(crate) struct Curve {
    pub(crate) label: String,
    pub(crate) motion: Vec<Point>,
}

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 900.0;

/// How much of the motions is plotted, in s.
const SHOWN: u8 = 4;

/// Colours that stay apart for the colour-blind, by Okabe and Ito.
const COLOURS: [&str; 4] = ["#0072b2", "#009e73", "#e69f00", "#d55e00"];

const STYLE: &str = "text { font-family: Helvetica, Arial, 'DejaVu Sans', sans-serif; font-size: 14px; fill: #222 } \
.title { font-size: 20px; font-weight: bold } .frame { fill: none; stroke: #222 } .grid { stroke: #ddd } \
.zero { stroke: #888 } .curve { fill: none; stroke-width: 1.6; stroke-linejoin: round }";

/// A quantity of a motion.
struct Panel {
    name: &'static str,
    of: fn(&Point) -> f64,
}

const PANELS: [Panel; 3] = [
    Panel {
        name: "θ in degrees",
        of: |(state, _)| state.q[1].to_degrees(),
    },
    Panel {
        name: "x in m",
        of: |(state, _)| state.q[0],
    },
    Panel {
        name: "force in N",
        of: |(_, force)| *force,
    },
];

/// The figure of some motions with a pole of a length in m; the third one is shown as it moves.
pub(crate) fn figure(curves: &[Curve], length: f64) -> String {
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\">\n<style>{STYLE}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n\
         <text class=\"title\" x=\"70\" y=\"36\">A pole on a cart under a linear-quadratic regulator</text>\n"
    );
    if let Some(curve) = curves.get(2) {
        movement(&mut svg, curve, length);
    }
    for (panel, top) in PANELS.iter().zip([300.0, 495.0, 690.0]) {
        plot(&mut svg, panel, curves, [top, top + 165.0]);
    }
    for (i, (curve, colour)) in curves.iter().zip(COLOURS).enumerate() {
        #[allow(clippy::cast_precision_loss)] // A few.
        let y = 318.0 + 19.0 * i as f64;
        put(
            &mut svg,
            format_args!(
                "<line class=\"curve\" stroke=\"{colour}\" x1=\"640\" x2=\"665\" y1=\"{y}\" y2=\"{y}\"/>\
                 <text x=\"673\" y=\"{}\">{}</text>",
                y + 5.0,
                curve.label
            ),
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// Writing to a string does not fail.
fn put(svg: &mut String, line: std::fmt::Arguments<'_>) {
    let _ = writeln!(svg, "{line}");
}

/// The cart and its pole every tenth of a second while they move fast, later ones darker.
fn movement(svg: &mut String, curve: &Curve, length: f64) {
    let shown: Vec<_> = curve.motion.iter().take(130).step_by(5).collect();
    let positions = || shown.iter().map(|(state, _)| state.q[0]);
    let [low, high] = [
        positions().fold(0.0, f64::min) - length,
        positions().fold(0.0, f64::max) + length,
    ];
    let scale = ((WIDTH - 140.0) / (high - low)).min(170.0 / (1.1 * length));
    let middle = 0.5 * (low + high);
    let rail = 245.0;
    put(
        svg,
        format_args!(
            "<line class=\"zero\" x1=\"70\" x2=\"{}\" y1=\"{rail}\" y2=\"{rail}\"/>",
            WIDTH - 70.0
        ),
    );
    for (i, (state, _)) in shown.iter().enumerate() {
        #[allow(clippy::cast_precision_loss)] // A few.
        let opacity = 0.15 + 0.85 * (i as f64 + 1.0) / shown.len() as f64;
        let x = 0.5 * WIDTH + scale * (state.q[0] - middle);
        let (sine, cosine) = state.q[1].sin_cos();
        let [tip_x, tip_y] = [x + scale * length * sine, rail - scale * length * cosine];
        put(
            svg,
            format_args!(
                "<g opacity=\"{opacity:.2}\" stroke=\"{0}\" fill=\"{0}\">\
                 <rect x=\"{1:.1}\" y=\"{2}\" width=\"28\" height=\"10\" fill=\"none\"/>\
                 <line x1=\"{x:.1}\" y1=\"{rail}\" x2=\"{tip_x:.1}\" y2=\"{tip_y:.1}\"/>\
                 <circle cx=\"{tip_x:.1}\" cy=\"{tip_y:.1}\" r=\"4\"/></g>",
                COLOURS[2],
                x - 14.0,
                rail - 5.0,
            ),
        );
    }
    put(
        svg,
        format_args!(
            "<text x=\"70\" y=\"275\">{}, every 0.1 s for 2.6 s, later ones darker</text>",
            curve.label
        ),
    );
}

/// A quantity of all motions over time.
fn plot(svg: &mut String, panel: &Panel, curves: &[Curve], [top, bottom]: [f64; 2]) {
    let values = || {
        let points = curves.iter().flat_map(|curve| &curve.motion);
        points.map(panel.of)
    };
    let [low, high] = [values().fold(0.0, f64::min), values().fold(0.0, f64::max)];
    let margin = 0.06 * (high - low).max(1e-9);
    let (low, high) = (low - margin, high + margin);
    let [left, right] = [70.0, WIDTH - 30.0];
    let x = |time: f64| left + time / f64::from(SHOWN) * (right - left);
    let y = |value: f64| bottom - (value - low) / (high - low) * (bottom - top);
    for second in 0..=SHOWN {
        let at = x(f64::from(second));
        put(
            svg,
            format_args!(
                "<line class=\"grid\" x1=\"{at:.1}\" x2=\"{at:.1}\" y1=\"{top}\" y2=\"{bottom}\"/>"
            ),
        );
        if bottom > HEIGHT - 60.0 {
            let unit = if second == SHOWN { " s" } else { "" };
            put(
                svg,
                format_args!(
                    "<text text-anchor=\"middle\" x=\"{at:.1}\" y=\"{}\">{second}{unit}</text>",
                    bottom + 20.0
                ),
            );
        }
    }
    let step = tick_step((high - low) / 5.0);
    let first = (low / step).ceil();
    let ticks = (0_u8..20).map(|k| (first + f64::from(k)) * step);
    for value in ticks.take_while(|value| *value <= high) {
        let (at, class) = (
            y(value),
            if value.abs() < 0.5 * step {
                "zero"
            } else {
                "grid"
            },
        );
        let decimals = usize::from(step < 1.0);
        put(
            svg,
            format_args!(
                "<line class=\"{class}\" x1=\"{left}\" x2=\"{right}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/>\
                 <text text-anchor=\"end\" x=\"{}\" y=\"{:.1}\">{:.decimals$}</text>",
                left - 6.0,
                at + 5.0,
                value + 0.0
            ),
        );
    }
    for (curve, colour) in curves.iter().zip(COLOURS) {
        let mut points = String::new();
        let is_shown = |point: &&Point| point.0.t < f64::from(SHOWN) + 1e-9;
        for point in curve.motion.iter().filter(is_shown) {
            let _ = write!(points, " {:.1},{:.1}", x(point.0.t), y((panel.of)(point)));
        }
        put(
            svg,
            format_args!(
                "<polyline class=\"curve\" stroke=\"{colour}\" points=\"{}\"/>",
                points.trim_start()
            ),
        );
    }
    put(
        svg,
        format_args!(
            "<rect class=\"frame\" x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\"/>\
             <text transform=\"translate(20,{}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            right - left,
            bottom - top,
            0.5 * (top + bottom),
            panel.name
        ),
    );
}

/// The least of 1, 2 and 5 times powers of ten that is not less than a distance.
fn tick_step(distance: f64) -> f64 {
    let decade = 10_f64.powf(distance.log10().floor());
    let steps = [1.0, 2.0, 5.0].map(|digit| digit * decade);
    steps
        .into_iter()
        .find(|step| *step >= distance)
        .unwrap_or(10.0 * decade)
}
