//! Arithmetic modulo primes (Knuth, The Art of Computer Programming, volume 2, 3rd edition 1997, section 4.3.2).
//!
//! p = 840 q + 1 with both p and q prime. Modulo p there is a square root of −1, so that with
//! z = e^{ix} sine and cosine are (z − 1/z)/2i and (z + 1/z)/2; and 2, 3, 5 and 7 have square roots, by quadratic
//! reciprocity. The 840th powers form a group of the prime order q, so that logarithms can be divided by any
//! integer. Other numbers have a square root modulo half of the primes, which is why there are several.

/// A prime p = 840 q + 1 below 2⁶¹.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Field {
    /// The prime modulus of values.
    pub(crate) p: u64,
    /// The prime modulus of logarithms, the order of the group.
    pub(crate) q: u64,
    /// A primitive eighth root of one modulo p.
    zeta: u64,
    /// A generator of the group of order q.
    generator: u64,
}

/// Twenty-four of them: a number has a square root modulo half of the primes.
static FIELDS: [Field; 24] = [
    Field::new(2_251_799_813_684_857, 1_218_444_822_762_680_921),
    Field::new(2_251_799_813_684_789, 628_785_502_487_796_663),
    Field::new(2_251_799_813_684_783, 1_019_711_334_828_627_971),
    Field::new(2_251_799_813_684_621, 1_619_437_570_929_357_403),
    Field::new(2_251_799_813_684_467, 382_700_285_611_481_840),
    Field::new(2_251_799_813_684_459, 76_014_114_327_245_253),
    Field::new(2_251_799_813_684_321, 1_566_323_202_489_326_802),
    Field::new(2_251_799_813_683_951, 1_251_718_289_793_097_149),
    Field::new(2_251_799_813_683_907, 674_800_777_656_714_128),
    Field::new(2_251_799_813_682_623, 1_626_181_972_185_066_505),
    Field::new(2_251_799_813_682_247, 1_714_709_333_805_026_201),
    Field::new(2_251_799_813_682_103, 1_279_534_212_677_837_161),
    Field::new(2_251_799_813_681_573, 891_446_529_066_106_026),
    Field::new(2_251_799_813_681_321, 573_133_010_220_775_652),
    Field::new(2_251_799_813_681_137, 859_805_933_225_519_326),
    Field::new(2_251_799_813_680_639, 1_594_997_582_422_495_292),
    Field::new(2_251_799_813_680_621, 153_487_284_330_725_508),
    Field::new(2_251_799_813_680_427, 1_321_469_370_800_465_063),
    Field::new(2_251_799_813_680_171, 461_476_127_452_966_736),
    Field::new(2_251_799_813_680_103, 369_033_927_015_021_783),
    Field::new(2_251_799_813_680_013, 1_093_091_684_397_532_366),
    Field::new(2_251_799_813_679_751, 1_220_416_329_317_789_740),
    Field::new(2_251_799_813_679_337, 1_886_320_371_417_321_426),
    Field::new(2_251_799_813_678_957, 25_479_258_706_751_108),
];

impl Field {
    const fn new(q: u64, zeta: u64) -> Self {
        let p = 840 * q + 1;
        Self {
            p,
            q,
            zeta,
            generator: power(11, 840, p),
        }
    }

    /// One of the fields.
    #[allow(clippy::cast_possible_truncation)] // The remainder is below 24.
    pub(crate) fn of(seed: u64) -> Self {
        FIELDS[(seed % FIELDS.len() as u64) as usize]
    }

    /// A square root of −1.
    pub(crate) const fn imaginary_unit(self) -> u64 {
        multiply(self.zeta, self.zeta, self.p)
    }

    /// A generator of the group of order q.
    pub(crate) const fn generator(self) -> u64 {
        self.generator
    }

    /// A square root of x, if there is one (Tonelli and Shanks: Cohen, A Course in Computational Algebraic Number
    /// Theory, 1993, section 1.5.1).
    pub(crate) fn square_root(self, x: u64) -> Option<u64> {
        // p − 1 = 8m with m odd: x^((m+1)/2) is a root but for an eighth root of one.
        let mut root = power(x, (self.p / 8).div_ceil(2), self.p);
        for _ in 0..8 {
            if multiply(root, root, self.p) == x {
                return Some(root);
            }
            root = multiply(root, self.zeta, self.p);
        }
        None
    }
}

/// x + y modulo `modulus`, which is below 2⁶³, as both are below the modulus.
pub(crate) const fn add(x: u64, y: u64, modulus: u64) -> u64 {
    let sum = x.wrapping_add(y);
    if sum >= modulus {
        sum.wrapping_sub(modulus)
    } else {
        sum
    }
}

/// −x modulo `modulus`.
pub(crate) const fn negate(x: u64, modulus: u64) -> u64 {
    if x == 0 { 0 } else { modulus.wrapping_sub(x) }
}

