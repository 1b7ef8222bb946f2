//! All limits and tolerances of the crate, by folder.
//!
//! A limit bounds the cost of a method, never its result: beyond it another method takes over. Each names the model
//! or the bound that made it, and what moves it. Costs are in operations of the [cost model](crate::algebra::cost);
//! the models of the benchmark are described in `bench/README.md`.

// algebra

/// Rationals with longer numerators or denominators are no longer folded. Made by chains of products of decimals,
/// whose digits add up: 4096 bits hold the 15th power of a number with 80 digits. A use of longer constants moves it.
pub(crate) const LONGEST_EXACT_BITS: u64 = 4096;

/// Decimal exponents beyond this are no numbers. Binary64 ends at 308, so that every useful literal passes; the limit
/// is a defence against `1e999999999`. Scalars with larger exponents than 20 000 would move it.
pub(crate) const LARGEST_DECIMAL_EXPONENT: u32 = 20_000;

/// A sum of more terms stays one term of the sum that contains it. Made by a chain of 20 links, whose prefix sums,
/// the positions of the bodies, would otherwise grow with the square of its length; a formula written by hand has
/// fewer terms. Cancellation across longer sums, as in expanded energies, would move it up.
pub(crate) const LONGEST_MERGED_SUM: usize = 8;

/// A product of more factors stays one factor of the product that contains it, as long sums do. Made by nested
/// functions whose derivatives are prefix products. It exceeds the number of factors in formulas written by hand, so
/// that their quotients cancel; longer formulas would move it up.
pub(crate) const LONGEST_MERGED_PRODUCT: usize = 16;

/// No product has more factors, which is the length that two products merge to: the factors of longer ones are
/// multiplied in pairs. Made by a potential of 199 factors, whose derivatives ran out of memory. It moves with
/// [`LONGEST_MERGED_PRODUCT`].
pub(crate) const LONGEST_PRODUCT: usize = 2 * LONGEST_MERGED_PRODUCT;

/// Products of more factors are differentiated as trees of pairs. Made by the growth tests (`tests/growth.rs`): of
/// fewer factors, the common factors in the terms of the product rule are found by the scheduler, and quotients
/// cancel. A better elimination of common subexpressions would move it up.
pub(crate) const LONGEST_FLAT_PRODUCT_RULE: usize = 10;

/// Expansions with more terms are given up. Made by the general top, whose entries of M have some 40 terms in Euler
/// angles. The time of a derivation moves it down, mass matrices with more angles move it up.
pub(crate) const MOST_EXPANDED_TERMS: usize = 128;

/// Sums to a higher integer power are not expanded. Made by fourth powers of two-term sums, the highest in the models
/// of the tests; (a + b)⁵ has more terms than factors worth cancelling.
pub(crate) const HIGHEST_EXPANDED_POWER: i64 = 4;

/// Higher powers of sines and cosines are not reduced. Made by det A of a rotation by Euler angles, of degree six,
/// and its products with inertias. Binomials of higher powers cancel digits, which moves it down.
pub(crate) const HIGHEST_REDUCED_POWER: i64 = 8;

/// Monomials that a reduction would turn into more terms stay. It moves with [`MOST_EXPANDED_TERMS`].
pub(crate) const MOST_REDUCED_TERMS: usize = 128;

// identity

/// Points at which a claim must hold where branches do not matter. Made by the bound of Schwartz and Zippel: a false
/// claim of degree 10⁶ passes one point with probability 10⁻¹², and three with 10⁻³⁶. Smaller primes would move it
/// up.
pub(crate) const AGREEMENTS: usize = 3;

/// Points at which a claim must hold for each choice of branches, on average. A claim that fails for one of 2ᵏ
/// choices passes with probability below (1 − 2⁻ᵏ)^(24·2ᵏ) < e⁻²⁴ ≈ 4·10⁻¹¹.
pub(crate) const AGREEMENTS_PER_CHOICE: usize = 24;

