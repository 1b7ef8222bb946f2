//! All limits and tolerances of the crate, by folder.
//!
//! A limit bounds the cost of a method, never its result: beyond it another method takes over. Each names the model
//! or the bound that made it, and what moves it. *Measured* are the operations of q̈ ([cost](crate::algebra::cost),
//! in additions, invariants hoisted) for the systems of the tests, with half and with twice the limit: tops in
//! Euler's and Cardan's angles, a cart and pole, charged and polar particles, and chains of 2, 3, 5, 8 and 12 links
//! in absolute and relative angles. *Insensitive* are limits that change none of them: they bound the time of a
//! derivation.

// algebra

/// Rationals with longer numerators or denominators are no longer folded. Made by products of long decimals, whose
/// digits add up; longer constants in a declaration move it.
pub(crate) const MAX_EXACT_BITS: u64 = 4096;

/// Larger decimal exponents are no numbers: a defence against `1e999999999`. Binary64 ends at 308; scalars with a
/// wider range move it.
pub(crate) const MAX_DECIMAL_EXPONENT: u32 = 20_000;

/// A sum of more terms stays one term of the sum that contains it: prefix sums, such as the positions along a chain,
/// would otherwise grow with the square of its length. Made by chains; measured: with 16, twelve different links cost
/// 961 instead of 849, with 4, three cost 132 instead of 129.
pub(crate) const MAX_MERGED_SUM_LENGTH: usize = 8;

/// A product of more factors stays one factor of the product that contains it, as long sums do. Made by nested
/// functions, whose derivatives are prefix products; formulas written by hand have fewer factors, so that their
/// quotients cancel. Insensitive.
pub(crate) const MAX_MERGED_PRODUCT_LENGTH: usize = 16;

/// No product has more factors, which is the length that two products merge to: the factors of longer ones are
/// multiplied in pairs. Made by a potential of 199 factors, whose derivatives ran out of memory.
pub(crate) const MAX_PRODUCT_LENGTH: usize = 2 * MAX_MERGED_PRODUCT_LENGTH;

/// Products of more factors are differentiated as trees of pairs; of fewer, the scheduler finds the common factors in
/// the terms of the product rule. Made by the general top; measured: with 5, its expanded form costs 128 instead of
/// 69, with 20 nothing changes.
pub(crate) const MAX_FLAT_PRODUCT_RULE: usize = 10;

/// Expansions with more terms are given up. Made by the general top. Insensitive.
pub(crate) const MAX_EXPANDED_TERMS: usize = 128;

/// Sums to a higher integer power are not expanded. Insensitive.
pub(crate) const HIGHEST_EXPANDED_POWER: i64 = 4;

/// Higher powers of sines and cosines are not reduced: their binomials cancel digits. Made by determinants of
/// rotations by Euler angles. Insensitive.
pub(crate) const HIGHEST_REDUCED_POWER: i64 = 8;

/// A monomial that a reduction would turn into more terms stays. Insensitive.
pub(crate) const MAX_REDUCED_TERMS: usize = 128;

// identity

/// Points at which a claim must hold where branches do not matter. Made by the bound of Schwartz and Zippel: a false
/// claim of degree 10⁶ passes one point with probability 4·10⁻¹⁰, three with 10⁻²⁸. Smaller primes move it.
pub(crate) const AGREEMENTS: usize = 3;

/// Points at which a claim must hold for each choice of branches, on average. A claim that fails for one of 2ᵏ
/// choices passes with probability below (1 − 2⁻ᵏ)^(24·2ᵏ) < e⁻²⁴ ≈ 4·10⁻¹¹.
pub(crate) const AGREEMENTS_PER_CHOICE: usize = 24;

/// Points to try for each one that must be in the domain: a square root exists modulo half of the primes, so that
/// four independent ones exist at one point in 16.
pub(crate) const ATTEMPTS_PER_AGREEMENT: usize = 16;

/// Points to try where one in the domain is enough: six independent square roots exist at one point in 64.
pub(crate) const MODULAR_ATTEMPTS: u64 = 64;

/// With more branches a claim is tested with uninterpreted functions only. Made by a top whose declaration contains
/// five roots: 768 points take some 10 ms for its mass matrix. Insensitive.
pub(crate) const MAX_BRANCHES: u32 = 5;

