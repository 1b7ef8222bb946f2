//! Problems of `diffsol`, on all of its matrices of `f64`.

use alloc::vec;
use alloc::vec::Vec;
use core::cell::RefCell;

use ::diffsol::op::closure_no_jac::ClosureNoJac;
use ::diffsol::{Closure, ConstantClosure, Matrix, OdeBuilder};
use lagrangian::Dynamics;

use crate::jacobian::{Jacobian, NoJacobian};
use crate::ode_system::OdeSystem;

impl<D: Dynamics> OdeSystem<D, NoJacobian> {
    /// A builder of a `diffsol` problem with the derivative, the initial state and its time, for explicit methods; `M` is the type
    /// of matrices.
    #[allow(clippy::type_complexity)] // The types of diffsol's own builder.
    pub fn diffsol_builder<M: Matrix<T = f64>>(
        &self,
    ) -> OdeBuilder<
        M,
        ClosureNoJac<M, impl Fn(&[f64], &[f64], f64, &mut [f64])>,
        ConstantClosure<M, impl Fn(&[f64], f64, &mut [f64])>,
    > {
        let initial = self.initial();
        OdeBuilder::<M>::new()
            .t0(self.start().t)
            .rhs(|x, _, t, derivative| self.derivative_or_nan(t, x, derivative))
            .init(
                move |_, _, written| written.copy_from_slice(&initial),
                self.size(),
            )
    }
}

impl<D: Dynamics, J: Jacobian<State = D::State>> OdeSystem<D, J> {
    /// A builder of a `diffsol` problem with the derivative, its Jacobian, the initial state and its time; `M` is the type of
    /// matrices. Tolerances, roots and outputs are set on it.
    ///
    /// ```
    /// use diffsol::{NalgebraLU, NalgebraMat, OdeSolverMethod, Vector};
    /// use lagrangian::prelude::*;
    /// use lagrangian_solvers::OdeSystem;
    ///
    /// /// θ̈ = −k sin θ − c θ̇, with so much damping that explicit methods take short steps.
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(theta),
    ///     kinetic = 0.5 * dot(theta).powi(2),
    ///     potential = -k * cos(theta),
    ///     dissipation = 0.5 * c * dot(theta).powi(2),
    /// )]
    /// struct Damped { k: f64, c: f64 }
    ///
    /// let damped = Damped { k: 1.0, c: 1e4 };
    /// let system = OdeSystem::new(&damped, State::new(0.0, [1.0], [0.0]))?;
    /// let problem = system.diffsol_builder::<NalgebraMat<f64>>().rtol(1e-8).atol([1e-10]).build()?;
    /// let mut solver = problem.bdf::<NalgebraLU<f64>>()?;
    /// solver.solve(1e4)?;
    /// let end = system.state(1e4, &solver.state().y.clone_as_vec())?;
    /// // tan ½θ decays by the rate k/c, but for terms in k/c².
    /// assert!((end.q[0] - 2.0 * (0.5_f64.tan() / 1.0_f64.exp()).atan()).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[allow(clippy::type_complexity)] // The types of diffsol's own builder.
    pub fn diffsol_builder<M: Matrix<T = f64>>(
        &self,
    ) -> OdeBuilder<
        M,
        Closure<
            M,
            impl Fn(&[f64], &[f64], f64, &mut [f64]),
            impl Fn(&[f64], &[f64], f64, &[f64], &mut [f64]),
        >,
        ConstantClosure<M, impl Fn(&[f64], f64, &mut [f64])>,
    > {
        let product = LastJacobian::new(self);
        let initial = self.initial();
        OdeBuilder::<M>::new()
            .t0(self.start().t)
            .rhs_implicit(
                |x, _, t, derivative| self.derivative_or_nan(t, x, derivative),
                move |x, _, t, direction, written| product.write(t, x, direction, written),
            )
            .init(
                move |_, _, written| written.copy_from_slice(&initial),
                self.size(),
            )
    }
}

/// Products of the Jacobian with vectors. A matrix is computed once for all of its columns, which `diffsol` asks for one by one.
struct LastJacobian<'a, D: Dynamics, J> {
    system: &'a OdeSystem<D, J>,
    last: RefCell<Evaluation>,
}

/// The Jacobian where it was last evaluated.
struct Evaluation {
    t: f64,
    x: Vec<f64>,
    rows: Vec<f64>,
}

impl<'a, D, J> LastJacobian<'a, D, J>
where
    D: Dynamics,
    J: Jacobian<State = D::State>,
{
    fn new(system: &'a OdeSystem<D, J>) -> Self {
        let size = system.size();
        let nowhere = Evaluation {
            t: f64::NAN,
            x: vec![f64::NAN; size],
            rows: vec![f64::NAN; size * size],
        };
        Self {
            system,
            last: RefCell::new(nowhere),
        }
    }

    fn write(&self, t: f64, x: &[f64], direction: &[f64], written: &mut [f64]) {
        let mut last = self.last.borrow_mut();
        let Evaluation { t: at, x: y, rows } = &mut *last;
        if at.to_bits() != t.to_bits() || y != x {
            if self.system.jacobian(t, x, rows).is_err() {
                written.fill(f64::NAN);
                return;
            }
            *at = t;
            y.copy_from_slice(x);
        }
        for (row, component) in rows.chunks_exact(x.len()).zip(written) {
            *component = row.iter().zip(direction).map(|(a, b)| a * b).sum();
        }
    }
}
