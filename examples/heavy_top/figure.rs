//! The figure: tilt against time, energy error against time, and the path of the axis from above.

use std::f64::consts::FRAC_PI_2;

use lagrangian::rigid_body::Nutation;
use lagrangian_examples::{Anchor, Panel, Svg, extent};

use crate::model::HeavyTop;
use crate::motion::{Cycle, Sample};

/// Left, right, top and bottom of the three panels in pixels.
const TILT: [f64; 4] = [84.0, 620.0, 112.0, 322.0];
const ENERGY: [f64; 4] = [84.0, 620.0, 402.0, 572.0];
const PATH: [f64; 4] = [712.0, 1072.0, 112.0, 472.0];

/// The figure of a motion, with the limits of its tilt where they are known in closed form.
pub(crate) fn figure(parameters: &str, samples: &[Sample], nutation: Option<&Nutation>) -> String {
    let mut svg = Svg::titled(1100.0, 632.0, "Motion of a heavy top", parameters);
    let limits = nutation.map(|closed| Cycle::from(closed).tilts);
    tilt_panel(&mut svg, samples, limits);
    energy_panel(&mut svg, samples);
    path_panel(&mut svg, samples, limits);
    svg.finish()
}

/// θ(t) in degrees.
fn tilt_panel(svg: &mut Svg, samples: &[Sample], limits: Option<[f64; 2]>) {
    let tilts = samples.iter().map(|x| [x.state.t, x.tilt().to_degrees()]);
    let limits = limits.into_iter().flatten().map(f64::to_degrees);
    let [low, high] = extent(tilts.clone().map(|[_, tilt]| tilt).chain(limits.clone()));
    // A steady precession is a straight line, and not a magnified rounding error.
    let margin = (0.06 * (high - low)).max(0.05);
    let panel = panel_of_time(TILT, samples, [low - margin, high + margin]);
    panel.draw(svg, "Tilt of the axis", "time t / s", "tilt θ / degrees");
    for limit in limits {
        panel.level(svg, "limit", limit);
    }
    panel.curve(svg, "curve", tilts);
}

/// The relative energy error on a scale that is symmetric about 0.
fn energy_panel(svg: &mut Svg, samples: &[Sample]) {
    let errors = samples.iter().map(|x| x.errors[0].abs());
    let most = errors.fold(1e-17, f64::max);
    let exponent = most.log10().floor();
    let unit = 10_f64.powf(exponent);
    let bound = 1.1 * most / unit;
    let panel = panel_of_time(ENERGY, samples, [-bound, bound]);
    let label = format!("error / 10{}", superscript(exponent));
    panel.draw(svg, "Relative error of the energy", "time t / s", &label);
    panel.level(svg, "zero", 0.0);
    let errors = samples.iter().map(|x| [x.state.t, x.errors[0] / unit]);
    panel.curve(svg, "curve", errors);
}

/// The path of a point of the axis at distance 1 from the pivot, seen from above.
fn path_panel(svg: &mut Svg, samples: &[Sample], limits: Option<[f64; 2]>) {
    let tilts = samples.iter().map(Sample::tilt);
    let [least, greatest] = extent(tilts.chain(limits.into_iter().flatten()));
    let horizon = least < FRAC_PI_2 && greatest > FRAC_PI_2;
    let widest = least.sin().max(greatest.sin());
    let reach = if horizon { 1.08 } else { 1.08 * widest };
    let panel = Panel::new(PATH, ([-reach, reach], [-reach, reach]), [6.0, 6.0]);
    let heading = "Path of the axis, seen from above";
    panel.draw(svg, heading, "x = sin θ sin φ", "y = −sin θ cos φ");
    let centre = panel.at(0.0, 0.0);
    let radius = |sine: f64| panel.x.at(sine) - centre[0];
    for limit in limits.into_iter().flatten() {
        svg.circle("limit", centre, radius(limit.sin()));
    }
    if horizon {
        svg.circle("horizon", centre, radius(1.0));
    }
    let path = samples.iter().map(|sample| {
        let (sine, cosine) = sample.state.q[HeavyTop::PHI].sin_cos();
        let radius = sample.tilt().sin();
        [radius * sine, -radius * cosine]
    });
    panel.curve(svg, "curve", path.clone());
    for [x, y] in path.take(1) {
        svg.circle("start", panel.at(x, y), 4.0);
    }
    legend(svg, limits, horizon);
}

/// What the lines of the path mean.
fn legend(svg: &mut Svg, limits: Option<[f64; 2]>, horizon: bool) {
    let (left, mut y) = (PATH[0], PATH[3] + 72.0);
    svg.circle("start", [left + 16.0, y - 5.0], 4.0);
    svg.text("tick", Anchor::Start, [left + 42.0, y], "start");
    let mut row = |class: &str, text: &str| {
        y += 20.0;
        svg.line(class, [left, y - 5.0], [left + 32.0, y - 5.0]);
        svg.text("tick", Anchor::Start, [left + 42.0, y], text);
    };
    if let Some(limits) = limits {
        let [least, greatest] = limits.map(f64::to_degrees);
        let text = format!("closed form: θ from {least:.2}° to {greatest:.2}°");
        row("limit", &text);
    }
    if horizon {
        row("horizon", "horizon, θ = 90°");
    }
}

/// A panel with the times of the motion along x.
fn panel_of_time(pixels: [f64; 4], samples: &[Sample], range: [f64; 2]) -> Panel {
    let times = extent(samples.iter().map(|sample| sample.state.t));
    Panel::new(pixels, (times, range), [8.0, 5.0])
}

/// A whole number in superscript digits.
fn superscript(value: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let text = format!("{value:.0}");
    let digits = text.chars().map(|character| character.to_digit(10));
    digits
        .map(|digit| digit.map_or('⁻', |digit| DIGITS[digit as usize]))
        .collect()
}
