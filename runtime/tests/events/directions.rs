//! The directions in which tests watch for an event.

/// A direction that a test goes through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Direction {
    Either,
    Rising,
    Falling,
}

pub(crate) const EVERY: [Direction; 3] = [Direction::Either, Direction::Rising, Direction::Falling];

/// An event of a problem, in a direction.
macro_rules! directed {
    ($direction:expr, $event:expr) => {{
        let event = $event;
        match $direction {
            $crate::directions::Direction::Either => event,
            $crate::directions::Direction::Rising => event.rising(),
            $crate::directions::Direction::Falling => event.falling(),
        }
    }};
}

pub(crate) use directed;