/// Points to try for each one that must be in the domain: a square root exists modulo half of the primes, so that
/// four independent roots are defined at one point in 16.
pub(crate) const ATTEMPTS_PER_AGREEMENT: usize = 16;

/// Points to try where one in the domain is enough: with six independent square roots one in 64 is.
pub(crate) const MODULAR_ATTEMPTS: u64 = 64;

/// With more branches a claim is only tested with uninterpreted functions: 768 points take some 10 ms for expressions
/// as long as the mass matrix of a top whose declaration contains five roots. A quicker evaluation moves it up.
pub(crate) const MOST_BRANCHES: u32 = 5;

/// Real points at which a matrix with roots must be a rotation, and by how much it may miss: numerical constants in a
/// declaration have six digits or more.
pub(crate) const REAL_POINTS: u64 = 64;

/// The largest defect of an orthonormal matrix of rounded numbers. Made by constants that are written with six
/// digits.
pub(crate) const ROUNDED_CONSTANT: f64 = 1e-6;

/// The largest numerator and denominator of a reconstructed structure constant. Made by multiples of body-fixed
/// angular velocities, such as 2 ω₁, whose constants are small integers and halves. Of some 10¹⁸ residues 10⁴ are
/// such rationals, so that a wrong one passes three points with probability 10⁻⁴².
pub(crate) const LARGEST_STRUCTURE_CONSTANT: u64 = 64;

// matrix

/// Determinants of matrices with more rows are not expanded in minors: n! products. Made by 4 × 4 homogeneous
/// transformations. An elimination in exact arithmetic would move it.
pub const LARGEST_DETERMINANT: usize = 4;

/// Matrices E with larger diagonal blocks are left to other solvers. Made by Euler angles, the largest block of which
/// is 3 × 3: Cramer's rule takes n² minors.
pub(crate) const LARGEST_DIAGONAL_BLOCK: usize = 3;

/// Entries of larger matrices become opaque during elimination. Made by chains: with four coordinates the
/// cancellation of the double pendulum and the tops is exact; with more, entries would grow exponentially.
pub(crate) const LARGEST_TRANSPARENT_ELIMINATION: usize = 4;

// frames

/// A vector is not multiplied by more factors one by one, but by the elements of their product. Made by chains of
/// links on universal joints: the elements are needed for later links anyway, and factors one by one would cost the
/// square of the length of the chain.
pub(crate) const MOST_SUCCESSIVE_FACTORS: usize = 6;

/// A sum of more vectors in frames is not remembered: it belongs to a link of a chain and is cheaper in the inertial
/// frame, where the links before it have been computed. With 6, five links on universal joints took twice the
/// operations.
pub(crate) const MOST_FRAMES_IN_SUM: usize = 3;

/// Nor is a sum with a vector that is rotated by more factors, by the same chain.
pub(crate) const MOST_FACTORS_IN_SUM: usize = 4;

/// Nor is a single vector that is rotated by more factors: the arm of six joints has two factors for each.
pub(crate) const MOST_FACTORS: usize = 12;

// mechanics

/// A mass matrix of more rows is not expanded: it swells. Made by the spherical pendulum and the tops, where angles
/// cancel in M; five or more coupled coordinates have entries beyond [`MOST_EXPANDED_TERMS`].
pub(crate) const MOST_EXPANDED_COORDINATES: u32 = 4;

/// The Boltzmann–Hamel equations are not tried for more quasi-velocities: the structure constants are a cube. Made by
/// two rigid bodies with a common point, six, and a margin.
pub(crate) const MOST_QUASI_VELOCITIES: usize = 8;

/// Where a pivot row has more entries, numerical elimination costs no more than straight-line code. Made by the chain
/// of 20 links and by the arm of six joints, whose M is full: its rows have five and are still eliminated.
pub(crate) const MOST_PIVOT_NEIGHBOURS: usize = 7;

/// Sums of more terms become opaque during articulated-body elimination. Made by chains of 3, 5 and 8 links, for
/// which two terms are one link's own inertia and its child's: transparent, they grow with the depth.
pub(crate) const LONGEST_TRANSPARENT_INERTIA: usize = 2;

