//! Jacobi's functions, and Legendre's integrals of the first and the third kind, for a given modulus.
//!
//! Functions by the descending Landen transformation, with arithmetic-geometric means: R. Bulirsch, *Numerical
//! calculation of elliptic integrals and elliptic functions*, Numer. Math. **7** (1965) 78–90, procedure sncndn.
//! Integrals by Carlson's symmetric integrals: NIST Digital Library of Mathematical Functions, section 19.25(i).

use super::carlson::{carlson_rc, carlson_rf, carlson_rj};
use crate::integrate::SingleNumber;
use crate::limits::elliptic::{MEANS, NEGATIVE_CHARACTERISTIC};

/// The modulus k of elliptic functions, given by the parameter m = k² and its complement 1 − m.
///
/// Both are given because, near m = 1, computing 1 − m would lose digits of the complement, and motions near a
/// separatrix depend on its logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modulus<S = f64> {
    parameter: S,
    complement: S,
}

impl<S: SingleNumber> Modulus<S> {
    /// Creates the modulus with a parameter m and its complement 1 − m, both in \[0, 1\]. Outside this range, results
    /// are NaN.
    #[must_use]
    pub fn new(parameter: S, complement: S) -> Self {
        Self {
            parameter,
            complement,
        }
    }

    /// Returns m.
    #[must_use]
    pub fn parameter(&self) -> S {
        self.parameter
    }

    /// Returns 1 − m.
    #[must_use]
    pub fn complement(&self) -> S {
        self.complement
    }

    /// Returns whether m = 1: the functions are hyperbolic and have no period.
    #[must_use]
    pub fn is_hyperbolic(&self) -> bool {
        self.complement.abs().largest() <= 0.0
    }

    /// Returns the complete integral of the first kind K(m): the quarter period of sn and cn, infinite for m = 1.
    #[must_use]
    pub fn complete_first(&self) -> S {
        if self.is_hyperbolic() {
            return S::from_f64(f64::INFINITY);
        }
        let means = Means::of(self);
        S::pi() / (means.last + means.last)
    }

    /// Returns the integral of the first kind F(φ|m) = ∫₀^φ dα/√(1 − m sin²α), for |φ| ≤ π, given the sine and the
    /// cosine of φ.
    ///
    /// The result is smooth at φ = ½π: its deviation from the complete integral is odd in the cosine. The symmetric
    /// integral is not smooth in the square of the cosine; with the first term of the expansion, derivative parts of
    /// first and second order are correct.
    #[must_use]
    pub fn first(&self, sine: S, cosine: S) -> S {
        if cosine.abs().largest() <= 0.0 {
            return sign(sine) * (self.complete_first() - cosine / self.complement.sqrt());
        }
        if cosine.largest() < 0.0 {
            let whole = S::from_f64(2.0) * sign(sine) * self.complete_first();
            return whole - self.first(sine, -cosine);
        }
        let [x, y] = self.arguments(sine, cosine);
        sine * carlson_rf(x, y, S::one())
    }

    /// Returns the integral of the third kind Π(n; φ|m) = ∫₀^φ dα/((1 − n sin²α)√(1 − m sin²α)), for |φ| ≤ π and n < 1,
    /// given the sine and the cosine of φ.
    #[must_use]
    pub fn third(&self, characteristic: S, sine: S, cosine: S) -> S {
        if cosine.abs().largest() <= 0.0 {
            let slope = (S::one() - characteristic) * self.complement.sqrt();
            return sign(sine) * (self.complete_third(characteristic) - cosine / slope);
        }
        if cosine.largest() < 0.0 {
            let complete = self.complete_third(characteristic);
            let whole = S::from_f64(2.0) * sign(sine) * complete;
            return whole - self.third(characteristic, sine, -cosine);
        }
        let [x, y] = self.arguments(sine, cosine);
        if characteristic.largest() < NEGATIVE_CHARACTERISTIC {
            return sine * self.third_of_negative(characteristic, [x, y], sine * sine, cosine);
        }
        let square = characteristic * sine * sine;
        let of_third = carlson_rj(x, y, S::one(), S::one() - square);
        self.first(sine, cosine) + square * sine * of_third * S::ratio(1.0, 3.0)
    }

    /// Returns the complete integral of the third kind Π(n|m), for n < 1; infinite for m = 1.
    #[must_use]
    pub fn complete_third(&self, characteristic: S) -> S {
        if self.is_hyperbolic() {
            return S::from_f64(f64::INFINITY);
        }
        let [zero, one] = [S::zero(), S::one()];
        if characteristic.largest() < NEGATIVE_CHARACTERISTIC {
            return self.third_of_negative(characteristic, [zero, self.complement], one, zero);
        }
        let of_third = carlson_rj(zero, self.complement, one, one - characteristic);
        self.complete_first() + characteristic * of_third * S::ratio(1.0, 3.0)
    }

    /// Returns Π(n; φ|m)/sin φ for a negative n and 0 < φ ≤ ½π, as a sum of terms of one sign.
    ///
    /// The integral `R_J` with p = 1 − n sin²φ is expressed by `R_J` with q = cos²φ + sin²φ (1 − m)/(1 − n) (NIST
    /// Digital Library of Mathematical Functions, 19.21.12). `x` and `y` are cos²φ and 1 − m sin²φ.
    fn third_of_negative(&self, n: S, [x, y]: [S; 2], square: S, cosine: S) -> S {
        let one = S::one();
        let divisor = one - n;
        let part = square * self.complement / divisor;
        let q = x + part;
        let of_first = if cosine.abs().largest() > 0.0 {
            carlson_rf(x, y, one) - n * cosine * carlson_rc(y, (one - n * square) * q)
        } else {
            self.complete_first()
        };
        if part.abs().largest() <= 0.0 {
            return of_first / divisor;
        }
        let of_third = part * carlson_rj(x, y, one, q) * S::ratio(1.0, 3.0);
        (of_first - n * of_third) / divisor
    }

