//! Samples against their definitions.

#![allow(clippy::float_cmp, clippy::float_cmp_const)] // The same numbers.

use std::collections::HashSet;

use lagrangian::nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use lagrangian_ensembles::statrs::distribution::{ContinuousCDF, Gamma};
use lagrangian_ensembles::{Axis, Column, Grid, Parameter, Points, Sample};

fn unit(name: &str) -> Parameter {
    Parameter::uniform(name, 0.0, 1.0)
}

fn points<const D: usize>(sample: &Sample<D>) -> Vec<[f64; D]> {
    sample.check().unwrap();
    (0..sample.count())
        .map(|index| sample.point(index))
        .collect()
}

/// The part of `count` equal ones in which a number is.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss
)]
fn part(number: f64, count: usize) -> usize {
    assert!(0.0 < number && number < 1.0, "{number}");
    (number * count as f64) as usize
}

#[test]
fn a_latin_hypercube_has_one_value_in_each_part() {
    let sample = Sample::new(1000, [unit("a"), unit("b"), unit("c")])
        .latin_hypercube()
        .seed(3);
    let points = points(&sample);
    for axis in 0..3 {
        let parts: HashSet<usize> = points.iter().map(|point| part(point[axis], 1000)).collect();
        assert_eq!(parts.len(), 1000);
    }
    // The axes are shuffled apart, and values are not in the middles of their parts.
    let equal = points
        .iter()
        .filter(|point| part(point[0], 1000) == part(point[1], 1000));
    assert!(equal.count() < 20);
    let middles = points
        .iter()
        .filter(|point| ((point[0] * 1000.0).fract() - 0.5).abs() < 0.05);
    assert!(middles.count() < 200);
}

/// The first two axes of Sobol's sequence are a (0, 2)-sequence in base 2 (Niederreiter 1992, section 4.1): of 2ᵐ members,
/// each interval of the area 2⁻ᵐ contains one. Digital shifts keep this.
#[test]
fn a_sobol_sequence_has_one_member_in_each_elementary_interval() {
    for seed in 0..4 {
        let sample = Sample::new(1 << 10, [unit("a"), unit("b")])
            .sobol()
            .seed(seed);
        let points = points(&sample);
        for digits in 0..=10 {
            let intervals: HashSet<(usize, usize)> = points
                .iter()
                .map(|[a, b]| (part(*a, 1 << digits), part(*b, 1 << (10 - digits))))
                .collect();
            assert_eq!(intervals.len(), 1 << 10, "seed {seed}, {digits} digits");
        }
    }
}

/// All axes up to the last one are stratified, and no two are alike.
#[test]
fn axes_of_high_dimensions_are_stratified() {
    let axes: [Parameter; 200] = std::array::from_fn(|axis| unit(&format!("a{axis}")));
    let points = points(&Sample::new(256, axes).sobol());
    let columns: HashSet<Vec<u64>> = (0..200)
        .map(|axis| {
            let parts: HashSet<usize> = points.iter().map(|point| part(point[axis], 256)).collect();
            assert_eq!(parts.len(), 256, "axis {axis}");
            points
                .iter()
                .map(|point| (point[axis] * 1e9).to_bits())
                .collect()
        })
        .collect();
    assert_eq!(columns.len(), 200);
}

/// The digits of a number of Sobol's sequence.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn digits(number: f64) -> u64 {
    (number * 2.0_f64.powi(52)) as u64
}

/// Without the digital shift, which is member 0, the sequence is by the direction numbers of Joe and Kuo, in the order of Antonov
/// and Saleev. The expected values are `scipy.stats.qmc.Sobol(5, scramble=False, bits=52).random(1024)` of `SciPy` 1.17.1,
/// members 0 to 7, 1000 and 1023. The first three columns are also in the output of `sobol.cc`, which Joe and Kuo publish with their direction numbers.
#[test]
fn a_sobol_sequence_has_the_numbers_of_joe_and_kuo() {
    let expected = [
        (0, [0.0, 0.0, 0.0, 0.0, 0.0]),
        (1, [0.5, 0.5, 0.5, 0.5, 0.5]),
        (2, [0.75, 0.25, 0.25, 0.25, 0.75]),
        (3, [0.25, 0.75, 0.75, 0.75, 0.25]),
        (4, [0.375, 0.375, 0.625, 0.875, 0.375]),
        (5, [0.875, 0.875, 0.125, 0.375, 0.875]),
        (6, [0.625, 0.125, 0.875, 0.625, 0.625]),
        (7, [0.125, 0.625, 0.375, 0.125, 0.125]),
        (
            1000,
            [
                0.219_726_562_5,
                0.096_679_687_5,
                0.518_554_687_5,
                0.676_757_812_5,
                0.280_273_437_5,
            ],
        ),
        (
            1023,
            [
                0.000_976_562_5,
                0.752_929_687_5,
                0.612_304_687_5,
                0.145_507_812_5,
                0.186_523_437_5,
            ],
        ),
    ];
    let sample = Sample::new(1024, ["a", "b", "c", "d", "e"].map(unit))
        .sobol()
        .seed(5);
    let shift = sample.point(0).map(digits);
    assert!(shift.iter().all(|digits| *digits != 0));
    for (member, expected) in expected {
        let found = sample.point(member).map(digits);
        let found: [u64; 5] = std::array::from_fn(|axis| found[axis] ^ shift[axis]);
        assert_eq!(found, expected.map(digits), "member {member}");
    }
}

