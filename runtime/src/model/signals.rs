//! Inputs that are functions of time, with their Taylor series.

use nalgebra::SVector;

use crate::scalar::Scalar;

/// A function of time s(t) with its Taylor series, such as an input of a model
/// ([`Problem::driven_by`](crate::Problem::driven_by)).
///
/// [`Constant`], [`Polynomial`], [`Sinusoid`] and [`Sum`]s of these are signals. Other signals are written with the
/// building blocks of [`recurrences`](crate::recurrences), such as this chirp a sin(½ r t²):
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::signals::Signal;
/// use lagrangian::recurrences::{SineCosine, Square};
///
/// struct Chirp { amplitude: f64, rate: f64 }
///
/// impl<S: Scalar> Signal<S> for Chirp {
///     fn add_series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [S]) {
///         let [amplitude, half_rate] = [self.amplitude, 0.5 * self.rate].map(S::from_f64);
///         let mut square = Square::<S, HALF>::new();
///         let mut angle = SineCosine::<S, HALF>::new();
///         let mut time = [t, unit].into_iter();
///         for coefficient in coefficients {
///             let square = square.next(time.next().unwrap_or(S::zero()));
///             let (sine, _) = angle.next(half_rate * square);
///             *coefficient += amplitude * sine;
///         }
///     }
/// }
///
/// let chirp = Chirp { amplitude: 2.0, rate: 3.0 };
/// assert!((chirp.value(0.7_f64) - 2.0 * (1.5_f64 * 0.49).sin()).abs() < 1e-15);
/// let mut series = [0.0; 24];
/// chirp.add_series::<12>(0.7, 0.25, &mut series);
/// let sum: f64 = series.iter().rev().fold(0.0, |sum, c| 0.5 * sum + c);
/// assert!((chirp.value(0.7 + 0.5 * 0.25) - sum).abs() < 1e-14);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a signal: its Taylor series is not known",
    note = "signals are `Constant`, `Polynomial`, `Sinusoid`, `Sum`s of them, and types that implement `Signal`; a \
            closure as an input is a control law, `feedback`, which `Dop853` integrates"
)]
pub trait Signal<S: Scalar = f64> {
    /// Adds the Taylor coefficients of order 0, 1, … about a time, in the given unit of time, to `coefficients`: s(t +
    /// τ·unit) = Σ sₖ τᵏ. There are at most 2·`HALF` coefficients.
    fn add_series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [S]);

    /// Returns s(t).
    fn value(&self, t: S) -> S {
        let mut value = [S::zero()];
        self.add_series::<1>(t, S::one(), &mut value);
        value[0]
    }
}

/// A constant signal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant(pub f64);

/// The polynomial Σ cᵢ tⁱ with the given coefficients c₀, c₁, ….
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial<const K: usize>(pub [f64; K]);

/// The signal amplitude · sin(angular frequency · t + phase).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sinusoid {
    /// The amplitude, in the unit of the input.
    pub amplitude: f64,
    /// The angular frequency, in radians per unit of time.
    pub angular_frequency: f64,
    /// The angle at t = 0, in radians.
    pub phase: f64,
}

/// The sum of signals: an array of signals of one type, such as the harmonics of a periodic function, or a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum<T>(pub T);

impl Sinusoid {
    /// Creates the signal A sin(ω t) with amplitude A and angular frequency ω; its phase can be set as a field.
    #[must_use]
    pub const fn new(amplitude: f64, angular_frequency: f64) -> Self {
        Self {
            amplitude,
            angular_frequency,
            phase: 0.0,
        }
    }
}

impl<S: Scalar> Signal<S> for Constant {
    fn add_series<const HALF: usize>(&self, _: S, _: S, coefficients: &mut [S]) {
        if let Some(first) = coefficients.first_mut() {
            *first += S::from_f64(self.0);
        }
    }
}

impl<S: Scalar, const K: usize> Signal<S> for Polynomial<K> {
    fn add_series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [S]) {
        // Repeated division by the linear factor: Horner's scheme.
        let mut quotient = self.0.map(S::from_f64);
        let mut power = S::one();
        for (order, coefficient) in coefficients.iter_mut().enumerate().take(K) {
            let mut remainder = S::zero();
            for c in quotient[order..].iter_mut().rev() {
                remainder = remainder.mul_add(t, *c);
                *c = remainder;
            }
            *coefficient += remainder * power;
            power *= unit;
        }
    }
}

