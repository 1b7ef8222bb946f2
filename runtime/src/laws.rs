//! Laws, which set the inputs of a model along its motion.
//!
//! Programs rarely name these types: [`Problem`](crate::Problem) constructs them by `feedback`, `feedback_with_states`,
//! `sampled_feedback`, `driven_by` and `lagged`. Custom laws are types that implement [`Law`].

pub use crate::model::{
    Driven, DynamicFeedback, Feedback, Held, Lagged, Law, LawSeries, LawStates, LawsInLanes,
    Sampled, SampledFeedback, StatesInLanes,
};
