use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(
        python = x if x > 0.0 else y,
        guard = x if y,
        c = x > 0.0 ? x : y,
        pascal = if x > 0.0 then x else y,
        numpy = where(x > 0.0, x, y),
        both = x and y,
        either = x || y,
        length = 2.0 * |x|,
        length_first = |x| * 2.0,
        remainder = mod(x, 2.0),
        product = x @ y,
        juxtaposed = 2x,
        half = 0.5m * y,
        point = .5 * x,
        plus = +x,
        increment = x++,
        comprehension = [x for i in 0..3],
        generator = sum(x for i in 0..3),
        repeated = for i in 0..3 { x },
        braces = sin{x},
    ),
    kinetic = 0.5 * m * dot(x).powi(2) for i in 0..3,
)]
struct Particle {
    m: f64,
}

fn main() {}
