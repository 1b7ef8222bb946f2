#![deny(deprecated)]
#![allow(dead_code)]
use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, phi),
    kinetic = 0.5 * m * dot(x).powi(2) + 0.5 * inertia * dot(phi).powi(2),
    nonholonomic(roll = dot(x) - r * dot(phi)),
)]
struct Wheel {
    m: f64,
    inertia: f64,
    r: f64,
}

/// A vertical disc that does not turn.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector2, phi, psi),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * inertia * (dot(phi).powi(2) + dot(psi).powi(2)),
    constraint(guide = phi - a),
    nonholonomic(rolling = [dot(p.x) - r * dot(psi) * cos(phi), dot(p.y) - r * dot(psi) * sin(phi)]),
)]
struct Disc {
    m: f64,
    inertia: f64,
    r: f64,
    a: f64,
}

/// It is meant.
#[allow(deprecated)]
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, phi),
    kinetic = 0.5 * m * dot(x).powi(2) + 0.5 * inertia * dot(phi).powi(2),
    nonholonomic(roll = dot(x) - r * dot(phi)),
)]
struct Meant {
    m: f64,
    inertia: f64,
    r: f64,
}

fn main() {}
