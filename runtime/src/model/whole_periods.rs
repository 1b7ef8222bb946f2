//! Angles reduced by whole periods.
//!
//! The state of an integration counts turns, and the rounding error of an angle grows with them. A stepper also stores
//! the compensation, the part that rounding has removed from the state. With it, the reduced angle is accurate to all
//! digits. The turns are subtracted with 2π in several parts (W. J. Cody & W. Waite, *Software Manual for the
//! Elementary Functions*, 1980).

use core::f64::consts::TAU;

use nalgebra::Vector2;

use crate::limits::SMALL_ANGLE;
use crate::linalg::lane_select::{LaneSelect, greater};
use crate::scalar::Scalar;

/// 2π as the sum of four parts.
///
/// The first two parts have so few bits that their products with a number of turns are exact, up to 2 to the power
/// `digits` turns. The error of the sum is about the rounding error of 2π in a format with twice the digits, so that
/// scalars with more digits than `f64` benefit, too.
struct FullTurn {
    parts: [f64; 4],
    /// The third and the fourth part as three parts, the first of which has few bits, too: for larger numbers of turns.
    later_parts: [f64; 3],
    digits: u32,
}

/// For scalars with at least the precision of `f64`; `runtime/scripts/full_turn_constants.py` computes the parts.
const BINARY64: FullTurn = FullTurn {
    parts: [
        6.283_185_482_025_146_5,
        -1.748_455_531_469_517_2e-7,
        -6.860_497_997_771_531_6e-15,
        3.391_371_064_147_56e-31,
    ],
    later_parts: [
        -6.860_498_040_023_527_5e-15,
        4.225_199_626_794_971e-23,
        -2.111_389_598_789_867_5e-39,
    ],
    digits: 29,
};

/// For scalars with at least the precision of `f32`.
const BINARY32: FullTurn = FullTurn {
    parts: [
        6.283_203_125,
        -1.781_433_820_724_487_3e-5,
        -3.482_206_301_086_421_3e-9,
        2.288_475_566_583_491_2e-17,
    ],
    later_parts: [
        -3.482_455_213_088_542_2e-9,
        2.489_348_787_867_995_4e-13,
        8.089_064_641_434_98e-21,
    ],
    digits: 12,
};

impl FullTurn {
    fn of<S: Scalar>() -> Option<&'static Self> {
        let epsilon = S::machine_epsilon();
        if epsilon <= f64::EPSILON {
            Some(&BINARY64)
        } else if epsilon <= f32::EPSILON.into() {
            Some(&BINARY32)
        } else {
            None
        }
    }

    /// Returns the largest number of turns, a power of two, whose products with the first parts are exact.
    fn max_turns(&self) -> f64 {
        f64::from(1_u32 << self.digits)
    }

    /// Returns the number of units nearest to an angle, times the period, without derivative parts. It is 0 for angles
    /// that are not larger than `least`, and if there are too many.
    fn multiple_in<S: Scalar>(&self, angle: S, unit: &Unit) -> S {
        let Unit {
            period,
            inverse,
            least,
        } = *unit;
        let (smallest, largest) = (angle.smallest(), angle.largest());
        if largest > smallest {
            return self.multiple_in_lanes(angle, unit);
        }
        let multiple = period * libm::floor(largest.abs() * inverse + 0.5);
        let is_counted = largest.abs() > least && multiple <= self.max_turns();
        S::from_f64(if is_counted {
            multiple.copysign(largest)
        } else {
            0.0
        })
    }

    /// Returns the multiples in lanes that differ; the result of each lane is independent of the others.
    fn multiple_in_lanes<S: Scalar>(&self, angle: S, unit: &Unit) -> S {
        let size = angle.abs();
        let units = size * S::from_f64(unit.inverse) + S::from_f64(0.5);
        // A larger number is too many in any case.
        let units = units.min(S::from_f64(2.0 * self.max_turns())).floor();
        let multiple = units * S::from_f64(unit.period);
        let is_too_many = greater(multiple, S::from_f64(self.max_turns()));
        let is_large = greater(size, S::from_f64(unit.least));
        multiple * is_large * (S::one() - is_too_many) * angle.signum()
    }

    /// Returns the angle and its compensation reduced by whole blocks of periods, if there are more turns than
    /// [`max_turns`](Self::max_turns).
    ///
    /// Lanes with fewer turns, or with more turns than the square of this number, are unchanged. A block consists of a
    /// power of two of periods, at most as many turns as this number, so that its products with a number of blocks are
    /// exact.
    fn less_blocks<S: Scalar>(&self, angle: S, compensation: S, periods: &Unit) -> (S, S) {
        let least = (self.max_turns() - 0.5 * periods.period) * TAU;
        if angle.abs().largest() <= least {
            return (angle, compensation);
        }
        let mut block = self.max_turns();
        while block * periods.period > self.max_turns() {
            block *= 0.5;
        }
        let unit = Unit {
            inverse: periods.inverse / block,
            least,
            ..*periods
        };
        let count = self.multiple_in(angle, &unit);
        let [first, second, ..] = self.parts;
        let [third, fourth, fifth] = self.later_parts;
        let product = |part: f64| count * S::from_f64(part) * S::from_f64(block);
        let (mut rest, mut lost) = (angle, S::zero());
        for part in [first, second, third] {
            let (less, rounding) = difference(rest, product(part));
            (rest, lost) = (less, lost + rounding);
        }
        lost = lost - product(fourth) - product(fifth);
        let (rest, compensation_of_rest) = difference(rest, -(compensation + lost));
        let pair = [rest, compensation_of_rest].into();
        let other = [angle, compensation].into();
        let [rest, compensation] = Vector2::select(pair, other, count.abs().signum()).into();
        (rest, compensation)
    }
}