/// A solver whose result costs this many times the cheapest before scheduling is not scheduled: the scheduler has not
/// made up for a factor of two on any model of the benchmark.
pub(crate) const SCHEDULING_MARGIN: usize = 2;

/// For more coordinates the derivatives of q̈ are solved for numerically: 2n + 1 columns, each of the length of a
/// solution. Made by the chains: from five links on, the numerical factorization is shorter.
pub(crate) const MOST_DIFFERENTIATED_COORDINATES: usize = 4;

// program

/// The cost of a division, of a square root, of the sine and cosine of one angle and of another function, in
/// additions of binary64 on a current x86-64 core: reciprocal throughputs. Another target moves them.
pub(crate) const COST_OF_DIVISION: usize = 5;
/// See [`COST_OF_DIVISION`].
pub(crate) const COST_OF_SQUARE_ROOT: usize = 7;
/// See [`COST_OF_DIVISION`].
pub(crate) const COST_OF_SINE_AND_COSINE: usize = 12;
/// See [`COST_OF_DIVISION`].
pub(crate) const COST_OF_FUNCTION: usize = 20;

/// Integer powers up to this one are repeated factors, of which parts can be shared. Made by r⁶ and r⁸ of potentials
/// between molecules; higher powers are computed by squaring.
pub(crate) const HIGHEST_REPEATED_POWER: usize = 8;

/// Longer sums and products are neither searched nor searched for when existing sums are collected and common
/// subexpressions eliminated: their pairs grow with the square of the length. Made by the chain of 20 links, whose
/// sums have up to 20 terms.
pub(crate) const LONGEST_SEARCHED_LIST: usize = 24;

// validation

/// Points in the domain at which programs are compared: each distribution of random points eight times.
pub(crate) const VALIDATED_POINTS: usize = 32;

/// Points to try until as many are in the domain: roots and logarithms leave out most of them.
pub(crate) const VALIDATION_ATTEMPTS: u64 = 512;

/// The first attempts, at numbers near one; later ones are spread more widely. Made by domains far from one.
pub(crate) const NEARBY_ATTEMPTS: u64 = 160;

/// With as many points in the domain after the first attempts, none that are spread more widely are tried.
pub(crate) const ENOUGH_NEARBY_POINTS: usize = 8;

/// Perturbed runs that measure the conditioning where two numbers differ: the chance that all three miss a
/// sensitivity by the margin is below 10⁻³.
pub(crate) const PERTURBED_RUNS: u64 = 3;

/// The relative perturbation of every intermediate result, 2⁻³⁶: far above the rounding error 2⁻⁵³, and far below a
/// wrong term.
pub(crate) const PERTURBATION: f64 = 1.0 / 68_719_476_736.0;

/// By how much a difference must exceed the changes under perturbation, which are 2¹⁷ times those by rounding.
pub(crate) const PERTURBATION_MARGIN: f64 = 8.0;

/// Relative differences below 2⁻³⁰ are negligible: 2²³ rounding errors, far below a wrong term.
pub(crate) const NEGLIGIBLE_DIFFERENCE: f64 = 1.0 / 1_073_741_824.0;

/// How often an external function is differentiated: Lagrange's equations and their linearization take third
/// derivatives of the Lagrangian function.
pub(crate) const HIGHEST_EXTERNAL_DERIVATIVE: usize = 3;

// print

/// The longest printed formula, in characters: what is shared in the graph is printed wherever it occurs, which can
/// be exponentially often.
pub(crate) const LONGEST_FORMULA: usize = 1 << 16;

/// Decimals with more zeros behind the point carry a power of ten: 0.0001 is read at a glance.
pub(crate) const MOST_LEADING_ZEROS: usize = 4;

/// Integers that end in as many zeros carry a power of ten: 1000000 does not.
pub(crate) const ROUND_ZEROS: usize = 7;

/// Fractions with denominators up to this are read at a glance.
pub(crate) const SMALL_DENOMINATOR: u32 = 12;
