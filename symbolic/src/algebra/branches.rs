//! Where functions have branches: |u| at u = 0, max(u, v) at u = v.

use crate::{Binary, Expression, Graph, Node, Unary};

impl Graph {
    /// The expressions at whose zeros the roots may have a corner or a jump: u for |u| and sgn u, u − v for min(u, v) and
    /// max(u, v), y for the angle of the point (x, y). Those that depend on parameters alone have none, and external
    /// functions are taken as smooth.
    ///
    /// Between two zeros of all of them the roots are analytic, as far as the functions in them are.
    #[must_use]
    pub fn branch_arguments(&mut self, roots: &[Expression]) -> Vec<Expression> {
        let mut arguments = Vec::new();
        for expression in self.descendants(roots) {
            let argument = match *self.node(expression) {
                Node::Unary(Unary::Abs | Unary::Signum, x) | Node::Binary(Binary::Atan2, x, _) => x,
                Node::Binary(Binary::Min | Binary::Max, x, y) => self.subtract(x, y),
                _ => continue,
            };
            if self.contents(argument).varies_in_time() && !arguments.contains(&argument) {
                arguments.push(argument);
            }
        }
        arguments
    }
}
