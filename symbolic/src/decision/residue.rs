//! Arithmetic modulo two primes, for exact decisions at random points.
//!
//! p = 4q + 1 with both p and q prime. Modulo p there is a square root of −1, so that sine and cosine
//! of a phase z are (z − 1/z)/2i and (z + 1/z)/2. The fourth powers form a group of the prime order q,
//! so that phases can be divided by any integer.

/// The prime p = 4q + 1, below 2⁶¹.
pub(crate) const P: u64 = 2_305_843_009_213_691_357;
/// The prime q.
pub(crate) const Q: u64 = (P - 1) / 4;
/// A square root of −1 modulo p.
pub(crate) const I: u64 = 1_018_197_504_712_963_086;
/// A generator of the group of order q modulo p.
pub(crate) const GENERATOR: u64 = 16;

/// x + y modulo `modulus`.
pub(crate) const fn add(x: u64, y: u64, modulus: u64) -> u64 {
    (x + y) % modulus
}

/// −x modulo `modulus`.
pub(crate) const fn negate(x: u64, modulus: u64) -> u64 {
    (modulus - x) % modulus
}

/// x · y modulo `modulus`.
#[allow(clippy::cast_possible_truncation)] // The remainder is below the modulus.
pub(crate) const fn multiply(x: u64, y: u64, modulus: u64) -> u64 {
    (x as u128 * y as u128 % modulus as u128) as u64
}

/// x to the power of k modulo `modulus`.
pub(crate) const fn power(mut x: u64, mut k: u64, modulus: u64) -> u64 {
    let mut result = 1;
    while k > 0 {
        if k & 1 == 1 {
            result = multiply(result, x, modulus);
        }
        x = multiply(x, x, modulus);
        k >>= 1;
    }
    result
}

/// 1/x modulo the prime `modulus`, or `None` of zero.
pub(crate) fn reciprocal(x: u64, modulus: u64) -> Option<u64> {
    (x != 0).then(|| power(x, modulus - 2, modulus))
}

/// The Legendre symbol of x modulo p: 0, 1 for a square, p − 1 for any other.
pub(crate) const fn legendre(x: u64) -> u64 {
    power(x, P / 2, P)
}

/// A square root of x modulo p, if there is one.
pub(crate) fn square_root(x: u64) -> Option<u64> {
    if legendre(x) == P - 1 {
        return None;
    }
    // p − 1 = 4q with q odd: x^((q+1)/2) is a root but for a fourth root of one.
    let root = power(x, Q.div_ceil(2), P);
    [1, I]
        .into_iter()
        .map(|unit| multiply(root, unit, P))
        .find(|root| multiply(*root, *root, P) == x)
}

/// A number that looks random, from two others.
pub(crate) const fn mix(seed: u64, value: u64) -> u64 {
    let mut z = seed ^ value.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_have_their_orders() {
        assert_eq!(multiply(I, I, P), P - 1);
        assert_ne!(GENERATOR, 1);
        assert_eq!(power(GENERATOR, Q, P), 1);
        // Fermat's test to several bases.
        for base in [2, 3, 5, 7, 11, 13] {
            assert_eq!(power(base, P - 1, P), 1);
            assert_eq!(power(base, Q - 1, Q), 1);
        }
    }

    #[test]
    fn square_roots_square_back() {
        let mut roots = 0;
        for x in (0..200).map(|k| mix(1, k) % P) {
            match square_root(x) {
                Some(root) => {
                    assert_eq!(multiply(root, root, P), x);
                    roots += 1;
                }
                None => assert_eq!(legendre(x), P - 1),
            }
        }
        assert!(
            (60..140).contains(&roots),
            "half of all numbers are squares: {roots} of 200"
        );
    }

    #[test]
    fn reciprocals_invert() {
        assert_eq!(reciprocal(0, P), None);
        for x in 1..50 {
            assert_eq!(reciprocal(x, Q).map(|y| multiply(x, y, Q)), Some(1));
        }
    }
}
