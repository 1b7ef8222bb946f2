use lagrangian::prelude::*;

struct Table;

impl Table {
    fn at(&self, x: f64) -> f64 {
        x
    }

    fn slope(&self, _: f64) -> f64 {
        1.0
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    scalar = f64,
    coordinates(x, y),
    function(tension(length) = self.table.at(length), derivative(length) = stiffness(length)),
    function(stiffness(length) = self.table.slope(length)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    force(x = -tension(x), y = -tension(y)),
)]
struct NonlinearSpring {
    m: f64,
    #[lagrangian(skip)]
    table: Table,
}

fn main() {}