    /// Returns Π(n; am(u + v)|m) − Π(n; am u|m), for n ≤ 0.
    ///
    /// The result has full accuracy however small v is, and v may contain any number of half periods.
    ///
    /// By the addition theorem: NIST Digital Library of Mathematical Functions, 19.11(i), with γ and δ multiplied by
    /// sn²u sn²v sn²(u + v), where γ − δ is the square of 1 − n sn²w + n sn u sn v cn w dn w of w = u + v (P. F. Byrd
    /// and M. D. Friedman, *Handbook of Elliptic Integrals for Engineers and Scientists*, 1971, 116.03).
    ///
    /// ```
    /// use lagrangian::elliptic::Modulus;
    ///
    /// // For a small v it is v/(1 − n sn²u).
    /// let modulus = Modulus::new(0.3, 0.7);
    /// let (sn, _, _) = modulus.jacobi(0.8);
    /// let found: f64 = modulus.third_between(-2.0, 0.8, 1e-20);
    /// assert!((found * (1.0 + 2.0 * sn * sn) - 1e-20).abs() < 1e-35);
    /// ```
    #[must_use]
    pub fn third_between(&self, characteristic: S, u: S, v: S) -> S {
        let (half_periods, rest) = self.reduced(v);
        let w = u + rest;
        let [(su, _, _), (sv, cv, _), (sw, cw, dw)] = [u, rest, w].map(|x| self.jacobi(x));
        let n = characteristic;
        let divisors = [su, sv, sw].map(|sn| S::one() - n * sn * sn);
        let gamma = divisors[0] * divisors[1] * divisors[2];
        let root = divisors[2] + n * su * sv * cw * dw;
        let added = n * su * sv * sw * carlson_rc(root * root, gamma);
        let part = self.third(n, sv, cv) + added;
        if half_periods.abs() > 0.0 {
            part + S::from_f64(2.0 * half_periods) * self.complete_third(n)
        } else {
            part
        }
    }

    /// Returns cos²φ and 1 − m sin²φ, the latter as a sum of terms of one sign.
    fn arguments(&self, sine: S, cosine: S) -> [S; 2] {
        let square = cosine * cosine;
        [square, square + self.complement * sine * sine]
    }

    /// Returns the number j of half periods 2K, and u − 2 j K in \[−K, K\].
    #[must_use]
    pub fn reduced(&self, u: S) -> (f64, S) {
        if self.is_hyperbolic() {
            return (0.0, u);
        }
        let half_period = self.complete_first() * S::from_f64(2.0);
        let count = libm::round((u / half_period).largest());
        (count, u - S::from_f64(count) * half_period)
    }

    /// Returns sn u, cn u and dn u.
    #[must_use]
    pub fn jacobi(&self, u: S) -> (S, S, S) {
        if self.is_hyperbolic() {
            let secant = S::one() / u.cosh();
            return (u.tanh(), secant, secant);
        }
        let (half_periods, u) = self.reduced(u);
        let (sn, cn, dn) = Means::of(self).jacobi(u);
        // sn and cn change sign after a half period.
        let odd = libm::fmod(half_periods, 2.0).abs() > 0.5;
        if odd { (-sn, -cn, dn) } else { (sn, cn, dn) }
    }
}

/// Returns −1 below 0, and 1 otherwise.
pub(crate) fn sign<S: SingleNumber>(x: S) -> S {
    if x.largest() < 0.0 {
        -S::one()
    } else {
        S::one()
    }
}

/// The arithmetic-geometric means of 1 and √(1 − m).
struct Means<S> {
    /// The pairs whose means are taken.
    pairs: [[S; 2]; MEANS],
    count: usize,
    last: S,
}

impl<S: SingleNumber> Means<S> {
    fn of(modulus: &Modulus<S>) -> Self {
        let half = S::from_f64(0.5);
        let (mut a, mut b) = (S::one(), modulus.complement.sqrt());
        let mut pairs = [[S::zero(); 2]; MEANS];
        let mut count = 0;
        for pair in &mut pairs {
            *pair = [a, b];
            count += 1;
            let difference = (a - b).abs().largest();
            (a, b) = ((a + b) * half, (a * b).sqrt());
            // The next difference is of the order of the square of this one, and derivative parts lag one step behind.
            if difference <= S::machine_epsilon() * a.abs().largest() {
                break;
            }
        }
        Self {
            pairs,
            count,
            last: a,
        }
    }

    /// Returns sn u, cn u and dn u for |u| ≤ K.
    ///
    /// The recursion proceeds from the cotangent of the amplitude for the last modulus, which is 0, to the cotangent
    /// for the first. There is no cancellation, so that cn and dn are accurate where they are small.
    fn jacobi(&self, u: S) -> (S, S, S) {
        let (sine, cosine) = (u * self.last).sin_cos();
        if sine.abs().largest() <= 0.0 {
            return (u, S::one(), S::one());
        }
        let mut quotient = cosine / sine;
        let mut c = self.last * quotient;
        let mut dn = S::one();
        for [a, b] in self.pairs.iter().take(self.count).rev() {
            quotient *= c;
            c *= dn;
            dn = (*b + quotient) / (*a + quotient);
            quotient = c / *a;
        }
        let sn = sine.signum() / (c * c + S::one()).sqrt();
        (sn, c * sn, dn)
    }
}
