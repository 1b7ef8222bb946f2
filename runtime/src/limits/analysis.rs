//! Limits of the analysis of models.

/// The number of Newton steps after which a search for an equilibrium gives up by default. If it converges, it takes
/// about ten.
pub(crate) const NEWTON_STEPS: usize = 100;

/// The default tolerance of an equilibrium, in machine epsilons of the size of each variable.
pub(crate) const EQUILIBRIUM_TOLERANCE: f64 = 64.0;

/// The longest Newton step, in sizes of the variables: a radian for an angle at zero.
pub(crate) const MAX_NEWTON_STEP: f64 = 1.0;

/// The smallest damping factor of a Newton step, relative to the longest one that is allowed: Deuflhard's value.
pub(crate) const MIN_DAMPING: f64 = 1e-8;

/// The first damping of a descent, in squares of the largest singular value: the middle of the values that Nielsen
/// proposes.
pub(crate) const DESCENT_DAMPING: f64 = 1e-3;

/// A descent ends when its steps are this short, in sizes of the variables; Newton's method takes over.
pub(crate) const DESCENT_END: f64 = 1e-6;

/// Singular values of a Jacobian below this many machine epsilons of the largest one are zero.
pub(crate) const SINGULAR: f64 = 4096.0;

/// The power of the machine epsilon below which accelerations that remain after a search count as zero, relative to
/// their changes when the variables change by their own sizes.
pub(crate) const UNBALANCED: f64 = 0.5;

/// The fraction of their sizes by which variables are moved to find how forces change: a power of two, with which a
/// third of the digits is correct.
pub(crate) const FORCE_DIFFERENCE: f64 = 1.0 / 1024.0;

/// If forces are not balanced, relative pivots below this are reported as a singular mass matrix. By judgement, with
/// room for searches that end beside the singularity.
pub(crate) const NEARLY_SINGULAR: f64 = 1e-3;

/// The limit of sweeps of Jacobi's methods: they converge quadratically after a few, and take about ten even for large
/// matrices.
pub(crate) const JACOBI_SWEEPS: usize = 40;

/// The limit of double steps of the QR algorithm for one eigenvalue, and the number of steps between exceptional
/// shifts: values of EISPACK, with more steps for safety.
pub(crate) const QR_STEPS: usize = 60;
/// See [`QR_STEPS`].
pub(crate) const EXCEPTIONAL_SHIFT: usize = 10;

/// The number of steps of inverse iteration: with an eigenvalue to rounding two are enough, unless the start is
/// unlucky.
pub(crate) const INVERSE_ITERATIONS: usize = 4;

/// The factor by which an eigenvector of a multiple eigenvalue may be worse than the best one and still count as one.
pub(crate) const ROOM_FOR_SHAPES: f64 = 100.0;

/// Rows and columns are scaled if their sum is reduced by this factor: the value of Parlett and Reinsch.
pub(crate) const BALANCED: f64 = 0.95;

/// The possible error of the position of an equilibrium, in units of the distance from which on the forces agree with
/// the stiffness: the tested distances are a factor of eight apart.
pub(crate) const POSITION_ERRORS: f64 = 4.0;

/// The first distance at which forces are evaluated, as a power of two in sizes of the coordinates; [`FARTHEST`] is the
/// end of the range. The range includes the distances of rounding, of coordinates that are small, and of coordinates
/// that should be zero.
pub(crate) const FIRST_DISTANCE: i32 = -100;
/// See [`FIRST_DISTANCE`].
pub(crate) const FARTHEST: f64 = 16.0;

/// An eigenvalue of the second variation, or of the linearized motion, counts as zero if it changes by half of itself
/// within the error of the equilibrium.
pub(crate) const VARIATION_ERRORS: f64 = 2.0;

/// The perturbations for which the power of forces is evaluated, in sizes of the coordinates: small, and of two orders
/// of magnitude.
pub(crate) const ENERGY_SAMPLES: [f64; 2] = [1.0 / 1024.0, 1.0 / 1_048_576.0];

