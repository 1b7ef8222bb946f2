//! The events of a motion that is split into runs.

use core::cell::RefCell;

use lagrangian::problem::{End, Watched};
use lagrangian::quantities::{Events, MotionSeries};
use lagrangian::{
    Dynamics, Lagrangian, ObservationKind, Partial, Phase, Problem, Progress, Resume, RungeKutta,
    Solution, State, StopReason, Taylor,
};

use crate::At;
use crate::at::Run;
use crate::evaluation::Found;
use crate::motions::{Failure, MAX_STEPS, dop853, list};

/// An index of those watched, and a time.
type Seen = Vec<(usize, f64)>;

/// The problem from a state on in which both events are watched for, and what happens at each, by its number.
macro_rules! watched {
    ($declared:tt, $model:ident, $run:ident, $i:ident, $happens:ident($($reaction:expr)?)) => {
        |start: State<f64, N>| {
            let problem = Problem::new($model, start).max_steps(MAX_STEPS);
            let $i = 0;
            let problem = watched!($declared, problem, $model, $run, $i).$happens($($reaction)?);
            let $i = 1;
            watched!($declared, problem, $model, $run, $i).$happens($($reaction)?)
        }
    };
    ($declared:tt, $problem:ident, $model:ident, $run:ident, $i:ident) => {{
        let (index, direction) = $run.watched[$i];
        let event = watched!($declared, $problem, $model, index);
        match direction {
            sign if sign > 0.0 => event.rising(),
            sign if sign < 0.0 => event.falling(),
            _ => event,
        }
    }};
    (true, $problem:ident, $model:ident, $index:ident) => {
        $problem.on(lagrangian::DeclaredEvent::new($index))
    };
    (false, $problem:ident, $model:ident, $index:ident) => {
        $problem.when(move |x: &State<f64, N>| $model.event_functions(x).as_ref()[$index])
    };
}

/// The events of the runs of a motion under these methods, watched for as declared events or by a closure.
macro_rules! splits_by {
    ($($name:ident, $method:expr, $declared:tt;)*) => {$(
        #[doc = concat!("The events of the runs of a motion: ", stringify!($name), ".")]
        ///
        /// # Panics
        ///
        /// If the state says nothing of runs.
        #[must_use]
        pub fn $name<M, const N: usize>(model: &M, at: &At) -> Vec<Found>
        where
            M: Lagrangian<N, Model: MotionSeries<N> + Events<N>>,
        {
            let run = at.run();
            if run.name() != stringify!($name) {
                return Vec::new();
            }
            let (method, start) = ($method(run), at.state::<N>());
            let split = Split { method, start, run };
            // What the reactions of the ways that have some are called for.
            let seen = RefCell::new(Seen::new());
            let note = |event, t| seen.borrow_mut().push((event, t));
            let called = |runs: Result<Seen, Failure>| runs.map(|_| seen.take());
            let found = match run.way.as_str() {
                "unchanged" => {
                    let problem = watched!($declared, model, run, i, then(move |x| note(i, x.t)));
                    called(split.by_runs(|start, end| problem(start).solve(end, method)))
                }
                "changed" => {
                    let problem = watched!($declared, model, run, i, then_with(move |x, _| note(i, x.t)));
                    called(split.by_runs(|start, end| problem(start).solve(end, method)))
                }
                "stopped" => split.events(watched!($declared, model, run, i, stop())),
                _ => split.events(watched!($declared, model, run, i, record())),
            };
            let found = found.map_err(|error| error.to_string());
            vec![("events", found.map(|seen| list(&seen)))]
        }
    )*};
}

splits_by! {
    taylor_declared, |_: &Run| Taylor::new(), true;
    taylor_sampled, |_: &Run| Taylor::new(), false;
    dop853_declared, |run: &Run| dop853().max_step(run.step), true;
    dop853_sampled, |run: &Run| dop853().max_step(run.step), false;
    runge_kutta_declared, |run: &Run| RungeKutta::classical(run.step), true;
    runge_kutta_sampled, |run: &Run| RungeKutta::classical(run.step), false;
}

/// A motion, and how it is split.
struct Split<'a, I, const N: usize> {
    method: I,
    start: State<f64, N>,
    run: &'a Run,
}

type Solved<const N: usize> = Solution<f64, Phase<f64, N>>;

