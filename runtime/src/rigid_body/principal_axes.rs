//! Principal moments and axes of an inertia tensor (2.5).
//!
//! The cyclic method of C. G. J. Jacobi, *Über ein leichtes Verfahren, die in der Theorie der Säcularstörungen
//! vorkommenden Gleichungen numerisch aufzulösen*, J. reine angew. Math. **30** (1846) 51–94, with the rotations of G.
//! H. Golub & C. F. Van Loan, *Matrix Computations*, 4th edition (2013), section 8.5. It is as accurate as the entries
//! and has no special case. The axes of equal moments are not unique; the axes nearest to the axes of the body are
//! chosen.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::inertia_tensor::InertiaTensor;
use super::order::{is_less, length, power_of_two_near};
use crate::integrate::SingleNumber;
use crate::limits::rigid_bodies::{EQUAL_MOMENTS, JACOBI_SWEEPS, NEGLIGIBLE_ENTRY};
use crate::linalg::largest;
use crate::scalar::Scalar;

/// The principal moments of inertia and the principal axes of a body about a point (2.5).
///
/// ```
/// use lagrangian::rigid_body::{InertiaTensor, ProductsOfInertia, Symmetry};
///
/// let products = ProductsOfInertia { xy: 1.0, xz: 0.0, yz: 0.0 };
/// let principal = InertiaTensor::from_moments_and_products([3.0, 3.0, 5.0], products).principal_axes();
/// for (moment, expected) in principal.moments.into_iter().zip([2.0, 4.0, 5.0_f64]) {
///     assert!((moment - expected).abs() < 1e-15);
/// }
/// // More mass where x = y: the least moment is about that line.
/// assert!((principal.axes.matrix()[(0, 0)] - 0.5_f64.sqrt()).abs() < 1e-15);
/// assert_eq!(principal.symmetry, Symmetry::Asymmetric);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes<S: Scalar = f64> {
    /// The principal moments I₁ ≤ I₂ ≤ I₃.
    pub moments: [S; 3],
    /// The axes: a proper rotation R with R diag(I₁, I₂, I₃) Rᵀ = \[I\], whose columns are unit vectors along axes 1, 2
    /// and 3. It takes components along the principal axes to components in the axes of the body.
    ///
    /// The largest component of axes 1 and 2 is positive. If moments are equal, the axes nearest to the axes of the
    /// body are chosen: a body whose axes are principal axes keeps them up to their order. In this case, derivative
    /// parts of dual numbers have no meaning.
    pub axes: Rotation3<S>,
    /// Which moments are equal up to rounding.
    pub symmetry: Symmetry,
}

/// Which principal moments of inertia are equal, up to rounding errors of the tensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// All moments differ: the axes are determined up to their signs.
    Asymmetric,
    /// Two moments are equal: the axis of symmetry is principal axis 1 or 3, index 0 or 2, and any axes normal to it
    /// are principal axes.
    Symmetric {
        /// The index of the axis of symmetry among the principal axes.
        axis: usize,
    },
    /// All moments are equal: any axes are principal axes.
    Spherical,
}

impl<S: SingleNumber> InertiaTensor<S> {
    /// Returns the principal moments and axes (2.5). If entries are not finite, neither are the moments.
    #[must_use]
    pub fn principal_axes(&self) -> PrincipalAxes<S> {
        PrincipalAxes::of(self)
    }
}

impl<S: SingleNumber> PrincipalAxes<S> {
    /// Returns the principal moments and axes of a tensor. If entries are not finite, neither are the moments.
    fn of(tensor: &InertiaTensor<S>) -> Self {
        let matrix = tensor.matrix();
        let largest = largest(&matrix);
        let size = if largest > 0.0 && largest.is_finite() {
            S::from_f64(power_of_two_near(largest))
        } else {
            S::one()
        };
        let (moments, vectors) = eigenvectors(matrix.map(|entry| entry / size));
        let (moments, vectors) = ascending(moments, &vectors);
        let symmetry = symmetry(&moments);
        let axes = match symmetry {
            Symmetry::Asymmetric => right_handed(vectors.map(|axis| positive(&axis))),
            Symmetry::Symmetric { axis } => about(&vectors[axis], axis),
            Symmetry::Spherical => Matrix3::identity(),
        };
        Self {
            moments: moments.map(|moment| moment * size),
            axes: Rotation3::from_matrix_unchecked(axes),
            symmetry,
        }
    }

    /// Returns the tensor R diag(I₁, I₂, I₃) Rᵀ in the axes of the body.
    #[must_use]
    pub fn tensor(&self) -> InertiaTensor<S> {
        InertiaTensor::principal(self.moments).rotated(&self.axes)
    }
}

/// Returns the eigenvalues, and the eigenvectors as columns, of a symmetric matrix whose entries are of order 1.
fn eigenvectors<S: SingleNumber>(mut a: Matrix3<S>) -> (Vector3<S>, Matrix3<S>) {
    let mut vectors = Matrix3::identity();
    for _ in 0..JACOBI_SWEEPS {
        let mut changed = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            changed |= annihilate(&mut a, &mut vectors, p, q);
        }
        if !changed {
            break;
        }
    }
    (a.diagonal(), vectors)
}

