//! Statistics against direct computations.

use lagrangian::prelude::*;
use lagrangian_ensembles::{Column, Study, Summary, Table};

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Mass {
    m: f64,
}

/// A study whose members rest at the given places.
fn at_rest<const N: usize>(
    rows: &[[f64; N]],
    columns: [Column; N],
    chunk: usize,
) -> (Table, Summary) {
    let problem = |_: [f64; N]| Problem::new(Mass { m: 1.0 }, State::new(0.0, [0.0], [0.0]));
    let study = Study::new(rows, problem, 1.0, Taylor::new())
        .chunk(chunk)
        .threads(2);
    let table = study.table(columns.clone(), |motion| motion.point).unwrap();
    let summary = study.summary(columns, |motion| motion.point).unwrap();
    (table, summary)
}

/// Two columns that are far from zero, correlated, and of other sizes.
#[allow(clippy::cast_precision_loss)]
fn rows(count: usize) -> Vec<[f64; 2]> {
    let spread = |index: usize, factor: f64| (index as f64 * factor).fract() - 0.5;
    (0..count)
        .map(|index| {
            let (a, b) = (
                spread(index, 0.618_033_988_7),
                spread(index, 0.414_213_562_3),
            );
            [1e9 + a, 1e-3 * (2.0 * a + b)]
        })
        .collect()
}

/// The mean and the covariances by two passes, in whole numbers of the smallest spacing where that is exact.
#[allow(clippy::cast_precision_loss)]
fn two_pass(rows: &[[f64; 2]]) -> ([f64; 2], [f64; 3]) {
    let n = rows.len() as f64;
    let shifted = rows.iter().map(|[a, b]| [a - 1e9, *b]);
    let [mut a, mut b] = shifted
        .clone()
        .fold([0.0; 2], |sum, row| [sum[0] + row[0], sum[1] + row[1]]);
    a /= n;
    b /= n;
    let products = shifted.fold([0.0; 3], |[aa, ab, bb], [x, y]| {
        let (x, y) = (x - a, y - b);
        [aa + x * x, ab + x * y, bb + y * y]
    });
    ([1e9 + a, b], products.map(|sum| sum / (n - 1.0)))
}

#[test]
fn moments_are_those_of_two_passes() {
    let rows = rows(3_000);
    let ([mean_a, mean_b], [aa, ab, bb]) = two_pass(&rows);
    for chunk in [64, 500, 20_000] {
        let (_, summary) = at_rest(&rows, [Column::new("a"), Column::new("b")], chunk);
        let [a, b] = ["a", "b"].map(|name| summary.column(name).unwrap());
        let near = |value: f64, expected: f64, tolerance: f64| {
            assert!(
                (value / expected - 1.0).abs() < tolerance,
                "{value} {expected} in chunks of {chunk}"
            );
        };
        near(a.mean(), mean_a, 1e-15);
        assert!((b.mean() - mean_b).abs() < 1e-17);
        near(a.variance(), aa, 1e-12);
        near(b.variance(), bb, 1e-12);
        near(summary.covariance("a", "b").unwrap(), ab, 1e-12);
        near(summary.covariance("b", "a").unwrap(), ab, 1e-12);
        near(summary.covariance("b", "b").unwrap(), bb, 1e-12);
        near(
            summary.correlation("a", "b").unwrap(),
            ab / (aa * bb).sqrt(),
            1e-12,
        );
        assert_eq!(a.count(), 3_000);
    }
}

#[test]
fn a_summary_is_the_same_for_any_number_of_threads() {
    let rows = rows(3000);
    let problem = |_: [f64; 2]| Problem::new(Mass { m: 1.0 }, State::new(0.0, [0.0], [0.0]));
    let summaries = [1, 2, 5].map(|threads| {
        let study = Study::new(&rows[..], problem, 1.0, Taylor::new()).threads(threads);
        let summary = study.summary(["a", "b"], |motion| motion.point).unwrap();
        let quantiles = (0..=100).map(|n| summary.column("a")?.quantile(f64::from(n) / 100.0));
        format!("{summary:?} {:?}", quantiles.collect::<Vec<_>>())
    });
    assert_eq!(summaries[0], summaries[1]);
    assert_eq!(summaries[0], summaries[2]);
}

#[test]
fn extremes_have_the_first_of_their_members() {
    let rows = [[2.0], [-1.0], [5.0], [-1.0], [5.0], [0.0]];
    for chunk in [1, 2, 6] {
        let (_, summary) = at_rest(&rows, [Column::new("a")], chunk);
        let a = summary.column("a").unwrap();
        assert_eq!(
            (a.min(), a.max()),
            (Some((-1.0, 1)), Some((5.0, 2))),
            "chunks of {chunk}"
        );
    }
}

