//! Serialization of arrays of any length; serde itself supports lengths up to 32.

use core::{fmt, marker::PhantomData};

use serde::de::{Error, SeqAccess, Visitor};
use serde::ser::SerializeTuple;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

pub(crate) fn serialize<S, T, const N: usize>(
    array: &[T; N],
    serializer: S,
) -> Result<S::Ok, S::Error>
where
    S: Serializer,
    T: Serialize,
{
    let mut tuple = serializer.serialize_tuple(N)?;
    for element in array {
        tuple.serialize_element(element)?;
    }
    tuple.end()
}

pub(crate) fn deserialize<'de, D, T, const N: usize>(deserializer: D) -> Result<[T; N], D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de> + Clone,
{
    deserializer.deserialize_tuple(N, Elements(PhantomData))
}

/// A visitor for the elements of an array, one after the other.
struct Elements<T, const N: usize>(PhantomData<T>);

impl<'de, T, const N: usize> Visitor<'de> for Elements<T, N>
where
    T: Deserialize<'de> + Clone,
{
    type Value = [T; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "an array of {N} elements")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<[T; N], A::Error> {
        let missing = |index: usize| A::Error::invalid_length(index, &self);
        let first: T = elements.next_element()?.ok_or_else(|| missing(0))?;
        let mut array = core::array::from_fn(|_| first.clone());
        for (index, place) in array.iter_mut().enumerate().skip(1) {
            *place = elements.next_element()?.ok_or_else(|| missing(index))?;
        }
        Ok(array)
    }
}
