//! Mistakes: what they say.

use std::ops::ControlFlow;

use lagrangian::IntegrationError;
use lagrangian::nalgebra::SMatrix;
use lagrangian::prelude::*;
use lagrangian_ensembles::{Axis, Column, Grid, Parameter, Points, Sample, Shard, Study};

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = 0.5 * m * x.powi(2))]
struct Spring {
    m: f64,
}

fn start(x: f64) -> Problem<f64, impl Dynamics<State = Phase<f64, 1>> + lagrangian::InLanes<4>> {
    Problem::new(Spring { m: 1.0 }, State::new(0.0, [x], [0.0]))
}

/// Returns the message of a study of these points.
fn complaint<P: Points<Point = [f64; D]>, const D: usize>(points: P) -> String {
    let study = Study::new(
        points,
        |point: [f64; D]| start(point[0]),
        1.0,
        Taylor::new(),
    );
    study
        .summary(["end"], |motion| [motion.q[0]])
        .unwrap_err()
        .to_string()
}

#[test]
fn studies_without_members() {
    assert_eq!(
        complaint(Vec::<[f64; 1]>::new()),
        "the study has no members"
    );
    assert_eq!(
        complaint(Grid::new([Axis::linear("a", 0.0, 1.0, 0)])),
        "the study has no members"
    );
    assert_eq!(
        complaint(Sample::new(0, [Parameter::uniform("a", 0.0, 1.0)])),
        "the study has no members"
    );
}

#[test]
fn meaningless_points() {
    let expected = "the bounds of `a` are 1 and 0; they have to be finite, the lower one first";
    assert_eq!(
        complaint(Sample::new(9, [Parameter::uniform("a", 1.0, 0.0)])),
        expected
    );
    let expected = "the mean of `a` is NaN and its standard deviation 1; both have to be finite, and the deviation not negative";
    assert_eq!(
        complaint(Sample::new(9, [Parameter::normal("a", f64::NAN, 1.0)])),
        expected
    );
    let expected =
        "the ends of the axis `a` have to be finite, on a logarithmic axis also positive";
    assert_eq!(
        complaint(Grid::new([Axis::logarithmic("a", 0.0, 1.0, 3)])),
        expected
    );
    let axes: [Parameter; 60] =
        std::array::from_fn(|axis| Parameter::uniform(format!("a{axis}"), 0.0, 1.0));
    let expected = "a Halton sequence has at most 54 parameters, not 60; use a Latin hypercube";
    assert_eq!(complaint(Sample::new(9, axes).halton()), expected);
    let expected = "a correlation matrix has to be symmetric and positive definite with ones on its diagonal, a covariance matrix \
                    symmetric and positive definite";
    for matrix in [
        [1.0, 2.0, 2.0, 1.0],
        [1.0, 0.1, 0.2, 1.0],
        [2.0, 0.1, 0.1, 1.0],
        [f64::NAN; 4],
    ] {
        let parameters = ["a", "b"].map(|name| Parameter::normal(name, 0.0, 1.0));
        let sample = Sample::new(9, parameters).correlated(SMatrix::from_column_slice(&matrix));
        assert_eq!(complaint(sample), expected, "{matrix:?}");
    }
}

/// Without a study, values of invalid samples are NaN.
#[test]
fn points_of_invalid_samples() {
    let axes: [Parameter; 60] =
        std::array::from_fn(|axis| Parameter::normal(format!("a{axis}"), 0.0, 1.0));
    assert!(Sample::new(9, axes).halton().point(0)[59].is_nan());
    let parameter = Parameter::normal("a", 0.0, 1.0);
    assert!(parameter.quantile(1.5).is_nan() && parameter.quantile(f64::NAN).is_nan());
    let axes = ["a", "b", "c"].map(|name| Axis::linear(name, 0.0, 1.0, usize::MAX / 2));
    assert_eq!(
        complaint(Grid::new(axes)),
        "the grid has more points than can be counted"
    );
}

#[test]
fn columns_that_cannot_be_told_apart() {
    let grid = Grid::new([Axis::linear("a", 0.0, 1.0, 3)]);
    let study = Study::new(grid, |[a]| start(a), 1.0, Taylor::new());
    let complaint = |name: &str| {
        study
            .summary([name], |motion| [motion.t])
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        complaint("a"),
        "two columns are called `a`; parameters of the points are columns, too"
    );
    assert_eq!(
        complaint("member"),
        "a column cannot be called `member`: every table already has a column of this name"
    );
    assert_eq!(complaint(""), "each column needs a name");
    let column = Column::new("b").histogram(1.0, 1.0, 5);
    let complaint = study
        .summary([column], |motion| [motion.t])
        .unwrap_err()
        .to_string();
    assert_eq!(
        complaint,
        "the histogram of `b` needs finite bounds, the lower one first, and at least one bin"
    );
}

