//! Laws, which set the inputs of a model along its motion.
//!
//! Programs name few of these: [`Problem`](crate::Problem) makes them by `feedback`, `feedback_with_states`, `sampled_feedback`,
//! `driven_by` and `lagged`. A type that implements [`Law`] is a law of its own.

pub use crate::model::{
    Driven, DynamicFeedback, Feedback, Held, Lagged, Law, LawSeries, LawStates, LawsInLanes,
    Sampled, SampledFeedback, StatesInLanes,
};
