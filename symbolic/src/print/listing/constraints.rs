//! The constraints of a model.

use crate::Equations;
use crate::limits::MAX_UNARRANGED_LENGTH;
use crate::print::listing::composer::Composer;
use crate::print::listing::section::Section;

impl Composer<'_> {
    /// The constraints: g = 0 and w = 0.
    pub(crate) fn constraints(&mut self, equations: &Equations) -> Section {
        let heading = ["Constraints:"; 2].map(String::from);
        let method = "the methods of `Constraints`";
        let mut section = Section::new(Some(heading), method);
        let constraints = &equations.constraints;
        let holonomic = constraints.positions.len();
        let nonholonomic = constraints.velocities.iter().skip(holonomic);
        for constraint in constraints.positions.iter().chain(nonholonomic) {
            let symbols = self
                .model
                .graph
                .written_symbols(&[*constraint], &self.letters);
            if symbols > MAX_UNARRANGED_LENGTH || !section.has_room() {
                section.leave_out(symbols);
                continue;
            }
            let left = self.arranged(*constraint);
            let right = self.model.graph.zero();
            self.push_arranged(&mut section, left, right);
        }
        self.mention(section)
    }
}
