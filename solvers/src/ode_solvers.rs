//! Systems of `ode_solvers`.

use ::ode_solvers::{DVector, SVector, System};
use lagrangian::Dynamics;

use crate::ode_system::OdeSystem;

/// Implements `System` for a vector; one of another size has no derivative.
macro_rules! system_on {
    ([$($parameter:tt)*], $vector:ty) => {
        impl<D: Dynamics, J, $($parameter)*> System<f64, $vector> for OdeSystem<D, J> {
            fn system(&self, t: f64, x: &$vector, derivative: &mut $vector) {
                self.derivative_or_nan(t, x.as_slice(), derivative.as_mut_slice());
            }
        }

        impl<D: Dynamics, J, $($parameter)*> System<f64, $vector> for &OdeSystem<D, J> {
            fn system(&self, t: f64, x: &$vector, derivative: &mut $vector) {
                (**self).system(t, x, derivative);
            }
        }
    };
}

system_on!([], DVector<f64>);
system_on!([const SIZE: usize], SVector<f64, SIZE>);
