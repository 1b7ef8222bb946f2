//! Frames of reference, each turned against the one before it by one factor.

use std::collections::BTreeMap;

use crate::frames::factor::MatrixFactor;

/// A frame, by its position in the tree of frames.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Frame(usize);

impl Frame {
    /// The inertial frame.
    pub(crate) const INERTIAL: Self = Self(0);
}

/// All frames of a graph, from the inertial one on.
#[derive(Clone, Debug, Default)]
pub(crate) struct FrameTree {
    /// Each frame but the inertial one: the frame before it, and how it is turned against that.
    frames: Vec<(Frame, MatrixFactor)>,
    children: BTreeMap<(Frame, MatrixFactor), Frame>,
}

impl FrameTree {
    /// The frame with the rotation that is the product of these factors.
    pub(crate) fn frame(&mut self, factors: &[MatrixFactor]) -> Frame {
        let mut frame = Frame::INERTIAL;
        for factor in factors {
            let next = Frame(self.frames.len() + 1);
            let found = *self.children.entry((frame, *factor)).or_insert(next);
            if found == next {
                self.frames.push((frame, *factor));
            }
            frame = found;
        }
        frame
    }

    /// The frame before this one, with how this one is turned against it; none of the inertial frame.
    pub(crate) fn before(&self, frame: Frame) -> Option<(Frame, MatrixFactor)> {
        self.frames.get(frame.0.checked_sub(1)?).copied()
    }

    /// The frames that are turned against this one, each with its factor, in the order of their declaration.
    pub(crate) fn behind(&self, frame: Frame) -> Vec<(Frame, MatrixFactor)> {
        let all = (1..).map(Frame).zip(&self.frames);
        let children = all.filter(|(_, (before, _))| *before == frame);
        children
            .map(|(next, (_, factor))| (next, *factor))
            .collect()
    }

    /// The frames from the first one behind the inertial frame to this one, each with its factor.
    pub(crate) fn path(&self, frame: Frame) -> Vec<(Frame, MatrixFactor)> {
        let mut path = Vec::new();
        let mut frame = frame;
        while let Some((before, factor)) = self.before(frame) {
            path.push((frame, factor));
            frame = before;
        }
        path.reverse();
        path
    }

    /// How many factors a frame's rotation has.
    pub(crate) fn depth(&self, frame: Frame) -> usize {
        core::iter::successors(self.before(frame), |(before, _)| self.before(*before)).count()
    }

    /// The factors of a frame's rotation.
    pub(crate) fn factors(&self, frame: Frame) -> Vec<MatrixFactor> {
        let path = self.path(frame).into_iter();
        path.map(|(_, factor)| factor).collect()
    }

    /// The last frame through which the paths to all of these lead.
    pub(crate) fn last_in_common(&self, frames: impl IntoIterator<Item = Frame>) -> Frame {
        let mut paths = frames.into_iter().map(|frame| self.path(frame));
        let Some(mut common) = paths.next() else {
            return Frame::INERTIAL;
        };
        for path in paths {
            let length = common.iter().zip(&path).take_while(|(x, y)| x == y).count();
            common.truncate(length);
        }
        common.last().map_or(Frame::INERTIAL, |(frame, _)| *frame)
    }

    /// The frames that are turned against inertial axes by at most so many factors, with these, in the order of their
    /// declaration.
    pub(crate) fn nearest(&self, most: usize) -> Vec<(Frame, Vec<MatrixFactor>)> {
        let frames = (1..=self.frames.len()).map(Frame);
        let frames = frames.map(|frame| (frame, self.factors(frame)));
        frames
            .filter(|(_, factors)| factors.len() <= most)
            .collect()
    }
}
