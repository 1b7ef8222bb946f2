//! Altered programs are found and replaced.

use lagrangian_symbolic as symbolic;
use lagrangian_symbolic::{Operation, Program};
use proc_macro2::TokenStream;
use quote::quote;

use crate::plan::Methods;
use crate::tests::derived::{Derived, derive};

/// A pendulum on a cart on a shaken rail, of every kind of term.
fn driven_cart() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(x, theta),
            define(p = [x + l * sin(theta) + a * sin(w * t), -l * cos(theta)]),
            kinetic = 0.5 * mc * dot(x).powi(2) + 0.5 * m * dot(p).norm_squared(),
            potential = m * g * p.y + k * abs(x - 2.0).powi(3) + b * x * dot(theta),
            dissipation = 0.5 * c * dot(theta).powi(2) / (1.0 + x.powi(2)),
            force(x = u * cos(theta) + sqrt(1.0 + theta.powi(2)), theta = h * u),
            output(height = p.y, acceleration = dot(dot(p.x))),
            hamiltonian, energy_balance, sensitivities(l, m, k, w), regressor(m, mc, l, b, c, h),
        )]
        struct Cart {
            mc: f64, m: f64, l: f64, g: f64, a: f64, w: f64, k: f64, b: f64, c: f64, h: f64,
            #[lagrangian(input)]
            u: f64,
        }
    }
}

/// A chain of five, which is solved numerically for its derivatives.
fn chain() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(q[5]),
            define(
                p[0] = [sin(q[0]), -cos(q[0])],
                p[i] = p[i - 1] + l[i] * [sin(q[i]), -cos(q[i])] for i in 1..5,
            ),
            kinetic = (0..5).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
            potential = (0..5).map(|i| m[i] * g * p[i].y).sum(),
            force(q[1] = u),
            hamiltonian, energy_balance, sensitivities(g, l), regressor(m),
        )]
        struct Chain { m: [f64; 5], l: [f64; 5], g: f64, #[lagrangian(input)] u: f64 }
    }
}

/// A rigid body, solved through its angular velocity.
fn top() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(phi, theta, psi),
            define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
            kinetic = 0.5 * (i1 * w.x.powi(2) + i2 * w.y.powi(2) + i3 * w.z.powi(2)),
            potential = m * g * (r * [0.0, d, l]).z,
            force(w = [0.0, tau, 0.0]),
            hamiltonian, energy_balance, sensitivities, regressor,
        )]
        struct Top { i1: f64, i2: f64, i3: f64, m: f64, g: f64, d: f64, l: f64, tau: f64 }
    }
}

/// A skate on a slope that rises with time, with constraints of both kinds.
fn skate() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(p: Vector3, phi),
            kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * i * dot(phi).powi(2),
            potential = m * g * p.z,
            constraint(slope = p.z + rise * t * p.x),
            nonholonomic(edge = dot(p.x) * sin(phi) - dot(p.y) * cos(phi)),
            output(forces = [reaction(slope), reaction(edge)]),
        )]
        struct Skate { m: f64, i: f64, g: f64, rise: f64 }
    }
}

fn models() -> [TokenStream; 3] {
    [driven_cart(), chain(), top()]
}

#[test]
fn what_is_derived_agrees() {
    for model in models().into_iter().chain([skate()]) {
        let Derived {
            validator, methods, ..
        } = derive(model);
        assert!(methods.disagreements(&validator).is_empty());
    }
}

/// The same program with one instruction changed, if it is one that can be.
pub(super) fn altered(program: &Program, position: usize) -> Option<Program> {
    let mut program = program.clone();
    let instructions = program
        .groups
        .iter_mut()
        .flat_map(|group| &mut group.instructions);
    let instruction = instructions.into_iter().nth(position)?;
    instruction.operation = match instruction.operation.clone() {
        Operation::Add(x, y) => Operation::Subtract(x, y),
        Operation::Subtract(x, y) => Operation::Add(x, y),
        Operation::Multiply(x, y) => Operation::Divide(x, y),
        Operation::Divide(x, y) => Operation::Multiply(x, y),
        Operation::Negate(x) => Operation::Add(x.clone(), x),
        _ => return None,
    };
    Some(program)
}

/// Where a program stands among the methods.
type Slot = fn(&mut Methods) -> &mut Program;

const SLOTS: [(symbolic::Method, Slot); 18] = {
    use lagrangian_symbolic::Method;
    [
        (Method::Lagrangian, |methods| {
            &mut methods.lagrangian.program
        }),
        (Method::Energy, |methods| &mut methods.energy.program),
        (Method::Momenta, |methods| &mut methods.momenta.program),
        (Method::MassMatrix, |methods| {
            &mut methods.mass_matrix.program
        }),
        (Method::Forcing, |methods| &mut methods.forcing.program),
        (Method::GeneralizedForces, |methods| {
            &mut methods.generalized_forces.program
        }),
        (Method::InverseDynamics, |methods| {
            &mut methods.inverse_dynamics.program
        }),
        (Method::Outputs, |methods| &mut methods.outputs.program),
        (Method::Accelerations, |methods| {
            &mut methods.prepare.program
        }),
        (Method::Accelerations, |methods| {
            &mut methods.accelerations.program
        }),
        (Method::Linearization, |methods| {
            &mut methods.linearize.as_mut().unwrap().program
        }),
        (Method::Linearization, |methods| {
            &mut methods.input_jacobian.program
        }),
        (Method::MomentumRates, |methods| {
            &mut methods.requested.momentum_rates.as_mut().unwrap().program
        }),
        (Method::EnergyRate, |methods| {
            &mut methods.requested.energy_rate.as_mut().unwrap().program
        }),
        (Method::Sensitivities, |methods| {
            let sensitivities = methods.requested.sensitivities.as_mut();
            &mut sensitivities.unwrap().method.program
        }),
        (Method::Regressor, |methods| {
            &mut methods
                .requested
                .regressor
                .as_mut()
                .unwrap()
                .regressor
                .program
        }),
        (Method::Regressor, |methods| {
            &mut methods
                .requested
                .regressor
                .as_mut()
                .unwrap()
                .known_terms
                .program
        }),
        (Method::Regressor, |methods| {
            let regressor = methods.requested.regressor.as_mut();
            &mut regressor.unwrap().base_parameters.program
        }),
    ]
};

