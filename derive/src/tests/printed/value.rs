//! Scalars, vectors and matrices of numbers with rates.

use super::jet::Jet;

/// What a printed expression is worth.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Value {
    Scalar(Jet),
    Vector(Vec<Jet>),
    /// Row by row.
    Matrix(Vec<Vec<Jet>>),
}

/// What has no value, and why.
pub(super) type Reading<T> = Result<T, String>;

/// How two factors stand side by side.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Join {
    /// With a space between them, or nothing.
    Juxtaposed,
    /// With a dot, which is a product of numbers or the inner one of vectors.
    Dot,
}

impl Value {
    pub(super) fn scalar(&self) -> Reading<Jet> {
        match self {
            Self::Scalar(x) => Ok(*x),
            other => Err(format!("{other:?} is no number")),
        }
    }

    pub(super) fn vector(&self) -> Reading<Vec<Jet>> {
        match self {
            Self::Vector(x) => Ok(x.clone()),
            // 0 is the zero vector, too.
            Self::Scalar(x) if x.is_zero() => Ok(vec![Jet::ZERO; 3]),
            other => Err(format!("{other:?} is no vector")),
        }
    }

    /// The components one after the other.
    pub(super) fn components(&self) -> Vec<Jet> {
        match self {
            Self::Scalar(x) => vec![*x],
            Self::Vector(x) => x.clone(),
            Self::Matrix(rows) => rows.concat(),
        }
    }

    fn map(&self, function: impl Fn(Jet) -> Jet) -> Self {
        match self {
            Self::Scalar(x) => Self::Scalar(function(*x)),
            Self::Vector(x) => Self::Vector(x.iter().map(|x| function(*x)).collect()),
            Self::Matrix(rows) => {
                let row = |row: &Vec<Jet>| row.iter().map(|x| function(*x)).collect();
                Self::Matrix(rows.iter().map(row).collect())
            }
        }
    }

    pub(super) fn negated(&self) -> Self {
        self.map(|x| -x)
    }

    pub(super) fn rate(&self) -> Self {
        self.map(Jet::rate)
    }

    pub(super) fn plus(&self, other: &Self) -> Reading<Self> {
        let add =
            |x: &[Jet], y: &[Jet]| -> Vec<Jet> { x.iter().zip(y).map(|(x, y)| *x + *y).collect() };
        match (self, other) {
            (Self::Scalar(x), Self::Scalar(y)) => Ok(Self::Scalar(*x + *y)),
            (Self::Vector(x), Self::Vector(y)) if x.len() == y.len() => Ok(Self::Vector(add(x, y))),
            (Self::Matrix(x), Self::Matrix(y)) if x.len() == y.len() => {
                let rows = x.iter().zip(y).map(|(x, y)| add(x, y));
                Ok(Self::Matrix(rows.collect()))
            }
            (Self::Scalar(x), other) | (other, Self::Scalar(x)) if x.is_zero() => Ok(other.clone()),
            _ => Err(format!("{self:?} + {other:?}")),
        }
    }

    pub(super) fn times(&self, other: &Self, join: Join) -> Reading<Self> {
        match (self, other) {
            (Self::Scalar(x), other) => Ok(other.map(|y| *x * y)),
            (other, Self::Scalar(y)) => Ok(other.map(|x| x * *y)),
            (Self::Vector(x), Self::Vector(y)) if join == Join::Dot => {
                inner(x, y).map(Self::Scalar)
            }
            (Self::Matrix(rows), Self::Vector(y)) => {
                let rows = rows.iter().map(|row| inner(row, y));
                Ok(Self::Vector(rows.collect::<Reading<_>>()?))
            }
            // v·M w, from the left.
            (Self::Vector(x), Self::Matrix(_)) if join == Join::Dot => {
                other.transposed()?.times(&Self::Vector(x.clone()), join)
            }
            (Self::Matrix(rows), Self::Matrix(others)) => {
                let columns = transposed(others);
                let row = |row: &Vec<Jet>| columns.iter().map(|y| inner(row, y)).collect();
                let rows = rows.iter().map(row).collect::<Reading<_>>()?;
                Ok(Self::Matrix(rows))
            }
            _ => Err(format!("two vectors side by side: {self:?} {other:?}")),
        }
    }

    pub(super) fn over(&self, other: &Self) -> Reading<Self> {
        let divisor = other.scalar()?;
        Ok(self.map(|x| x / divisor))
    }

    pub(super) fn cross(&self, other: &Self) -> Reading<Self> {
        let (x, y) = (self.vector()?, other.vector()?);
        let ([a, b, c], [d, e, f]) = (&*x, &*y) else {
            return Err("× of other than three components".into());
        };
        let product = [*b * *f - *c * *e, *c * *d - *a * *f, *a * *e - *b * *d];
        Ok(Self::Vector(product.to_vec()))
    }

    pub(super) fn transposed(&self) -> Reading<Self> {
        match self {
            Self::Matrix(rows) => Ok(Self::Matrix(transposed(rows))),
            // Of a mass or of a rotation by 0.
            Self::Scalar(_) => Ok(self.clone()),
            Self::Vector(_) => Err("a vector is transposed".into()),
        }
    }

    /// The absolute value, or the length.
    pub(super) fn length(&self) -> Reading<Jet> {
        match self {
            Self::Scalar(x) => Ok(x.abs()),
            Self::Vector(x) => Ok(inner(x, x)?.sqrt()),
            Self::Matrix(_) => Err("bars around a matrix".into()),
        }
    }

    /// The component along an axis.
    pub(super) fn component(&self, axis: usize) -> Reading<Self> {
        let components = self.vector()?;
        let component = components.get(axis).ok_or("there is no such component")?;
        Ok(Self::Scalar(*component))
    }

    /// The rotation about an axis.
    pub(super) fn rotation(axis: usize, angle: Jet) -> Self {
        let sine = angle.function("sin").unwrap_or(Jet::ZERO);
        let cosine = angle.function("cos").unwrap_or(Jet::ZERO);
        let mut rows = vec![vec![Jet::ZERO; 3]; 3];
        rows[axis][axis] = Jet::ONE;
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        rows[next][next] = cosine;
        rows[last][last] = cosine;
        rows[next][last] = -sine;
        rows[last][next] = sine;
        Self::Matrix(rows)
    }

    /// The angular velocity of a rotation, along the axes of the body: Rᵀ dR/dt v = ω × v.
    pub(super) fn angular_velocity(&self) -> Reading<Self> {
        let spin = self.transposed()?.times(&self.rate(), Join::Dot)?;
        let Self::Matrix(rows) = spin else {
            return Err("ω of no matrix".into());
        };
        Ok(Self::Vector(vec![rows[2][1], rows[0][2], rows[1][0]]))
    }
}

fn transposed(rows: &[Vec<Jet>]) -> Vec<Vec<Jet>> {
    let columns = 0..rows.first().map_or(0, Vec::len);
    columns
        .map(|k| rows.iter().map(|row| row[k]).collect())
        .collect()
}

fn inner(x: &[Jet], y: &[Jet]) -> Reading<Jet> {
    if x.len() != y.len() {
        return Err(format!("{} and {} components", x.len(), y.len()));
    }
    let products = x.iter().zip(y).map(|(x, y)| *x * *y);
    Ok(products.fold(Jet::ZERO, |sum, product| sum + product))
}
