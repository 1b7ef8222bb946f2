//! Many motions of a model whose parameters and initial states differ.

use std::fmt::Debug;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use lagrangian::problem::{EnsembleIntegrator, Keep, Observer, Reactions, Watched};
use lagrangian::quantities::Reflect;
use lagrangian::{At, Dynamics, ObservationKind, Phase, Problem, Progress, State};
use lagrangian_ensembles::Study;

use crate::integrated::{Found, Reached, found};
use crate::method::Settings;
use crate::watch::Watch;

/// What is asked of many motions.
#[derive(Debug)]
pub struct Ensemble {
    /// The numbers of the fields of each model.
    pub models: Vec<Vec<f64>>,
    /// The initial states.
    pub starts: Vec<Reached>,
    /// The final time.
    pub until: f64,
    /// The times of samples.
    pub samples: Vec<f64>,
    /// The method.
    pub settings: Settings,
    /// What is done at events.
    pub watch: Watch,
    /// The number of threads; 0 for one on each core.
    pub threads: usize,
    /// Whether the members end as soon as possible.
    pub cancelled: AtomicBool,
}

/// A member of an ensemble.
#[derive(Clone, Debug)]
pub struct MemberMotion {
    /// The samples.
    pub samples: Vec<Reached>,
    /// The events.
    pub events: Vec<Found>,
    /// The last state.
    pub end: Reached,
    /// The message of the error that ended it.
    pub error: Option<String>,
}

/// The members, in order.
pub type EnsembleMotions = Vec<MemberMotion>;

impl Ensemble {
    /// The models.
    ///
    /// # Errors
    ///
    /// The message for the first one whose numbers describe no body.
    pub fn models<M: Reflect<N>, const N: usize>(&self) -> Result<Vec<M>, String> {
        let models = self.models.iter().enumerate();
        let models = models.map(|(member, numbers)| {
            M::from_numbers(numbers).map_err(|error| format!("member {member}: {error:?}"))
        });
        models.collect()
    }

    /// The initial state of a member.
    #[must_use]
    pub fn start<const N: usize>(&self, member: usize) -> State<f64, N> {
        let missing = || State::new(f64::NAN, [f64::NAN; N], [f64::NAN; N]);
        self.starts
            .get(member)
            .map_or_else(missing, |start| start.instant().state())
    }

    /// Ends a motion at the events that stop it, or if the ensemble is cancelled.
    pub fn flow<X>(&self, progress: &Progress<'_, X>) -> ControlFlow<()> {
        if self.cancelled.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        match progress.kind {
            ObservationKind::Event(event) if self.watch.stops_at(event) => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    }

    /// Integrates all members by a method.
    ///
    /// # Errors
    ///
    /// The message of the study.
    pub fn solve<D, C, R, O, I, Z, const N: usize>(
        &self,
        problem: impl Fn(usize) -> Problem<f64, D, Vec<f64>, C, R, O> + Sync,
        method: I,
    ) -> Result<EnsembleMotions, String>
    where
        D: Dynamics<f64, State = Phase<f64, N, Z>>,
        Z: Send,
        I: EnsembleIntegrator<f64, D, 4> + Debug + Sync,
        C: Watched<f64, D>,
        R: Reactions<f64, D>,
        O: Observer<D::State>,
        Vec<f64>: Keep<f64, D, I::Stepper, Kept = Vec<At<f64, D::State>>>,
    {
        let study = Study::new(0..self.starts.len(), problem, self.until, method);
        let motions = study
            .threads(self.threads.min(self.starts.len()).min(MAX_THREADS))
            .solve();
        let motions = motions.map_err(|error| error.to_string())?;
        let motions = motions.into_iter().map(|motion| {
            let (solution, error) = match &motion {
                Ok(motion) => (&motion.solution, None),
                Err(failure) => (
                    failure.partial.solution(),
                    Some(failure.error().to_string()),
                ),
            };
            MemberMotion {
                samples: solution.samples().iter().map(Reached::of).collect(),
                events: found(solution.events(), &self.watch),
                end: Reached::of(&solution.last),
                error,
            }
        });
        Ok(motions.collect())
    }
}

/// More threads than a computer has cores gain nothing.
const MAX_THREADS: usize = 256;
