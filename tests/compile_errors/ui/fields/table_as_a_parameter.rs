use lagrangian::Lagrangian;
use lagrangian::nalgebra::SMatrix;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = heights[0] * x + planes[0][0] * x + grid[(0, 0)] * x,
)]
struct Model {
    m: f64,
    heights: [f64; 2000000000],
    planes: [[f64; 9000000000000000000]; 9000000000000000000],
    grid: SMatrix<f64, 101, 100>,
}

fn main() {}