/// The power of the machine epsilon up to which real parts of eigenvalues are zero, relative to the largest eigenvalue:
/// the perturbation of a double eigenvalue has this size. It also applies to squares of frequencies, and to the
/// asymmetry of a Hessian.
pub(crate) const NEGLIGIBLE: f64 = 0.5;

/// The errors of the entries of a linearized motion, in machine epsilons. By judgement, so that the errors of its
/// derivation and of the QR algorithm are covered.
pub(crate) const EIGENVALUE_ERRORS: f64 = 1024.0;

/// The power of the machine epsilon up to which a defective eigenvalue is found, relative to the largest one to which
/// it is coupled: the power for a triple eigenvalue.
pub(crate) const DEFECTIVE: f64 = 1.0 / 3.0;

/// The delays after the time of a state at which its equations are evaluated, to find whether they contain the time.
/// Their ratios are irrational, so that no period contains all of them, and they have several orders of magnitude.
pub(crate) const OTHER_TIMES: [f64; 4] = [
    core::f64::consts::FRAC_1_SQRT_2 * 1e-3,
    0.618_033_988_749_894_8,
    1e3 * core::f64::consts::SQRT_2,
    1e6 * core::f64::consts::PI,
];

/// The coefficient of the leading term in the relative error of the Padé approximant of degree 13, which has the power
/// 26 of the norm: (13!)²/(26! 27!).
pub(crate) const PADE_ERROR: f64 = 8.83e-36;

/// The limit of halvings of the argument of the exponential: beyond it, the exponential overflows or underflows in any
/// case.
pub(crate) const PADE_SQUARINGS: i32 = 60;

/// In the staircase form, entries below this many machine epsilons of the largest one, for each dimension, are zero.
pub(crate) const UNREACHED: f64 = 64.0;

/// The distance of eigenvalues from the border of stability, relative to the largest one, below which they may be on
/// it.
pub(crate) const BORDER: f64 = 1e-9;

/// The limit of steps towards the sign of a matrix. With scaling they take about ten, and one more for each halving of
/// the angle between an eigenvalue and the imaginary axis.
pub(crate) const SIGN_ITERATIONS: usize = 200;

/// The limit of Newton steps for a Riccati equation. From a cost that is far too large, each step halves it; near the
/// solution a few are enough.
pub(crate) const RICCATI_NEWTON_STEPS: usize = 100;

/// A Newton step for a Riccati equation, relative to the cost, after which only rounding errors remain: the next step
/// would be shorter by this factor again, unless the equation is ill-conditioned.
pub(crate) const RICCATI_ROUNDING: f64 = 1e-20;

/// The largest last Newton step, relative to the cost, if rounding errors prevent shorter ones.
pub(crate) const RICCATI_CHANGE: f64 = 1e-10;

/// Powers of a stable matrix count as zero below this, in units in which it is balanced: their squares are below the
/// rounding errors of a double-double.
pub(crate) const VANISHED_POWER: f64 = 1e-18;

/// The parameters of the Cayley transform that are compared, in units of the geometric mean of the smallest and the
/// largest eigenvalue. There are several, so that one is far from all eigenvalues.
pub(crate) const CAYLEY_SHIFTS: [f64; 6] = [1.0, 1.3, 0.8, 1.7, 0.6, 2.2];

/// The number of doublings after which a Riccati equation has no solution: they converge quadratically, unless
/// eigenvalues of the closed loop are on the border of stability.
pub(crate) const DOUBLINGS: usize = 60;

/// The limit of Newton steps for the inputs of a given motion: one, and a second for its rounding errors, where forces are linear in
/// them.
pub(crate) const INPUT_STEPS: usize = 20;

/// The part of the largest velocity, in machine epsilons and in the metric of M, from which a coordinate of a constrained model moves. By
/// judgement: velocities that the constraints make zero are found to a few rounding errors.
pub(crate) const MOVING: f64 = 1e4;
