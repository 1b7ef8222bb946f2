//! Newton's cradle: impacts between neighbours are events, and a reaction exchanges what they carry.
//!
//! `cargo run --release --example newtons_cradle`

use std::cell::Cell;

use lagrangian::prelude::*;

/// Five balls on strings side by side, with a small gap between neighbours that hang at rest.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta[5]),
    kinetic = (0..5).map(|i| 0.5 * m[i] * (l * dot(theta[i])).powi(2)).sum(),
    potential = (0..5).map(|i| -m[i] * g * l * cos(theta[i])).sum(),
    event(contact = (0..4).map(|i| theta[i + 1] - theta[i] + gap).collect()),
)]
struct Cradle {
    m: [f64; 5],
    l: f64,
    g: f64,
    gap: f64,
}

impl Cradle {
    /// A central elastic impact of a ball and its neighbour (momentum and energy are kept).
    fn impact(&self, x: &mut Phase<f64, 5>, i: usize) {
        let (m, n) = (self.m[i], self.m[i + 1]);
        let (u, v) = (x.v[i], x.v[i + 1]);
        x.v[i] = ((m - n) * u + 2.0 * n * v) / (m + n);
        x.v[i + 1] = ((n - m) * v + 2.0 * m * u) / (m + n);
    }

    fn momentum(&self, x: &Phase<f64, 5>) -> f64 {
        let momenta = self.m.iter().zip(x.v.iter());
        momenta.map(|(m, v)| m * v * self.l).sum()
    }
}

fn main() -> Result<(), IntegrationError> {
    let cradle = Cradle {
        m: [0.1; 5],
        l: 0.25,
        g: 9.81,
        gap: 1e-4,
    };
    let start = State::new(0.0, [-0.5, -0.5, 0.0, 0.0, 0.0], [0.0; 5]);
    let [first, second, third, fourth] = Cradle::CONTACT;
    let largest = Cell::new(0.0_f64);
    let impact = |x: &mut State<f64, 5>, contact| {
        let before = cradle.momentum(x);
        cradle.impact(x, contact);
        let change = cradle.momentum(x) - before;
        largest.set(largest.get().max(change.abs()));
    };
    let motion = Problem::new(&cradle, start)
        .on(first)
        .falling()
        .then(|x| impact(x, 0))
        .on(second)
        .falling()
        .then(|x| impact(x, 1))
        .on(third)
        .falling()
        .then(|x| impact(x, 2))
        .on(fourth)
        .falling()
        .then(|x| impact(x, 3))
        .save(Every(0.25))
        .solve(3.0, Taylor::new())?;
    let largest = largest.get();

    println!("  t [s]  angles [rad]                             energy error [J]");
    for state in motion.samples() {
        let error = cradle.energy(state) - cradle.energy(&start);
        let angles: Vec<String> = state.q.iter().map(|q| format!("{q:7.3}")).collect();
        println!("{:7.2}  {}  {error:16.1e}", state.t, angles.join(" "));
    }
    let count = motion.events().len();
    println!("{count} impacts; momentum is kept to {largest:.1e} kg m/s in each");
    let end = cradle.energy(&motion);
    assert!((end - cradle.energy(&start)).abs() < 1e-12 && largest < 1e-15);
    Ok(())
}
