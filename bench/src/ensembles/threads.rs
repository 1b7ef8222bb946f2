//! Two threads of one study beside two processes of one core each.

use lagrangian_bench::{Question, Throughput};

use super::{END, Sheet, Tuned};
use crate::contest::Entry;
use crate::contestant::Contestant;
use crate::verdict::Verdict;

/// The seconds for which motions are counted, at least one whole ensemble: short enough for moments in which the machine is
/// quiet.
const COUNTED: f64 = 0.5;

/// The part of the motions of two processes that two threads may miss.
const MISSED: f64 = 0.05;

/// Motions a second by the clock.
#[derive(Clone, Copy, Debug, Default)]
struct Fastest {
    /// Of one process alone.
    alone: f64,
    /// Of two processes side by side, together.
    processes: f64,
    /// Of a study on two threads.
    threads: f64,
}

impl Sheet {
    /// How many motions our best method completes in a second by the clock: in one process, in two at the same time, and
    /// in a study on two threads. They are measured in turn, and the fastest round of each counts. All keep the final
    /// states, which have the same bits.
    pub(super) fn by_the_clock(
        &mut self,
        best: &Tuned,
        verdicts: &mut Vec<Verdict>,
    ) -> Result<(), String> {
        let mut beside = self.built.start()?;
        let entry = |method: &str| {
            Entry::new(best.side, method, &self.starts, END).with_tolerance(best.tolerance)
        };
        let alone = entry(&best.method).integration;
        let study = entry(&format!("{}, two threads", best.method)).integration;
        let ours = &mut self.contestants[best.side];
        if ours.integrate(&alone)?.states != beside.integrate(&study)?.states {
            return Err(format!("{}: a study ends elsewhere", self.model));
        }
        let [alone, study] = [alone, study].map(|integration| {
            Question::Throughput(Throughput {
                integration,
                seconds: COUNTED,
            })
        });
        let mut fastest = Fastest::default();
        for _ in 0..10 * self.rounds.least {
            fastest.alone = fastest.alone.max(ours.ask(&alone)?);
            let both = side_by_side([&mut *ours, &mut beside], &alone)?;
            fastest.processes = fastest.processes.max(both);
            fastest.threads = fastest.threads.max(ours.ask(&study)?);
        }
        let part = fastest.threads / fastest.processes;
        println!(
            "  motions a second by the clock: one process {:.0}, two processes {:.0}, a study on two threads {:.0}, {part:.3} of these",
            fastest.alone, fastest.processes, fastest.threads
        );
        verdicts.push(Verdict {
            what: format!(
                "{}, part that two threads miss of two processes",
                self.model
            ),
            figure: 1.0 - part,
            target: MISSED,
            limit: MISSED,
        });
        Ok(())
    }
}

/// The sum of what contestants that work at the same time complete in a second.
fn side_by_side(contestants: [&mut Contestant; 2], question: &Question) -> Result<f64, String> {
    let mut sum = 0.0;
    let [one, other] = contestants;
    one.send(question)?;
    other.send(question)?;
    for contestant in [one, other] {
        sum += contestant.receive::<f64>()?;
    }
    Ok(sum)
}
