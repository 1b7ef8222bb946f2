//! `Debug` for errors by their messages, which `main`, `unwrap` and `expect` print.

use core::error::Error;
use core::fmt;

/// Writes the message of an error and, after colons, the messages of its sources.
pub(crate) fn write_message(error: &dyn Error, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    write!(f, "{error}")?;
    let mut source = error.source();
    while let Some(error) = source {
        write!(f, ": {error}")?;
        source = error.source();
    }
    Ok(())
}

/// Implements `Debug` for an error by its message.
macro_rules! debug_by_message {
    ($error:ty $(; $($parameters:tt)*)?) => {
        impl $(<$($parameters)*>)? core::fmt::Debug for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                crate::error_debug::write_message(self, f)
            }
        }
    };
}
pub(crate) use debug_by_message;

#[cfg(test)]
mod tests {
    use core::error::Error;
    use core::fmt;
    use std::format;

    use crate::IntegrationError;
    use crate::rigid_body::BodyError;

    #[test]
    fn an_error_is_shown_by_its_message() {
        let error = IntegrationError::InvalidStep { step: -1.0 };
        let message = "a step size must be positive and finite, not -1";
        assert_eq!(format!("{error}"), message);
        assert_eq!(format!("{error:?}"), message);
        assert_eq!(
            format!("{:?}", Err::<(), _>(error)),
            format!("Err({message})")
        );
        let error: &dyn Error = &BodyError::NotFinite {
            quantity: "the mass",
            value: f64::NAN,
        };
        assert_eq!(format!("{error:?}"), format!("{error}"));
    }

    /// An error caused by another error.
    struct Unread(fmt::Error);

    impl fmt::Display for Unread {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("the file could not be read")
        }
    }

    debug_by_message!(Unread);

    impl Error for Unread {
        fn source(&self) -> Option<&(dyn Error + 'static)> {
            Some(&self.0)
        }
    }

    #[test]
    fn sources_stand_behind_the_message() {
        let message = format!("the file could not be read: {}", fmt::Error);
        assert_eq!(format!("{:?}", Unread(fmt::Error)), message);
    }
}