/// What is computed, but for pivots, of which the signs alone matter, at some numbers.
fn values(methods: &Methods, method: symbolic::Method, program: &Program, seed: u32) -> Vec<f64> {
    let value = |symbol: symbolic::Symbol| {
        let text = format!("{symbol:?}");
        let mix = |code: u32, byte| code.wrapping_mul(31) + u32::from(byte);
        let code = text.bytes().fold(seed, mix);
        0.3 + f64::from(code.wrapping_mul(2_654_435_761) >> 16) / 65536.0
    };
    let pivots = methods.accelerations.outputs.pivots().unwrap_or(0);
    match method {
        symbolic::Method::Accelerations => {
            let prepared = methods.prepare.program.evaluate(value).concat();
            let program = &methods.accelerations.program;
            let accelerations = program.evaluate(|symbol| match symbol {
                symbolic::Symbol::Invariant(index) => prepared[index as usize],
                _ => value(symbol),
            });
            accelerations.concat().split_off(pivots)
        }
        symbolic::Method::Linearization | symbolic::Method::Sensitivities => {
            program.evaluate(value).concat().split_off(pivots)
        }
        _ => program.evaluate(value).concat(),
    }
}

/// The same at several points.
fn all_values(methods: &mut Methods, method: symbolic::Method, slot: Slot) -> Vec<f64> {
    let program = slot(methods).clone();
    let values = (1..5).map(|seed| values(methods, method, &program, seed));
    values.flatten().collect()
}

fn differ(first: &[f64], second: &[f64]) -> bool {
    let mut pairs = first.iter().zip(second);
    pairs.any(|(x, y)| (x - y).abs() > 1e-9 * (x.abs() + y.abs()))
}

/// Instructions of every method are altered in turn, and every alteration of its values is found. Some change nothing: the
/// energy function is the same for either sign of the velocity of a frame.
#[test]
fn some_altered_instructions_are_found() {
    altered_instructions_are_found(5);
}

#[test]
#[ignore = "all of them"]
fn every_altered_instruction_is_found() {
    altered_instructions_are_found(1);
}

fn altered_instructions_are_found(stride: usize) {
    for model in models() {
        let Derived {
            validator,
            mut methods,
            ..
        } = derive(model);
        let mut count = 0;
        for (method, slot) in SLOTS {
            let program = slot(&mut methods).clone();
            let expected = all_values(&mut methods, method, slot);
            for position in (0..program.instructions().count()).step_by(stride) {
                let Some(altered) = altered(&program, position) else {
                    continue;
                };
                *slot(&mut methods) = altered;
                // Some of many: each costs a validation.
                if (position < 40 || position % 7 == 0)
                    && differ(&all_values(&mut methods, method, slot), &expected)
                {
                    let found = methods.disagreements(&validator);
                    let instruction = program.instructions().nth(position);
                    assert!(found.contains(&method), "{method:?} {instruction:?}");
                    count += 1;
                }
            }
            *slot(&mut methods) = program;
        }
        assert!(count > 100 / stride, "{count}");
    }
}

/// What was simplified wrongly is replaced by what was derived plainly.
#[test]
fn what_disagrees_is_replaced() {
    for model in models() {
        let Derived {
            mut model,
            mut equations,
            validator,
            mut methods,
            shapes,
            requested,
        } = derive(model);
        let wrong = |program: &Program| {
            let count = program.instructions().count();
            (0..count)
                .find_map(|position| altered(program, position))
                .unwrap()
        };
        methods.accelerations.program = wrong(&methods.accelerations.program);
        methods.forcing.program = wrong(&methods.forcing.program);
        let linearize = methods.linearize.as_mut().unwrap();
        linearize.program = wrong(&linearize.program);
        let found = methods.validate(
            &validator,
            &mut model,
            &mut equations,
            (&shapes, &requested),
        );
        assert!(found.contains(&symbolic::Method::Accelerations));
        assert!(found.contains(&symbolic::Method::Forcing));
        assert!(!found.contains(&symbolic::Method::MassMatrix));
        assert!(methods.disagreements(&validator).is_empty());
        assert!(methods.accelerations.outputs.pivots().is_none());
    }
}

/// Values far beyond one, whose fourth power is no number, are no defect.
#[test]
fn steep_switches_have_series() {
    for force in [
        quote!(c / (1 + exp(-20 * x))),
        quote!(c / (1 + exp(-100 * dot(x)))),
        quote!(x / (1 + exp(-20 * x))),
        quote!(c * (1 - exp(-20 * (x - 1))) * exp(-20 * (x - 1))),
        quote!(c * (1 + exp(30 * x)).powi(-3)),
    ] {
        let declaration = quote! {
            #[lagrangian(
                taylor,
                coordinates(x),
                kinetic = 0.5 * dot(x).powi(2),
                force(x = #force),
                event(near = 1 / (1 + exp(-20 * x)) - 0.3),
            )]
            struct Switch { c: f64 }
        };
        let tokens = crate::expand::expand(declaration).to_string();
        assert!(!tokens.contains("compile_error"), "{force}: {tokens}");
    }
}
