//! The limits of this crate, each with the model that set it and what would move it.
//!
//! Times are those of an expansion in a development build, without optimization, on one core.

use lagrangian_symbolic::Rational;

/// How many scopes may be nested with a `let` for each variable. The derivatives of an arm of six joints in space
/// have 2500 variables, at which rustc 1.95 without optimization overflows its stack where it writes debug
/// information. A compiler that does not recurse over scopes would lift it.
pub(crate) const MAX_SCOPES: usize = 1000;

/// How many times [`MAX_SCOPES`] the variables of a method are declared at once and assigned; one with more is divided into
/// pieces. Measured by arms in space: the accelerations of thirty joints (4600 variables) take 0.94 of the time in pieces, the
/// inverse dynamics of thirty (2800) and the accelerations of ten (1800) 1.9 and 1.1 times as long. Code that fits the first
/// cache of instructions is better in one function, whose values wait on the stack; a larger cache would move it.
pub(crate) const MAX_ASSIGNED: usize = 4;

/// Like [`MAX_ASSIGNED`], for the accelerations and multipliers of a constrained model by the factors of its saddle point problem.
/// Those of 40 four-bar linkages in a row (6000 variables) take 0.8 of the time in one function, and half of the instructions: pieces
/// would keep all factors in an array, which has to be cleared. Compiling with optimization takes 9 s in place of 6.
pub(crate) const MAX_ASSIGNED_FACTORS: usize = 8;

/// How many statements a piece has of a method in pieces; with what it reads these are fewer scopes than [`MAX_SCOPES`]. The
/// accelerations of thirty joints take the same time, to 3 %, in pieces of 300 and of 1000. Compiled with optimization, a function of
/// 6000 random statements takes 27 s and its pieces of 300 take 4 s. Loops over links of one kind would move it.
pub(crate) const STATEMENTS_PER_PIECE: usize = 300;

/// How many statements of a piece are between two transfers from and to memory. The accelerations of thirty joints in space take the
/// same time with four, 1.08 times as long with 16, and 1.55 times as long where pieces read at their beginning and write at
/// their end. Fewer registers would move it.
pub(crate) const STATEMENTS_PER_TRANSFER: usize = 8;

/// How many variables are declared at once, those that are assigned and the results of pieces.
pub(crate) const DECLARED_AT_ONCE: usize = 200;

/// The characters of a switching function's formula in an error.
pub(crate) const MAX_SWITCHING_FUNCTION_LENGTH: usize = 60;

/// The cost of M beyond which it is computed column by column. That of thirty joints in space costs ten thousand, a tenth of
/// what thirty columns of momenta do; that of a hundred joints would cost more than ten times as much, and the time to compile
/// grows with it. Loops over the links of one kind would lift it.
pub(crate) const COSTLIEST_MASS_MATRIX: usize = 20_000;

/// The cost of the inverse dynamics, times the number of columns, beyond which the derivatives of the accelerations are computed
/// column by column. For thirty joints in space it is two hundred thousand; a release build then took 28 s of processor time
/// in place of 41. Derivatives of fewer operations would move it.
pub(crate) const COSTLIEST_DERIVATIVES: usize = 150_000;

/// How many columns of derivatives are computed at once. With two, `linearize` of 30 joints in space or of 100 links in a plane takes
/// 0.85 of the time, and a quarter to two thirds more to compile. Loops over links of one kind would move it.
pub(crate) const DIRECTIONS_AT_ONCE: usize = 1;

/// The sizes beyond which methods take another form.
#[derive(Clone, Copy)]
pub(crate) struct MethodLimits {
    /// See [`MAX_SCOPES`].
    pub(crate) most_scopes: usize,
    /// See [`COSTLIEST_MASS_MATRIX`].
    pub(crate) costliest_mass_matrix: usize,
    /// See [`COSTLIEST_DERIVATIVES`].
    pub(crate) costliest_derivatives: usize,
}

/// The variables beyond which the body of a method takes another form.
#[derive(Clone, Copy)]
pub(crate) struct BodyLimits {
    /// See [`MAX_SCOPES`].
    pub(crate) most_scopes: usize,
    /// The variables that are declared at once and assigned.
    pub(crate) most_assigned: usize,
}