impl<S: Scalar> Signal<S> for Sinusoid {
    fn add_series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [S]) {
        let rate = S::from_f64(self.angular_frequency);
        let angle = rate.mul_add(t, S::from_f64(self.phase));
        let (sine, cosine) = angle.sin_cos();
        let amplitude = S::from_f64(self.amplitude);
        // The derivatives s⁽ᵏ⁾ are in turn s, s shifted by a quarter period, and their opposites.
        let (mut here, mut next) = (amplitude * sine, amplitude * cosine);
        let mut order = S::zero();
        for coefficient in coefficients {
            *coefficient += here;
            order += S::one();
            let step = rate * unit / order;
            let after = -here;
            here = next * step;
            next = after * step;
        }
    }
}

impl<S: Scalar, G: Signal<S>, const K: usize> Signal<S> for Sum<[G; K]> {
    fn add_series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [S]) {
        for signal in &self.0 {
            signal.add_series::<HALF>(t, unit, coefficients);
        }
    }
}

impl<S: Scalar, A: Signal<S>, B: Signal<S>> Signal<S> for Sum<(A, B)> {
    fn add_series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [S]) {
        self.0.0.add_series::<HALF>(t, unit, coefficients);
        self.0.1.add_series::<HALF>(t, unit, coefficients);
    }
}

impl<S: Scalar, G: Signal<S> + ?Sized> Signal<S> for &G {
    fn add_series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [S]) {
        (**self).add_series::<HALF>(t, unit, coefficients);
    }
}

/// The `U` inputs of a model as functions of time: an array of [`Signal`]s, or a tuple of up to six.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a signal for each of the {U} inputs",
    note = "inputs are driven by an array of signals, `[push]`, or a tuple of different ones, `(push, Constant(1.0))`; \
            a closure is a control law, `feedback(|x| …)`, which `Dop853` integrates"
)]
pub trait Signals<S: Scalar, const U: usize> {
    /// Returns u(t).
    fn values(&self, t: S) -> SVector<S, U>;

    /// Sets the Taylor coefficients u₀, u₁, … about a time, in the given unit of time. There are at most 2·`HALF`
    /// coefficients.
    fn series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [SVector<S, U>]);
}

impl<S: Scalar, G: Signal<S>, const U: usize> Signals<S, U> for [G; U] {
    fn values(&self, t: S) -> SVector<S, U> {
        SVector::from_fn(|i, _| self[i].value(t))
    }

    fn series<const HALF: usize>(&self, t: S, unit: S, coefficients: &mut [SVector<S, U>]) {
        for (input, signal) in self.iter().enumerate() {
            set_input::<_, _, U, HALF>(signal, (t, unit), input, coefficients);
        }
    }
}

macro_rules! tuples {
    ($($u:literal: $($signal:ident $index:tt),*;)*) => {$(
        impl<S: Scalar, $($signal: Signal<S>),*> Signals<S, $u> for ($($signal,)*) {
            fn values(&self, t: S) -> SVector<S, $u> {
                SVector::from([$(self.$index.value(t)),*])
            }

            fn series<const HALF: usize>(
                &self,
                t: S,
                unit: S,
                coefficients: &mut [SVector<S, $u>],
            ) {
                $(set_input::<_, _, $u, HALF>(&self.$index, (t, unit), $index, coefficients);)*
            }
        }
    )*};
}

tuples! {
    1: A 0;
    2: A 0, B 1;
    3: A 0, B 1, C 2;
    4: A 0, B 1, C 2, D 3;
    5: A 0, B 1, C 2, D 3, E 4;
    6: A 0, B 1, C 2, D 3, E 4, F 5;
}

/// Sets the coefficients of one input.
fn set_input<S: Scalar, G: Signal<S>, const U: usize, const HALF: usize>(
    signal: &G,
    (t, unit): (S, S),
    input: usize,
    coefficients: &mut [SVector<S, U>],
) {
    let mut series = [[S::zero(); 2]; HALF];
    let series = series.as_flattened_mut();
    let count = coefficients.len().min(series.len());
    signal.add_series::<HALF>(t, unit, &mut series[..count]);
    for (coefficient, term) in coefficients.iter_mut().zip(series) {
        coefficient[input] = *term;
    }
}
