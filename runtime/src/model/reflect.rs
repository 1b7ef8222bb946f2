//! Models by the names of their fields: what programs in other languages, forms and files need.

use core::fmt;

use nalgebra::{Const, Matrix3, OPoint, SMatrix, Vector3};

use super::lagrangian::Lagrangian;
use super::state::State;
use crate::error_debug::debug_by_message;
use crate::rigid_body::{BodyError, InertiaTensor, PrincipalBody, RigidBody, SymmetricBody};

/// A model that describes its fields and is made from their numbers: the clause `reflect`.
///
/// Programs that do not know the model when they are written use it: a module for another language, a form with a slider for
/// each parameter, a file of parameters.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::quantities::Reflect;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(x),
///     kinetic = 0.5 * m * dot(x).powi(2),
///     potential = 0.5 * k * x.powi(2),
///     output(tension = k * x),
///     reflect,
/// )]
/// struct Oscillator {
///     /// The mass in kg.
///     m: f64,
///     /// The stiffness in N/m.
///     k: f64,
/// }
///
/// let names = Oscillator::FIELDS.iter().map(|field| (field.name, field.documentation));
/// assert!(names.eq([("m", "The mass in kg."), ("k", "The stiffness in N/m.")]));
/// let oscillator = Oscillator::from_numbers(&[2.0, 18.0])?;
/// assert_eq!(oscillator.accelerations(&State::new(0.0, [1.0], [0.0]))[0], -9.0);
/// # Ok::<(), lagrangian::quantities::InvalidNumbers>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not describe its fields",
    note = "write the clause `reflect` in its declaration"
)]
pub trait Reflect<const N: usize>: Lagrangian<N> + Sized {
    /// The name of the struct.
    const NAME: &'static str;

    /// The documentation of the struct, as it is written in its declaration.
    const DOCUMENTATION: &'static str;

    /// The fields, in the order of the declaration, without those that the model skips.
    const FIELDS: &'static [FieldDescription];

    /// The outputs, in the order of the declaration.
    const OUTPUTS: &'static [FieldDescription] = &[];

    /// The inputs, component by component.
    const INPUTS: &'static [&'static str] = &[];

    /// The events.
    const EVENTS: &'static [&'static str] = &[];

    /// The constraints, component by component.
    const CONSTRAINTS: &'static [&'static str] = &[];

    /// Reads the fields. Programs call [`from_numbers`](Self::from_numbers).
    ///
    /// # Errors
    ///
    /// The numbers of a body describe none.
    fn read_fields(numbers: &mut FieldReader<'_>) -> Result<Self, InvalidNumbers>;

    /// Passes on the numbers of all fields, in order.
    fn numbers(&self, each: &mut dyn FnMut(f64));

    /// Passes on the numbers of all outputs at a state, in order.
    fn output_numbers(&self, state: &State<f64, N>, each: &mut dyn FnMut(f64)) {
        let _ = (state, each);
    }

    /// Passes on the multipliers of the constraints at a state, component by component.
    fn multiplier_numbers(&self, state: &State<f64, N>, each: &mut dyn FnMut(f64)) {
        let _ = (state, each);
    }

    /// Makes a model from the numbers of its fields, field by field in the order of [`FIELDS`](Self::FIELDS), each in the order that
    /// [`FieldDescription`] says. Fields that the model skips have the value of [`Default`].
    ///
    /// # Errors
    ///
    /// [`InvalidNumbers`] if there are too few or too many, or the numbers of a body describe none.
    fn from_numbers(numbers: &[f64]) -> Result<Self, InvalidNumbers> {
        let expected = Self::FIELDS.iter().map(FieldDescription::count).sum();
        if numbers.len() != expected {
            return Err(InvalidNumbers::Count {
                expected,
                found: numbers.len(),
            });
        }
        Self::read_fields(&mut FieldReader { numbers })
    }
}

/// A field of a model, or an output.
///
/// Arrays, vectors and matrices are stored row by row, the last index fastest. A body stands for the numbers that its
/// [`element`](Self::element) lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldDescription {
    /// The name.
    pub name: &'static str,
    /// The documentation of the field in the declaration.
    pub documentation: &'static str,
    /// The lengths of the arrays, vectors and matrices, from the outermost; none for a number or a body.
    pub lengths: &'static [usize],
    /// What each element is.
    pub element: FieldElement,
    /// Whether the field is an input.
    pub is_input: bool,
}

/// What an element of a field is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FieldElement {
    /// A number.
    Number,
    /// A [`RigidBody`]: its mass, the three coordinates of its centre of gravity, and the nine elements of its inertia tensor
    /// about this centre.
    RigidBody,
    /// A [`PrincipalBody`]: its mass and its principal moments I₁, I₂, I₃.
    PrincipalBody,
    /// A [`SymmetricBody`]: its mass, the height of its centre of gravity, and its transverse and axial moments about this
    /// centre.
    SymmetricBody,
}