/// Returns whether a number and its derivative parts are zero, or so small that their squares are.
fn is_negligible<S: Scalar>(x: S) -> bool {
    let small = |part: f64| part.abs() < NEGLIGIBLE_ENTRY;
    small(x.largest()) && (0..S::DERIVATIVES).all(|index| small(x.derivative_part(index)))
}

/// Makes the entries (p, q) and (q, p) zero by a rotation in that plane; returns `false` if they are zero already.
fn annihilate<S: SingleNumber>(
    a: &mut Matrix3<S>,
    vectors: &mut Matrix3<S>,
    p: usize,
    q: usize,
) -> bool {
    let entry = a[(p, q)];
    let difference = a[(q, q)] - a[(p, p)];
    let determined = difference.abs().largest() > 0.0 || entry.abs().largest() > 0.0;
    if is_negligible(entry) || !determined || !entry.is_finite() {
        return false;
    }
    // The tangent of the smaller angle that solves t² + t (a_qq − a_pp)/a_pq − 1 = 0.
    let twice = entry + entry;
    let root = (difference * difference + twice * twice).sqrt();
    let signed_root = if difference.smallest() < 0.0 {
        -root
    } else {
        root
    };
    let tangent = twice / (difference + signed_root);
    let cosine = S::one() / (S::one() + tangent * tangent).sqrt();
    let sine = tangent * cosine;

    a[(p, p)] -= tangent * entry;
    a[(q, q)] += tangent * entry;
    a[(p, q)] = S::zero();
    a[(q, p)] = S::zero();
    let other = 3 - p - q;
    let turned = |[x, y]: [S; 2]| [cosine * x - sine * y, sine * x + cosine * y];
    let [x, y] = turned([a[(other, p)], a[(other, q)]]);
    [a[(other, p)], a[(p, other)]] = [x, x];
    [a[(other, q)], a[(q, other)]] = [y, y];
    for row in 0..3 {
        [vectors[(row, p)], vectors[(row, q)]] = turned([vectors[(row, p)], vectors[(row, q)]]);
    }
    true
}

/// Returns the eigenvalues with their vectors in ascending order.
fn ascending<S: SingleNumber>(
    values: Vector3<S>,
    vectors: &Matrix3<S>,
) -> ([S; 3], [Vector3<S>; 3]) {
    let mut order = [0, 1, 2];
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if is_less(values[order[j]], values[order[i]]) {
            order.swap(i, j);
        }
    }
    let vector = |index: usize| vectors.column(index).into_owned();
    (order.map(|index| values[index]), order.map(vector))
}

/// Returns which of three ascending moments are equal up to rounding.
fn symmetry<S: SingleNumber>([first, second, third]: &[S; 3]) -> Symmetry {
    let largest = first.abs().largest().max(third.abs().largest());
    let allowed = EQUAL_MOMENTS * S::machine_epsilon() * largest;
    let near = |a: S, b: S| (b - a).largest() <= allowed;
    match (near(*first, *second), near(*second, *third)) {
        (false, false) => Symmetry::Asymmetric,
        (true, false) => Symmetry::Symmetric { axis: 2 },
        (false, true) => Symmetry::Symmetric { axis: 0 },
        (true, true) => Symmetry::Spherical,
    }
}

/// Returns the index of the component of the largest magnitude; of equal ones, the first.
fn largest_component<S: SingleNumber>(vector: &Vector3<S>) -> usize {
    let longer = |best: usize, index: usize| {
        // A component that is larger only by rounding errors does not count as larger.
        let rounded = vector[best].abs().largest() * (1.0 + EQUAL_MOMENTS * S::machine_epsilon());
        if vector[index].abs().largest() > rounded {
            index
        } else {
            best
        }
    };
    longer(longer(0, 1), 2)
}

/// Returns the unit vector along an axis whose largest component is positive.
fn positive<S: SingleNumber>(axis: &Vector3<S>) -> Vector3<S> {
    let norm = length(axis);
    let sign = axis[largest_component(axis)].signum();
    axis.map(|component| sign * component / norm)
}

/// Returns axes 1 and 2 and their vector product. Rounding errors that make axis 2 oblique are removed.
fn right_handed<S: SingleNumber>([first, second, _]: [Vector3<S>; 3]) -> Matrix3<S> {
    let oblique = first.dot(&second);
    let second = positive(&(second - first * oblique));
    Matrix3::from_columns(&[first, second, first.cross(&second)])
}

/// Returns the axes about an axis of symmetry, which is axis `index`, that are nearest to the axes of the body.
fn about<S: SingleNumber>(axis: &Vector3<S>, index: usize) -> Matrix3<S> {
    let axis = positive(axis);
    // The axis of the body nearest to the normal plane, along which the axis of symmetry has its smallest component.
    let distances = axis.map(|component| S::one() - component.abs());
    let nearest = largest_component(&distances);
    let unit = Vector3::from_fn(|row, _| if row == nearest { S::one() } else { S::zero() });
    let projected = positive(&(unit - axis * axis[nearest]));
    let across = axis.cross(&projected);
    if index == 0 {
        Matrix3::from_columns(&[axis, projected, across])
    } else {
        Matrix3::from_columns(&[projected, across, axis])
    }
}
