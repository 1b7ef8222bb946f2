//! The figure: how the cart and its pole move, and angle, position and force over time.

use lagrangian_examples::{Anchor, Panel, Svg, extent};

use crate::model::Point;

/// A motion and what it is called.
pub(crate) struct Curve {
    pub(crate) label: String,
    pub(crate) motion: Vec<Point>,
}

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 1010.0;
const LEFT: f64 = 90.0;
const RIGHT: f64 = 870.0;

/// How much of the motions is plotted, in s.
const SHOWN: f64 = 4.0;

/// The classes of the curves.
const CLASSES: [&str; 4] = ["curve", "second", "third", "limit"];

/// A quantity of a motion.
struct Quantity {
    name: &'static str,
    of: fn(&Point) -> f64,
}

const QUANTITIES: [Quantity; 3] = [
    Quantity {
        name: "θ / degrees",
        of: |(state, _)| state.q[1].to_degrees(),
    },
    Quantity {
        name: "x / m",
        of: |(state, _)| state.q[0],
    },
    Quantity {
        name: "force / N",
        of: |(_, force)| *force,
    },
];

/// The figure of some motions with a pole of a length in m; the third one is shown as it moves.
pub(crate) fn figure(curves: &[Curve], length: f64) -> String {
    let mut svg = Svg::new(WIDTH, HEIGHT);
    let title = "A pole on a cart under a linear-quadratic regulator";
    svg.text("title", Anchor::Start, [LEFT, 36.0], title);
    if let Some(curve) = curves.get(2) {
        movement(&mut svg, curve, length);
    }
    let tops = [320.0, 550.0, 780.0];
    for (quantity, top) in QUANTITIES.iter().zip(tops) {
        plot(&mut svg, quantity, curves, [top, top + 160.0]);
    }
    let mut y = tops[1] + 18.0;
    for (curve, class) in curves.iter().zip(CLASSES) {
        svg.line(class, [640.0, y], [665.0, y]);
        svg.text("tick", Anchor::Start, [673.0, y + 5.0], &curve.label);
        y += 19.0;
    }
    svg.finish()
}

/// The cart and its pole every tenth of a second while they move fast.
fn movement(svg: &mut Svg, curve: &Curve, length: f64) {
    let shown: Vec<_> = curve.motion.iter().take(130).step_by(5).collect();
    let [low, high] = extent(shown.iter().map(|(state, _)| state.q[0]));
    let (low, high) = (low - length, high + length);
    let scale = ((RIGHT - LEFT) / (high - low)).min(170.0 / (1.1 * length));
    let middle = 0.5 * (low + high);
    let rail = 245.0;
    svg.line("zero", [LEFT, rail], [RIGHT, rail]);
    for (state, _) in &shown {
        let x = 0.5 * (LEFT + RIGHT) + scale * (state.q[0] - middle);
        let (sine, cosine) = state.q[1].sin_cos();
        let tip = [x + scale * length * sine, rail - scale * length * cosine];
        svg.rectangle("frame", [x - 14.0, rail - 5.0], [x + 14.0, rail + 5.0]);
        svg.line("third", [x, rail], tip);
        svg.circle("start", tip, 3.0);
    }
    let label = format!("{}, every 0.1 s for 2.6 s", curve.label);
    svg.text("tick", Anchor::Start, [LEFT, 275.0], &label);
}

/// A quantity of all motions over time.
fn plot(svg: &mut Svg, quantity: &Quantity, curves: &[Curve], [top, bottom]: [f64; 2]) {
    let is_shown = |point: &&Point| point.0.t < SHOWN + 1e-9;
    let points = curves.iter().flat_map(|curve| &curve.motion);
    let [low, high] = extent(points.filter(is_shown).map(quantity.of));
    let margin = 0.06 * (high - low);
    let values = [low - margin, high + margin];
    let panel = Panel::new(
        [LEFT, RIGHT, top, bottom],
        ([0.0, SHOWN], values),
        [8.0, 5.0],
    );
    panel.draw(svg, "", "time t / s", quantity.name);
    panel.level(svg, "zero", 0.0);
    for (curve, class) in curves.iter().zip(CLASSES) {
        let shown = curve.motion.iter().filter(is_shown);
        panel.curve(
            svg,
            class,
            shown.map(|point| [point.0.t, (quantity.of)(point)]),
        );
    }
}