impl FieldElement {
    /// How many numbers an element consists of.
    #[must_use]
    pub const fn count(self) -> usize {
        match self {
            Self::Number => 1,
            Self::RigidBody => 13,
            Self::PrincipalBody | Self::SymmetricBody => 4,
        }
    }
}

impl FieldDescription {
    /// How many numbers the field consists of.
    #[must_use]
    pub fn count(&self) -> usize {
        self.lengths.iter().product::<usize>() * self.element.count()
    }
}

/// The numbers of a model that have not been read yet.
#[derive(Clone, Debug)]
pub struct FieldReader<'a> {
    numbers: &'a [f64],
}

impl FieldReader<'_> {
    /// Reads a field.
    ///
    /// # Errors
    ///
    /// The numbers of a body describe none.
    pub fn field<T: FieldValue>(&mut self, name: &'static str) -> Result<T, InvalidNumbers> {
        T::read(self).map_err(|error| InvalidNumbers::Body { name, error })
    }

    /// The next number; NaN behind the last one.
    fn next(&mut self) -> f64 {
        match self.numbers {
            [first, rest @ ..] => {
                self.numbers = rest;
                *first
            }
            [] => f64::NAN,
        }
    }
}

/// Why a model is not made from some numbers.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidNumbers {
    /// There are too few or too many numbers.
    Count {
        /// How many numbers the fields consist of.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The numbers of a body describe none.
    Body {
        /// The name of the field.
        name: &'static str,
        /// Why there is no such body.
        error: BodyError,
    },
}

debug_by_message!(InvalidNumbers);

impl fmt::Display for InvalidNumbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count { expected, found } => write!(
                f,
                "the fields of the model consist of {expected} numbers, but there are {found}"
            ),
            Self::Body { name, .. } => {
                write!(f, "the numbers of the field `{name}` describe no body")
            }
        }
    }
}

impl core::error::Error for InvalidNumbers {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Count { .. } => None,
            Self::Body { error, .. } => Some(error),
        }
    }
}

/// A type of fields that consist of numbers.
#[diagnostic::on_unimplemented(
    message = "a field of type `{Self}` is not made from numbers",
    note = "leave the clause `reflect` out, or mark the field `#[lagrangian(skip)]` if the model does not read it"
)]
pub trait FieldValue: Sized {
    /// Reads the value.
    ///
    /// # Errors
    ///
    /// The numbers of a body describe none.
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError>;

    /// Passes on the numbers of the value, in order.
    fn write(&self, each: &mut dyn FnMut(f64));
}

impl FieldValue for f64 {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        Ok(numbers.next())
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        each(*self);
    }
}

impl FieldValue for f32 {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        Ok(<Self as num_traits::NumCast>::from(numbers.next()).unwrap_or(Self::NAN))
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        each((*self).into());
    }
}

/// Arrays have at least one element.
impl<T: FieldValue + Copy, const K: usize> FieldValue for [T; K] {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        let mut values = [T::read(numbers)?; K];
        for value in values.iter_mut().skip(1) {
            *value = T::read(numbers)?;
        }
        Ok(values)
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        for value in self {
            value.write(each);
        }
    }
}

impl<const R: usize, const C: usize> FieldValue for SMatrix<f64, R, C> {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        let mut matrix = Self::zeros();
        for mut row in matrix.row_iter_mut() {
            for element in row.iter_mut() {
                *element = numbers.next();
            }
        }
        Ok(matrix)
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        for row in self.row_iter() {
            row.iter().for_each(|element| each(*element));
        }
    }
}

impl<const D: usize> FieldValue for OPoint<f64, Const<D>> {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        SMatrix::read(numbers).map(Self::from)
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        self.coords.write(each);
    }
}

impl FieldValue for RigidBody {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        let mass = numbers.next();
        let center = Vector3::read(numbers)?;
        let inertia = InertiaTensor::from_matrix(&Matrix3::read(numbers)?)?;
        Self::new(mass, center, inertia)
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        each(self.mass());
        self.center().write(each);
        self.inertia().matrix().write(each);
    }
}

impl FieldValue for PrincipalBody {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        Self::new(numbers.next(), FieldValue::read(numbers)?)
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        each(self.mass());
        self.moments().write(each);
    }
}

impl FieldValue for SymmetricBody {
    fn read(numbers: &mut FieldReader<'_>) -> Result<Self, BodyError> {
        let [mass, height, transverse, axial] = FieldValue::read(numbers)?;
        Self::new(mass, height, transverse, axial)
    }

    fn write(&self, each: &mut dyn FnMut(f64)) {
        [
            self.mass(),
            self.height(),
            self.transverse_moment(),
            self.axial_moment(),
        ]
        .write(each);
    }
}