/// Real points at which a matrix with roots must be a rotation.
pub(crate) const REAL_POINTS: u64 = 64;

/// The largest residual of the orthonormality of a matrix of rounded numbers: constants are written with six digits or more.
pub(crate) const ROUNDED_CONSTANT: f64 = 1e-6;

/// The largest numerator and denominator of a reconstructed structure constant. Made by multiples of body-fixed
/// angular velocities, such as 2 ω₁, whose constants are 2 and ½; a random residue is such a rational with a
/// probability below 10⁻¹⁴. Insensitive.
pub(crate) const MAX_STRUCTURE_CONSTANT: u64 = 64;

// matrix

/// The most components that a vector or matrix may have: as many as a parameter, so that no expression is larger than the
/// largest of these.
pub const MAX_ARRAY: usize = 10_000;

/// The most rows of an identity matrix, and of the diagonal matrix of a vector: those of the largest square array.
/// The product of two of them takes two seconds. Sparse matrices would move it.
pub const MAX_DIAGONAL_ROWS: usize = MAX_ARRAY.isqrt();

/// Determinants of matrices with more rows are not expanded in minors: n! products, 24 for four rows.
pub const MAX_DETERMINANT: usize = 4;

/// Matrices with larger diagonal blocks are left to other solvers: Cramer's rule takes n² minors. Made by Euler
/// angles, whose block is 3 × 3; measured: with 1, the general top costs 122 instead of 70, with 6 nothing changes.
pub(crate) const MAX_DIAGONAL_BLOCK: usize = 3;

/// The entries of larger matrices become opaque during elimination: they would grow with each step. Made by chains;
/// measured: with 8, five different links cost 309 instead of 293; with 2, three cost 124
/// instead of 129, at the price of exact cancellation.
pub(crate) const MAX_TRANSPARENT_ELIMINATION: usize = 4;

// frames

/// A vector is not multiplied by more factors one by one, but by the elements of their product. Made by chains: the
/// elements are needed for later links anyway, and factors one by one would cost the square of the length of the
/// chain.
pub(crate) const MAX_SUCCESSIVE_FACTORS: usize = 6;

/// A sum of more vectors in frames is not remembered: it belongs to a link of a chain and is cheaper in the inertial
/// frame, where the links before it have been computed. Made by five links on universal joints, which took twice the
/// operations with 6.
pub(crate) const MAX_FRAMES_IN_SUM: usize = 3;

/// Nor is a sum with a vector that is rotated by more factors. Made by the same chain.
pub(crate) const MAX_FACTORS_IN_SUM: usize = 4;

/// Nor is a single vector that is rotated by more factors; twelve are six joints of two rotations each.
pub(crate) const MAX_FACTORS: usize = 12;

/// A frame with whose angular velocity a recursion begins has at most so many turns behind inertial axes: three angles of a
/// body, and a constant orientation of its mount.
pub(crate) const MAX_TURNS_OF_A_BASE: usize = 4;

// mechanics

/// Polynomials in parameters with more monomials are given up: there is no regressor. Made by the arm of six joints, whose
/// energies have some 250. Moved by longer chains with unknown lengths, whose monomials grow with their square.
pub(crate) const MAX_PARAMETER_MONOMIALS: usize = 4096;

/// Higher powers of parameters are no polynomials. A defence against `l.powi(1_000_000)`.
pub(crate) const HIGHEST_PARAMETER_POWER: i64 = 64;

/// More different functions of the motion among the columns of a regressor are given up: their elimination modulo a prime
/// takes the cube of their number.
pub(crate) const MAX_MOTION_FUNCTIONS: usize = 600;

/// Random motions, one after the other, at which the rank of a regressor does not grow, when it is taken to be complete.
/// At each, an incomplete rank stays by an accident of a probability of the degree of the columns over 2·10¹⁵.
pub(crate) const MOTIONS_WITHOUT_GAIN: usize = 2;

/// A mass matrix of more rows is not expanded, unless an ignorable coordinate is written in it: it swells. Made by the general
/// top, expanded; measured: with 2 it costs 149 instead of 69, with 8 only five different links change, from 293 to 290.
pub(crate) const MAX_EXPANDED_COORDINATES: u32 = 4;

/// The Boltzmann–Hamel equations are not tried for more quasi-velocities: the structure constants are a cube.
/// Insensitive.
pub(crate) const MAX_QUASI_VELOCITIES: usize = 8;

