//! Two lists of conditions and events that are numbered together: the second list is numbered after the
//! first.

use super::memory::Remembers;
use super::met_conditions::MetConditions;
use super::one_signed::OneSigned;
use super::{Detection, LastStep, Occurring};
use crate::integrate::at::At;
use crate::integrate::checkpoint::EventSigns;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::Advance;
use crate::scalar::Scalar;

/// What is known about the events of both lists.
#[derive(Clone, Copy, Debug)]
pub struct BothMemories<A, B> {
    first: A,
    second: B,
    /// The events of each list that were found but not yet processed.
    pending: [Option<Occurring>; 2],
    /// The number of conditions and events in the first list.
    count: usize,
}

impl<A: Remembers, B: Remembers> Remembers for BothMemories<A, B> {
    fn event_signs(&self) -> EventSigns {
        let [first, second] = [self.first.event_signs(), self.second.event_signs()];
        first.followed_by(second, self.count)
    }

    fn recalled(self, stored: EventSigns) -> Self {
        Self {
            first: self.first.recalled(stored),
            second: self.second.recalled(stored.behind(self.count)),
            ..self
        }
    }

    fn goes_on(&self, t: f64, end: f64) -> bool {
        self.first.goes_on(t, end) && self.second.goes_on(t, end)
    }
}

impl Occurring {
    /// Returns the events of the first and of the second list.
    fn split(self, count: usize) -> [Option<Self>; 2] {
        let sets = [self.events.before(count), self.events.behind(count)];
        sets.map(|events| Some(Self { events, ..self }).filter(|part| part.events.any()))
    }

    /// Converts the numbers of events in the second list to their numbers in both.
    fn shifted(self, count: usize) -> Self {
        Self {
            events: self.events.shifted(count),
            ..self
        }
    }
}

impl<S, D, A, B> Detection<S, D> for (A, B)
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    A: Detection<S, D>,
    B: Detection<S, D>,
{
    type Memory = BothMemories<A::Memory, B::Memory>;

    const COUNT: usize = {
        let count = A::COUNT + B::COUNT;
        assert!(
            count <= MetConditions::MAX,
            "at most 64 conditions and events at a time"
        );
        count
    };

    fn check(&self, dynamics: &D) -> Result<(), IntegrationError> {
        self.0.check(dynamics)?;
        self.1.check(dynamics)
    }

    fn holding(&mut self, t: f64, x: &D::State) -> MetConditions {
        let second = self.1.holding(t, x).shifted(A::COUNT);
        self.0.holding(t, x).or(second)
    }

    fn is_terminal(&self, event: usize) -> bool {
        match event.checked_sub(A::COUNT) {
            Some(event) => self.1.is_terminal(event),
            None => self.0.is_terminal(event),
        }
    }

    fn declared(&self, event: usize) -> Option<usize> {
        match event.checked_sub(A::COUNT) {
            Some(event) => self.1.declared(event),
            None => self.0.declared(event),
        }
    }

    fn function(&mut self, dynamics: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        match event.checked_sub(A::COUNT) {
            Some(event) => self.1.function(dynamics, t, x, event),
            None => self.0.function(dynamics, t, x, event),
        }
    }

    fn begin(&mut self, dynamics: &D, t: f64, x: &D::State) -> Self::Memory {
        BothMemories {
            first: self.0.begin(dynamics, t, x),
            second: self.1.begin(dynamics, t, x),
            pending: [None; 2],
            count: A::COUNT,
        }
    }

    fn watched_functions(&self, dynamics: &D) -> MetConditions {
        let second = self.1.watched_functions(dynamics);
        self.0.watched_functions(dynamics).or(second)
    }

    #[inline]
    fn passes_over(
        &mut self,
        memory: &mut Self::Memory,
        dynamics: &D,
        step: [f64; 2],
        one_signed: OneSigned,
    ) -> bool {
        // A list that has passed over the step finds nothing when the step is examined for the other one.
        let first = self
            .0
            .passes_over(&mut memory.first, dynamics, step, one_signed);
        let second = self
            .1
            .passes_over(&mut memory.second, dynamics, step, one_signed);
        first && second
    }

    /// Returns the events that come first. Events of both lists within the resolution of time occur together, at the
    /// later of their times, at which all of them have occurred.
    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring> {
        let [first, second] = &mut memory.pending;
        *first = first.or_else(|| self.0.next(&mut memory.first, step));
        *second = second.or_else(|| self.1.next(&mut memory.second, step));
        let pending = (*first, second.map(|second| second.shifted(A::COUNT)));
        let (Some(early), Some(late)) = pending else {
            memory.pending = [None; 2];
            return pending.0.or(pending.1);
        };
        let is_in_order = !step.comes_before(late.t, early.t);
        let (early, late) = if is_in_order {
            (early, late)
        } else {
            (late, early)
        };
        if !step.comes_before(step.after(early.t), late.t) {
            memory.pending = [None; 2];
            self.occur_at(memory, step, late.t);
            return Some(Occurring {
                t: late.t,
                events: early.events.or(late.events),
            });
        }
        memory.pending[usize::from(!is_in_order)] = None;
        Some(early)
    }

    fn occur_at<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
        t: f64,
    ) {
        self.0.occur_at(&mut memory.first, step, t);
        self.1.occur_at(&mut memory.second, step, t);
    }

    fn close<T: Advance<S, D>>(
        &mut self,
        memory: &mut Self::Memory,
        step: &mut LastStep<'_, S, D, T>,
        here: &At<f64, D::State>,
        pending: Option<Occurring>,
    ) -> MetConditions {
        let count = A::COUNT;
        let [first, second] = pending.map_or([None; 2], |pending| pending.split(count));
        let [own_first, own_second] = core::mem::take(&mut memory.pending);
        let [first, second] = [first.or(own_first), second.or(own_second)];
        let first = self.0.close(&mut memory.first, step, here, first);
        let second = self.1.close(&mut memory.second, step, here, second);
        first.or(second.shifted(count))
    }

    fn restart(
        &mut self,
        memory: &mut Self::Memory,
        dynamics: &D,
        occurring: Occurring,
        x: &D::State,
        step: f64,
    ) -> MetConditions {
        let none = |part: Option<Occurring>| {
            part.unwrap_or(Occurring {
                t: occurring.t,
                events: MetConditions::default(),
            })
        };
        let count = A::COUNT;
        let [first, second] = occurring.split(count).map(none);
        memory.pending = [None; 2];
        let first = (self.0).restart(&mut memory.first, dynamics, first, x, step);
        let second = (self.1).restart(&mut memory.second, dynamics, second, x, step);
        first.or(second.shifted(count))
    }
}
