//! What is kept of the members: motions, rows of numbers, statistics.

use crate::column::Column;
use crate::error::Error;
use crate::members::{Found, Members};
use crate::motion::{Failure, Motion};
use crate::points::Points;
use crate::rows::Rows;
use crate::summary::Summary;
use crate::table::Table;
use crate::workers::{Entries, Sink};

/// The type of the points of members.
pub(crate) type PointOf<M> = <<M as Members>::Points as Points>::Point;

/// A motion, or a failure.
pub(crate) type Ended<M> = Result<
    Motion<PointOf<M>, <M as Members>::State, <M as Members>::Kept>,
    Failure<PointOf<M>, <M as Members>::State, <M as Members>::Kept>,
>;

/// Adds its index and its point to the result of a member.
fn identify<M: Members>(members: &M, index: usize, found: Found<M::State, M::Kept>) -> Ended<M> {
    let points = members.points();
    let point = points.point(index);
    match found {
        Ok(solution) => Ok(Motion {
            index,
            point,
            solution,
        }),
        Err(partial) => Err(Failure {
            index,
            parameters: points
                .columns()
                .into_iter()
                .zip(points.values(&point))
                .collect(),
            point,
            partial,
        }),
    }
}

/// Keeps all motions.
pub(crate) struct Motions;

impl<M: Members> Sink<M> for Motions {
    type Entry = Ended<M>;
    type Part = Vec<Ended<M>>;

    fn entry(&self, members: &M, index: usize, found: Found<M::State, M::Kept>) -> Self::Entry {
        identify(members, index, found)
    }

    fn part(&self, _: usize, entries: Entries<Self::Entry>) -> Result<Self::Part, Error> {
        Ok(entries.entries)
    }
}

/// Keeps rows of numbers.
pub(crate) struct Tables<F, const N: usize> {
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: F,
}

/// The rows of a member.
pub(crate) struct MemberRows<B> {
    index: usize,
    /// The values of the point.
    values: Vec<f64>,
    /// The rows, or why there are none.
    rows: Result<B, String>,
}

impl<M, F, B, const N: usize> Sink<M> for Tables<F, N>
where
    M: Members,
    F: Fn(&Motion<PointOf<M>, M::State, M::Kept>) -> B + Sync,
    B: Rows<N>,
{
    type Entry = MemberRows<B>;
    type Part = Table;

    fn entry(&self, members: &M, index: usize, found: Found<M::State, M::Kept>) -> Self::Entry {
        let values = |point| members.points().values(point);
        match identify(members, index, found) {
            Ok(motion) => MemberRows {
                index,
                values: values(&motion.point),
                rows: Ok((self.rows)(&motion)),
            },
            Err(failure) => MemberRows {
                index,
                values: values(&failure.point),
                rows: Err(failure.to_string()),
            },
        }
    }

    fn part(
        &self,
        _: usize,
        Entries { entries, .. }: Entries<Self::Entry>,
    ) -> Result<Table, Error> {
        let mut table = Table::new(self.columns.clone());
        table.count(entries.len());
        for member in entries {
            let MemberRows {
                index,
                values,
                rows,
            } = member;
            match rows {
                Ok(rows) => {
                    for row in rows.rows() {
                        table.add_row(index, values.iter().chain(row).copied());
                    }
                }
                Err(message) => {
                    table.add_row(index, values);
                    table.add_failure(index, message);
                }
            }
        }
        Ok(table)
    }
}

/// Keeps the statistics of rows of numbers.
pub(crate) struct Summaries<K>(pub(crate) K);

impl<M: Members, K: Sink<M, Part = Table>> Sink<M> for Summaries<K> {
    type Entry = K::Entry;
    type Part = Summary;

    fn entry(&self, members: &M, index: usize, found: Found<M::State, M::Kept>) -> Self::Entry {
        self.0.entry(members, index, found)
    }

    fn part(&self, chunk: usize, entries: Entries<Self::Entry>) -> Result<Summary, Error> {
        Ok(self.0.part(chunk, entries)?.summary())
    }
}
