//! The messages of errors in tables.

/// Implements `Display` for an error by a table of its variants and their messages, `Debug` by these messages, and `Error`. A row is a
/// pattern, a format string and its arguments; generic parameters stand in brackets before the type.
macro_rules! error_messages {
    ([$($generics:tt)*] $error:ty: $(
        $variant:pat $(if $condition:expr)? => $message:literal $(, $argument:expr)*;
    )+) => {
        impl<$($generics)*> core::fmt::Display for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match *self {
                    $($variant $(if $condition)? => write!(f, $message $(, $argument)*),)+
                }
            }
        }

        $crate::error_debug::debug_by_message! { $error; $($generics)* }

        impl<$($generics)*> core::error::Error for $error {}
    };
    ($error:ty: $($rows:tt)+) => {
        $crate::error_messages::error_messages! { [] $error: $($rows)+ }
    };
}
pub(crate) use error_messages;
