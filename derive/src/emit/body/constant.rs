//! Exact numbers as they are emitted.

use lagrangian_symbolic::Rational;
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use crate::syntax::scalar::Scalar;

/// The scalar nearest to an exact number.
pub(super) fn constant(scalar: &Scalar<'_>, number: &Rational) -> TokenStream {
    let functions = scalar.functions();
    if let Some((numerator, denominator)) = quotient(number) {
        let (numerator, denominator) = (signed(numerator), signed(denominator));
        return quote!(#functions::ratio(#numerator, #denominator));
    }
    let value = signed(number.to_f64());
    quote!(#functions::from_f64(#value))
}

/// Numerator and denominator of a number that `f64` does not have, if it has those.
#[allow(clippy::cast_precision_loss)] // They are exact.
fn quotient(number: &Rational) -> Option<(f64, f64)> {
    const EXACT: u64 = 1 << 53;
    let (numerator, denominator) = number.to_fraction()?;
    let exact = [numerator, denominator]
        .iter()
        .all(|part| part.unsigned_abs() <= EXACT);
    let dyadic = denominator.unsigned_abs().is_power_of_two();
    (exact && !dyadic).then_some((numerator as f64, denominator as f64))
}

/// The literal of a number, with its sign.
fn signed(value: f64) -> TokenStream {
    let magnitude = literal(value.abs());
    let sign = (value < 0.0).then(|| quote!(-));
    quote!(#sign #magnitude)
}

/// The shortest literal that reads back as `value`, which is not negative.
fn literal(value: f64) -> TokenStream {
    let written = format!("{value:?}");
    match written.parse::<Literal>() {
        Ok(literal) => literal.into_token_stream(),
        // Not a number, or infinite: there is no literal.
        Err(_) if value.is_nan() => quote!(::core::primitive::f64::NAN),
        Err(_) => quote!(::core::primitive::f64::INFINITY),
    }
}
