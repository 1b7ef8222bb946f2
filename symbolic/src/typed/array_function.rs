//! The functions of vectors and matrices: one row for each.

use crate::limits::{MAX_ARRAY, MAX_DETERMINANT, MAX_DIAGONAL_ROWS};
use crate::typed::components::{Components, NoValue};
use crate::{Geometry, Matrix, NoInverse, Rational};

/// The value of a function, or what its arguments should be.
type Found = Result<Components, NoValue>;

/// A function of vectors and matrices.
#[derive(Debug)]
pub struct ArrayFunction {
    /// How it is written, as a function or as a method of its first argument.
    pub name: &'static str,
    /// How many arguments it has.
    pub arity: usize,
    /// How it is printed, in Unicode and in LaTeX.
    pub notation: ArrayNotation,
    /// Whether the value of a sum without terms is one.
    pub keeps_empty_sum: bool,
    evaluate: fn(&mut Geometry, &[&Matrix]) -> Found,
}

/// How a function of vectors and matrices is printed; two texts are those in Unicode and in LaTeX.
#[derive(Clone, Copy, Debug)]
pub enum ArrayNotation {
    /// x · y.
    InnerProduct,
    /// A sign between two arguments.
    Between([&'static str; 2]),
    /// The arguments between brackets, with an exponent behind them.
    Enclosed {
        /// What opens and what closes.
        brackets: [[&'static str; 2]; 2],
        /// What stands behind.
        exponent: [&'static str; 2],
    },
    /// An exponent.
    Raised([&'static str; 2]),
    /// x / |x|.
    Direction,
    /// diag(x) y.
    Diagonal,
    /// It has no customary notation.
    None,
}

/// All of them.
pub static ARRAY_FUNCTIONS: [ArrayFunction; 17] = [
    of_sum("dot", 2, ArrayNotation::InnerProduct, dot),
    function("cross", 2, CROSS, cross),
    function("triple", 3, TRIPLE, triple),
    function("outer", 2, ArrayNotation::None, outer),
    function("component_mul", 2, ArrayNotation::Diagonal, component_mul),
    of_sum("norm", 1, bars(["", ""]), |geometry, arguments| {
        each(arguments, |x| Components::Scalar(geometry.norm(x)))
    }),
    of_sum(
        "norm_squared",
        1,
        bars(["²", "^{2}"]),
        |geometry, arguments| each(arguments, |x| Components::Scalar(geometry.norm_squared(x))),
    ),
    function("normalize", 1, ArrayNotation::Direction, normalized),
    function("transpose", 1, TRANSPOSE, |_, arguments| {
        each(arguments, |x| Components::Array(x.transpose()))
    }),
    function("trace", 1, ArrayNotation::None, |geometry, arguments| {
        let trace = arguments.first().and_then(|x| geometry.graph.trace(x));
        scalar(trace, NoValue::Arguments("a square matrix"))
    }),
    function("determinant", 1, ArrayNotation::None, determinant),
    function("inverse", 1, INVERSE, inverse),
    function("cross_matrix", 1, ArrayNotation::None, cross_matrix),
    function("diagonal", 1, ArrayNotation::None, diagonal),
    of_sum("sum", 1, ArrayNotation::None, |geometry, arguments| {
        each(arguments, |x| {
            let terms = x.elements().iter().map(|x| (*x, Rational::ONE));
            Components::Scalar(geometry.graph.sum(terms))
        })
    }),
    function("product", 1, ArrayNotation::None, |geometry, arguments| {
        each(arguments, |x| {
            let factors = x.elements().iter().map(|x| (*x, Rational::ONE));
            Components::Scalar(geometry.graph.product(factors))
        })
    }),
    function("len", 1, ArrayNotation::None, |geometry, arguments| {
        each(arguments, |x| {
            let length = i64::try_from(x.elements().len()).unwrap_or(i64::MAX);
            Components::Scalar(geometry.graph.integer(length))
        })
    }),
];

const CROSS: ArrayNotation = ArrayNotation::Between([" × ", " \\times "]);
const TRANSPOSE: ArrayNotation = ArrayNotation::Raised(["ᵀ", "^{T}"]);
const INVERSE: ArrayNotation = ArrayNotation::Raised(["⁻¹", "^{-1}"]);
const TRIPLE: ArrayNotation = ArrayNotation::Enclosed {
    brackets: [["[", "]"], ["\\left[", "\\right]"]],
    exponent: ["", ""],
};

const fn bars(exponent: [&'static str; 2]) -> ArrayNotation {
    ArrayNotation::Enclosed {
        brackets: [["|", "|"], ["\\left|", "\\right|"]],
        exponent,
    }
}

const SAME_SHAPE: NoValue = NoValue::Arguments("two arrays of the same shape");
const SMALL_SQUARE: NoValue = NoValue::Arguments("a square matrix of at most 4 rows");

impl ArrayFunction {
    /// The function with a name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        ARRAY_FUNCTIONS
            .iter()
            .find(|function| function.name == name)
    }

    /// Its value.
    pub(crate) fn evaluate(&self, geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
        (self.evaluate)(geometry, arguments)
    }
}

const fn function(
    name: &'static str,
    arity: usize,
    notation: ArrayNotation,
    evaluate: fn(&mut Geometry, &[&Matrix]) -> Found,
) -> ArrayFunction {
    ArrayFunction {
        name,
        arity,
        notation,
        keeps_empty_sum: false,
        evaluate,
    }
}

/// A function of which the value of a sum without terms is one.
const fn of_sum(
    name: &'static str,
    arity: usize,
    notation: ArrayNotation,
    evaluate: fn(&mut Geometry, &[&Matrix]) -> Found,
) -> ArrayFunction {
    ArrayFunction {
        keeps_empty_sum: true,
        ..function(name, arity, notation, evaluate)
    }
}

fn scalar(found: Option<crate::Expression>, wanted: NoValue) -> Found {
    found.map(Components::Scalar).ok_or(wanted)
}

fn array(found: Option<Matrix>, wanted: NoValue) -> Found {
    found.map(Components::Array).ok_or(wanted)
}

fn two<'a>(arguments: &[&'a Matrix]) -> Option<[&'a Matrix; 2]> {
    arguments.try_into().ok()
}

/// A function that every array has.
fn each(arguments: &[&Matrix], value: impl FnOnce(&Matrix) -> Components) -> Found {
    let one = NoValue::Arguments("one array");
    arguments.first().map(|x| value(x)).ok_or(one)
}

/// x · y.
fn dot(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let product = two(arguments).and_then(|[x, y]| geometry.dot_product(x, y));
    scalar(product, SAME_SHAPE)
}

/// x × y.
fn cross(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let product = two(arguments).and_then(|[x, y]| geometry.cross_product(x, y));
    array(product, NoValue::Arguments("two vectors of 3 components"))
}

/// [x, y, z] = x · (y × z).
fn triple(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let wanted = NoValue::Arguments("three vectors of 3 components");
    let [x, y, z] = arguments else {
        return Err(wanted);
    };
    let product = geometry.cross_product(y, z).ok_or(wanted)?;
    scalar(geometry.dot_product(x, &product), wanted)
}

/// x yᵀ.
fn outer(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let wanted = NoValue::Arguments("two vectors");
    let [x, y] = two(arguments).ok_or(wanted)?;
    if x.elements().len() > MAX_ARRAY / y.elements().len().max(1) {
        return Err(NoValue::Size);
    }
    array(geometry.graph.outer_product(x, y), wanted)
}

/// The products of elements in one place.
fn component_mul(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let graph = &mut geometry.graph;
    let product = two(arguments).and_then(|[x, y]| graph.component_product(x, y));
    array(product, SAME_SHAPE)
}

/// det A.
fn determinant(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let determinant = arguments.first().and_then(|x| geometry.determinant(x));
    scalar(determinant, SMALL_SQUARE)
}

/// The matrix of x ×.
fn cross_matrix(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let graph = &mut geometry.graph;
    let matrix = arguments.first().and_then(|x| graph.cross_matrix(x));
    array(matrix, NoValue::Arguments("a vector of 3 components"))
}

/// A⁻¹.
fn inverse(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let small = |x: &&&Matrix| x.is_square() && x.rows() <= MAX_DETERMINANT;
    let x = arguments.first().filter(small).ok_or(SMALL_SQUARE)?;
    match geometry.inverse(x) {
        Ok(inverse) => Ok(Components::Array(inverse)),
        Err(NoInverse::Singular) => Err(NoValue::Singular),
        Err(NoInverse::Shape) => Err(SMALL_SQUARE),
    }
}

/// x / |x|.
fn normalized(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let wanted = NoValue::Arguments("a vector other than zero");
    let x = arguments.first().ok_or(wanted)?;
    let norm = geometry.norm(x);
    if geometry.graph.is_zero(norm) {
        return Err(wanted);
    }
    let factor = geometry.graph.power(norm, &Rational::MINUS_ONE);
    Ok(Components::Array(geometry.matrix_scaled(x, factor)))
}

/// The diagonal of a square matrix, or the diagonal matrix of a vector.
fn diagonal(geometry: &mut Geometry, arguments: &[&Matrix]) -> Found {
    let wanted =
        NoValue::Arguments("a square matrix, or a vector that becomes the diagonal of one");
    let x = arguments.first().ok_or(wanted)?;
    let found = match x.columns() {
        1 if x.rows() > MAX_DIAGONAL_ROWS => {
            return Err(NoValue::Arguments("a vector of at most 100 components"));
        }
        1 => geometry.graph.diagonal_matrix(x),
        _ => x.diagonal(),
    };
    array(found, wanted)
}
