//! The functions that are counted, on `f32` and on `f64`; their names appear in the symbols of the program.

/// Makes a module for a scalar.
macro_rules! functions {
    ($module:ident, $scalar:ty) => {
        pub(crate) mod $module {
            use core::hint::black_box;

            use cart_pole_model::{CartPole, computed_force, law};
            use lagrangian::nalgebra::RowVector4;
            use lagrangian::prelude::*;

            use crate::counter::Counter;

            type S = $scalar;
            type Equations<'a> = lagrangian::EquationsOfMotion<&'a CartPole<S>, S, 2>;

            #[inline(never)]
            fn lqr(gain: &RowVector4<S>, x: &State<S, 2>) -> S {
                law(gain, x)
            }

            #[inline(never)]
            fn computed_torque(model: &CartPole<S>, x: &State<S, 2>) -> S {
                computed_force(model, x, 1.0)
            }

            #[inline(never)]
            fn accelerations(equations: &Equations<'_>, x: &State<S, 2>) -> Phase<S, 2> {
                equations.derivative(x.t, &x.x)
            }

            #[inline(never)]
            fn inverse_dynamics(model: &CartPole<S>, x: &State<S, 2>) -> Vector2<S> {
                model.inverse_dynamics(x, &Vector2::new(1.0, -1.0))
            }

            #[inline(never)]
            fn runge_kutta_step<T: Advance<S, D>, D: Dynamics<S>>(stepper: &mut T, equations: &D) {
                let _ = black_box(stepper.step(equations, stepper.time() + 1e-3));
            }

            #[inline(never)]
            fn taylor_step<T: Advance<S, D>, D: Dynamics<S>>(stepper: &mut T, equations: &D) {
                let _ = black_box(stepper.step(equations, 1e6));
            }

            /// The instructions of each function.
            pub(crate) fn counts(counter: &Counter) -> [(&'static str, u32); 6] {
                let model = black_box(CartPole::<S>::new());
                let gain = black_box(RowVector4::new(-2.6758, -35.4849, -4.0647, -7.5324));
                let x = black_box(State::<S, 2>::new(0.0, [0.1, 0.2], [0.3, 0.4]));
                let equations = model.dynamics();
                let mut counts = [
                    ("lqr", 0),
                    ("computed_torque", 0),
                    ("accelerations", 0),
                    ("inverse_dynamics", 0),
                    ("runge_kutta_step", 0),
                    ("taylor_step", 0),
                ];
                counts[0].1 = counter.count(1000, || {
                    black_box(lqr(&gain, black_box(&x)));
                });
                counts[1].1 = counter.count(1000, || {
                    black_box(computed_torque(&model, black_box(&x)));
                });
                counts[2].1 = counter.count(1000, || {
                    black_box(accelerations(&equations, black_box(&x)));
                });
                counts[3].1 = counter.count(1000, || {
                    black_box(inverse_dynamics(&model, black_box(&x)));
                });
                if let Ok(mut stepper) = RungeKutta::classical(1e-3).start(&equations, 0.0, x.x) {
                    counts[4].1 =
                        counter.count(1000, || runge_kutta_step(&mut stepper, &equations));
                }
                if let Ok(mut stepper) = Taylor::order_12().start(&equations, 0.0, x.x) {
                    counts[5].1 = counter.count(20, || taylor_step(&mut stepper, &equations));
                }
                counts
            }
        }
    };
}

functions!(single, f32);
functions!(double, f64);