/// Whole periods, or blocks of them, by which an angle is reduced.
struct Unit {
    /// The number of turns in a period.
    period: f64,
    /// The reciprocal of the angle of the unit.
    inverse: f64,
    /// Larger angles are reduced.
    least: f64,
}

/// Returns x − y and its rounding error (T. J. Dekker, *A floating-point technique for extending the available
/// precision*, Numer. Math. **18** (1971) 224–242).
fn difference<S: Scalar>(x: S, y: S) -> (S, S) {
    let difference = x - y;
    let of_y = x - difference;
    let of_x = difference + of_y;
    (difference, (x - of_x) - (y - of_y))
}

/// Returns whether an angle is so large that subtracting periods increases its accuracy.
#[inline]
pub(crate) fn is_large<S: Scalar>(angle: S) -> bool {
    angle.abs().largest() > SMALL_ANGLE
}

/// Returns the angle `angle` + `compensation` reduced by whole periods to the value nearest to zero; `period` is in
/// full turns.
///
/// Lanes are unchanged if their angle is not large, or too large for the digits of 2π. In `f64` this happens after some
/// 10¹⁵ turns, where neighbouring numbers are a radian apart.
#[inline(never)]
#[cold]
pub(crate) fn less_whole_periods<S: Scalar>(angle: S, compensation: S, period: u32) -> S {
    let Some(full_turn) = FullTurn::of::<S>() else {
        return angle;
    };
    let period = f64::from(period);
    let periods = Unit {
        period,
        inverse: 1.0 / (period * TAU),
        least: SMALL_ANGLE,
    };
    let (angle, compensation) = full_turn.less_blocks(angle, compensation, &periods);
    let turns = full_turn.multiple_in(angle, &periods);
    let [first, second, third, fourth] = full_turn.parts.map(S::from_f64);
    // The differences are exact in `f64`: they are small multiples of the last bit of the angle or of the product.
    let rest = (angle - turns * first) - turns * second;
    let compensation = compensation * turns.signum().abs();
    rest - (turns * third - (compensation - turns * fourth))
}

#[cfg(test)]
mod tests {
    use super::{BINARY32, BINARY64, FullTurn, less_whole_periods};
    use crate::scalar::{DoubleDouble, Dual, Lanes, Scalar};

    fn double(x: f64) -> DoubleDouble {
        DoubleDouble::from(x)
    }

    /// Returns the angle minus `turns` full turns, in double-double arithmetic.
    fn exact(angle: f64, compensation: f64, turns: f64) -> DoubleDouble {
        let [first, second, third, fourth] =
            BINARY64.parts.map(|part| double(part) * double(turns));
        double(angle) - first - second - third - fourth + double(compensation)
    }

    #[test]
    fn the_parts_are_those_of_a_full_turn() {
        let tau = DoubleDouble::pi() * double(2.0);
        for full_turn in [BINARY64, BINARY32] {
            let FullTurn {
                parts,
                later_parts,
                digits,
            } = full_turn;
            let sum = parts
                .iter()
                .rev()
                .fold(double(0.0), |sum, part| sum + double(*part));
            let bound = if digits == BINARY64.digits {
                1e-31
            } else {
                1e-24
            };
            assert!((sum - tau).to_f64().abs() < bound);
            let later = later_parts.iter().rev();
            let later = later.fold(double(0.0), |sum, part| sum + double(*part));
            let rest = double(parts[2]) + double(parts[3]);
            assert!((later - rest).to_f64().abs() < bound);
            // The product with the largest number of turns is exact.
            let most = full_turn.max_turns() - 1.0;
            for part in parts[..2].iter().chain(&later_parts[..1]) {
                let product = double(*part) * double(most);
                assert!(product.low().abs() <= 0.0);
                if digits == BINARY32.digits {
                    let nearest = f64::from(<f32 as Scalar>::from_f64(product.to_f64()));
                    assert!((product.to_f64() - nearest).abs() <= 0.0);
                }
            }
        }
    }

