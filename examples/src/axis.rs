//! An axis: a range of values laid out along pixels, with ticks at round numbers.

/// An axis of a panel.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The values at both ends.
    pub range: [f64; 2],
    /// The pixels at both ends.
    pub pixels: [f64; 2],
    /// The distance between ticks: 1, 2 or 5 times a power of ten.
    step: f64,
}

impl Axis {
    /// An axis with at most `ticks` ticks or so. A range without width is widened.
    #[must_use]
    pub fn new(range: [f64; 2], pixels: [f64; 2], ticks: f64) -> Self {
        let [low, high] = range;
        // Distances below the resolution of the numbers themselves have no round values in between.
        let least = 1e-9 * low.abs().max(high.abs()).max(1e-300);
        let range = if high - low > least {
            range
        } else {
            [low - least, high + least]
        };
        let rough = (range[1] - range[0]) / ticks;
        let decade = 10_f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0]
            .into_iter()
            .map(|digit| digit * decade)
            .find(|step| *step >= rough)
            .unwrap_or(10.0 * decade);
        Self {
            range,
            pixels,
            step,
        }
    }

    /// Where a value lies, in pixels.
    #[must_use]
    pub fn at(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let [from, to] = self.pixels;
        from + (value - low) / (high - low) * (to - from)
    }

    /// The values of the ticks and their labels.
    pub fn ticks(&self) -> impl Iterator<Item = (f64, String)> + use<> {
        let Self { range, step, .. } = *self;
        let first = (range[0] / step - 1e-9).ceil();
        let count = (range[1] / step + 1e-9).floor() - first;
        let decimals = (-step.log10().floor()).clamp(0.0, 12.0);
        (0_u16..)
            .map(f64::from)
            .take_while(move |k| *k <= count)
            .map(move |k| {
                let value = (first + k) * step;
                (value, label(value, decimals))
            })
    }
}

/// A number with a given count of decimals and a true minus sign.
fn label(value: f64, decimals: f64) -> String {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // A whole number up to 12.
    let decimals = decimals as usize;
    // Adding 0 takes the sign off a zero.
    format!("{:.decimals$}", value + 0.0).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::Axis;

    /// The labels of an axis.
    fn labels(range: [f64; 2], ticks: f64) -> String {
        let labels: Vec<_> = Axis::new(range, [0.0, 1.0], ticks)
            .ticks()
            .map(|(_, label)| label)
            .collect();
        labels.join(" ")
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(labels([0.0, 12.0], 6.0), "0 2 4 6 8 10 12");
        assert_eq!(labels([-0.31, 0.31], 6.0), "−0.2 0.0 0.2");
        assert_eq!(labels([29.7, 33.4], 5.0), "30 31 32 33");
        assert_eq!(labels([0.0, 3e5], 4.0), "0 100000 200000 300000");
    }

    #[test]
    fn a_range_without_width_is_widened() {
        let axis = Axis::new([30.0, 30.0], [0.0, 100.0], 5.0);
        assert!((axis.at(30.0) - 50.0).abs() < 1e-3);
        assert!(axis.ticks().count() < 12);
    }
}
