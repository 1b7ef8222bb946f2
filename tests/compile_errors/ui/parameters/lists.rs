use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * mass * dot(x).powi(2), force(x = push), regressor(mas, push, x, mass, mass))]
struct Names {
    mass: f64,
    #[lagrangian(input)]
    push: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m[0] * dot(x).powi(2), sensitivities(m[0], table))]
struct Components {
    m: [f64; 2],
    #[lagrangian(skip)]
    table: Vec<f64>,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), regressor = m, sensitivities())]
struct Grammar {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), regressor, regressor(m), hamiltonian, hamiltonian)]
struct Twice {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), regressor, energy_balance = 1.0)]
struct Nothing {}

#[derive(Lagrangian)]
#[lagrangian(coordinates(parameters, base_parameters), kinetic = 0.5 * m * (dot(parameters).powi(2) + dot(base_parameters).powi(2)), sensitivities, regressor)]
struct Constants {
    m: f64,
}

fn main() {}
