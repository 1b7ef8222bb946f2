//! Constants with 106 or more bits, as sums of `f64`, and the ranges of the algorithms.

use super::DoubleDouble;

/// The number of decimal digits that are read; further digits are below the rounding error.
pub(super) const READ_DIGITS: u32 = 34;

/// The greatest power of ten in one multiplication, so that the power is far from overflow.
pub(super) const MAX_POWER_OF_TEN: i32 = 150;

/// Beyond this argument the hyperbolic tangent is ±1 to all digits, since 2 e⁻⁸⁰ is below 10⁻³⁴.
pub(super) const TANH_SATURATES: f64 = 40.0;

/// Beyond this argument the exponential is near the ends of the range of `f64`: multiplication by a power of two would
/// overflow, and at the lower end the low part has no digits.
pub(super) const EXP_RANGE: f64 = 700.0;

/// Beyond this argument the exponential is infinite.
pub(super) const EXP_OVERFLOWS: f64 = 710.0;

/// Beyond this argument, e to the rounded ln x may overflow.
pub(super) const LN_RANGE: f64 = 1e300;

/// Beyond this argument √(x² + 1) equals |x| to all digits.
pub(super) const ASINH_IS_LN: f64 = 1e40;

/// Beyond this argument of sine and cosine, the number of quarter turns is too long for an accurate reduction.
pub(super) const REDUCIBLE: f64 = 1e15;

/// Logarithms of 1 + x with |x| below this are computed by artanh, without cancellation.
pub(super) const NEAR_ONE: f64 = 0.25;

pub(super) const PI: DoubleDouble = DoubleDouble {
    high: core::f64::consts::PI,
    low: 1.224_646_799_147_353_2e-16,
};

/// π/2 in three parts.
pub(super) const HALF_PI: [f64; 3] = [
    core::f64::consts::FRAC_PI_2,
    6.123_233_995_736_766e-17,
    -1.497_384_904_859_169_8e-33,
];

/// ln 2 in three parts.
pub(super) const LN_2: [f64; 3] = [
    core::f64::consts::LN_2,
    2.319_046_813_846_299_6e-17,
    5.707_708_438_416_212e-34,
];

/// 1/i! for i from 0 on. At |x| = 1, the omitted terms of the series of the hyperbolic sine are below 2⁻¹¹⁶ of its
/// value.
pub(super) const INVERSE_FACTORIALS: [(f64, f64); 34] = [
    (1.0, 0.0),
    (1.0, 0.0),
    (0.5, 0.0),
    (0.166_666_666_666_666_66, 9.251_858_538_542_97e-18),
    (0.041_666_666_666_666_664, 2.312_964_634_635_742_7e-18),
    (0.008_333_333_333_333_333, 1.156_482_317_317_871_4e-19),
    (0.001_388_888_888_888_889, -5.300_543_954_373_577e-20),
    (0.000_198_412_698_412_698_4, 1.720_955_829_342_070_5e-22),
    (2.480_158_730_158_73e-5, 2.151_194_786_677_588_2e-23),
    (2.755_731_922_398_589_3e-6, -1.858_393_274_046_472e-22),
    (2.755_731_922_398_589e-7, 2.376_771_462_225_029_7e-23),
    (2.505_210_838_544_172e-8, -1.448_814_070_935_912e-24),
    (2.087_675_698_786_81e-9, -1.207_345_059_113_26e-25),
    (1.605_904_383_682_161_3e-10, 1.258_529_458_875_209_8e-26),
    (1.147_074_559_772_972_5e-11, 2.065_551_275_283_074_5e-28),
    (7.647_163_731_819_816e-13, 7.038_728_777_334_53e-30),
    (4.779_477_332_387_385e-14, 4.399_205_485_834_081e-31),
    (2.811_457_254_345_520_6e-15, 1.650_884_273_086_143_3e-31),
    (1.561_920_696_858_622_5e-16, 1.191_067_966_027_375_4e-32),
    (8.220_635_246_624_33e-18, 2.214_189_411_960_426_5e-34),
    (4.110_317_623_312_165e-19, 1.441_297_337_865_952_7e-36),
    (1.957_294_106_339_126_3e-20, -1.364_350_383_008_790_8e-36),
    (8.896_791_392_450_574e-22, -7.911_402_614_872_376e-38),
    (3.868_170_170_630_684e-23, -8.843_177_655_482_344e-40),
    (1.611_737_571_096_118_4e-24, -3.684_657_356_450_976_6e-41),
    (6.446_950_284_384_474e-26, -1.933_040_423_370_346_5e-42),
    (2.479_596_263_224_797_6e-27, -1.295_373_096_476_522_9e-43),
    (9.183_689_863_795_546e-29, 1.430_315_039_678_732_2e-45),
    (3.279_889_237_069_838e-30, 1.511_754_274_402_987_9e-46),
    (1.130_996_288_644_771_6e-31, 1.049_801_541_295_950_6e-47),
    (3.769_987_628_815_905_4e-33, 2.587_034_783_275_032_4e-49),
    (1.216_125_041_553_518e-34, 5.586_290_567_888_806e-51),
    (3.800_390_754_854_743_4e-36, 1.745_715_802_465_251_8e-52),
    (1.151_633_562_077_195e-37, -6.099_574_457_884_54e-54),
];
