//! The edges of a box are three numbers.

use lagrangian::nalgebra::Vector3;
use lagrangian::rigid_body::Solid;

fn main() {
    let _ = Solid::cuboid(Vector3::new(0.4, 0.2, 0.1));
}
