//! Motions with one degree of freedom that do not turn back: rates by the energy, and times as quadratures.

/// A mechanism with T = ½ I(θ) θ̇² and V(θ), which starts at an angle with a rate.
pub(super) struct Freedom<I, V> {
    moment: I,
    potential: V,
    from: f64,
    energy: f64,
    direction: f64,
}

/// The nodes and weights of Gauss's formula with five points, on one side of the middle.
const GAUSS: [(f64, f64); 2] = [
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];
/// That of the middle.
const MIDDLE: f64 = 128.0 / 225.0;

/// In how many parts an interval of length 1 is divided: errors are h¹⁰.
const PARTS: f64 = 30.0;

impl<I: Fn(f64) -> f64, V: Fn(f64) -> f64> Freedom<I, V> {
    pub(super) fn starting(moment: I, potential: V, from: f64, rate: f64) -> Self {
        let energy = 0.5 * moment(from) * rate * rate + potential(from);
        Self {
            moment,
            potential,
            from,
            energy,
            direction: rate.signum(),
        }
    }

    /// θ̇ at an angle.
    pub(super) fn rate(&self, angle: f64) -> f64 {
        let kinetic = self.energy - (self.potential)(angle);
        self.direction * (2.0 * kinetic / (self.moment)(angle)).sqrt()
    }

    /// The time at which an angle is reached, ∫ dθ/θ̇.
    pub(super) fn time(&self, angle: f64) -> f64 {
        let count = (PARTS * ((angle - self.from).abs() + 1.0)).ceil();
        let half = 0.5 * (angle - self.from) / count;
        let mut total = 0.0;
        let mut part = 0.0;
        while part < count {
            let middle = self.from + (2.0 * part + 1.0) * half;
            total += MIDDLE / self.rate(middle);
            for (node, weight) in GAUSS {
                let sides = [-1.0, 1.0].map(|side| self.rate(middle + side * node * half).recip());
                total += weight * (sides[0] + sides[1]);
            }
            part += 1.0;
        }
        half * total
    }
}
