//! What no top can be, and what no integration can do.

use crate::model::HeavyTop;
use crate::options::Options;

/// The most samples that fit into memory without a second thought: 100 MB.
const MAX_SAMPLES: usize = 1_000_000;

impl Options {
    /// The first thing that is wrong with the options, in one sentence.
    pub(crate) fn check(&self) -> Result<(), String> {
        self.check_body()?;
        self.check_start()?;
        self.check_integration()
    }

    /// A body has mass and inertia, and gravity points down.
    fn check_body(&self) -> Result<(), String> {
        let HeavyTop {
            i1,
            i2,
            i3,
            m,
            g,
            l,
        } = self.top();
        for (name, value) in [("--i1", i1), ("--i2", i2), ("--i3", i3), ("--mass", m)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(format!(
                    "{name} must be positive and finite, and is {value}"
                ));
            }
        }
        for (name, value) in [("--arm", l), ("--gravity", g)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(format!(
                    "{name} must be finite and not negative, and is {value}; a top that hangs has a \
                     --tilt over 90 degrees"
                ));
            }
        }
        self.check_inertias()
    }

    /// About the centre of mass (I₂ + I₃ − I₁)/2 is the sum of x² over the mass, and likewise for y and
    /// z; none of them is negative. About the pivot I₁ and I₂ are greater by m l² (2.2).
    fn check_inertias(&self) -> Result<(), String> {
        let HeavyTop {
            i1, i2, i3, m, l, ..
        } = self.top();
        let offset = m * l * l;
        let [a, b, c] = [i1 - offset, i2 - offset, i3];
        let rounding = 1e-12 * (i1 + i2 + i3);
        if a.max(b).max(c) > 0.5 * (a + b + c) + rounding {
            return Err(format!(
                "no rigid body has the moments of inertia {i1}, {i2} and {i3} kg m² about a pivot {l} m \
                 from its centre of mass: those about the centre of mass would be {a:.4}, {b:.4} and \
                 {c:.4} kg m², and the greatest may not exceed the sum of the others"
            ));
        }
        Ok(())
    }

    /// Euler angles need a third axis that is not vertical.
    fn check_start(&self) -> Result<(), String> {
        let tilt = self.tilt;
        if !(tilt > 0.0 && tilt < 180.0) {
            return Err(format!(
                "--tilt must lie between 0 and 180 degrees, both excluded, and is {tilt}: the Euler \
                 angles φ and ψ are not defined where the axis is vertical"
            ));
        }
        for (name, value) in [
            ("--spin", self.spin),
            ("--precession", self.precession),
            ("--nutation", self.nutation),
        ] {
            if !value.is_finite() {
                return Err(format!("{name} must be finite, and is {value}"));
            }
        }
        Ok(())
    }

    /// The integration must be possible, and end.
    fn check_integration(&self) -> Result<(), String> {
        let Self {
            time,
            samples,
            tolerance,
            ..
        } = *self;
        if !(time > 0.0 && time.is_finite()) {
            return Err(format!("--time must be positive, and is {time}"));
        }
        if !(2..=MAX_SAMPLES).contains(&samples) {
            return Err(format!(
                "--samples must be from 2 to {MAX_SAMPLES}, and is {samples}"
            ));
        }
        if !(1e-15..=1e-2).contains(&tolerance) {
            return Err(format!(
                "--tolerance must be from 1e-15, where rounding ends all progress, to 1e-2, where the \
                 result means nothing, and is {tolerance}"
            ));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use crate::options::Options;

    /// The complaint about a command line, empty if there is none.
    fn complaint(line: &str) -> String {
        let words = std::iter::once("heavy_top").chain(line.split_whitespace());
        Options::try_parse_from(words)
            .expect("numbers where numbers belong")
            .check()
            .err()
            .unwrap_or_default()
    }

    #[test]
    fn possible_values() {
        for line in [
            "",
            "--i1 1 --i2 0.9 --i3 0.6",
            "--precession -0.5 --nutation -1e-3 --spin -20",
            "--gravity 0 --arm 0",
            "--tilt 179.9 --tolerance 1e-3 -n 2 -t 1e-3",
            // A thin disc: the greatest moment is exactly the sum of the others.
            "--i1 15.234375 --i3 0.46875 -m 15 -l 1",
        ] {
            assert_eq!(complaint(line), "", "{line}");
        }
    }

    #[test]
    fn impossible_values() {
        for (line, start) in [
            ("--i1 0", "--i1 must be positive"),
            ("--i2 -1", "--i2 must be positive"),
            ("--i3 nan", "--i3 must be positive"),
            ("--mass -1", "--mass must be positive"),
            ("--mass inf", "--mass must be positive"),
            ("--arm -0.1", "--arm must be finite and not negative"),
            (
                "--gravity -9.81",
                "--gravity must be finite and not negative",
            ),
            ("--i1 1 --i2 2 --i3 0.9 --arm 0", "no rigid body"),
            ("--i3 2.5 --arm 0", "no rigid body"),
            // Possible about the centre of mass, and not about a pivot away from it.
            ("--i1 1 --i3 1.9", "no rigid body"),
            ("--tilt 0", "--tilt must lie between"),
            ("--tilt 180", "--tilt must lie between"),
            ("--tilt -5", "--tilt must lie between"),
            ("--tilt nan", "--tilt must lie between"),
            ("--spin inf", "--spin must be finite"),
            ("--time 0", "--time must be positive"),
            ("--samples 1", "--samples must be from 2"),
            ("--samples 2000000000", "--samples must be from 2"),
            ("--tolerance 0", "--tolerance must be from"),
            ("--tolerance 1", "--tolerance must be from"),
            ("--tolerance 1e-20", "--tolerance must be from"),
        ] {
            let found = complaint(line);
            assert!(found.starts_with(start), "{line}: {found:?}");
        }
    }
}