impl<I: Copy, const N: usize> Split<'_, I, N> {
    /// The events of all runs, in the order in which they are reported.
    fn events<D, C>(
        &self,
        problem: impl Fn(State<f64, N>) -> Problem<f64, D, End, C>,
    ) -> Result<Seen, Failure>
    where
        D: Dynamics<f64, State = Phase<f64, N>>,
        I: Resume<f64, D>,
        C: Watched<f64, D>,
    {
        let method = self.method;
        match self.run.way.as_str() {
            "runs" => self.by_runs(|start, end| problem(start).solve(end, method)),
            "stopped" => self.by_stops(|start, end| problem(start).solve(end, method)),
            "limited" => self
                .by_limits(|start, end, steps| problem(start).max_steps(steps).solve(end, method)),
            "samples" => self.by_samples(problem(self.start)),
            "advanced" => self.by_advances(problem(self.start)),
            "resumed" => self.by_checkpoints(|| problem(self.start)),
            other => panic!("`{other}` is no way to split a motion"),
        }
    }

    /// Each run begins from the last state of the one before.
    fn by_runs(
        &self,
        run: impl Fn(State<f64, N>, f64) -> Result<Solved<N>, Partial<Solved<N>>>,
    ) -> Result<Seen, Failure> {
        let (mut last, mut seen) = (self.start, Vec::new());
        for &time in &self.run.times {
            let motion = run(last, time)?;
            seen.extend(motion.events().iter().map(|e| (e.event, e.t)));
            last = motion.last;
        }
        Ok(seen)
    }

    /// All events are terminal: a run ends at each, and the next begins there.
    fn by_stops(
        &self,
        run: impl Fn(State<f64, N>, f64) -> Result<Solved<N>, Partial<Solved<N>>>,
    ) -> Result<Seen, Failure> {
        let (mut last, mut seen) = (self.start, Vec::new());
        for &time in &self.run.times {
            for stops in 0.. {
                if stops > MAX_EVENTS {
                    return Err(Failure::Stop(StopReason::Condition, last.t));
                }
                let motion = run(last, time)?;
                seen.extend(motion.met.indices().map(|index| (index, motion.t)));
                last = motion.last;
                if motion.reason != StopReason::Condition {
                    break;
                }
            }
        }
        Ok(seen)
    }

    /// Runs of one, two, three, one, … steps.
    fn by_limits(
        &self,
        run: impl Fn(State<f64, N>, f64, u64) -> Result<Solved<N>, Partial<Solved<N>>>,
    ) -> Result<Seen, Failure> {
        let (mut last, mut seen) = (self.start, Vec::new());
        for &time in &self.run.times {
            for runs in 0.. {
                // A few runs of few steps: a method with short steps needs many of those.
                let steps = if runs < MAX_EVENTS {
                    2 + runs % 3
                } else {
                    MAX_STEPS
                };
                let motion = run(last, time, steps)?;
                seen.extend(motion.events().iter().map(|e| (e.event, e.t)));
                last = motion.last;
                if motion.reason != StopReason::StepLimit {
                    break;
                }
            }
        }
        Ok(seen)
    }

    /// One run, with samples at these times.
    fn by_samples<D, C>(&self, problem: Problem<f64, D, End, C>) -> Result<Seen, Failure>
    where
        D: Dynamics<f64, State = Phase<f64, N>>,
        I: Resume<f64, D>,
        C: Watched<f64, D>,
    {
        let times = &self.run.times;
        let problem = problem.save(times);
        let motion = problem.solve(times[times.len() - 1], self.method)?;
        Ok(motion.events().iter().map(|e| (e.event, e.t)).collect())
    }

    /// One integration in progress, advanced to each time.
    fn by_advances<D, C>(&self, problem: Problem<f64, D, End, C>) -> Result<Seen, Failure>
    where
        D: Dynamics<f64, State = Phase<f64, N>>,
        I: Resume<f64, D>,
        C: Watched<f64, D>,
    {
        let mut seen = Vec::new();
        let problem = problem.each_step(|progress| seen.extend(noted(progress)));
        let mut run = problem.start(self.method)?;
        for &time in &self.run.times {
            run.advance(time)?;
        }
        drop(run);
        Ok(seen)
    }

    /// Integrations that go on from the checkpoint of the one before.
    fn by_checkpoints<D, C>(
        &self,
        problem: impl Fn() -> Problem<f64, D, End, C>,
    ) -> Result<Seen, Failure>
    where
        D: Dynamics<f64, State = Phase<f64, N>>,
        I: Resume<f64, D>,
        C: Watched<f64, D>,
    {
        let (mut seen, mut checkpoint) = (Vec::new(), None);
        for &time in &self.run.times {
            let problem = problem().each_step(|progress| seen.extend(noted(progress)));
            let mut run = match checkpoint.take() {
                None => problem.start(self.method)?,
                Some(checkpoint) => problem.resume(checkpoint, self.method)?,
            };
            run.advance(time)?;
            checkpoint = Some(run.checkpoint());
        }
        Ok(seen)
    }
}

/// Far more than any motion here has.
const MAX_EVENTS: u64 = 200;

/// The event at which an observer is called.
fn noted<X>(progress: &Progress<'_, X>) -> Option<(usize, f64)> {
    match progress.kind {
        ObservationKind::Event(index) => Some((index, progress.t)),
        _ => None,
    }
}

impl Run {
    /// The method, and whether it watches for declared events or samples a closure.
    fn name(&self) -> String {
        let watched = if self.is_declared {
            "declared"
        } else {
            "sampled"
        };
        format!("{}_{watched}", self.method)
    }
}