#[test]
fn keys_of_metadata() {
    let study = || Study::new(0..3, |_| start(1.0), 1.0, Taylor::new()).metadata("by", "us");
    let complaint = |key: &str| {
        let table = study()
            .metadata(key, "")
            .table(["end"], |motion| [motion.t]);
        table.unwrap_err().to_string()
    };
    for key in ["lagrangian", "members", "points", "units", "ARROW:schema"] {
        let expected =
            format!("the metadata cannot have the key `{key}`, which every file has already");
        assert_eq!(complaint(key), expected);
    }
    assert_eq!(complaint("by"), "the metadata have the key `by` twice");
}

#[test]
fn shards() {
    let complaint = |text: &str| text.parse::<Shard>().unwrap_err().to_string();
    assert_eq!(
        complaint("5/4"),
        "there is no shard 5/4: in k/n, k is from 1 to n"
    );
    assert_eq!(
        complaint("0/4"),
        "there is no shard 0/4: in k/n, k is from 1 to n"
    );
    for text in ["", "3", "a/4", "1/", "1/2/3", "-1/2"] {
        assert_eq!(
            complaint(text),
            format!("`{text}` is not a shard: write k/n, such as 2/4")
        );
    }
}

/// A member that fails is a value, and others are not affected.
#[test]
fn a_member_that_fails() {
    let points = Grid::new([Axis::listed("x", [0.5, f64::NAN, 1.5]).unit("m")]);
    let study = Study::new(points, |[x]| start(x), 1.0, Taylor::new());
    let motions = study.solve().unwrap();
    let failure = motions[1].as_ref().unwrap_err();
    assert_eq!((failure.index, failure.point[0].is_nan()), (1, true));
    assert!(
        matches!(failure.error(), IntegrationError::NonFiniteState { .. }),
        "{failure}"
    );
    assert!(
        failure.to_string().starts_with("member 1 (x = NaN m): "),
        "{failure}"
    );
    assert!((motions[2].as_ref().unwrap().q[0] - 1.5 * 1.0_f64.cos()).abs() < 1e-15);

    let table = study.table(["end"], |motion| [motion.q[0]]).unwrap();
    assert_eq!(table.members(), [0, 1, 2]);
    assert!(table.column("end").unwrap()[1].is_nan());
    assert_eq!(table.failures()[0].to_string(), failure.to_string());
    let summary = study.summary(["end"], |motion| [motion.q[0]]).unwrap();
    assert_eq!((summary.members(), summary.failures()), (3, 1));
    assert_eq!(summary.column("end").unwrap().missing(), 1);
    assert!(
        summary
            .to_string()
            .starts_with(&format!("3 members, 1 failed, the first: {failure}\n")),
        "{summary}"
    );
}

/// What an observer cancels keeps what has ended.
#[test]
fn cancelled_studies() {
    for threads in [1, 3] {
        let mut seen = Vec::new();
        let motions = {
            let study = Study::new(0..10_000, |_| start(1.0), 1.0, Taylor::new());
            let study = study.threads(threads).chunk(10).each_member(|progress| {
                assert_eq!(progress.members, 10_000);
                seen.push(progress.ended);
                if progress.ended >= 100 {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            });
            study.solve().unwrap()
        };
        assert!(seen.iter().copied().eq(1..=seen.len()), "{seen:?}");
        assert_eq!(motions.len(), seen.len());
        assert!((100..200).contains(&motions.len()), "{}", motions.len());
    }
}

/// Only members that have begun take memory, not a whole chunk or all chunks.
#[test]
fn studies_of_more_members_than_fit_into_memory() {
    for chunk in [None, Some(usize::MAX), Some(1)] {
        let study = Study::new(0..usize::MAX, |_| start(1.0), 1.0, Taylor::new());
        let study = study.threads(2).each_member(|progress| {
            if progress.ended < 100 {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        let study = match chunk {
            Some(chunk) => study.chunk(chunk),
            None => study,
        };
        let table = study.table(["end"], |motion| [motion.q[0]]).unwrap();
        assert!((100..200).contains(&table.finished()), "{chunk:?}");
        let summary = study.summary(["end"], |motion| [motion.q[0]]).unwrap();
        assert!((100..200).contains(&summary.members()), "{chunk:?}");
    }
}

/// A panic in a function of the caller is the panic of the study, and does not wait for the other members.
#[test]
fn panics_end_the_study() {
    let count = std::sync::atomic::AtomicUsize::new(0);
    let problem = |index: usize| {
        count.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        assert!(index != 50, "of the caller");
        start(1.0)
    };
    let study = Study::new(0..50_000_000, problem, 1.0, Taylor::new()).threads(2);
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| study.solve()));
    let panic = panic.expect_err("a function of the caller panics");
    assert_eq!(panic.downcast_ref::<&str>(), Some(&"of the caller"));
    assert!(count.into_inner() < 25_000_000);
}