/// Where a pivot of a saddle point problem is less than 2⁻⁷ of what it is compared with, a numerical factorization takes over, with
/// pivoting. By judgement: the solution loses two digits there, as many as the numerical one without pivoting may
/// (`MIN_STABLE_PIVOT` of the runtime).
pub(crate) const MIN_SADDLE_POINT_PIVOT: (i64, i64) = (1, 1 << 7);

/// A constraint is eliminated before a coordinate where the sum of the squares of its derivatives with respect to the
/// coordinates eliminated before is at least 2⁻⁴ of the square of its derivative with respect to this coordinate. By judgement:
/// a rod without mass may be 4 m long, and one digit is lost.
pub(crate) const MIN_ELIMINATED_GRADIENT: (i64, i64) = (1, 1 << 4);

/// Where a pivot row has more entries, the matrix is eliminated numerically, which costs no more than straight-line
/// code. Made by chains in relative angles, whose M is full; measured: with 14, twelve links become 3578 operations
/// of straight-line code, with 3, five links (462) are left to numerical elimination.
pub(crate) const MAX_PIVOT_NEIGHBOURS: usize = 7;

/// A saddle point problem whose rows of pivots are longer is eliminated as straight-line code if the products of a dense
/// factorization are at least this many times as many. By judgement: loops over dense columns use vectors, straight-line code
/// does not.
pub(crate) const MIN_SPARSITY: usize = 2;

/// Constraints are eliminated before the coordinates of hubs if that takes less than half of the products: it is stable at fewer
/// configurations. Made by a platform on six legs, where it takes 0.47 of them; in rows of four-bar linkages without hubs,
/// constraints that wait for nothing would take 0.65, and be unstable at most configurations.
pub(crate) const MIN_SPARSITY_OF_HUBS: usize = 2;

/// A coordinate that so many constraints restrict is one of a hub. Made by a platform on six legs; the coordinates of rods in
/// rows of four-bar linkages are restricted by three.
pub(crate) const MIN_CONSTRAINTS_OF_HUB: usize = 4;

/// No saddle point problem is eliminated as straight-line code that takes more products, so that compiling takes less than a
/// minute. Those of 40 four-bar linkages in a row take some 4000 with one right-hand side, those of 200 would take 20 000. Loops over
/// repeated parts would lift it.
pub(crate) const MAX_ELIMINATION_PRODUCTS: usize = 20_000;

/// Sums of more terms become opaque during articulated-body elimination. Made by chains; measured: with 1, most
/// systems change by one operation in either direction, with 4, eight different links by one.
pub(crate) const MAX_TRANSPARENT_INERTIA_LENGTH: usize = 2;

/// A solver whose result costs this many times the cheapest before scheduling is not scheduled. Made by the symmetric
/// top; measured: with 1 it costs 36 instead of 34, with 4 nothing changes.
pub(crate) const SCHEDULING_MARGIN: usize = 2;

/// For more coordinates the derivatives of q̈ are solved for numerically: they have 2n + 1 columns of the length of a
/// solution. Made by chains; measured: by q and q̇ alone five links take 1064 operations and eight 2771, where q̈
/// takes 280 and 499.
pub(crate) const MAX_DIFFERENTIATED_COORDINATES: usize = 4;

/// For fewer coordinates the derivatives of q̈ are not sought along the links of a mechanism. Measured: an arm of nine joints takes
/// 9757 operations with a numerical solution, and some 12 000 along its links; from thirteen on it takes fewer along them.
pub(crate) const MIN_DIFFERENTIATED_ALONG_LINKS: usize = 9;

/// For more, they are taken along the links without a look at the cost of a numerical solution, which grows with the cube. Made by
/// arms: twenty joints take 43558 operations instead of 61357, thirty 86359 instead of 172667.
pub(crate) const MAX_SOLVED_BY_COLUMNS: usize = 20;

/// Periods of more full turns are not used. By judgement: angles are halved, or geared by ratios of small numbers, and
/// a longer period is rarely exceeded.
pub(crate) const MAX_PERIOD: u32 = 64;

// program

