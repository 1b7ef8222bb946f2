//! Principal moments and axes of random tensors, degenerate ones included, against the tensors and nalgebra.

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{InertiaTensor, PrincipalAxes, ProductsOfInertia, Solid, Symmetry};
use lagrangian::{DoubleDouble, Dual};
use nalgebra::Rotation3;

type M = Matrix3<f64>;

/// `SplitMix64`: G. L. Steele, D. Lea & C. H. Flood, OOPSLA (2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let high = u32::try_from((z ^ (z >> 31)) >> 32).unwrap();
        f64::from(high) / f64::from(u32::MAX)
    }

    fn rotation(&mut self) -> Rotation3<f64> {
        let vector = Vector3::from_fn(|_, _| 2.0 * self.next() - 1.0);
        Rotation3::from_scaled_axis(vector * 4.0)
    }
}

/// Fails unless the axes are a proper rotation that makes the tensor diagonal, with ascending moments.
fn check(tensor: &InertiaTensor, principal: &PrincipalAxes) {
    let [first, _, third] = principal.moments;
    let size = first.abs().max(third.abs());
    let r = principal.axes.matrix();
    assert!(principal.moments.is_sorted());
    assert_close((r.transpose() * r - M::identity()).norm(), 0.0, 4e-15);
    assert_close(r.determinant(), 1.0, 4e-15);
    let rebuilt = r * M::from_diagonal(&principal.moments.into()) * r.transpose();
    let error = (rebuilt - tensor.matrix()).norm() / size;
    assert!(error < 1e-14, "{error:e}: {tensor:?}");
}

/// Principal moments of all kinds in turn: distinct, two equal, all equal, nearly equal, a rod, a plate.
fn moments(round: i32, random: &mut Random) -> [f64; 3] {
    let scale = 10.0_f64.powi(round % 25 - 12);
    let [a, b, c] = [(); 3].map(|()| scale * random.next());
    match round % 8 {
        0 | 1 => [a, b, c],
        2 => [a, a, b],
        3 => [a, b, b],
        4 => [a, a, a],
        5 => {
            let near = a * (1.0 + 1e-10 * (1.0 + random.next()));
            [a, near, 2.0 * a * b / scale]
        }
        6 => [0.0, b, b],
        _ => [a, b, a + b],
    }
}

