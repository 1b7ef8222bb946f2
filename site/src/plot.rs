//! Time plots as SVG: a strip for each curve.

use std::fmt::Write as _;

use lagrangian_exhibits::About;

use crate::markup::escaped;
use crate::recording::Recording;

const WIDTH: f64 = 560.0;
const STRIP: f64 = 118.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = WIDTH - 12.0;
const BELOW: f64 = 30.0;

/// Draws the curves of a recording over time.
pub(crate) fn plot(about: &About, recording: &Recording) -> String {
    #[allow(clippy::cast_precision_loss)] // A few curves.
    let height = STRIP * about.curves.len() as f64 + BELOW;
    let mut svg = format!(
        "<svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-label=\"Curves over time: {}\" font-size=\"13\" \
         fill=\"var(--soft)\">\n",
        escaped(about.title)
    );
    let across = |t: f64| LEFT + (RIGHT - LEFT) * t / about.seconds;
    let mut top = 26.0;
    for (index, curve) in about.curves.iter().enumerate() {
        let bottom = top + STRIP - 40.0;
        let values = || {
            recording
                .samples
                .iter()
                .filter_map(|(_, values)| values.get(index).copied())
        };
        let (low, high) = extent(values());
        let up = |x: f64| bottom - (bottom - top) * (x - low) / (high - low);
        let name = escaped(&format!("{} in {}", curve.name, curve.unit));
        let _ = writeln!(
            svg,
            "<text x=\"{LEFT}\" y=\"{:.1}\" fill=\"var(--text)\">{name}</text>",
            top - 9.0
        );
        let _ = writeln!(
            svg,
            "<rect x=\"{LEFT}\" y=\"{top}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"none\" stroke=\"var(--edge)\"/>",
            RIGHT - LEFT,
            bottom - top
        );
        for (value, y) in [(high, top + 9.0), (low, bottom)] {
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"{y:.1}\" text-anchor=\"end\">{}</text>",
                LEFT - 8.0,
                short(value)
            );
        }
        if low < 0.0 && high > 0.0 {
            let y = up(0.0);
            let _ = writeln!(
                svg,
                "<path d=\"M{LEFT} {y:.1}H{RIGHT:.1}\" stroke=\"var(--edge)\" stroke-dasharray=\"3 4\"/>"
            );
        }
        let mut path = String::new();
        for ((t, _), value) in recording.samples.iter().zip(values()) {
            let _ = write!(
                path,
                "{}{:.1} {:.1}",
                if path.is_empty() { 'M' } else { 'L' },
                across(*t),
                up(value)
            );
        }
        let _ = writeln!(
            svg,
            "<path d=\"{path}\" fill=\"none\" stroke=\"var(--curve-{})\" stroke-width=\"1.8\" stroke-linejoin=\"round\"/>",
            index % 4
        );
        top += STRIP;
    }
    let y = height - 14.0;
    let _ = writeln!(svg, "<text x=\"{LEFT}\" y=\"{y}\">0</text>");
    let _ = writeln!(
        svg,
        "<text x=\"{RIGHT:.1}\" y=\"{y}\" text-anchor=\"end\">{} s</text>\n</svg>",
        about.seconds
    );
    svg
}

/// The least and the largest value, apart.
fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (low.min(x), high.max(x))
    });
    if high - low > 1e-9 * high.abs().max(1e-3) {
        (low, high)
    } else {
        (low - 1.0, high + 1.0)
    }
}

/// A number in three digits.
fn short(x: f64) -> String {
    if x == 0.0 {
        return "0".to_string();
    }
    #[allow(clippy::cast_possible_truncation)] // An exponent.
    let decimals = 2 - x.abs().log10().floor() as i32;
    let decimals = usize::try_from(decimals.clamp(0, 4)).unwrap_or_default();
    let text = format!("{x:.decimals$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    text.replace('-', "−")
}
