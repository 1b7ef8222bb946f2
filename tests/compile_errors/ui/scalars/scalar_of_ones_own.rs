use lagrangian::prelude::*;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Own(f64);

fn doubled<S: Scalar>(x: S) -> S {
    x + x
}

fn main() {
    let _ = doubled(Own(1.0));
}
