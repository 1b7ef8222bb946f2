//! Systems of `differential-equations`, on all of its states: arrays, `Vec`, and those of other crates.

use alloc::vec;

use ::differential_equations::linalg::{Matrix, MatrixStorage};
use ::differential_equations::ode::ODE;
use ::differential_equations::traits::State;
use lagrangian::{Dynamics, VectorSpace};

use crate::jacobian::{Jacobian, NoJacobian};
use crate::ode_system::OdeSystem;

/// Implicit methods difference the derivative.
impl<D: Dynamics, Y: State<f64>> ODE<f64, Y> for OdeSystem<D, NoJacobian> {
    fn diff(&self, t: f64, x: &Y, derivative: &mut Y) {
        self.write_derivative(t, x, derivative);
    }
}

impl<D, J, Y> ODE<f64, Y> for OdeSystem<D, J>
where
    D: Dynamics,
    J: Jacobian<State = D::State>,
    Y: State<f64>,
{
    fn diff(&self, t: f64, x: &Y, derivative: &mut Y) {
        self.write_derivative(t, x, derivative);
    }

    fn jacobian(&self, t: f64, x: &Y, jacobian: &mut Matrix<f64>) {
        let size = self.size();
        if let Some(x) = self.state_like(x)
            && jacobian.dims() == (size, size)
        {
            let mut rows = vec![f64::NAN; size * size];
            self.write_jacobian(t, &x, &mut rows);
            jacobian.data = rows;
            jacobian.storage = MatrixStorage::Full;
        } else {
            jacobian.fill(f64::NAN);
        }
    }
}

impl<D: Dynamics, J> OdeSystem<D, J> {
    /// Writes the derivative; a state of another size has none.
    fn write_derivative<Y: State<f64>>(&self, t: f64, x: &Y, derivative: &mut Y) {
        let Some(x) = self.state_like(x) else {
            derivative.fill(f64::NAN);
            return;
        };
        let found = self.dynamics().derivative(t, &x);
        for (index, component) in found.components().enumerate() {
            derivative.set_component(index, component);
        }
    }

    fn state_like<Y: State<f64>>(&self, x: &Y) -> Option<D::State> {
        let components = (0..x.len()).map(|index| x.get_component(index));
        (x.len() == self.size()).then(|| self.state_of(components))
    }
}
