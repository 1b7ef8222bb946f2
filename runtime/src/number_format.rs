//! The format of numbers in messages.

use core::fmt;

use crate::limits::PRINTED_WITHOUT_EXPONENT;

/// A number in a message, without an exponent if it is easy to read.
pub(crate) struct Readable(pub(crate) f64);

impl fmt::Display for Readable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = self;
        let size = value.abs();
        if size == 0.0 || PRINTED_WITHOUT_EXPONENT.contains(&size) || !size.is_finite() {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// Writes names with their values, such as `a = 1, b = 2`, and how many more there are.
pub(crate) fn write_values<'a>(
    f: &mut fmt::Formatter<'_>,
    relation: &str,
    values: impl Iterator<Item = (&'a str, f64)>,
    left_out: usize,
) -> fmt::Result {
    for (i, (name, value)) in values.enumerate() {
        let separator = if i == 0 { "" } else { ", " };
        write!(f, "{separator}{name} {relation} {}", Readable(value))?;
    }
    if left_out > 0 {
        write!(f, " and {left_out} more")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::Readable;

    #[test]
    fn numbers_are_written_as_they_are_read() {
        let written = [0.0, 0.5, 123_456.0, 1.75e-9, -2e10, f64::INFINITY]
            .map(|value| std::format!("{}", Readable(value)));
        assert_eq!(written, ["0", "0.5", "123456", "1.75e-9", "-2e10", "inf"]);
    }
}