/// Without the shift, the sequence is `scipy.stats.qmc.Halton(3, scramble=False).random(9)` of `SciPy` 1.17.1, from
/// the second one: its first is zero.
#[test]
#[allow(clippy::unreadable_literal)] // As they are printed.
fn a_halton_sequence_has_the_numbers_of_another_implementation() {
    let expected = [
        [0.5, 0.3333333333333333, 0.2],
        [0.25, 0.6666666666666666, 0.4],
        [0.75, 0.1111111111111111, 0.6000000000000001],
        [0.125, 0.4444444444444444, 0.8],
        [0.625, 0.7777777777777777, 0.04],
        [0.375, 0.2222222222222222, 0.24000000000000002],
        [0.875, 0.5555555555555556, 0.44],
        [0.0625, 0.8888888888888888, 0.6400000000000001],
    ];
    let sample = Sample::new(8, ["a", "b", "c"].map(unit)).halton().seed(5);
    let points = points(&sample);
    for (point, numbers) in points.iter().zip(&expected) {
        for axis in 0..3 {
            let found = point[axis] - points[0][axis];
            let difference = found - (numbers[axis] - expected[0][axis]);
            assert!((difference - difference.round()).abs() < 1e-15, "{point:?}");
        }
    }
}

/// Differences of members are differences of radical inverses, modulo 1.
#[test]
fn a_halton_sequence_is_shifted_radical_inverses() {
    let sample = Sample::new(100, [unit("a"), unit("b"), unit("c")])
        .halton()
        .seed(5);
    let points = points(&sample);
    let inverse = |mut index: u32, base: u32| {
        let (mut inverse, mut weight) = (0.0, 1.0);
        while index > 0 {
            weight /= f64::from(base);
            inverse += f64::from(index % base) * weight;
            index /= base;
        }
        inverse
    };
    for (axis, base) in [2, 3, 5].into_iter().enumerate() {
        for index in 1..100_u32 {
            let found = points[index as usize][axis] - points[0][axis];
            let expected: f64 = inverse(index + 1, base) - inverse(1, base);
            let difference = found - expected;
            assert!(
                (difference - difference.round()).abs() < 1e-13,
                "member {index}, base {base}"
            );
        }
    }
}

#[test]
fn members_depend_on_seed_and_index_alone() {
    for design in [|s: Sample<2>| s, Sample::sobol, Sample::halton] {
        let sample = |count, seed| design(Sample::new(count, [unit("a"), unit("b")])).seed(seed);
        assert_eq!(
            sample(20_000, 1).point(12_345),
            sample(13_000, 1).point(12_345)
        );
        assert_ne!(sample(100, 1).point(50), sample(100, 2).point(50));
        // Setters commute.
        let other = design(Sample::new(100, [unit("a"), unit("b")]).seed(7));
        assert_eq!(sample(100, 7).point(3), other.point(3));
    }
}

/// A study of last year can be repeated.
#[test]
fn values_stay_as_they_are() {
    let sample = Sample::new(3, [unit("a"), unit("b")]).seed(1);
    let expected = [
        [0.402_485_663_664_848_06, 0.080_383_708_929_781_97],
        [0.851_912_160_844_185_2, 0.050_913_366_002_028_115],
        [0.876_394_122_505_368_7, 0.682_740_861_531_275_9],
    ];
    assert_eq!(points(&sample), expected);
    let expected = [
        [0.800_828_554_554_949_3, 0.360_127_902_976_593_97],
        [0.283_970_720_281_395_1, 0.683_637_788_667_342_7],
        [0.625_464_707_501_789_6, 0.227_580_287_177_091_97],
    ];
    assert_eq!(points(&sample.clone().latin_hypercube()), expected);
    let expected = [
        [0.371_529_862_961_158_2, 0.931_656_328_884_557_5],
        [0.871_529_862_961_158_2, 0.431_656_328_884_557_5],
        [0.621_529_862_961_158_2, 0.681_656_328_884_557_5],
    ];
    assert_eq!(points(&sample.clone().sobol()), expected);
    let expected = [
        [0.871_529_862_961_158_2, 0.264_989_662_217_890_9],
        [0.621_529_862_961_158_2, 0.598_322_995_551_224_1],
        [0.121_529_862_961_158_31, 0.042_767_439_995_668_566],
    ];
    assert_eq!(points(&sample.halton()), expected);
    let normal = Sample::new(3, [Parameter::normal("a", 1.0, 2.0)]).seed(1);
    let expected = [
        [0.506_163_074_203_195_4],
        [3.089_339_292_517_687_2],
        [3.314_296_703_160_296],
    ];
    assert_eq!(points(&normal), expected);
}

