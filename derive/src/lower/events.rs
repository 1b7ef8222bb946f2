//! What events may be.

use lagrangian_symbolic::Value;

use crate::lower::expression::Lowerer;
use crate::syntax::named::NamedExpression;
use crate::syntax::shape::Shape;

impl Lowerer<'_> {
    /// An event is a scalar or a vector that can change.
    pub(super) fn check_events(&mut self, events: &[NamedExpression], values: &[Option<Value>]) {
        for (event, value) in events.iter().zip(values) {
            let shape = value.map(|value| self.shape(value));
            if let Some(shape @ Shape::Array { columns: 2.., .. }) = shape {
                let message = format!(
                    "this is {shape}, and an event is a scalar, or several as a vector: write one of its \
                     components or columns"
                );
                self.diagnostics.error(&event.expression, message);
                continue;
            }
            let components = value.iter().flat_map(|value| self.elements(*value));
            let constant = components
                .filter(|component| !self.graph().contents(**component).varies_in_motion())
                .count();
            if constant > 0 {
                self.diagnostics.error(
                    &event.expression,
                    "this depends neither on the motion nor on time or inputs, so that it never changes its sign: write \
                     a function of coordinates, velocities, time or inputs",
                );
            }
        }
    }
}