/// The cost of a division, in additions of binary64 on a current x86-64 core, as that of a square root, of the sine
/// and cosine of one angle, and of another function: reciprocal throughputs. Another target moves them.
pub(crate) const COST_OF_DIVISION: usize = 5;
/// See [`COST_OF_DIVISION`].
pub(crate) const COST_OF_SQUARE_ROOT: usize = 7;
/// See [`COST_OF_DIVISION`].
pub(crate) const COST_OF_SINE_AND_COSINE: usize = 12;
/// See [`COST_OF_DIVISION`].
pub(crate) const COST_OF_FUNCTION: usize = 20;
/// The cost of a convolution in a term of a Taylor series, in additions: at order 28 it has 13 products on average, of
/// which a vector register holds four.
pub(crate) const COST_OF_CONVOLUTION: usize = 5;

/// How many cycles a sum takes on a current x86-64 core, as a product, a product that is fused with a sum, a division and
/// another function do (Fog, Instruction tables, 2025). They bound no cost: they tell the order of terms and of instructions.
pub(crate) const LATENCY_OF_ADDITION: usize = 3;
/// See [`LATENCY_OF_ADDITION`].
pub(crate) const LATENCY_OF_PRODUCT: usize = 3;
/// See [`LATENCY_OF_ADDITION`].
pub(crate) const LATENCY_OF_FUSED: usize = 4;
/// See [`LATENCY_OF_ADDITION`].
pub(crate) const LATENCY_OF_DIVISION: usize = 13;
/// See [`LATENCY_OF_ADDITION`].
pub(crate) const LATENCY_OF_FUNCTION: usize = 40;

/// As many applications of external functions are made for the Taylor series of one. A polynomial and its derivatives have
/// as many as its degree. Made by f′(x) = f(x/2), whose derivatives are of f at ever further arguments.
pub(crate) const MAX_APPLICATIONS_IN_A_SERIES: usize = 128;

/// The instructions of longer groups are put in an order for registers, terms of their sums are added as they are known, and emitted
/// code keeps that order. Made by arms in space; simulated with 30 registers that are evicted as late as possible, q̈ of ten links
/// loads 296 values again instead of 681, of thirty 1136 instead of 2548. Shorter groups keep the order of their scheduling. More
/// registers would move it.
pub(crate) const MAX_GROUP_AS_SCHEDULED_LENGTH: usize = 600;

/// Integer powers up to this one are repeated factors, of which parts can be shared; higher ones are computed by
/// squaring. Insensitive.
pub(crate) const HIGHEST_REPEATED_POWER: usize = 8;

/// Longer sums and products are neither searched nor searched for when existing sums are collected and common
/// subexpressions eliminated: their pairs grow with the square of the length. Insensitive.
pub(crate) const MAX_SEARCHED_LIST_LENGTH: usize = 24;

// validation

/// Points in the domain at which programs are compared: each of four distributions of random points eight times.
pub(crate) const VALIDATED_POINTS: usize = 32;

/// Points to try until as many are in the domain: roots and logarithms leave out most of them.
pub(crate) const VALIDATION_ATTEMPTS: u64 = 512;

/// The first attempts, of moderate numbers; later ones are spread more widely. Made by domains far from one.
pub(crate) const NEARBY_ATTEMPTS: u64 = 160;

/// With as many points in the domain after the first attempts, none that are spread more widely are tried.
pub(crate) const ENOUGH_NEARBY_POINTS: usize = 8;

/// Where an intermediate result is larger, a program need not have a value: its fourth power is not far from the largest
/// number, and a program may form it where the value itself is moderate. Made by 1/(1 + cosh 1000x); numbers of a wider
/// range move it.
pub(crate) const MAX_WITHIN_RANGE: f64 = 1e70;

/// Perturbed runs that measure the conditioning where two numbers differ.
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

/// For more coordinates the derivatives of a mechanism are those along its links, without a look at the general ones, which
/// grow with the cube of the number of links and are 7 % of what it takes to derive an arm of thirty.
pub(crate) const MAX_DIFFERENTIATED_BOTH_WAYS: usize = 4;

// print

/// The longest printed formula, in characters: what is shared in the graph is printed wherever it occurs, which can
/// be exponentially often.
pub(crate) const MAX_FORMULA_LENGTH: usize = 1 << 16;

/// Formulas that nest deeper are not folded: each level takes frames of the stack. A line of a page has some thirty levels.
pub(crate) const MAX_PRINTED_DEPTH: usize = 300;

