//! Random numbers.

use lagrangian_tests::Random;
use nalgebra::SVector;

#[test]
fn numbers_fill_their_interval() {
    let mut random = Random::default();
    let numbers = SVector::from(random.array::<1000>(-1.0, 3.0));
    assert!(numbers.min() >= -1.0 && numbers.min() < -0.98, "{numbers}");
    assert!(numbers.max() <= 3.0 && numbers.max() > 2.98, "{numbers}");
    assert!((numbers.mean() - 1.0).abs() < 0.1, "{}", numbers.mean());
}