/// x · y modulo `modulus`.
#[allow(clippy::cast_possible_truncation)] // The remainder is below the modulus.
pub(crate) const fn multiply(x: u64, y: u64, modulus: u64) -> u64 {
    ((x as u128).wrapping_mul(y as u128) % modulus as u128) as u64
}

/// x to the power of k modulo `modulus`, which is odd and below 2⁶³.
pub(crate) const fn power(x: u64, mut k: u64, modulus: u64) -> u64 {
    match k {
        0 => return 1,
        1 => return x,
        2 => return multiply(x, x, modulus),
        _ => {}
    }
    let montgomery = Montgomery::of(modulus);
    let mut result = montgomery.one;
    let mut x = multiply(x, montgomery.one, modulus);
    while k > 0 {
        if k & 1 == 1 {
            result = montgomery.multiply(result, x);
        }
        x = montgomery.multiply(x, x);
        k >>= 1;
    }
    montgomery.multiply(result, 1)
}

/// Multiplication without division (Montgomery, Modular multiplication without trial division, 1985): x stands for
/// x·2⁶⁴ modulo the modulus. Macros run without optimization, where a division of 128 bits is a slow call.
struct Montgomery {
    modulus: u64,
    /// −1/`modulus` modulo 2⁶⁴.
    negative_inverse: u64,
    /// What stands for 1.
    one: u64,
}

impl Montgomery {
    #[allow(clippy::cast_possible_truncation)] // The remainder is below the modulus.
    const fn of(modulus: u64) -> Self {
        // Newton's iteration doubles the bits that are right: an odd number is its own inverse modulo 8.
        let mut inverse = modulus;
        let mut bits = 3;
        while bits < 64 {
            let error = 2_u64.wrapping_sub(modulus.wrapping_mul(inverse));
            inverse = inverse.wrapping_mul(error);
            bits *= 2;
        }
        Self {
            modulus,
            negative_inverse: inverse.wrapping_neg(),
            one: ((1 << 64) % modulus as u128) as u64,
        }
    }

    /// x · y / 2⁶⁴ modulo the modulus.
    #[allow(clippy::cast_possible_truncation)] // Low words are meant.
    const fn multiply(&self, x: u64, y: u64) -> u64 {
        let product = (x as u128).wrapping_mul(y as u128);
        let factor = (product as u64).wrapping_mul(self.negative_inverse);
        let multiple = (factor as u128).wrapping_mul(self.modulus as u128);
        let quotient = (product.wrapping_add(multiple) >> 64) as u64;
        if quotient >= self.modulus {
            quotient.wrapping_sub(self.modulus)
        } else {
            quotient
        }
    }
}

/// 1/x modulo the prime `modulus`, or `None` of zero.
pub(crate) fn reciprocal(x: u64, modulus: u64) -> Option<u64> {
    match x {
        0 => None,
        1 => Some(1),
        2 => Some(modulus.div_ceil(2)),
        _ => Some(power(x, modulus - 2, modulus)),
    }
}

/// A pseudorandom number from two others: the mixing function of splitmix64 (Steele, Lea and Flood, Fast splittable
/// pseudorandom number generators, 2014).
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
        for field in FIELDS {
            let Field { p, q, zeta, .. } = field;
            assert_eq!(power(zeta, 4, p), p - 1);
            assert_eq!(power(field.imaginary_unit(), 2, p), p - 1);
            assert_ne!(field.generator(), 1);
            assert_eq!(power(field.generator(), q, p), 1);
            // Fermat's test to several bases.
            for base in [2, 3, 5, 7, 11, 13] {
                assert_eq!(power(base, p - 1, p), 1);
                assert_eq!(power(base, q - 1, q), 1);
            }
        }
    }

    #[test]
    fn square_roots_square_back() {
        for field in FIELDS {
            let mut roots = 0;
            for x in (0..100).map(|k| mix(1, k) % field.p) {
                match field.square_root(x) {
                    Some(root) => {
                        assert_eq!(multiply(root, root, field.p), x);
                        roots += 1;
                    }
                    // Euler's criterion.
                    None => assert_eq!(power(x, field.p / 2, field.p), field.p - 1),
                }
            }
            assert!(
                (25..75).contains(&roots),
                "half of all numbers are squares: {roots} of 100"
            );
        }
    }

    #[test]
    fn small_numbers_have_roots_in_some_fields() {
        for number in 2..40 {
            let roots = FIELDS
                .iter()
                .filter(|field| field.square_root(number).is_some())
                .count();
            assert!(roots >= 4, "{number} has a root in {roots} fields");
        }
    }

    #[test]
    fn reciprocals_invert() {
        let Field { p, q, .. } = Field::of(0);
        assert_eq!(reciprocal(0, p), None);
        for x in 1..50 {
            assert_eq!(reciprocal(x, q).map(|y| multiply(x, y, q)), Some(1));
        }
    }
}