/// Longer equations are left out of a listing, in characters: some five lines of a page, which no equation of the golden
/// models exceeds.
pub(crate) const MAX_LINE_LENGTH: usize = 500;

/// Rows of LaTeX with more visible characters are broken: the width of a page of a book in ten points.
pub(crate) const MAX_ROW_LENGTH: usize = 80;

/// An energy that is longer when it is written out, in characters, is printed as it was declared if that is a quarter as
/// long: two lines of a page. Made by a chain of rods.
pub(crate) const MAX_SKIMMED_LENGTH: usize = 200;

/// The same of an energy that mentions no definitions, if it is half as long as it was declared: a line of a page. Made by a
/// chain of equal springs.
pub(crate) const MIN_SKIMMED: usize = 90;

/// Accelerations of more symbols are not listed: they follow from the equations before them.
pub(crate) const MAX_ACCELERATION_LENGTH: u64 = 40;

/// Nor are those of more coordinates.
pub(crate) const MAX_LISTED_ACCELERATIONS: usize = 3;

/// Equations may be so many characters before they are folded, and those under one heading together.
pub(crate) const MAX_UNFOLDED_LINE_LENGTH: usize = 2000;
/// See [`MAX_UNFOLDED_LINE_LENGTH`].
pub(crate) const MAX_UNFOLDED_SECTION_LENGTH: usize = 16_000;

/// Fewer terms are not folded to a sum over an index: three are as easily read.
pub(crate) const MIN_FOLDED_TERMS: usize = 4;

/// Fewer members of a family are not folded to one equation: of two, both are as easily read.
pub(crate) const MIN_FOLDED_LINES: usize = 3;

/// Equations of a family that are shorter together, in characters, are not folded to one with a sum: two lines of a page.
pub(crate) const MIN_FOLDED_SECTION: usize = 200;

/// How many patterns of a family are compared with its equations. Each sum in a sample has up to nine and each parameter two, so
/// that the chain of links, with a sum and two lengths, has 36.
pub(crate) const MAX_PATTERNS: usize = 128;

/// With less room under a heading, no further equation is tried.
pub(crate) const MIN_LINE: usize = 20;

/// Equations of more symbols are not arranged, since they would be too long even then. Made by the general top, whose
/// longest has some 200, and by chains, whose equations take a second to arrange.
pub(crate) const MAX_UNARRANGED_LENGTH: u64 = 300;

/// The equations under one heading together, in characters: a third of a page.
pub(crate) const MAX_SECTION_LENGTH: usize = 1200;

/// Expressions with more terms are printed as they are. Made by a chain of twenty links, whose forces have some 400.
pub(crate) const MAX_ARRANGED_TERMS: usize = 512;

/// Equations that have more symbols where nothing is called by its name are arranged by names alone. Made by arms in space,
/// whose rotations double with each joint; what cancels in tops and in their definitions has some 500.
pub(crate) const MAX_ARRANGED_IN_FULL_LENGTH: u64 = 2000;

/// Of arrangements that are longer than this in print, in characters, the first is taken.
pub(crate) const MAX_ARRANGED_LENGTH: usize = 2000;

/// Decimals with more zeros behind the point carry a power of ten.
pub(crate) const MAX_LEADING_ZEROS: usize = 4;

/// Integers that end in as many zeros carry a power of ten.
pub(crate) const ROUND_ZEROS: usize = 7;

/// Sums in products are multiplied by their common denominator up to this one: 4 m + 3 M in place of m + ¾ M. Larger ones
/// are those of decimals.
pub(crate) const MAX_COMMON_DENOMINATOR: i64 = 48;

/// Fractions with denominators up to this are read at a glance.
pub(crate) const SMALL_DENOMINATOR: u32 = 12;

/// A pivot of which cancellation leaves at least this part of its terms, as numerator and denominator, does not vanish: it
/// costs three digits at most. The runtime allows twelve bits before it takes a pivot for a singularity. Bounds of
/// expressions that are not wider than their range would move it.
pub(crate) const MIN_REMAINDER: (i64, i64) = (1, 1024);

/// Sums with exponential and other terms are scaled by what grows up to this number of terms. Those that are declared have a
/// few; the pivots of a mass matrix, which share their values in derivatives, have many.
pub(crate) const MAX_SCALED_TERMS: usize = 16;
