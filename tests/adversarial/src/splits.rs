//! The events of a motion that is split into runs.

use core::ops::ControlFlow;

use lagrangian::{
    Driver, Dynamics, Event, Events, IntegrationMethod as _, MotionSeries, ObservationKind,
    Observer, Phase, Progress, Reaction, Resume, RungeKutta, State, StopCondition, StopReason,
    Taylor,
};

use crate::At;
use crate::at::Run;
use crate::evaluation::Found;
use crate::motions::{MAX_STEPS, dop853, list};

/// An index of those watched, and a time.
type Seen = Vec<(usize, f64)>;

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
            M: MotionSeries<N> + Events<N>,
        {
            let run = at.run();
            if run.name() != stringify!($name) {
                return Vec::new();
            }
            let dynamics = model.dynamics();
            let split = Split {
                dynamics: &dynamics,
                start: at.state::<N>(),
                run,
            };
            let driver = $method(run).driver().max_steps(MAX_STEPS);
            let seen = splits_by!(driver, split, model, $declared);
            vec![("events", seen.map(|seen| list(&seen)))]
        }
    )*};
    ($driver:ident, $split:ident, $model:ident, true) => {{
        $split.events(&$driver.declared_events($split.run.declared()))
    }};
    ($driver:ident, $split:ident, $model:ident, false) => {{
        let indices = $split.run.watched.map(|(index, _)| index);
        let closure = |t: f64, x: &Phase<f64, N>| {
            let values = $model.event_functions(&State::new(t, x.q, x.v));
            indices.map(|index| values.as_ref()[index])
        };
        $split.events(&$driver.events($split.run.events(), closure))
    }};
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
struct Split<'a, D: Dynamics<f64>> {
    dynamics: &'a D,
    start: lagrangian::At<f64, D::State>,
    run: &'a Run,
}