impl MethodLimits {
    /// Those of the body of a method, which may solve a saddle point problem by its factors.
    pub(crate) const fn of_body(self, solves_saddle_point: bool) -> BodyLimits {
        let times = if solves_saddle_point {
            MAX_ASSIGNED_FACTORS
        } else {
            MAX_ASSIGNED
        };
        BodyLimits {
            most_scopes: self.most_scopes,
            most_assigned: self.most_scopes.saturating_mul(times),
        }
    }

    /// Those of what users get; tests have others, too.
    pub(crate) const OF_EXPANSIONS: Self = Self {
        most_scopes: MAX_SCOPES,
        costliest_mass_matrix: COSTLIEST_MASS_MATRIX,
        costliest_derivatives: COSTLIEST_DERIVATIVES,
    };
}

/// How deep expressions are nested in one statement. The golden expansions set it: their statements stay within a
/// few lines. More would make longer statements of the same operations.
pub(crate) const DEEPEST_NESTING: usize = 6;

/// About how many characters a statement of a short group takes besides its `let` and the name of its variable: it then fits in a line
/// of 89 characters, as formatters print expansions. The golden expansions set it.
pub(crate) const MAX_STATEMENT_WIDTH: usize = 70;

/// How deep an expression of the declaration is printed as it stands. Each level takes a frame of the stack; a sum of more terms
/// is too long to read. A printer with a stack of its own would lift it.
pub(crate) const DEEPEST_PRINTED: usize = 100;

/// The most numbers that a field may hold. Each is a symbol of the equations and has a name, used or not, which
/// takes 45 microseconds and two kilobytes: at most half a second for a table of data. Symbols that are made on
/// demand would lift it.
pub(crate) const MAX_COMPONENTS: usize = lagrangian_symbolic::MAX_ARRAY;

/// How many coordinates may have one name. A chain of springs between 200 masses takes four seconds, and the time
/// grows with the square of their number, as the emitted mass matrix does: a thousand are beyond what is practical,
/// so that the limit stops slips of the pen alone. A mass matrix that is emitted by its pattern of zeros would
/// move it.
pub(crate) const MAX_FAMILY: usize = 1000;

/// How many iterations are unrolled in one declaration, all together. A sum of as many terms `i * x` takes a
/// second. Sums that stay loops would lift it.
pub(crate) const MAX_REPETITIONS: usize = 100_000;

/// How many rotations and matrices of frames are in one declaration. Each of a chain remembers its factors, so that memory and
/// time grow with the square of their number; 2000 are a chain of 600 links. Products that share the factors of those before
/// them would lift it.
pub(crate) const MAX_ROTATIONS: usize = 2000;

/// For more coordinates the relative pivots are those of a numerical factorization: symbolic elimination keeps the
/// entries of larger systems opaque, and the magnitude of a pivot is summed over its terms. Magnitudes that are
/// computed along with the elimination would move it.
pub(crate) const MAX_PIVOTS: usize = 4;

/// Accelerations up to this cost are inlined where a stepper evaluates them: a result that goes through memory delays each
/// stage by some 8 ns, a quarter of the time of a double pendulum's and an eighth of that of five links, whose
/// accelerations cost 280. Longer ones would make steppers longer and hardly faster.
pub(crate) const COSTLIEST_INLINED_ACCELERATIONS: usize = 300;

/// The most tokens of an expression. Printing 10 000 terms in a row takes the stack that rustc has, 8 MiB; a parser that
/// does not recurse would lift it, as it would the next three.
pub(crate) const MAX_EXPRESSION_LENGTH: usize = 8192;

/// The most dots of an expression: calls of methods, one on the result of the other, of which 1500 are within the stack.
pub(crate) const MAX_METHOD_CALLS: usize = 1024;

/// The most operators without an operand between them.
pub(crate) const MAX_OPERATORS_IN_ROW: usize = 256;

/// How deep parentheses, brackets and braces are nested; 600 are within the stack.
pub(crate) const DEEPEST_GROUPS: usize = 256;

/// How many names an error lists: one line of a terminal.
pub(crate) const MAX_NAMES: usize = 10;

/// Whether a number is neither beyond the largest nor lost below the smallest `f64`.
pub(crate) fn in_range(number: &Rational) -> bool {
    let rounded = number.to_f64();
    rounded.is_finite() && (rounded != 0.0 || number.is_zero())
}

/// Terms of more characters are not printed in errors: what is longer is not read.
pub(crate) const MAX_TERM_LENGTH: usize = 80;
