//! Tables as text.
#![cfg(feature = "csv")]

use std::fs;

use lagrangian::prelude::*;
use lagrangian_ensembles::{Axis, Column, Grid, Study};
use lagrangian_models::SimplePendulum;
use tempfile::TempDir;

const PENDULUM: SimplePendulum = SimplePendulum {
    m: 1.0,
    l: 1.0,
    g: 9.81,
};

#[test]
fn tables_as_text() {
    let starts = Grid::new([Axis::listed("theta", [0.5, f64::NAN]).unit("rad")]);
    let problem = |[theta]: [f64; 1]| Problem::new(PENDULUM, State::new(0.0, [theta], [0.0]));
    let study = Study::new(starts, problem, 0.0, Taylor::new());
    let column = Column::new("end, of all").unit("rad");
    let table = study.table([column], |motion| [motion.q[0]]).unwrap();
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.csv");
    table.write_csv(&path).unwrap();
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some("member,theta [rad],\"end, of all [rad]\",error")
    );
    assert_eq!(lines.next(), Some("0,0.5,0.5,"));
    assert!(
        lines
            .next()
            .unwrap()
            .starts_with("1,,,member 1 (theta = NaN rad): "),
        "{text}"
    );
    assert_eq!(lines.next(), None);
}