impl<D> Split<'_, D>
where
    D: Dynamics<f64, State: Clone>,
    D: Clone,
{
    /// The events of all runs, in the order in which they are reported.
    fn events<I, C>(&self, driver: &Driver<I, C>) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        match self.run.way.as_str() {
            "runs" => self.by_runs(driver),
            "stopped" => self.by_stops(driver),
            "limited" => self.by_limits(driver),
            "samples" => self.by_samples(driver),
            "advanced" => self.by_advances(driver),
            "resumed" => self.by_checkpoints(driver),
            "unchanged" => self.by_reactions(driver, Reaction::Unchanged),
            "changed" => self.by_reactions(driver, Reaction::Changed),
            other => panic!("`{other}` is no way to split a motion"),
        }
    }

    /// Each run begins from the last state of the one before.
    fn by_runs<I, C>(&self, driver: &Driver<I, C>) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        let (mut last, mut seen) = (self.start.clone(), Vec::new());
        for &time in &self.run.times {
            let motion = driver.clone().sample(self.dynamics, &last, &[time]);
            let motion = motion.map_err(|error| error.to_string())?;
            seen.extend(motion.events().iter().map(|e| (e.event, e.t)));
            last = motion.last().clone();
        }
        Ok(seen)
    }

    /// All events are terminal: a run ends at each, and the next begins there.
    fn by_stops<I, C>(&self, driver: &Driver<I, C>) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        let (mut last, mut seen) = (self.start.clone(), Vec::new());
        for &time in &self.run.times {
            for stops in 0.. {
                if stops > MAX_EVENTS {
                    return Err(format!("no end of events at t = {}", last.t));
                }
                let outcome = driver.clone().run_until(self.dynamics, &last, time);
                let outcome = outcome.map_err(|error| error.to_string())?;
                let met = outcome.met.indices();
                seen.extend(met.map(|index| (index, outcome.last.t)));
                last = outcome.last;
                if outcome.reason != StopReason::Condition {
                    break;
                }
            }
        }
        Ok(seen)
    }

    /// Runs of one, two, three, one, … steps.
    fn by_limits<I, C>(&self, driver: &Driver<I, C>) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        let (mut last, mut seen) = (self.start.clone(), Vec::new());
        for &time in &self.run.times {
            for runs in 0.. {
                // A few runs of few steps: a method with short steps needs many of those.
                let steps = if runs < MAX_EVENTS {
                    2 + runs % 3
                } else {
                    MAX_STEPS
                };
                let driver = driver.clone().max_steps(steps);
                let motion = driver.sample(self.dynamics, &last, &[time]);
                let motion = motion.map_err(|error| error.to_string())?;
                seen.extend(motion.events().iter().map(|e| (e.event, e.t)));
                last = motion.last().clone();
                if motion.reason() != StopReason::StepLimit {
                    break;
                }
            }
        }
        Ok(seen)
    }

    /// One run, with samples at these times.
    fn by_samples<I, C>(&self, driver: &Driver<I, C>) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        let motion = driver
            .clone()
            .sample(self.dynamics, &self.start, &self.run.times);
        let motion = motion.map_err(|error| error.to_string())?;
        Ok(motion.events().iter().map(|e| (e.event, e.t)).collect())
    }

    /// One integration in progress, advanced to each time.
    fn by_advances<I, C>(&self, driver: &Driver<I, C>) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        let mut seen = Vec::new();
        let driver = driver.clone().observe(Watch(&mut seen));
        let running = driver.start(self.dynamics, &self.start);
        let mut running = running.map_err(|error| error.to_string())?;
        for &time in &self.run.times {
            running
                .advance_to(time)
                .map_err(|error| error.to_string())?;
        }
        drop(running);
        Ok(seen)
    }

    /// Integrations that go on from the checkpoint of the one before.
    fn by_checkpoints<I, C>(&self, driver: &Driver<I, C>) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        let (mut seen, mut checkpoint) = (Vec::new(), None);
        for &time in &self.run.times {
            let driver = driver.clone().observe(Watch(&mut seen));
            let running = match checkpoint.take() {
                None => driver.start(self.dynamics, &self.start),
                Some(checkpoint) => driver.resume(self.dynamics, checkpoint),
            };
            let mut running = running.map_err(|error| error.to_string())?;
            running
                .advance_to(time)
                .map_err(|error| error.to_string())?;
            checkpoint = Some(running.checkpoint());
        }
        Ok(seen)
    }

    /// Each run reacts to its events, without a change of the state.
    fn by_reactions<I, C>(&self, driver: &Driver<I, C>, reaction: Reaction) -> Result<Seen, String>
    where
        I: Resume<f64, D> + Clone,
        C: StopCondition<f64, D> + Clone,
    {
        let (mut last, mut seen) = (self.start.clone(), Vec::new());
        let mut dynamics = self.dynamics.clone();
        for &time in &self.run.times {
            let react = |event, t, _: &mut D::State, _: &mut D| {
                seen.push((event, t));
                reaction
            };
            let driver = driver.clone();
            let outcome = driver.run_reacting(&mut dynamics, &last, time, react);
            last = outcome.map_err(|error| error.to_string())?.last;
        }
        Ok(seen)
    }
}

/// Far more than any motion here has.
const MAX_EVENTS: u64 = 200;

/// Notes events.
struct Watch<'a>(&'a mut Seen);

impl<X> Observer<X> for Watch<'_> {
    fn observe(&mut self, progress: &Progress<'_, X>) -> ControlFlow<()> {
        if let ObservationKind::Event(index) = progress.kind {
            self.0.push((index, progress.t));
        }
        ControlFlow::Continue(())
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

    /// The declared events that are watched for.
    fn declared(&self) -> [(usize, Event); 2] {
        let [first, second] = self.events();
        [(self.watched[0].0, first), (self.watched[1].0, second)]
    }

    /// What is watched for; terminal if the runs end at events.
    fn events(&self) -> [Event; 2] {
        self.watched.map(|(_, crossing)| {
            let event = Event::new(crossing);
            if self.way == "stopped" {
                event.terminal()
            } else {
                event
            }
        })
    }
}
