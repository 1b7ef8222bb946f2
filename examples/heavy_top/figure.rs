//! The figure: tilt against time, energy error against time, and the path of the axis from above.

use std::f64::consts::FRAC_PI_2;

use lagrangian_examples::{Anchor, Panel, Point, Svg, extent};

use crate::model::HeavyTop;
use crate::nutation::Nutation;
use crate::record::Record;

/// The most points of a curve; more would only make the file larger.
const MAX_POINTS: usize = 20_000;

/// Left, right, top and bottom of the three panels in pixels.
const TILT: [f64; 4] = [84.0, 620.0, 112.0, 322.0];
const ENERGY: [f64; 4] = [84.0, 620.0, 402.0, 572.0];
const PATH: [f64; 4] = [712.0, 1072.0, 112.0, 472.0];

/// The figure of a motion, with the limits of its tilt where they are known in closed form.
pub(crate) fn figure(parameters: &str, records: &[Record], nutation: Option<&Nutation>) -> String {
    let mut svg = Svg::new(1100.0, 632.0);
    svg.text(
        "title",
        Anchor::Start,
        [24.0, 36.0],
        "Motion of a heavy top",
    );
    svg.text("subtitle", Anchor::Start, [24.0, 62.0], parameters);
    let limits: Vec<f64> = nutation
        .map(|form| vec![form.least_tilt(), form.greatest_tilt()])
        .unwrap_or_default();
    tilt_panel(&mut svg, records, &limits);
    energy_panel(&mut svg, records);
    path_panel(&mut svg, records, &limits);
    svg.finish()
}

/// θ(t) in degrees.
fn tilt_panel(svg: &mut Svg, records: &[Record], limits: &[f64]) {
    let tilts = || {
        records
            .iter()
            .map(|record| record.state.q[HeavyTop::THETA].to_degrees())
    };
    let limits: Vec<f64> = limits.iter().map(|limit| limit.to_degrees()).collect();
    let [low, high] = extent(tilts().chain(limits.iter().copied()));
    // A steady precession is a straight line, and not a magnified rounding error.
    let margin = (0.06 * (high - low)).max(0.05);
    let panel = panel_of_time(TILT, records, [low - margin, high + margin]);
    panel.draw(svg, "Tilt of the axis", "time t / s", "tilt θ / degrees");
    for &limit in &limits {
        let [from, to] = panel.x.range;
        svg.line("limit", panel.at(from, limit), panel.at(to, limit));
    }
    let tilts = points(records, |record| {
        record.state.q[HeavyTop::THETA].to_degrees()
    });
    panel.curve(svg, "curve", tilts);
}

/// The relative energy error on a scale that is symmetric about 0.
fn energy_panel(svg: &mut Svg, records: &[Record]) {
    let most = records
        .iter()
        .map(|record| record.errors[0].abs())
        .fold(1e-17, f64::max);
    let exponent = most.log10().floor();
    let unit = 10_f64.powf(exponent);
    let bound = 1.1 * most / unit;
    let panel = panel_of_time(ENERGY, records, [-bound, bound]);
    let label = format!("error / 10{}", superscript(exponent));
    panel.draw(svg, "Relative error of the energy", "time t / s", &label);
    let [from, to] = panel.x.range;
    svg.line("zero", panel.at(from, 0.0), panel.at(to, 0.0));
    panel.curve(
        svg,
        "curve",
        points(records, |record| record.errors[0] / unit),
    );
}

/// The path of a point of the axis at distance 1 from the pivot, seen from above.
fn path_panel(svg: &mut Svg, records: &[Record], limits: &[f64]) {
    let tilts = records.iter().map(|record| record.state.q[HeavyTop::THETA]);
    let [least, greatest] = extent(tilts.chain(limits.iter().copied()));
    let horizon = least < FRAC_PI_2 && greatest > FRAC_PI_2;
    let widest = if horizon {
        1.0
    } else {
        least.sin().max(greatest.sin())
    };
    let range = [-1.08 * widest, 1.08 * widest];
    let panel = Panel::new(PATH, (range, range), [6.0, 6.0]);
    panel.draw(
        svg,
        "Path of the axis, seen from above",
        "x = sin θ sin φ",
        "y = −sin θ cos φ",
    );
    let centre = panel.at(0.0, 0.0);
    let radius = |sine: f64| panel.x.at(sine) - centre[0];
    for limit in limits {
        svg.circle("limit", centre, radius(limit.sin()));
    }
    if horizon {
        svg.circle("horizon", centre, radius(1.0));
    }
    let mut path = thinned(records).map(|record| {
        let [x, y] = seen_from_above(record);
        panel.at(x, y)
    });
    svg.curve("curve", path.clone());
    if let Some(start) = path.next() {
        svg.circle("start", start, 4.0);
    }
    legend(svg, limits, horizon);
}

/// What the lines of the path mean.
fn legend(svg: &mut Svg, limits: &[f64], horizon: bool) {
    let (left, mut y) = (PATH[0], PATH[3] + 72.0);
    let mut row = |svg: &mut Svg, class: &str, text: &str| {
        if class == "start" {
            svg.circle(class, [left + 16.0, y - 5.0], 4.0);
        } else {
            svg.line(class, [left, y - 5.0], [left + 32.0, y - 5.0]);
        }
        svg.text("tick", Anchor::Start, [left + 42.0, y], text);
        y += 20.0;
    };
    row(svg, "start", "start");
    if let [least, greatest] = limits {
        let (least, greatest) = (least.to_degrees(), greatest.to_degrees());
        row(
            svg,
            "limit",
            &format!("closed form: θ from {least:.2}° to {greatest:.2}°"),
        );
    }
    if horizon {
        row(svg, "horizon", "horizon, θ = 90°");
    }
}

/// A panel with the times of the motion along x.
fn panel_of_time(pixels: [f64; 4], records: &[Record], range: [f64; 2]) -> Panel {
    let times = extent(records.iter().map(|record| record.state.t));
    Panel::new(pixels, (times, range), [8.0, 5.0])
}

/// A quantity against time.
fn points(records: &[Record], value: impl Fn(&Record) -> f64) -> impl Iterator<Item = [f64; 2]> {
    thinned(records).map(move |record| [record.state.t, value(record)])
}

/// Every so many records, that not too many remain.
fn thinned(records: &[Record]) -> impl Iterator<Item = &Record> + Clone {
    records
        .iter()
        .step_by(records.len().div_ceil(MAX_POINTS).max(1))
}

/// The horizontal coordinates of the point of the axis at distance 1 from the pivot.
fn seen_from_above(record: &Record) -> Point {
    let (sine, cosine) = record.state.q[HeavyTop::PHI].sin_cos();
    let radius = record.state.q[HeavyTop::THETA].sin();
    [radius * sine, -radius * cosine]
}

/// A whole number in superscript digits.
fn superscript(value: f64) -> String {
    format!("{value:.0}")
        .chars()
        .map(|character| match character {
            '-' => '⁻',
            digit => "⁰¹²³⁴⁵⁶⁷⁸⁹"
                .chars()
                .nth(digit.to_digit(10).unwrap_or(0) as usize)
                .unwrap_or(digit),
        })
        .collect()
}
