//! Horner's rule for a polynomial and its derivative.

use crate::scalar::Scalar;

/// Returns p(τ) − p(0) and dp/dτ, for pairs of coefficients of odd and even order from order 1 on; `plus` returns x + τ y.
///
/// The coefficients of odd and of even order are summed in turn, so that neither has to wait for the other (Knuth, *The Art of
/// Computer Programming* 2, 3rd edition 1997, section 4.6.4): with p(τ) − p(0) = τ A(τ²) + τ² B(τ²),
/// dp/dτ = A + 2 τ B + 2 τ² (A′ + τ B′).
#[inline]
pub(crate) fn change_and_derivative<'a, S: Scalar, T: Clone + 'a>(
    pairs: impl DoubleEndedIterator<Item = [&'a T; 2]>,
    tau: S,
    zero: T,
    plus: impl Fn(&T, S, &T) -> T,
) -> [T; 2] {
    let square = tau * tau;
    let mut pairs = pairs.rev();
    let [mut odd, mut even] = match pairs.next() {
        Some(last) => last.map(T::clone),
        None => [zero.clone(), zero.clone()],
    };
    let mut slopes = [zero.clone(), zero.clone()];
    for [first, second] in pairs {
        slopes = [
            plus(&odd, square, &slopes[0]),
            plus(&even, square, &slopes[1]),
        ];
        odd = plus(first, square, &odd);
        even = plus(second, square, &even);
    }
    let change = plus(&zero, tau, &plus(&odd, tau, &even));
    let [of_odd, of_even] = slopes;
    let slope = plus(&odd, tau + tau, &even);
    let higher = plus(&of_odd, tau, &of_even);
    [change, plus(&slope, square + square, &higher)]
}
