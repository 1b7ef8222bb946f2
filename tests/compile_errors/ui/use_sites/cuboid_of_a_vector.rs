use lagrangian::prelude::*;
use lagrangian::rigid_body::Solid;

fn main() {
    let _ = Solid::cuboid(Vector3::new(1.0, 2.0, 3.0));
}