    #[test]
    fn whole_periods_are_removed_to_the_last_digit() {
        for period in [1, 2, 3, 10, 64] {
            for magnitude in 4..31 {
                for step in 0..50 {
                    let angle = libm::ldexp(1.0 + f64::from(step) / 50.3, magnitude);
                    let compensation = angle * 0.41 * f64::EPSILON * f64::from(step % 3 - 1);
                    for sign in [1.0, -1.0] {
                        let (x, rounding) = (sign * angle, sign * compensation);
                        let found = less_whole_periods(x, rounding, period);
                        let length = f64::from(period) * core::f64::consts::TAU;
                        let periods = libm::floor(x.abs() / length + 0.5);
                        let turns = f64::from(period) * periods.copysign(x);
                        if turns.abs() > 0.0 {
                            let error = (double(found) - exact(x, rounding, turns)).to_f64();
                            let ulp = 0.51 * f64::EPSILON * found.abs() + 1e-19;
                            assert!(error.abs() <= ulp, "{x:e} {period}: {found:e}, {error:e}");
                            assert!(found.abs() <= 0.5 * length + 1e-6);
                        } else {
                            assert_eq!(found.to_bits(), x.to_bits());
                        }
                    }
                }
            }
        }
    }

    /// Beyond 5·10⁸ turns, the angle is a whole number of turns and a remainder, in extended precision.
    #[test]
    fn many_turns_are_removed_to_the_last_digit() {
        let tau = DoubleDouble::pi() * double(2.0);
        for period in [1_u32, 2, 3, 10, 64] {
            for magnitude in 28..52 {
                for step in 1..30 {
                    let count = libm::floor(libm::ldexp(1.0 + f64::from(step) / 37.7, magnitude));
                    let turns = f64::from(period) * libm::floor(count / f64::from(period));
                    let rest = (f64::from(step) / 15.0 - 1.0) * 3.1 * f64::from(period);
                    for sign in [1.0, -1.0] {
                        let exact = (double(turns) * tau + double(rest)) * double(sign);
                        let angle = exact.to_f64();
                        let compensation = (exact - double(angle)).to_f64();
                        let found = less_whole_periods(angle, compensation, period);
                        // The error of the product with 2π in double-doubles.
                        let tolerance = 1e-15 * f64::from(period) + 1e-31 * turns;
                        let error = found - sign * rest;
                        assert!(
                            error.abs() < tolerance,
                            "{angle:e} {period}: {found}, {error:e}"
                        );
                    }
                }
            }
        }
        let angle = <f32 as Scalar>::from_f64(3e6);
        let exact = 3e6 - libm::round(3e6 / core::f64::consts::TAU) * core::f64::consts::TAU;
        let found = f64::from(less_whole_periods(angle, 0.0, 1));
        assert!((found - exact).abs() < 1e-6, "{found} {exact}");
    }

    #[test]
    fn a_lane_is_reduced_as_it_is_alone() {
        let angles = [
            0.3, -7.9, 8.1, -1e3, 123_456.7, 3.2e9, -3.4e9, 1e15, -1e300, 8.0, 4.0e8, -3.7e12,
        ];
        for period in [1, 2, 7] {
            for shift in 0..angles.len() {
                let lanes = Lanes::<4>::from_fn(|lane| angles[(shift + 3 * lane) % angles.len()]);
                let rounding = Lanes::<4>::from_fn(|lane| lanes.lane(lane) * 1e-17);
                let found = less_whole_periods(lanes, rounding, period);
                for lane in 0..4 {
                    let alone = less_whole_periods(lanes.lane(lane), rounding.lane(lane), period);
                    assert_eq!(found.lane(lane).to_bits(), alone.to_bits(), "{lanes:?}");
                }
            }
        }
        for angle in [7.9, -8.0, 1e300, f64::INFINITY] {
            assert_eq!(less_whole_periods(angle, 0.0, 1).to_bits(), angle.to_bits());
        }
    }

    #[test]
    fn other_scalars_gain_their_own_digits() {
        // 0.7 after 100 000 turns.
        let turns = double(1e5) * double(2.0) * DoubleDouble::pi();
        let angle = turns + DoubleDouble::ratio(7.0, 10.0);
        let error = less_whole_periods(angle, double(0.0), 1) - DoubleDouble::ratio(7.0, 10.0);
        assert!(error.to_f64().abs() < 1e-26);

        let angle = 0.7 + 4000.0 * core::f64::consts::TAU;
        let rounded = <f32 as Scalar>::from_f64(angle);
        let lost = <f32 as Scalar>::from_f64(angle - f64::from(rounded));
        let error = f64::from(less_whole_periods(rounded, lost, 1)) - 0.7;
        assert!(error.abs() < 2e-7, "{error:e}");
        assert!(lost.abs() > 1e-4);
    }

    #[test]
    fn derivative_parts_are_kept() {
        let found = less_whole_periods(Dual::new(1e4, [3.0]), Dual::new(1e-13, [1e-17_f64]), 1);
        let value: f64 = less_whole_periods(1e4, 1e-13, 1);
        assert_eq!(found.value.to_bits(), value.to_bits());
        assert_eq!(found.derivative[0].to_bits(), 3.0_f64.to_bits());
    }
}
