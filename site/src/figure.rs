//! Drawings as SVG, in the colours of the page.

use std::fmt::Write as _;

use lagrangian_exhibits::{Camera, Kind, Picture, Piece, palette};

use crate::markup::escaped;
use crate::recording::Recording;

/// The rules of the colours of all drawings.
pub(crate) fn style() -> String {
    let rules = |is_dark| {
        let mut css = String::new();
        for tone in 0..7 {
            for shade in 0..palette::SHADES {
                let color = palette::color(is_dark, tone, shade);
                let _ = writeln!(css, ".t{tone}s{shade}{{color:{color}}}");
            }
        }
        css
    };
    format!(
        ".f{{fill:currentColor;stroke:currentColor;stroke-width:.7;stroke-linejoin:round}}\n.l{{fill:none;stroke:currentColor;\
         stroke-linecap:round}}\n{}@media (prefers-color-scheme: dark) {{\n{}}}\n",
        rules(false),
        rules(true)
    )
}

/// The drawing of a recording.
pub(crate) fn drawing(
    recording: &Recording,
    title: &str,
    view: [f64; 2],
    [width, height]: [f64; 2],
) -> String {
    let camera = Camera {
        azimuth: view[0],
        height: view[1],
        zoom: 1.0,
        size: [width, height],
    };
    let picture = Picture::of(&recording.scene, &recording.trails.paths(), &camera);
    let mut svg = format!(
        "<svg class=\"sky\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"Drawing: {}\">\n",
        escaped(title)
    );
    for piece in &picture.pieces {
        add(&mut svg, piece);
    }
    svg.push_str("</svg>\n");
    svg
}

fn add(svg: &mut String, piece: &Piece) {
    let class = format!("t{}s{}", piece.tone, piece.shade);
    let width = piece.width;
    // A string takes whatever is written.
    let _ = match piece.kind {
        Kind::Polygon => writeln!(
            svg,
            "<path class=\"f {class}\" d=\"{}z\"/>",
            path(&piece.points)
        ),
        Kind::Line => {
            writeln!(
                svg,
                "<path class=\"l {class}\" stroke-width=\"{width:.1}\" d=\"{}\"/>",
                path(&piece.points)
            )
        }
        Kind::Ball => {
            let [x, y] = piece.points.first().copied().unwrap_or_default();
            let light = format!("t{}s{}", piece.tone, palette::SHADES - 1);
            let dark = format!("t{}s7", piece.tone);
            writeln!(
                svg,
                "<circle class=\"f {dark}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{width:.1}\"/><circle class=\"f {light}\" \
                 cx=\"{:.1}\" cy=\"{:.1}\" r=\"{:.1}\"/>",
                x - 0.18 * width,
                y - 0.2 * width,
                0.62 * width
            )
        }
    };
}

fn path(points: &[[f64; 2]]) -> String {
    let mut path = String::new();
    for (index, [x, y]) in points.iter().enumerate() {
        let _ = write!(path, "{}{x:.1} {y:.1}", if index == 0 { 'M' } else { 'L' });
    }
    path
}
