use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(height),
    kinetic = 0.5 * m * dot(height).powi(2),
    event(floor = height),
)]
struct Ball {
    m: f64,
}

fn main() -> Result<(), IntegrationError> {
    let ball = Ball { m: 1.0 };
    let problem = || Problem::new(&ball, State::new(0.0, [1.0], [0.0]));
    // No action.
    let _ = problem().on(Ball::FLOOR).falling().solve(1.0, Taylor::new())?;
    let _ = problem().when(|x| x.q[0]).save(Every(0.1));
    // Nothing is saved.
    let end = problem().solve(1.0, Taylor::new())?;
    let _ = end.samples();
    let _ = end.at(0.5);
    Ok(())
}
