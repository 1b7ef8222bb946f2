//! Half a car on its springs: sag, modes, linear model, and what a damper does to them.

// ANCHOR: model
use std::f64::consts::TAU;

use lagrangian::analysis::{EquilibriumSearch, SmallOscillations, StateSpace};
use lagrangian::nalgebra::Complex;
use lagrangian::prelude::*;
use lagrangian_guide::{Curve, Figure};

/// A body on two axles, seen from the side; heights are above their places with springs at rest.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    coordinates(heave, pitch, front, rear),
    define(
        // What lengthens the springs of the body.
        front_gap = heave + a * sin(pitch) - front,
        rear_gap = heave - b * sin(pitch) - rear,
    ),
    kinetic = 0.5 * (m * dot(heave).powi(2) + i * dot(pitch).powi(2)),
    kinetic = 0.5 * wheel * (dot(front).powi(2) + dot(rear).powi(2)),
    potential = g * (m * heave + wheel * (front + rear)),
    potential = 0.5 * spring * (front_gap.powi(2) + rear_gap.powi(2)),
    potential = 0.5 * tyre * (front.powi(2) + rear.powi(2)),
    dissipation = 0.5 * damper * (dot(front_gap).powi(2) + dot(rear_gap).powi(2)),
    // The tyres stand on a road that is not level.
    force(front = tyre * road[0], rear = tyre * road[1]),
)]
struct HalfCar {
    m: f64,
    i: f64,
    wheel: f64,
    /// The distances of the axles from the centre of gravity.
    a: f64,
    b: f64,
    spring: f64,
    damper: f64,
    tyre: f64,
    g: f64,
    /// The height of the road under the front and the rear wheel in m.
    #[lagrangian(input)]
    road: Vector2<f64>,
}
// ANCHOR_END: model

// ANCHOR: rest
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let car = HalfCar {
        m: 650.0,
        i: 1000.0,
        wheel: 40.0,
        a: 1.2,
        b: 1.5,
        spring: 22e3,
        damper: 1600.0,
        tyre: 190e3,
        g: 9.81,
        road: Vector2::zeros(),
    };
    let guess = State::new(0.0, [0.0; 4], [0.0; 4]);
    let rest = EquilibriumSearch::of(&car).near(&guess)?.state;
    let [heave, pitch] = [HalfCar::HEAVE, HalfCar::PITCH].map(|i| rest.q[i]);
    println!(
        "It sinks by {:.1} mm, nose down by {:.3}°.",
        -1e3 * heave,
        -pitch.to_degrees()
    );

    let oscillations = SmallOscillations::about(&car, &rest)?;
    println!("Stability: {:?}\n", oscillations.stability()?.verdict());
    println!("f [Hz]   damping ratio   largest in");
    for mode in oscillations.damped_modes()?.iter() {
        let largest = mode.shape.map(Complex::norm).imax();
        let (frequency, name) = (
            mode.natural_frequency() / TAU,
            HalfCar::COORDINATES[largest],
        );
        println!("{frequency:6.2}   {:13.3}   {name}", mode.damping_ratio());
    }

    // ANCHOR_END: rest

    // ANCHOR: plant
    let plant = Linear::of(&car, &rest);
    assert!(plant.is_at_equilibrium(1e-10));
    let row = plant.a.fixed_view::<1, 4>(4 + HalfCar::HEAVE, 0);
    println!(
        "\nHeave in A, by heave, pitch, front, rear: {}",
        digits(row.iter())
    );
    let column = plant.b.fixed_view::<4, 1>(4, 0);
    println!(
        "Road in B, for their accelerations: {}",
        digits(column.iter())
    );
    println!("Controllable states: {} of 8", plant.controllability().rank);

    // ANCHOR_END: plant

    // ANCHOR: response
    let [soft, normal, hard] = [400.0, 1600.0, 5000.0].map(|damper| {
        let car = HalfCar {
            damper,
            ..car.clone()
        };
        let plant = Linear::of(&car, &rest);
        let frequencies = (10..=1500).map(|i| 0.01 * f64::from(i));
        frequencies.map(|f| [f, gain(&plant, f)]).collect()
    });
    Figure::new(
        "linearize",
        "frequency in Hz",
        "heave per height of the road",
    )
    .draw(&[
        Curve::new("damper of 400 N s/m", soft),
        Curve::new("1600 N s/m", normal),
        Curve::new("5000 N s/m", hard),
    ])
}

/// ẋ = A x + B u of the eight states and two inputs.
type Linear = StateSpace<f64, 8, 2, 8>;

/// |H(iω)| from a road that lifts both wheels to the heave: the first entry of (iω − A)⁻¹ B u.
fn gain(plant: &Linear, frequency: f64) -> f64 {
    let complex = |x: f64| Complex::new(x, 0.0);
    let shift = SMatrix::from_diagonal_element(Complex::new(0.0, TAU * frequency));
    let matrix: SMatrix<Complex<f64>, 8, 8> = shift - plant.a.map(complex);
    let right = plant.b.column_sum().map(complex);
    matrix
        .lu()
        .solve(&right)
        .map_or(f64::NAN, |x| x[HalfCar::HEAVE].norm())
}

/// Four digits of each number.
fn digits<'a>(numbers: impl Iterator<Item = &'a f64>) -> String {
    let digits: Vec<_> = numbers.map(|x| format!("{x:.4}")).collect();
    digits.join(", ")
}
// ANCHOR_END: response