#[test]
fn quantiles_are_near_their_ranks() {
    // Far from zero, skew, in no order; in chunks of which each contains other values.
    let value = |n: i32| 1e6 + (f64::from(n * 997 % 3000) / 3000.0).powi(4);
    let rows: Vec<[f64; 1]> = (0..3000).map(|n| [value(n)]).collect();
    for chunk in [64, 3000] {
        let (_, summary) = at_rest(&rows, [Column::new("a")], chunk);
        let a = summary.column("a").unwrap();
        for probability in [0.001, 0.01, 0.25, 0.5, 0.9, 0.999] {
            let found = a.quantile(probability).unwrap();
            // Of equal values, some are below.
            let part = |is_below: &dyn Fn(f64) -> bool| {
                let below = rows.iter().filter(|[value]| is_below(*value)).count();
                f64::from(u32::try_from(below).unwrap()) / 3000.0
            };
            let error =
                probability - probability.clamp(part(&|a| a < found), part(&|a| a <= found));
            assert!(error.abs() < 1e-3, "{probability}: {error:e}");
        }
        assert_eq!(a.quantile(0.0), a.min().map(|(value, _)| value));
        assert_eq!(a.quantile(1.0), a.max().map(|(value, _)| value));
        assert_eq!((a.quantile(1.5), a.quantile(f64::NAN)), (None, None));
    }
}

#[test]
fn missing_values_count_nowhere() {
    let rows = [[1.0, 10.0], [f64::NAN, 20.0], [3.0, f64::NAN], [5.0, 30.0]];
    let (table, summary) = at_rest(&rows, [Column::new("a"), Column::new("b")], 2);
    let [a, b] = ["a", "b"].map(|name| summary.column(name).unwrap());
    assert_eq!(
        (a.count(), a.missing(), a.mean(), a.variance()),
        (3, 1, 3.0, 4.0)
    );
    assert_eq!((b.count(), b.missing(), b.mean()), (3, 1, 20.0));
    // Of the rows without missing values: (1, 10) and (5, 30).
    assert_eq!(summary.covariance("a", "b"), Some(40.0));
    assert!(table.column("a").unwrap()[1].is_nan());
    assert!(summary.column("c").is_none() && summary.covariance("a", "c").is_none());
}

#[test]
fn few_values_have_no_variance() {
    for rows in [&[[f64::NAN]][..], &[[2.0]]] {
        let (_, summary) = at_rest(rows, [Column::new("a")], 2);
        let a = summary.column("a").unwrap();
        assert!(a.variance().is_nan() && a.standard_deviation().is_nan());
        assert!(summary.covariance("a", "a").unwrap().is_nan());
        assert_eq!(a.mean().is_nan(), rows[0][0].is_nan());
    }
}

#[test]
fn histograms_count_every_value_once() {
    let rows: Vec<[f64; 1]> = (0..1000).map(|n| [f64::from(n) / 100.0]).collect();
    let column = Column::new("a").histogram(2.0, 8.0, 12);
    let (_, summary) = at_rest(&rows, [column], 77);
    let histogram = summary.column("a").unwrap().histogram().unwrap();
    assert_eq!(histogram.edges()[..3], [2.0, 2.5, 3.0]);
    assert_eq!(histogram.below(), 200);
    // 8 itself is the upper edge.
    assert_eq!(histogram.above(), 199);
    assert_eq!(histogram.counts().iter().sum::<u64>(), 601);
    assert_eq!(histogram.counts()[11], 51);
}

#[test]
fn rows_of_samples_are_in_the_order_of_members_and_times() {
    let problem = |index: usize| {
        #[allow(clippy::cast_precision_loss)]
        let speed = index as f64;
        Problem::new(Mass { m: 1.0 }, State::new(0.0, [0.0], [speed])).save(Every(0.5))
    };
    let study = Study::new(0..100, problem, 1.0, Taylor::new())
        .chunk(9)
        .threads(2);
    let samples =
        |motion: &[State<f64, 1>]| motion.iter().map(|x| [x.t, x.q[0]]).collect::<Vec<_>>();
    let table = study
        .table(["t", "x"], |motion| samples(motion.samples()))
        .unwrap();
    assert_eq!(table.members().len(), 300);
    assert_eq!(table.members()[296..], [98, 99, 99, 99]);
    assert_eq!(table.column("t").unwrap()[..4], [0.0, 0.5, 1.0, 0.0]);
    assert_eq!(table.column("x").unwrap()[297..], [0.0, 49.5, 99.0]);
    assert_eq!(table.finished(), 100);
}