#[test]
#[allow(clippy::cast_precision_loss)]
fn a_multivariate_normal_sample_has_its_covariance() {
    let covariance = Matrix3::new(4.0, 1.0, -2.0, 1.0, 9.0, 0.5, -2.0, 0.5, 2.0);
    let mean = Vector3::new(1.0, -2.0, 1e3);
    let columns = ["a", "b", "c"].map(Column::new);
    let sample = Sample::multivariate_normal(1 << 14, columns, mean, covariance).sobol();
    let points: Vec<Vector3<f64>> = points(&sample).into_iter().map(Vector3::from).collect();
    let n = points.len() as f64;
    let center = points.iter().sum::<Vector3<f64>>() / n;
    let found = points
        .iter()
        .map(|x| (x - center) * (x - center).transpose());
    let found: Matrix3<f64> = found.sum::<Matrix3<f64>>() / n;
    assert!((center - mean).amax() < 1e-3, "{center}");
    assert!((found - covariance).amax() < 2e-2, "{found}");
}

/// A Gaussian copula keeps the distributions of the parameters.
#[test]
#[allow(clippy::cast_precision_loss)]
fn correlated_parameters_keep_their_distributions() {
    let gamma = Gamma::new(2.0, 3.0).unwrap();
    let parameters = [
        Parameter::distributed("a", gamma),
        Parameter::uniform("b", 2.0, 4.0),
    ];
    let correlation = SMatrix::<f64, 2, 2>::new(1.0, 0.8, 0.8, 1.0);
    let sample = Sample::new(4096, parameters)
        .sobol()
        .correlated(correlation);
    let points = points(&sample);
    for probability in [0.1, 0.5, 0.9] {
        let (a, b) = (gamma.inverse_cdf(probability), 2.0 + 2.0 * probability);
        let below = points.iter().fold(SVector::from([0.0, 0.0]), |sum, point| {
            sum + SVector::from([f64::from(point[0] < a), f64::from(point[1] < b)])
        });
        let error = (below / 4096.0).add_scalar(-probability).amax();
        assert!(error < 3e-3, "{probability}: {error}");
    }
    let product = |point: &[f64; 2]| (point[0] - 2.0 / 3.0) * (point[1] - 3.0);
    let covariance = points.iter().map(product).sum::<f64>() / 4096.0;
    assert!(covariance > 0.15, "{covariance}");
}

/// Quantiles against `scipy.special.ndtri` of `SciPy` 1.17.1, in each part of the approximation.
#[test]
#[allow(clippy::unreadable_literal)] // As they are printed.
fn normal_quantiles() {
    let parameter = Parameter::normal("a", 0.0, 2.0);
    for (probability, score) in [
        (0.5, 0.0),
        (0.3, -0.5244005127080409),
        (0.975, 1.959963984540054),
        (0.001, -3.090232306167813),
        (1e-10, -6.361340902404056),
        (f64::EPSILON / 2.0, -8.209536151601387),
        (1.0 - f64::EPSILON / 2.0, 8.209536151601387),
        (1e-300, -37.0470962993612),
    ] {
        let found = parameter.quantile(probability);
        let error = found - 2.0 * score;
        assert!(error.abs() <= 1e-15 * found.abs(), "{probability}: {error}");
    }
    assert_eq!(parameter.quantile(0.0), f64::NEG_INFINITY);
    assert_eq!(parameter.quantile(1.0), f64::INFINITY);
}

#[test]
fn grids_end_at_their_ends() {
    let grid = Grid::new([
        Axis::linear("a", -0.3, 0.7, 11),
        Axis::logarithmic("b", 1e-3, 1e3, 7),
        Axis::listed("c", [5.0, 4.0]),
    ]);
    assert_eq!(grid.count(), 154);
    assert_eq!(grid.point(0), [-0.3, 1e-3, 5.0]);
    assert_eq!(grid.point(153), [0.7, 1e3, 4.0]);
    assert_eq!(grid.point(1), [-0.3, 1e-3, 4.0]);
    let middle = grid.point(2 * (7 * 5 + 3));
    assert!((middle[0] - 0.2).abs() < 1e-16 && (middle[1] - 1.0).abs() < 1e-15);
    assert_eq!(Grid::new([Axis::linear("a", 2.0, 3.0, 1)]).point(0), [2.0]);
}