/// The symmetry of these moments, ascending.
fn symmetry(round: i32, ascending: &[f64; 3]) -> Symmetry {
    let lower_are_equal = ascending[0].to_bits() == ascending[1].to_bits();
    match round % 8 {
        2 | 3 | 6 => Symmetry::Symmetric {
            axis: if lower_are_equal { 2 } else { 0 },
        },
        4 => Symmetry::Spherical,
        _ => Symmetry::Asymmetric,
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn a_hundred_thousand_tensors() {
    find_axes(100_000);
}

#[test]
fn eight_thousand_tensors() {
    find_axes(8_000);
}

/// Finds the principal axes of so many tensors, half of which have equal moments.
fn find_axes(count: i32) {
    let mut random = Random(7);
    let mut counts = [0; 3];
    for round in 0..count {
        let moments = moments(round, &mut random);
        let rotation = random.rotation();
        let tensor = InertiaTensor::principal(moments).rotated(&rotation);
        let principal = tensor.principal_axes();
        check(&tensor, &principal);
        let mut expected = moments;
        expected.sort_by(f64::total_cmp);
        let mut by_nalgebra = tensor.matrix().symmetric_eigenvalues();
        by_nalgebra.as_mut_slice().sort_by(f64::total_cmp);
        for k in 0..3 {
            assert_close(principal.moments[k], expected[k], 4e-15 * expected[2]);
            assert_close(principal.moments[k], by_nalgebra[k], 1e-14 * expected[2]);
        }
        let symmetry = symmetry(round, &expected);
        assert_eq!(principal.symmetry, symmetry, "{expected:?}");
        match symmetry {
            Symmetry::Asymmetric => counts[0] += 1,
            Symmetry::Spherical => counts[2] += 1,
            Symmetry::Symmetric { axis } => {
                counts[1] += 1;
                // The axis of symmetry is that of the body.
                let of_axis = |x: &f64| x.to_bits() == expected[axis].to_bits();
                let index = moments.iter().position(of_axis).unwrap();
                let of_body = rotation.matrix().column(index).into_owned();
                let found = principal.axes.matrix().column(axis).into_owned();
                let gap = (expected[axis] - expected[1]).abs() / expected[2];
                assert!(found.cross(&of_body).norm() * gap < 1e-14);
            }
        }
    }
    assert_eq!(counts, [count / 2, count / 8 * 3, count / 8]);
}

#[test]
fn axes_that_are_principal_keep_their_place() {
    let axes = |moments| {
        InertiaTensor::<f64>::principal(moments)
            .principal_axes()
            .axes
    };
    let columns = |order: [usize; 3], sign: f64| {
        let mut matrix = M::zeros();
        for (column, row) in order.into_iter().enumerate() {
            matrix[(row, column)] = if column == 2 { sign } else { 1.0 };
        }
        matrix
    };
    assert_eq!(*axes([1.0, 2.0, 3.0]).matrix(), M::identity());
    assert_eq!(*axes([2.0, 1.0, 3.0]).matrix(), columns([1, 0, 2], -1.0));
    assert_eq!(*axes([3.0, 1.0, 2.0]).matrix(), columns([1, 2, 0], 1.0));
    assert_eq!(*axes([1.0, 1.0, 3.0]).matrix(), M::identity());
    assert_eq!(*axes([2.0, 2.0, 1.0]).matrix(), columns([2, 0, 1], 1.0));
    assert_eq!(*axes([2.0, 1.0, 2.0]).matrix(), columns([1, 0, 2], -1.0));
    assert_eq!(*axes([1.0, 1.0, 1.0]).matrix(), M::identity());
    assert_eq!(*axes([0.0, 0.0, 0.0]).matrix(), M::identity());
}

#[test]
fn equal_moments_take_the_nearest_axes() {
    // A cylinder whose axis is tilted by 10° about x: the axis x stays a principal axis.
    let tilt = Rotation3::from_axis_angle(&Vector3::x_axis(), 10.0_f64.to_radians());
    let body = Solid::cylinder(0.5, 0.2).unwrap().with_mass(3.0).unwrap();
    let principal = body.turned(&tilt).principal_axes();
    assert_eq!(principal.symmetry, Symmetry::Symmetric { axis: 2 });
    assert_close((principal.axes.matrix() - tilt.matrix()).norm(), 0.0, 1e-14);
}

#[test]
fn double_doubles_have_all_digits() {
    let d = DoubleDouble::from_f64;
    let zero = d(0.0);
    let products = ProductsOfInertia {
        xy: d(1.0),
        xz: zero,
        yz: zero,
    };
    let tensor = InertiaTensor::from_moments_and_products([d(3.0), d(4.0), d(6.0)], products);
    let principal = tensor.principal_axes();
    // (7 ∓ √5)/2.
    let root = d(5.0).sqrt();
    for (found, expected) in [
        (principal.moments[0], d(7.0) - root),
        (principal.moments[1], d(7.0) + root),
    ] {
        assert!((found - expected * d(0.5)).abs().to_f64() < 1e-30);
    }
    let error = principal.tensor().matrix() - tensor.matrix();
    assert!(error.iter().all(|x| x.abs().to_f64() < 1e-30), "{error}");
    // Moments whose difference f64 does not see.
    let close = InertiaTensor::principal([d(1.0) + d(1e-25), d(1.0), d(1.5)]).principal_axes();
    assert_eq!(close.symmetry, Symmetry::Asymmetric);
    assert!((close.moments[1] - close.moments[0]).to_f64() > 0.9e-25);
}

#[test]
fn derivatives_of_principal_moments() {
    type Twice = Dual<Dual>;
    let slope = |x: Twice| x.derivative[0].value;
    let bend = |x: Twice| x.derivative[0].derivative[0];
    // With the product p, I₁ and I₂ are (a + b)/2 ∓ √((a − b)²/4 + p²).
    for p in [0.25, 0.0] {
        let number = Twice::from_f64;
        let zero = number(0.0);
        let product = Twice::variable(Dual::variable(p, 0), 0);
        let products = ProductsOfInertia {
            xy: product,
            xz: zero,
            yz: zero,
        };
        let moments = [3.0, 2.0, 4.5].map(number);
        let principal =
            InertiaTensor::from_moments_and_products(moments, products).principal_axes();
        let root = (product * product + number(0.25)).sqrt();
        let expected = number(2.5) - root;
        let found = principal.moments[0];
        assert_close(found.largest(), expected.largest(), 1e-15);
        assert_close(slope(found), slope(expected), 1e-15);
        assert_close(bend(found), bend(expected), 1e-14);
        // Axis 1 is at tan 2α = −2p/(a − b) from y: dα/dp.
        let axis = principal.axes.matrix().column(0).into_owned();
        let length = axis.y * axis.y + axis.x * axis.x;
        assert_close(slope(length), 0.0, 1e-15);
        let alpha = axis.x.atan2(axis.y);
        let expected = (product + product).atan2(number(1.0)) * number(0.5);
        assert_close(slope(alpha), slope(expected), 1e-14);
    }
}
